#include "durero/io/output_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "durero/io/source.hpp"
#include "support/catch.hpp"

using namespace durero::io;
namespace fs = std::filesystem;

namespace {

// A directory of its own for one test.
class Directory {
 public:
  Directory() {
    std::string name = (fs::temp_directory_path() / ("durero-test-" + std::string(6, 'X'))).string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~Directory() { fs::remove_all(path_); }
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(path_), {}); }

 private:
  fs::path path_;
};

std::string contents(const std::string& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("An output file appears at commit, whole") {
  const Directory directory;
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
  const Directory directory;
  const std::string path = directory.file("out");
  { OutputFile(path).write("lost"); }
  CHECK(directory.files() == 0);
  write_file(path, "kept");
  { OutputFile(path).write("lost"); }
  CHECK(contents(path) == "kept");
  CHECK(directory.files() == 1);
}

TEST_CASE("A new file has the permissions that the user's mask gives, a replaced one keeps its own") {
  const Directory directory;
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
  const Directory directory;
  write_file(directory.file("target"), "old");
  fs::create_symlink("target", directory.file("link"));
  write_file(directory.file("link"), "new");
  CHECK(fs::is_symlink(directory.file("link")));
  CHECK(contents(directory.file("target")) == "new");
}

TEST_CASE("What cannot be written is named, with the reason") {
  const Directory directory;
  CHECK_THROWS_WITH(OutputFile(directory.file("no/such")), Catch::Contains("no/such: cannot be written: No such file"));
  CHECK_THROWS_WITH(OutputFile("/"), Catch::Contains("/: cannot be written: Is a directory"));
  OutputFile full("/dev/full");  // no regular file: written to at commit, and always full
  full.write("x");
  CHECK_THROWS_WITH(full.commit(), Catch::Contains("/dev/full: cannot be written: No space left"));
}

TEST_CASE("A device is written to, not replaced") {
  write_file("/dev/null", "x");
  CHECK(fs::is_character_file("/dev/null"));
}
