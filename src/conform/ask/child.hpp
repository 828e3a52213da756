#pragma once
/// A child process exchanges lines with this program, within a time. It leads a process group of its own, and all
/// processes that it starts end with it.

#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "durero/conform/ask/system_file.hpp"

namespace durero::conform {

using Seconds = std::chrono::duration<double>;

/// The limits on a child's memory, folder and output.
struct ChildLimits {
  std::uint64_t memory = 0;       ///< bytes of data; 0: without limit
  std::string folder{};           ///< its working folder, where it may leave files; empty: this program's
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

  /// Starts the process. Throws std::runtime_error where there is no such program. `stop` must outlive this object.
  Child(const Command& command, const ChildLimits& limits, const std::atomic<bool>& stop);
  /// Ends the process and all that it started, and waits for its end.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Appends to the text that the process will read. The text is written while lines are awaited, at the speed at which
  /// the process reads.
  void tell(std::string_view text) { to_tell_.append(text); }
  /// Closes the input of the process: no text follows.
  void close_input();
  /// Closes the input as soon as the process has read all that it was told.
  void close_input_when_told();
  /// Stores the next line of the process, without its end, in `line`. The time counts from the call.
  Event next_line(Seconds time, std::string& line);
  /// Whether the process wrote more than the lines that were read.
  bool has_more();
  /// The text behind the lines that were read, such as a last line without an end.
  const std::string& rest() const { return answers_; }
  /// Closes the input, and waits until the process ends or the time passes. Returns whether it wrote anything until
  /// then.
  bool close(Seconds time);
  /// Ends the process now. Returns how it had ended before, such as "exit status 3" or "signal 6 (Aborted)", or an
  /// empty text.
  std::string end();
  /// The end of its standard error.
  const std::string& last_words() const { return last_words_; }

 private:
  void drop_rest();  // of a line that is too long
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
  bool is_told_all_ = false;  // nothing follows what is to be told
  bool skips_line_ = false;   // the rest of a line that is too long was not dropped yet
};

}  // namespace durero::conform
