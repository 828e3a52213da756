#include "durero/conform/ask/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>

#include "conform/ask/asker.hpp"
#include "conform/ask/claims_log.hpp"

namespace durero::conform {
namespace {

/// A case and its claims that wait for those of earlier cases.
struct Answered {
  SuiteCase of;
  std::vector<Claim> claims;
  std::size_t asked = 0;  // of its rays, by this run
  std::string says{};
};

/// The number of cases that may wait, for each job.
constexpr std::size_t waiting_of_a_job = 8;

bool is_answer(const Claim& claim) {
  return claim.outcome == Claim::Outcome::hit || claim.outcome == Claim::Outcome::miss;
}

std::optional<ClaimsLog> open_log(const RunOptions& options) {
  if (options.claims.empty()) return std::nullopt;
  return options.goes_on ? ClaimsLog::go_on(options.claims, options.identity)
                         : ClaimsLog::begin(options.claims, options.identity);
}

/// A run on several jobs. Jobs take the cases in order; the job that finishes the next case to be handed on also hands
/// on all finished cases behind it.
class Run {
 public:
  Run(const System& system, const RunCases& cases, const RunOptions& options, const ClaimSink& sink)
      : system_(&system),
        cases_(&cases),
        options_(&options),
        sink_(&sink),
        log_(open_log(options)),
        kept_(log_ ? log_->cases() : 0),
        working_(std::max<std::size_t>(options.jobs, 1)) {}

  RunEnd finish(const std::atomic<bool>& stop) {
    std::vector<std::jthread> jobs;
    for (std::size_t i = working_; i > 0; --i) jobs.emplace_back([this] { work(); });
    for (std::unique_lock lock(mutex_); working_ > 0; changed_.wait_for(lock, std::chrono::milliseconds(50))) {
      if (stop) stop_ = true;
    }
    jobs.clear();
    if (error_) std::rethrow_exception(error_);
    end_.cases = handed_on_;
    end_.stopped = handed_on_ < cases_->count;
    return end_;
  }

 private:
  void work() {
    Asker asker(*system_, options_->ask, stop_);
    try {
      while (const auto place = take_place()) {
        std::optional<Answered> answered = ask(asker, *place);
        if (!answered) break;
        hand_on(*place, std::move(*answered));
      }
      asker.close();
    } catch (const ProtocolBreach&) {
      fail();
      if (log_) log_->remove();
    } catch (...) {
      fail();
    }
    const std::scoped_lock lock(mutex_);
    end_.deaths += asker.deaths();
    if (!asker.says().empty()) end_.says = asker.says();
    if (!asker.last_words().empty()) end_.last_words = asker.last_words();
    --working_;
    changed_.notify_all();
  }

  void fail() {
    const std::scoped_lock lock(mutex_);
    if (!error_) error_ = std::current_exception();
    stop_ = true;
  }

  /// The place of the next case that no job has taken, once there is room for its claims; nothing at the end or after a
  /// stop.
  std::optional<std::size_t> take_place() {
    std::unique_lock lock(mutex_);
    const std::size_t room = waiting_of_a_job * std::max<std::size_t>(options_->jobs, 1);
    while (!stop_ && next_ < cases_->count && next_ >= handed_on_ + room)
      changed_.wait_for(lock, std::chrono::milliseconds(50));
    if (stop_ || next_ == cases_->count) return std::nullopt;
    return next_++;
  }

  /// The answers to a case; nothing where the run was stopped.
  std::optional<Answered> ask(Asker& asker, std::size_t place) const {
    Answered answered{cases_->make(place), {}};
    if (place < kept_) {
      answered.claims = log_->claims(place, answered.of);
      return answered;
    }
    const std::size_t count = answered.of.the_case.rays.size();
    answered.claims.resize(count);
    std::vector<std::size_t> inside;
    std::vector<std::string> outside = cases_->outside(answered.of);
    for (std::size_t ray = 0; ray < count; ++ray) {
      answered.claims[ray].why = std::move(outside[ray]);
      if (answered.claims[ray].why.empty()) inside.push_back(ray);
    }
    if (!asker.ask(answered.of, inside, answered.claims)) return std::nullopt;
    answered.asked = inside.size();
    answered.says = asker.says();
    return answered;
  }

  void hand_on(std::size_t place, Answered answered) {
    const std::scoped_lock lock(mutex_);
    waiting_.emplace(place, std::move(answered));
    while (!waiting_.empty() && waiting_.begin()->first == handed_on_) {
      const Answered next = std::move(waiting_.extract(waiting_.begin()).mapped());
      require_answers(next);
      if (log_ && handed_on_ >= kept_) log_->add(next.of, next.claims, next.says);
      (*sink_)(next.of, next.claims);
      ++handed_on_;
    }
    changed_.notify_all();
  }

  void require_answers(const Answered& of) {
    if (of.asked == 0) return;
    silent_ = std::ranges::any_of(of.claims, is_answer) ? 0 : silent_ + 1;
    if (silent_ < options_->ask.silent_cases) return;
    throw std::runtime_error(fmt::format("{}: no answer to any ray of {} scenes in a row, the last {}; expected some",
                                         system_->name, silent_, of.of.name()));
  }

  const System* system_;
  const RunCases* cases_;
  const RunOptions* options_;
  const ClaimSink* sink_;
  std::optional<ClaimsLog> log_;
  const std::size_t kept_;  // cases that the log had

  std::atomic<bool> stop_ = false;  // by the user, or because a job failed
  std::mutex mutex_;                // guards the members below
  std::condition_variable changed_;
  std::size_t working_;
  std::size_t next_ = 0, handed_on_ = 0, silent_ = 0;
  std::map<std::size_t, Answered> waiting_;
  std::exception_ptr error_;
  RunEnd end_;
};

}  // namespace

RunEnd run_system(const System& system, const RunCases& cases, const RunOptions& options, const ClaimSink& sink,
                  const std::atomic<bool>& stop) {
  return Run(system, cases, options, sink).finish(stop);
}

Ask asking(const System& system, const AskOptions& options, const std::atomic<bool>& stop, std::string* says) {
  const auto asker = std::make_shared<Asker>(system, options, stop);
  return [asker, says](const SuiteCase& of) {
    constexpr std::array<std::size_t, 1> only{0};
    Claim claim;
    asker->ask(of, only, {&claim, 1});
    if (says != nullptr) *says = asker->says();
    return claim;
  };
}

}  // namespace durero::conform
