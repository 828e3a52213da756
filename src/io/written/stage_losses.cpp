#include "stage_losses.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "durero/scene/stage.hpp"
#include "io/losses.hpp"

namespace durero::io {

void add_stage_losses(std::vector<std::string>& lost, const scene::Scene& scene, std::string_view format) {
  const scene::Stage& stage = scene.stage();
  const std::string not_written = fmt::format("left out: not written to {}", format);
  if (!stage.camera) lost.emplace_back("no camera in the scene: no view was written");
  add_loss(lost, !stage.camera && stage.resolution, "resolution", "resolutions", "left out: it is part of a view");
  add_loss(lost, stage.textures.size(), "texture", "textures", not_written);
  add_loss(lost, stage.environment.has_value(), "environment", "environments", not_written);
  add_loss(lost, stage.max_depth.has_value(), "max_depth", "max_depths", not_written);
}

void add_empty_group_losses(std::vector<std::string>& lost, const scene::Groups& groups) {
  const auto empty = std::ranges::count_if(
      groups.table(), [](const auto& one) { return one.second.elementos.empty() && one.second.groups.empty(); });
  add_loss(lost, static_cast<std::size_t>(empty), "group", "groups", "left out: nothing is in it");
}

}  // namespace durero::io
