#include "durero/render/fractal.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "render/sample/by_rows.hpp"
#include "render/sample/points.hpp"

namespace durero::render {
namespace {

using distance::MengerSponge;
using distance::QuaternionJulia;
using Vec = glm::dvec3;

/// How a fractal is seen: what it is lit by is the same for all.
struct FractalView {
  Vec eye, look_at;
  double width;  ///< of the picture, at the distance 1
  double floor;  ///< the height of the floor
  Vec albedo;    ///< of the fractal
};
FractalView view_of(const MengerSponge&) { return {{2.3, 1.5, 2.6}, {0.5, 0.42, 0.5}, 0.92, 0, {0.83, 0.66, 0.45}}; }
FractalView view_of(const QuaternionJulia&) { return {{1.7, 1.2, 3.1}, {0, -0.2, 0}, 1.25, -0.98, {0.8, 0.42, 0.3}}; }

constexpr std::uint32_t most_bounces = 4, most_steps = 400;
constexpr double far = 60;                                                   // beyond which there is sky
const Vec sun(0.5883484054145521, 0.7844645405527361, 0.19611613513818402);  // of length 1, but for its rounding
constexpr double sun_radius = 0.035;                                         // of its disc, at the distance 1
const Vec sunlight(0.95, 0.84, 0.68), horizon(0.5, 0.54, 0.6), zenith(0.16, 0.28, 0.5), floor_albedo(0.62, 0.6, 0.57);

Vec sky(const Vec& direction) { return horizon + (zenith - horizon) * std::sqrt(std::clamp(direction.y, 0.0, 1.0)); }

/// The sine and the cosine of π·a, −1/2 ≤ a ≤ 1/2, by their series: the same on every machine, to some 10⁻¹².
struct SineCosine {
  double sine, cosine;
};
SineCosine half_turn(double a) {
  constexpr double pi = 3.14159265358979323846;
  const double x = pi * a, xx = x * x;
  double sine = 1, cosine = 1;
  for (int n = 16; n >= 2; n -= 2) {
    sine = 1 - xx / (n * (n + 1)) * sine;
    cosine = 1 - xx / (n * (n - 1)) * cosine;
  }
  return {x * sine, cosine};
}

/// Two directions across one of length 1.
struct AcrossFrame {
  Vec one, other;
};
AcrossFrame frame_across(const Vec& n) {
  const Vec axis = std::abs(n.x) < 0.6 ? Vec(1, 0, 0) : Vec(0, 1, 0);
  const Vec one = glm::normalize(glm::cross(axis, n));
  return {one, glm::cross(n, one)};
}

/// The point of the disc of radius 1 for a point of the square: equal areas become equal areas.
glm::dvec2 on_lens(const glm::dvec2& square) {
  const double radius = std::sqrt(square.x + 0.5);
  const auto [sine, cosine] = half_turn(square.y);
  return {radius * (1 - 2 * sine * sine), radius * 2 * sine * cosine};
}

/// A surface that a path meets.
struct Met {
  Vec point, normal, albedo;
};

/// The paths of a picture of one fractal.
template <class Set>
class FractalPaths {
 public:
  explicit FractalPaths(const Set& set) : set_(set), view_(view_of(set)) {}

  /// The light that path i of pixel (x, y) brings.
  Vec brought(std::uint32_t x, std::uint32_t y, std::uint32_t i, scene::Resolution size) const {
    const auto draw = [&](std::uint32_t pair) { return in_net(i, key_of(x, y, pair)); };
    const glm::dvec2 at = draw(0);
    Vec point = view_.eye, direction = towards(x + 0.5 + at.x, y + 0.5 + at.y, size), share(1), light(0);
    double fine = view_.width / size.width / 2;  // half a pixel, at the distance 1
    for (std::uint32_t bounce = 0; bounce < most_bounces; ++bounce) {
      const auto met = first(point, direction, fine);
      if (!met) return light + share * sky(direction);
      share *= met->albedo;
      light += share * sunlight * lit(*met, draw(1 + 2 * bounce));
      const glm::dvec2 across = on_lens(draw(2 + 2 * bounce));
      const auto [one, other] = frame_across(met->normal);
      direction = across.x * one + across.y * other +
                  std::sqrt(std::max(0.0, 1 - across.x * across.x - across.y * across.y)) * met->normal;
      point = met->point;
      fine = 0x1p-11;
    }
    return light;
  }

 private:
  Vec towards(double x, double y, scene::Resolution size) const {
    const Vec ahead = glm::normalize(view_.look_at - view_.eye);
    const Vec right = glm::normalize(glm::cross(ahead, Vec(0, 1, 0))), up = glm::cross(right, ahead);
    const double pixel = view_.width / size.width;
    return glm::normalize(ahead + (x - size.width / 2.0) * pixel * right + (size.height / 2.0 - y) * pixel * up);
  }

  /// The first surface that is nearer than `fine` times the way to it; the walk starts at the point and leaves what it
  /// starts on by a point a little off it.
  std::optional<Met> first(const Vec& from, const Vec& direction, double fine) const {
    double t = 0;
    for (std::uint32_t step = 0; step < most_steps && t < far; ++step) {
      const Vec p = from + t * direction;
      const double of_set = set_.below(p), of_floor = p.y - view_.floor, least = std::min(of_set, of_floor);
      const double near = std::max(fine * t, 0x1p-13);
      if (least < near) {
        const bool is_floor = of_floor <= of_set;
        const Vec normal = is_floor ? Vec(0, 1, 0) : set_.normal(p);
        return Met{p + 2 * near * normal, normal, is_floor ? floor_albedo : view_.albedo};
      }
      t += least;
    }
    return std::nullopt;
  }

  /// How much of the sun a surface has: the cosine of a direction to its disc, where nothing stands in it.
  double lit(const Met& met, const glm::dvec2& square) const {
    const glm::dvec2 at = on_lens(square);
    const auto [one, other] = frame_across(sun);
    const Vec direction = glm::normalize(sun + sun_radius * (at.x * one + at.y * other));
    const double cosine = glm::dot(direction, met.normal);
    return cosine > 0 && !first(met.point, direction, 0x1p-12) ? cosine : 0;
  }

  const Set& set_;
  FractalView view_;
};

}  // namespace

Picture draw_fractal(const Fractal& fractal, scene::Resolution size, std::uint32_t samples, const Progress& progress) {
  return std::visit(
      [&](const auto& set) {
        const FractalPaths paths(set);
        Picture picture(size);
        by_rows(size.height, progress, [&](std::uint32_t y) {
          for (std::uint32_t x = 0; x < size.width; ++x) {
            Vec sum(0);
            for (std::uint32_t i = 0; i < samples; ++i) sum += paths.brought(x, y, i, size);
            picture.rgb[std::size_t(y) * size.width + x] = sum / double(samples);
          }
        });
        return picture;
      },
      fractal);
}

}  // namespace durero::render
