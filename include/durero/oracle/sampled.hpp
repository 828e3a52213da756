#pragma once
/// The sampled oracle: every surface as points that follow from two parameters, the ray as a set of points, and the
/// first intersection as the nearest point common to both up to the covering radius δ of the points at hand. It knows
/// no equation, and so no root of one: what it sees, it sees otherwise than every engine that it judges.
///
/// It is coarse: its own first hit is a sample, within δ of the ray. And it takes no origin: of the elements that a ray
/// starts on, samples stay within δ of the ray for as long as it takes the ray to rise from the surface, which is no
/// fixed length, but the whole of a generator where the ray leaves along it. No distance tells a surface that the ray
/// leaves from one that it meets; only the equation through the origin does.
///
/// Of a plane it sees a patch: a disc about centro, eight times as wide as what reaches to every element of the scene
/// that is no plane, or of the radius 64 in a scene of planes alone. Of points beyond it, it says nothing; and where
/// centro is far from those elements the patch is wide, its samples lie far apart, and it says little of what is among
/// them.
///
/// With x = p + u·v/|v| at distance u from the origin, a sample w is a candidate when it is within δ of the ray; the
/// point of the ray nearest to it is its foot. Two directions hold for each element:
///   complete: where the ray meets the element, some sample is within δ of that point, so it is a candidate.
///   sound: where a candidate has its foot more than 8δ before the claimed hit, finer points of the surface near the
///     ray, down to δ/1024, either are not there, or prove that the ray crosses the surface before that hit
///     (crossing.hpp), unless
///     grazing: the ray is nearly tangent to the surface where they are,
///     rim: they are at a rim or an apex, or
///     origin: they are at the origin of the ray.
///
/// Its lengths are limited so that their squares neither overflow nor underflow; its distances carry a slack of 2⁻⁴⁰ of
/// the lengths at hand for their own rounding.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "durero/model/tipos.hpp"
#include "durero/oracle/cover.hpp"
#include "durero/scene/hit.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"

namespace durero::oracle::sampled {

/// The fineness of whoever names none.
inline constexpr double default_fineness = 1.0 / 16;

/// @{ The lengths of elements that it takes: radius, altura, a cone's generator, half the circumference of a sphere. A
/// coordinate of a centre may also be nearer to 0.
inline constexpr double least_length = 1e-140, greatest_length = 1e140;
/// @}
/// The greatest coordinate of a ray's origin.
inline constexpr double greatest_origin = 1e145;

/// How a claimed first hit stands to the samples.
enum class SampledVerdict : std::uint8_t {
  agrees,      ///< both directions hold for every element
  grazing,     ///< a candidate without a hit, explained by a nearly tangent ray
  rim,         ///< a candidate without a hit, explained by a rim or an apex
  origin,      ///< a candidate without a hit, explained by its place at the origin
  incomplete,  ///< a claimed hit with no sample within δ: the claim is wrong
  unsound      ///< a candidate without a hit and without an explanation: the claim is wrong
};
/// How many verdicts there are.
inline constexpr std::size_t verdict_count = static_cast<std::size_t>(SampledVerdict::unsound) + 1;
/// Its name, as above.
std::string_view name(SampledVerdict verdict) noexcept;
/// Whether the claim is not shown to be wrong.
constexpr bool agrees(SampledVerdict verdict) noexcept { return verdict < SampledVerdict::incomplete; }

/// Is told of how many pairs of a ray and a surface more is known, by any thread.
using Done = std::function<void(std::uint64_t)>;

struct ElementSurface;

/// The samples of every element of a scene, instances and solids among them. They are copies: the scene may be edited
/// or end.
///
/// The samples of a usual element take 90 kB, and those of a needle 2 GB. Where all take more than most_bytes, none are
/// kept: each call makes those of some elements at a time, of what it asks for, and holds all its rays against them. So
/// of such a scene many rays are to be asked at once.
class Oracle {
 public:
  /// How many bytes of samples are held at once, and those of one element where they are more.
  static constexpr std::size_t usual_bytes = std::size_t{1} << 28U;

  /// Throws std::domain_error where a length or coordinate of an element is not one that it takes.
  explicit Oracle(const scene::Scene& scene, double fineness = default_fineness, std::size_t most_bytes = usual_bytes);
  ~Oracle();
  Oracle(const Oracle&) = delete;
  Oracle& operator=(const Oracle&) = delete;

  /// A ball around each surface: of a solid around that of each leaf, of another element around its own.
  std::vector<BallNode> bounds() const;

  // All throw std::domain_error where a ray starts beyond greatest_origin.

  /// The nearest candidate over all elements, as a hit: t and punto (the sample) are approximate, within δ.
  scene::Hit first_hit(const model::Rayo& ray) const;
  /// The same of each ray. Precondition: as many hits as queries.
  void first_hits(std::span<const scene::Query> queries, std::span<scene::Hit> hits) const;

  /// Judges a claimed closest intersection of the ray against the samples, in both directions.
  SampledVerdict judge(const model::Rayo& ray, const scene::Hit& claimed) const;
  /// The same of each ray. Precondition: as many claims as queries.
  std::vector<SampledVerdict> judge(
      std::span<const scene::Query> queries, std::span<const scene::Hit> claimed,
      const Done& done = [](std::uint64_t) {}) const;

 private:
  struct Part;    // some surfaces that follow each other, and their covers
  struct Judged;  // a ray and its claim
  struct First;   // a ray and its first hit

  /// Behind the last element of the part that begins with that one.
  std::size_t end_of_part(std::size_t first) const;
  template <class IsWanted>
  std::vector<Cover> covers(std::span<const ElementSurface> of, IsWanted is_wanted) const;
  template <class Visit, class IsWanted>
  void for_each_part(Visit visit, IsWanted is_wanted) const;

  double fineness_;
  std::size_t most_bytes_;
  std::vector<ElementSurface> elements_;
  std::vector<Cover> kept_{};  // of all elements, or of none
};

}  // namespace durero::oracle::sampled
