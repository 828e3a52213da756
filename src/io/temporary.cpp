#include "durero/io/temporary.hpp"

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
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

[[noreturn]] void fail() { throw std::system_error(errno, std::generic_category()); }

/// Calls only what a handler may call. The lock is never given back: no file is made or named any more.
void remove_all_and_end(int signal) {
  lock();
  for (const std::string& name : names()) ::unlink(name.c_str());
  std::signal(signal, SIG_DFL);
  std::raise(signal);  // ends the program when this handler returns, with the status that tells the signal
}

}  // namespace

Temporary::Temporary(const std::string& target) {
  std::string name = target + '.' + std::string(6, 'X');  // mkostemp puts its own six characters there
  const Locked locked;
  names().reserve(names().size() + 1);  // may throw, and leaves no file where it does
  file_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (file_ < 0) fail();
  path_ = name;
  names().push_back(std::move(name));
}

Temporary::~Temporary() {
  if (path_.empty()) return;
  const Locked locked;
  ::unlink(path_.c_str());
  forget(path_);
}

void Temporary::replace(const std::string& target) {
  const Locked locked;
  if (std::rename(path_.c_str(), target.c_str()) != 0) fail();
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
