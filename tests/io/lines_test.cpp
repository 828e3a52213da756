#include "durero/io/lines.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "durero/io/json/operations_file.hpp"
#include "durero/io/mesh/ply.hpp"
#include "durero/io/nff/nff.hpp"
#include "durero/io/rays/rays_file.hpp"
#include "durero/io/source.hpp"
#include "durero/scene/stage.hpp"
#include "malformed.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;
using io::TextLine;

namespace {

std::vector<TextLine> all_lines(std::string_view text) {
  std::vector<TextLine> all;
  io::Lines lines(text);
  while (const auto line = lines.next()) all.push_back(*line);
  return all;
}

}  // namespace

TEST_CASE("A line ends as any system ends it") {
  CHECK(all_lines("ab\ncd\r\nef\rg") == std::vector<TextLine>{{1, 0, 2}, {2, 3, 5}, {3, 7, 9}, {4, 10, 11}});
  CHECK(all_lines("\n\r\r\n\n") == std::vector<TextLine>{{1, 0, 0}, {2, 1, 1}, {3, 2, 2}, {4, 4, 4}});
  CHECK(all_lines("a\r") == std::vector<TextLine>{{1, 0, 1}});
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
    for (const TextLine& line : all_lines(text)) {
      RC_ASSERT(source.place(line.begin) == io::TextPosition({line.number, 1}));
      RC_ASSERT(source.place(line.end).line == line.number);
    }
  });
}

TEST_CASE("A line is too long from the byte on that is one too many, in whatever blocks it comes") {
  constexpr std::size_t longest = 10;
  const std::string full(longest, ' ');
  for (const std::string before : {"", "a\n", "a\r\n", "\n\nab\r", "0123456789\n"}) {
    for (std::size_t block = 1; block <= longest; ++block) {
      const auto too_many = [&](const std::string& text) {
        io::LineLengths lengths(longest);
        std::optional<std::size_t> found;
        for (std::size_t at = 0; at < text.size() && !found; at += block)
          found = lengths.pass(std::string_view(text).substr(at, block));
        return found;
      };
      CHECK_FALSE(too_many(before + full));
      CHECK_FALSE(too_many(before + full + "\n" + full + "\r\n"));
      CHECK(too_many(before + full + " ") == before.size() + longest);
      CHECK(too_many(before + full + " \nb") == before.size() + longest);
    }
  }
}

TEST_CASE("Each reader of lines refuses one that is too long, at its place, and reads one that is as long as may be") {
  const auto longest = [](char filled, std::size_t more = 0) { return std::string(io::longest_line + more, filled); };
  const auto refused = [](const std::string& text, const auto& read) { return test::error_of(text, read); };
  const scene::Scene scene;
  const auto rays = [&](const io::Source& source) { io::read_rays(source, scene); };
  const auto script = [&](const io::Source& source) { io::read_script(source, scene.stage(), {}); };
  const std::string wrong =
      fmt::format("a line of more than {0} bytes; expected a shorter one: no line that means ", io::longest_line);
  const std::string place = fmt::format("f:2:{}: ", io::longest_line + 1);
  const std::string head = "# a comment\n";
  CHECK_THAT(refused(head + longest(' ', 1), rays), Catch::StartsWith(place + wrong));
  CHECK(refused(head + longest(' '), rays).empty());
  CHECK_THAT(refused(head + longest(' ', 1) + "\n", script), Catch::StartsWith(place + wrong));
  CHECK(refused(head + longest(' ') + "\n", script).empty());
  CHECK_THAT(refused(head + longest(' ', 1), io::read_nff), Catch::StartsWith(place + wrong));
  CHECK_THAT(refused("ply\n" + longest(' ', 1), io::read_ply), Catch::StartsWith(place + wrong));
}
