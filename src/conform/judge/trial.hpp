#pragma once
/// A trial holds one ray of an answered case beside the profile of the system on trial; the functions below read a
/// claim in its light.

#include <optional>

#include "conform/judge/near_box.hpp"
#include "conform/judge/scene_facts.hpp"
#include "conform/judge/zones.hpp"
#include "durero/conform/ask/claim.hpp"
#include "durero/conform/ask/profile.hpp"
#include "durero/conform/families/suite.hpp"

namespace durero::conform {

struct ClaimContext {
  const scene::Scene& scene;
  const std::vector<Solid>& solids;
  OtherElements others;  ///< those of the scene that are no shapes of the model
  const scene::Query& ray;
  const ExactAnswer& truth;
  const Profile& profile;
  const SceneFacts& facts;            ///< about the scene
  QuestionKind question;              ///< what is asked about the ray
  bool is_grid;                       ///< whether the scene is asked about as a grid
  std::optional<AskedRange> range{};  ///< of the ray, where has_numbers(question)

  ClaimContext(const SuiteCase& of, std::size_t number, const Profile& asked, const SceneFacts& of_scene)
      : scene(of.the_case.scene),
        solids(of.solids),
        others(of.others()),
        ray(of.the_case.rays[number]),
        truth(of.truths[number]),
        profile(asked),
        facts(of_scene),
        question(of.question),
        is_grid(of.is_grid) {
    if (has_numbers(question)) range = of.ranges[number];
  }

  /// The format and the thickness of surfaces that the profile declares.
  Precision precision() const { return {profile.format, profile.thickness, profile.error}; }
  /// The elements as the system is asked about them: with solids where its profile closes walls with discs.
  AskedElements elements() const {
    return {scene, profile.caps == Caps::solid ? std::span<const Solid>(solids) : std::span<const Solid>(), others};
  }
  bool has_hit() const { return truth.hit.resultado == model::Resultado::hit; }
  /// The element that stands for this one in the system: the wall, where the system has solids and the element is a
  /// disc that closes one; otherwise the element itself.
  scene::ElementRef body(scene::ElementRef element) const;
  /// Whether the claim may be about the element: it names no element, or one of the same body.
  bool names(const Claim& claim, scene::ElementRef element) const {
    return !claim.element || body(*claim.element) == body(element);
  }
  /// Whether the condition holds for some element that the claim may be about.
  template <class Holds>
  bool any_named(const Claim& claim, Holds holds) const;
  /// Whether the element is a solid to the system, and so has an inside: a sphere, a body, a wall that discs close, or
  /// a plane where planes are half-spaces.
  bool is_solid(scene::ElementRef element) const;
  /// The solids inside which the origin lies for some data within the allowance.
  std::vector<scene::ElementRef> solids_around_origin() const;

 private:
  bool may_start_inside(scene::ElementRef element) const;
};

template <class Holds>
bool ClaimContext::any_named(const Claim& claim, Holds holds) const {
  if (claim.element && (profile.caps == Caps::open || solids.empty())) return holds(*claim.element);
  return scene.any_of([&](scene::ElementRef element, const auto&) { return names(claim, element) && holds(element); });
}

/// The number of the format nearest to x, which is x itself in binary64.
double rounded(double x, NumberFormat format);

/// The true value of the number that the system calls distance: t! of Primera_Interseccion, or t!·|v| where the system
/// measures lengths, rounded to binary64.
double number_of_truth(const ClaimContext& trial);

/// The number of any exact hit of the ray, likewise.
double number_of(const ClaimContext& trial, const scene::Hit& hit);

/// Whether the claim may name an element of the exact hit and gives exactly its number or point, rounded to the format.
bool is_exactly(const ClaimContext& trial, const Claim& claim, const scene::Hit& hit);
/// Whether the hit may name an element of the truth and gives exactly the true number (number_of_truth(), or the
/// point), rounded to the format.
bool is_the_truth(const ClaimContext& trial, const Claim& claim);

/// The place that the claim gives by t, by a length or by a point; nothing where the number is missing or not finite.
std::optional<ClaimedPoint> place(const ClaimContext& trial, const Claim& claim);

/// Whether the place lies on the ray of some data within the allowance. A point given by its coordinates may lie beside
/// the ray by 2√3·δ and a rounding, less than 4δ, and a place may lie before the origin by as much.
bool may_lie_on_ray(const ClaimContext& trial, scene::ElementRef element, const ClaimedPoint& place);
/// The elements that the claim may name and that the place, on the ray, may lie on.
std::vector<scene::ElementRef> elements_at(const ClaimContext& trial, const Claim& claim, const ClaimedPoint& place);
/// The solids around the origin that the claim may name, where the system answers the origin inside them.
std::vector<scene::ElementRef> answered_origins(const ClaimContext& trial, const Claim& claim);
/// The filter for triangles on which the place may lie.
NearBox near_box(const ClaimContext& trial, const ClaimedPoint& place);
/// Whether the element is no triangle, or one that the filter lets pass.
bool may_be_near(const scene::Scene& scene, scene::ElementRef element, const NearBox& near);

/// Whether the place may be the origin itself: it is within 4δ of p, with δ of the element.
bool may_be_origin(const ClaimContext& trial, scene::ElementRef element, const ClaimedPoint& place);

}  // namespace durero::conform
