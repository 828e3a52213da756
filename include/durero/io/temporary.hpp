#pragma once
/// New files beside their targets, none of which is left behind: not by an exception, not by a signal, and not for ever
/// by a process that is killed.
///
/// Where the file system has files without a name (O_TMPFILE), a file has none until it takes its target's place; what
/// is killed before leaves nothing. A file that replaces another has a name for two system calls, and where there are
/// no files without one, all the time: TARGET.durero-N.part. Its process holds a lock on it (flock) from before it has
/// the name until it has it no more, so a file of such a name that nobody has locked belongs to a process that was
/// killed. The next Temporary of the same target removes it, where it belongs to the same user.

#include <string>

namespace durero::io {

/// When a file gets a name beside its target.
enum class PartName {
  at_the_end,          ///< at replace(), where the file system can do that
  from_the_beginning,  ///< as where it cannot
};

/// A new, empty file beside its target, which goes with this unless it has taken the target's place by then.
class Temporary {
 public:
  /// Throws std::system_error.
  explicit Temporary(const std::string& target, PartName named = PartName::at_the_end);
  ~Temporary();
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  /// To read and to write. It belongs to the caller, who closes it.
  int file() const noexcept { return file_; }
  /// Gives the file its target's name. Throws std::system_error.
  void replace();

 private:
  void open_without_name();
  void open_with_name();

  std::string target_;
  std::string path_;  // empty: the file has no name beside its target
  int own_ = -1;      // open as long as this is: it holds the lock
  int file_ = -1;
};

/// From this call on SIGINT, SIGTERM and SIGHUP remove every Temporary before they end the program as they always do;
/// one that the program was started to ignore it goes on ignoring. For programs: what is a library leaves signals
/// alone.
void remove_temporaries_at_signals();

}  // namespace durero::io
