#pragma once
/// Scenes of triangles and planes, some of them mirrors.

#include <string>

#include "durero/model/operaciones.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"
#include "support/scenes.hpp"

namespace durero::test {

/// An empty scene with a camera, two lights, and the materials matt (0), mirror (1) and silver (2).
inline scene::Scene triangle_stage() {
  scene::Scene scene;
  scene::Stage& stage = scene.stage();
  stage.camera = scene::Camera{{0.3, 0.4, -4}, {0, 0, 0}, {0, 1, 0}, 50};
  stage.resolution = scene::Resolution{40, 30};
  stage.background = glm::dvec3(0.1, 0.2, 0.4);
  stage.lights = {{{3, 5, -3}, {0.9, 0.8, 0.7}}, {{-4, 3, -2}, {0.3, 0.3, 0.4}}};
  stage.materials = {{"matt", {0.9, 0.4, 0.2}}, {"mirror", {0.1, 0.1, 0.1}}, {"silver", {0.2, 0.2, 0.3}}};
  stage.materials[1].k_ps = 0.9;
  stage.materials[2].k_ps = 0.5;
  stage.max_depth = 4;
  return scene;
}

inline void add_triangle(scene::Scene& scene, const std::string& name, const glm::dvec3& a, const glm::dvec3& b,
                         const glm::dvec3& c, std::uint32_t material = 0) {
  scene.apply(model::Agregar_Triangulo{model::Elemento(name), {model::Punto(a), model::Punto(b), model::Punto(c)}});
  scene.set_material(*scene.find(name), material);
}
inline void add_plane(scene::Scene& scene, const std::string& name, const glm::dvec3& point, const glm::dvec3& normal,
                      std::uint32_t material = 0) {
  scene.apply(model::Agregar_Plano{model::Elemento(name), model::Punto(point), model::Vector(normal)});
  scene.set_material(*scene.find(name), material);
}

/// Random triangles that pierce each other, over a floor.
inline scene::Scene random_triangles(Random& random, std::size_t count) {
  scene::Scene scene = triangle_stage();
  add_plane(scene, "floor", {0, -1, 0}, {0, 1, 0}, 2);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 a = random.in_cube(1.5), b = random.in_cube(1.5), c = random.in_cube(1.5);
    add_triangle(scene, "t" + std::to_string(i), a, b, c, static_cast<std::uint32_t>(i % 3));
  }
  return scene;
}

}  // namespace durero::test
