#pragma once
/// Runs a suite through a system: child processes are asked case by case, and what they claim is handed on in order.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "durero/conform/claim.hpp"
#include "durero/conform/suite.hpp"
#include "durero/conform/system_file.hpp"

namespace durero::conform {

/// What a system may use.
struct AskOptions {
  std::chrono::duration<double> time{10};            ///< for a ray
  std::chrono::duration<double> time_to_start{120};  ///< until it says what it is
  std::uint64_t memory = 0;                          ///< bytes; 0: without limit
  std::size_t hung_of_scene = 3;                     ///< when so many rays of a scene hung, its others are not asked
  std::size_t silent_cases = 20;  ///< when so many cases in a row have no answer at all, it is given up
};

/// The cases of a run, made where they are needed: on several threads at once.
struct RunCases {
  std::size_t count = 0;                             ///< how many
  std::function<SuiteCase(std::size_t place)> make;  ///< the case at that place, from 0 to count − 1
  /// The clause of the profile that the ray is outside of, or nothing; one outside is not asked, and its claim is
  /// unanswered because of it.
  std::function<std::string(const SuiteCase& of, std::size_t ray)> outside;
};

/// How a run is made.
struct RunOptions {
  AskOptions ask{};        ///< what each of the processes may use
  std::size_t jobs = 1;    ///< so many systems are asked at once
  std::string claims{};    ///< the file that keeps the claims, as JSON lines, so that a run can go on; empty: none
  bool goes_on = false;    ///< from what the file has; otherwise there must be none
  std::string identity{};  ///< of the run, one line: only a run of the same goes on
};

/// How a run ended, and what the system was like.
struct RunEnd {
  std::size_t cases = 0;     ///< that were handed on
  bool stopped = false;      ///< before the last
  std::string says{};        ///< what the system says of itself, as "Embree 3.13.5"
  std::string last_words{};  ///< the end of what it wrote to its standard error
  std::size_t deaths = 0;    ///< how often it ended or hung and was started again
};

/// Is handed each case and a claim for each of its rays: in the order of the cases, one after the other.
using ClaimSink = std::function<void(const SuiteCase& of, std::span<const Claim> claims)>;

/// Asks the system all cases, until `stop` is set. What the sink is handed depends neither on the number of jobs nor on
/// where a run was stopped. Throws std::runtime_error where the system does not start or does not keep to the protocol,
/// io::InputError where the file of claims is of another run, and what the sink throws. Where it writes more lines than
/// it has rays to answer, which answer is of which ray cannot be told: the file of claims is then removed.
RunEnd run_system(const System& system, const RunCases& cases, const RunOptions& options, const ClaimSink& sink,
                  const std::atomic<bool>& stop);

/// The system's claim on the only ray of a case, which need not be of any suite.
using Ask = std::function<Claim(const SuiteCase&)>;

/// Asks a system one ray after the other, in a process that is kept between. The system and `stop` must outlive it; a
/// ray that is asked when `stop` is set is unanswered. What it answers throws std::runtime_error as run_system does.
Ask asking(const System& system, const AskOptions& options, const std::atomic<bool>& stop);

}  // namespace durero::conform
