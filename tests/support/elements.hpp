#pragma once
/// RapidCheck generators of elements and rays, over any generator of numbers.
#include <rapidcheck.h>

#include <array>
#include <cmath>

#include "durero/model/tipos.hpp"
#include "durero/scene/shapes.hpp"
#include "support/doubles.hpp"
#include "support/shapes.hpp"

namespace durero::test {

using Reals = rc::Gen<double>;

inline rc::Gen<glm::dvec3> vec(const Reals& x) {
  return rc::gen::map(rc::gen::tuple(x, x, x), [](const std::tuple<double, double, double>& v) {
    return glm::dvec3(std::get<0>(v), std::get<1>(v), std::get<2>(v));
  });
}

/// Strictly positive numbers: the magnitudes of x, without 0.
inline Reals positive(const Reals& x) {
  return rc::gen::suchThat(rc::gen::map(x, [](double a) { return std::abs(a); }), [](double a) { return a > 0; });
}

/// Axes that Unitario takes: the six unit ones, and directions of length 1 up to the tolerance. Only the six have
/// length 1 exactly: three squares with the sum 4ᵏ are 0, 0 and 4ᵏ.
inline rc::Gen<glm::dvec3> axis() {
  const auto normalised = rc::gen::map(vec(moderate()), [](glm::dvec3 v) {
    // Some scalings of a direction miss the tolerance by a rounding; a slightly different one then succeeds.
    for (double k = 1; v != glm::dvec3(0); k += 0x1p-53 * 3) {
      const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z) * k;
      const glm::dvec3 d = v / length;
      if (model::Unitario::contains(model::Vector(d))) return d;
    }
    return glm::dvec3(0, 0, 1);
  });
  const auto unit = rc::gen::element(glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1),
                                     glm::dvec3(-1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -1));
  return rc::gen::oneOf(normalised, unit);
}

inline rc::Gen<model::Rayo> rays(const Reals& x) {
  const auto v = rc::gen::suchThat(vec(x), [](const glm::dvec3& a) { return a != glm::dvec3(0); });
  return rc::gen::map(rc::gen::pair(vec(x), v), [](const std::pair<glm::dvec3, glm::dvec3>& r) {
    return model::Rayo(model::Punto(r.first), model::Vector(r.second));
  });
}

inline rc::Gen<scene::Sphere> spheres(const Reals& x) { return rc::gen::construct<scene::Sphere>(vec(x), positive(x)); }
inline rc::Gen<scene::Cylinder> cylinders(const Reals& x) {
  return rc::gen::construct<scene::Cylinder>(vec(x), positive(x), axis(), positive(x));
}
inline rc::Gen<scene::Cone> cones(const Reals& x) {
  return rc::gen::construct<scene::Cone>(vec(x), positive(x), axis(), positive(x));
}
inline rc::Gen<scene::TruncatedCone> truncated_cones(const Reals& x) {
  return rc::gen::construct<scene::TruncatedCone>(vec(x), positive(x), positive(x), axis(), positive(x));
}
inline rc::Gen<scene::Plane> planes(const Reals& x) { return rc::gen::construct<scene::Plane>(vec(x), axis()); }
inline rc::Gen<scene::Disc> discs(const Reals& x) {
  return rc::gen::construct<scene::Disc>(vec(x), positive(x), axis());
}
inline rc::Gen<scene::Triangle> triangles(const Reals& x) {
  const auto corners = rc::gen::map(rc::gen::tuple(vec(x), vec(x), vec(x)), [](const auto& v) {
    return scene::Triangle{{std::get<0>(v), std::get<1>(v), std::get<2>(v)}};
  });
  return rc::gen::suchThat(corners, [](const scene::Triangle& t) {
    const auto& [a, b, c] = t.vertices;
    return model::Vertices::contains({model::Punto(a), model::Punto(b), model::Punto(c)});
  });
}

/// visit(shape) for one of each.
template <class Visit>
void for_one_of_each(const Reals& x, Visit visit) {
  static_assert(scene::shape_count == 7, "another shape is one more below");
  visit(*spheres(x));
  visit(*cylinders(x));
  visit(*cones(x));
  visit(*planes(x));
  visit(*discs(x));
  visit(*triangles(x));
  visit(*truncated_cones(x));
}

/// A scene of so many of each.
inline scene::Scene some_of_each(const Reals& x, int count) {
  scene::Scene scene;
  for (int i = 0; i < count; ++i) for_one_of_each(x, [&](const auto& shape) { add(scene, shape); });
  return scene;
}

}  // namespace durero::test
