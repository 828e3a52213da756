#include "durero/render/sample/sampling.hpp"

#include <tbb/global_control.h>

#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <set>
#include <tuple>
#include <vector>

#include "durero/model/operaciones.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/stage.hpp"
#include "render/lit_ball.hpp"
#include "render/sample/points.hpp"
#include "render/sample/statistical.hpp"
#include "support/catch.hpp"

using namespace durero;
using render::Sampling;

namespace {

/// A lit ball and a mirror over a floor, before a background: edges, a shadow's edge, and smooth shades.
scene::Scene stage() {
  scene::Scene scene = test::lit_ball();
  scene.stage().materials.push_back({.name = "silver", .color = {0.2, 0.2, 0.2}, .k_ps = 0.7});
  scene.apply(model::Agregar_Esfera{model::Elemento("mirror"), {1.6, -0.4, 0.4}, 0.6});
  scene.set_material(*scene.find("mirror"), 1);
  scene.apply(model::Agregar_Plano{model::Elemento("floor"), {0, -1, 0}, {0, 1, 0}});
  scene.stage().background = glm::dvec3(0.2, 0.4, 0.8);
  scene.stage().camera = scene::Camera{{0, 1, -6}, {0.4, -0.2, 0}, {0, 1, 0}, 45};
  scene.stage().resolution = scene::Resolution{64, 48};
  return scene;
}

double squared_error(const render::Picture& picture, const render::Picture& truth) {
  double squares = 0;
  for (std::size_t i = 0; i < truth.rgb.size(); ++i)
    for (int k = 0; k < 3; ++k) squares += std::pow(picture.rgb[i][k] - truth.rgb[i][k], 2);
  return squares / (3 * double(truth.rgb.size()));
}

}  // namespace

TEST_CASE("a grid has the centres of equal squares, of one the centre exactly") {
  CHECK(render::in_grid(1, 0) == glm::dvec2(0));
  CHECK(render::in_grid(2, 0) == glm::dvec2(-0.25, -0.25));
  CHECK(render::in_grid(2, 1) == glm::dvec2(0.25, -0.25));
  CHECK(render::in_grid(3, 4) == glm::dvec2(0));
  CHECK(render::in_grid(4, 15) == glm::dvec2(0.375, 0.375));
}

TEST_CASE("strata have a point in each square, elsewhere in each pixel") {
  std::set<double> places;
  for (std::uint32_t pixel = 0; pixel < 50; ++pixel)
    for (std::uint32_t i = 0; i < 16; ++i) {
      const glm::dvec2 p = render::in_strata(4, i, render::key_of(pixel, 3, 0)), from = p - render::in_grid(4, i);
      CHECK((std::abs(from.x) <= 0.125 && std::abs(from.y) <= 0.125));
      places.insert(from.x);
    }
  CHECK(places.size() == 800);
}

TEST_CASE("of the first 2^m points of a net one lies in each rectangle of 2^-a by 2^-b, a + b = m") {
  for (std::uint32_t set = 0; set < 20; ++set) {
    const std::uint64_t key = render::key_of(7, set, set);
    for (std::uint32_t m = 0; m <= 10; ++m)
      for (std::uint32_t a = 0; a <= m; ++a) {
        std::set<std::pair<double, double>> taken;
        for (std::uint32_t i = 0; i < 1U << m; ++i) {
          const glm::dvec2 p = render::in_net(i, key) + 0.5;
          taken.emplace(std::floor(std::ldexp(p.x, int(a))), std::floor(std::ldexp(p.y, int(m - a))));
        }
        CHECK(taken.size() == 1U << m);
      }
  }
}

TEST_CASE("a scrambled point is anywhere: its mean and its spread over the keys are those of the square") {
  for (const std::uint32_t i : {0U, 1U, 5U, 1000U}) {
    glm::dvec2 sum(0), squares(0);
    constexpr std::uint32_t keys = 20000;
    for (std::uint32_t key = 0; key < keys; ++key) {
      const glm::dvec2 p = render::in_net(i, render::key_of(key, 1, 2));
      sum += p;
      squares += p * p;
    }
    // Standard errors: of the mean √(1/12/20000) = 0.00204, of the mean square √(1/180/20000) = 0.00053; four of each.
    for (int k = 0; k < 2; ++k) {
      CHECK(std::abs(sum[k] / keys) < 0.0082);
      CHECK(std::abs(squares[k] / keys - 1.0 / 12) < 0.0021);
    }
  }
}

