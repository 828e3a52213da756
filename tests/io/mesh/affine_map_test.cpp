#include "io/mesh/affine_map.hpp"

#include "durero/number/rational.hpp"
#include "support/catch.hpp"
#include "support/doubles.hpp"
#include "support/property.hpp"

using namespace durero;
using io::AffineMap;
using number::exact;
using number::Rational;
using number::round_to_binary64;

namespace {

using Triple = std::array<Rational, 3>;
using Quaternion = std::array<Rational, 4>;  // x y z w

Quaternion product(const Quaternion& p, const Quaternion& q) {
  return {p[3] * q[0] + p[0] * q[3] + p[1] * q[2] - p[2] * q[1], p[3] * q[1] - p[0] * q[2] + p[1] * q[3] + p[2] * q[0],
          p[3] * q[2] + p[0] * q[1] - p[1] * q[0] + p[2] * q[3], p[3] * q[3] - p[0] * q[0] - p[1] * q[1] - p[2] * q[2]};
}

struct Parts {
  glm::dvec3 translation, scale;
  std::array<double, 4> rotation;

  AffineMap map() const { return AffineMap::of_parts(translation, rotation, scale); }
  /// Scaled, turned by q·p·q⁻¹, and shifted: by quaternions, and not by the matrix of one.
  Triple image(Triple p) const {
    for (int i = 0; i < 3; ++i) p[static_cast<std::size_t>(i)] *= exact(scale[i]);
    Quaternion q, conjugate;
    Rational norm = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      q[i] = exact(rotation[i]);
      conjugate[i] = i < 3 ? Rational(-q[i]) : q[i];
      norm += q[i] * q[i];
    }
    const Quaternion turned = product(product(q, {p[0], p[1], p[2], 0}), conjugate);
    Triple image;
    for (std::size_t i = 0; i < 3; ++i) image[i] = turned[i] / norm + exact(translation[static_cast<int>(i)]);
    return image;
  }
};

glm::dvec3 rounded(const Triple& x) {
  return {round_to_binary64(x[0]), round_to_binary64(x[1]), round_to_binary64(x[2])};
}

glm::dvec3 any_vector(const rc::Gen<double>& number) { return {*number, *number, *number}; }

Parts any_parts(const rc::Gen<double>& number) {
  Parts parts{any_vector(number), any_vector(number), {*number, *number, *number, *number}};
  RC_PRE(std::ranges::count(parts.rotation, 0) < 4);
  return parts;
}

Triple over(const glm::dvec3& p, double denominator) {
  return {exact(p.x) / exact(denominator), exact(p.y) / exact(denominator), exact(p.z) / exact(denominator)};
}

/// The edges of a map's unit cube, exactly: where it takes the axes from where it takes 0.
std::array<Triple, 3> columns(const Parts& parts) {
  const Triple origin = parts.image({0, 0, 0});
  std::array<Triple, 3> columns{parts.image({1, 0, 0}), parts.image({0, 1, 0}), parts.image({0, 0, 1})};
  for (Triple& column : columns)
    for (std::size_t i = 0; i < 3; ++i) column[i] -= origin[i];
  return columns;
}

Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace

TEST_CASE("a map's points are the exact images, rounded once, whatever the length of the quaternion") {
  test::property("of quaternions", [] {
    const auto numbers = *rc::gen::element(test::moderate(), test::dyadicGrid());
    const Parts parts = any_parts(numbers);
    const glm::dvec3 p = any_vector(numbers);
    const double denominator = *rc::gen::element(1.0, 127.0, 65535.0);
    RC_ASSERT(parts.map().point(p, denominator) == rounded(parts.image(over(p, denominator))));
  });
  test::property("through three nodes", [] {
    const Parts a = any_parts(test::moderate()), b = any_parts(test::moderate()), c = any_parts(test::moderate());
    const glm::dvec3 p = any_vector(test::moderate());
    const AffineMap all = a.map().after(b.map()).after(c.map());
    RC_ASSERT(all.point(p, 1) == rounded(a.image(b.image(c.image(over(p, 1))))));
    RC_ASSERT(all.point(p, 1) == a.map().after(b.map().after(c.map())).point(p, 1));
  });
  CHECK(AffineMap().point({0.1, -0.0, 1e300}, 1) == glm::dvec3(0.1, 0, 1e300));
  CHECK(AffineMap::of_parts({0, 0, 0}, {0, 0, 3, 4}, {1, 1, 1}).point({25, 0, 0}, 1) == glm::dvec3(7, 24, 0));
  CHECK(std::isinf(AffineMap::of_parts({0, 0, 0}, {0, 0, 0, 1}, {1e300, 1, 1}).point({1e300, 0, 0}, 1).x));
}

TEST_CASE("a matrix is read column by column") {
  const AffineMap map = AffineMap::of_matrix({1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 10, 0, 0.5, 0.25, 0.125, 1});
  CHECK(map.point({1, 0, 0}, 1) == glm::dvec3(1.5, 2.25, 3.125));
  CHECK(map.point({0, 1, 0}, 1) == glm::dvec3(4.5, 5.25, 6.125));
  CHECK(map.point({0, 0, 3}, 3) == glm::dvec3(7.5, 8.25, 10.125));
  CHECK(map.orientation() == -1);
}

TEST_CASE("normals go by the transposed inverse, each coordinate rounded once") {
  test::property("by Cramer's rule", [] {
    const auto numbers = *rc::gen::element(test::moderate(), test::dyadicGrid());
    const Parts parts = any_parts(numbers);
    const glm::dvec3 n = any_vector(numbers);
    const auto [a, b, c] = columns(parts);
    const Rational whole = dot(a, cross(b, c));
    const auto map = parts.map().normals();
    RC_ASSERT(parts.map().orientation() == whole.sign());
    RC_ASSERT(map.has_value() == (whole.sign() != 0));
    if (!map) return;
    const Triple own = over(n, 127), bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    Triple wanted;
    for (std::size_t i = 0; i < 3; ++i) wanted[i] = (bc[i] * own[0] + ca[i] * own[1] + ab[i] * own[2]) / whole;
    RC_ASSERT(map->point(n, 127) == rounded(wanted));
  });
  CHECK(!AffineMap::of_parts({1, 2, 3}, {0, 0, 0, 1}, {1, 0, 1}).normals());
}
