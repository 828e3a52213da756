#include "pov_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>
#include <variant>

#include "durero/io/json/whole_number.hpp"
#include "durero/io/number_text.hpp"
#include "durero/scene/stage.hpp"
#include "durero/text/shown.hpp"
#include "io/cursor.hpp"
#include "io/json/stage_fields.hpp"
#include "io/losses.hpp"
#include "pov_light.hpp"

namespace durero::io {

std::optional<scene::Resolution> pov_size(const Source& source) {
  const auto line = Lines(source.text()).next();
  if (!line || !source.text().starts_with("//")) return std::nullopt;
  scene::Resolution size{};
  for (WordCursor in(source, *line); !in.done(); in.skip_blanks()) {
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
  else
    return false;
  return true;
}

/// Of several POV-Ray takes the last.
void PovStage::read_camera() {
  const auto read = read_pov_camera(in_, version_, told_size_);
  if (!read) {
    ++cameras_;
    return;
  }
  camera_changed_ = !read->is_exact;
  stage_.camera = read->camera;
  stage_.resolution = read->size;
}

void PovStage::read_light() {
  in_.expect("{", "behind light_source");
  add(read_pov_light(in_), {});
}

void PovStage::add(PovLight light, const PovTransform& by) {
  settings_ += light.left_out;
  if (!light.light) {
    ++lights_;
    return;
  }
  move_light(*light.light, by);
  if (const auto* const near = std::get_if<scene::Light>(&*light.light)) {
    if (!near->extent.is_point()) ++areas_;
    stage_.lights.push_back(*near);
  } else {
    stage_.directional_lights.push_back(std::get<scene::DirectionalLight>(*light.light));
    ++parallels_;
  }
}

void PovStage::read_background() {
  in_.pass();
  in_.expect("{", "behind background");
  const glm::dvec3 color = in_.color("background").rgb;
  in_.expect("}", "behind the colour of a background");
  if (light_color.holds(color))
    stage_.background = color;
  else
    ++settings_;
}

void PovStage::read_settings() {
  in_.expect("{", "behind global_settings");
  while (!in_.take("}")) read_setting();
}

void PovStage::read_setting() {
  const std::size_t at = in_.offset();
  if (in_.take("max_trace_level")) {
    const double level = in_.number("max_trace_level");
    if (is_whole(level, 1, scene::greatest_depth))
      stage_.max_depth = static_cast<std::uint32_t>(level);
    else
      ++settings_;
  } else if (in_.take("assumed_gamma")) {
    read_gamma(at);
  } else if (in_.take("adc_bailout")) {
    if (in_.number("adc_bailout") != 0) ++settings_;
  } else {
    if (in_.done()) in_.fail_here("expected } for each {");
    if (in_.word() != "{") in_.pass();
    in_.skip_value();
    ++settings_;
  }
}

/// Of two POV-Ray takes the first.
void PovStage::read_gamma(std::size_t at) {
  const std::size_t number_at = in_.offset();
  PovGamma gamma;
  if (!in_.take("srgb")) {
    gamma.power = in_.number("assumed_gamma");
    if (!(*gamma.power > 0))
      in_.fail(number_at, fmt::format("assumed_gamma is {}", *gamma.power), "expected a number above 0, or srgb");
  }
  if (gamma_) {
    ++settings_;
    return;
  }
  gamma_ = gamma;
  gamma_at_ = at;
}

/// The last one is that of the whole text, as POV-Ray has it.
void PovStage::read_version() {
  in_.take("unofficial");
  version_ = in_.number("#version");
  if (*version_ != 3.7) ++versions_;
  in_.take(";");
}

void PovStage::make_linear() {
  const PovGamma gamma = gamma_.value_or(default_gamma(version_));
  const auto changed = io::make_linear(gamma, stage_);
  if (!changed) in_.fail(gamma_at_, "the light of a colour is beyond binary64", "expected colours of finite light");
  numbers_ = *changed;
  gamma_ = gamma;
}

void PovStage::read_sky() {
  in_.expect("{", "behind sky_sphere");
  const PovWords begin = in_;
  if (auto sky = read_gradient()) {
    stage_.environment = std::move(sky);
  } else {
    in_.stand_where(begin);
    in_.skip_block();
    ++skies_;
  }
}

/// A sky that goes from one colour straight below to another straight above, as it is written to POV-Ray; nothing of
/// another, of which part has been passed.
std::optional<scene::Environment> PovStage::read_gradient() {
  scene::Environment sky;
  const auto take_all = [&](std::initializer_list<std::string_view> words) {
    return std::ranges::all_of(words, [&](std::string_view word) { return in_.take(word); });
  };
  if (!take_all({"pigment", "{", "gradient", "y", "color_map", "{"})) return std::nullopt;
  for (std::size_t end = 0; end < 2; ++end) {
    if (!take_all({"["}) || in_.take_number() != double(end) || in_.word() != "rgb") return std::nullopt;
    const glm::dvec3& color = sky.colors[end] = in_.color("sky_sphere").rgb;
    if (!(std::min({color.x, color.y, color.z}) >= 0) || !take_all({"]"})) return std::nullopt;
  }
  return take_all({"}", "scale", "2", "translate", "<", "0", ",", "-", "1", ",", "0", ">", "}", "}"})
             ? std::optional(sky)
             : std::nullopt;
}

void PovStage::name_losses(std::vector<std::string>& lost) const {
  add_loss(lost, camera_changed_ ? 1 : 0, "camera", "cameras", "changed: a scene's has square pixels and right angles");
  add_loss(lost, cameras_, "camera", "cameras", "left out: a scene's sees by straight rays from one point");
  add_loss(lost, lights_, "light_source", "light_sources", "left out: no light of a scene is such");
  add_loss(lost, parallels_, "parallel light", "parallel lights",
           "read as directional: a scene has none that some things stand behind");
  add_loss(lost, areas_, "area_light", "area_lights",
           "read as a light of some size: a scene's shine from all of their points, and not from a grid of lamps");
  add_loss(lost, skies_, "sky_sphere", "sky_spheres", "left out");
  add_loss(lost, settings_, "global setting", "global settings", "left out: a scene has none such");
  const bool is_told = gamma_ && gamma_->power;
  add_loss(lost, numbers_, "colour or share of light", "colours and shares of light",
           (is_told ? fmt::format("made linear from assumed_gamma {}", *gamma_->power)
                    : std::string("made linear from sRGB, which POV-Ray shows as they stand here")) +
               ": sums and slopes of light are other than its own");
  add_loss(lost, versions_, "#version", "#versions", "read as 3.7");
}

}  // namespace durero::io
