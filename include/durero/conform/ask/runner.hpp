#pragma once
/// A runner asks a system a suite: it asks child processes case by case, and hands the claims on in order.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "durero/conform/ask/claim.hpp"
#include "durero/conform/ask/system_file.hpp"
#include "durero/conform/families/suite.hpp"

namespace durero::conform {

/// The resources of a system.
struct AskOptions {
  std::chrono::duration<double> time{10};  ///< for each ray; the first of a scene has 0.01 s more for each element
  std::chrono::duration<double> time_to_start{120};  ///< the time until it writes its name and version
  std::uint64_t memory = 0;                          ///< bytes; 0: without limit
  std::size_t hung_of_scene = 3;  ///< after so many hung rays of a scene its other rays are not asked
  std::size_t silent_cases = 20;  ///< after so many cases in a row without any answer the system is given up
};

/// The cases of a run, made when they are needed, on several threads at once.
struct RunCases {
  std::size_t count = 0;                             ///< the number of cases
  std::function<SuiteCase(std::size_t place)> make;  ///< the case at that place, from 0 to count − 1
  /// For each ray of the case, the clause of the profile that excludes it, or nothing. An excluded ray is not asked,
  /// and the clause becomes the reason of its unanswered claim.
  std::function<std::vector<std::string>(const SuiteCase& of)> outside;
};

/// The options of a run.
struct RunOptions {
  AskOptions ask{};        ///< the resources of each process
  std::size_t jobs = 1;    ///< the number of processes that are asked at once
  std::string claims{};    ///< the file that keeps the claims, as JSON lines, so that a run can go on; empty: none
  bool goes_on = false;    ///< continues from the claims of the file; otherwise there must be no file
  std::string identity{};  ///< the identity of the run, in one line: only a run with the same identity goes on
};

/// The end of a run, and the system's account of itself.
struct RunEnd {
  std::size_t cases = 0;     ///< the number of cases that were handed on
  bool stopped = false;      ///< true where the run was stopped before the last case
  std::string says{};        ///< the system's name and version, as "Embree 3.13.5"
  std::string last_words{};  ///< the end of its standard error
  std::size_t deaths = 0;    ///< the number of times that it ended or hung and was started again
};

/// A receiver of each case and a claim for each of its rays, in the order of the cases, one after the other.
using ClaimSink = std::function<void(const SuiteCase& of, std::span<const Claim> claims)>;

/// Asks the system all cases, until `stop` is set. The calls of the sink depend neither on the number of jobs nor on
/// where a run was stopped. Throws std::runtime_error where the system does not start or does not keep to the protocol,
/// io::InputError where the file of claims is of another run, and what the sink throws. Where the system writes more
/// lines than it has rays to answer, nobody can tell which answer is of which ray: the file of claims is then removed.
RunEnd run_system(const System& system, const RunCases& cases, const RunOptions& options, const ClaimSink& sink,
                  const std::atomic<bool>& stop);

/// A function that returns the system's claim on the only ray of a case, which need not be of any suite.
using Ask = std::function<Claim(const SuiteCase&)>;

/// A function that asks a system one ray after the other, in a process that it keeps between. The system and `stop`
/// must outlive it. A ray that is asked when `stop` is set is unanswered. It throws std::runtime_error as run_system
/// does. Where `says` is given, each answer puts the system's name and version there; it must outlive the function.
Ask asking(const System& system, const AskOptions& options, const std::atomic<bool>& stop, std::string* says = nullptr);

}  // namespace durero::conform
