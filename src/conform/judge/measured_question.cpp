#include "conform/judge/measured_question.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "conform/families/solids.hpp"
#include "conform/judge/allowance.hpp"

namespace durero::conform {
namespace {

/// The element of the exact answer, or else of the claim; a disc that closes a solid stands for its wall.
std::optional<scene::ElementRef> met_element(const Finding& finding) {
  const scene::ElementSet& first = finding.of.truths[0].hit.elementos;
  if (first.empty() && !finding.claim.element) return std::nullopt;
  const scene::ElementRef met = first.empty() ? *finding.claim.element : first[0];
  const Solid* const solid = solid_closed_by(finding.of.solids, met);
  return solid == nullptr ? met : solid->wall;
}

std::size_t target_of(const Finding& finding, const Draft& draft) {
  const auto met = met_element(finding);
  if (!met) return 0;
  const std::string name = finding.of.the_case.scene.name(*met).name();
  const auto at = std::ranges::find(draft.elements, name, &Draft::Element::name);
  return at == draft.elements.end() ? 0 : static_cast<std::size_t>(at - draft.elements.begin());
}

/// The place and the measures of a shape.
struct Measures {
  glm::dvec3 middle;
  double size, extent;
};

template <class Shape>
Measures measures(const Shape& shape) {
  if constexpr (std::is_same_v<Shape, AskedBody>) {
    const auto [least, most] =
        std::minmax({length_of(shape.sides[0]), length_of(shape.sides[1]), length_of(shape.sides[2])});
    return {shape.centro, least, 3 * most + shape.radio};
  } else if constexpr (requires { shape.vertices; }) {
    const auto& [a, b, c] = shape.vertices;
    const double longest = std::max({glm::length(b - a), glm::length(c - a), glm::length(c - b)});
    return {(a + b + c) / 3.0, longest, longest};
  } else if constexpr (requires { shape.altura; }) {
    const double wide = number::round_to_binary64(radius_at_centre(shape));  // it is nowhere wider than at its base
    return {shape.centro + shape.altura / 2 * shape.vector, std::min(wide, shape.altura), wide + shape.altura};
  } else if constexpr (requires { shape.radio; }) {
    return {shape.centro, shape.radio, shape.radio};
  } else {
    return {shape.centro, 1, 1};
  }
}

std::optional<double> claimed_distance(const Finding& finding, const MeasuredQuestion& question,
                                       const Profile& profile) {
  const Claim& claim = finding.claim;
  if (claim.outcome != Claim::Outcome::hit) return std::nullopt;
  if (claim.punto) return glm::length(*claim.punto - question.draft.p);
  if (!claim.t) return std::nullopt;
  return profile.measure == Measure::length ? *claim.t : *claim.t * question.length;
}

double distance_of(const Finding& finding, const MeasuredQuestion& question, const Profile& profile) {
  const scene::Hit& hit = finding.of.truths[0].hit;
  if (hit.resultado == model::Resultado::hit) return hit.t * question.length;
  const auto claimed = claimed_distance(finding, question, profile);
  if (claimed && std::isfinite(*claimed)) return *claimed;
  return std::max(0.0, glm::dot(question.middle - question.draft.p, question.unit));
}

}  // namespace

MeasuredQuestion::MeasuredQuestion(const Finding& finding, const Profile& profile)
    : draft(finding.of), target(target_of(finding, draft)), length(std::hypot(draft.v.x, draft.v.y, draft.v.z)) {
  const AskedShape& shape = draft.elements[target].shape;
  const Measures of = std::visit([](const auto& known) { return measures(known); }, shape);
  middle = of.middle;
  size = of.size;
  extent = of.extent;
  has_sides = std::visit([](const auto& known) { return requires { known.vertices; }; }, shape);
  unit = draft.v / length;
  distance = distance_of(finding, *this, profile);
}

}  // namespace durero::conform
