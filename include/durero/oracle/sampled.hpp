#pragma once
/// The oracle of the design card: every surface as a finite set of points, the ray as a set of points, and the first
/// intersection as the nearest point common to both up to the covering radius δ. It knows no root of any equation.
///
/// It is meant for ordinary rays, whose squares neither overflow nor underflow; its distances carry a slack of 2⁻⁴⁰
/// of the lengths at hand for their own rounding.
///
/// With x = p + u·v/|v| at distance u from the origin, a sample w is a candidate when it is within δ of the ray; the
/// point of the ray nearest to it is its foot. Two directions hold for each element:
///   complete: where the ray meets the element, some sample is within δ of that point, so it is a candidate.
///   sound: where a candidate has its foot at f, the ray meets the element within η = 8δ of f, unless
///     grazing: the discriminant of the unit-speed quadratic is below (δ·|∇|/η)², the ray being nearly tangent, or
///     rim: that root lies outside the element's stretch of its axis by at most δ + η, or
///     origin: that root lies at or behind the origin.
///     For potencia is 0 at the sample, so at most δ·|∇| at f; a quadratic a(u − u₁)(u − u₂) that is so small has a
///     root within δ·|∇|/√D, because the farther of its roots is at least √D/|a| away.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "durero/model/tipos.hpp"
#include "durero/oracle/cover.hpp"
#include "durero/scene/hit.hpp"
#include "durero/scene/scene.hpp"

namespace durero::oracle::sampled {

inline constexpr double default_fineness = 1.0 / 16;

/// η/δ: how far from a candidate's foot the root may be. A smaller ratio calls more rays grazing.
inline constexpr double reach_ratio = 8;

/// The first candidate of one element: distance of its foot from the origin, and the sample.
struct Candidate {
  double distance;
  glm::dvec3 sample;
};

/// How a claimed first hit stands to the samples.
enum class Verdict : std::uint8_t {
  agrees,      ///< both directions hold for every element
  grazing,     ///< a candidate without a hit, explained by a nearly tangent ray
  rim,         ///< … by a root just beyond a rim
  origin,      ///< … by a root at or behind the origin
  incomplete,  ///< a claimed hit with no sample within δ: the claim is wrong
  unsound      ///< a candidate without a hit and without an explanation: the claim is wrong
};
std::string_view name(Verdict verdict) noexcept;
constexpr bool agrees(Verdict verdict) noexcept { return verdict < Verdict::incomplete; }

/// The samples of every element of a scene. Keeps a reference to the scene, which must outlive it unedited.
class Oracle {
 public:
  explicit Oracle(const scene::Scene& scene, double fineness = default_fineness);

  /// A ball around each element.
  std::vector<Ball> bounds() const;

  /// The nearest candidate over all elements, as a hit: t and punto (the sample) are approximate, within δ.
  scene::Hit first_hit(const model::Rayo& ray) const;

  /// Judges a claimed closest intersection of the ray against the samples, in both directions.
  Verdict judge(const model::Rayo& ray, const scene::Hit& claimed) const;

 private:
  struct Element {
    scene::ElementRef ref;
    Cover cover;
  };
  const scene::Scene& scene_;
  std::vector<Element> elements_;
};

}  // namespace durero::oracle::sampled
