#include "durero/io/source.hpp"

#include <unistd.h>

#include <fstream>
#include <string>
#include <vector>

#include "arriving.hpp"
#include "durero/contract/contract.hpp"
#include "durero/io/input.hpp"
#include "durero/io/lines.hpp"
#include "support/catch.hpp"
#include "support/folder.hpp"

using namespace durero::io;

TEST_CASE("A place counts lines and characters from 1") {
  const Source source("f", "ab\ncñd\r\n\nx");
  CHECK(source.place(0) == TextPosition{1, 1});
  CHECK(source.place(2) == TextPosition{1, 3});
  CHECK(source.place(3) == TextPosition{2, 1});
  CHECK(source.place(6) == TextPosition{2, 3});  // d: ñ takes two bytes and one column
  CHECK(source.place(9) == TextPosition{3, 1});
  CHECK(source.place(10) == TextPosition{4, 1});
  CHECK(source.place(11) == TextPosition{4, 2});  // the end
}

TEST_CASE("Places of a long text are those of its lines, in whatever order they are asked for") {
  std::string text;
  std::vector<std::size_t> begins;
  while (text.size() < 20'000) {
    begins.push_back(text.size());
    text += std::string(begins.size() % 37, 'x') + "ñ" + (begins.size() % 3 == 0 ? "\r\n" : "\n");
  }
  const Source source("f", text, 5);
  for (std::size_t i = 0; i < begins.size(); ++i) {
    const std::size_t line = i * 7919 % begins.size();
    CHECK(source.place(begins[line]) == TextPosition{line + 6, 1});
    CHECK(Source(source).place(begins[line] + (line + 1) % 37 + 2) == TextPosition{line + 6, (line + 1) % 37 + 2});
  }
}

TEST_CASE("A hundred thousand places of a line of ten million bytes are told of") {  // counted one by one: an hour
  const Source source("f", std::string(10'000'000, 'x'));
  for (std::size_t i = 0; i < 100'000; ++i) REQUIRE(source.place(100 * i) == TextPosition{1, 100 * i + 1});
}

TEST_CASE("An error is one line: place, what is wrong, what is expected") {
  const Source source("scene.json", "a\nbc");
  try {
    source.fail(4, "radio is 0", "expected r > 0");
    FAIL("nothing was thrown");
  } catch (const InputError& error) {
    CHECK(std::string(error.what()) == "scene.json:2:3: radio is 0; expected r > 0");
    CHECK(error.place() == TextPosition{2, 3});
    CHECK(error.message() == "radio is 0; expected r > 0");
    CHECK(error.offset() == 4);
    CHECK(error.broken() == nullptr);
  }
}

TEST_CASE("An error may name the clause that is broken; its message begins behind any name") {
  const durero::contract::clause clause{"Rmas.inv.1", "r > 0"};
  try {
    Source("a\n: b.json", "").fail(0, "radio is 0", "expected r > 0", &clause);
    FAIL("nothing was thrown");
  } catch (const InputError& error) {
    CHECK(error.broken() == &clause);
    CHECK(error.message() == "radio is 0; expected r > 0");
  }
}

TEST_CASE("A file that cannot be read is named, with the reason") {
  CHECK_THROWS_WITH(read_source("/nowhere/at/all"),
                    "/nowhere/at/all: cannot be read: No such file or directory; expected a readable file");
  CHECK_THROWS_AS(read_source("/"), FileError);
}

TEST_CASE("Whatever a name or a text holds, an error is one line that a terminal does not obey") {
  const Source source("a\x1B[2J\n\xFF.json", "");
  CHECK_THROWS_WITH(source.fail(0, "\x07 stands here", "expected ∉"),
                    "a\\x1b[2J\\x0a\\xff.json:1:1: \\x07 stands here; expected ∉");
  CHECK_THROWS_WITH(read_source("/nowhere/\x1B[2J"),
                    "/nowhere/\\x1b[2J: cannot be read: No such file or directory; expected a readable file");
}

TEST_CASE("A file of lines is read whole, and a .npy file, which has none") {
  const durero::test::Folder folder;
  const std::string path = folder.file("f"), long_line(longest_line + 1, ' ');
  for (const std::string& text : {std::string(), std::string("a\r\nb"), "\x93NUMPY" + long_line}) {
    std::ofstream(path, std::ios::binary) << text;
    CHECK(read_lines(path).text() == text);
    CHECK(read_lines(path).name() == path);
  }
  std::ofstream(path, std::ios::binary) << "a\n\xC3\xB1" << long_line << "\nb";
  CHECK_THROWS_WITH(read_lines(path),
                    path +
                        ":2:16777216: a line of more than 16777216 bytes; expected a shorter one: no line that "
                        "means something is so long");
  CHECK_THROWS_WITH(read_lines("/nowhere/at/all"),
                    "/nowhere/at/all: cannot be read: No such file or directory; expected a readable file");
}

TEST_CASE("Of a file of lines no more is read than the first line that is too long") {
  durero::test::Blanks endless("a\n");
  CHECK_THROWS_AS(read_lines("/dev/fd/" + std::to_string(endless.out())), InputError);
  ::close(endless.out());
  CHECK(endless.count() < longest_line + 2 * Input::usual_block);
}
