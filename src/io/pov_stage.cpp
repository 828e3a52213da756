#include "pov_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <stdexcept>

#include "cursor.hpp"
#include "durero/io/number_text.hpp"
#include "durero/io/whole_number.hpp"
#include "durero/scene/camera.hpp"
#include "durero/text/shown.hpp"
#include "losses.hpp"
#include "stage_fields.hpp"

namespace durero::io {
namespace {

struct CameraPart {
  std::string_view word;
  glm::dvec3 PovCamera::*member;
};
constexpr CameraPart camera_parts[] = {{"location", &PovCamera::location},
                                       {"direction", &PovCamera::direction},
                                       {"right", &PovCamera::right},
                                       {"up", &PovCamera::up},
                                       {"sky", &PovCamera::sky}};

/// Whether the pixels of a scene's camera have the rays of this one, to a thousandth of a pixel: for a line that tells
/// of it, and no more.
bool has_rays_of(const scene::Camera& made, const PovCamera& camera, scene::Resolution size) {
  const scene::PrimaryRays rays(made, size);
  const double distance = glm::length(camera.direction), pixel = glm::length(camera.up) / distance / size.height;
  const auto is_at = [&](double x, double y) {
    const glm::dvec3 there = (camera.direction + x * camera.right - y * camera.up) / distance;
    const glm::dvec3 here = rays.ray_at((x + 0.5) * size.width - 0.5, (y + 0.5) * size.height - 0.5).v().xyz();
    return glm::distance(here, there) < pixel / 1000;
  };
  return is_at(-0.5, -0.5) && is_at(0.5, -0.5) && is_at(-0.5, 0.5);
}

/// So far ahead that the place keeps the direction: the sum is rounded by no more than the numbers of both are.
glm::dvec3 ahead(const PovCamera& camera) {
  const auto greatest = [](const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); };
  const double from = greatest(camera.location), by = greatest(camera.direction);
  const int doublings = from > by && by > 0 ? std::ilogb(from) - std::ilogb(by) + 1 : 0;
  return camera.location + std::ldexp(1, doublings) * camera.direction;
}

}  // namespace

std::optional<scene::Resolution> pov_size(const Source& source) {
  const auto line = Lines(source.text()).next();
  if (!line || !source.text().starts_with("//")) return std::nullopt;
  scene::Resolution size{};
  for (Cursor in(source, *line); !in.done(); in.skip_blanks()) {
    const std::string_view word = in.word("");
    for (const auto& [letters, side] : {std::pair{"Ww", &size.width}, std::pair{"Hh", &size.height}}) {
      if (word.size() < 3 || std::string_view("+-").find(word[0]) == word.npos ||
          std::string_view(letters).find(word[1]) == word.npos)
        continue;
      const auto pixels = read_finite(word.substr(2));
      if (pixels && is_whole(*pixels, 1, most_pixels)) *side = static_cast<std::uint32_t>(*pixels);
    }
  }
  return size.width > 0 && size.height > 0 ? std::optional(size) : std::nullopt;
}

bool PovStage::read() {
  if (in_.word() == "camera")
    read_camera();
  else if (in_.take("light_source"))
    read_light();
  else if (in_.word() == "background")
    read_background();
  else if (in_.take("global_settings"))
    read_settings();
  else if (in_.take("sky_sphere"))
    read_sky();
  else if (in_.take("#version"))
    read_version();
  else if (in_.take("#declare") || in_.take("#local"))
    read_declaration();
  else
    return false;
  return true;
}

void PovStage::read_camera() {
  const std::size_t at = in_.offset();
  if (stage_.camera) in_.fail(at, "a second camera", "expected one");
  in_.pass();
  in_.expect("{", "behind camera");
  PovCamera camera;
  while (!in_.take("}")) read_camera_part(camera);
  if (camera.look_at == camera.location) in_.fail(at, "the camera looks at its own eye", "expected look_at elsewhere");
  if (camera.look_at) look_at(camera);
  take_camera(at, camera);
}

void PovStage::read_camera_part(PovCamera& camera) {
  const std::size_t at = in_.offset();
  const std::string_view word = in_.word();
  const auto* const part = std::ranges::find(camera_parts, word, &CameraPart::word);
  if (part != std::end(camera_parts)) {
    if (camera.is_turned && word != "location") in_.fail_here("expected it before look_at and angle, which turn it");
    in_.pass();
    camera.*part->member = in_.triple(word);
  } else if (in_.take("angle")) {
    const double angle = in_.number("angle");
    check_rule(in_, at, "angle", view_angle, angle);
    const double distance = glm::length(camera.right) / 2 / std::tan(glm::radians(angle) / 2);
    camera.direction *= distance / glm::length(camera.direction);
    camera.is_turned = true;
  } else if (in_.take("look_at")) {
    camera.look_at = in_.triple("look_at");
    camera.is_turned = true;
  } else if (!in_.take("perspective")) {
    in_.fail_here("expected one of location, direction, right, up, sky, angle, look_at, or }: no other camera is read");
  }
}

