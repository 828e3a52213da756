#pragma once
/// Random scenes with numbers of the full range, and what two scenes must have in common to be the same.
#include <bit>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "durero/scene/scene.hpp"
#include "support/doubles.hpp"

namespace durero::test {

inline glm::dvec3 any_triple() { return {*anyFinite(), *anyFinite(), *anyFinite()}; }

/// A positive binary64 of any size.
inline double any_positive() {
  const double x = std::abs(*anyFinite());
  return x > 0 ? x : 1.0;
}

/// A vector in Unitario: a random direction, rounded.
inline glm::dvec3 any_axis() {
  const long double x = *moderate(), y = *moderate(), z = *moderate();
  const long double length = std::sqrt(x * x + y * y + z * z);
  if (length == 0) return {0, 0, -1};
  return {static_cast<double>(x / length), static_cast<double>(y / length), static_cast<double>(z / length)};
}

inline model::Operation any_addition(model::Elemento e) {
  const model::Punto centro{any_triple()};
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      return model::Agregar_Esfera{std::move(e), centro, any_positive()};
    case 1:
      return model::Agregar_Cilindro{std::move(e), centro, any_positive(), model::Vector{any_axis()}, any_positive()};
    default:
      return model::Agregar_Cono{std::move(e), centro, any_positive(), model::Vector{any_axis()}, any_positive()};
  }
}

inline glm::dvec3 any_share() {
  const auto share = [] { return std::ldexp(static_cast<double>(*rc::gen::arbitrary<std::uint32_t>()), -32); };
  return {share(), share(), share()};
}

inline void set_any_stage(scene::Stage& stage) {
  const auto flip = [] { return *rc::gen::arbitrary<bool>(); };
  if (flip()) {
    stage.camera = scene::Camera{any_triple(), any_triple(), any_triple(), *rc::gen::inRange(1, 180000) / 1000.0};
    if (stage.camera->up == glm::dvec3{}) stage.camera->up.y = 1;
    if (stage.camera->look_at == stage.camera->eye) stage.camera->look_at.x = stage.camera->eye.x == 0 ? 1 : 0;
  }
  if (flip()) stage.resolution = {*rc::gen::inRange(1U, 65536U), *rc::gen::inRange(1U, 65536U)};
  if (flip()) stage.background = any_share() * 3.0;
  for (int n = *rc::gen::inRange(0, 3); n > 0; --n) stage.lights.push_back({any_triple(), any_share() * 1e10});
  for (const char* name : {"\"\\\n", "a", "rojo ñ", "zz"}) {
    if (flip()) stage.materials.push_back({name, any_share()});
  }
}

/// Up to `most` elements, some with a material.
inline scene::Scene any_scene(int most = 8) {
  scene::Scene scene;
  set_any_stage(scene.stage());
  const std::size_t materials = scene.stage().materials.size();
  const std::string letters = "eE9_.:-";
  for (int n = *rc::gen::inRange(0, most + 1); n > 0; --n) {
    const model::Elemento e{letters[static_cast<std::size_t>(*rc::gen::inRange(0, 7))] + std::to_string(n)};
    scene.apply(any_addition(e));
    if (materials == 0 || *rc::gen::arbitrary<bool>()) continue;
    const auto material = static_cast<std::uint32_t>(*rc::gen::inRange<std::size_t>(0, materials));
    scene.set_material(scene.find(e.name()).value(), material);
  }
  return scene;
}

/// Each element's type, the bits of its numbers and the name of its material.
inline std::map<std::string, std::string> described(const scene::Scene& scene) {
  std::map<std::string, std::string> all;
  const auto add = [&](model::Tipo tipo, std::size_t index, const std::vector<double>& numbers) {
    const scene::ElementRef element{tipo, static_cast<std::uint32_t>(index)};
    std::string text(model::name(tipo));
    for (const double x : numbers) text += ' ' + std::to_string(std::bit_cast<std::uint64_t>(x));
    if (const auto m = scene.material(element)) text += ' ' + scene.stage().materials[*m].name;
    all.emplace(scene.name(element).name(), text);
  };
  for (std::size_t i = 0; i < scene.shapes<scene::Sphere>().size(); ++i) {
    const auto& s = scene.shapes<scene::Sphere>()[i];
    add(model::Tipo::soy_esfera, i, {s.centro.x, s.centro.y, s.centro.z, s.radio});
  }
  for (std::size_t i = 0; i < scene.shapes<scene::Cylinder>().size(); ++i) {
    const auto& c = scene.shapes<scene::Cylinder>()[i];
    add(model::Tipo::soy_cilindro, i,
        {c.centro.x, c.centro.y, c.centro.z, c.radio, c.vector.x, c.vector.y, c.vector.z, c.altura});
  }
  for (std::size_t i = 0; i < scene.shapes<scene::Cone>().size(); ++i) {
    const auto& k = scene.shapes<scene::Cone>()[i];
    add(model::Tipo::soy_cono, i,
        {k.centro.x, k.centro.y, k.centro.z, k.proporcion, k.vector.x, k.vector.y, k.vector.z, k.altura});
  }
  return all;
}

inline bool same_scene(const scene::Scene& a, const scene::Scene& b) {
  return described(a) == described(b) && a.stage() == b.stage();
}

}  // namespace durero::test
