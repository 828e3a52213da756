#pragma once
/// The files of a suite. DIR/suite.json holds its options, and the description and counts of each family:
///
///   {"format":"durero-suite","version":2,"seed":1,"rays":1024,"numbers":"binary32","caps":"open","tipos":["esfera",…],
///   "families":[
///   {"family":"generic","kind":"…","reason":"…","parameter":{"name":"elements","least":1,"greatest":8},
///   "cases":16,"rays":1024,"members":987,"exact":231,"ambiguity":{"none":900,"tangent":20,…}},…]}
///
/// A family that has no scene of those types has 0 cases. Each case has the files DIR/FAMILY/0000.…:
///
///   .scene.json   the scene
///   .rays.txt     its rays, in decimal that reads back, and .rays.npy the same
///   .hits.jsonl   the exact answers as hit files have them, and .hits.npy the same
///   .case.json    the sidecar: what the case is, how many of its rays are truly of the family, the solids, and for
///   each
///                 ray why its answer may not be the only one and which others are permissible
///
/// Where something else than the first hit is asked for, .claims.jsonl has the exact answers as claims, and .ranges.txt
/// the ends of the rays, a line each.
///
/// The bytes depend on the options alone: not on the machine, nor on the number of threads.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "durero/conform/families/suite.hpp"

namespace durero::conform {

/// The version of the format of suites, which changes where the same options make other cases.
inline constexpr std::uint64_t suite_version = 2;

/// The number of enumerators of Ambiguity, none among them.
inline constexpr std::size_t ambiguity_count = 7;

/// The counts of a family in a suite.
struct FamilySummary {
  const Family* family = nullptr;                          ///< one of families()
  std::size_t cases = 0;                                   ///< the number of cases
  Count count{};                                           ///< the members among the rays of all cases
  std::array<std::size_t, ambiguity_count> ambiguities{};  ///< the number of rays, by Ambiguity

  /// Adds number by number; the family stays.
  FamilySummary& operator+=(const FamilySummary& other);
};

/// A suite as its files hold it.
struct Suite {
  SuiteOptions options;          ///< the options that it was made from
  std::vector<SuiteCase> cases;  ///< answered, in the order of families() and of their numbers
};

/// Writes the suite on as many threads as the calling one may use. The directory appears whole or not at all; one that
/// exists must be empty. Throws io::FileError, and std::invalid_argument where nearest points are asked for.
/// `before_case` is called before each case is made, on any of the threads; what it throws ends the work.
std::vector<FamilySummary> write_suite(
    const std::string& directory, const SuiteOptions& options, const std::function<void()>& before_case = [] {});

/// Reads a suite. It takes the options, scenes, rays, parameters and solids from the files, but no answer: it computes
/// these anew, and every file must agree with them. Throws io::InputError at the first place that does not, and
/// io::FileError.
Suite read_suite(const std::string& directory);

}  // namespace durero::conform
