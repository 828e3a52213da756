#include "durero/io/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "durero/io/source.hpp"
#include "support/catch.hpp"
#include "support/folder.hpp"

using namespace durero;
using namespace durero::io;
namespace fs = std::filesystem;

namespace {

std::string contents(const std::string& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("An output file appears at commit, whole") {
  const test::Folder directory;
  const std::string path = directory.file("out");
  {
    OutputFile out(path);
    out.write("one ");
    CHECK_FALSE(fs::exists(path));
    out.write("two");
    out.commit();
    CHECK(contents(path) == "one two");
  }
  CHECK(contents(path) == "one two");
  CHECK(directory.files() == 1);
}

TEST_CASE("An output file that is not committed leaves nothing, and what it would replace as it was") {
  const test::Folder directory;
  const std::string path = directory.file("out");
  { OutputFile(path).write("lost"); }
  CHECK(directory.files() == 0);
  write_file(path, "kept");
  { OutputFile(path).write("lost"); }
  CHECK(contents(path) == "kept");
  CHECK(directory.files() == 1);
}

TEST_CASE("A new file has the permissions that the user's mask gives, a replaced one keeps its own") {
  const test::Folder directory;
  const auto mode = [](const std::string& path) {
    struct stat s {};
    REQUIRE(::stat(path.c_str(), &s) == 0);
    return s.st_mode & 0777U;
  };
  const mode_t mask = ::umask(0027);
  write_file(directory.file("new"), "");
  ::umask(mask);
  CHECK(mode(directory.file("new")) == 0640);
  ::chmod(directory.file("new").c_str(), 0604);
  write_file(directory.file("new"), "again");
  CHECK(mode(directory.file("new")) == 0604);
}

TEST_CASE("A symbolic link stays one; its target gets the text") {
  const test::Folder directory;
  write_file(directory.file("target"), "old");
  fs::create_symlink("target", directory.file("link"));
  write_file(directory.file("link"), "new");
  CHECK(fs::is_symlink(directory.file("link")));
  CHECK(contents(directory.file("target")) == "new");
}

TEST_CASE("What cannot be written is named, with the reason") {
  const test::Folder directory;
  CHECK_THROWS_WITH(OutputFile(directory.file("no/such")), Catch::Contains("no/such: cannot be written: No such file"));
  CHECK_THROWS_WITH(OutputFile("/"), Catch::Contains("/: cannot be written: Is a directory"));
  OutputFile full("/dev/full");  // no regular file: written to at once, and always full
  CHECK_THROWS_WITH(full.write("x"), Catch::Contains("/dev/full: cannot be written: No space left"));
}

TEST_CASE("A device is written to, not replaced") {
  write_file("/dev/null", "x");
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("What is written to a pipe is there before commit") {
  const test::Folder directory;
  const std::string path = directory.file("pipe");
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);
  REQUIRE(reader >= 0);
  OutputFile out(path);
  out.write("one");
  std::string text(3, ' ');
  CHECK(::read(reader, text.data(), text.size()) == 3);
  CHECK(text == "one");
  out.commit();
  ::close(reader);
}

TEST_CASE("A pipe that nobody waits on may be full for a while") {
  const test::Folder directory;
  const std::string path = directory.file("pipe");
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);
  const int writer = ::open(path.c_str(), O_WRONLY | O_NONBLOCK);
  REQUIRE(writer >= 0);
  const std::string text(300'000, 'x');  // more than a pipe holds
  std::jthread writing([&] {
    OutputFile out("/dev/fd/" + std::to_string(writer));
    out.write(text);
  });
  std::size_t count = 0;
  std::string some(4096, ' ');
  while (count < text.size())
    count += static_cast<std::size_t>(std::max<ssize_t>(0, ::read(reader, some.data(), some.size())));
  CHECK(count == text.size());
  ::close(reader);
  ::close(writer);
}
