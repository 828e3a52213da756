// The typed commands of durero spec run are taken apart here.
#include "spec_run_typed.hpp"

#include <algorithm>
#include <string_view>

#include "durero/io/source.hpp"

namespace durero::cli {

using spec::Machine;
using spec::MachineOperation;

std::string trimmed(const std::string& text) {
  const auto blank = " \t\r";
  const std::size_t from = text.find_first_not_of(blank);
  return from == text.npos ? "" : text.substr(from, text.find_last_not_of(blank) - from + 1);
}

namespace {

/// The offset of the first semicolon outside brackets, or the end.
std::size_t end_of_input(const std::string& typed, std::size_t from) {
  int depth = 0;
  for (std::size_t at = from; at < typed.size(); ++at) {
    const std::string_view rest = std::string_view(typed).substr(at);
    for (const char* open : {"(", "[", "{", "⦉", "⟨"}) depth += rest.starts_with(open) ? 1 : 0;
    for (const char* close : {")", "]", "}", "⦊", "⟩"}) depth -= rest.starts_with(close) ? 1 : 0;
    if (depth == 0 && typed[at] == ';') return at;
  }
  return typed.size();
}

}  // namespace

zed::Valuation typed_inputs(const Machine& machine, const MachineOperation& operation, const std::string& typed) {
  zed::Valuation given;
  for (std::size_t from = 0; from < typed.size();) {
    const std::size_t end = end_of_input(typed, from);
    const std::string part = typed.substr(from, end - from);
    from = end + 1;
    const std::size_t sign = part.find('=');
    const std::string name = trimmed(part.substr(0, sign));
    const auto at = std::find_if(operation.inputs.begin(), operation.inputs.end(),
                                 [&](const zed::Name& input) { return input.text() == name; });
    if (sign == part.npos || at == operation.inputs.end())
      throw Refused{name + " is no input of " + operation.name, "expected x? = VALUE for an input x?"};
    try {
      given.emplace_back(*at, machine.typed(trimmed(part.substr(sign + 1)), *at));
    } catch (const zed::ZError& error) {
      throw Refused{name + ": " + error.what_is_wrong, error.expected};
    }
  }
  return given;
}

void add_typed_members(const std::string& typed, spec::Setup& setup) {
  const std::size_t sign = typed.find('=');
  const std::string set = typed.substr(0, sign), rest = sign == typed.npos ? "" : typed.substr(sign + 1);
  if (set.empty() || rest.empty())
    throw io::InputError("--given", {1, 1}, typed + " gives no members", "expected SET=NUMBER or SET=WORD,WORD");
  auto& members = setup.given[set];
  if (rest.size() < 3 && rest.find_first_not_of("0123456789") == rest.npos) {
    for (unsigned long i = 1; i <= std::stoul(rest); ++i) members.push_back(set + std::to_string(i));
    return;
  }
  for (std::size_t from = 0; from <= rest.size();) {
    const std::size_t comma = std::min(rest.find(',', from), rest.size());
    members.push_back(rest.substr(from, comma - from));
    from = comma + 1;
  }
}

}  // namespace durero::cli
