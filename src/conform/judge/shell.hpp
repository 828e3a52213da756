#pragma once
/// A shell is the space in which an element lies, whatever data within the allowance it has. Its walls are the surface
/// moved out and moved in: `outer` is not positive inside the surface moved out, `inner` is not negative outside the
/// surface moved in, and each of `bounds` is not negative between the ends of the element. Over Dyadic these are
/// numbers, for a point; over Linear<Dyadic> they are quadratics, along a ray.
///
/// A shell with its ends moved *outwards* holds every point that is the answer of some data within the allowance. A ray
/// that goes from one wall to the other between ends moved *inwards* meets the element for all such data. The distances
/// of walls and ends are derived beside each shape; u, δ and the ray's share are those of allowance.hpp.

#include <array>
#include <optional>
#include <vector>

#include "conform/ask/asked_elements.hpp"
#include "durero/number/dyadic_surd.hpp"
#include "durero/number/quotient.hpp"
#include "durero/surface/surfaces.hpp"

namespace durero::conform {

using surface::Linear;
using surface::Point;

/// The direction in which the ends of an element are moved.
enum class EndShift { outwards, inwards };

/// The type of a wall or an end: a number for a point, a quadratic for a ray.
template <class T>
struct BoundOf {
  using type = T;
};
template <>
struct BoundOf<Linear<Dyadic>> {
  using type = surface::Quadratic<Dyadic>;
};

inline const Dyadic& bound(const Dyadic& value) { return value; }
inline surface::Quadratic<Dyadic> bound(const Linear<Dyadic>& value) {
  return {0, number::shifted(value.slope, -1), value.at_zero};
}
inline surface::Quadratic<Dyadic> bound(surface::Quadratic<Dyadic> value) { return value; }
inline Dyadic negated(const Dyadic& a) { return -a; }
inline surface::Quadratic<Dyadic> negated(const surface::Quadratic<Dyadic>& a) { return {-a.A, -a.B, -a.C}; }

template <class T>
struct Shell {
  using Bound = typename BoundOf<T>::type;
  Bound outer{}, inner{};
  std::vector<Bound> bounds{};
  /// True where the surface moved in has vanished: the shell is then all that lies within `outer`. Along a ray `hollow`
  /// tells it of an element with an axis.
  bool filled = false;
  /// A quadratic that is positive where the element is so wide that its walls are far apart; only the shell of an
  /// element with an axis along a ray has it.
  std::optional<Bound> hollow{};
};

/// Whether the point that the shell was computed for lies inside the element or on it, for some data; may_hold() asks
/// for a point on it.
inline bool may_hold_inside(const Shell<Dyadic>& shell) {
  return number::sign(shell.outer) <= 0 && std::all_of(shell.bounds.begin(), shell.bounds.end(),
                                                       [](const Dyadic& bound) { return number::sign(bound) >= 0; });
}
inline bool may_hold(const Shell<Dyadic>& shell) {
  return may_hold_inside(shell) && (shell.filled || number::sign(shell.inner) >= 0);
}

/// The sign of A·t² + 2B·t + C. With t = (x + y√Δ)/w it is the sign of the same times w².
inline int sign_at(const surface::Quadratic<Dyadic>& f, const number::DyadicSurd& t) {
  if (number::sign(f.A) == 0) return number::sign(number::linear(f.C, number::shifted(f.B, 1), t));
  const auto& [x, y, radicand, w] = t;
  const Dyadic rational = f.A * (number::square(x) + number::square(y) * radicand) + number::shifted(f.B * x, 1) * w +
                          f.C * number::square(w);
  return number::sign(number::DyadicSurd{rational, number::shifted((f.A * x + f.B * w) * y, 1), radicand});
}

inline Dyadic moved(const Dyadic& by, EndShift ends) { return ends == EndShift::outwards ? by : -by; }

/// The walls of a sphere lie 7δ from it: the distance from the centre is off by the ray's share, and the radius by δ,
/// together 6.42·δ.
template <class T>
Shell<T> shell(const scene::Sphere& e, const Point<T>& w, const Allowance& allowed, EndShift) {
  const Dyadic eta = allowed.times(7), r(e.radio);
  const auto squared = squared_length(from(e.centro, w));
  return {squared - square(r + eta), squared - square(r - eta), {}, number::sign(r - eta) <= 0};
}

/// The walls and ends of a shape with an axis. With q = w − centro, s = q·d, k the proportion (0 of a cylinder),
/// g = u·k, R(s) = radio + k·(altura − s): |q| ≤ √(altura² + R²) < 1.51·M·(1 + g) for the points of the moved element,
/// and for the points of the shell between the ends and where R ≥ 8η. There d, off by √3·u, moves s by at most
/// 2.62·(1 + g)·δ. With the ray's share s is off by 8.1·δ + 2.62·g·δ, and altura by δ: the ends by (10 + 3g)·δ. The
/// distance from the axis, |q − s·d|, is off by the ray's share and, since d is off in both places, by
/// 2·2.62·(1 + g)·δ: 10.7·δ + 5.3·g·δ. R(s) is off by δ for radio, δ for k (and g·δ where altura is off as well), k·δ
/// for altura and k times the error of s. Together the walls are off by (13 + 7g + k·(10 + 3g))·δ.
template <class T, surface::Axial Shape>
Shell<T> shell(const Shape& e, const Point<T>& w, const Allowance& allowed, EndShift ends) {
  const Dyadic k(proportion(e)), g = allowed.u * k, altura(e.altura);
  const Dyadic along = Dyadic(10) + Dyadic(3) * g;
  const Dyadic eta = allowed.times(Dyadic(13) + Dyadic(7) * g + k * along), end = moved(allowed.times(along), ends);
  const auto squared = alejamiento(e, w);
  const T s = avance(e, w);
  const Dyadic base = radius_at_centre(e);
  const T out = (base + eta) - s * k, in = (base - eta) - s * k;  // R(s) ± η
  Shell<T> result{squared - square(out), squared - square(in), {bound(s - (-end)), bound((altura + end) - s)}};
  if constexpr (std::is_same_v<T, Dyadic>)
    result.filled = number::sign(in) <= 0;
  else
    result.hollow = bound((base - Dyadic(8) * eta) - s * k);
  return result;
}

/// The distance of a plane's walls from it, in δ.
inline const Dyadic plane_wall(15);

/// The walls of a plane: q·d is off by the ray's share, and by |q|·√3·u for d. |q| ≤ |p| + |t·v| + |centro| ≤ 3√3·M
/// gives 9·δ; together 14.5·δ.
template <class T>
Shell<T> shell(const scene::Plane& e, const Point<T>& w, const Allowance& allowed, EndShift) {
  const Dyadic eta = allowed.times(plane_wall);
  const T value = potencia(e, w);
  return {bound(value - eta), bound(value - (-eta))};
}

/// The shell of a disc with walls at the distance eta from its plane and the radius `rim` of its moved rim.
template <class T>
Shell<T> shell_of_disc(const scene::Disc& e, const Point<T>& w, const Dyadic& eta, const Dyadic& rim) {
  const T value = potencia(e, w);
  Shell<T> result{bound(value - eta), bound(value - (-eta))};
  // A radius moved in below 0 leaves no point between the ends.
  const Dyadic reach = number::sign(rim) < 0 ? Dyadic(-1) : square(rim);
  result.bounds.push_back(negated(squared_length(from(e.centro, w)) - reach));
  return result;
}

/// The walls of a disc follow from those of a plane, but |q| ≤ M up to a small part: 5.42·δ + 1.74·δ. In the plane |q|
/// is off by the ray's share and the radius by δ: 6.42·δ.
template <class T>
Shell<T> shell(const scene::Disc& e, const Point<T>& w, const Allowance& allowed, EndShift ends) {
  return shell_of_disc(e, w, allowed.times(8), Dyadic(e.radio) + moved(allowed.times(7), ends));
}

/// A disc that closes a solid moves besides with the errors of its wall. The far end, centro + altura·d, is off by δ
/// along the axis for altura and by altura·√3·u ≤ 1.74·δ in any direction for d: from the plane of a disc
/// 5.42·δ + 1.74·δ + 2.74·δ = 9.9·δ, and across 5.42·δ + 1.74·δ; its radius by δ. At the base the centre is the wall's,
/// and the radius, radio + k·altura, is off by δ for radio, k·δ for altura, and for k, which is off by u·max(1, k), by
/// altura·u·max(1, k) ≤ δ (and g·δ where altura is off as well, g = u·k): 5.42·δ + (2 + k + g)·δ. The disc's own
/// numbers were rounded where the solid ends, by δ/16 each, and |vector|² = 1 ± 2⁻⁵⁰ puts it half a δ away at most:
/// 0.61·δ more.
template <class T>
Shell<T> shell(const DiscOfSolid& e, const Point<T>& w, const Allowance& allowed, EndShift ends) {
  const Dyadic k(e.proporcion), across = Dyadic(9) + k + allowed.u * k;
  return shell_of_disc(e.disc, w, allowed.times(11), Dyadic(e.disc.radio) + moved(allowed.times(across), ends));
}

inline Point<Dyadic> cross(const Point<Dyadic>& a, const Point<Dyadic>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// An upper bound of |a|, larger by less than 2⁻³⁰ of it: a wall or an end that is further off is one as well.
inline Dyadic length_above(const Point<Dyadic>& a) {
  const Dyadic squared = squared_length(a);
  if (number::sign(squared) == 0) return {};
  const number::SquareRoot root = number::square_root(squared, 32);
  return root.exact ? root.value : root.value + root.unit;
}

template <class T>
T dot(const Point<T>& a, const Point<Dyadic>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The vertices of a triangle, and so all its points, are off by √3·δ: with the ray 5.42·δ. *Outwards*: a point of the
/// moved triangle is within 6δ of a point of this one, hence of its plane, of the inner side of each edge, and of its
/// box. *Inwards*: a stretch from 6δ on one side of the plane to 6δ on the other, at least 6δ inside each edge, meets
/// every such triangle. While the vertices move to their places in straight lines, the edge never meets the stretch nor
/// the triangle its two ends, and the number of crossings stays odd.
template <class T>
Shell<T> shell(const scene::Triangle& e, const Point<T>& w, const Allowance& allowed, EndShift ends) {
  const Dyadic eta = allowed.times(6), end = moved(eta, ends);
  const auto& [a, b, c] = e.vertices;
  const Point<Dyadic> normal = cross(surface::between<Dyadic>(a, b), surface::between<Dyadic>(a, c));
  const Dyadic wall = eta * length_above(normal);
  const T value = dot(from(a, w), normal);
  Shell<T> result{bound(value - wall), bound(value - (-wall))};
  for (const auto& [begin, finish] : std::array{std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
    const Point<Dyadic> inwards = cross(normal, surface::between<Dyadic>(begin, finish));
    result.bounds.push_back(bound(dot(from(begin, w), inwards) - (-(end * length_above(inwards)))));
  }
  if (ends == EndShift::inwards) return result;
  const surface::Box box = surface::box(e);
  const auto beside = [&](const T& x, double low, double high) {
    result.bounds.push_back(bound(x - (Dyadic(low) - end)));
    result.bounds.push_back(bound((Dyadic(high) + end) - x));
  };
  beside(w.x, box.low.x, box.high.x);
  beside(w.y, box.low.y, box.high.y);
  beside(w.z, box.low.z, box.high.z);
  return result;
}

}  // namespace durero::conform
