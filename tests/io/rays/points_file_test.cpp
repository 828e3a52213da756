#include "durero/io/rays/points_file.hpp"

#include <cmath>

#include "durero/io/rays/npy.hpp"
#include "support/catch.hpp"

using namespace durero;
using io::InputError;
using io::read_points;
using io::Source;

namespace {

std::string table(std::initializer_list<double> numbers, const char* shape) {
  std::string text = io::npy_head("'<f8'", shape);
  for (const double number : numbers) io::append_binary64(text, number);
  return text;
}

std::string refusal(const std::string& text, const std::string& name = "points") {
  try {
    read_points(Source(name, text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

}  // namespace

TEST_CASE("Points are three numbers a line, with comments and blank lines, decimal or hexadecimal") {
  CHECK(read_points(Source("points", "# three\n1 2 3\n\n  -0x1p-3 .5 1e3 # and a comment\r\n4 5 6")) ==
        std::vector<glm::dvec3>{{1, 2, 3}, {-0.125, 0.5, 1000}, {4, 5, 6}});
  CHECK(read_points(Source("points", "")).empty());
  CHECK(read_points(Source("points", table({1, 2, 3, 4, 5, 6}, "(2, 3)"))) ==
        std::vector<glm::dvec3>{{1, 2, 3}, {4, 5, 6}});
}

TEST_CASE("What is no point is refused where it stands") {
  CHECK(refusal("1 2 3\n1 2\n") == "points:2:4: the point ends after 2 numbers; expected x y z");
  CHECK(refusal("1 2 3 4\n") == "points:1:7: \"4\" after three numbers; expected the end of the line");
  CHECK(refusal("1 2 inf\n") == "points:1:5: \"inf\" in a point; expected a finite number");
  CHECK(refusal(table({1, 2, 3, 4, INFINITY, 6}, "(2, 3)")) == "points:2:2: inf; expected a finite number");
  CHECK(refusal(table({1, 2, 3, 4}, "(1, 4)")).find("expected (n, 3)") != std::string::npos);
  CHECK(refusal("1 2 3", "points.npy").find("no NumPy file") != std::string::npos);
}