TEST_CASE(
    "two scrambled points share the digits that they shared, differ in the next, and in the others go their own ways") {
  constexpr std::uint32_t keys = 32000, eighths = 8;
  const auto eighth = [](double x) { return static_cast<std::uint32_t>(std::floor((x + 0.5) * eighths)); };
  const auto shared = [](std::uint32_t a, std::uint32_t b) { return std::countl_zero((a ^ b) << 29 | 1U << 28); };
  for (const auto& [i, j] : {std::pair(0U, 1U), {1U, 3U}, {0U, 2U}, {5U, 9U}, {6U, 14U}, {1000U, 3U}})
    for (const int k : {0, 1}) {
      CAPTURE(i, j, k);
      std::array<std::array<int, eighths>, eighths> count{};
      int together = 0;
      for (std::uint32_t key = 0; key < keys; ++key) {
        const std::uint64_t own = render::key_of(key, 7, 2);
        const std::uint32_t a = eighth(render::in_net(i, own)[k]), b = eighth(render::in_net(j, own)[k]);
        ++count[a][b];
        if (key == 0) together = shared(a, b);
      }
      // Of the pairs of eighths with as many digits in common each is as likely as the others: five standard errors.
      int pairs = 0;
      for (std::uint32_t a = 0; a < eighths; ++a)
        for (std::uint32_t b = 0; b < eighths; ++b) pairs += shared(a, b) == together;
      const double even = double(keys) / pairs;
      for (std::uint32_t a = 0; a < eighths; ++a)
        for (std::uint32_t b = 0; b < eighths; ++b) {
          const double expected = shared(a, b) == together ? even : 0;
          CHECK(std::abs(count[a][b] - expected) <= 5 * std::sqrt(expected));
        }
    }
}

TEST_CASE("the factor is Student's t of one less than the blocks over their root") {
  // Of one look no more than a tail of 0.03/3/2 = 0.005 for each component, of two half of that. Tables: t(3, 0.005) =
  // 5.841, t(7, 0.005) = 3.499, t(7, 0.0025) = 4.029.
  CHECK(render::half_width_factor(1 - 0.03, 1, 4) * 2 == Approx(5.841).epsilon(1e-3));
  CHECK(render::half_width_factor(1 - 0.03, 1, 8) * std::sqrt(8) == Approx(3.499).epsilon(1e-3));
  CHECK(render::half_width_factor(1 - 0.03, 2, 8) * std::sqrt(8) == Approx(4.029).epsilon(1e-3));
}

TEST_CASE("the deviation of the means of blocks is that of the textbook, by component, and blocks are joined") {
  render::Estimate estimate;
  const auto take = [&](std::uint32_t begin, const std::vector<double>& brought) {
    estimate.grow_to(begin + std::uint32_t(brought.size()));
    for (std::uint32_t i = 0; i < brought.size(); ++i)
      estimate.take(begin + i, {.color = {brought[i], 7, 0.1 * brought[i]}});
  };
  take(0, {0, 1, 2, 3, 4, 5, 6, 7});
  CHECK(estimate.blocks() == 8);
  CHECK(render::deviation(estimate).x == Approx(std::sqrt(6.0)));  // 0 … 7: the squares about 3.5 sum to 42
  CHECK(render::deviation(estimate).y == 0);
  CHECK(render::deviation(estimate).z == Approx(0.1 * std::sqrt(6.0)));
  take(8, {8, 9, 10, 11, 12, 13, 14, 15});
  CHECK(estimate.blocks() == 16);
  CHECK(render::deviation(estimate).x == Approx(std::sqrt(340.0 / 15)));
  // Of two points each: 0.5, 2.5, … 14.5 and eight of 11.5, whose mean is 9.5.
  take(16, {10, 13, 11.5, 11.5, 3, 20, 23, 0, 11, 12, 12, 11, 1, 22, 2, 21});
  CHECK(render::deviation(estimate).x == Approx(std::sqrt((81 + 49 + 25 + 9 + 1 + 1 + 9 + 25 + 8 * 4) / 15.0)));
  CHECK(estimate.all.color.y == 7 * 32);
}

