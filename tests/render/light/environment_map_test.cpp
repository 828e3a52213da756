#include "durero/render/light/environment_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <iostream>

#include "durero/io/pictures/picture_file.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/render/light/environment.hpp"
#include "durero/render/output/tone.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"

using namespace durero;
using scene::Surroundings;

namespace {

constexpr std::uint32_t width = 64;
constexpr Surroundings with_pictures[] = {Surroundings::box, Surroundings::spherical, Surroundings::equirectangular};

/// Balls of different colours all around the origin, and a sky.
scene::Scene crowd(double distance) {
  scene::Scene scene;
  scene.stage().environment = {
      {.kind = Surroundings::gradient, .colors = {glm::dvec3(0.3, 0.2, 0.1), glm::dvec3(0.4, 0.6, 1)}}};
  const auto add = [&](const char* name, const glm::dvec3& at, const glm::dvec3& color) {
    const auto index = static_cast<std::uint32_t>(scene.stage().materials.size());
    scene.stage().materials.push_back({.name = name, .color = {0, 0, 0}, .emission = color});
    scene.apply(model::Agregar_Esfera{model::Elemento(name), model::Punto(distance * at), 0.5 * distance});
    scene.set_material(*scene.find(name), index);
  };
  add("a", {1, 0.2, 0}, {1, 0, 0});
  add("b", {-1, 0, 0.3}, {0, 1, 0});
  add("c", {0.1, 1, 0}, {0, 0, 1});
  add("d", {0, -1, 0.4}, {1, 1, 0});
  add("e", {0, 0.3, 1}, {0, 1, 1});
  add("f", {0.3, 0, -1}, {1, 0, 1});
  return scene;
}

scene::Environment read(const std::vector<render::Image>& images, Surroundings kind) {
  scene::Environment environment{.kind = kind};
  for (const render::Image& image : images)
    environment.pictures.push_back(
        {"", std::make_shared<const std::vector<scene::TexelImage>>(
                 1, io::picture_of(render::encode_png(image), scene::TransferFunction::srgb))});
  return environment;
}

}  // namespace

