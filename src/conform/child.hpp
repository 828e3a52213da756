#pragma once
/// A child process that is written to and read from by lines, within a time. It leads a process group of its own, so
/// that whatever it starts ends with it.

#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "durero/conform/system_file.hpp"

namespace durero::conform {

using Seconds = std::chrono::duration<double>;

/// Bounds on what a child may use and say.
struct ChildLimits {
  std::uint64_t memory = 0;       ///< bytes of data; 0: without limit
  std::size_t line = 4096;        ///< bytes of a line; the rest of a longer one is left out
  std::size_t last_words = 2048;  ///< bytes of its standard error that are kept, the last ones
};

class Child {
 public:
  enum class Event {
    line,    ///< a line was read
    ended,   ///< it ended, or closed its standard output
    late,    ///< the time passed without a line
    stopped  ///< `stop` was set
  };

  /// Starts it. Throws std::runtime_error where there is no such program. `stop` must outlive it.
  Child(const Command& command, const ChildLimits& limits, const std::atomic<bool>& stop);
  /// Ends it, and all that it started, and waits for it.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// What it is to be told next; it is written while its lines are awaited, as it takes it.
  void tell(std::string_view text) { to_tell_.append(text); }
  /// It is told nothing more.
  void close_input();
  /// Its next line, without the end, into `line`. The time counts from the call.
  Event next_line(Seconds time, std::string& line);
  /// Whether it wrote more than the lines that were read.
  bool has_more();
  /// Tells it that nothing more comes, and waits until it ends or the time passes; whether it wrote anything until
  /// then.
  bool close(Seconds time);
  /// Ends it now: how it had ended, if it had, such as "exit status 3" or "signal 6 (Aborted)".
  std::string end();
  /// The last of what it wrote to its standard error.
  const std::string& last_words() const { return last_words_; }

 private:
  bool take_line(std::string& line);
  void await(int milliseconds);
  void write_some();
  void read_answers();
  void read_last_words();

  ChildLimits limits_;
  const std::atomic<bool>* stop_;
  pid_t process_ = -1;
  int input_ = -1, output_ = -1, error_ = -1;
  std::string to_tell_, answers_, last_words_;
  bool skips_line_ = false;  // the rest of a line that is too long
};

}  // namespace durero::conform
