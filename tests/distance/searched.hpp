#pragma once
/// Distances by another way: a search over the points of a shape, in numbers of a hundred digits.

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

#include "durero/algebra/value.hpp"
#include "durero/scene/shapes.hpp"
#include "durero/surface/surfaces.hpp"

namespace durero::test {

using Big = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

/// With room for what cancels: an axis may be so near to a unit vector that its square counts in the hundredth digit.
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<500>, boost::multiprecision::et_off>;

inline Wide wide(const number::Dyadic& value) {
  return ldexp(Wide(value.significand().str()), static_cast<int>(value.exponent()));
}

inline Wide wide(const number::DyadicSurd& value) {
  return (wide(value.x) + wide(value.y) * sqrt(wide(value.delta))) / wide(value.w);
}

/// To some hundred digits.
inline Big big(const algebra::Value& value) {
  if (const auto* const surd = std::get_if<number::DyadicSurd>(&value)) return Big(wide(*surd));
  const auto& fraction = std::get<algebra::Fraction>(value);
  const algebra::Root fine = algebra::refined(fraction.at, 1600);
  const auto* const isolated = std::get_if<algebra::Isolated>(&fine);
  const Wide root = isolated ? wide(isolated->low) : wide(std::get<number::DyadicSurd>(fine));
  const auto at = [&](const algebra::Polynomial& p) {
    Wide sum = 0;
    for (std::size_t i = p.size(); i-- > 0;) sum = sum * root + wide(p[i]);
    return sum;
  };
  return Big(at(fraction.numerator) / at(fraction.denominator));
}

struct Big3 {
  Big x, y, z;
  Big3(Big a, Big b, Big c) : x(std::move(a)), y(std::move(b)), z(std::move(c)) {}
  explicit Big3(const glm::dvec3& v) : x(v.x), y(v.y), z(v.z) {}
};
inline Big3 operator-(const Big3& a, const Big3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Big3 operator+(const Big3& a, const Big3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Big3 operator*(const Big& k, const Big3& a) { return {k * a.x, k * a.y, k * a.z}; }
inline Big dot(const Big3& a, const Big3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Big length(const Big3& a) { return sqrt(dot(a, a)); }

/// The least distance of p from the points with q·d = s and |q − s·d| = R(s), as the text has them, 0 ≤ s ≤ altura.
template <class Shape>
Big searched_distance(const Shape& shape, const glm::dvec3& at, const auto& R) {
  const Big3 d(shape.vector), q = Big3(at) - Big3(shape.centro);
  const Big dd = dot(d, d), altura = shape.altura;
  const Big3 out = q - (dot(q, d) / dd) * d;
  const auto distance = [&](const Big& s) {
    const Big along = s / dd, radius = R(s), squared = radius * radius - (along - s) * (along - s) * dd;
    if (squared < 0) return Big(1e300);
    const Big beside = length(out) - sqrt(squared);
    const Big3 ahead = (along - dot(q, d) / dd) * d;
    return sqrt(beside * beside + dot(ahead, ahead));
  };
  std::vector<Big> places{0, altura};
  for (int i = 1; i < 60; ++i) places.push_back(altura * i / 60);
  for (int i = 6; i < 130; i += 2) {
    places.push_back(ldexp(altura, -i));
    places.push_back(altura - ldexp(altura, -i));
  }
  std::ranges::sort(places);
  Big least = 1e300;
  for (std::size_t i = 0; i < places.size(); ++i) {
    Big low = places[i > 0 ? i - 1 : i], high = places[std::min(i + 1, places.size() - 1)];
    const Big here = distance(places[i]);
    least = std::min(least, here);
    if (here > 1e299 || here > distance(low) || here > distance(high)) continue;
    // Beyond the last circle, near an apex, there are no points: where both places lie there, the search goes back. At
    // that circle the distance grows as a root does, so that it is found to twice the digits.
    static const Big golden = (sqrt(Big(5)) - 1) / 2;
    const int turns = distance(high) > 1e299 ? 400 : 120;
    for (int turn = 0; turn < turns; ++turn) {
      const Big step = golden * (high - low);
      const bool is_before = distance(high - step) <= distance(low + step);
      (is_before ? high : low) = is_before ? low + step : high - step;
    }
    least = std::min({least, distance(low), distance((low + high) / 2)});
  }
  return least;
}

inline Big searched_distance(const scene::Cylinder& e, const glm::dvec3& p) {
  return searched_distance(e, p, [&](const Big&) { return Big(e.radio); });
}
inline Big searched_distance(const scene::Cone& e, const glm::dvec3& p) {
  return searched_distance(e, p, [&](const Big& s) { return e.proporcion * (e.altura - s); });
}
inline Big searched_distance(const scene::TruncatedCone& e, const glm::dvec3& p) {
  return searched_distance(e, p, [&](const Big& s) { return e.radio + e.proporcion * (e.altura - s); });
}
inline Big searched_distance(const scene::Sphere& e, const glm::dvec3& p) {
  return abs(length(Big3(p) - Big3(e.centro)) - e.radio);
}
inline Big searched_distance(const scene::Plane& e, const glm::dvec3& p) {
  return abs(dot(Big3(p) - Big3(e.centro), Big3(e.vector))) / length(Big3(e.vector));
}
inline Big searched_distance(const scene::Disc& e, const glm::dvec3& p) {
  const Big3 d(e.vector), q = Big3(p) - Big3(e.centro), out = q - (dot(q, d) / dot(d, d)) * d;
  const Big beyond = std::max(Big(0), Big(length(out) - e.radio)), above = dot(q, d) / length(d);
  return sqrt(beyond * beyond + above * above);
}

/// The points of a segment by one parameter, those of a triangle by segments beside an edge: the distance is convex in
/// both, since the points are affine in both.
inline Big searched_distance(const scene::Triangle& e, const glm::dvec3& at) {
  const Big3 a(e.vertices[0]), b(e.vertices[1]), c(e.vertices[2]), p(at);
  const auto to_segment = [&](const Big3& from, const Big3& to) {
    const Big3 way = to - from;
    const Big t = std::clamp(Big(dot(p - from, way) / dot(way, way)), Big(0), Big(1));
    return length(p - (from + t * way));
  };
  const auto distance = [&](const Big& t) { return to_segment(a + t * (b - a), c + t * (b - c)); };
  Big low = 0, high = 1;
  for (int turn = 0; turn < 150; ++turn) {
    const Big one = low + (high - low) / 3, other = high - (high - low) / 3;
    (distance(one) < distance(other) ? high : low) = distance(one) < distance(other) ? other : one;
  }
  return std::min({distance(low), to_segment(a, b), to_segment(b, c), to_segment(c, a)});
}

}  // namespace durero::test