TEST_CASE("each face of a box is the picture of a camera of 90 degrees, to 1/255") {
  scene::Scene scene = crowd(4);
  const auto engine = engine::find("exact")->prepare(scene);
  const glm::dvec3 from(0.2, 0.1, -0.3);
  const auto faces = render::environment_map(scene, *engine, Surroundings::box, width, from, {1});
  REQUIRE(faces.size() == 6);
  const glm::dvec3 forward[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const glm::dvec3 up[] = {{0, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 1, 0}, {0, 1, 0}};
  for (std::size_t i = 0; i < 6; ++i) {
    scene.stage().camera = {from, from + forward[i], up[i], 90};
    const render::Image seen =
        render::toned(render::render(scene, *engine, {}, {.size = scene::Resolution{width, width}, .max_depth = 1}),
                      render::Tone::clamp);
    int off = 0;
    for (std::size_t j = 0; j < seen.rgb.size(); ++j) off += std::abs(seen.rgb[j] - faces[i].rgb[j]) > 1;
    // On the outline of a ball a ray of another rounding may pass by: few pixels.
    CHECK(off <= 9);
    CHECK(std::adjacent_find(seen.rgb.begin(), seen.rgb.end(), std::not_equal_to<>()) != seen.rgb.end());
  }
}

TEST_CASE("a map in place of what it was drawn of brings the same colours, but for its texels") {
  const scene::Scene scene = crowd(4);
  const auto engine = engine::find("exact")->prepare(scene);
  for (const Surroundings kind : with_pictures) {
    const auto environment = read(render::environment_map(scene, *engine, kind, 512, glm::dvec3(0), {1}), kind);
    int off = 0, count = 0;
    for (double a = 0.05; a < 6.2; a += 0.1)
      for (double b = -1.5; b < 1.5; b += 0.1, ++count) {
        const glm::dvec3 d(std::cos(b) * std::cos(a), std::sin(b), std::cos(b) * std::sin(a));
        const scene::Query query{{model::Punto(0, 0, 0), model::Vector(d)}};
        const glm::dvec3 truth = render::brought(scene, *engine, {&query, 1}, {1}).at(0).color;
        const glm::dvec3 seen = render::environment_at(environment, d);
        off += std::max({std::abs(truth.x - seen.x), std::abs(truth.y - seen.y), std::abs(truth.z - seen.z)}) > 0.02;
      }
    CHECK(off < count / 12);  // those next to an outline
  }
}

TEST_CASE("a mirror ball among things that are far shows what a map of them shows, and the better the farther") {
  double before = 1;
  for (const double distance : {10.0, 100.0, 1000.0}) {
    scene::Scene scene = crowd(distance);
    const auto bare = engine::find("exact")->prepare(scene);
    const glm::dvec3 n = glm::dvec3(0.36, 0.48, 0.8);
    // What a ball of radius 1 mirrors at n starts there, and not in its middle: the directions to what is seen differ
    // by at most 1/distance or so. The outlines that this moves are counted.
    int off = 0, count = 0;
    for (double a = 0; a < 6.28; a += 0.02)
      for (double b = -1.5; b < 1.5; b += 0.02, ++count) {
        const model::Vector d(std::cos(b) * std::cos(a), std::sin(b), std::cos(b) * std::sin(a));
        const scene::Query traced{{model::Punto(n), d}}, mapped{{model::Punto(0, 0, 0), d}};
        off += render::brought(scene, *bare, {&traced, 1}, {1}).at(0).color !=
               render::brought(scene, *bare, {&mapped, 1}, {1}).at(0).color;
      }
    const double share = double(off) / count;
    CHECK(share < before / 2);
    before = share;
  }
}

namespace {

/// A pot in the shape of a teapot, of truncated cones that make up its belly, with spout, lid and knob: all mirrors.
void add_pot(scene::Scene& scene) {
  const auto silver = static_cast<std::uint32_t>(scene.stage().materials.size());
  scene.stage().materials.push_back({.name = "silver", .color = {0, 0, 0}, .k_d = 0, .k_ps = 1});
  const auto add = [&](const char* name, const auto& operation) {
    scene.apply(operation);
    scene.set_material(*scene.find(name), silver);
  };
  const model::Vector up(0, 1, 0), down(0, -1, 0);
  using model::Elemento;
  add("foot", model::Agregar_Tronco{Elemento("foot"), {0, -0.6, 0}, 0.5, 1, down, 0.2});
  add("belly", model::Agregar_Cilindro{Elemento("belly"), {0, -0.6, 0}, 0.7, up, 0.4});
  add("shoulder", model::Agregar_Tronco{Elemento("shoulder"), {0, -0.2, 0}, 0.4, 0.5, up, 0.6});
  add("lid", model::Agregar_Esfera{Elemento("lid"), {0, 0.3, 0}, 0.4});
  add("knob", model::Agregar_Esfera{Elemento("knob"), {0, 0.8, 0}, 0.12});
  add("spout", model::Agregar_Tronco{Elemento("spout"), {0.5, -0.4, 0}, 0.08, 0.15, {0.8, 0.6, 0}, 0.8});
  add("handle", model::Agregar_Tronco{Elemento("handle"), {-0.5, 0.3, 0}, 0.05, 0.05, {-0.8, -0.6, 0}, 0.7});
}

/// The pot, drawn among what there is, of width 160.
render::Picture pot_among(scene::Scene scene) {
  add_pot(scene);
  scene.stage().camera = scene::Camera{{0.4, 0.9, -3.4}, {0, 0.1, 0}, {0, 1, 0}, 36};
  const auto engine = engine::find("fast")->prepare(scene);
  return render::render(scene, *engine, {}, {.size = scene::Resolution{160, 120}, .max_depth = 5});
}

/// The share of the pixels that are off by more than 0.02.
double off(const render::Picture& a, const render::Picture& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    const glm::dvec3 by = glm::abs(a.rgb[i] - b.rgb[i]);
    count += std::max({by.x, by.y, by.z}) > 0.02;
  }
  return double(count) / double(a.rgb.size());
}

}  // namespace

// What is at 10⁹ is a map without texels: no point of the pot sees it in another direction.
TEST_CASE("a pot mirrors what is around it as a map of it shows, and the better the farther that is") {
  const render::Picture mapped = pot_among(crowd(1e9));
  double before = 1;
  for (const double distance : {10.0, 100.0, 1000.0}) {
    const double share = off(pot_among(crowd(distance)), mapped);
    std::cout << "mapped and traced at " << distance << ": " << 100 * share << " % of the pixels differ\n";
    CHECK(share < before / 4);
    before = share;
  }
  CHECK(before > 0);
  // And what the texels of a real map take away.
  const scene::Scene far = crowd(1e9);
  scene::Scene none;
  none.stage().environment = read(render::environment_map(far, *engine::find("fast")->prepare(far),
                                                          Surroundings::equirectangular, 2048, glm::dvec3(0), {1}),
                                  Surroundings::equirectangular);
  const double by_texels = off(pot_among(none), mapped);
  std::cout << "of 2048 by 1024 texels: " << 100 * by_texels << " %\n";
  CHECK(by_texels < 0.03);
}

TEST_CASE("sizes, and what has no pictures") {
  CHECK(render::size_of(Surroundings::equirectangular, 64) == scene::Resolution{64, 32});
  CHECK(render::size_of(Surroundings::equirectangular, 1) == scene::Resolution{1, 1});
  CHECK(render::size_of(Surroundings::box, 64) == scene::Resolution{64, 64});
  const scene::Scene none;
  const auto engine = engine::find("exact")->prepare(none);
  CHECK_THROWS_AS(render::environment_map(none, *engine, Surroundings::gradient, 4, glm::dvec3(0), {1}),
                  std::domain_error);
}
