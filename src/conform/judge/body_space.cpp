#include "conform/judge/body_space.hpp"

#include <array>
#include <cmath>

#include "conform/judge/torus.hpp"
#include "durero/contract/contract.hpp"
#include "durero/number/quotient.hpp"

namespace durero::conform {
namespace {

using surface::exact::order;
using surface::exact::Parameter;

Point<Dyadic> dyadic(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

/// Conditions f ≤ 0 that hold all together in a part of a body; the body is what is in any part.
template <class T>
using Conditions = std::vector<typename BoundOf<T>::type>;
template <class T>
using SpaceParts = std::vector<Conditions<T>>;

/// The normals of the sides that two of x, y and z span, each along the third, and the volume that the three span: a
/// point centro + a·x + b·y + c·z has the products a·D, b·D and c·D with them.
struct DualSides {
  std::array<Point<Dyadic>, 3> normals;
  Dyadic D;

  explicit DualSides(const AskedBody& body) {
    const auto& [x, y, z] = body.sides;
    normals = {cross(dyadic(y), dyadic(z)), cross(dyadic(z), dyadic(x)), cross(dyadic(x), dyadic(y))};
    D = absolute(dot(dyadic(x), normals[0]));
  }
};

/// The middles of the four edges of a box along a side, from its middle.
std::array<Point<Dyadic>, 4> edges_along(const AskedBody& body, std::size_t side) {
  const Point<Dyadic> y = dyadic(body.sides[(side + 1) % 3]), z = dyadic(body.sides[(side + 2) % 3]);
  const auto at = [&](const Dyadic& a, const Dyadic& b) {
    return Point<Dyadic>{a * y.x + b * z.x, a * y.y + b * z.y, a * y.z + b * z.z};
  };
  return {at(-1, -1), at(-1, 1), at(1, -1), at(1, 1)};
}

/// A box between planes: |q·n| ≤ D is moved out by η·|n|.
template <class T>
SpaceParts<T> box_space(const AskedBody& body, const Point<T>& w, const Dyadic& eta) {
  const DualSides dual(body);
  const Point<T> q = from(body.centro, w);
  Conditions<T> all;
  for (const Point<Dyadic>& normal : dual.normals) {
    const Dyadic far = dual.D + eta * length_above(normal);
    const T along = dot(q, normal);
    all.push_back(bound(along - far));
    all.push_back(negated(bound(along - (-far))));
  }
  return {all};
}

/// An ellipsoid, Σ(q·n)² ≤ D². The ball of radius r = D/√Σ|n|² lies in it, for |n|/D are the lengths of the rows of the
/// map that makes it a ball of radius 1. So moved out by η it lies in (1 + η/r) times it, and (1 − η/r) times it lies
/// in it moved in: D ± η·√Σ|n|² in the place of D.
template <class T>
SpaceParts<T> ellipsoid_space(const AskedBody& body, const Point<T>& w, const Dyadic& eta) {
  const DualSides dual(body);
  const auto& [a, b, c] = dual.normals;
  const Point<T> q = from(body.centro, w);
  const Dyadic rows = length_above({length_above(a), length_above(b), length_above(c)});
  const Dyadic far = dual.D + eta * rows;
  if (number::sign(far) < 0) return {};
  return {{square(dot(q, a)) + square(dot(q, b)) + square(dot(q, c)) - square(far)}};
}

/// A capsule: between the planes across its axis what is near the axis, and what is near either end of it.
template <class T>
SpaceParts<T> capsule_space(const AskedBody& body, const Point<T>& w, const Dyadic& eta) {
  const Point<Dyadic> y = dyadic(body.sides[1]);
  const Dyadic reach = Dyadic(length_of(body.sides[0])) + eta, yy = squared_length(y);
  if (number::sign(reach) < 0) return {};
  const Point<T> q = from(body.centro, w);
  const T along = dot(q, y);
  const auto near = [&](const Point<Dyadic>& end) {
    return squared_length(Point<T>{q.x - end.x, q.y - end.y, q.z - end.z}) - square(reach);
  };
  const auto beside = squared_length(q) * yy - square(along) - square(reach) * yy;
  return {{beside, bound(along - yy), negated(bound(along - (-yy)))}, {near(y)}, {near({-y.x, -y.y, -y.z})}};
}

/// Bounds of |a| from both sides, apart by less than 2⁻¹¹⁸ of it, which is nothing beside η.
struct LengthBounds {
  Dyadic below, above;
};
LengthBounds length_bounds(const Point<Dyadic>& a) {
  const number::SquareRoot root = number::square_root(squared_length(a), 120);
  return {root.value, root.exact ? root.value : root.value + root.unit};
}

/// A rounded box, with R = radio + η: a box that is longer by R along each side in turn, what is near an edge, and what
/// is near a corner. The sides stand at right angles, so that each normal is along its side and no part is missing.
/// A rounded box that moves inwards by more than its radius is a box that moves in by the rest.
template <class T>
SpaceParts<T> rounded_box_space(const AskedBody& body, const Point<T>& w, const Dyadic& eta) {
  const Dyadic reach = Dyadic(body.radio) + eta;
  if (number::sign(reach) < 0) return box_space(body, w, reach);
  const DualSides dual(body);
  const Point<T> q = from(body.centro, w);
  SpaceParts<T> all;
  const auto between = [](Conditions<T>& conditions, const T& along, const Dyadic& far) {
    conditions.push_back(bound(along - far));
    conditions.push_back(negated(bound(along - (-far))));
  };
  const auto near = [&](const Point<Dyadic>& a) { return Point<T>{q.x - a.x, q.y - a.y, q.z - a.z}; };
  for (std::size_t i = 0; i < 3; ++i) {
    const Point<Dyadic> along = dyadic(body.sides[i]);
    const Dyadic squared = squared_length(along);
    Conditions<T> longer;
    for (std::size_t j = 0; j < 3; ++j) {
      const LengthBounds length = length_bounds(dual.normals[j]);
      const Dyadic more = reach * (number::sign(eta) < 0 ? length.below : length.above);
      between(longer, dot(q, dual.normals[j]), j == i ? dual.D + more : dual.D);
    }
    all.push_back(std::move(longer));
    for (const Point<Dyadic>& edge : edges_along(body, i)) {
      const Point<T> beside = near(edge);
      Conditions<T> round{squared_length(beside) * squared - square(dot(beside, along)) - square(reach) * squared};
      between(round, dot(q, along), squared);
      all.push_back(std::move(round));
    }
  }
  for (const Point<Dyadic>& edge : edges_along(body, 0)) {
    const Point<Dyadic> x = dyadic(body.sides[0]);
    for (const Point<Dyadic>& corner : {Point<Dyadic>{edge.x - x.x, edge.y - x.y, edge.z - x.z},
                                        Point<Dyadic>{edge.x + x.x, edge.y + x.y, edge.z + x.z}})
      all.push_back({squared_length(near(corner)) - square(reach)});
  }
  return all;
}

template <class T>
SpaceParts<T> space(const AskedBody& body, const Point<T>& w, const Dyadic& eta) {
  switch (body.kind) {
    case BodyKind::caja:
    case BodyKind::copia_caja:
      return box_space(body, w, eta);
    case BodyKind::elipsoide:
    case BodyKind::copia_esfera:
      return ellipsoid_space(body, w, eta);
    case BodyKind::capsula:
      return capsule_space(body, w, eta);
    case BodyKind::caja_redonda:
      return rounded_box_space(body, w, eta);
    case BodyKind::toro:
    case BodyKind::campo:
      break;  // they are not convex
  }
  contract::unreachable();
}

/// The stretch of the ray in one part of a body, which is closed, convex and bounded: its ends are the first and the
/// last parameter at which a condition may begin or cease to hold, and all hold.
std::optional<BodyStretch> stretch_of_part(const Conditions<Linear<Dyadic>>& conditions) {
  std::vector<Parameter> changes;
  for (const auto& f : conditions) {
    const surface::exact::Roots roots = surface::exact::roots({f.A, f.B, f.C});
    if (roots.every) continue;
    const auto values = roots.values();
    changes.insert(changes.end(), values.begin(), values.end());
  }
  std::ranges::sort(changes, [](const Parameter& a, const Parameter& b) { return order(a, b) < 0; });
  const auto holds = [&](const Parameter& t) {
    return std::ranges::all_of(conditions, [&](const auto& f) { return sign_at(f, t) <= 0; });
  };
  const auto first = std::ranges::find_if(changes, holds);
  if (first == changes.end()) return std::nullopt;
  return BodyStretch{*first, *std::find_if(changes.rbegin(), changes.rend(), holds)};
}

double in_units(const Dyadic& a, const Dyadic& M) { return number::round_quotient(a, M); }

/// The first order of the distance from f = 0, |f|/|∇f|; where the gradient vanishes, the least half axis.
double distance_of_ellipsoid(const AskedBody& body, const Point<Dyadic>& w, const Dyadic& M) {
  const DualSides dual(body);
  const Point<Dyadic> q = from(body.centro, w);
  Point<Dyadic> half_gradient{0, 0, 0};
  Dyadic value = -square(dual.D);
  for (const Point<Dyadic>& n : dual.normals) {
    const Dyadic along = dot(q, n);
    value += square(along);
    half_gradient = {half_gradient.x + along * n.x, half_gradient.y + along * n.y, half_gradient.z + along * n.z};
  }
  const Dyadic steep = length_above(half_gradient);
  if (number::sign(steep) == 0) {
    const auto& [x, y, z] = body.sides;
    return in_units(Dyadic(std::min({length_of(x), length_of(y), length_of(z)})), M);
  }
  return number::round_quotient(absolute(value), number::shifted(steep, 1) * M);
}

double distance_of_box(const AskedBody& body, const Point<Dyadic>& w, const Dyadic& M) {
  const DualSides dual(body);
  const Point<Dyadic> q = from(body.centro, w);
  double most = -std::numeric_limits<double>::infinity();
  for (const Point<Dyadic>& n : dual.normals)
    most = std::max(most, number::round_quotient(absolute(dot(q, n)) - dual.D, length_above(n) * M));
  return std::abs(most);
}

/// | √a² − r | from the difference of the squares, for the part of the capsule that the point is beside.
double distance_of_capsule(const AskedBody& body, const Point<Dyadic>& w, const Dyadic& M) {
  const Point<Dyadic> q = from(body.centro, w), y = dyadic(body.sides[1]);
  const Dyadic along = dot(q, y), yy = squared_length(y), radio(length_of(body.sides[0]));
  Dyadic squared_yy = squared_length(q) * yy - square(along);  // the squared distance from the axis, times |y|²
  if (absolute(along) > yy) {
    const Dyadic side = number::sign(along) < 0 ? -1 : 1;
    squared_yy = squared_length(Point<Dyadic>{q.x - side * y.x, q.y - side * y.y, q.z - side * y.z}) * yy;
  }
  const double far = number::round_quotient(squared_yy - square(radio) * yy, yy * square(M));
  const double sum = std::sqrt(number::round_quotient(squared_yy, yy * square(M))) + in_units(radio, M);
  return std::abs(far) / sum;
}

/// A torus moved out and in; moved out so far that its hole closes it may hold any point.
BodyPlace place_in_torus(const AskedBody& body, const Point<Dyadic>& w, const Dyadic& eta) {
  const Torus torus(body);
  const Dyadic rho = torus.radio() + eta;
  if (number::sign(rho) <= 0) return BodyPlace::outside;
  if (!torus.is_tube(rho)) return BodyPlace::surface;
  const int side = number::sign(torus.at(w, rho));
  return side < 0 ? BodyPlace::inside : side == 0 ? BodyPlace::surface : BodyPlace::outside;
}

/// | √((h − R)² + along²) − r |, with the distance h from the line through the middle, and the way along it.
double distance_of_torus(const AskedBody& body, const Point<Dyadic>& w, const Dyadic& M) {
  const Point<Dyadic> q = from(body.centro, w), x = dyadic(body.sides[0]), n = cross(dyadic(body.sides[2]), x);
  const Dyadic nn = squared_length(n), along_n = dot(q, n), hh = squared_length(q) * nn - square(along_n);
  const double h = std::sqrt(number::round_quotient(hh, nn * square(M))), R = in_units(length_above(x), M);
  const double along = number::round_quotient(along_n, length_above(n) * M);
  return std::abs(std::hypot(h - R, along) - in_units(Dyadic(body.radio), M));
}

/// | √(Σ beyond²) − r | outside the box, with the ways beyond its sides; inside it the least way to a side, and r.
double distance_of_rounded_box(const AskedBody& body, const Point<Dyadic>& w, const Dyadic& M) {
  const Point<Dyadic> q = from(body.centro, w);
  glm::dvec3 beyond(0);
  for (int i = 0; i < 3; ++i) {
    const Point<Dyadic> side = dyadic(body.sides[static_cast<std::size_t>(i)]);
    beyond[i] = number::round_quotient(absolute(dot(q, side)) - squared_length(side), length_above(side) * M);
  }
  const double r = in_units(Dyadic(body.radio), M), most = std::max({beyond.x, beyond.y, beyond.z});
  if (most <= 0) return r - most;
  return std::abs(std::hypot(std::max(0.0, beyond.x), std::max(0.0, beyond.y), std::max(0.0, beyond.z)) - r);
}

}  // namespace

double largest_length(const AskedBody& body) {
  const auto& [x, y, z] = body.sides;
  return std::max({largest(body.centro), largest(x), largest(y), largest(z), body.radio});
}

Dyadic magnitude(const AskedBody& body, const model::Rayo& rayo, const Dyadic& way) {
  return std::max(Dyadic(std::max(largest_length(body), largest(rayo.p().xyz()))), way);
}

Dyadic eta_of(const AskedBody& body, const Allowance& allowed) {
  switch (body.kind) {
    case BodyKind::caja:
    case BodyKind::copia_caja:
      return allowed.times(18);
    case BodyKind::elipsoide:
    case BodyKind::copia_esfera:
    case BodyKind::toro:
      return allowed.times(13);
    case BodyKind::capsula:
      return allowed.times(14);
    case BodyKind::caja_redonda:
      return allowed.times(20);
    case BodyKind::campo:
      break;
  }
  contract::unreachable();
}

BodyPlace place_in(const AskedBody& body, const Point<Dyadic>& w, const Dyadic& eta) {
  if (body.kind == BodyKind::toro) return place_in_torus(body, w, eta);
  BodyPlace place = BodyPlace::outside;
  for (const Conditions<Dyadic>& conditions : space(body, w, eta)) {
    int most = -1;
    for (const Dyadic& f : conditions) most = std::max(most, number::sign(f));
    if (most < 0) return BodyPlace::inside;
    if (most == 0) place = BodyPlace::surface;
  }
  return place;
}

/// The body is convex, and so the stretches of its parts are one.
std::optional<BodyStretch> stretch_in(const AskedBody& body, const model::Rayo& rayo, const Dyadic& eta) {
  std::optional<BodyStretch> whole;
  for (const auto& conditions : space(body, surface::along<Dyadic>(rayo), eta)) {
    const std::optional<BodyStretch> part = stretch_of_part(conditions);
    if (!part) continue;
    if (!whole) whole = part;
    if (order(part->begin, whole->begin) < 0) whole->begin = part->begin;
    if (order(whole->end, part->end) < 0) whole->end = part->end;
  }
  return whole;
}

double distance_of_body(const AskedBody& body, const Point<Dyadic>& w, const Dyadic& M) {
  switch (body.kind) {
    case BodyKind::caja:
    case BodyKind::copia_caja:
      return distance_of_box(body, w, M);
    case BodyKind::elipsoide:
    case BodyKind::copia_esfera:
      return distance_of_ellipsoid(body, w, M);
    case BodyKind::capsula:
      return distance_of_capsule(body, w, M);
    case BodyKind::caja_redonda:
      return distance_of_rounded_box(body, w, M);
    case BodyKind::toro:
      return distance_of_torus(body, w, M);
    case BodyKind::campo:
      break;
  }
  contract::unreachable();
}

Dyadic squared_size_of_body(const AskedBody& body) {
  Dyadic most;
  for (const glm::dvec3& side : body.sides) most = std::max(most, squared_length(dyadic(side)));
  return std::max(most, square(Dyadic(body.radio)));
}

}  // namespace durero::conform
