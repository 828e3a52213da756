#pragma once
/// The elements of a scene as questions to a system see them: shapes, bodies and surfaces of a text. A disc that closes
/// a solid is no element of its own for a system with solids: it follows from its wall, and is off by the errors of the
/// wall.

#include <span>

#include "conform/families/solids.hpp"
#include "conform/judge/allowance.hpp"
#include "durero/conform/families/asked_surface.hpp"
#include "durero/contract/contract.hpp"
#include "durero/scene/scene.hpp"
#include "durero/surface/surfaces.hpp"

namespace durero::conform {

/// A disc at an end of a solid's wall.
struct DiscOfSolid {
  const scene::Disc& disc;
  double proporcion;  ///< k of the wall, 0 where it does not narrow
  Dyadic magnitude;   ///< the largest of the wall's coordinates and lengths, the radius of its base among them
};

inline double proportion(const DiscOfSolid& e) { return e.proporcion; }
inline Dyadic magnitude(const DiscOfSolid& e, const model::Rayo& rayo, const Dyadic& way) {
  return std::max(e.magnitude, magnitude(e.disc, rayo, way));
}

/// The elements of a scene, some of them discs of solids. Precondition of each visit: the element is in the scene.
class AskedElements {
 public:
  /// Without solids every disc is an element of its own. Scene, solids and the others must outlive this object.
  AskedElements(const scene::Scene& scene, std::span<const Solid> solids = {}, const OtherElements& others = {})
      : scene_(&scene), solids_(solids), others_(others) {}

  const scene::Scene& scene() const { return *scene_; }

  template <class Visit>
  decltype(auto) visit(scene::ElementRef element, Visit&& visit) const {
    if (const AskedBody* const of_body = body(element)) return visit(*of_body);
    if (const AskedSurface* const of_text = surface(element)) return visit(*of_text);
    return visit_shape(element, visit);
  }
  /// visit() of one of the model's shapes.
  template <class Visit>
  decltype(auto) visit_shape(scene::ElementRef element, Visit&& visit) const {
    const Solid* solid = solid_closed_by(solids_, element);
    if (solid == nullptr) return scene_->visit(element, visit);
    return visit(disc_of(*solid, element));
  }
  /// visit() where a disc that closes a solid is a disc like any other.
  template <class Visit>
  decltype(auto) visit_plain(scene::ElementRef element, Visit&& visit) const {
    if (const AskedBody* const of_body = body(element)) return visit(*of_body);
    if (const AskedSurface* const of_text = surface(element)) return visit(*of_text);
    return scene_->visit(element, visit);
  }
  /// The body that the element is; null of another.
  const AskedBody* body(scene::ElementRef element) const { return others_.body(element); }
  /// The surface of a text that the element is; null of another.
  const AskedSurface* surface(scene::ElementRef element) const { return others_.surface(element); }

 private:
  DiscOfSolid disc_of(const Solid& solid, scene::ElementRef element) const {
    return scene_->visit(solid.wall, [&]<class Shape>(const Shape& wall) -> DiscOfSolid {
      if constexpr (surface::Axial<Shape>)
        return {scene_->shapes<scene::Disc>()[element.index], proportion(wall),
                std::max(Dyadic(largest_length(wall)), radius_at_centre(wall))};
      else
        contract::unreachable();
    });
  }

  const scene::Scene* scene_;
  std::span<const Solid> solids_;
  OtherElements others_;
};

}  // namespace durero::conform
