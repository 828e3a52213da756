#pragma once
/// Scenes of triangles for the tests of this layer. Coordinates are multiples of 1/16, so that points between corners,
/// at parts of a 64th, are stored as they are.

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <string>

#include "durero/model/operaciones.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"

namespace durero::test {

using Corners3 = std::array<glm::dvec3, 3>;

/// Adds a triangle, which wears that material of the stage.
inline void add(scene::Scene& scene, const std::string& name, const Corners3& at, std::uint32_t material = 0) {
  using model::Punto;
  scene.apply(model::Agregar_Triangulo{model::Elemento(name), {Punto(at[0]), Punto(at[1]), Punto(at[2])}});
  if (material < scene.stage().materials.size()) scene.set_material(*scene.find(name), material);
}

/// Adds the two triangles of a square across y, of that side, around a point.
inline void add_square(scene::Scene& scene, const std::string& name, const glm::dvec3& middle, double side,
                       std::uint32_t material = 0) {
  const glm::dvec3 x(side / 2, 0, 0), z(0, 0, side / 2);
  add(scene, name + ".1", {middle - x - z, middle + x - z, middle + x + z}, material);
  add(scene, name + ".2", {middle - x - z, middle + x + z, middle - x + z}, material);
}

/// A point of the grid in a cube, −half to half.
inline glm::dvec3 grid_point(std::mt19937_64& random, int half) {
  const auto number = [&] { return (double(random() % std::uint64_t(32 * half + 1)) - 16 * half) / 16; };
  const double x = number(), y = number();
  return {x, y, number()};
}

/// A triangle with an area, its corners around a place of a cube of that half.
inline Corners3 grid_triangle(std::mt19937_64& random, int half, int size = 1) {
  for (;;) {
    const glm::dvec3 middle = grid_point(random, half);
    Corners3 at{};
    for (glm::dvec3& corner : at) corner = middle + grid_point(random, size);
    if (glm::cross(at[1] - at[0], at[2] - at[0]) != glm::dvec3(0)) return at;
  }
}

/// So many triangles t100, t101, …, a camera before them, a light from a point and one from a direction.
inline scene::Scene grid_scene(std::mt19937_64& random, int triangles, int half, int size = 1) {
  scene::Scene scene;
  scene::Stage& stage = scene.stage();
  stage.camera = {{0.125, 0.25, -3.0 * half - 4}, {0, 0, 0}, {0, 1, 0}, 45};
  stage.resolution = scene::Resolution{96, 64};
  stage.background = glm::dvec3(0.25, 0.5, 0.75);
  stage.lights = {{grid_point(random, half) + glm::dvec3(0, 2.0 * half + 2, 0), {0.5, 0.5, 0.5}}};
  stage.directional_lights = {{{0.25, -1, 0.5}, {0.25, 0.25, 0.25}}};
  stage.materials = {{.name = "matt", .color = {0.5, 0.75, 1}, .k_a = 0.125, .k_d = 0.75, .ambient = {0.1, 0.1, 0.1}},
                     {.name = "shiny", .color = {0.75, 0.5, 0.25}, .k_d = 0.5, .k_s = 0.5, .e = 20}};
  for (int i = 0; i < triangles; ++i)
    add(scene, "t" + std::to_string(100 + i), grid_triangle(random, half, size), std::uint32_t(i) % 2);
  return scene;
}

/// A point of a triangle at 64ths between its corners, exactly.
inline glm::dvec3 point_of(std::mt19937_64& random, const Corners3& at) {
  const auto u = random() % 65, v = random() % (65 - u);
  return at[0] + double(u) / 64 * (at[1] - at[0]) + double(v) / 64 * (at[2] - at[0]);
}

}  // namespace durero::test
