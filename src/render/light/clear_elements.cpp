#include "clear_elements.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "durero/render/texture/coordinates.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"

namespace durero::render {
namespace {

/// The share of light that a surface of that look lets through.
glm::dvec3 let_through(const Look& look) { return look.k_t * look.M_T; }

}  // namespace

bool ClearElements::count() const {
  return context_.limits.shadows == ShadowRule::coloured &&
         std::ranges::any_of(context_.scene.stage().materials, [](const scene::Material& m) { return m.k_t > 0; });
}

glm::dvec3 ClearElements::share_through(const scene::Query& shadow, surface::exact::RayStretch stretch,
                                        double way) const {
  // A texture makes a share no greater.
  const auto passes = [&](scene::ElementRef e) { return let_through(context_.look_of(e).plain) != glm::dvec3(0); };
  const auto points = context_.engine.points_between(context_.scene, shadow, stretch, passes);
  if (!points) return glm::dvec3(0);
  glm::dvec3 share(1);
  for (const auto& [element, point] : *points) {
    const TexturedMaterial& worn = context_.look_of(element);
    if (worn.varies) {
      const double seen_from = way + glm::distance(shadow.rayo.p().xyz(), point);
      share *= let_through(worn.look(coordinates(context_.scene, element, point), seen_from));
    } else {
      share *= let_through(worn.plain);
    }
  }
  return share;
}

}  // namespace durero::render
