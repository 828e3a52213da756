#include "durero/io/temporary.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <functional>
#include <system_error>
#include <thread>

#include "support/catch.hpp"
#include "support/folder.hpp"

using namespace durero;
using io::Temporary;

namespace {

/// How a process ends that does this and nothing else.
int end_of(const std::function<void()>& work) {
  const pid_t process = ::fork();
  REQUIRE(process >= 0);
  if (process == 0) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
    work();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(process, &status, 0);
  return status;
}

}  // namespace

TEST_CASE("A temporary goes with its object, or takes its target's place") {
  const test::Folder folder;
  {
    const Temporary temporary(folder.file("out"));
    CHECK(temporary.file() >= 0);
    CHECK(folder.files() == 1);
    ::close(temporary.file());
  }
  CHECK(folder.files() == 0);
  {
    Temporary temporary(folder.file("out"));
    ::close(temporary.file());
    temporary.replace(folder.file("out"));
  }
  CHECK(folder.files() == 1);
  CHECK(std::filesystem::exists(folder.file("out")));
  CHECK_THROWS_AS(Temporary("/nowhere/out"), std::system_error);
}

TEST_CASE("A signal ends the program as it always does, and leaves no temporary") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const test::Folder folder;
    const int status = end_of([&] {
      io::remove_temporaries_at_signals();
      Temporary placed(folder.file("placed"));
      const Temporary one(folder.file("out")), other(folder.file("out"));
      placed.replace(folder.file("placed"));
      std::raise(signal);
    });
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == signal);
    CHECK(folder.files() == 1);
    CHECK(std::filesystem::exists(folder.file("placed")));
  }
}

TEST_CASE("A signal that was ignored stays so") {
  const test::Folder folder;
  const int status = end_of([&] {
    std::signal(SIGHUP, SIG_IGN);
    io::remove_temporaries_at_signals();
    const Temporary temporary(folder.file("out"));
    std::raise(SIGHUP);
    if (folder.files() != 1) ::_exit(1);
  });
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
}

TEST_CASE("Whenever a signal comes, while threads make temporaries and give them up, none is left") {
  for (int delay = 0; delay < 30; ++delay) {
    const test::Folder folder;
    const int status = end_of([&] {
      io::remove_temporaries_at_signals();
      const auto make = [&] {
        for (;;) {
          const Temporary temporary(folder.file("out"));
          ::close(temporary.file());
        }
      };
      const std::jthread one(make), other(make);
      std::this_thread::sleep_for(std::chrono::microseconds(100 + 97 * delay));
      ::kill(::getpid(), SIGTERM);
      std::this_thread::sleep_for(std::chrono::seconds(60));
    });
    CHECK(WTERMSIG(status) == SIGTERM);
    CHECK(folder.files() == 0);
  }
}
