// Allotment: pixels get points by what their neighbours show, which leaves less error for as many rays, and no bias.
#include "render/sample/allotment.hpp"

#include <cmath>
#include <limits>

#include "durero/model/operaciones.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"

using namespace durero;
using render::Sampling;

namespace {

/// A ball that shines of itself, before grey, seen along z under 4° by a lens of that diameter, in focus at 10.
scene::Scene lamp_at(const glm::dvec3& centre, double radius, double light, double aperture) {
  scene::Scene scene;
  scene.stage().background = glm::dvec3(0.25);
  scene.stage().materials = {{.name = "lamp", .color = {0, 0, 0}, .emission = glm::dvec3(light)}};
  scene.apply(model::Agregar_Esfera{model::Elemento("lamp"), model::Punto(centre), radius});
  scene.set_material(*scene.find("lamp"), 0);
  scene.stage().camera = scene::Camera{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 4, aperture, 10};
  return scene;
}

struct Drawn {
  render::Picture picture;
  double rays;  ///< from the eye, those of pixels around included
};

Drawn drawn(const scene::Scene& scene, const render::RenderSettings& frame) {
  const auto engine = engine::find("fast")->prepare(scene);
  render::PathStatistics reach;
  render::Picture picture = render::render(scene, *engine, {}, frame, &reach);
  return {std::move(picture), double(reach.samples)};
}

double squared_error_of(const render::Picture& picture, const render::Picture& truth) {
  double squares = 0;
  for (std::size_t i = 0; i < truth.rgb.size(); ++i) squares += std::pow(picture.rgb[i].x - truth.rgb[i].x, 2);
  return squares / double(truth.rgb.size());
}

}  // namespace

TEST_CASE("points are as many as the deviation over the root of the mean says, a sixteenth of the most at least") {
  const auto points = [](double mean, double variance) {
    return render::allotted_points(glm::dvec3(mean), glm::dvec3(variance), 1000);
  };
  CHECK(points(0.5, 0.25) == 701);  // √(0.25/0.51) = 0.7001
  CHECK(points(0.99, 0.01) == 100);
  CHECK(points(0, 0.0001) == 100);
  CHECK(points(0.5, 0) == 62);
  CHECK(render::allotted_points(glm::dvec3(0.5), glm::dvec3(0), 40) == 4);
  CHECK(points(0.5, 0.6) == 1000);
  CHECK(points(std::numeric_limits<double>::quiet_NaN(), 0) == 1000);
  CHECK(render::allotted_points({0.24, 7, 7}, {0.03, 0, 0}, 1000) == 200);  // of three components the mean
}

TEST_CASE("a pixel's own points have no say in their number, and those of pixels up to three away have") {
  const scene::Resolution size{9, 9};
  const double pixel = 2 * 10 * std::tan(2 * std::acos(-1.0) / 180) / 9;  // at the distance 10
  const scene::Scene scene = lamp_at({0, 0, 10}, 0.4 * pixel, 1, 0);
  constexpr double even = 49 * 64;  // rays of an even pixel and of those around
  const auto rays_at = [&](std::uint32_t x, std::uint32_t y) {
    return drawn(scene, {.size = size,
                         .crop = render::Crop{x, y, {1, 1}},
                         .samples = {.sampling = Sampling::allotted, .most = 1024}})
        .rays;
  };
  CHECK(rays_at(4, 4) == even);
  for (const auto& [x, y] : {std::pair(3U, 4U), {4U, 5U}, {1U, 4U}, {6U, 6U}, {4U, 1U}}) CHECK(rays_at(x, y) > even);
  for (const auto& [x, y] : {std::pair(0U, 4U), {8U, 4U}, {4U, 0U}, {4U, 8U}}) CHECK(rays_at(x, y) == even);
  CHECK(rays_at(3, 4) > rays_at(1, 4));
}

TEST_CASE("what is even is told by its first points, to the last digit") {
  const scene::Scene scene = lamp_at({0, 0, -5}, 0.1, 1, 0.5);  // behind the eye
  const Drawn seen =
      drawn(scene, {.size = scene::Resolution{8, 6}, .samples = {.sampling = Sampling::allotted, .most = 256}});
  CHECK(seen.rays == (8 + 6) * (6 + 6) * 16);
  for (const glm::dvec3& color : seen.picture.rgb) CHECK(color == glm::dvec3(0.25));
}

TEST_CASE("where every pixel asks for more than there are points, the picture is the net's") {
  const scene::Scene scene = lamp_at({0, 0, 25}, 0.2, 20, 2);
  const auto of = [&](Sampling sampling) {
    return drawn(scene, {.size = scene::Resolution{32, 32},
                         .crop = render::Crop{12, 12, {8, 7}},
                         .samples = {.sampling = sampling, .most = 24}});
  };
  const Drawn allotted = of(Sampling::allotted);
  CHECK(allotted.rays == 8 * 7 * 24 + (14 * 13 - 8 * 7) * 4);
  CHECK(allotted.picture.rgb == of(Sampling::net).picture.rgb);
}

TEST_CASE("a pixel's mean has no bias: over many seeds it is that of very many points, to four standard errors") {
  const scene::Scene scene = lamp_at({0, 0, 25}, 0.06, 10, 1);
  // At the edge of the circle of confusion, where few of the first points meet the lamp.
  const auto mean = [&](const render::Samples& samples) {
    return drawn(scene, {.size = scene::Resolution{32, 32}, .crop = render::Crop{24, 15, {1, 1}}, .samples = samples})
        .picture.rgb[0]
        .x;
  };
  const double truth = mean({.sampling = Sampling::net, .most = 65536});
  constexpr std::uint32_t seeds = 1000;
  double sum = 0, squares = 0;
  for (std::uint32_t seed = 0; seed < seeds; ++seed) {
    const double one = mean({.sampling = Sampling::allotted, .most = 32, .seed = seed}) - truth;
    sum += one;
    squares += one * one;
  }
  CHECK(std::abs(sum / seeds) < 4 * std::sqrt(squares) / seeds);
  CHECK(squares > 0);
}

TEST_CASE("what is blurred has less than a quarter of the squared error that a net of as many rays leaves") {
  const scene::Scene scene = lamp_at({0, 0, 25}, 0.1, 3, 0.3);
  const auto of = [&](Sampling sampling, std::uint32_t most) {
    return drawn(scene,
                 {.size = scene::Resolution{40, 40}, .samples = {.sampling = sampling, .most = most, .seed = 3}});
  };
  const render::Picture truth = of(Sampling::net, 2048).picture;
  const Drawn allotted = of(Sampling::allotted, 256);
  const double in_each = std::ceil(allotted.rays / (40 * 40));
  CAPTURE(in_each);
  const Drawn even = of(Sampling::net, static_cast<std::uint32_t>(in_each));
  CHECK(squared_error_of(allotted.picture, truth) < 0.25 * squared_error_of(even.picture, truth));
}
