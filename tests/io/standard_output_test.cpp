#include "durero/io/standard_output.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <functional>
#include <string>

#include "durero/io/source.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

/// What is thrown while the standard output is that open file, or closed where it is -1; "" where nothing is.
std::string error_on(int file, const std::function<void()>& work) {
  std::fflush(stdout);
  const int kept = ::dup(STDOUT_FILENO);
  if (file < 0) {
    ::close(STDOUT_FILENO);
  } else {
    ::dup2(file, STDOUT_FILENO);
  }
  std::string error;
  try {
    work();
  } catch (const io::FileError& thrown) {
    error = thrown.what();
  }
  ::dup2(kept, STDOUT_FILENO);
  ::close(kept);
  return error;
}

const auto printing = [] { io::print("text"); };

}  // namespace

TEST_CASE("What is printed is there at once") {
  std::array<int, 2> ends{};
  REQUIRE(::pipe(ends.data()) == 0);
  CHECK(error_on(ends[1], [] { io::require_standard_output(); }).empty());
  CHECK(error_on(ends[1], printing).empty());
  std::string text(4, ' ');
  CHECK(::read(ends[0], text.data(), text.size()) == 4);
  CHECK(text == "text");
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  ::close(ends[0]);
  CHECK(error_on(ends[1], printing) ==
        "<stdout>: cannot be written: Broken pipe; expected a standard output that takes what is printed");
  std::signal(SIGPIPE, before);
  ::close(ends[1]);
}

TEST_CASE("A standard output that takes nothing is an error before and while something is printed") {
  const std::string expected = "; expected a standard output that takes what is printed";
  const int full = ::open("/dev/full", O_WRONLY), read_only = ::open("/dev/null", O_RDONLY);
  for (const auto& work : std::initializer_list<std::function<void()>>{io::require_standard_output, printing}) {
    CHECK(error_on(-1, work) == "<stdout>: cannot be written: Bad file descriptor" + expected);
    CHECK(error_on(full, work) == "<stdout>: cannot be written: No space left on device" + expected);
    CHECK(error_on(read_only, work) == "<stdout>: cannot be written: Bad file descriptor" + expected);
  }
  ::close(full);
  ::close(read_only);
}
