#include "conform/families/binary32_axis.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "durero/conform/random.hpp"
#include "durero/model/tipos.hpp"
#include "support/catch.hpp"

using namespace durero;
using conform::binary32_axis;

namespace {

bool is_binary32(const glm::dvec3& v) { return glm::dvec3(glm::vec3(v)) == v; }

}  // namespace

TEST_CASE("every axis is a unit vector of binary32 numbers, near the one that was asked for") {
  conform::Random random(32);
  double farthest = 0;
  for (int i = 0; i < 20000; ++i) {
    glm::dvec3 near = random.direction();
    if (random.chance(1, 2)) near[random.integer(0, 2)] *= random.signed_power(-30, 0);
    near /= glm::length(near);
    const glm::dvec3 d = binary32_axis(near);
    CHECK(is_binary32(d));
    CHECK(model::Unitario::contains(model::Vector(d)));
    CHECK(binary32_axis(-near) == -d);
    farthest = std::max(farthest, glm::length(d - near));
  }
  CHECK(farthest < 0.15);  // some 8 degrees
}

TEST_CASE("in the plane of two coordinates the axis stays there, and along one it stays along it") {
  conform::Random random(33);
  std::size_t turned = 0;
  for (int i = 0; i < 2000; ++i) {
    glm::dvec3 near = random.direction();
    const int zero = random.integer(0, 2);
    near[zero] = 0;
    near /= glm::length(near);
    const glm::dvec3 d = binary32_axis(near);
    CHECK(d[zero] == 0);
    CHECK(is_binary32(d));
    CHECK(model::Unitario::contains(model::Vector(d)));
    turned += (d.x != 0) + (d.y != 0) + (d.z != 0) == 2;
  }
  CHECK(turned == 2000);
  for (int i = 0; i < 3; ++i) {
    glm::dvec3 d(0);
    d[i] = -1;
    CHECK(binary32_axis(d) == d);
  }
}
