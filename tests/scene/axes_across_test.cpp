#include "durero/scene/axes_across.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "support/catch.hpp"

using namespace durero;

TEST_CASE("angles count from the axis of space that an axis has the least of, right-handed about it") {
  const auto first = [](const glm::dvec3& d) { return scene::axes_across(d).first; };
  CHECK(first({0, 1, 0}) == glm::dvec3(1, 0, 0));
  CHECK(first({1, 0, 0}) == glm::dvec3(0, 1, 0));
  CHECK(first({0, 0, -1}) == glm::dvec3(1, 0, 0));
  CHECK(first({0.6, 0.8, 0}) == glm::dvec3(0, 0, 1));
  for (const glm::dvec3& d : {glm::dvec3(0.6, 0.8, 0), glm::dvec3(0.48, 0.6, -0.64), glm::dvec3(0, 0, 1)}) {
    const auto [one, other] = scene::axes_across(d);
    CHECK(std::abs(glm::dot(one, d)) < 1e-15);
    CHECK(std::abs(glm::length(one) - 1) < 1e-15);
    CHECK(glm::length(glm::cross(one, other) - d) < 1e-15);
  }
}
