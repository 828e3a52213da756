#pragma once
/// What a claim answers, and the place that it names.

#include <optional>

#include "conform/zones.hpp"
#include "durero/conform/claim.hpp"
#include "durero/conform/profile.hpp"
#include "durero/conform/suite.hpp"

namespace durero::conform {

struct Trial {
  const scene::Scene& scene;
  const std::vector<Solid>& solids;
  const scene::Query& ray;
  const Truth& truth;
  const Profile& profile;

  Trial(const SuiteCase& of, std::size_t number, const Profile& asked)
      : scene(of.the_case.scene),
        solids(of.solids),
        ray(of.the_case.rays[number]),
        truth(of.truths[number]),
        profile(asked) {}

  Precision precision() const { return {profile.format, profile.thickness}; }
  /// As the system is asked of them.
  AskedElements elements() const {
    return {scene, profile.caps == Caps::solid ? std::span<const Solid>(solids) : std::span<const Solid>()};
  }
  bool has_hit() const { return truth.hit.resultado == model::Resultado::hit; }
  /// What a system knows the element as: a disc that closes a solid of one with solids is its wall.
  scene::ElementRef body(scene::ElementRef element) const;
  /// Whether the claim may be of the element.
  bool names(const Claim& claim, scene::ElementRef element) const {
    return !claim.element || body(*claim.element) == body(element);
  }
  /// Whether the element is a solid, of which there is an inside.
  bool is_solid(scene::ElementRef element) const;
  /// Whether it is one that the origin lies inside for some data.
  bool may_start_inside(scene::ElementRef element) const;
};

/// x, or the nearest number of the format.
double rounded(double x, Format format);

/// What the system calls the distance of the truth: t! of Primera_Interseccion, or |v| times it, rounded to binary64.
double number_of_truth(const Trial& trial);

/// Whether the hit is of an element of the truth, and its number is the truth's, rounded to the format:
/// number_of_truth, or its point.
bool is_the_truth(const Trial& trial, const Claim& claim);

/// t or the point that the claim gives; nothing where it gives none, or no number.
std::optional<Place> place(const Trial& trial, const Claim& claim);

/// Whether the place lies on the ray of some data: a point given by its coordinates may be beside it by 2√3·δ and a
/// rounding, less than 4δ, and a place before the origin by as much.
bool may_lie_on_ray(const Trial& trial, scene::ElementRef element, const Place& place);
/// Whether it may be the origin itself.
bool may_be_origin(const Trial& trial, scene::ElementRef element, const Place& place);

}  // namespace durero::conform