/// Turns it to that point, as POV-Ray does: all keep their lengths, and what is right of the way stays there.
void PovStage::look_at(PovCamera& camera) {
  const double hand = glm::dot(glm::cross(camera.up, camera.direction), camera.right) < 0 ? -1 : 1;
  const auto along = [](const glm::dvec3& way, const glm::dvec3& of) {
    return glm::length(of) / glm::length(way) * way;
  };
  camera.direction = along(*camera.look_at - camera.location, camera.direction);
  camera.right = along(hand * glm::cross(camera.sky, camera.direction), camera.right);
  camera.up = along(hand * glm::cross(camera.direction, camera.right), camera.up);
}

void PovStage::take_camera(std::size_t at, const PovCamera& camera) {
  const double fov_y = glm::degrees(2 * std::atan(glm::length(camera.up) / 2 / glm::length(camera.direction)));
  const scene::Camera made{camera.location, camera.look_at.value_or(ahead(camera)),
                           camera.look_at ? camera.sky : camera.up, fov_y};
  try {
    camera_changed_ = !has_rays_of(made, camera, stage_.resolution.value_or(scene::default_resolution));
  } catch (const std::domain_error& error) {
    const std::string what = error.what();  // X; expected Y
    const std::size_t middle = what.find("; ");
    in_.fail(at, what.substr(0, middle), what.substr(middle + 2));
  }
  stage_.camera = made;
}

void PovStage::read_light() {
  in_.expect("{", "behind light_source");
  const std::size_t at = in_.offset();
  const glm::dvec3 position = in_.triple("light_source");
  in_.comma("light_source");
  const glm::dvec3 color = in_.color("light_source").rgb;
  check_rule(in_, at, "the colour of a light_source", light_color, color, &model::Fuente_inv_1);
  if (in_.take("parallel")) {
    const glm::dvec3 way = (in_.take("point_at") ? in_.triple("point_at") : glm::dvec3(0)) - position;
    check_rule(in_, at, "the way of a parallel light", direction, way);
    stage_.directional_lights.push_back({way, color});
    ++parallels_;
  } else {
    stage_.lights.push_back({position, color});
  }
  if (!in_.take("}")) in_.fail_here("expected }, or parallel and point_at: no other light_source is read");
}

void PovStage::read_background() {
  const std::size_t at = in_.offset();
  if (stage_.background) in_.fail(at, "a second background", "expected one");
  in_.pass();
  in_.expect("{", "behind background");
  stage_.background = in_.color("background").rgb;
  check_rule(in_, at, "background", light_color, *stage_.background);
  in_.expect("}", "behind the colour of a background");
}

void PovStage::read_settings() {
  in_.expect("{", "behind global_settings");
  while (!in_.take("}")) read_setting();
}

void PovStage::read_setting() {
  const std::size_t at = in_.offset();
  if (in_.take("max_trace_level")) {
    const double level = in_.number("max_trace_level");
    if (!is_whole(level, 1, scene::greatest_depth))
      in_.fail(at, fmt::format("max_trace_level is {}", level), "expected a whole number of rays in a row, 1 to 1000");
    stage_.max_depth = static_cast<std::uint32_t>(level);
  } else if (in_.take("assumed_gamma")) {
    if (in_.number("assumed_gamma") != 1) ++settings_;
  } else if (in_.take("adc_bailout")) {
    if (in_.number("adc_bailout") != 0) ++settings_;
  } else {
    if (in_.done()) in_.fail_here("expected } for each {");
    if (in_.word() != "{") in_.pass();
    in_.skip_value();
    ++settings_;
  }
}

void PovStage::read_version() {
  if (in_.number("#version") != 3.7) ++versions_;
  in_.take(";");
}

void PovStage::read_declaration() {
  static constexpr std::array<std::string_view, 13> blocks{
      "function",  "texture",     "pigment",    "normal",      "finish",    "interior",  "material",
      "color_map", "pigment_map", "normal_map", "texture_map", "slope_map", "colour_map"};
  static constexpr std::array<std::string_view, 5> colors{"color", "colour", "rgb", "rgbf", "rgbt"};
  if (in_.done()) in_.fail_here("expected a name behind #declare");
  in_.pass();
  in_.expect("=", "behind the name of a declaration");
  const std::string_view kind = in_.word();
  if (is_one_of(colors, kind)) {
    in_.color("#declare");
  } else if (is_one_of(blocks, kind)) {
    in_.pass();
    if (in_.take("("))
      while (!in_.done() && !in_.take(")")) in_.pass();
    in_.expect("{", fmt::format("behind {}", kind));
    in_.skip_block();
  } else {
    in_.fail_here("expected a colour, a function, a texture, or what is part of one: no other declaration is read");
  }
  in_.take(";");
  ++declarations_;
}

void PovStage::read_sky() {
  in_.expect("{", "behind sky_sphere");
  in_.skip_block();
  ++skies_;
}

void PovStage::name_losses(std::vector<std::string>& lost) const {
  add_loss(lost, camera_changed_ ? 1 : 0, "camera", "cameras",
           "changed: a scene's has square pixels and right angles, and mirrors nothing");
  add_loss(lost, parallels_, "parallel light", "parallel lights",
           "read as directional: a scene has none that some things stand behind");
  add_loss(lost, skies_, "sky_sphere", "sky_spheres", "left out");
  add_loss(lost, settings_, "global setting", "global settings", "left out: a scene has none such");
  add_loss(lost, versions_, "#version", "#versions", "read as 3.7");
  add_loss(lost, declarations_, "declaration", "declarations", "left out, of textures and their parts");
}

}  // namespace durero::io
