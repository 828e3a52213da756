#pragma once
/// Random scenes of moderate size for tests: a seeded stream in, a scene under contract out. Not of any degenerate
/// family: those are in the families of the conformance cases.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <string>

#include "durero/model/operaciones.hpp"
#include "durero/scene/scene.hpp"

namespace durero::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// Uniform in [low, high): 53 random bits, the same on every platform.
  double uniform(double low, double high) { return low + (high - low) * (double(engine_() >> 11) * 0x1p-53); }
  std::uint64_t below(std::uint64_t n) { return engine_() % n; }
  glm::dvec3 in_cube(double half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }
  glm::dvec3 direction() {
    for (;;) {
      const glm::dvec3 v = in_cube(1);
      const double length = glm::length(v);
      if (length > 0.1 && length <= 1) return v / length;
    }
  }
  /// A direction whose stored components are within tolerancia_unidad of unit length.
  model::Vector axis() {
    for (;;) {
      const model::Vector d(direction());
      if (model::Unitario::contains(d)) return d;
    }
  }

 private:
  std::mt19937_64 engine_;
};

/// A random element named `name`, of a random type, its centre in [−1, 1]³ and its lengths between 0.1 and 0.8.
inline model::Operation random_addition(Random& random, const std::string& name) {
  const model::Elemento e(name);
  const model::Punto centro(random.in_cube(1));
  switch (random.below(3)) {
    case 0:
      return model::Agregar_Esfera{e, centro, random.uniform(0.1, 0.8)};
    case 1:
      return model::Agregar_Cilindro{e, centro, random.uniform(0.1, 0.5), random.axis(), random.uniform(0.3, 1.2)};
    default:
      return model::Agregar_Cono{e, centro, random.uniform(0.2, 1.5), random.axis(), random.uniform(0.3, 0.8)};
  }
}

inline scene::Scene random_scene(Random& random, std::size_t elements) {
  scene::Scene scene;
  for (std::size_t i = 0; i < elements; ++i) scene.apply(random_addition(random, "e" + std::to_string(i)));
  return scene;
}

/// A ray from somewhere around the scene towards somewhere in it; its direction is no unit vector.
inline model::Rayo random_ray(Random& random) {
  const glm::dvec3 from = random.in_cube(3), to = random.in_cube(1);
  return {model::Punto(from), model::Vector((to - from) * random.uniform(0.5, 2))};
}

}  // namespace durero::test
