#include "written_triangles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "durero/scene/stage.hpp"
#include "io/blur_losses.hpp"
#include "io/losses.hpp"

namespace durero::io {
namespace {

/// A name's order: what stands before its last digits, then these as a number, then the whole name.
auto order_of(std::string_view name) {
  const std::string_view stem = name.substr(0, name.find_last_not_of("0123456789") + 1);
  std::string_view digits = name.substr(stem.size());
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return std::tuple(stem, digits.size(), digits, name);
}

}  // namespace

std::vector<WrittenTriangle> written_triangles(const scene::Scene& scene, const scene::Groups& groups) {
  std::vector<WrittenTriangle> triangles;
  for (std::uint32_t i = 0; i < scene.shapes<scene::Triangle>().size(); ++i) {
    const scene::ElementRef element{model::Tipo::soy_triangulo, i};
    std::string name = scene.name(element).name();
    const std::string_view group = groups.of_element(name);
    triangles.push_back({element, group, std::move(name)});
  }
  std::ranges::sort(triangles, {}, [](const WrittenTriangle& triangle) {
    return std::tuple(triangle.group, order_of(triangle.name));
  });
  return triangles;
}

void add_nesting_loss(std::vector<std::string>& lost, const scene::Groups& groups, std::string_view one) {
  const auto within =
      std::ranges::count_if(groups.table(), [&](const auto& group) { return !groups.of_group(group.first).empty(); });
  add_loss(lost, static_cast<std::size_t>(within), "place of a group in another", "places of groups in others",
           fmt::format("left out: {} is in none", one));
}

void add_mesh_losses(std::vector<std::string>& lost, const scene::Scene& scene, std::string_view format,
                     bool keeps_uv) {
  const scene::Stage& stage = scene.stage();
  const std::string none = fmt::format("left out: {} has none", format);
  const std::size_t triangles = scene.shapes<scene::Triangle>().size();
  add_loss(lost, scene.size() - triangles, "element", "elements",
           fmt::format("left out: {} has triangles alone", format));
  add_loss(lost, triangles, "name of an element", "names of elements", none);
  add_loss(lost, stage.materials.size(), "material", "materials", none);
  add_loss(lost, stage.textures.size(), "texture", "textures", none);
  std::size_t wrapped = 0, with_tangents = 0;
  scene.for_each([&](scene::ElementRef element, const auto&) {
    const auto wrap = scene.wrap(element);
    wrapped += wrap.has_value();
    with_tangents += wrap && wrap->tangents;
  });
  if (!keeps_uv)
    add_loss(lost, wrapped, "uv of a triangle", "uv of triangles",
             fmt::format("left out: they are not written to {}", format));
  add_loss(lost, with_tangents, "triangle with tangents", "triangles with tangents", "written without them");
  add_loss(lost, stage.lights.size() + stage.directional_lights.size(), "light", "lights", none);
  add_loss(lost, stage.camera.has_value(), "camera", "cameras", none);
  add_loss(lost, stage.resolution.has_value(), "resolution", "resolutions", none);
  add_loss(lost, stage.background.has_value(), "background", "backgrounds", none);
  add_loss(lost, stage.environment.has_value(), "environment", "environments", none);
  add_loss(lost, stage.max_depth.has_value(), "max_depth", "max_depths", none);
  add_blur_losses(lost, scene, format);
}

}  // namespace durero::io
