#pragma once
/// Random scenes of moderate size for tests: a seeded stream in, a scene under contract out. Not of any degenerate
/// family: those are in the families of the conformance cases.
#include <glm/vec3.hpp>
#include <string>

#include "durero/conform/random.hpp"
#include "durero/model/operation.hpp"
#include "durero/scene/scene.hpp"

namespace durero::test {

/// The stream of the families, and axes.
class Random : public conform::Random {
 public:
  using conform::Random::Random;
  /// A direction whose stored components are within tolerancia_unidad of unit length.
  model::Vector axis() {
    for (;;) {
      const model::Vector d(direction());
      if (model::Unitario::contains(d)) return d;
    }
  }
};

/// A random element named `name`, of a random type, its centre in [−1, 1]³ and its lengths between 0.1 and 0.8. Whoever
/// calls it includes durero/model/operaciones.hpp.
model::Operation random_addition(Random& random, const std::string& name);

/// So many of them, named e0, e1, ….
scene::Scene random_scene(Random& random, std::size_t elements);

/// A ray from somewhere around the scene towards somewhere in it; its direction is no unit vector.
inline model::Rayo random_ray(Random& random) {
  const glm::dvec3 from = random.in_cube(3), to = random.in_cube(1);
  return {model::Punto(from), model::Vector((to - from) * random.uniform(0.5, 2))};
}

}  // namespace durero::test
