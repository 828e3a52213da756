#include "durero/scene/mesh_points.hpp"

#include <cmath>
#include <limits>

#include "support/catch.hpp"

using durero::scene::MeshPoints;
using Points = std::vector<glm::dvec3>;

namespace {

const Points in_single{{0.5, -0.0, 3}, {0x1p100, 1, -7}, {0x1p-149, 0, 0}};

Points read(const MeshPoints& points) {
  Points all;
  for (const glm::dvec3 p : points) all.push_back(p);
  return all;
}

}  // namespace

TEST_CASE("points of binary32 take twelve bytes each, and have their values") {
  MeshPoints points(in_single);
  CHECK(points.bytes() == 3 * 12);
  CHECK(read(points) == in_single);
  CHECK(std::signbit(points[0].y));
  CHECK_FALSE(points.empty());
  CHECK(MeshPoints().empty());
}

TEST_CASE("a point that is not of binary32 widens all, whether it is given, added or set") {
  for (const glm::dvec3& wide : {glm::dvec3(0.1, 0, 0), {0, 0x1p128, 0}, {0, 0, 0x1p-150}}) {
    Points all = in_single;
    all.push_back(wide);
    MeshPoints added(in_single), set(in_single);
    added.push_back(wide);
    set.set(1, wide);
    CHECK(MeshPoints(all).bytes() == 4 * 24);
    CHECK(read(MeshPoints(all)) == all);
    CHECK(read(added) == all);
    CHECK(added == MeshPoints(all));
    CHECK(read(set) == Points{in_single[0], wide, in_single[2]});
    CHECK(set.bytes() == 3 * 24);
    set.set(1, in_single[1]);
    CHECK(set == MeshPoints(in_single));
    CHECK_FALSE(set == added);
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isnan(MeshPoints{{nan, 0, 0}}[0].x));
}

TEST_CASE("room for points stays when they are widened") {
  MeshPoints points;
  points.reserve(10);
  CHECK(points.bytes() == 10 * 12);
  for (int i = 0; i < 9; ++i) points.push_back(glm::dvec3(i));
  points.push_back(glm::dvec3(0.1));
  CHECK(points.bytes() == 10 * 24);
  CHECK(points.size() == 10);
}
