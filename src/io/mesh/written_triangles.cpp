#include "written_triangles.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "durero/scene/stage.hpp"
#include "io/blur_losses.hpp"
#include "io/losses.hpp"

namespace durero::io {

void add_nesting_loss(std::vector<std::string>& lost, const scene::Groups& groups, std::string_view one) {
  const auto within =
      std::ranges::count_if(groups.table(), [&](const auto& group) { return !groups.of_group(group.first).empty(); });
  add_loss(lost, static_cast<std::size_t>(within), "place of a group in another", "places of groups in others",
           fmt::format("left out: {} is in none", one));
}

void add_smoothness_loss(std::vector<std::string>& lost, const scene::Scene& scene, std::string_view why) {
  std::size_t smooth = 0;
  for (std::uint32_t i = 0; i < scene.shapes<scene::Triangle>().size(); ++i)
    smooth += scene.vertex_normals({model::Tipo::soy_triangulo, i}).has_value();
  add_loss(lost, smooth, "smooth triangle", "smooth triangles", fmt::format("written flat: {}", why));
}

void add_wrap_losses(std::vector<std::string>& lost, const scene::Scene& scene, std::string_view format,
                     bool keeps_uv) {
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
  add_wrap_losses(lost, scene, format, keeps_uv);
  add_loss(lost, stage.lights.size() + stage.directional_lights.size(), "light", "lights", none);
  add_loss(lost, stage.camera.has_value(), "camera", "cameras", none);
  add_loss(lost, stage.resolution.has_value(), "resolution", "resolutions", none);
  add_loss(lost, stage.background.has_value(), "background", "backgrounds", none);
  add_loss(lost, stage.environment.has_value(), "environment", "environments", none);
  add_loss(lost, stage.max_depth.has_value(), "max_depth", "max_depths", none);
  add_blur_losses(lost, scene, format);
}

}  // namespace durero::io