namespace {

/// Of one net of `points`, over many of them: the mean of s²/R, what statistics estimates the variance of the mean by,
/// over that variance.
template <class F>
double estimated_over_true(std::uint32_t points, F&& of, std::uint32_t keys = 4000) {
  double sum = 0, squares = 0, estimated = 0;
  for (std::uint32_t key = 0; key < keys; ++key) {
    render::Estimate estimate;
    for (std::uint32_t n = render::least_samples; n <= points; n *= 2) {
      const std::uint32_t begin = estimate.points;
      estimate.grow_to(n);
      for (std::uint32_t i = begin; i < n; ++i)
        estimate.take(i, {.color = glm::dvec3(of(render::in_net(i, render::key_of(key, 5, 0)), key))});
    }
    const double mean = estimate.all.color.x / points, s = render::deviation(estimate).x;
    sum += mean;
    squares += mean * mean;
    estimated += s * s / estimate.blocks();
  }
  return estimated / (squares - sum * sum / keys);
}

}  // namespace

TEST_CASE("the spread of the blocks of a net says no less than how far its mean is off: of edges, and of shades") {
  for (const std::uint32_t points : {4U, 8U, 16U, 32U, 128U})
    for (const double slant : {0.0, 0.3, 1.0, 2.4}) {
      CAPTURE(points, slant);
      CHECK(estimated_over_true(points, [&](auto p, auto) { return double(p.x + slant * p.y > 0.1); }) > 1);
      CHECK(estimated_over_true(points, [&](auto p, auto) { return p.x * p.x + slant * p.y + p.x * p.y; }) > 1);
    }
}

TEST_CASE("of no function does it say less than 7/15 of it, 3/7 of eight points, a third of four") {
  // Haar's function of the scale on which two points of the net fall together: rectangles of 2^-a by 2^-b, a + b one
  // less than the net's. Its mean is a sum of products of coins for rows and for columns, whose fourth moment is up to
  // 9 squares of the second: the standard error of a variance of 10000 is up to √(8/10000), and three of them are
  // 0.085.
  const auto haar = [](double x, int digits) {
    return std::fmod(std::floor(std::ldexp(x + 0.5, digits + 1)), 2) * 2 - 1;
  };
  for (const auto& [points, digits, ratio] :
       {std::tuple(4U, 1, 1.0 / 3), std::tuple(8U, 2, 3.0 / 7), {16U, 3, 7.0 / 15}, {64U, 5, 7.0 / 15}})
    for (int a = 0; a <= digits; ++a) {
      CAPTURE(points, a);
      const double found = estimated_over_true(
          points, [&](auto p, auto) { return haar(p.x, a) * haar(p.y, digits - a); }, 10000);
      CHECK(found > 0.9 * ratio);
      CHECK(found < 1.1 * ratio);
    }
}

TEST_CASE("one sample in a grid is the picture of one ray, and more are the mean of theirs") {
  const scene::Scene scene = stage();
  const auto engine = engine::find("analytic")->prepare(scene);
  render::PathStatistics reach;
  const render::RenderSettings four{.size = scene::Resolution{8, 6}, .samples = {.most = 4}};
  const render::Picture picture = render::render(scene, *engine, {}, four, &reach);
  CHECK(reach.samples == 8 * 6 * 4);
  const render::Picture fine = render::render(scene, *engine, {}, {.size = scene::Resolution{16, 12}});
  for (std::size_t y = 0; y < 6; ++y)
    for (std::size_t x = 0; x < 8; ++x) {
      const auto of = [&](std::size_t dx, std::size_t dy) { return fine.rgb[(2 * y + dy) * 16 + 2 * x + dx].y; };
      CHECK(picture.rgb[y * 8 + x].y == Approx((of(0, 0) + of(1, 0) + of(0, 1) + of(1, 1)) / 4).margin(1e-9));
    }
}

TEST_CASE("every sampling gives a pixel the same bytes, whatever the threads, the engine and the crop") {
  const scene::Scene scene = stage();
  const auto engine = engine::find("exact")->prepare(scene), other = engine::find("fast")->prepare(scene);
  for (const Sampling sampling : {Sampling::grid, Sampling::stratified, Sampling::allotted, Sampling::statistical}) {
    const render::Samples samples{.sampling = sampling, .most = 16, .width = 0.1};
    const render::RenderSettings whole{.size = scene::Resolution{24, 18}, .samples = samples};
    const render::Picture picture = render::render(scene, *engine, {}, whole);
    for (const std::size_t threads : {1, 3}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      CHECK(render::render(scene, *other, {}, whole).rgb == picture.rgb);
    }
    const render::RenderSettings part{.size = whole.size, .crop = render::Crop{5, 7, {9, 4}}, .samples = samples};
    const render::Picture crop = render::render(scene, *other, {}, part);
    for (std::size_t y = 0; y < 4; ++y)
      for (std::size_t x = 0; x < 9; ++x) CHECK(crop.rgb[y * 9 + x] == picture.rgb[(7 + y) * 24 + 5 + x]);
  }
}

