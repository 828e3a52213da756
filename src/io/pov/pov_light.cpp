#include "pov_light.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "durero/contract/contract.hpp"
#include "durero/scene/axes_across.hpp"
#include "io/json/stage_fields.hpp"

namespace durero::io {
namespace {

using scene::LightExtent;
using scene::LightShape;

/// Lamps along each side of an area_light that is written.
constexpr int lamps = 9;

/// The parts of a light_source behind its colour, in any order.
struct LightParts {
  bool parallel = false, spotlight = false, circular = false, orient = false;
  bool is_other = false;  // a light that no scene has
  std::size_t left_out = 0;
  PovTransform moved{};
  std::optional<glm::dvec3> point_at{};
  std::optional<std::array<glm::dvec3, 2>> area{};
  scene::LightCone cone{.towards = glm::dvec3(0)};
};

void read_area(PovWords& in, LightParts& parts) {
  auto& [first, second] = parts.area.emplace();
  first = in.triple("area_light");
  in.comma();
  second = in.triple("area_light");
  for (int side = 0; side < 2; ++side) {
    in.comma();
    in.number("area_light");
  }
}

/// Reads a number; a light is another where a scene's breaks the rule.
void read_number(PovWords& in, std::string_view word, const Rule<double>& rule, double& value, LightParts& parts) {
  value = in.number(word);
  parts.is_other |= !rule.holds(value);
}

/// Words of what a light of a scene has not, with what stands behind them.
constexpr std::string_view other_parts[] = {
    "shadowless", "media_interaction", "media_attenuation", "looks_like", "fade_distance",
    "fade_power", "fade_color",        "projected_through", "photons",    "groups"};

/// Reads one part, if one stands here.
bool read_part(PovWords& in, LightParts& parts) {
  for (const auto& [word, flag] :
       {std::pair{"parallel", &LightParts::parallel}, std::pair{"spotlight", &LightParts::spotlight},
        std::pair{"circular", &LightParts::circular}, std::pair{"orient", &LightParts::orient}})
    if (in.take(word)) return parts.*flag = true;
  if (in.take("point_at")) {
    parts.point_at = in.triple("point_at");
  } else if (in.take("radius")) {
    read_number(in, "radius", inner_angle, parts.cone.inner, parts);
  } else if (in.take("falloff")) {
    read_number(in, "falloff", outer_angle, parts.cone.outer, parts);
  } else if (in.take("tightness")) {
    read_number(in, "tightness", from_zero, parts.cone.tightness, parts);
  } else if (in.take("area_light")) {
    read_area(in, parts);
  } else if (in.take("adaptive")) {
    in.number("adaptive");
  } else if (in.take("area_illumination")) {
    if (!in.take("on")) in.take("off");
  } else if (in.take("cylinder")) {
    parts.is_other = true;
  } else if (is_one_of(other_parts, in.word())) {
    ++parts.left_out;
    in.pass();
    in.skip_value();
  } else if (const auto move = take_pov_transform(in)) {
    parts.moved = parts.moved.then(*move);
  } else {
    return in.take("jitter");
  }
  return true;
}

/// The shape of an area_light: a rectangle, a circle across both sides, or one that turns to whoever it shines on.
LightExtent extent_of(const PovWords& in, std::size_t at, const LightParts& parts) {
  const auto& [first, second] = *parts.area;
  const glm::dvec3 across = glm::cross(first, second);
  if (across == glm::dvec3(0))
    in.fail(at, "an area_light has parallel sides", "expected sides with an area between them");
  if (!parts.circular) return {.shape = LightShape::rectangle, .edges = *parts.area};
  const double width = glm::length(first);
  constexpr double as_written = 1e-6;  // of numbers that a text gives with some digits
  if (std::abs(glm::length(second) - width) > as_written * width ||
      std::abs(glm::dot(first, second)) > as_written * width * width)
    in.fail(at, "a circular area_light is no circle", "expected sides of one length, at right angles");
  if (parts.orient) return {.shape = LightShape::sphere, .radius = width / 2};
  return {.shape = LightShape::disc, .radius = width / 2, .normal = glm::normalize(across)};
}

/// The light that the parts make; nothing where no scene has such.
std::optional<std::variant<scene::Light, scene::DirectionalLight>> made_of(const PovWords& in, std::size_t at,
                                                                           const LightParts& parts,
                                                                           scene::Light light) {
  if (parts.is_other || !light_color.holds(light.color)) return std::nullopt;
  if (parts.parallel) {
    const glm::dvec3 way = parts.point_at.value_or(glm::dvec3(0)) - light.position;
    if (parts.spotlight || parts.area || !direction.holds(way)) return std::nullopt;
    return scene::DirectionalLight{way, light.color};
  }
  if (parts.spotlight) {
    light.cone = parts.cone;
    light.cone->towards = parts.point_at.value_or(light.position + glm::dvec3(0, 0, 1));
    if (light.cone->inner > light.cone->outer || light.cone->towards == light.position) return std::nullopt;
  }
  if (parts.area) light.extent = extent_of(in, at, parts);
  return light;
}

std::string area_text(const glm::dvec3& first, const glm::dvec3& second, std::string_view more) {
  return fmt::format(" area_light <{}, {}, {}>, <{}, {}, {}>, {}, {} jitter area_illumination{}", first.x, first.y,
                     first.z, second.x, second.y, second.z, lamps, lamps, more);
}

std::string extent_text(const LightExtent& extent) {
  const double width = 2 * extent.radius;
  switch (extent.shape) {
    case LightShape::point:
    case LightShape::triangle:
      return "";
    case LightShape::disc: {
      const auto [first, second] = scene::axes_across(glm::normalize(extent.normal));
      return area_text(width * first, width * second, " circular");
    }
    case LightShape::sphere:
      return area_text({width, 0, 0}, {0, width, 0}, " circular orient");
    case LightShape::rectangle:
      return area_text(extent.edges[0], extent.edges[1], "");
  }
  contract::unreachable();
}

}  // namespace

PovLight read_pov_light(PovWords& in) {
  const std::size_t at = in.offset();
  scene::Light light{};
  light.position = in.triple("light_source");
  in.comma();
  light.color = in.color("light_source").rgb;
  LightParts parts;
  while (!in.take("}")) {
    in.comma();
    if (!read_part(in, parts))
      in.fail_here(
          "expected one of parallel, spotlight, point_at, radius, falloff, tightness, area_light, adaptive, jitter, "
          "circular, orient, area_illumination, translate, rotate, scale, matrix, transform, or }");
  }
  auto made = made_of(in, at, parts, light);
  if (made) move_light(*made, parts.moved);
  return {std::move(made), parts.left_out};
}

void move_light(std::variant<scene::Light, scene::DirectionalLight>& light, const PovTransform& by) {
  if (by.is_identity()) return;
  if (auto* const far = std::get_if<scene::DirectionalLight>(&light)) {
    far->direction = by.direction(far->direction);
    return;
  }
  auto& near = std::get<scene::Light>(light);
  near.position = by.point(near.position);
  if (near.cone) near.cone->towards = by.point(near.cone->towards);
  for (glm::dvec3& edge : near.extent.edges) edge = by.direction(edge);
  near.extent.radius *= by.scale.value_or(1);
  if (near.extent.normal != glm::dvec3(0)) near.extent.normal = glm::normalize(by.normal(near.extent.normal));
}

std::string pov_light(const scene::Light& light) {
  const glm::dvec3 &p = light.position, &c = light.color;
  std::string text = fmt::format("light_source {{ <{}, {}, {}>, rgb <{}, {}, {}>", p.x, p.y, p.z, c.x, c.y, c.z);
  if (const auto& cone = light.cone)
    text += fmt::format(" spotlight point_at <{}, {}, {}> radius {} falloff {} tightness {}", cone->towards.x,
                        cone->towards.y, cone->towards.z, cone->inner, cone->outer, cone->tightness);
  return text + extent_text(light.extent) + " }\n";
}

}  // namespace durero::io
