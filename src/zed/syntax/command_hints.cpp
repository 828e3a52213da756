#include "zed/syntax/command_hints.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "durero/text/nearest.hpp"
#include "zed/syntax/symbols.hpp"

namespace durero::zed {
namespace {

/// Commands of mathematics in LaTeX, and of other styles for Z, with those of ISO Z.
constexpr std::array<std::pair<std::string_view, std::string_view>, 26> elsewhere = {{
    {"rightarrow", "fun"},
    {"to", "fun"},
    {"leftrightarrow", "rel"},
    {"Rightarrow", "implies"},
    {"Leftrightarrow", "iff"},
    {"times", "cross"},
    {"wedge", "land"},
    {"vee", "lor"},
    {"neg", "lnot"},
    {"lhd", "dres"},
    {"rhd", "rres"},
    {"sim", "inv"},
    {"ne", "neq"},
    {"le", "leq"},
    {"ge", "geq"},
    {"empty", "emptyset"},
    {"varnothing", "emptyset"},
    {"ints", "num"},
    {"integer", "num"},
    {"natural", "nat"},
    {"pset", "power"},
    {"fset", "finset"},
    {"frown", "cat"},
    {"rsub", "nrres"},
    {"dsub", "ndres"},
    {"fovr", "oplus"},
}};

std::string in_small(std::string_view word) {
  std::string small(word);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

}  // namespace

std::string expected_command(std::string_view command, const Markup& markup) {
  const auto found = std::ranges::find(elsewhere, command, &std::pair<std::string_view, std::string_view>::first);
  if (found != elsewhere.end()) return fmt::format("expected \\{}, as Z writes it", found->second);
  if (command == "bullet" || command == "spot" || command == "cdot") return "expected @, as Z writes it";
  std::vector<std::string> known;
  for (const auto& [name, meaning] : command_spellings()) known.emplace_back(name);
  for (const auto& [name, meaning] : markup) known.push_back(name);
  const auto is_same = [command](const std::string& each) { return in_small(each) == in_small(command); };
  const auto same = std::ranges::find_if(known, is_same);
  const auto meant = same != known.end() ? std::optional(*same) : text::nearest(command, known);
  return "expected a command of ISO Z or of a %%Z directive" + (meant ? "; did you mean \\" + *meant + "?" : "");
}

}  // namespace durero::zed
