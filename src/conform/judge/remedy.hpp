#pragma once
/// The remedies of traits, as changes of a draft.

#include <optional>
#include <vector>

#include "conform/judge/measured_question.hpp"
#include "durero/conform/judge/trait.hpp"

namespace durero::conform {

/// The questions that tell whether a trait causes a failure: it does where the system is right about each of `cures`
/// and not about the control.
struct Remedy {
  std::vector<Draft> cures{};      ///< without the trait; none where the question does not have it
  std::optional<Draft> control{};  ///< with the trait, and with the rounding that the cure makes
};

/// The question with p and v off by six roundings of their largest coordinate, in four ways.
std::vector<Draft> shaken(const Draft& given, const Profile& profile);

/// The remedy of a trait for a question.
Remedy remedy_of(Trait trait, const MeasuredQuestion& question, const SuiteCase& of, const Profile& profile);

/// Whether the answers to a question that was cured correspond to those before: both are hits of the same element or
/// misses; or, where a remedy makes another question on purpose, this is the one it meant to make.
bool corresponds(Trait trait, const MeasuredQuestion& question, const SuiteCase& of, const SuiteCase& cured);

}  // namespace durero::conform
