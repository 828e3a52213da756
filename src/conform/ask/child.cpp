#include "conform/ask/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <vector>

namespace durero::conform {
namespace {

using Clock = std::chrono::steady_clock;

/// The time that a process has to end by itself after it closed its output, so that its own exit status is seen.
constexpr Seconds to_end{0.1};
/// The interval at which a wait looks whether it is to stop.
constexpr int slice_milliseconds = 100;

struct Pipe {
  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
      throw std::runtime_error(fmt::format("a pipe: {}; expected one", std::strerror(errno)));
  }
  ~Pipe() {
    for (const int end : ends) {
      if (end >= 0) ::close(end);
    }
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  /// The file descriptor of an end of the pipe, which the caller closes from now on.
  int take(std::size_t end) { return std::exchange(ends[end], -1); }

  std::array<int, 2> ends{-1, -1};  // to read from, to write to
};

/// A guard that blocks SIGPIPE in this thread: a child that reads no more is an event, and does not end this program.
class WithoutBrokenPipes {
 public:
  WithoutBrokenPipes() {
    sigemptyset(&broken_pipe_);
    sigaddset(&broken_pipe_, SIGPIPE);
    ::pthread_sigmask(SIG_BLOCK, &broken_pipe_, &before_);
  }
  ~WithoutBrokenPipes() {
    const timespec now{};
    while (::sigtimedwait(&broken_pipe_, nullptr, &now) > 0) {
    }
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  WithoutBrokenPipes(const WithoutBrokenPipes&) = delete;
  WithoutBrokenPipes& operator=(const WithoutBrokenPipes&) = delete;

 private:
  sigset_t broken_pipe_, before_;
};

void close_once(int& file) {
  if (file >= 0) ::close(std::exchange(file, -1));
}

pid_t spawn(const Command& command, const std::string& folder, const Pipe& input, const Pipe& output,
            const Pipe& error) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t files;
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawn_file_actions_adddup2(&files, input.ends[0], STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&files, output.ends[1], STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&files, error.ends[1], STDERR_FILENO);
  if (!folder.empty()) ::posix_spawn_file_actions_addchdir_np(&files, folder.c_str());
  posix_spawnattr_t how;
  ::posix_spawnattr_init(&how);
  ::posix_spawnattr_setflags(&how, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  ::posix_spawnattr_setpgroup(&how, 0);
  sigset_t signals;
  sigemptyset(&signals);
  ::posix_spawnattr_setsigmask(&how, &signals);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) sigaddset(&signals, signal);
  ::posix_spawnattr_setsigdefault(&how, &signals);
  pid_t process = -1;
  const int failed = ::posix_spawnp(&process, words.front(), &files, &how, words.data(), environ);
  ::posix_spawnattr_destroy(&how);
  ::posix_spawn_file_actions_destroy(&files);
  if (failed != 0)
    throw std::runtime_error(fmt::format("{}: {}; expected a program", command.front(), std::strerror(failed)));
  return process;
}

void limit(pid_t process, int resource, std::uint64_t most) {
  const rlimit bound{most, most};
  ::prlimit(process, static_cast<__rlimit_resource>(resource), &bound, nullptr);
}

std::string how_ended(int status) {
  if (WIFEXITED(status)) return fmt::format("exit status {}", WEXITSTATUS(status));
  return fmt::format("signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)));
}

/// The bytes that can be read now; nothing at the end of the file.
std::optional<std::string> read_now(int file) {
  std::string bytes(1 << 16, '\0');
  const ssize_t count = ::read(file, bytes.data(), bytes.size());
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return "";
  if (count <= 0) return std::nullopt;
  bytes.resize(static_cast<std::size_t>(count));
  return bytes;
}

}  // namespace

Child::Child(const Command& command, const ChildLimits& limits, const std::atomic<bool>& stop)
    : limits_(limits), stop_(&stop) {
  Pipe input, output, error;
  process_ = spawn(command, limits.folder, input, output, error);
  limit(process_, RLIMIT_CORE, 0);
  if (limits.memory != 0) limit(process_, RLIMIT_DATA, limits.memory);
  input_ = input.take(1);
  output_ = output.take(0);
  error_ = error.take(0);
  for (const int file : {input_, output_, error_}) ::fcntl(file, F_SETFL, O_NONBLOCK);
}

Child::~Child() { end(); }

void Child::close_input() { close_once(input_); }

void Child::close_input_when_told() {
  is_told_all_ = true;
  if (to_tell_.empty()) close_input();
}

Child::Event Child::next_line(Seconds time, std::string& line) {
  const Clock::time_point until = Clock::now() + std::chrono::duration_cast<Clock::duration>(time);
  for (;;) {
    if (take_line(line)) return Event::line;
    if (output_ < 0) return Event::ended;
    if (*stop_) return Event::stopped;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now()).count();
    if (left <= 0) return Event::late;
    await(static_cast<int>(std::min<std::int64_t>(left, slice_milliseconds)));
  }
}

bool Child::has_more() {
  await(0);
  drop_rest();  // what follows is another line
  return !answers_.empty();
}

bool Child::close(Seconds time) {
  std::string line;
  while (!to_tell_.empty() && output_ >= 0 && !*stop_) await(slice_milliseconds);
  close_input();
  return next_line(time, line) == Event::line || !answers_.empty();
}

std::string Child::end() {
  if (process_ < 0) return "";
  close_once(input_);
  int status = 0;
  pid_t ended = 0;
  // A process that still writes is not waited for.
  const Clock::time_point until = Clock::now() + std::chrono::duration_cast<Clock::duration>(to_end);
  while ((ended = ::waitpid(process_, &status, WNOHANG)) == 0 && output_ < 0 && Clock::now() < until)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  read_last_words();
  ::kill(-process_, SIGKILL);  // and all that it started
  if (ended == 0) ::waitpid(process_, &status, 0);
  process_ = -1;
  close_once(output_);
  close_once(error_);
  return ended == 0 ? "" : how_ended(status);
}

void Child::drop_rest() {
  if (!skips_line_) return;
  const std::size_t end = answers_.find('\n');
  answers_.erase(0, end == answers_.npos ? end : end + 1);
  skips_line_ = end == answers_.npos;
}

bool Child::take_line(std::string& line) {
  drop_rest();
  if (skips_line_) return false;
  const std::size_t end = answers_.find('\n');
  if (end == answers_.npos && answers_.size() <= limits_.line) return false;
  skips_line_ = end == answers_.npos;
  line = answers_.substr(0, std::min(end, limits_.line));
  answers_.erase(0, end == answers_.npos ? end : end + 1);
  return true;
}

void Child::await(int milliseconds) {
  std::array<pollfd, 3> files{pollfd{to_tell_.empty() ? -1 : input_, POLLOUT, 0}, pollfd{output_, POLLIN, 0},
                              pollfd{error_, POLLIN, 0}};
  if (::poll(files.data(), files.size(), milliseconds) <= 0) return;
  if (files[0].revents != 0) write_some();
  if (files[1].revents != 0) read_answers();
  if (files[2].revents != 0) read_last_words();
}

void Child::write_some() {
  const WithoutBrokenPipes guard;
  const ssize_t count = ::write(input_, to_tell_.data(), to_tell_.size());
  if (count >= 0) to_tell_.erase(0, static_cast<std::size_t>(count));
  if (is_told_all_ && to_tell_.empty()) close_once(input_);
  if (count < 0 && errno != EAGAIN && errno != EINTR) {  // it reads no more; what it still writes is read
    to_tell_.clear();
    close_once(input_);
  }
}

void Child::read_answers() {
  const std::optional<std::string> bytes = read_now(output_);
  if (bytes)
    answers_ += *bytes;
  else
    close_once(output_);
}

void Child::read_last_words() {
  if (error_ < 0) return;
  const std::optional<std::string> bytes = read_now(error_);
  if (!bytes) return close_once(error_);
  last_words_ += *bytes;
  if (last_words_.size() > limits_.last_words) last_words_.erase(0, last_words_.size() - limits_.last_words);
}

}  // namespace durero::conform
