#include "durero/io/file_lock.hpp"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <optional>
#include <thread>

#include "durero/io/output_file.hpp"
#include "durero/io/source.hpp"
#include "support/catch.hpp"
#include "support/folder.hpp"

namespace durero::io {
namespace {

TEST_CASE("A file that is held is waited for, and the one that came in its place is held then") {
  const test::Folder folder;
  const std::string path = folder.file("scene.json");
  write_file(path, "0");
  // Each of these adds one to the number in the file. A lock that left out anything would lose some.
  std::atomic<int> left = 4;
  const auto add = [&] {
    for (int i = 0; i < 100; ++i) {
      const FileLock lock(path);
      const int number = std::stoi(std::string(read_source(path).text()));
      write_file(path, std::to_string(number + 1));
    }
    --left;
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) threads.emplace_back(add);
  for (std::thread& thread : threads) thread.join();
  CHECK(left == 0);
  CHECK(read_source(path).text() == "400");
}

TEST_CASE("A second hold comes after the first is let go") {
  const test::Folder folder;
  const std::string path = folder.file("scene.json");
  write_file(path, "");
  std::optional<FileLock> first(path);
  std::atomic<bool> is_held = false;
  std::thread second([&] {
    const FileLock lock(path);
    is_held = true;
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  CHECK_FALSE(is_held);
  first.reset();
  second.join();
  CHECK(is_held);
}

TEST_CASE("What is no regular file is not held, and not waited for") {
  const test::Folder folder;
  CHECK_NOTHROW(FileLock(folder.file("nothing.json")));
  CHECK_NOTHROW(FileLock("/dev/null"));
}

TEST_CASE("Two paths mean one file where one is a link to the other") {
  const test::Folder folder;
  const std::string file = folder.file("a.json"), link = folder.file("b.json"), other = folder.file("c.json");
  write_file(file, "");
  write_file(other, "");
  REQUIRE(::symlink(file.c_str(), link.c_str()) == 0);
  CHECK(is_same_file(file, file));
  CHECK(is_same_file(file, link));
  CHECK_FALSE(is_same_file(file, other));
  CHECK_FALSE(is_same_file(folder.file("nothing"), folder.file("nothing")));
}

}  // namespace
}  // namespace durero::io
