#include "mitsuba_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <optional>
#include <utility>

#include "durero/io/json/whole_number.hpp"
#include "durero/io/number_text.hpp"
#include "durero/scene/camera.hpp"
#include "durero/text/nearest.hpp"
#include "durero/text/shown.hpp"
#include "io/placed/placed_camera.hpp"

namespace durero::io {
namespace {

constexpr std::array<std::pair<std::string_view, AngleAcross>, 5> angle_sides{{{"x", AngleAcross::width},
                                                                               {"y", AngleAcross::height},
                                                                               {"smaller", AngleAcross::smaller},
                                                                               {"larger", AngleAcross::larger},
                                                                               {"diagonal", AngleAcross::diagonal}}};

AngleAcross angle_side(const MitsubaNode& node) {
  const std::string_view word = node.required("value");
  const auto* const found = std::ranges::find(angle_sides, word, &std::pair<std::string_view, AngleAcross>::first);
  if (found == angle_sides.end())
    node.fail(fmt::format("{} as fov_axis", text::shown(word)),
              "expected " + text::expected_of(std::string(word), {"x", "y", "smaller", "larger", "diagonal"}), "value");
  return found->second;
}

/// The angle of a lens of that many millimetres over the diagonal of a picture of 36 mm × 24 mm, in degrees.
double diagonal_angle(double length) { return glm::degrees(2 * std::atan(std::hypot(36, 24) / 2 / length)); }

double angle_of_lens(const MitsubaNode& node) {
  std::string_view text = node.required("value");
  if (text.ends_with("mm")) text.remove_suffix(2);
  const auto length = read_finite(text);
  if (!length || !(*length > 0))
    node.fail(fmt::format("{} as focal_length", text::shown(text)), "expected millimetres above 0", "value");
  return diagonal_angle(*length);
}

std::uint32_t film_pixels(const MitsubaNode& node) {
  const double pixels = mitsuba_number(node);
  if (!is_whole(pixels, 1, most_pixels))
    node.fail(fmt::format("{} is {}", node.name(), pixels), "expected a whole number of pixels, 1 to 65535", "value");
  return static_cast<std::uint32_t>(pixels);
}

double lens_number(const MitsubaNode& node) {
  const double number = mitsuba_number(node);
  if (!(number >= 0)) node.fail(fmt::format("{} is {}", node.name(), number), "expected a number from 0", "value");
  return number;
}

/// The lens and the place of a sensor.
struct Optics {
  AffinePlacement frame{};
  std::optional<double> angle{};  ///< without one the lens is of 50 mm
  AngleAcross side = AngleAcross::width;
  double aperture = 0, focus = 0;
  std::size_t others = 0;
};

Optics optics_of(const MitsubaNode& sensor) {
  Optics optics;
  for (const MitsubaNode& child : sensor.children) {
    const std::string_view name = child.name();
    if (name == "to_world") {
      optics.frame = mitsuba_placement(child);
    } else if (name == "fov") {
      optics.angle = mitsuba_number(child);
    } else if (name == "fov_axis") {
      optics.side = angle_side(child);
    } else if (name == "focal_length") {
      optics.angle = angle_of_lens(child);
      optics.side = AngleAcross::diagonal;
    } else if (name == "aperture_radius") {
      optics.aperture = 2 * lens_number(child);
    } else if (name == "focus_distance") {
      optics.focus = lens_number(child);
    } else {
      optics.others += child.tag != "film";
    }
  }
  return optics;
}

/// The frame of what stands there, or points there; without to_world, where it is simple.
AffinePlacement emitter_frame(const MitsubaNode& node) {
  for (const MitsubaNode& child : node.children)
    if (child.tag == "transform") return mitsuba_placement(child);
  return {};
}

bool is_reachable(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

const MitsubaNode* mitsuba_property(const MitsubaNode& node, std::string_view name) {
  for (const MitsubaNode& child : node.children)
    if (child.name() == name) return &child;
  return nullptr;
}

}  // namespace

/// The size of a picture, which is Mitsuba's own where nobody says.
struct MitsubaStage::Film {
  scene::Resolution size{768, 576};
};

MitsubaStage::Film MitsubaStage::film_of(const MitsubaNode& sensor) {
  Film film;
  for (const MitsubaNode& child : sensor.children) {
    if (child.tag != "film") continue;
    for (const MitsubaNode& part : child.children) {
      if (part.name() == "width")
        film.size.width = film_pixels(part);
      else if (part.name() == "height")
        film.size.height = film_pixels(part);
      else
        ++settings_;
    }
  }
  return film;
}

/// The first sensor is the one that draws the picture.
void MitsubaStage::read_sensor(const MitsubaNode& sensor) {
  if (std::exchange(has_sensor_, true)) {
    ++sensors_;
    return;
  }
  const std::string_view type = sensor.required("type");
  const Film film = film_of(sensor);
  stage_.resolution = film.size;
  const Optics optics = optics_of(sensor);
  settings_ += optics.others;
  const bool is_kept = type == "perspective" || type == "thinlens";
  const auto fov_y = !is_kept       ? std::nullopt
                     : optics.angle ? vertical_angle(*optics.angle, optics.side, film.size)
                                    : vertical_angle(diagonal_angle(50), AngleAcross::diagonal, film.size);
  auto camera = fov_y ? placed_camera(optics.frame, *fov_y, false) : std::nullopt;
  if (!camera) {
    ++cameras_;
    return;
  }
  if (type == "thinlens") {
    camera->aperture = optics.aperture;
    camera->focus = optics.focus;
  }
  stage_.camera = *camera;
}

void MitsubaStage::read_emitter(const MitsubaNode& emitter) {
  const std::string type(emitter.required("type"));
  if (type == "point")
    add_point(emitter);
  else if (type == "spot")
    add_spot(emitter);
  else if (type == "directional")
    add_directional(emitter);
  else if (type == "constant")
    stage_.background = looks_.light(emitter, "radiance", 1);
  else
    ++left_out_[type];
}

void MitsubaStage::add_point(const MitsubaNode& emitter) {
  const MitsubaNode* const place = mitsuba_property(emitter, "position");
  const glm::dvec3 at = place != nullptr ? mitsuba_triple(*place) : emitter_frame(emitter).map.point(glm::dvec3(0), 1);
  if (!is_reachable(at)) emitter.fail("a light beyond binary64", "expected a place in reach");
  stage_.lights.push_back({at, looks_.light(emitter, "intensity", 1)});
  ++faded_;
}

/// A spot shines along its own +z.
void MitsubaStage::add_spot(const MitsubaNode& emitter) {
  const AffinePlacement frame = emitter_frame(emitter);
  const auto angle = [&](std::string_view name, double usual) {
    const MitsubaNode* const told = mitsuba_property(emitter, name);
    return told == nullptr ? usual : mitsuba_number(*told);
  };
  scene::LightCone cone{frame.map.point({0, 0, 1}, 1)};
  cone.outer = angle("cutoff_angle", 20);
  cone.inner = angle("beam_width", cone.outer * 3 / 4);
  scene::Light light{frame.map.point(glm::dvec3(0), 1), looks_.light(emitter, "intensity", 1)};
  if (!outer_angle.holds(cone.outer) || !inner_angle.holds(cone.inner) || cone.inner > cone.outer ||
      !is_reachable(light.position) || !is_reachable(cone.towards) || cone.towards == light.position) {
    ++left_out_["spot of another form"];
    return;
  }
  light.cone = cone;
  stage_.lights.push_back(light);
  ++faded_;
}

void MitsubaStage::add_directional(const MitsubaNode& emitter) {
  const MitsubaNode* const told = mitsuba_property(emitter, "direction");
  const glm::dvec3 way =
      told != nullptr ? mitsuba_triple(*told) : emitter_frame(emitter).map.linear().point({0, 0, 1}, 1);
  if (way == glm::dvec3(0) || !is_reachable(way)) emitter.fail("a light of no direction", "expected one");
  stage_.directional_lights.push_back({way, looks_.light(emitter, "irradiance", 1)});
}

void MitsubaStage::name_losses(std::vector<std::string>& lost) const {
  add_loss(lost, sensors_, "sensor", "sensors", "left out: the first draws the picture");
  add_loss(lost, cameras_, "sensor", "sensors", "left out: a scene has perspective cameras of a told angle");
  add_loss(lost, settings_, "setting of a sensor or a film", "settings of sensors or films",
           "left out: how a picture is drawn, the call says");
  add_loss(lost, faded_, "light", "lights", "as bright at every distance: in Mitsuba it fades");
  for (const auto& [type, count] : left_out_)
    add_loss(lost, count, fmt::format("emitter {}", text::shown(type)), fmt::format("emitters {}", text::shown(type)),
             "left out: a scene has none");
}

}  // namespace durero::io
