#pragma once
/// What a scene and what was read of its text in another format must have in common, whatever their names.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "durero/io/formats.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/scene/stage.hpp"
#include "random_scene.hpp"
#include "support/scenes.hpp"

namespace durero::test {

/// A scene of a JSON text without its head.
inline scene::GroupedScene scene_of(const std::string& body) {
  return io::read_grouped_scene(io::Source("f", R"({"format":"durero-scene","version":1,)" + body + "}"),
                                io::Bodies::read);
}

/// A material in words, without its name.
inline std::string look_text(const scene::Material& m) {
  const auto triple = [](const glm::dvec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); };
  return fmt::format("{}, {} {} {} {} {} {} {}, {}, {}, {}", triple(m.color), m.k_a, m.k_d, m.k_s, m.k_s > 0 ? m.e : 0,
                     m.k_ps, m.k_t, m.k_t > 0 ? m.index : 1, triple(m.M_PS), triple(m.M_T), triple(m.emission));
}

/// The elements of the tables by type, the bits of their numbers and the look of their material, sorted; −0 is 0.
inline std::vector<std::string> shapes_and_looks(const scene::Scene& scene) {
  scene::Scene renamed = scene;
  for (scene::Material& material : renamed.stage().materials) material.name = look_text(material);
  std::vector<std::string> all;
  const std::string negative_zero = " 9223372036854775808";
  for (auto& [name, text] : described(renamed)) {
    for (std::size_t at; (at = text.find(negative_zero)) != text.npos;) text.replace(at, negative_zero.size(), " 0");
    all.push_back(std::move(text));
  }
  std::ranges::sort(all);
  return all;
}

inline bool has_line(const std::vector<std::string>& lost, const std::string& text) {
  return std::ranges::any_of(lost, [&](const std::string& line) { return line.find(text) != line.npos; });
}

/// Elements of all types at moderate places; every other axis is one of the space, and every other number short, so
/// that some come back the same and some are rounded.
inline scene::Scene scene_to_write(Random& random, int elements) {
  const auto number = [&] {
    const double x = random.uniform(-4, 4);
    return random.below(2) == 0 ? std::round(x * 8) / 8 : x;
  };
  const auto point = [&] { return glm::dvec3{number(), number(), number()}; };
  const auto length = [&] { return std::abs(number()) + 0.125; };
  const auto axis = [&] {
    if (random.below(2) == 0) return random.axis().xyz();
    glm::dvec3 v(0);
    v[static_cast<int>(random.below(3))] = random.below(2) == 0 ? 1 : -1;
    return v;
  };
  scene::Scene scene;
  for (int i = 0; i < elements; ++i) {
    const model::Elemento e("e" + std::to_string(i));
    switch (random.below(7)) {
      case 0:
        scene.add(e, scene::Sphere{point(), length()});
        break;
      case 1:
        scene.add(e, scene::Cylinder{point(), length(), axis(), length()});
        break;
      case 2:
        scene.add(e, scene::Cone{point(), length(), axis(), length()});
        break;
      case 3:
        scene.add(e, scene::TruncatedCone{point(), length(), length(), axis(), length()});
        break;
      case 4:
        scene.add(e, scene::Disc{point(), length(), axis()});
        break;
      case 5:
        scene.add(e, scene::Plane{point(), axis()});
        break;
      default:
        scene.add(e, scene::Triangle{{point(), point(), point()}});
    }
  }
  return scene;
}

}  // namespace durero::test
