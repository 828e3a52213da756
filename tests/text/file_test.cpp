#include "durero/text/file.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "support/catch.hpp"

namespace durero::text {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for a scope.
struct Folder {
  fs::path path = fs::temp_directory_path() / "durero-text-file-test";
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

int error_of(const std::string& path) {
  try {
    read_file(path);
  } catch (const std::system_error& error) {
    return error.code().value();
  }
  return 0;
}

TEST_CASE("a file is read byte by byte, and no further than is asked") {
  const Folder folder;
  const std::string path = (folder.path / "bytes").string();
  std::string bytes;
  for (int i = 0; i < 200000; ++i) bytes += static_cast<char>(i % 251);
  std::ofstream(path, std::ios::binary) << bytes;
  CHECK(read_file(path) == bytes);
  CHECK(read_file(path, bytes.size()) == bytes);
  CHECK(read_file(path, 100000) == bytes.substr(0, 100000));
  CHECK(read_file(path, 0).empty());
}

TEST_CASE("an open file is read from where it stands") {
  const Folder folder;
  const std::string path = (folder.path / "rest").string();
  std::ofstream(path, std::ios::binary) << "abc\r\n\0d";
  std::FILE* file = std::fopen(path.c_str(), "rb");
  REQUIRE(file);
  CHECK(std::fgetc(file) == 'a');
  CHECK(read_rest(*file, 2) == "bc");
  CHECK(read_rest(*file) == "\r\n");
  CHECK(read_rest(*file).empty());
  std::fclose(file);
}

TEST_CASE("what cannot be read says why") {
  const Folder folder;
  CHECK(error_of((folder.path / "nowhere").string()) == ENOENT);
  CHECK(error_of(folder.path.string()) == EISDIR);
}

}  // namespace
}  // namespace durero::text
