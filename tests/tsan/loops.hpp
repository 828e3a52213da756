#pragma once
/// What this project uses of TBB, as threads of the standard library, for the build under ThreadSanitizer. It judges by
/// the synchronisation that it sees, so by code that was compiled for it; TBB's library is not, and its protocols of
/// stealing work could not be judged if it were. Here every order between two threads is one that it sees, so a report
/// is a race of this project, but for one of exceptions (suppressions.txt), and TBB promises no order that is not here:
/// the end of a loop comes after every call, and no call after another.

#include <cstddef>
#include <exception>
#include <iterator>
#include <list>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

/// @{ For `durero version`: that none is there.
#define TBB_VERSION_MAJOR 0
#define TBB_VERSION_MINOR 0
/// @}

namespace tbb {

inline namespace stand_in {

/// How many threads a loop has: enough to meet, on any machine.
inline thread_local int loop_threads = 4;

/// call(0), …, call(count − 1), each once, by the threads in turn: so each thread has its share however fast another
/// is, and what two of them do without an order is always seen. The first exception is thrown when all threads are
/// done.
template <class Call>
void on_threads(std::size_t count, const Call& call) {
  const auto threads = static_cast<std::size_t>(loop_threads);
  std::exception_ptr failure;
  std::once_flag failed;
  const auto work = [&](std::size_t first) {
    try {
      for (std::size_t i = first; i < count; i += threads) call(i);
    } catch (...) {
      std::call_once(failed, [&] { failure = std::current_exception(); });
    }
  };
  std::vector<std::thread> others;
  for (std::size_t first = 1; first < threads; ++first) others.emplace_back(work, first);
  work(0);
  for (std::thread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace stand_in

template <class Index>
class blocked_range {
 public:
  blocked_range(Index begin, Index end) : begin_(begin), end_(end) {}
  Index begin() const { return begin_; }
  Index end() const { return end_; }
  std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
  bool empty() const { return !(begin_ < end_); }

 private:
  Index begin_, end_;
};

template <class Index, class Body>
void parallel_for(Index begin, Index end, const Body& body) {
  if (!(begin < end)) return;
  on_threads(static_cast<std::size_t>(end - begin), [&](std::size_t i) { body(static_cast<Index>(begin + i)); });
}

/// How TBB is to cut a range: here each index is one call, whatever is asked.
struct simple_partitioner {};
template <class Index, class Body>
void parallel_for(Index begin, Index end, const Body& body, const simple_partitioner&) {
  parallel_for(begin, end, body);
}

/// One call for each index: TBB may cut a range so far.
template <class Index, class Body>
void parallel_for(const blocked_range<Index>& range, const Body& body) {
  parallel_for(range.begin(), range.end(), [&](Index i) { body(blocked_range<Index>(i, i + 1)); });
}

class task_arena {
 public:
  static constexpr int automatic = -1;
  explicit task_arena(int threads = automatic) : threads_(threads == automatic ? loop_threads : threads) {}

  template <class Work>
  auto execute(const Work& work) {
    const Threads outside(threads_);
    return work();
  }

 private:
  struct Threads {
    explicit Threads(int threads) : before(std::exchange(loop_threads, threads)) {}
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;
    ~Threads() { loop_threads = before; }
    int before;
  };
  int threads_;
};

namespace this_task_arena {
inline int max_concurrency() { return loop_threads; }
/// A thread that waits for a loop here takes no work of another.
template <class Work>
auto isolate(const Work& work) {
  return work();
}
}  // namespace this_task_arena

/// A bound on threads changes no answer, and fewer would show less.
class global_control {
 public:
  enum parameter { max_allowed_parallelism };
  global_control(parameter, std::size_t) {}
};

/// One value a thread, made where it first asks.
template <class Value>
class enumerable_thread_specific {
 public:
  Value& local() {
    const std::scoped_lock lock(mutex_);
    for (Entry& entry : entries_) {
      if (entry.owner == std::this_thread::get_id()) return entry.value;
    }
    return entries_.emplace_back(Entry{std::this_thread::get_id(), Value{}}).value;
  }

  /// op over all of them, in no order; a new value where no thread asked.
  template <class Operation>
  Value combine(Operation op) {
    if (entries_.empty()) return Value{};
    Value all = entries_.front().value;
    for (auto entry = std::next(entries_.begin()); entry != entries_.end(); ++entry) all = op(all, entry->value);
    return all;
  }

 private:
  struct Entry {
    std::thread::id owner;
    Value value;
  };
  std::list<Entry> entries_;
  std::mutex mutex_;
};

}  // namespace tbb

namespace oneapi {
namespace tbb = ::tbb;
}
