// What `durero spec check` says of the conjectures of a text: that they were tried, that they are proved, and never
// more.
#include <fmt/format.h>

#include "durero/oracle/samples.hpp"
#include "durero/oracle/spec_index.hpp"
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

TriedConjectures tried(const zed::Specification& text, const zed::Typing& typing, bool own, std::size_t states) {
  zed::TrialBounds bounds;
  bounds.states = states;
  bounds.draws = 16 * states;
  const oracle::spec::LabelIndex index(own ? embedded::labels().begin()->second : "");
  TriedConjectures all;
  for (const zed::Trial& trial :
       zed::try_conjectures(text, typing, own && states > 0 ? oracle::spec::samples() : zed::Samples(), bounds)) {
    const std::string theorem = trial.label.empty() ? "" : index.theorem(trial.label);
    std::string said = verdict(trial);
    if (!theorem.empty() && trial.counterexample.empty()) said = fmt::format("proved as {}; {}", theorem, said);
    if (!said.ends_with("\n")) said += "\n";
    all.said += fmt::format("{}:{}:{}: conjecture{} {}", trial.file, trial.place.line, trial.place.column,
                            trial.label.empty() ? "" : " " + trial.label, said);
    all.refuted = all.refuted || !trial.counterexample.empty();
  }
  return all;
}

}  // namespace durero::cli
