#include "element_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "durero/oracle/sampled.hpp"

namespace durero::oracle::sampled {
namespace {

/// How much more a map may stretch lengths one way than another: with 2¹⁶ the roundings of normals, some 2⁻⁵⁰ times
/// as much, are far below the 1/8 that they are compared with.
constexpr double most_stretch = 0x1p16;

void require_length(double length, const model::Elemento& e) {
  if (length >= least_length && length <= greatest_length) return;
  out_of_range(fmt::format("element {} has a length of", e.name()), length,
               fmt::format("lengths from {} to {}", least_length, greatest_length));
}

void require_coordinates(const glm::dvec3& center, const model::Elemento& e) {
  for (const double x : {center.x, center.y, center.z}) {
    if (std::abs(x) <= greatest_length) continue;
    out_of_range(fmt::format("element {} has a coordinate of", e.name()), x,
                 fmt::format("coordinates up to {}", greatest_length));
  }
}

void require_range(const PlacedSurface& surface, const model::Elemento& e) {
  const Placement& by = surface.placement();
  if (!(by.most() <= most_stretch * by.least())) {
    out_of_range(fmt::format("element {} is stretched more one way than another by a factor of up to", e.name()),
                 by.most() / by.least(), fmt::format("factors up to {}", most_stretch));
  }
  const Parametrisation& original = surface.original();
  for (const double length : {original.widest(), original.length()})
    for (const double stretch : {1.0, by.least(), by.most()}) require_length(stretch * length, e);
  require_coordinates(original.center(), e);
  require_coordinates(by.point(original.center()), e);
}

/// How much wider than what stands about it a patch is.
constexpr double patch_width = 8;

/// Radii of the patches of a scene's planes.
class PatchWidths {
 public:
  void add(const glm::dvec3& center, double size) { others_.push_back({center, size}); }

  /// Of the patch about this point: far enough for every other element of the scene, and their shadows from most
  /// directions.
  double about(const glm::dvec3& centro) const {
    double farthest = 0;
    for (const auto& [center, size] : others_) farthest = std::max(farthest, glm::length(center - centro) + size);
    return farthest == 0 ? Parametrisation::default_patch : std::min(patch_width * farthest, greatest_length);
  }

 private:
  struct Other {
    glm::dvec3 center;
    double size;
  };
  std::vector<Other> others_;
};

/// An element, as what its points are made of: a shape and where a map puts it, or a solid.
struct PlacedElement {
  scene::ElementRef ref;
  scene::AnyShape shape;
  Placement by;
  std::shared_ptr<const SampledSolid> solid;

  Parametrisation parametrised(double patch) const {
    return std::visit([&](const auto& one) { return Parametrisation(scene::ShapeView(one), patch); }, shape);
  }
};

class SceneSurfaces {
 public:
  SceneSurfaces(const scene::Scene& scene, double fineness) : scene_(scene), fineness_(fineness) {
    scene.for_each([&](scene::ElementRef e, const auto& shape) {
      const scene::Body* const body = scene.body(e);
      elements_.push_back(body == nullptr ? PlacedElement{e, shape, {}, nullptr} : placed_element(e, *body));
    });
    for (const PlacedElement& element : elements_) measure(element);
  }

  std::vector<ElementSurface> all() {
    surfaces_.reserve(elements_.size());
    for (const PlacedElement& element : elements_) {
      if (element.solid)
        add_solid(element);
      else
        add({element.ref, placed(element), nullptr, 0, {}});
    }
    return std::move(surfaces_);
  }

 private:
  static PlacedElement placed_element(scene::ElementRef e, const scene::Body& body) {
    if (const auto* const instance = std::get_if<scene::Instance>(&body.form))
      return {e, instance->shape, Placement(instance->mapa), nullptr};
    return {e, scene::stand_in, {}, std::make_shared<const SampledSolid>(std::get<scene::Compound>(body.form))};
  }

  void measure(const PlacedElement& element) {
    if (element.solid) return widths_.add(element.solid->seen().center, element.solid->seen().radius);
    const Parametrisation surface = element.parametrised(Parametrisation::default_patch);
    if (!surface.is_patch()) widths_.add(element.by.point(surface.center()), element.by.most() * surface.size());
  }

  PlacedSurface placed(const PlacedElement& element) const {
    const glm::dvec3* const centro = plane_centro(element.shape);
    const double patch = centro == nullptr ? 0 : widths_.about(element.by.point(*centro)) / element.by.least();
    return PlacedSurface(element.parametrised(patch), element.by);
  }

  static const glm::dvec3* plane_centro(const scene::AnyShape& shape) {
    const auto* const plane = std::get_if<scene::Plane>(&shape);
    return plane == nullptr ? nullptr : &plane->centro;
  }

  void add_solid(const PlacedElement& element) {
    for (std::size_t leaf = 0; leaf < element.solid->size(); ++leaf)
      for (const PlacedSurface& surface : element.solid->surfaces(leaf))
        add({element.ref, surface, element.solid, leaf, {}});
  }

  void add(ElementSurface surface) {
    require_range(surface.surface, scene_.name(surface.ref));
    surface.outline = surface.surface.outline(fineness_);
    surfaces_.push_back(std::move(surface));
  }

  const scene::Scene& scene_;
  double fineness_;
  std::vector<PlacedElement> elements_;
  PatchWidths widths_;
  std::vector<ElementSurface> surfaces_;
};

/// Leaves those samples of a cover for which `keeps` is true. The balls stay: some hold none.
template <class Keeps>
void keep(Cover& cover, Keeps keeps) {
  std::vector<std::uint32_t> kept_before{0};  // of the samples before each
  kept_before.reserve(cover.samples.size() + 1);
  std::vector<glm::dvec3> kept;
  for (const glm::dvec3& sample : cover.samples) {
    if (keeps(sample)) kept.push_back(sample);
    kept_before.push_back(static_cast<std::uint32_t>(kept.size()));
  }
  for (BallNode& ball : cover.balls) {
    ball.first = kept_before[ball.first];
    ball.last = kept_before[ball.last];
  }
  cover.samples = std::move(kept);
}

}  // namespace

void out_of_range(const std::string& what, double value, const std::string& expected) {
  throw std::domain_error(fmt::format("{} {}; expected {} (the sampled oracle's range)", what, value, expected));
}

Cover ElementSurface::cover(double fineness) const {
  Cover cover = surface.cover(fineness);
  if (solid) keep(cover, [&](const glm::dvec3& sample) { return may_have(sample, cover.delta); });
  return cover;
}

std::vector<ElementSurface> surfaces_of(const scene::Scene& scene, double fineness) {
  return SceneSurfaces(scene, fineness).all();
}

}  // namespace durero::oracle::sampled
