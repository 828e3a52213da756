#include "durero/raster/mirror.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "durero/render/light/planar_mirror.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/render/still_scene.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/query.hpp"

namespace durero::raster {
namespace {

/// A plane, by a point and its unit normal.
struct MirrorPlane {
  glm::dvec3 point, normal;
};

std::optional<MirrorPlane> plane_of(const scene::Scene& scene, scene::ElementRef element) {
  return scene.visit(element, []<class Shape>(const Shape& shape) -> std::optional<MirrorPlane> {
    if constexpr (std::is_same_v<Shape, scene::Triangle>) {
      const auto& [a, b, c] = shape.vertices;
      return MirrorPlane{a, glm::normalize(glm::cross(b - a, c - a))};
    } else if constexpr (std::is_same_v<Shape, scene::Plane> || std::is_same_v<Shape, scene::Disc>) {
      return MirrorPlane{shape.centro, shape.vector};
    } else {
      return std::nullopt;
    }
  });
}

const scene::Material& look_of(const scene::Scene& scene, scene::ElementRef element, std::string_view name) {
  const auto material = scene.material(element);
  if (!material || scene.stage().materials[*material].k_ps == 0)
    throw std::domain_error(fmt::format("element {} mirrors nothing; expected a material with k_ps", name));
  const scene::Material& look = scene.stage().materials[*material];
  if (look.k_t > 0 || std::isfinite(look.gloss) || look.textures.any() || look.bump)
    throw std::domain_error(
        fmt::format("element {} is more than a mirror; expected one color, no gloss and k_t of 0", name));
  return look;
}

/// Pixels with a ray each.
struct PixelRays {
  std::vector<scene::Query> rays;
  std::vector<std::size_t> pixels;

  void add(std::size_t pixel, scene::Query ray) {
    rays.push_back(std::move(ray));
    pixels.push_back(pixel);
  }
};

/// The rays of a picture: those that do not show the mirror, those that do, and for each of these the second camera's.
struct MirrorPasses {
  PixelRays others, mirror, behind;
};

MirrorPasses passes_of(const engine::Engine& engine, scene::Resolution size, const scene::Camera& camera,
                       scene::ElementRef element, const MirrorPlane& plane) {
  const scene::PrimaryRays first(camera, size);
  const render::SecondCamera second(camera, size, plane.point, plane.normal);
  std::vector<scene::Query> rays;
  for (std::uint32_t y = 0; y < size.height; ++y)
    for (std::uint32_t x = 0; x < size.width; ++x) rays.push_back({first.ray(x, y)});
  const std::vector<scene::Hit> hits = engine::first_hits(engine, rays);
  MirrorPasses passes;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto x = static_cast<std::uint32_t>(i % size.width), y = static_cast<std::uint32_t>(i / size.width);
    const auto behind = second.ray(x, y);
    if (behind && hits[i].elementos == scene::ElementSet{element}) {
      passes.mirror.add(i, rays[i]);
      passes.behind.add(i, {*behind, {element}});
    } else {
      passes.others.add(i, rays[i]);
    }
  }
  return passes;
}

}  // namespace

render::Picture by_second_camera(const scene::Scene& scene, const engine::Engine& engine, scene::Resolution size,
                                 std::string_view mirror, std::uint32_t max_depth) {
  const scene::Camera& camera = render::still_camera(scene);
  const auto element = scene.find(mirror);
  if (!element) throw std::domain_error(fmt::format("no element is called {}; expected the name of a mirror", mirror));
  const scene::Material& look = look_of(scene, *element, mirror);
  const auto plane = plane_of(scene, *element);
  if (!plane)
    throw std::domain_error(fmt::format("element {} is not flat; expected a plano, disco or triangulo", mirror));

  const MirrorPasses passes = passes_of(engine, size, camera, *element, *plane);
  render::Picture picture(size);
  const auto add = [&](const PixelRays& of, const glm::dvec3& share, std::uint32_t depth) {
    const auto brought = render::brought(scene, engine, of.rays, {depth});
    for (std::size_t i = 0; i < brought.size(); ++i) picture.rgb[of.pixels[i]] += share * brought[i].color;
  };
  add(passes.others, glm::dvec3(1), max_depth);
  add(passes.mirror, glm::dvec3(1), 1);
  add(passes.behind, look.k_ps * look.M_PS, max_depth - 1);
  return picture;
}

}  // namespace durero::raster
