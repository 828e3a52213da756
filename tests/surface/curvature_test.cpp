#include "durero/surface/curvature.hpp"

#include <glm/geometric.hpp>

#include "durero/model/operaciones.hpp"
#include "durero/scene/axes_across.hpp"
#include "durero/surface/normal.hpp"
#include "support/catch.hpp"

using namespace durero;
using model::Tipo;

namespace {

/// One element of each type, none of them where the numbers are simple.
scene::Scene scene_of_all() {
  scene::Scene scene;
  const model::Vector axis(glm::normalize(glm::dvec3(1, 2, -2)));
  scene.apply(model::Agregar_Esfera{model::Elemento("s"), {1, 2, 3}, 2});
  scene.apply(model::Agregar_Cilindro{model::Elemento("c"), {1, 0, 0}, 1.5, axis, 2});
  scene.apply(model::Agregar_Cono{model::Elemento("k"), {0, 1, 0}, 0.7, axis, 3});
  scene.apply(model::Agregar_Tronco{model::Elemento("t"), {0, 1, 0}, 1, 0.4, axis, 3});
  scene.apply(model::Agregar_Plano{model::Elemento("p"), {0, 0, 0}, axis});
  return scene;
}

/// A point of the surface that is turned around an axis, at an advance and a radius there.
glm::dvec3 turned(const glm::dvec3& centre, const glm::dvec3& axis, double advance, double radius) {
  return centre + advance * axis + radius * scene::axes_across(axis).first;
}

}  // namespace

TEST_CASE("the curvature of a sphere is one over its radius, of what is flat 0") {
  const scene::Scene scene = scene_of_all();
  const glm::dmat3 ball = surface::curvature(scene, {Tipo::soy_esfera, 0}, {3, 2, 3});
  CHECK(glm::length(ball * glm::dvec3(0, 1, 0) - glm::dvec3(0, 0.5, 0)) < 1e-15);
  CHECK(glm::length(ball * glm::dvec3(0, 0, 1) - glm::dvec3(0, 0, 0.5)) < 1e-15);
  CHECK(ball * glm::dvec3(1, 0, 0) == glm::dvec3(0));
  CHECK(surface::curvature(scene, {Tipo::soy_plano, 0}, {0, 0, 0}) == glm::dmat3(0));
  CHECK(surface::curvature(scene, {Tipo::soy_esfera, 0}, {1, 2, 3}) == glm::dmat3(0));  // the centre has no normal
}

TEST_CASE("the curvature of each quadric is what the normals beside a point tell") {
  const scene::Scene scene = scene_of_all();
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, -2));
  const std::pair<Tipo, glm::dvec3> points[] = {
      {Tipo::soy_esfera, {1 + 2 * 0.6, 2, 3 + 2 * 0.8}},
      {Tipo::soy_cilindro, turned({1, 0, 0}, axis, 0.5, 1.5)},
      {Tipo::soy_cono, turned({0, 1, 0}, axis, 1, 0.7 * 2)},
      {Tipo::soy_tronco, turned({0, 1, 0}, axis, 1, 1 + 0.4 * 2)},
  };
  for (const auto& [tipo, w] : points) {
    CAPTURE(static_cast<int>(tipo));
    const glm::dvec3 n = surface::normal(scene, {tipo, 0}, w);
    const glm::dmat3 curvature = surface::curvature(scene, {tipo, 0}, w);
    const auto [first, second] = scene::axes_across(n);
    for (const glm::dvec3& step : {first, second, glm::normalize(first + 3.0 * second)}) {
      constexpr double h = 1e-5;
      const glm::dvec3 turn =
          (surface::normal(scene, {tipo, 0}, w + h * step) - surface::normal(scene, {tipo, 0}, w - h * step)) / (2 * h);
      CHECK(glm::length(curvature * step - turn) < 1e-8);
    }
    CHECK(glm::length(curvature * n) < 1e-15);
  }
}
