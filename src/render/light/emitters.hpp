#pragma once
/// Emitters are the elements that shine of themselves. A point of a surface draws light from their points.

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <unordered_map>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"

namespace durero::render {

/// A direction towards a point of an emitter.
struct EmitterDraw {
  scene::ElementRef element;
  glm::dvec3 way;       ///< to the point, of any length but 0
  double density = 0;   ///< of the direction among all, by solid angle; 0 where nothing is drawn
  bool leaves = false;  ///< whether the way meets the outer side of the element at that point, from within
  bool is_sided =
      true;  ///< whether the point counts only from that side; else wherever the way meets the element first
};

/// The emitters of a scene that have an area: all but planes.
class Emitters {
 public:
  /// Those of a scene and an engine that outlive them.
  Emitters(const scene::Scene& scene, const engine::Engine& engine);

  bool empty() const { return all_.empty(); }

  /// A direction from a point that lies on the elements `en`: an emitter by its power with one number, a point of it
  /// with a pair. Of a sphere that the point is outside of, a direction of the cone that it fills; else a point of the
  /// area.
  EmitterDraw draw(const glm::dvec3& from, const scene::ElementSet& en, double choice, const glm::dvec2& pair) const;

  /// The density, by solid angle, with which draw() gives the direction from there to a point of an element, which has
  /// that unit normal there; 0 for an element that it never draws.
  double density(const glm::dvec3& from, const scene::ElementSet& en, scene::ElementRef element,
                 const glm::dvec3& point, const glm::dvec3& normal) const;

 private:
  struct Emitter {
    scene::ElementRef element;
    double area;
    double chance;  ///< of being drawn
    double up_to;   ///< the sum of the chances up to it
  };

  const scene::Scene& scene_;
  const engine::Engine& engine_;
  std::vector<Emitter> all_;
  std::unordered_map<std::uint64_t, std::size_t> places_;
};

}  // namespace durero::render