TEST_CASE("what is even takes four rays and the corners, and what never settles is in doubt") {
  scene::Scene scene = test::lit_ball();
  scene.stage().camera = scene::Camera{{0, 0, -5}, {0, 0, -9}, {0, 1, 0}, 45};  // away from it
  const auto engine = engine::find("analytic")->prepare(scene);
  render::RenderSettings frame{.size = scene::Resolution{8, 4},
                               .samples = {.sampling = Sampling::statistical, .most = 40}};
  render::PathStatistics reach;
  render::render(scene, *engine, {}, frame, &reach);
  CHECK(reach.samples == 8 * 4 * 4 + 11 * 7);
  CHECK(reach.in_doubt == 0);
  scene.stage().camera = scene::Camera{{0, 2, -5}, {0, 0, 0}, {0, 1, 0}, 45};
  frame.samples.width = 1e-9;
  render::render(scene, *engine, {}, frame, &reach);
  CHECK(reach.in_doubt > 0);
  CHECK(reach.in_doubt < reach.pixels);
  CHECK(reach.samples <= reach.pixels * 32 + 11 * 7);
}

namespace {

/// How a scene with that stage is seen in one pixel of 90°, whose corners are (±1, ±1, 1) from the eye.
render::PathStatistics seen_in_one_pixel(const scene::Scene& scene, const render::Samples& samples) {
  const auto engine = engine::find("exact")->prepare(scene);
  render::PathStatistics reach;
  render::render(scene, *engine, {}, {.size = scene::Resolution{1, 1}, .samples = samples}, &reach);
  return reach;
}

constexpr std::uint64_t corners = 4 * 4;  // of one pixel, and of those around it

}  // namespace

TEST_CASE(
    "a pixel of which something bright cuts off a corner is not believed before its 32nd point, nor one beside it "
    "before its eighth") {
  const auto samples_at = [&](const glm::dvec3& lamp, const glm::dvec3& background) {
    scene::Scene scene;
    scene.stage().materials = {{.name = "lamp", .color = glm::dvec3(0), .emission = {1, 1, 1}}};
    scene.apply(
        model::Agregar_Esfera{model::Elemento("lamp"), model::Punto(lamp), 0.01});  // which no point of the pixel sees
    scene.set_material(*scene.find("lamp"), 0);
    scene.stage().camera = scene::Camera{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 90};
    scene.stage().background = background;
    return seen_in_one_pixel(scene, {.sampling = Sampling::statistical, .most = 1024}).samples;
  };
  for (const glm::dvec3& lamp : {glm::dvec3(1, 1, 1), glm::dvec3(-1, 1, 1), glm::dvec3(-1, -1, 1)}) {
    CHECK(samples_at(lamp, {1, 1, 1}) == 4 + corners);
    CHECK(samples_at(lamp, {0, 0, 0}) == 32 + corners);
  }
  for (const glm::dvec3& beside : {glm::dvec3(3, 1, 1), glm::dvec3(-3, -3, 1), glm::dvec3(1, -3, 1)})
    CHECK(samples_at(beside, {0, 0, 0}) == 8 + corners);
  CHECK(samples_at({5, 1, 1}, {0, 0, 0}) == 4 + corners);
}

TEST_CASE("few points are held to a part of the width, the last ones to all of it") {
  CHECK(render::part_of_width(8) == 0.25);
  CHECK(render::part_of_width(128) == 1);
  CHECK(render::part_of_width(1024) == 1);
  scene::Scene scene;
  scene.stage().environment =
      scene::Environment{.kind = scene::Surroundings::gradient, .colors = {glm::dvec3(0), glm::dvec3(1)}};
  scene.stage().camera = scene::Camera{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1};
  // From its lower to its upper side the pixel goes from 0.5 − r/2 to 0.5 + r/2, with a deviation of about r/√12. With
  // nine looks, t(3) is 10.5, t(7) 4.9 and t(15) 3.8: half the interval is 1.5·r of four points, which are held to
  // 0.18 of the width; of eight 0.5·r and 0.25; of sixteen 0.28·r and 0.35. From r on, corners differ by more than the
  // width.
  const double r = std::sin(0.5 * 3.14159265358979 / 180);
  const auto seen = [&](double width, std::uint32_t most = 1024) {
    return seen_in_one_pixel(scene, {.sampling = Sampling::statistical, .most = most, .width = width});
  };
  CHECK(seen(r / 0.05).samples == 4 + corners);
  CHECK(seen(r / 0.3).samples == 8 + corners);
  CHECK(seen(r / 0.85).samples == 16 + corners);
  CHECK(seen(r / 1.5).samples == 32 + corners);
  CHECK(seen(r / 0.85, 8).in_doubt == 0);
  CHECK(seen(r / 1.5, 8).in_doubt == 1);
}

