#include "pov_camera.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <stdexcept>

#include "durero/scene/camera.hpp"
#include "durero/scene/stage.hpp"
#include "io/json/stage_fields.hpp"

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

/// Cameras whose rays do not go through a plane from one point, and a relief of it.
constexpr std::array<std::string_view, 9> other_cameras{"orthographic", "fisheye",     "ultra_wide_angle",
                                                        "omnimax",      "panoramic",   "cylinder",
                                                        "spherical",    "mesh_camera", "normal"};
/// How the rays through a lens are chosen, which a scene leaves to whoever draws it.
constexpr std::array<std::string_view, 3> blur_words{"blur_samples", "confidence", "variance"};

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

/// The size whose pixels are as near to squares as can be, as wide as the default one; nothing where that is too high
/// or too low.
std::optional<scene::Resolution> form_of(const PovCamera& camera) {
  scene::Resolution size = scene::default_resolution;
  const double height = std::round(size.width * glm::length(camera.up) / glm::length(camera.right));
  if (!(height >= 1 && height <= most_pixels)) return std::nullopt;
  size.height = static_cast<std::uint32_t>(height);
  return size;
}

/// So far ahead that the place keeps the direction: the sum is rounded by no more than the numbers of both are.
glm::dvec3 ahead(const PovCamera& camera) {
  const auto greatest = [](const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); };
  const double from = greatest(camera.location), by = greatest(camera.direction);
  const int doublings = from > by && by > 0 ? std::ilogb(from) - std::ilogb(by) + 1 : 0;
  return camera.location + std::ldexp(1, doublings) * camera.direction;
}

void read_part(PovWords& in, std::optional<double> version, PovCamera& camera) {
  const std::string_view word = in.word();
  const auto* const part = std::ranges::find(camera_parts, word, &CameraPart::word);
  if (part != std::end(camera_parts)) {
    if (camera.look_at && word == "location" && version && *version < 3.5)
      in.fail_here(
          fmt::format("expected it before look_at, which turns the camera where it stands by #version {}", *version));
    in.pass();
    camera.*part->member = in.triple(word);
  } else if (in.take("angle")) {
    camera.angle = in.number("angle");
    camera.is_other |= !view_angle.holds(*camera.angle);
    if (in.take(",")) in.number("angle");
  } else if (in.take("look_at")) {
    camera.look_at = in.triple("look_at");
  } else if (in.take("aperture")) {
    camera.aperture = in.number("aperture");
    camera.is_other |= !from_zero.holds(camera.aperture);
  } else if (in.take("focal_point")) {
    camera.focal_point = in.triple("focal_point");
  } else if (is_one_of(blur_words, word)) {
    in.pass();
    in.skip_value();
  } else if (is_one_of(other_cameras, word)) {
    in.pass();
    in.skip_value();
    camera.is_other = true;
  } else if (const auto move = take_pov_transform(in)) {
    camera.moved = camera.moved.then(*move);
  } else if (!in.take("perspective")) {
    in.fail_here(fmt::format(
        "expected one of location, direction, right, up, sky, angle, look_at, aperture, focal_point, "
        "blur_samples, confidence, variance, perspective, {}, translate, rotate, scale, matrix, transform, or }}",
        fmt::join(other_cameras, ", ")));
  }
}

/// The direction becomes so long that the picture is seen across this angle.
void open_to(double angle, PovCamera& camera) {
  const double distance = glm::length(camera.right) / 2 / std::tan(glm::radians(angle) / 2);
  camera.direction *= distance / glm::length(camera.direction);
}

/// Turns it to that point, as POV-Ray does: all keep their lengths, and what is right of the way stays there.
void turn_to(const glm::dvec3& look_at, PovCamera& camera) {
  const double hand = glm::dot(glm::cross(camera.up, camera.direction), camera.right) < 0 ? -1 : 1;
  const auto along = [](const glm::dvec3& way, const glm::dvec3& of) {
    return glm::length(of) / glm::length(way) * way;
  };
  camera.direction = along(look_at - camera.location, camera.direction);
  camera.right = along(hand * glm::cross(camera.sky, camera.direction), camera.right);
  camera.up = along(hand * glm::cross(camera.direction, camera.right), camera.up);
}

/// Moves all of it.
void move(PovCamera& camera) {
  if (camera.moved.is_identity()) return;
  camera.location = camera.moved.point(camera.location);
  for (std::optional<glm::dvec3>* const point : {&camera.look_at, &camera.focal_point})
    if (*point) **point = camera.moved.point(**point);
  for (glm::dvec3* const way : {&camera.direction, &camera.right, &camera.up, &camera.sky})
    *way = camera.moved.direction(*way);
}

/// Gives a camera its lens, which in POV-Ray is half as wide as its aperture says, and shows sharply the plane of a
/// point. False where that is not before it.
bool set_lens(const PovCamera& camera, scene::Camera& made) {
  made.aperture = camera.aperture / 2;
  if (camera.aperture == 0 || !camera.focal_point) return true;
  made.focus = glm::dot(*camera.focal_point - camera.location, glm::normalize(camera.direction));
  return above_zero.holds(made.focus);
}

}  // namespace

std::optional<ReadCamera> read_pov_camera(PovWords& in, std::optional<double> version,
                                          std::optional<scene::Resolution> size) {
  in.pass();
  in.expect("{", "behind camera");
  PovCamera camera;
  while (!in.take("}")) {
    in.comma();
    if (in.word() != "}") read_part(in, version, camera);
  }
  if (camera.is_other || camera.look_at == camera.location) return std::nullopt;
  if (camera.angle) open_to(*camera.angle, camera);
  if (camera.look_at) turn_to(*camera.look_at, camera);
  move(camera);
  const double fov_y = glm::degrees(2 * std::atan(glm::length(camera.up) / 2 / glm::length(camera.direction)));
  scene::Camera made{camera.location, camera.look_at.value_or(ahead(camera)), camera.look_at ? camera.sky : camera.up,
                     fov_y};
  made.mirrored = glm::dot(glm::cross(camera.direction, camera.up), camera.right) < 0;
  if (!view_angle.holds(fov_y) || !set_lens(camera, made)) return std::nullopt;
  try {
    const bool is_exact = has_rays_of(made, camera, size.value_or(scene::default_resolution));
    const auto form = size || is_exact ? std::nullopt : form_of(camera);
    if (form) return ReadCamera{made, form, has_rays_of(made, camera, *form)};
    return ReadCamera{made, size, is_exact};
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
}

}  // namespace durero::io
