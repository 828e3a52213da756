#pragma once
/// An asker asks one system, and starts it again when it ended or hung.

#include <atomic>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "conform/ask/child.hpp"
#include "durero/conform/ask/runner.hpp"

namespace durero::conform {

/// The error of a system that wrote more lines than rays were asked: nobody can tell which of its answers is of which
/// ray.
struct ProtocolBreach : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A crash, an abort or a hang costs only the ray that causes it. This ray is found by asking it alone: a system may
/// write its answers when it has all of a scene, so the first ray without an answer need not be the cause, though
/// mostly it is, and it is tried first. The answers before it are not believed either, since one of them may have been
/// left out: all other rays are asked again.
class Asker {
 public:
  /// `system` and `stop` must outlive it.
  Asker(const System& system, const AskOptions& options, const std::atomic<bool>& stop)
      : system_(&system), options_(options), stop_(&stop) {}

  /// Asks these rays of the case and stores their claims at their places. Returns false where `stop` was set before the
  /// last answer. Throws std::runtime_error where the system does not start, and ProtocolBreach.
  bool ask(const SuiteCase& of, std::span<const std::size_t> rays, std::span<Claim> claims);

  /// Ends the system. Throws ProtocolBreach.
  void close();

  /// The system's name and version; empty while it was never started.
  const std::string& says() const { return says_; }
  const std::string& last_words() const { return last_words_; }
  /// The number of times that the system ended or hung.
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
