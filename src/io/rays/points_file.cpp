#include "durero/io/rays/points_file.hpp"

#include <fmt/format.h>

#include <cmath>

#include "durero/io/file_name.hpp"
#include "durero/io/lines.hpp"
#include "durero/io/number_text.hpp"
#include "durero/io/rays/npy.hpp"
#include "durero/text/shown.hpp"
#include "io/cursor.hpp"

namespace durero::io {
namespace {

glm::dvec3 read_point(WordCursor& in) {
  glm::dvec3 point;
  for (int i = 0; i < 3; ++i) {
    if (in.done()) in.fail(in.offset(), fmt::format("the point ends after {} numbers", i), "expected x y z");
    point[i] = in.number("#", "a point");
    in.skip_blanks();
  }
  if (in.done()) return point;
  const std::size_t at = in.offset();
  in.fail(at, fmt::format("{} after three numbers", text::shown(in.word("#"))), "expected the end of the line");
}

std::vector<glm::dvec3> of_table(const Source& source) {
  const std::vector<double> numbers = read_npy(source, 3);
  std::vector<glm::dvec3> points;
  points.reserve(numbers.size() / 3);
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k)
      if (!std::isfinite(numbers[i + k]))
        throw InputError(source.name(), {i / 3 + 1, k + 1}, number_text(numbers[i + k]), "expected a finite number");
    points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
  return points;
}

}  // namespace

std::vector<glm::dvec3> read_points(const Source& source) {
  if (is_npy(source.text()) || ends_in(source.name(), ".npy")) return of_table(source);
  std::vector<glm::dvec3> points;
  Lines lines(source.text());
  while (const auto line = lines.next()) {
    WordCursor in(source, *line);
    if (!in.done()) points.push_back(read_point(in));
  }
  return points;
}

}  // namespace durero::io
