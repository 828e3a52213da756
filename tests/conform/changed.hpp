#pragma once
/// Scenes and hits with every length, point, direction and parameter changed.

#include <cmath>
#include <functional>

#include "durero/scene/hit.hpp"
#include "durero/scene/scene.hpp"
#include "support/shapes.hpp"

namespace durero::test {

/// x·2^k, remembering whether it was possible: a subnormal or infinite result may be rounded, and x is given back.
struct Scaling {
  bool exact = true;

  double operator()(double x, int k) {
    const double y = std::ldexp(x, k);
    if (x == 0 || std::isnormal(y)) return y;
    exact = false;
    return x;
  }
  glm::dvec3 operator()(const glm::dvec3& v, int k) { return {(*this)(v.x, k), (*this)(v.y, k), (*this)(v.z, k)}; }
};

/// What is done to lengths, points, directions and to the parameter t.
struct Change {
  std::function<double(double)> length;
  std::function<glm::dvec3(const glm::dvec3&)> point, axis, direction;
  std::function<double(double)> parameter;
};

inline double same(double x) { return x; }
inline glm::dvec3 unchanged(const glm::dvec3& v) { return v; }

/// Elements are added in the order of their places, so they keep them.
inline scene::Scene changed(const scene::Scene& of, const Change& by) {
  scene::Scene made;
  for (const scene::Sphere& s : of.shapes<scene::Sphere>())
    add(made, scene::Sphere{by.point(s.centro), by.length(s.radio)});
  for (const scene::Cylinder& c : of.shapes<scene::Cylinder>())
    add(made, scene::Cylinder{by.point(c.centro), by.length(c.radio), by.axis(c.vector), by.length(c.altura)});
  for (const scene::Cone& c : of.shapes<scene::Cone>())
    add(made, scene::Cone{by.point(c.centro), c.proporcion, by.axis(c.vector), by.length(c.altura)});
  for (const scene::Plane& c : of.shapes<scene::Plane>())
    add(made, scene::Plane{by.point(c.centro), by.axis(c.vector)});
  for (const scene::Disc& c : of.shapes<scene::Disc>())
    add(made, scene::Disc{by.point(c.centro), by.length(c.radio), by.axis(c.vector)});
  for (const auto& [vertices] : of.shapes<scene::Triangle>())
    add(made, scene::Triangle{{by.point(vertices[0]), by.point(vertices[1]), by.point(vertices[2])}});
  for (const scene::TruncatedCone& c : of.shapes<scene::TruncatedCone>())
    add(made, scene::TruncatedCone{by.point(c.centro), by.length(c.radio), c.proporcion, by.axis(c.vector),
                                   by.length(c.altura)});
  return made;
}

inline scene::Hit changed(scene::Hit hit, const Change& by) {
  if (hit.resultado != model::Resultado::hit) return hit;
  hit.t = by.parameter(hit.t);
  hit.punto = by.point(hit.punto);
  return hit;
}

/// Multiplies the whole scene by 2^k; t stays what it is.
inline Change scaled_whole(Scaling& scaling, int k) {
  const auto point = [&scaling, k](const glm::dvec3& p) { return scaling(p, k); };
  return {[&scaling, k](double x) { return scaling(x, k); }, point, unchanged, point, same};
}

}  // namespace durero::test
