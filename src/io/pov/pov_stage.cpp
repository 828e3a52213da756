#include "pov_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include "durero/io/json/whole_number.hpp"
#include "durero/io/number_text.hpp"
#include "durero/scene/stage.hpp"
#include "durero/text/shown.hpp"
#include "io/cursor.hpp"
#include "io/json/stage_fields.hpp"
#include "io/losses.hpp"

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
  else if (in_.take("#declare") || in_.take("#local"))
    read_declaration();
  else
    return false;
  return true;
}

void PovStage::read_camera() {
  if (stage_.camera) in_.fail(in_.offset(), "a second camera", "expected one");
  const auto [camera, is_exact] = read_pov_camera(in_, version_, stage_.resolution);
  camera_changed_ = !is_exact;
  stage_.camera = camera;
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
  return take_all({"}", "scale", "2", "translate", "<", "0", ",", "-1", ",", "0", ">", "}", "}"}) ? std::optional(sky)
                                                                                                  : std::nullopt;
}

void PovStage::name_losses(std::vector<std::string>& lost) const {
  add_loss(lost, camera_changed_ ? 1 : 0, "camera", "cameras",
           "changed: a scene's has square pixels and right angles, and mirrors nothing");
  add_loss(lost, parallels_, "parallel light", "parallel lights",
           "read as directional: a scene has none that some things stand behind");
  add_loss(lost, skies_, "sky_sphere", "sky_spheres", "left out");
  add_loss(lost, settings_, "global setting", "global settings", "left out: a scene has none such");
  const bool is_told = gamma_ && gamma_->power;
  add_loss(lost, numbers_, "colour or share of light", "colours and shares of light",
           (is_told ? fmt::format("made linear from assumed_gamma {}", *gamma_->power)
                    : std::string("made linear from sRGB, which POV-Ray shows as they stand here")) +
               ": sums and slopes of light are other than its own");
  add_loss(lost, versions_, "#version", "#versions", "read as 3.7");
  add_loss(lost, declarations_, "declaration", "declarations", "left out, of textures and their parts");
}

}  // namespace durero::io
