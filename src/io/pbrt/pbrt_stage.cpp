#include "pbrt_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <limits>
#include <utility>

#include "durero/io/json/whole_number.hpp"
#include "durero/text/shown.hpp"
#include "io/placed/placed_camera.hpp"

namespace durero::io {
namespace {

/// The size of a picture where nobody says.
constexpr scene::Resolution usual_film{1280, 720};

std::uint32_t film_side(const PbrtParameters& parameters, std::string_view name, std::uint32_t usual) {
  const double pixels = parameters.number(name, usual);
  if (!is_whole(pixels, 1, most_pixels))
    parameters.find(name)->place.fail(fmt::format("{} is {}", name, pixels),
                                      "expected a whole number of pixels, 1 to 65535");
  return static_cast<std::uint32_t>(pixels);
}

bool is_in_reach(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// The vertical angle that a window across the screen shows of a camera; nothing where it is not even, or of another
/// form than the picture.
std::optional<double> angle_of_window(double fov, const std::vector<double>& window, scene::Resolution size) {
  constexpr double as_written = 1e-6;
  if (window.size() != 4 || window[0] != -window[1] || window[2] != -window[3] || !(window[3] > 0)) return std::nullopt;
  const double form = static_cast<double>(size.width) / size.height;
  if (std::abs(window[1] / window[3] - form) > as_written * form) return std::nullopt;
  return glm::degrees(2 * std::atan(std::tan(glm::radians(fov) / 2) * window[3]));
}

}  // namespace

void PbrtStage::read_film(const PbrtParameters& parameters) {
  size_ = {film_side(parameters, "xresolution", usual_film.width),
           film_side(parameters, "yresolution", usual_film.height)};
}

void PbrtStage::read_camera(const std::string& type, const PbrtParameters& parameters,
                            std::optional<AffinePlacement> frame) {
  fov_ = parameters.number("fov", 90);
  aperture_ = 2 * parameters.number("lensradius", 0);
  focus_ = parameters.number("focaldistance", 1e6);
  if (const PbrtParameter* const window = parameters.find("screenwindow")) window_ = window->numbers;
  const bool is_stretched = parameters.find("frameaspectratio") != nullptr;
  if (type == "perspective" && frame && !is_stretched)
    frame_ = std::move(frame);
  else
    ++cameras_;
}

void PbrtStage::finish() {
  stage_.resolution = size_;
  if (!frame_) return;
  const scene::Resolution size = size_.value_or(usual_film);
  const auto fov_y =
      window_.empty() ? vertical_angle(fov_, AngleAcross::smaller, size) : angle_of_window(fov_, window_, size);
  const bool is_lens = aperture_ >= 0 && focus_ > 0 && std::isfinite(focus_);
  auto camera = fov_y && view_angle.holds(*fov_y) && is_lens ? placed_camera(*frame_, *fov_y, true) : std::nullopt;
  if (!camera) {
    ++cameras_;
    return;
  }
  if (aperture_ > 0) {
    camera->aperture = aperture_;
    camera->focus = focus_;
  }
  stage_.resolution = size;
  stage_.camera = *camera;
}

void PbrtStage::read_light(const std::string& type, const PbrtParameters& parameters, const AffinePlacement& by) {
  const glm::dvec3 from = parameters.triple("from", glm::dvec3(0)), to = parameters.triple("to", {0, 0, 1});
  const bool has_picture = parameters.find("filename") != nullptr || parameters.find("mapname") != nullptr;
  if (type == "point") {
    const glm::dvec3 at = by.map.point(from, 1);
    if (is_in_reach(at)) stage_.lights.push_back({at, looks_.light(parameters, "I", 1)});
    ++(is_in_reach(at) ? faded_ : left_out_["point beyond binary64"]);
  } else if (type == "distant") {
    const glm::dvec3 way = by.map.linear().point(to - from, 1);
    if (way == glm::dvec3(0) || !is_in_reach(way))
      ++left_out_["distant of no direction"];
    else
      stage_.directional_lights.push_back({way, looks_.light(parameters, "L", 1)});
  } else if (type == "infinite" && !has_picture) {
    stage_.background = looks_.light(parameters, "L", 1);
  } else if (type == "spot") {
    add_spot(parameters, by);
  } else {
    ++left_out_[type];
  }
}

void PbrtStage::add_spot(const PbrtParameters& parameters, const AffinePlacement& by) {
  scene::Light light{by.map.point(parameters.triple("from", glm::dvec3(0)), 1), looks_.light(parameters, "I", 1)};
  scene::LightCone cone{by.map.point(parameters.triple("to", {0, 0, 1}), 1)};
  cone.outer = parameters.number("coneangle", 30);
  cone.inner = cone.outer - parameters.number("conedeltaangle", 5);
  if (!outer_angle.holds(cone.outer) || !inner_angle.holds(cone.inner) || cone.inner > cone.outer ||
      !is_in_reach(light.position) || !is_in_reach(cone.towards) || cone.towards == light.position) {
    ++left_out_["spot of another form"];
    return;
  }
  light.cone = cone;
  stage_.lights.push_back(light);
  ++faded_;
}

void PbrtStage::name_losses(std::vector<std::string>& lost) const {
  add_loss(lost, cameras_, "camera", "cameras",
           "left out: a scene has perspective cameras whose pixels are square and about the view");
  add_loss(lost, faded_, "light", "lights", "as bright at every distance: in pbrt it fades");
  for (const auto& [type, count] : left_out_)
    add_loss(lost, count, fmt::format("light {}", text::shown(type)), fmt::format("lights {}", text::shown(type)),
             "left out: a scene has none");
}

}  // namespace durero::io
