#pragma once
/// Algorithm II.1 of the source paper with the colour of its sections II-D and II-E: for each pixel a ray, its closest
/// intersection, Lambert's law for each light that the point sees.

#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "durero/model/tipos.hpp"
#include "durero/render/image.hpp"
#include "durero/scene/hit.hpp"
#include "durero/scene/scene.hpp"
#include "durero/trace/search.hpp"

namespace durero::render {

/// What answers the rays: any engine, since all of them give the same answer.
struct Tracer {
  using Origin = scene::Origin;
  std::function<scene::Hit(const model::Rayo&, Origin)> first_hit;
  std::function<bool(const model::Rayo&, Origin)> occluded_segment;

  /// first_hit of many rays, in order, on so many threads (0: every core). Empty where an engine has but the first.
  std::function<std::vector<scene::Hit>(std::span<const scene::Query>, unsigned threads)> first_hits{};
};

/// Called now and then, from one thread at a time, with the share of rows that are done, 0 to 1.
using Progress = std::function<void(double)>;

/// What a stage that leaves something open is drawn with.
inline constexpr scene::Resolution default_resolution{640, 360};
inline constexpr glm::dvec3 default_background{0, 0, 0};
inline constexpr glm::dvec3 default_color{0.8, 0.8, 0.8};

/// The unit normal of an element at a point of it: the gradient of its power, on the outer side. At a cone's apex,
/// where the gradient is null, its axis.
glm::dvec3 normal(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point);

/// The colour that a ray brings: background where it meets nothing or where no nearest point exists; otherwise the
/// element's colour times the sum over the lights of max(0, L·N)·colour, each light only where no element stands
/// between. Shadow rays start on the elements hit, so a surface does not shadow itself by rounding. Of several
/// elements at one point the first by name gives colour and normal.
glm::dvec3 color(const scene::Scene& scene, const Tracer& tracer, const model::Rayo& ray);

/// Draws the scene. Rows are shared among threads; every pixel is the same whatever their number.
/// Throws std::domain_error when the scene has no camera, or one that sees nothing.
Image render(const scene::Scene& scene, const Tracer& tracer, const Progress& progress = {});

}  // namespace durero::render
