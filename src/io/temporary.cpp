#include "durero/io/temporary.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <pthread.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <system_error>
#include <utility>
#include <vector>

namespace durero::io {
namespace {

constexpr int ending_signals[] = {SIGINT, SIGTERM, SIGHUP};

std::atomic_flag is_locked;

/// The names of all temporaries. They are never destroyed, for a signal may come while the program ends.
std::vector<std::string>& names() {
  static auto* const all = new std::vector<std::string>;
  return *all;
}

void lock() noexcept {
  while (is_locked.test_and_set(std::memory_order_acquire)) {
  }
}

/// Holds the names and the files still. A signal waits meanwhile: on this thread it is blocked, and on another its
/// handler waits for the lock; so the handler finds the names whole, and under each a file of ours or none.
class Locked {
 public:
  Locked() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : ending_signals) sigaddset(&signals, signal);
    ::pthread_sigmask(SIG_BLOCK, &signals, &before_);
    lock();
  }
  ~Locked() {
    is_locked.clear(std::memory_order_release);
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  Locked(const Locked&) = delete;
  Locked& operator=(const Locked&) = delete;

 private:
  sigset_t before_;
};

void forget(const std::string& path) {
  const auto place = std::ranges::find(names(), path);
  if (place != names().end()) names().erase(place);
}

void remove(const std::string& path) {
  const Locked locked;
  ::unlink(path.c_str());
  forget(path);
}

[[noreturn]] void fail(int error) { throw std::system_error(error, std::generic_category()); }

constexpr mode_t owner_alone = 0600;

/// A process that writes a file alone takes the first name; the others are of processes that write it at once.
constexpr unsigned names_looked_at = 8;

/// A target's name is cut where the other one would be too long: ".durero-4294967295.part" are 23 bytes.
std::string part_name(const std::string& target, unsigned n) {
  constexpr std::size_t most = NAME_MAX - 23;
  const std::size_t name_at = target.find_last_of('/') + 1;
  return fmt::format("{}.durero-{}.part", target.substr(0, name_at + most), n);
}

std::string folder_above(const std::string& target) {
  const std::size_t slash = target.find_last_of('/');
  return slash == std::string::npos ? "." : target.substr(0, slash + 1);
}

/// What linkat(2) finds an open file by that has no name.
std::string link_to(int file) { return fmt::format("/proc/self/fd/{}", file); }

/// False where another holds the lock; true also where the file system has no locks.
bool lock_now(int file) { return ::flock(file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK; }

bool is_named(int file, const std::string& name) {
  struct stat open {
  }, named{};
  return ::fstat(file, &open) == 0 && ::lstat(name.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
         open.st_ino == named.st_ino;
}

/// A file with another name besides is none of ours: somebody linked it there.
bool is_ours(int file) {
  struct stat what {};
  return ::fstat(file, &what) == 0 && S_ISREG(what.st_mode) && what.st_uid == ::geteuid() && what.st_nlink == 1;
}

/// Removes what a process that was killed left under the name. True where the name is free then. Only who holds the
/// lock of a file takes its name away, so the name cannot get another file between the question and the removal.
bool remove_of_killed(const std::string& name) {
  const int file = ::open(name.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return errno == ENOENT;
  const bool is_left = is_ours(file) && ::flock(file, LOCK_EX | LOCK_NB) == 0 && is_named(file, name);
  const bool is_free = is_left && ::unlink(name.c_str()) == 0;
  ::close(file);
  return is_free;
}

/// The first part name of the target that is free and by which `make` makes its file; it fails with EEXIST where there
/// is one. Precondition: the names are locked.
template <class Make>
std::string take_name(const std::string& target, Make make) {
  names().reserve(names().size() + 1);  // may throw, and leaves no file where it does
  for (unsigned n = 0;; ++n) {
    std::string name = part_name(target, n), same = name;
    do {
      if (make(name)) {
        names().push_back(std::move(same));
        return name;
      }
      if (errno != EEXIST) fail(errno);
    } while (remove_of_killed(name));
  }
}

/// Calls only what a handler may call. The lock is never given back: no file is made or named any more.
void remove_all_and_end(int signal) {
  lock();
  for (const std::string& name : names()) ::unlink(name.c_str());
  std::signal(signal, SIG_DFL);
  std::raise(signal);  // ends the program when this handler returns, with the status that tells the signal
}

}  // namespace

Temporary::Temporary(const std::string& target, PartName named) : target_(target) {
  for (unsigned n = 0; n < names_looked_at; ++n) remove_of_killed(part_name(target_, n));
  if (named == PartName::at_the_end) open_without_name();
  if (own_ < 0) open_with_name();
  file_ = ::fcntl(own_, F_DUPFD_CLOEXEC, 0);
  if (file_ >= 0) return;
  const int error = errno;
  if (!path_.empty()) remove(path_);
  ::close(own_);
  fail(error);
}

/// Leaves it to open_with_name() to say why a file cannot be made.
void Temporary::open_without_name() {
  own_ = ::open(folder_above(target_).c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, owner_alone);
  if (own_ < 0) return;
  lock_now(own_);
  if (::access(link_to(own_).c_str(), F_OK) != 0) ::close(std::exchange(own_, -1));  // no /proc to name it by
}

void Temporary::open_with_name() {
  const Locked locked;
  path_ = take_name(target_, [&](const std::string& name) {
    own_ = ::open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, owner_alone);
    if (own_ < 0) return false;
    if (lock_now(own_) && is_named(own_, name)) return true;
    ::close(std::exchange(own_, -1));  // another took it for one of a process that was killed: it removes it
    errno = EEXIST;
    return false;
  });
}

Temporary::~Temporary() {
  if (!path_.empty()) remove(path_);
  ::close(own_);
}

void Temporary::replace() {
  const Locked locked;
  const auto link_as = [&](const std::string& name) {
    return ::linkat(AT_FDCWD, link_to(own_).c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
  };
  if (path_.empty()) {
    if (link_as(target_)) return;  // nothing stands there
    if (errno != EEXIST) fail(errno);
    path_ = take_name(target_, link_as);
  }
  if (std::rename(path_.c_str(), target_.c_str()) != 0) fail(errno);
  forget(path_);
  path_.clear();
}

void remove_temporaries_at_signals() {
  names();  // is made now: a handler must not make it
  for (const int signal : ending_signals) {
    struct sigaction before {};
    ::sigaction(signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN) continue;
    struct sigaction removing {};
    removing.sa_handler = remove_all_and_end;
    ::sigaction(signal, &removing, nullptr);
  }
}

}  // namespace durero::io
