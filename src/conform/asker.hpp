#pragma once
/// Asks one system, and starts it again when it ended or hung.

#include <atomic>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "conform/child.hpp"
#include "durero/conform/runner.hpp"

namespace durero::conform {

/// The system wrote what no ray asked for: which of its answers is of which ray cannot be told.
struct ProtocolBreach : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A crash, an abort or a hang costs its ray alone. Which ray it was is seen when it is asked alone: a system may write
/// its answers when it has all of a scene, so the first ray without one need not be the cause, though mostly it is and
/// is tried first. Nor are the answers before it believed, of which one may be left out: all others are asked again.
class Asker {
 public:
  /// `system` and `stop` must outlive it.
  Asker(const System& system, const AskOptions& options, const std::atomic<bool>& stop)
      : system_(&system), options_(options), stop_(&stop) {}

  /// Asks these rays of the case; their claims go to their places. False where `stop` was set before the last answer.
  /// Throws std::runtime_error where the system does not start, and ProtocolBreach.
  bool ask(const SuiteCase& of, std::span<const std::size_t> rays, std::span<Claim> claims);

  /// Ends the system. Throws ProtocolBreach.
  void close();

  /// What it says of itself; empty while it was never started.
  const std::string& says() const { return says_; }
  const std::string& last_words() const { return last_words_; }
  /// How often it ended or hung.
  std::size_t deaths() const { return deaths_; }

 private:
  struct Attempt {
    std::size_t answered;  // of the rays, from the first
    Child::Event event;    // line: all were answered
    std::string how{};     // it ended
  };

  void start();
  void end_child();
  void require_silence();
  Attempt attempt(const SuiteCase& of, std::span<const std::size_t> rays, std::span<Claim> claims);
  bool ask_rays(const SuiteCase& of, std::span<const std::size_t> rays, std::span<Claim> claims);
  bool ask_after_death(const SuiteCase& of, std::span<const std::size_t> rays, std::size_t suspect,
                       std::span<Claim> claims);
  Claim death(const Attempt& attempt);

  const System* system_;
  AskOptions options_;
  const std::atomic<bool>* stop_;
  std::unique_ptr<Child> child_;
  std::string says_, last_words_, last_scene_;
  std::size_t deaths_ = 0;
  std::size_t hung_of_scene_ = 0;
};

}  // namespace durero::conform