TEST_CASE("as many pixels as the confidence says are within the width, and it takes less than four tenths of a grid") {
  const scene::Scene scene = stage();
  const auto engine = engine::find("fast")->prepare(scene);
  const auto drawn = [&](const render::Samples& samples, render::PathStatistics* reach = nullptr) {
    return render::render(scene, *engine, {}, {.crop = render::Crop{12, 10, {40, 32}}, .samples = samples}, reach);
  };
  const render::Picture truth = drawn({.most = 4096});
  const double grid = squared_error(drawn({.most = 64}), truth);
  const render::Samples samples{.sampling = Sampling::statistical, .most = 1024, .width = 0.25, .confidence = 0.95};
  render::PathStatistics reach;
  const render::Picture picture = drawn(samples, &reach);
  const double rays = double(reach.samples) / double(reach.pixels), error = squared_error(picture, truth);
  std::size_t off = 0;
  for (std::size_t i = 0; i < truth.rgb.size(); ++i) {
    const glm::dvec3 by = glm::abs(picture.rgb[i] - truth.rgb[i]);
    off += by.x > samples.width || by.y > samples.width || by.z > samples.width;
  }
  INFO("RMS error of 64 rays in a grid " << std::sqrt(grid) << ", of " << rays << " by statistics " << std::sqrt(error)
                                         << "; " << off << " of " << truth.rgb.size() << " pixels off by more than "
                                         << samples.width);
  CHECK(error <= grid);
  CHECK(rays <= 0.4 * 64);
  // At most 5 in 100, and three standard errors of the count.
  const double pixels = double(truth.rgb.size());
  CHECK(double(off) <= 0.05 * pixels + 3 * std::sqrt(0.05 * 0.95 * pixels));
}

TEST_CASE("each dimension of a sample is a net of its own, block by block") {
  for (const std::uint64_t dimension :
       {std::uint64_t{0}, render::of_lens, render::of_meeting(1), render::of_meeting(6)})
    for (std::uint32_t m = 0; m <= 6; ++m)
      for (std::uint32_t a = 0; a <= m; ++a)
        for (const std::uint32_t block : {0U, 5U}) {
          std::set<std::pair<double, double>> taken;
          for (std::uint32_t i = 0; i < 1U << m; ++i) {
            const glm::dvec2 p = render::SampleSource{render::key_of(3, 4, 0), (block << m) + i}.pair(dimension);
            CHECK((p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1));
            taken.emplace(std::floor(std::ldexp(p.x, int(a))), std::floor(std::ldexp(p.y, int(m - a))));
          }
          CHECK(taken.size() == 1U << m);
        }
}

TEST_CASE("dimensions are in orders of their own: the numbers of two of them do not go together") {
  double together = 0;
  constexpr std::uint32_t pixels = 64, points = 64;
  for (std::uint32_t pixel = 0; pixel < pixels; ++pixel)
    for (std::uint32_t i = 0; i < points; ++i) {
      const render::SampleSource sample{render::key_of(pixel, 9, 0), i};
      together += (sample.pair(render::of_lens).x - 0.5) * (sample.pair(render::of_meeting(1)).x - 0.5);
    }
  // Each product has the variance 1/144: the sum is beyond five deviations once in a million keys.
  CHECK(std::abs(together) < 5 * std::sqrt(pixels * points / 144.0));
}

TEST_CASE("times are in as many equal parts as there are samples, and the seed turns them") {
  for (const std::uint64_t seed : {0, 1}) {
    std::set<double> parts;
    for (std::uint32_t i = 0; i < 64; ++i) parts.insert(std::floor(64 * render::time_of(i, seed)));
    CHECK(parts.size() == 64);
    CHECK(*parts.begin() == 0);
    CHECK(*parts.rbegin() == 63);
  }
  CHECK(render::time_of(3, 0) != render::time_of(3, 1));
}
