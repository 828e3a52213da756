#include "durero/distance/exact.hpp"

#include "turned.hpp"

namespace durero::distance::exact {
namespace {

Value number(const Dyadic& x, const Dyadic& w) { return DyadicSurd{.x = x, .w = w}; }

Nearest of(const scene::Sphere& sphere, const glm::dvec3& p) {
  const Triple centro = triple(sphere.centro), q = difference(triple(p), centro);
  const Dyadic P = dot(q, q), r = sphere.radio;
  if (sign(P) == 0)
    return {number(square(r), 1), {number(centro[0] - r, 1), number(centro[1], 1), number(centro[2], 1)}, true};
  Nearest found{.squared = DyadicSurd{P + square(r), shifted(-r, 1), P, 1}, .point = {}};
  for (std::size_t i = 0; i < 3; ++i) found.point[i] = DyadicSurd{centro[i] * P, r * q[i], P, P};
  return found;
}

/// The foot of a point p on the plane through a point with a normal n, s the product of n and the way from there to p.
Nearest of_plane(const Triple& p, const Triple& n, const Dyadic& s) {
  const Dyadic nn = dot(n, n);
  Nearest found{.squared = number(square(s), nn), .point = {}};
  for (std::size_t i = 0; i < 3; ++i) found.point[i] = number(p[i] * nn - s * n[i], nn);
  return found;
}

Nearest of(const scene::Plane& plane, const glm::dvec3& p) {
  const Triple n = triple(plane.vector), at = triple(p);
  return of_plane(at, n, dot(difference(at, triple(plane.centro)), n));
}

Nearest of(const scene::Disc& disc, const glm::dvec3& p) {
  const AxialPoint seen(disc.centro, disc.vector, p);
  const Dyadic H = seen.dd * square(Dyadic(disc.radio));
  return seen.squared_out <= H ? of_plane(triple(p), seen.d, seen.s) : of_ring(seen, {}, H);
}

Nearest of(const scene::Cylinder& e, const glm::dvec3& p) {
  return of_profile(AxialPoint(e.centro, e.vector, p), {e.radio, {}, e.altura});
}

Nearest of(const scene::Cone& e, const glm::dvec3& p) {
  return of_profile(AxialPoint(e.centro, e.vector, p), {Dyadic(e.proporcion) * e.altura, e.proporcion, e.altura});
}

Nearest of(const scene::TruncatedCone& e, const glm::dvec3& p) {
  return of_profile(AxialPoint(e.centro, e.vector, p),
                    {Dyadic(e.radio) + Dyadic(e.proporcion) * e.altura, e.proporcion, e.altura});
}

Nearest of_edge(const Triple& a, const Triple& b, const Triple& p) {
  const Triple e = difference(b, a), q = difference(p, a);
  const Dyadic ee = dot(e, e), t = dot(q, e);
  const auto whole = [](const Triple& w, const Triple& to) {
    const Triple way = difference(to, w);
    return Nearest{number(dot(way, way), 1), {number(w[0], 1), number(w[1], 1), number(w[2], 1)}};
  };
  if (sign(t) <= 0) return whole(a, p);
  if (t >= ee) return whole(b, p);
  Nearest found{.squared = number(dot(q, q) * ee - square(t), ee), .point = {}};
  for (std::size_t i = 0; i < 3; ++i) found.point[i] = number(a[i] * ee + t * e[i], ee);
  return found;
}

Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Over the inside of the triangle the foot on its plane, else the nearest point of an edge.
Nearest of(const scene::Triangle& triangle, const glm::dvec3& at) {
  const Triple a = triple(triangle.vertices[0]), b = triple(triangle.vertices[1]), c = triple(triangle.vertices[2]);
  const Triple p = triple(at), n = cross(difference(b, a), difference(c, a));
  const auto is_inside = [&](const Triple& from, const Triple& to) {  // lado.def.1, by the sign
    return sign(dot(cross(difference(to, from), difference(p, from)), n)) >= 0;
  };
  if (is_inside(a, b) && is_inside(b, c) && is_inside(c, a)) return of_plane(p, n, dot(difference(p, a), n));
  Nearest found = of_edge(a, b, p);
  take(found, of_edge(b, c, p));
  take(found, of_edge(c, a, p));
  return found;
}

}  // namespace

Nearest nearest(scene::ShapeView shape, const glm::dvec3& p) {
  return shape.visit([&](const auto& of_type) { return of(of_type, p); });
}

std::strong_ordering order(const std::array<Value, 3>& a, const std::array<Value, 3>& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (const auto by = algebra::compare(a[i], b[i]); by != 0) return by;
  return std::strong_ordering::equal;
}

void take(Nearest& found, Nearest other) {
  const auto by = algebra::compare(other.squared, found.squared);
  if (by > 0) return;
  if (by < 0) {
    found = std::move(other);
    return;
  }
  const auto place = order(other.point, found.point);
  const bool many = found.many || other.many || place != 0;
  if (place < 0) found = std::move(other);
  found.many = many;
}

}  // namespace durero::distance::exact
