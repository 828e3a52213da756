#include "durero/spec/text_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "durero/spec/constants.hpp"
#include "durero/spec/samples.hpp"
#include "durero/text/utf8.hpp"
#include "durero/zed/review/review.hpp"

namespace durero::spec {
namespace {

/// The beginning of a reason that is long: it stands on one line.
std::string shortened_reason(const std::string& reason) {
  constexpr std::size_t most = 120;
  std::size_t end = std::min(most, reason.size());
  while (end < reason.size() && text::continues(reason[end])) --end;
  return reason.substr(0, end) + (end < reason.size() ? "…" : "");
}

std::string trial_verdict(const TriedConjecture& tried) {
  const zed::Trial& trial = tried.trial;
  if (!trial.counterexample.empty())
    return fmt::format("is false{}, as in this state:\n{}", tried.within, trial.counterexample);
  if (trial.is_evaluated) return (trial.taken.empty() ? "is true" : "is true of the values taken") + tried.within;
  if (trial.tried == 0) return "not tried: " + shortened_reason(trial.why_not);
  return fmt::format("tried on {} state{}{}{}", trial.tried, trial.tried == 1 ? "" : "s", tried.within, tried.numbers);
}

std::string section_line(const zed::Section& section, const zed::Specification& text) {
  const auto spivey = text.spivey.find(section.file);
  return fmt::format("{}: section {} ok, {} paragraphs{}\n", section.file, section.name, section.paragraphs.size(),
                     spivey == text.spivey.end() ? "" : ", in Spivey's Z as " + spivey->second + " tells");
}

bool has_error(const std::vector<zed::Defect>& defects) {
  return std::ranges::any_of(defects,
                             [](const zed::Defect& defect) { return defect.severity == zed::Defect::Severity::error; });
}

std::vector<zed::Defect> reviewed(const zed::Specification& read, const zed::Typing& typing, bool strict) {
  std::vector<zed::Defect> defects = zed::review(read, typing);
  for (zed::Defect& defect : defects)
    if (strict && defect.severity == zed::Defect::Severity::opinion) defect.severity = zed::Defect::Severity::error;
  std::erase_if(defects, [&](const zed::Defect& defect) {  // nobody wrote it
    return std::ranges::any_of(read.sections, [&](const zed::Section& section) {
      return zed::is_built_in(section) && section.file == defect.file;
    });
  });
  return defects;
}

/// Values for the constants of the program's own text that the call gives none.
void add_sample_constants(zed::Valuation& constants) {
  for (auto& [name, value] : sample_constants())
    if (std::ranges::none_of(constants, [&](const auto& given) { return given.first == name; }))
      constants.emplace_back(name, std::move(value));
}

std::vector<zed::Trial> trials(const zed::Specification& read, const zed::Typing& typing, const TextCheckSetup& setup,
                               zed::Valuation given) {
  zed::TrialBounds bounds;
  bounds.states = setup.states;
  bounds.draws = 16 * setup.states;
  bounds.constants = std::move(given);
  bounds.numbers = setup.numbers;
  bounds.solver = setup.solver;
  if (setup.own) add_sample_constants(bounds.constants);
  return zed::try_conjectures(read, typing, setup.own && setup.states > 0 ? samples() : zed::Samples(), bounds);
}

}  // namespace

std::string TriedConjecture::text() const {
  std::string said = trial_verdict(*this);
  if (!trial.solver_said.empty() && trial.counterexample.empty()) said += "; " + trial.solver_said;
  if (!theorem.empty() && trial.counterexample.empty()) said = fmt::format("proved as {}; {}", theorem, said);
  if (!said.ends_with("\n")) said += "\n";
  return fmt::format("{}:{}:{}: conjecture{} {}", trial.file, trial.place.line, trial.place.column,
                     trial.label.empty() ? "" : " " + trial.label, said);
}

bool TextCheck::is_read() const { return !has_error(defects); }

bool TextCheck::is_refuted() const {
  return std::ranges::any_of(conjectures,
                             [](const TriedConjecture& tried) { return !tried.trial.counterexample.empty(); });
}

std::size_t TextCheck::untried() const {
  return static_cast<std::size_t>(std::ranges::count_if(conjectures, [](const TriedConjecture& tried) {
    return tried.trial.tried == 0 && tried.trial.counterexample.empty();
  }));
}

std::string TextCheck::lines() const {
  std::string said;
  for (const zed::Defect& defect : defects) said += defect.text() + "\n";
  if (!is_read()) return said;
  for (const zed::Section& section : text->sections)
    if (!zed::is_built_in(section)) said += section_line(section, *text);
  for (const TriedConjecture& tried : conjectures) said += tried.text();
  return said;
}

TextCheck check_text(const zed::Specification& read, const zed::Typing& typing, const std::vector<std::string>& files,
                     const TextCheckSetup& setup, const LabelIndex& index) {
  TextCheck check{reviewed(read, typing, setup.strict)};
  check.text = &read;
  if (check.is_read()) std::ranges::move(zed::without_paragraphs(files, read), std::back_inserter(check.defects));
  if (!check.is_read()) return check;
  GivenScope given;
  if (!setup.let.empty() || !setup.scope.empty()) given = given_scope(read, setup.let, setup.scope);
  const std::string within = given.within.empty() ? "" : fmt::format(" within {}", fmt::join(given.within, " and "));
  const std::string numbers =
      setup.numbers ? fmt::format(", with numbers from {} to {}", setup.numbers->first, setup.numbers->second) : "";
  for (zed::Trial& trial : trials(read, typing, setup, std::move(given.values))) {
    check.taken = trial.taken;
    const std::string theorem = trial.label.empty() ? "" : index.theorem(trial.label);
    check.conjectures.push_back({std::move(trial), theorem, within, numbers});
  }
  return check;
}

}  // namespace durero::spec
