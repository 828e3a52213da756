#pragma once
/// Files under a temporary name, none of which is left behind: not by an exception, and not by a signal.

#include <string>

namespace durero::io {

/// A new, empty file beside its target, whose name goes with this unless it has taken the target's place by then.
class Temporary {
 public:
  /// Throws std::system_error.
  explicit Temporary(const std::string& target);
  ~Temporary();
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  /// To read and to write. It belongs to the caller, who closes it.
  int file() const noexcept { return file_; }
  /// Gives the file its target's name. Throws std::system_error.
  void replace(const std::string& target);

 private:
  std::string path_;  // empty: there is none under it
  int file_ = -1;
};

/// From this call on SIGINT, SIGTERM and SIGHUP remove every Temporary before they end the program as they always do;
/// one that the program was started to ignore it goes on ignoring. For programs: what is a library leaves signals
/// alone.
void remove_temporaries_at_signals();

}  // namespace durero::io
