#pragma once
/// Random scenes with numbers of the full range, and what two scenes must have in common to be the same.
#include <bit>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "durero/scene/addition.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"
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
  switch (*rc::gen::inRange(0, 7)) {
    case 0:
      return model::Agregar_Esfera{std::move(e), centro, any_positive()};
    case 1:
      return model::Agregar_Cilindro{std::move(e), centro, any_positive(), model::Vector{any_axis()}, any_positive()};
    case 2:
      return model::Agregar_Plano{std::move(e), centro, model::Vector{any_axis()}};
    case 5: {
      const double radio = any_positive();
      return model::Agregar_Disco{std::move(e), centro, radio, model::Vector{any_axis()}};
    }
    case 6: {
      const glm::dvec3 b = any_triple();
      const model::Terna v{centro, model::Punto{b}, model::Punto{any_triple()}};
      if (model::Vertices::contains(v)) return model::Agregar_Triangulo{std::move(e), v};
      return model::Agregar_Triangulo{std::move(e), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    }
    case 3:
      return model::Agregar_Cono{std::move(e), centro, any_positive(), model::Vector{any_axis()}, any_positive()};
    default: {
      const double radio = any_positive(), proporcion = any_positive();
      return model::Agregar_Tronco{std::move(e), centro, radio, proporcion, model::Vector{any_axis()}, any_positive()};
    }
  }
}

inline glm::dvec3 any_share() {
  const auto share = [] { return std::ldexp(static_cast<double>(*rc::gen::arbitrary<std::uint32_t>()), -32); };
  return {share(), share(), share()};
}

inline void set_any_textures(scene::Stage& stage) {
  const auto flip = [] { return *rc::gen::arbitrary<bool>(); };
  const auto number = [] { return *rc::gen::inRange(1, 1001) / 64.0; };
  for (const char* name : {"\"", "b", "ñ"}) {
    if (!flip()) continue;
    scene::Texture& t = stage.textures.emplace_back();
    t.name = name;
    t.pattern = static_cast<scene::Pattern>(*rc::gen::inRange<std::size_t>(0, scene::pattern_words.size()));
    t.repeat = {number(), number()};
    if (t.pattern != scene::Pattern::image) {
      t.colors = {any_share(), any_share()};
      continue;
    }
    t.image.file = "a\\b.png";
    t.filter = static_cast<scene::Filter>(*rc::gen::inRange<std::size_t>(0, scene::filter_words.size()));
    if (t.filter == scene::Filter::mipmap) t.near = number();
    if (flip()) t.edges = scene::Edges::clamp;
    if (flip()) t.curve = scene::TransferFunction::linear;
  }
  for (scene::Material& m : stage.materials) {
    for (const scene::Texture& t : stage.textures) {
      if (flip()) m.textures.names[*rc::gen::inRange<std::size_t>(0, m.textures.names.size())] = t.name;
      if (flip()) m.bump = scene::Bump{t.name, number() - 8, flip() ? std::optional(number()) : std::nullopt};
    }
  }
  if (flip()) {
    scene::Environment& e = stage.environment.emplace();
    e.kind = static_cast<scene::Surroundings>(*rc::gen::inRange<std::size_t>(0, scene::surroundings_words.size()));
    if (e.kind == scene::Surroundings::gradient) e.colors = {any_share(), 2.0 * any_share()};
    e.pictures.assign(pictures_of(e.kind), {"sky.jpg"});
  }
}

inline void set_any_stage(scene::Stage& stage) {
  const auto flip = [] { return *rc::gen::arbitrary<bool>(); };
  if (flip()) {
    stage.camera = scene::Camera{any_triple(), any_triple(), any_triple(), *rc::gen::inRange(1, 180000) / 1000.0};
    stage.camera->mirrored = flip();
    if (stage.camera->up == glm::dvec3{}) stage.camera->up.y = 1;
    if (stage.camera->look_at == stage.camera->eye) stage.camera->look_at.x = stage.camera->eye.x == 0 ? 1 : 0;
  }
  if (flip()) stage.resolution = {*rc::gen::inRange(1U, 65536U), *rc::gen::inRange(1U, 65536U)};
  if (flip()) stage.background = any_share() * 3.0;
  for (int n = *rc::gen::inRange(0, 3); n > 0; --n) {
    scene::Light& light = stage.lights.emplace_back(any_triple(), any_share() * 1e10);
    if (*rc::gen::arbitrary<bool>())
      light.cone = {.towards = light.position + glm::dvec3(0, 1, 2), .inner = *rc::gen::inRange(0, 40) / 2.0};
    if (light.cone && light.cone->towards == light.position) light.cone.reset();  // where the sum is rounded
  }
  for (int n = *rc::gen::inRange(0, 3); n > 0; --n) {
    const glm::dvec3 direction = any_triple();
    stage.directional_lights.push_back({direction == glm::dvec3{} ? glm::dvec3{0, 0, 1} : direction, any_share()});
  }
  for (const char* name : {"\"\\\n", "a", "rojo ñ", "zz"}) {
    if (!flip()) continue;
    scene::Material& m = stage.materials.emplace_back(name, any_share());
    if (flip()) continue;
    const auto share = [] { return *rc::gen::inRange(0, 1001) / 1000.0; };
    for (double* k : {&m.k_a, &m.k_d, &m.k_s, &m.k_ps, &m.k_t}) *k = share();
    for (glm::dvec3* color : {&m.M_PS, &m.M_T, &m.emission, &m.ambient}) *color = any_share();
    m.e = share() * 100;
    m.index = share() + 0.5;
  }
  set_any_textures(stage);
  if (flip()) stage.max_depth = *rc::gen::inRange(1U, 1001U);
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
  scene.for_each([&]<class Shape>(scene::ElementRef element, const Shape& shape) {
    std::string text(Shape::word);
    const auto add = [&](double x) { text += ' ' + std::to_string(std::bit_cast<std::uint64_t>(x)); };
    const auto add_triple = [&](const glm::dvec3& v) { add(v.x), add(v.y), add(v.z); };
    scene::for_each_attribute<Shape>([&](const auto& attribute) {
      const auto& value = shape.*attribute.field;
      if constexpr (requires { value.x; }) {
        add_triple(value);
      } else if constexpr (requires { value.size(); }) {
        for (const glm::dvec3& v : value) add_triple(v);
      } else {
        add(value);
      }
    });
    if (const auto m = scene.material(element)) text += ' ' + scene.stage().materials[*m].name;
    all.emplace(scene.name(element).name(), text);
  });
  return all;
}

inline bool same_scene(const scene::Scene& a, const scene::Scene& b) {
  return described(a) == described(b) && a.stage() == b.stage();
}

}  // namespace durero::test
