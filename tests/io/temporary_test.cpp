#include "durero/io/temporary.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "support/catch.hpp"
#include "support/folder.hpp"

using namespace durero;
using io::PartName;
using io::Temporary;

namespace {

std::string contents(const std::string& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

void write_and_close(const Temporary& temporary, const std::string& text) {
  REQUIRE(::write(temporary.file(), text.data(), text.size()) == static_cast<ssize_t>(text.size()));
  ::close(temporary.file());
}

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
  const auto named = GENERATE(PartName::at_the_end, PartName::from_the_beginning);
  const test::Folder folder;
  const std::string out = folder.file("out");
  {
    const Temporary temporary(out, named);
    CHECK(temporary.file() >= 0);
    CHECK(folder.files() == (named == PartName::at_the_end ? 0 : 1));
    ::close(temporary.file());
  }
  CHECK(folder.files() == 0);
  for (const std::string text : {"one", "two"}) {  // where nothing stands, and where something does
    Temporary temporary(out, named);
    write_and_close(temporary, text);
    temporary.replace();
    CHECK(contents(out) == text);
    CHECK(folder.files() == 1);
  }
  CHECK_THROWS_AS(Temporary("/nowhere/out", named), std::system_error);
}

TEST_CASE("A target's name may be as long as a file system takes") {
  const auto named = GENERATE(PartName::at_the_end, PartName::from_the_beginning);
  const test::Folder folder;
  const std::string out = folder.file(std::string(255, 'n'));
  for (const std::string text : {"one", "two"}) {
    Temporary temporary(out, named);
    write_and_close(temporary, text);
    temporary.replace();
    CHECK(contents(out) == text);
  }
  CHECK(folder.files() == 1);
}

TEST_CASE("What a process that was killed left under a part name is gone after the next run") {
  const test::Folder folder;
  const std::string out = folder.file("out");
  const int status = end_of([&] {
    const Temporary one(out, PartName::from_the_beginning), other(out, PartName::from_the_beginning);
    if (folder.files() == 2) ::kill(::getpid(), SIGKILL);
  });
  CHECK(WTERMSIG(status) == SIGKILL);
  CHECK(folder.files() == 2);
  SECTION("which replaces the target") {
    Temporary next(out);
    write_and_close(next, "next");
    next.replace();
    CHECK(contents(out) == "next");
    CHECK(folder.files() == 1);
  }
  SECTION("which fails") {
    { const Temporary next(out); }
    CHECK(folder.files() == 0);
  }
  SECTION("which has a name from the beginning") {
    { const Temporary next(out, PartName::from_the_beginning); }
    CHECK(folder.files() == 0);
  }
}

TEST_CASE("What a process that lives has under a part name stays, whoever writes the target meanwhile") {
  const test::Folder folder;
  const std::string out = folder.file("out");
  Temporary slow(out, PartName::from_the_beginning);
  {
    Temporary quick(out), other(out, PartName::from_the_beginning);
    write_and_close(quick, "quick");
    write_and_close(other, "other");
    quick.replace();
    CHECK(contents(out) == "quick");
    other.replace();
    CHECK(contents(out) == "other");
  }
  write_and_close(slow, "slow");
  slow.replace();
  CHECK(contents(out) == "slow");
  CHECK(folder.files() == 1);
}

TEST_CASE("A file under a part name that is no file of ours stays") {
  const test::Folder folder;
  const std::string out = folder.file("out"), first = out + ".durero-0.part", second = out + ".durero-1.part";
  std::ofstream(folder.file("kept")) << "kept";
  std::filesystem::create_hard_link(folder.file("kept"), first);
  std::filesystem::create_symlink("kept", second);
  for (const auto named : {PartName::at_the_end, PartName::from_the_beginning}) {
    Temporary temporary(out, named);
    write_and_close(temporary, "out");
    temporary.replace();
  }
  CHECK(contents(out) == "out");
  CHECK(contents(first) == "kept");
  CHECK(contents(folder.file("kept")) == "kept");
  CHECK(std::filesystem::is_symlink(second));
  CHECK(folder.files() == 4);
}

TEST_CASE("A part that cannot take its target's place leaves no name") {
  const auto named = GENERATE(PartName::at_the_end, PartName::from_the_beginning);
  const test::Folder folder;
  {
    Temporary temporary(folder.file("out"), named);
    ::close(temporary.file());
    std::filesystem::create_directory(folder.file("out"));
    CHECK_THROWS_AS(temporary.replace(), std::system_error);
  }
  CHECK(folder.files() == 1);
}

TEST_CASE("A signal ends the program as it always does, and leaves no temporary") {
  const auto named = GENERATE(PartName::at_the_end, PartName::from_the_beginning);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const test::Folder folder;
    const int status = end_of([&] {
      io::remove_temporaries_at_signals();
      Temporary placed(folder.file("placed"), named);
      const Temporary one(folder.file("out"), named), other(folder.file("out"), named);
      placed.replace();
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
    const Temporary temporary(folder.file("out"), PartName::from_the_beginning);
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
          const Temporary temporary(folder.file("out"), PartName::from_the_beginning);
          ::close(temporary.file());
        }
      };
      const std::jthread other(make), killing([delay] {
        std::this_thread::sleep_for(std::chrono::microseconds(100 + 97 * delay));
        ::kill(::getpid(), SIGTERM);  // which the first thread gets, as long as it takes signals
      });
      ::alarm(20);  // ends what waits for itself
      make();
    });
    REQUIRE(WTERMSIG(status) == SIGTERM);
    CHECK(folder.files() == 0);
  }
}

TEST_CASE("Whenever a process is killed, the target is whole, and after the next run nothing else is there") {
  const auto named = GENERATE(PartName::at_the_end, PartName::from_the_beginning);
  const test::Folder folder;
  const std::string out = folder.file("out");
  const auto write = [&](const std::string& text) {
    Temporary temporary(out, named);
    write_and_close(temporary, text);
    temporary.replace();
  };
  const std::string old(10'000, 'o'), fresh(10'000, 'f');
  write(old);
  for (int kill = 0; kill < 100; ++kill) {
    const pid_t process = ::fork();
    REQUIRE(process >= 0);
    if (process == 0) {
      for (;;) {
        write(fresh);
        write(old);
      }
    }
    std::this_thread::sleep_for(std::chrono::microseconds(200 + 37 * kill));
    ::kill(process, SIGKILL);
    ::waitpid(process, nullptr, 0);
    const std::string found = contents(out);
    CHECK((found == old || found == fresh));
    CHECK(folder.files() <= 2);
    write(old);
    CHECK(contents(out) == old);
    CHECK(folder.files() == 1);
  }
}

TEST_CASE("Many processes write one target at once: each time it is whole, and no other name is left") {
  const auto named = GENERATE(PartName::at_the_end, PartName::from_the_beginning);
  const test::Folder folder;
  const std::string out = folder.file("out");
  std::vector<pid_t> writers;
  for (char letter = 'a'; letter < 'e'; ++letter) {
    writers.push_back(::fork());
    REQUIRE(writers.back() >= 0);
    if (writers.back() != 0) continue;
    for (int i = 0; i < 200; ++i) {
      Temporary temporary(out, named);
      write_and_close(temporary, std::string(1000, letter));
      temporary.replace();
    }
    ::_exit(0);
  }
  for (const pid_t writer : writers) {
    int status = 0;
    ::waitpid(writer, &status, 0);
    CHECK(status == 0);
  }
  const std::string found = contents(out);
  CHECK(found == std::string(1000, found.front()));
  CHECK(folder.files() == 1);
}
