#include "durero/accel/wide/frustum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "durero/number/rational.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::WideNode;
using accel::WidePacket;
using number::exact;
using number::Rational;

namespace {

constexpr float nothing = std::numeric_limits<float>::infinity();
constexpr surface::Box all{{-20, -20, -20}, {20, 20, 20}};

/// A box that holds the point, narrowly; of each axis one plane or both go through the nearest numbers of binary32.
void hold(WideNode& node, std::size_t place, const glm::dvec3& point, Random& random) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double x = point[static_cast<int>(axis)];
    const auto nearest = static_cast<float>(x);
    const float low = static_cast<double>(nearest) <= x ? nearest : std::nextafter(nearest, -nothing);
    const float high = static_cast<double>(nearest) >= x ? nearest : std::nextafter(nearest, nothing);
    node.planes[axis][place] = random.integer(0, 1) == 0 ? low : low - 1;
    node.planes[axis + 3][place] = random.integer(0, 1) == 0 ? high : high + 1;
  }
}

/// Segments from about a point, or from a point, or along each other; the first `count` places.
void fill(WidePacket& bundle, std::size_t count, int kind, double apart, Random& random) {
  const glm::dvec3 p = random.in_cube(9), end = random.in_cube(9);
  for (std::size_t place = 0; place < count; ++place) {
    const glm::dvec3 from = kind == 1 ? p : p + random.in_cube(apart);
    const glm::dvec3 to = kind == 0 ? end : kind == 1 ? end + random.in_cube(apart) : from + (end - p);
    bundle.set(place, trace::Ray(ray(from, to - from)), place % 11 == 10 ? -1 : 1);
  }
  bundle.begin = 0, bundle.end = count;
}

}  // namespace

TEST_CASE("a beam passes over no box that holds a point of a segment") {
  Random random(5);
  std::size_t narrow = 0;
  for (std::size_t turn = 0; turn < fewer_when_sanitized(2000); ++turn) {
    WidePacket bundle;
    const std::size_t count = 8 * (1 + turn % 8);
    fill(bundle, count, static_cast<int>(turn % 3), std::ldexp(1, -static_cast<int>(turn % 50)), random);
    const accel::Frustum beam = beam_of(bundle, all);
    if (!std::isfinite(beam.width)) continue;
    narrow += beam.width < 0.1;
    for (std::size_t place = 0; place < count; ++place) {
      if (bundle.limit[place] < 0) continue;
      WideNode node;
      for (std::size_t child = 0; child < WideNode::width; ++child) {
        const double t = child == 0 ? 0 : child == 1 ? 1 : random.uniform(0, 1);
        const glm::dvec3 p(bundle.rays.p[0][place], bundle.rays.p[1][place], bundle.rays.p[2][place]);
        const glm::dvec3 v(bundle.rays.v[0][place], bundle.rays.v[1][place], bundle.rays.v[2][place]);
        hold(node, child, p + t * v, random);
      }
      // The box that was to hold the point does, exactly, or is not asked about: the point was rounded.
      unsigned holding = 0;
      for (std::size_t child = 0; child < WideNode::width; ++child) {
        Rational first = 0, last = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const Rational p = exact(bundle.rays.p[axis][place]), v = exact(bundle.rays.v[axis][place]);
          const Rational low = exact(static_cast<double>(node.planes[axis][child]));
          const Rational high = exact(static_cast<double>(node.planes[axis + 3][child]));
          if (v == 0) {
            if (p < low || p > high) last = -1;
            continue;
          }
          const Rational one = (low - p) / v, other = (high - p) / v;
          first = std::max(first, std::min(one, other)), last = std::min(last, std::max(one, other));
        }
        if (first <= last) holding |= 1u << child;
      }
      CHECK((met(node, beam) & holding) == holding);
    }
  }
  CHECK(narrow > fewer_when_sanitized(500));
}

TEST_CASE("a beam passes over what lies beside it, before it and beyond it") {
  WidePacket bundle;
  for (std::size_t place = 0; place < 8; ++place) {
    const glm::dvec3 from(0.01 * static_cast<double>(place), 0, 0.01 * static_cast<double>(place % 3));
    bundle.set(place, trace::Ray(ray(from, glm::dvec3(0.5, 8, 0.25) - from)), 1);
  }
  bundle.begin = 0, bundle.end = 8;
  const accel::Frustum beam = beam_of(bundle, all);
  CHECK(beam.along == 1);
  CHECK(beam.width < 0.1);
  const auto asked = [&](const glm::dvec3& centre) {
    WideNode node;
    for (std::size_t plane = 0; plane < 6; ++plane) node.planes[plane].fill(plane < 3 ? nothing : -nothing);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      node.planes[axis][3] = static_cast<float>(centre[static_cast<int>(axis)] - 0.02);
      node.planes[axis + 3][3] = static_cast<float>(centre[static_cast<int>(axis)] + 0.02);
    }
    return met(node, beam);
  };
  const glm::dvec3 middle(0.25 + 0.0175, 4, 0.125 + 0.005);
  CHECK(asked(middle) == 1u << 3);
  for (const glm::dvec3& aside : {glm::dvec3(0.15, 0, 0), glm::dvec3(0, 0, 0.15)}) {
    CHECK(asked(middle + aside) == 0);
    CHECK(asked(middle - aside) == 0);
  }
  CHECK(asked({0, -0.1, 0}) == 0);
  CHECK(asked({0.5, 8.1, 0.25}) == 0);
}

TEST_CASE("of segments that stand still along the longest way of the first, a beam says nothing or what is true") {
  WidePacket bundle;
  for (std::size_t place = 0; place < 8; ++place)
    bundle.set(place, trace::Ray(ray({0, 0, 0}, place == 0 ? glm::dvec3(0, 1, 0.5) : glm::dvec3(1, 0, 0))), 1);
  bundle.begin = 0, bundle.end = 8;
  CHECK_FALSE(std::isfinite(beam_of(bundle, all).width));
}
