#include "conform/judge/normals.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "conform/judge/body_space.hpp"
#include "conform/judge/text_space.hpp"
#include "durero/number/quotient.hpp"

namespace durero::conform {
namespace {

using number::sign;
using Vector = Point<Dyadic>;

Vector exact_vector(const glm::dvec3& a) { return {a.x, a.y, a.z}; }
Vector sum(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector times(const Dyadic& factor, const Vector& a) { return {factor * a.x, factor * a.y, factor * a.z}; }

/// The outward normals at a place, of any positive length: `middle` is that of the data given, and those of moved data
/// are off from it by `error` at most.
struct NormalBall {
  Vector middle;
  Dyadic error;
};

/// The normal of a sphere is q = w − centro, which is off by the ray's share, 5.42·δ.
NormalBall normals_at(const scene::Sphere& e, const Vector& w, const Allowance& allowed) {
  return {from(e.centro, w), allowed.times(6)};
}

/// The normal of a shape with an axis is ρ + k·R·d, with ρ = q − s·d the way from the axis and R the radius at s. By
/// shell.hpp ρ is off by (10.7 + 5.3g)·δ, and R by (2 + g + k·(9.1 + 2.62g))·δ; k is off by u·max(1, k), which times
/// R < 1.51·M·(1 + g) is 1.51·(1 + k)·(1 + g)·δ at most; d by √3·u, which times k·R is 2.62·k·(1 + g)·δ. Together this
/// is less than (13 + 7g + k·(7 + 6g) + k²·(10 + 3g))·δ. |d|² = 1 ± 2⁻⁵⁰ puts s·d off by less than δ more, and products
/// of errors by less than δ.
template <surface::Axial Shape>
NormalBall normals_at(const Shape& e, const Vector& w, const Allowance& allowed) {
  const Dyadic k(proportion(e)), g = allowed.u * k, s = avance(e, w);
  const Vector d = exact_vector(e.vector), across = sum(from(e.centro, w), times(-s, d));
  const Dyadic radius = radius_at_centre(e) - k * s;
  const Dyadic error =
      Dyadic(15) + Dyadic(7) * g + k * (Dyadic(7) + Dyadic(6) * g) + square(k) * (Dyadic(10) + Dyadic(3) * g);
  return {sum(across, times(k * radius, d)), allowed.times(error)};
}

/// The unit vector of a flat shape is off by √3·u.
NormalBall normals_of(const glm::dvec3& vector, const Allowance& allowed) {
  return {exact_vector(vector), Dyadic(2) * allowed.u};
}
NormalBall normals_at(const scene::Plane& e, const Vector&, const Allowance& allowed) {
  return normals_of(e.vector, allowed);
}
NormalBall normals_at(const scene::Disc& e, const Vector&, const Allowance& allowed) {
  return normals_of(e.vector, allowed);
}
NormalBall normals_at(const DiscOfSolid& e, const Vector&, const Allowance& allowed) {
  return normals_of(e.disc.vector, allowed);
}

/// Of the normal of a body only its length is judged: here any direction is right.
NormalBall normals_at(const AskedBody&, const Vector&, const Allowance&) { return {{0, 0, 0}, 1}; }
NormalBall normals_at(const AskedSurface&, const Vector&, const Allowance&) { return {{0, 0, 0}, 1}; }

/// The edges of a triangle are off by 2√3·δ < 3.47·δ each, and the product of two, a × b, by 3.47·δ·(|a| + |b|) +
/// (3.47·δ)². Any two edges have the same product; the shortest have the least error.
NormalBall normals_at(const scene::Triangle& e, const Vector&, const Allowance& allowed) {
  const auto& [a, b, c] = e.vertices;
  const Vector ab = surface::between<Dyadic>(a, b), ac = surface::between<Dyadic>(a, c),
               bc = surface::between<Dyadic>(b, c);
  std::array<Dyadic, 3> lengths = {length_above(ab), length_above(ac), length_above(bc)};
  std::sort(lengths.begin(), lengths.end());
  const Dyadic off = allowed.times(4);
  return {cross(ab, ac), off * (lengths[0] + lengths[1]) + square(off)};
}

/// The verdict where a distance, given by its square, is right up to `allowed`, and no gross error up to `small`.
Verdict verdict_on(const Dyadic& squared, const Dyadic& allowed, const Dyadic& small, Verdict gross) {
  if (squared <= square(allowed)) return Verdict::right;
  return squared <= square(allowed + small) ? Verdict::off : gross;
}

const Dyadic thousandth(0x1.0624dd2f1a9fcp-10);

/// The judge of a hit about one element.
class BesidesJudge {
 public:
  BesidesJudge(const ClaimContext& trial, const Claim& claim, const ClaimedPoint& place, scene::ElementRef element)
      : trial_(&trial),
        claim_(&claim),
        place_(&place),
        element_(element),
        allowed_(trial.elements().visit(
            element,
            [&](const auto& shape) {
              return Allowance(trial.precision(), conform::magnitude(shape, trial.ray.rayo, place.way), trial.ray.rayo);
            })),
        normals_(outward()) {}

  Verdict verdict() const {
    const Profile& profile = trial_->profile;
    Verdict worst = Verdict::right;
    const auto take = [&](Verdict is) {
      if (worst == Verdict::right || (worst == Verdict::off && is != Verdict::right)) worst = is;
    };
    if (claim_->normal && profile.normal != NormalSide::none) take(of_normal(*claim_->normal));
    if (claim_->is_front && profile.faces) take(of_face(*claim_->is_front));
    if (claim_->uv && profile.uv && element_.tipo == scene::Triangle::tipo) take(of_uv(*claim_->uv));
    return worst;
  }

 private:
  /// The outward normals; those of a disc that closes a solid point away from its wall.
  NormalBall outward() const {
    NormalBall normals = trial_->elements().visit(
        element_, [&](const auto& shape) { return normals_at(shape, place_->punto, allowed_); });
    if (trial_->profile.caps == Caps::open) return normals;
    const Solid* const solid = solid_closed_by(trial_->solids, element_);
    if (solid == nullptr) return normals;
    trial_->scene.visit(solid->wall, [&]<class Shape>(const Shape& wall) {
      if constexpr (surface::Axial<Shape>) {
        const bool is_base = solid->discs.front() == element_;
        normals.middle = times(Dyadic(is_base ? -1 : 1), exact_vector(wall.vector));
      }
    });
    return normals;
  }

  /// The side from which the ray comes: 1 from the front, −1 from the back, and 0 where it depends on the data. The way
  /// to the place is off by √3·δ for t·v and by the error of t, 4δ at most: by less than 6δ.
  int side() const {
    const Vector way = from(trial_->ray.rayo.p().xyz(), place_->punto);
    const Dyadic along = dot(way, normals_.middle), off = allowed_.times(6);
    const Dyadic most = off * length_above(normals_.middle) + (length_above(way) + off) * normals_.error;
    return absolute(along) <= most ? 0 : -sign(along);
  }

  /// Whether the normal may point to the side to which those of the profile point.
  bool is_of_side(const Vector& normal) const {
    const int points = sign(dot(normal, normals_.middle));
    switch (trial_->profile.normal) {
      case NormalSide::outward:
        return points > 0;
      case NormalSide::facing:
        return side() == 0 || points == side();
      case NormalSide::either:
      case NormalSide::none:
        return true;
    }
    contract::unreachable();
  }

  /// A normal n of a right answer is at most √3·u from a unit vector N'/|N'| with |N' − N| ≤ error: the sine of its
  /// angle with N is at most error/|N| + √3·u·(1 + 2u), and |n| is 1 up to √3·u, so that |n|² is 1 up to 4u. Where the
  /// error is as large as N every direction is right.
  Verdict of_normal(const glm::dvec3& claimed) const {
    if (!std::isfinite(claimed.x) || !std::isfinite(claimed.y) || !std::isfinite(claimed.z)) return Verdict::non_finite;
    const Vector n = exact_vector(claimed);
    const Dyadic squared = squared_length(n), length = length_above(normals_.middle), u = allowed_.u;
    if (sign(squared) == 0) return Verdict::wrong_normal;
    const Dyadic small = thousandth * length, most = normals_.error + Dyadic(2) * u * length;
    Verdict is = Verdict::right;
    if (most < length) {
      if (!is_of_side(n)) return Verdict::wrong_normal;
      // |n × N|² is (|n|·|N|·sin)²; both sides have |n|² in them.
      const Dyadic off = squared_length(cross(n, normals_.middle));
      is = off <= squared * square(most)           ? Verdict::right
           : off <= squared * square(most + small) ? Verdict::off
                                                   : Verdict::wrong_normal;
    }
    if (is == Verdict::wrong_normal || trial_->profile.normal_length == NormalLength::any) return is;
    const Verdict of_length = verdict_on(square(squared - Dyadic(1)), Dyadic(4) * u, thousandth, Verdict::wrong_normal);
    return of_length == Verdict::right ? is : of_length;
  }

  Verdict of_face(bool is_front) const {
    const int from_side = side();
    return from_side == 0 || (from_side > 0) == is_front ? Verdict::right : Verdict::wrong_face;
  }

  /// The point (1 − u − v)·a + u·b + v·c is off from that of moved vertices by √3·δ·(|1 − u − v| + |u| + |v|), and that
  /// point from the place by √3·2δ + 0.22·δ and the error of t. u and v are ratios, and off by 16ε each besides.
  Verdict of_uv(const glm::dvec2& uv) const {
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return Verdict::non_finite;
    const auto& [a, b, c] = trial_->scene.shapes<scene::Triangle>()[element_.index].vertices;
    const Vector ab = surface::between<Dyadic>(a, b), ac = surface::between<Dyadic>(a, c);
    const Dyadic u(uv.x), v(uv.y), rest = Dyadic(1) - u - v;
    const Vector point = sum(times(u, ab), times(v, ac)), w = from(a, place_->punto);
    const Dyadic lengths = length_above(ab) + length_above(ac);
    const Dyadic weights = absolute(rest) + absolute(u) + absolute(v);
    const Dyadic most = allowed_.times(Dyadic(4 + place_->deviation) + Dyadic(2) * weights) + allowed_.u * lengths;
    return verdict_on(squared_length(sum(point, times(Dyadic(-1), w))), most, thousandth * lengths, Verdict::wrong_uv);
  }

  const ClaimContext* trial_;
  const Claim* claim_;
  const ClaimedPoint* place_;
  scene::ElementRef element_;
  Allowance allowed_;
  NormalBall normals_;
};

}  // namespace

Verdict verdict_besides(const ClaimContext& trial, const Claim& claim, const ClaimedPoint& place,
                        const std::vector<scene::ElementRef>& at) {
  if (at.empty()) return Verdict::right;
  std::optional<Verdict> best;
  for (const scene::ElementRef element : at) {
    const Verdict is = BesidesJudge(trial, claim, place, element).verdict();
    if (!best || is == Verdict::right || (is == Verdict::off && *best != Verdict::right)) best = is;
  }
  return *best;
}

}  // namespace durero::conform
