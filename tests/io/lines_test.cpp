#include "durero/io/lines.hpp"

#include <vector>

#include "durero/io/source.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;
using io::Line;

namespace {

std::vector<Line> all_lines(std::string_view text) {
  std::vector<Line> all;
  io::Lines lines(text);
  while (const auto line = lines.next()) all.push_back(*line);
  return all;
}

}  // namespace

TEST_CASE("A line ends as any system ends it") {
  CHECK(all_lines("ab\ncd\r\nef\rg") == std::vector<Line>{{1, 0, 2}, {2, 3, 5}, {3, 7, 9}, {4, 10, 11}});
  CHECK(all_lines("\n\r\r\n\n") == std::vector<Line>{{1, 0, 0}, {2, 1, 1}, {3, 2, 2}, {4, 4, 4}});
  CHECK(all_lines("a\r") == std::vector<Line>{{1, 0, 1}});
  CHECK(all_lines("").empty());
  CHECK(io::count_lines("a\rb\r\n") == 2);
  CHECK(io::count_lines("a\n\n") == 2);
  CHECK(io::count_lines("") == 0);
}

TEST_CASE("A line ends behind \\n, and behind \\r where no \\n follows") {
  CHECK(io::ends_line("\n", 0));
  CHECK(io::ends_line("\r", 0));
  CHECK(io::ends_line("\rx", 0));
  CHECK_FALSE(io::ends_line("\r\n", 0));
  CHECK(io::ends_line("\r\n", 1));
  CHECK_FALSE(io::ends_line("x", 0));
}

TEST_CASE("Lines and places count alike") {
  test::property("any text", [] {
    const auto piece = rc::gen::element<std::string>("a", "b ", "\n", "\r\n", "\r");
    std::string text;
    for (const auto& p : *rc::gen::container<std::vector<std::string>>(piece)) text += p;
    const io::Source source("f", text);
    for (const Line& line : all_lines(text)) {
      RC_ASSERT(source.place(line.begin) == io::Place({line.number, 1}));
      RC_ASSERT(source.place(line.end).line == line.number);
    }
  });
}
