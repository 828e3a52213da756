#include "durero/raster/transparency.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "durero/render/render.hpp"
#include "raster/triangles.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::raster;
using namespace durero::test;

namespace {

/// Sheets across the view, one behind the other, before an opaque wall.
scene::Scene sheets(const std::vector<scene::Material>& materials, const scene::Material& wall) {
  scene::Scene scene;
  scene.stage().camera = {{0.1, 0.2, -5}, {0, 0, 0}, {0, 1, 0}, 40};
  scene.stage().resolution = scene::Resolution{40, 30};
  scene.stage().background = glm::dvec3(0.5, 0.25, 0.125);
  scene.stage().materials = materials;
  scene.stage().materials.push_back(wall);
  scene.stage().max_depth = 9;
  add(scene, "wall", {glm::dvec3(-4, -4, 4), {4, -4, 4}, {0, 5, 4}}, std::uint32_t(materials.size()));
  for (std::uint32_t i = 0; i < materials.size(); ++i) {
    const double z = double(i) - 1.5, aside = 0.25 * i;
    add(scene, std::string(1, char('a' + i)),
        {glm::dvec3(-2 + aside, -1, z), {2, -1 + aside, z + 0.125}, {aside, 1.5, z + 0.25}}, i);
  }
  return scene;
}

std::vector<std::size_t> depth_order(const RasterScene& raster) {
  const std::vector<std::size_t> places = transparent_of(raster);
  std::vector<polygon::Polygon> corners;
  for (const std::size_t place : places) corners.push_back(raster.corners()[place]);
  std::vector<std::size_t> order;
  for (const std::size_t i : far_to_near(corners, {polygon::exact(raster.view().eye())})) order.push_back(places[i]);
  return order;
}

/// How many binary64 numbers apart two positive ones are.
std::int64_t ulps(double a, double b) {
  return std::abs(std::bit_cast<std::int64_t>(a) - std::bit_cast<std::int64_t>(b));
}

scene::Material glowing(const char* name, double own, double k_t, double M_T) {
  return {.name = name, .color = {0, 0, 0}, .k_d = 0, .k_t = k_t, .M_T = glm::dvec3(M_T), .emission = glm::dvec3(own)};
}

}  // namespace

TEST_CASE("mezcla.def.1: .1, .2 and .8 behind shares of a half and a quarter are .25, and .35 in the other order") {
  const scene::Scene scene = sheets({glowing("z", 0.1, 0.5, 0.5), glowing("y", 0.2, 1, 0.5)}, glowing("x", 0.8, 0, 1));
  const RasterScene raster(scene, {40, 30}, Opacity::transparent);
  const auto engine = engine::find("fast")->prepare(scene);
  const std::vector<std::size_t> order = depth_order(raster);
  CHECK(order == std::vector<std::size_t>{1, 0});  // y, then z
  const std::size_t middle = 15 * 40 + 20;
  CHECK(ulps(with_transparency(raster, *engine, order).rgb[middle].x, 0.25) <= 1);
  CHECK(ulps(with_transparency(raster, *engine, {0, 1}).rgb[middle].x, 0.35) <= 1);
}

TEST_CASE("without colours of their own four polygons have the same bytes in each of 24 orders") {
  std::vector<scene::Material> materials;
  for (const double share : {0.5, 0.25, 0.75, 0.625}) {
    scene::Material m = glowing("m", 0, 1, share);
    m.name += std::to_string(materials.size());
    m.M_T = {share, 1 - share / 2, share / 4};
    materials.push_back(m);
  }
  const scene::Scene scene = sheets(materials, glowing("wall", 0.5, 0, 1));
  const RasterScene raster(scene, {40, 30}, Opacity::transparent);
  const auto engine = engine::find("fast")->prepare(scene);
  std::vector<std::size_t> order = transparent_of(raster);
  REQUIRE(order.size() == 4);
  const render::Picture first = with_transparency(raster, *engine, order);
  int orders = 0;
  do {
    ++orders;
    CHECK((with_transparency(raster, *engine, order).rgb == first.rgb));
  } while (std::ranges::next_permutation(order).found);
  CHECK(orders == 24);
}

TEST_CASE("drawn from far to near, sheets have what rays bring straight through them, to a unit in the last place") {
  std::vector<scene::Material> materials;
  for (const double share : {0.5, 0.25, 0.75}) {
    scene::Material m = glowing("m", share / 7, 1, share);
    m.name += std::to_string(materials.size());
    materials.push_back(m);
  }
  const scene::Scene scene = sheets(materials, glowing("wall", 0.6, 0, 1));
  const RasterScene raster(scene, {40, 30}, Opacity::transparent);
  const auto engine = engine::find("fast")->prepare(scene);
  const render::Picture own = with_transparency(raster, *engine, depth_order(raster)),
                        rays = render::render(scene, *engine);
  int covered = 0;
  for (std::size_t i = 0; i < own.rgb.size(); ++i) {
    INFO("pixel " << i);
    for (int k = 0; k < 3; ++k) CHECK(ulps(own.rgb[i][k], rays.rgb[i][k]) <= 1);
    covered += own.rgb[i].x < 0.3 ? 1 : 0;
  }
  CHECK(covered > 100);
}

