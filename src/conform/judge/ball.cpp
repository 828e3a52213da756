#include "conform/judge/ball.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "durero/algebra/value.hpp"

namespace durero::conform {
namespace {

using algebra::Polynomial;
using algebra::Root;
using surface::Quadratic;
using surface::exact::Parameter;

Point<Dyadic> exact_point(const glm::dvec3& a) { return {a.x, a.y, a.z}; }

/// Conditions that hold together where none of them is positive.
template <class T>
using BallPiece = std::vector<typename BoundOf<T>::type>;

/// The circle of a radius around the middle, across the axis d. W is what the middle times d·d is: dd·w − W leads from
/// the middle to w, times dd, so that no number is divided.
struct Ring {
  Point<Dyadic> middle_times_dd, d;
  Dyadic dd, radius;
};

/// The wall of a cone or a truncated cone.
struct ConeWall {
  Point<Dyadic> centro, d;
  Dyadic dd, k, base, altura;
};

/// The points within ρ of a shape.
template <class T>
struct BallSpace {
  std::vector<BallPiece<T>> pieces{};
  std::vector<Ring> rings{};
  std::optional<ConeWall> wall{};
};

template <class T>
auto squared_dot(const Point<T>& q, const Point<Dyadic>& d) {
  return square(dot(q, d));
}

template <class T>
BallSpace<T> space_of(const scene::Sphere& e, const Point<T>& w, const Dyadic& rho) {
  const Dyadic r(e.radio);
  const auto squared = squared_length(from(e.centro, w));
  BallPiece<T> piece{squared - square(r + rho)};
  if (r > rho) piece.push_back(negated(squared - square(r - rho)));
  return {.pieces = {piece}};
}

template <class T>
BallSpace<T> space_of(const scene::Plane& e, const Point<T>& w, const Dyadic& rho) {
  const Point<Dyadic> d = exact_point(e.vector);
  const BallPiece<T> slab{squared_dot(from(e.centro, w), d) - square(rho) * squared_length(d)};
  return {.pieces = {slab}};
}

/// The cylinder around an edge of a triangle, between the planes across its ends.
template <class T>
BallPiece<T> around_edge(const glm::dvec3& begin, const glm::dvec3& end, const Point<T>& w, const Dyadic& rho) {
  const Point<Dyadic> way = surface::between<Dyadic>(begin, end);
  const Dyadic squared = squared_length(way);
  const Point<T> q = from(begin, w);
  const T along = dot(q, way);
  return {squared_length(q) * squared - square(along) - square(rho) * squared, negated(bound(along)),
          bound(along - squared)};
}

template <class T>
BallSpace<T> space_of(const scene::Triangle& e, const Point<T>& w, const Dyadic& rho) {
  const auto& [a, b, c] = e.vertices;
  const Point<Dyadic> n = cross(surface::between<Dyadic>(a, b), surface::between<Dyadic>(a, c));
  BallSpace<T> space;
  BallPiece<T> prism{squared_dot(from(a, w), n) - square(rho) * squared_length(n)};
  for (const auto& [begin, end] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
    prism.push_back(negated(bound(dot(from(begin, w), cross(n, surface::between<Dyadic>(begin, end))))));
    space.pieces.push_back(around_edge(begin, end, w, rho));
    space.pieces.push_back({squared_length(from(begin, w)) - square(rho)});
  }
  space.pieces.push_back(std::move(prism));
  return space;
}

/// The rim of a shape with the axis d, in the plane s = advance.
Ring rim_of(const glm::dvec3& centro, const glm::dvec3& axis, const Dyadic& advance, const Dyadic& radius) {
  const Point<Dyadic> c = exact_point(centro), d = exact_point(axis);
  const Dyadic dd = squared_length(d);
  return {{dd * c.x + advance * d.x, dd * c.y + advance * d.y, dd * c.z + advance * d.z}, d, dd, radius};
}

/// The square of the way from the line along d, times d·d.
template <class T>
auto squared_across(const Point<T>& q, const Point<Dyadic>& d) {
  return squared_length(q) * squared_length(d) - squared_dot(q, d);
}

template <class T>
BallSpace<T> space_of(const scene::Disc& e, const Point<T>& w, const Dyadic& rho) {
  const Point<Dyadic> d = exact_point(e.vector);
  const Dyadic dd = squared_length(d), r(e.radio);
  const Point<T> q = from(e.centro, w);
  const BallPiece<T> face{squared_dot(q, d) - square(rho) * dd, squared_across(q, d) - square(r) * dd};
  return {.pieces = {face}, .rings = {rim_of(e.centro, e.vector, {}, r)}};
}
template <class T>
BallSpace<T> space_of(const DiscOfSolid& e, const Point<T>& w, const Dyadic& rho) {
  return space_of(e.disc, w, rho);
}

template <class T>
BallSpace<T> space_of(const scene::Cylinder& e, const Point<T>& w, const Dyadic& rho) {
  const Point<Dyadic> d = exact_point(e.vector);
  const Dyadic dd = squared_length(d), r(e.radio), altura(e.altura);
  const Point<T> q = from(e.centro, w);
  const T s = dot(q, d);
  const auto across = squared_across(q, d);
  BallPiece<T> wall{across - square(r + rho) * dd, negated(bound(s)), bound(s - altura)};
  if (r > rho) wall.push_back(negated(across - square(r - rho) * dd));
  return {.pieces = {wall}, .rings = {rim_of(e.centro, e.vector, {}, r), rim_of(e.centro, e.vector, altura, r)}};
}

/// A cone and a truncated cone.
template <class T, surface::Axial Shape>
BallSpace<T> space_of(const Shape& e, const Point<T>& w, const Dyadic& rho) {
  const Point<Dyadic> d = exact_point(e.vector);
  const Dyadic altura(e.altura), base = radius_at_centre(e), k(proportion(e));
  const ConeWall wall{exact_point(e.centro), d, squared_length(d), k, base, altura};
  BallSpace<T> space{.pieces = {}, .rings = {rim_of(e.centro, e.vector, {}, base)}, .wall = wall};
  const Ring top = rim_of(e.centro, e.vector, altura, base - k * altura);
  if (number::sign(top.radius) > 0) {
    space.rings.push_back(top);
    return space;
  }
  const Point<Dyadic>& apex = top.middle_times_dd;
  const Point<T> q{w.x * top.dd - apex.x, w.y * top.dd - apex.y, w.z * top.dd - apex.z};
  space.pieces.push_back({squared_length(q) - square(rho * top.dd)});
  return space;
}

/// @{ The numbers of a polynomial, ascending.
Polynomial polynomial(const Quadratic<Dyadic>& f) { return {f.C, number::shifted(f.B, 1), f.A}; }
Polynomial polynomial(const Linear<Dyadic>& f) { return {f.at_zero, f.slope}; }
/// @}
Polynomial times(const Polynomial& a, const Polynomial& b) {
  Polynomial product(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
  return product;
}
Polynomial minus(Polynomial a, const Polynomial& b) {
  a.resize(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < b.size(); ++i) a[i] -= b[i];
  return a;
}
/// @{ Products and differences of numbers, as of polynomials.
Dyadic times(const Dyadic& a, const Dyadic& b) { return a * b; }
Dyadic minus(const Dyadic& a, const Dyadic& b) { return a - b; }
const Dyadic& polynomial(const Dyadic& a) { return a; }
/// @}

/// A number, or a polynomial along a ray.
template <class T>
using BallNumber = std::decay_t<decltype(polynomial(std::declval<T>()))>;

/// The signs that tell whether a place is within ρ of a ring. With S = |q|² + r² and h the way from the axis the
/// squared distance from the ring is S − 2·r·h. It is at most ρ² where S − ρ² ≤ 0, or where `f`, (S − ρ²)² − 4·r²·h²,
/// is not positive. Where S = ρ², f ≤ 0: so a ray that begins outside enters at a root of f, whatever ρ. Both are
/// multiplied by powers of d·d.
template <class T>
struct RingSigns {
  typename BoundOf<T>::type less;
  BallNumber<T> f;

  RingSigns(const Ring& ring, const Point<T>& w, const Dyadic& rho) {
    const auto& [middle, d, dd, r] = ring;
    const Point<T> q{w.x * dd - middle.x, w.y * dd - middle.y, w.z * dd - middle.z};
    less = squared_length(q) - (square(rho) - square(r)) * square(dd);
    const auto across = squared_across(q, d) * (number::shifted(square(r), 2) * dd);
    f = minus(times(polynomial(less), polynomial(less)), polynomial(across));
  }
};

/// The signs that tell whether a place is within ρ of the wall of a cone, whose foot lies between the ends. With x for
/// the way from the axis, A = R(s), and c² = ρ²·(1 + k²·dd) the place is beside the line of the wall where (x − A)² ≤
/// c², that is U ≤ 2·A·x with U = x² + A² − c². `f` is U² − 4·A²·x². The foot is not before the base where k·dd·x ≤ E,
/// with E = s + k·dd·base, and not beyond the end where k·dd·x ≥ E − altura·(1 + k²·dd). Each is multiplied by powers
/// of d·d.
template <class T>
struct WallSigns {
  BallNumber<T> A, U, f, E, near, beyond, far;

  WallSigns(const ConeWall& wall, const Point<T>& w, const Dyadic& rho) {
    const auto& [centro, d, dd, k, base, altura] = wall;
    const Point<T> q{w.x - centro.x, w.y - centro.y, w.z - centro.z};
    const T s = dot(q, d), radius = base - s * k, foot = s - (-(k * dd * base));
    const Dyadic narrowed = Dyadic(1) + square(k) * dd;
    const T from_end = foot - altura * narrowed;
    const auto xx = squared_across(q, d);                                   // x²·dd
    const auto u = xx + square(radius) * dd - square(rho) * narrowed * dd;  // U·dd
    const auto kx = xx * (square(k) * dd);                                  // (k·dd·x)²
    A = polynomial(radius);
    U = polynomial(u);
    f = minus(times(U, U), times(polynomial(square(radius) * number::shifted(dd, 2)), polynomial(xx)));
    E = polynomial(foot);
    near = minus(polynomial(kx), polynomial(square(foot)));
    beyond = polynomial(from_end);
    far = minus(polynomial(kx), polynomial(square(from_end)));
  }

  /// Whether the signs are those of a place there.
  template <class Sign>
  bool holds(Sign sign) const {
    const bool is_beside = sign(A) >= 0 ? sign(U) <= 0 || sign(f) <= 0 : sign(U) <= 0 && sign(f) >= 0;
    return is_beside && sign(E) >= 0 && sign(near) <= 0 && (sign(beyond) <= 0 || sign(far) >= 0);
  }
};

/// The first touch so far.
class EarliestTouch {
 public:
  bool is_at_start() const { return found_ && !found_->root; }
  void take_start() { found_ = BallTouch{}; }
  void take(const Root& root) {
    if (!found_ || (found_->root && algebra::compare(root, *found_->root) < 0)) found_ = BallTouch{root};
  }
  /// Whether a root is not before the first so far.
  bool is_late(const Root& root) const {
    return found_ && (!found_->root || algebra::compare(root, *found_->root) >= 0);
  }
  const std::optional<BallTouch>& found() const { return found_; }

 private:
  std::optional<BallTouch> found_{};
};

/// Whether the quadratic is positive at every t ≥ 0, as its coefficients show.
bool is_always_positive(const Quadratic<Dyadic>& f) {
  return number::sign(f.C) > 0 && number::sign(f.B) >= 0 && number::sign(f.A) >= 0;
}

void take_first_in(EarliestTouch& earliest, const BallPiece<Linear<Dyadic>>& piece) {
  if (std::ranges::any_of(piece, is_always_positive)) return;
  if (std::ranges::all_of(piece, [](const auto& f) { return number::sign(f.C) <= 0; })) return earliest.take_start();
  for (const Quadratic<Dyadic>& f : piece) {
    const surface::exact::Roots roots = surface::exact::roots({f.A, f.B, f.C});
    if (roots.every) continue;
    if (roots.count == 0 && number::sign(f.C) > 0) return;
    for (const Parameter& t : roots.values()) {
      const auto holds = [&](const Quadratic<Dyadic>& g) { return &g == &f || sign_at(g, t) <= 0; };
      if (number::sign(t) <= 0 || earliest.is_late(t) || !std::ranges::all_of(piece, holds)) continue;
      earliest.take(t);
    }
  }
}

void take_first_in(EarliestTouch& earliest, const RingSigns<Linear<Dyadic>>& ring) {
  if (number::sign(ring.less.C) <= 0 || number::sign(ring.f[0]) <= 0) return earliest.take_start();
  Polynomial f = ring.f;
  algebra::normalise(f);
  const std::vector<Root> roots = algebra::positive_roots(f);
  if (!roots.empty()) earliest.take(roots.front());
}

void take_first_in(EarliestTouch& earliest, const WallSigns<Linear<Dyadic>>& wall) {
  if (wall.holds([](const Polynomial& f) { return number::sign(f[0]); })) return earliest.take_start();
  for (Polynomial f : {wall.f, wall.near, wall.far}) {
    algebra::normalise(f);
    if (f.empty()) continue;  // it is 0 along the whole ray, and no end of the piece
    for (const Root& root : algebra::positive_roots(f)) {
      if (earliest.is_late(root)) break;
      const auto sign = [&](Polynomial g) {
        algebra::normalise(g);
        return g.empty() ? 0 : algebra::sign_at(g, root);
      };
      if (wall.holds(sign)) {
        earliest.take(root);
        break;
      }
    }
  }
}

/// A bound of a root.
Parameter bound_of(const BallTouch& touch, bool is_low) {
  if (!touch.root) return {};
  const Root fine = algebra::refined(*touch.root, 200);
  if (const auto* const surd = std::get_if<number::DyadicSurd>(&fine)) return *surd;
  const auto& isolated = std::get<algebra::Isolated>(fine);
  return {.x = is_low ? isolated.low : isolated.high};
}

}  // namespace

Parameter BallTouch::low() const { return bound_of(*this, true); }
Parameter BallTouch::high() const { return bound_of(*this, false); }

std::strong_ordering operator<=>(const BallTouch& a, const BallTouch& b) {
  if (!a.root || !b.root) return a.root.has_value() <=> b.root.has_value();
  return algebra::compare(*a.root, *b.root);
}

std::optional<BallTouch> first_touch(const AskedElements& elements, scene::ElementRef element, const model::Rayo& rayo,
                                     const Dyadic& rho) {
  if (number::sign(rho) <= 0) return std::nullopt;
  const Point<Linear<Dyadic>> w = surface::along<Dyadic>(rayo);
  const auto space = elements.visit_shape(element, [&](const auto& shape) { return space_of(shape, w, rho); });
  EarliestTouch earliest;
  for (const auto& piece : space.pieces) {
    if (!earliest.is_at_start()) take_first_in(earliest, piece);
  }
  if (space.wall && !earliest.is_at_start()) take_first_in(earliest, WallSigns<Linear<Dyadic>>(*space.wall, w, rho));
  for (const Ring& ring : space.rings) {
    if (!earliest.is_at_start()) take_first_in(earliest, RingSigns<Linear<Dyadic>>(ring, w, rho));
  }
  return earliest.found();
}

bool is_touched(const AskedElements& elements, scene::ElementRef element, const Point<Dyadic>& w, const Dyadic& rho) {
  if (number::sign(rho) < 0) return false;
  const auto is_not_positive = [](const Dyadic& f) { return number::sign(f) <= 0; };
  const auto space = elements.visit_shape(element, [&](const auto& shape) { return space_of(shape, w, rho); });
  if (std::ranges::any_of(space.pieces, [&](const auto& piece) { return std::ranges::all_of(piece, is_not_positive); }))
    return true;
  if (space.wall && WallSigns<Dyadic>(*space.wall, w, rho).holds([](const Dyadic& f) { return number::sign(f); }))
    return true;
  return std::ranges::any_of(space.rings, [&](const Ring& ring) {
    const RingSigns<Dyadic> signs(ring, w, rho);
    return is_not_positive(signs.less) || is_not_positive(signs.f);
  });
}

}  // namespace durero::conform
