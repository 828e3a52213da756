#pragma once
/// Fuzzing searches for questions about which a system is wrong. It changes questions of the families and of its own at
/// random, asks the system each, and goes on from those that lie in new places or whose answers are off by more, as the
/// judge measures it. The same seed and number of steps give the same questions to a system that gives the same
/// answers.

#include <cstdint>
#include <functional>
#include <vector>

#include "durero/conform/ask/runner.hpp"
#include "durero/conform/report/tally.hpp"

namespace durero::conform {

/// The faces that a mesh has about in fuzzing, which asks one ray of it.
inline constexpr std::size_t fuzzed_faces = 64;

/// The options of fuzzing.
struct FuzzOptions {
  SuiteOptions suite{};  ///< where questions come from: the families, types, numbers and the seed; `rays` is not used
  std::uint64_t steps = 0;  ///< the number of questions to make; 0: as many as there is time for
};

/// Failures that are alike: of one verdict, on one type of elements, of like sizes and ways.
struct FuzzedFailure {
  Finding finding;          ///< the worst of them: of the greatest backward error, then of the fewest elements
  std::uint64_t step = 0;   ///< the number of the question, from 0
  std::uint64_t alike = 0;  ///< the number of failures
};

/// The result of fuzzing.
struct Fuzzing {
  std::uint64_t steps = 0;               ///< the number of questions that were made
  std::uint64_t asked = 0;               ///< those that the model and the profile take, which the system was asked
  std::uint64_t failures = 0;            ///< the number of questions about which it was wrong
  std::vector<FuzzedFailure> failing{};  ///< each kind once, 1024 at most, in the order of their first failures
};

/// Searches until the steps are over, or until `goes_on` says no, which is asked before each step. An answer that comes
/// after that is not counted. Throws what `ask` throws, and std::invalid_argument where no family has a scene.
Fuzzing fuzz(const FuzzOptions& options, const Profile& profile, const Ask& ask, const std::function<bool()>& goes_on);

}  // namespace durero::conform
