#include "durero/render/texture/bump.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;
using render::bumped;
using render::Tangents;

namespace {

const Tangents axes{{1, 0, 0}, {0, 1, 0}};
const glm::dvec3 z{0, 0, 1};

}  // namespace

TEST_CASE("on an orthonormal frame n'' is n - d_u t_u - d_v t_v exactly") {
  test::property("any slope", [] {
    const double d_u = *rc::gen::inRange(-1000, 1000) / 64.0, d_v = *rc::gen::inRange(-1000, 1000) / 64.0;
    RC_ASSERT(render::normal_of_relief(axes, z, {d_u, d_v}) == z - d_u * axes.u - d_v * axes.v);
  });
}

TEST_CASE("a slope of one tilts by 45 degrees, away from where it rises") {
  const glm::dvec3 n = bumped(axes, z, {1, 0});
  CHECK(n.x == Approx(-std::sqrt(0.5)).epsilon(1e-15));
  CHECK(n.y == 0);
  CHECK(n.z == Approx(std::sqrt(0.5)).epsilon(1e-15));
}

TEST_CASE("n' is a unit vector across t'_u and t'_v to 10^-15") {
  test::property("any slope", [] {
    const glm::dvec2 slope(*rc::gen::inRange(-300, 300) / 100.0, *rc::gen::inRange(-300, 300) / 100.0);
    const glm::dvec3 n = bumped(axes, z, slope);
    RC_ASSERT(std::abs(glm::length(n) - 1) < 1e-15);
    RC_ASSERT(std::abs(glm::dot(n, glm::normalize(axes.u + slope.x * z))) < 1e-15);
    RC_ASSERT(std::abs(glm::dot(n, glm::normalize(axes.v + slope.y * z))) < 1e-15);
  });
}

TEST_CASE("no slope, no tangents or no finite n'': n as it stands, to the last bit") {
  const glm::dvec3 n = glm::normalize(glm::dvec3(1, 2, 3));
  CHECK(bumped({{0.3, 0.1, -0.2}, {0.7, -0.1, 0.4}}, n, {0, 0}) == n);
  CHECK(bumped({{0, 0, 0}, {1, 0, 0}}, z, {0.5, 0.5}) == z);
  CHECK(bumped({{1, 0, 0}, {2, 0, 0}}, z, {0.5, 0.5}) == z);
  CHECK(bumped(axes, z, {INFINITY, 0}) == z);
}

TEST_CASE("a texture that is turned over tilts the normal to where it rises no less: n' stays on the outer side") {
  const render::Tangents mirrored{axes.v, axes.u};
  const glm::dvec3 n = bumped(mirrored, z, {0.5, 0.25});
  CHECK(n.z > 0);
  CHECK(glm::distance(n, bumped(axes, z, {0.25, 0.5})) < 1e-15);
}
