// The statements of `durero spec check` about the conjectures of a text: that they were tried, that they are proved,
// and never more.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "durero/io/standard_output.hpp"
#include "durero/spec/constants.hpp"
#include "durero/spec/label_index.hpp"
#include "durero/spec/samples.hpp"
#include "durero/text/utf8.hpp"
#include "embedded.hpp"
#include "spec.hpp"

namespace durero::cli {
namespace {

/// The beginning of a reason that is long: it stands on one line.
std::string shortened(const std::string& reason) {
  constexpr std::size_t most = 120;
  std::size_t end = std::min(most, reason.size());
  while (end < reason.size() && text::continues(reason[end])) --end;
  return reason.substr(0, end) + (end < reason.size() ? "…" : "");
}

std::string verdict(const zed::Trial& trial) {
  if (!trial.counterexample.empty()) return "is false, as in this state:\n" + trial.counterexample;
  if (trial.tried == 0) return "not tried: " + shortened(trial.why_not);
  return fmt::format("tried on {} state{}", trial.tried, trial.tried == 1 ? "" : "s");
}

}  // namespace

void note_taken(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) io::complain("durero: note: " + line + "\n");
}

TriedConjectures tried(const zed::Specification& text, const zed::Typing& typing, const CheckCall& call) {
  const bool own = call.files.empty();
  zed::TrialBounds bounds;
  bounds.states = call.states;
  bounds.draws = 16 * call.states;
  if (!call.let.empty()) bounds.constants = spec::given_constants(text, call.let);
  if (own)
    for (auto& [name, value] : spec::sample_constants())
      if (std::ranges::none_of(bounds.constants, [&](const auto& given) { return given.first == name; }))
        bounds.constants.emplace_back(name, std::move(value));
  zed::Valuation taken;
  const spec::LabelIndex index(own ? embedded::labels().begin()->second : "");
  TriedConjectures all;
  for (const zed::Trial& trial :
       zed::try_conjectures(text, typing, own && call.states > 0 ? spec::samples() : zed::Samples(), bounds)) {
    const std::string theorem = trial.label.empty() ? "" : index.theorem(trial.label);
    std::string said = verdict(trial);
    if (!theorem.empty() && trial.counterexample.empty()) said = fmt::format("proved as {}; {}", theorem, said);
    if (!said.ends_with("\n")) said += "\n";
    all.said += fmt::format("{}:{}:{}: conjecture{} {}", trial.file, trial.place.line, trial.place.column,
                            trial.label.empty() ? "" : " " + trial.label, said);
    all.refuted = all.refuted || !trial.counterexample.empty();
    taken = trial.taken;
  }
  note_taken(spec::taken_lines(taken));
  return all;
}

}  // namespace durero::cli