TEST_CASE(
    "sheets in the light of a lamp, which they all shadow, have what rays bring, to eight units in the last place") {
  std::vector<scene::Material> materials;
  for (const double share : {0.5, 0.3, 0.8})
    materials.push_back({.name = "m" + std::to_string(materials.size()),
                         .color = {share, 0.5, 1 - share},
                         .k_a = 0.1,
                         .k_d = 0.4,
                         .k_s = 0.3,
                         .e = 9,
                         .k_t = 0.7,
                         .M_T = {1, share, 0.9}});
  scene::Scene scene = sheets(materials, {.name = "wall", .color = {0.8, 0.7, 0.6}});
  scene.stage().lights = {{{3, 4, -6}, {0.9, 0.9, 0.8}}};
  scene.stage().directional_lights = {{{0, -1, 3}, {0.2, 0.2, 0.3}}};
  const RasterScene raster(scene, {40, 30}, Opacity::transparent);
  const auto engine = engine::find("fast")->prepare(scene);
  const render::Picture own = with_transparency(raster, *engine, depth_order(raster)),
                        rays = render::render(scene, *engine);
  std::int64_t most = 0;
  for (std::size_t i = 0; i < own.rgb.size(); ++i)
    for (int k = 0; k < 3; ++k) most = std::max(most, ulps(own.rgb[i][k], rays.rgb[i][k]));
  INFO(most << " units");
  CHECK(most <= 8);
}

TEST_CASE("a sheet behind a wall is not seen, and one that goes through it is seen before it alone") {
  scene::Scene scene =
      sheets({glowing("behind", 0.125, 1, 0.5), glowing("across", 0.125, 1, 0.5)}, glowing("wall", 0.5, 0, 1));
  scene.apply(model::Eliminar_Triangulo{model::Elemento("wall")});
  add(scene, "front", {glm::dvec3(-9, -9, -3), {9, -9, -3}, {0, 9, -3}}, 2);
  add(scene, "through", {glm::dvec3(0.2, -9, -4), {0.2, 9, -4}, {0.1, 0, 9}}, 1);
  const RasterScene raster(scene, {40, 30}, Opacity::transparent);
  const auto engine = engine::find("fast")->prepare(scene);
  const render::Picture own = with_transparency(raster, *engine, transparent_of(raster)),
                        rays = render::render(scene, *engine);
  CHECK((own.rgb == rays.rgb));
  CHECK(std::ranges::count(own.rgb, glm::dvec3(0.5)) > 300);  // the wall alone
}

TEST_CASE("far_to_near: none is drawn after one that hides a part of it; boards around each other have no order") {
  std::mt19937_64 random(20251206);
  for (int round = 0; round < 20; ++round) {
    std::vector<polygon::Polygon> all;
    for (int i = 0; i < 8; ++i) {
      const double z = double(random() % 64);
      const Corners3 at = grid_triangle(random, 2, 2);
      if (at[0].x * at[1].y == at[0].y * at[1].x) continue;
      polygon::Polygon flat;
      for (const glm::dvec3& corner : at) flat.push_back(polygon::exact({corner.x, corner.y, z}));
      if (polygon::doubled_area(flat) != polygon::RationalPoint{}) all.push_back(flat);
    }
    const auto order = far_to_near(all, {{0, 0, -5}});
    REQUIRE(order.size() == all.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i + 1; j < order.size(); ++j)
        CHECK(polygon::clipped(all[order[j]], polygon::hidden({{0, 0, -5}}, all[order[i]])).empty());
  }
  std::vector<polygon::Polygon> boards;
  boards.push_back({{-4, 1, -1}, {4, -1, -1}, {4, -1, 0}, {-4, 1, 0}});
  boards.push_back({{2, 1, -3}, {-1, -1, 4}, {-2, -1, 4}, {1, 1, -3}});
  boards.push_back({{-3, -1, -2}, {2, 1, 4}, {3, 1, 4}, {-2, -1, -2}});
  CHECK_THROWS_AS(far_to_near(boards, {{0, 20, 0}}), std::domain_error);
  boards.pop_back();
  CHECK(far_to_near(boards, {{0, 20, 0}}).size() == 2);
}
