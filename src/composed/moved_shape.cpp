#include "durero/composed/moved_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "durero/surface/surfaces.hpp"
#include "durero/trace/ray.hpp"

namespace durero::composed {
namespace {

using model::ExactVector;
using surface::exact::Parameter;
using surface::exact::Reach;

using SeenPoint = surface::Point<LinearForm>;

ExactVector cross(const ExactVector& a, const ExactVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// normal·(w − centro)/uno, as a form in w.
LinearForm coordinate(const ExactVector& normal, const ExactVector& centro, const Rational& uno) {
  return {normal.x / uno, normal.y / uno, normal.z / uno,
          -(normal.x * centro.x + normal.y * centro.y + normal.z * centro.z) / uno};
}

/// The point that is put at w, as forms in w (visto.def.1).
SeenPoint seen(const model::Mapa& m) {
  const Rational uno = model::mixto(m.x, m.y, m.z);
  return {coordinate(cross(m.y, m.z), m.centro, uno), coordinate(cross(m.z, m.x), m.centro, uno),
          coordinate(cross(m.x, m.y), m.centro, uno)};
}

Rational exact_dot(const surface::Point<Rational>& a, const surface::Point<Rational>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

LinearForm form_dot(const SeenPoint& a, const surface::Point<Rational>& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The bounds of a shape, none of them negative within (recorte.def.1, tramo.def.1).
template <class Shape>
std::vector<QuadraticForm> bounds_of(const Shape& shape, const SeenPoint& w) {
  if constexpr (surface::Axial<Shape>) {
    const LinearForm s = surface::avance(shape, w);
    return {s, Rational(shape.altura) - s};
  } else {
    return {};
  }
}

std::vector<QuadraticForm> bounds_of(const scene::Disc& disc, const SeenPoint& w) {
  const QuadraticForm beyond =
      surface::squared_length(surface::from(disc.centro, w)) - Rational(disc.radio) * Rational(disc.radio);
  return {beyond * Rational(-1)};
}

/// The lados, as those of a line in the plane of surface/exact_element.cpp.
std::vector<QuadraticForm> bounds_of(const scene::Triangle& triangle, const SeenPoint& w) {
  const auto& [a, b, c] = triangle.vertices;
  const auto e1 = surface::between<Rational>(a, b), e2 = surface::between<Rational>(a, c);
  const SeenPoint q = surface::from(a, w);
  const Rational e11 = exact_dot(e1, e1), e12 = exact_dot(e1, e2), e22 = exact_dot(e2, e2);
  const LinearForm w1 = form_dot(q, e1), w2 = form_dot(q, e2);
  const LinearForm ab = w2 * e11 - w1 * e12, ca = w1 * e22 - w2 * e12;
  return {ab, e11 * e22 - e12 * e12 - (ab + ca), ca};
}

std::vector<SpaceForm<Dyadic>> whole_bounds(const scene::Instance& of) {
  std::vector<SpaceForm<Dyadic>> bounds;
  const auto take = [&](const auto& shape) {
    for (const QuadraticForm& bound : bounds_of(shape, seen(of.mapa))) bounds.push_back(whole(bound));
  };
  std::visit(take, of.shape);
  return bounds;
}

SpaceForm<Dyadic> whole_power(const scene::Instance& of) {
  return std::visit([&](const auto& shape) { return whole(QuadraticForm(potencia(shape, seen(of.mapa)))); }, of.shape);
}

surface::Dual<double> rounded(const LinearForm& form) {
  const auto to = [](const Rational& value) { return number::round_to_binary64(value); };
  return {to(form.one), to(form.x), to(form.y), to(form.z)};
}

std::array<surface::Dual<double>, 3> rounded_seen(const scene::Instance& of) {
  const SeenPoint u = seen(of.mapa);
  return {rounded(u.x), rounded(u.y), rounded(u.z)};
}

/// Whether no root of A·t² + 2B·t + C is positive, where the signs tell.
bool no_positive_root(const surface::Quadratic<RealBall>& f, bool on) {
  const int A = sign(f.A), B = sign(f.B), C = on ? 0 : sign(f.C);
  if (on) return A != 0 && A == B;  // the roots are 0 and −2B/A
  if (A != 0 && A == B && B == C) return true;
  return sign(f.B * f.B - f.A * f.C) < 0;
}

/// Of a flat shape, whose A is exactly 0.
bool no_positive_crossing(const surface::Quadratic<RealBall>& f, bool on) {
  const int B = sign(f.B);
  return B != 0 && (on || B == sign(f.C));
}

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double greatest_plane = 0x1p1000;

surface::Box everything() { return {glm::dvec3(-infinite), glm::dvec3(infinite)}; }

/// The least box with binary64 planes around some points and a little more.
surface::Box around(const std::array<model::ExactPoint, 8>& corners) {
  surface::Box box{glm::dvec3(infinite), glm::dvec3(-infinite)};
  for (const model::ExactPoint& corner : corners) {
    const std::array<double, 3> w{round_to_binary64(corner.x), round_to_binary64(corner.y),
                                  round_to_binary64(corner.z)};
    for (int i = 0; i < 3; ++i) {
      if (!(std::abs(w[i]) <= greatest_plane)) return everything();
      box.low[i] = std::min(box.low[i], std::nextafter(w[i], -infinite));
      box.high[i] = std::max(box.high[i], std::nextafter(w[i], infinite));
    }
  }
  return box;
}

}  // namespace

MovedShape::MovedShape(const scene::Instance& instance)
    : of_(instance),
      power_(whole_power(instance)),
      rough_power_(roughly(power_)),
      bounds_(whole_bounds(instance)),
      seen_(rounded_seen(instance)) {}

Reach MovedShape::reach(const model::Rayo& rayo, bool on) const {
  auto [A, B, C] = power_.along(rayo);
  surface::exact::Coefficients f{std::move(A), std::move(B), on ? Dyadic() : std::move(C)};
  for (const SpaceForm<Dyadic>& bound : bounds_) f.bounds.push_back(bound.along(rayo));
  const surface::exact::Roots roots = surface::exact::roots(f);
  if (roots.every) return surface::exact::reach(f);  // the ray lies in the surface, and the bounds decide
  Reach result;
  for (const Parameter& t : roots.values()) {
    const bool within =
        number::sign(t) > 0 && std::ranges::all_of(f.bounds, [&](const auto& bound) { return sign_at(bound, t) >= 0; });
    if (within) result.t[result.count++] = t;
  }
  return result;
}

bool MovedShape::may_meet(const model::Rayo& rayo, bool on) const {
  const auto f = rough_power_.along(rayo);
  const bool is_flat = std::visit([]<class Shape>(const Shape&) { return surface::Flat<Shape>; }, of_.shape);
  return !(is_flat ? no_positive_crossing(f, on) : no_positive_root(f, on));
}

// A map keeps what lies between two points between where it puts them: so the corners' box holds what their box held.
surface::Box MovedShape::box() const {
  return std::visit(
      [&](const auto& shape) {
        if (!trace::ordinary(shape)) return everything();
        const surface::Box own = surface::box(shape);
        if (!std::isfinite(own.low.x) || !std::isfinite(own.high.x)) return everything();
        const auto corner = [&](unsigned i) {
          return model::puesto(
              of_.mapa, model::Punto((i & 1U) != 0 ? own.high.x : own.low.x, (i & 2U) != 0 ? own.high.y : own.low.y,
                                     (i & 4U) != 0 ? own.high.z : own.low.z));
        };
        return around({corner(0), corner(1), corner(2), corner(3), corner(4), corner(5), corner(6), corner(7)});
      },
      of_.shape);
}

glm::dvec3 MovedShape::gradient(const glm::dvec3& w) const {
  using D = surface::Dual<double>;
  const auto at = [&](const D& u) { return D{u.value + u.dx * w.x + u.dy * w.y + u.dz * w.z, u.dx, u.dy, u.dz}; };
  const surface::Point<D> u{at(seen_[0]), at(seen_[1]), at(seen_[2])};
  return std::visit(
      [&]<class Shape>(const Shape& shape) {
        const D power = potencia(shape, u);
        const glm::dvec3 gradient(power.dx, power.dy, power.dz);
        if constexpr (surface::Axial<Shape>) {
          if (gradient != glm::dvec3(0)) return gradient;
          const D advance = surface::avance(shape, u);
          return glm::dvec3(advance.dx, advance.dy, advance.dz);
        } else {
          return gradient;
        }
      },
      of_.shape);
}

}  // namespace durero::composed
