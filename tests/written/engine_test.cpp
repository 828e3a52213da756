#include "durero/written/engine.hpp"

#include <fmt/format.h>

#include <fstream>

#include "durero/conform/families/families.hpp"
#include "durero/io/json/scene_file.hpp"
#include "support/catch.hpp"
#include "support/folder.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/tree.hpp"

namespace durero::written {
namespace {

const std::string spec = test::source_dir() + "/spec/puntos.tex", surfaces = test::source_dir() + "/demo/surfaces/";

/// What the text says of each ray of the case is what the program's formulas say, byte for byte.
void check_same(const Text& text, const conform::Case& made, const std::string& what) {
  CAPTURE(what);
  const auto written = prepared(made.scene, text), exact = engine::find("exact")->prepare(made.scene);
  const auto ours = engine::first_hits(*exact, made.rays), theirs = engine::first_hits(*written, made.rays);
  for (std::size_t i = 0; i < ours.size(); ++i) {
    CAPTURE(i);
    REQUIRE((ours[i] == theirs[i]));
    REQUIRE(engine::occluded_segment(*exact, made.rays[i]) == engine::occluded_segment(*written, made.rays[i]));
  }
}

TEST_CASE("The types that the program has formulas for have the same bytes by the text, on every family") {
  const Text text(spec);
  for (const conform::Family& family : conform::families_of_few())
    for (std::uint64_t seed = 1; seed <= test::fewer_when_sanitized(6); ++seed)
      check_same(text, generate(family, seed, 12), std::string(family.name) + " with seed " + std::to_string(seed));
}

TEST_CASE("The types that the program has formulas for have the same bytes by the text, at length", "[long]") {
  const Text text(spec);
  for (const conform::Family& family : conform::families_of_few())
    for (std::uint64_t seed = 1000; seed < 1200; ++seed)
      check_same(text, generate(family, seed, 50), std::string(family.name) + " with seed " + std::to_string(seed));
}

Written read_text(const std::string& elements, const std::string& text) {
  const io::Source source("scene.json", R"({"format":"durero-scene","version":1,"elementos":[)" + elements + "]}");
  return read(source, Text(text));
}

scene::Hit hit_of(const Written& written, const glm::dvec3& p, const glm::dvec3& v) {
  return engine::first_hit(*written.engine, {{model::Punto(p), model::Vector(v)}});
}

std::vector<std::string> names(const Written& written, const scene::Hit& hit) {
  std::vector<std::string> all;
  for (const scene::ElementRef element : hit.elementos) all.push_back(written.scene.name(element).name());
  std::ranges::sort(all);
  return all;
}

using Names = std::vector<std::string>;

TEST_CASE("A surface of degree four and one of degree two that meet in a point are both named") {
  const Written written = read_text(
      R"({"id":"ring","tipo":"toro","centro":[0,0,0],"mayor":2,"menor":1},
         {"id":"ball","tipo":"esfera","centro":[0,0,0],"radio":3},
         {"id":"wall","tipo":"plano","centro":[-2.5,0,0],"vector":[1,0,0]})",
      surfaces + "torus.tex");
  const scene::Hit both = hit_of(written, {-5, 0, 0}, {1, 0, 0});
  CHECK(both.resultado == model::Resultado::hit);
  CHECK(both.t == 2);
  CHECK(both.punto == glm::dvec3(-3, 0, 0));
  CHECK(names(written, both) == Names{"ball", "ring"});
  CHECK(names(written, hit_of(written, {-2.75, 0, 0}, {1, 0, 0})) == Names{"wall"});
  CHECK(names(written, hit_of(written, {-2.25, 0, 0}, {1, 0, 0})) == Names{"ring"});
  CHECK(hit_of(written, {-2.25, 4, 0}, {1, 0, 0}).resultado == model::Resultado::miss);
}

TEST_CASE("Where a stretch begins at no first point, what is met before it or with it is the answer") {
  const std::string open = R"({"id":"open","tipo":"plano","centro":[0,0,0],"vector":[0,1,0]})";
  const Written alone = read_text(open, spec);
  const scene::Hit none = hit_of(alone, {0, 0, 0}, {1, 0, 0});
  CHECK(none.resultado == model::Resultado::no_minimum);
  CHECK(names(alone, none) == Names{"open"});
  const Written two = read_text(open + R"(,{"id":"ball","tipo":"esfera","centro":[3,0,0],"radio":1})", spec);
  CHECK(names(two, hit_of(two, {0, 0, 0}, {1, 0, 0})) == Names{"open"});
}

TEST_CASE("The normal of an element is that of its surface") {
  const Written written = read_text(R"({"id":"ring","tipo":"toro","centro":[0,0,0],"mayor":2,"menor":1},
                                       {"id":"ball","tipo":"esfera","centro":[0,9,0],"radio":3})",
                                    surfaces + "torus.tex");
  CHECK(written.engine->normal(written.scene, *written.scene.find("ring"), {1, 0, 0}) == glm::dvec3(-1, 0, 0));
  CHECK(written.engine->normal(written.scene, *written.scene.find("ball"), {0, 12, 0}) == glm::dvec3(0, 1, 0));
}

/// A text with the points of the program's own shapes and of tori, which then decides of all elements.
std::string text_of_all(const test::Folder& folder) {
  const std::string all = folder.file("all.tex");
  std::ofstream out(all);
  for (const std::string& file : {spec, surfaces + "torus.tex"}) out << std::ifstream(file).rdbuf() << '\n';
  return all;
}

/// Elements at small whole numbers, where many meet in one point, and rays between such.
std::string elements_of_whole_numbers(test::Random& random) {
  const auto whole = [&](int least, int most) { return static_cast<int>(random.uniform(least, most + 1)); };
  const auto point = [&] {
    const std::array<int, 3> p{whole(-3, 3), whole(-3, 3), whole(-3, 3)};
    return fmt::format("[{},{},{}]", p[0], p[1], p[2]);
  };
  std::string all = fmt::format(R"({{"id":"wall","tipo":"plano","centro":{},"vector":[0,1,0]}})", point());
  for (int i = 0; i < 3; ++i) {
    const int mayor = whole(2, 3), radio = whole(1, 3);
    all += fmt::format(R"(,{{"id":"ring{}","tipo":"toro","centro":{},"mayor":{},"menor":1}})", i, point(), mayor);
    all += fmt::format(R"(,{{"id":"ball{}","tipo":"esfera","centro":{},"radio":{}}})", i, point(), radio);
    all += fmt::format(R"(,{{"id":"can{}","tipo":"cilindro","centro":{},"radio":1,"vector":[0,0,1],"altura":2}})", i,
                       point());
    all += fmt::format(R"(,{{"id":"leaf{}","tipo":"triangulo","vertices":[{},[7,0,0],[0,7,{}]]}})", i, point(), i);
  }
  return all;
}

TEST_CASE("With the program's own shapes a text answers as one that declares these too") {
  const test::Folder folder;
  const Text own(surfaces + "torus.tex"), all(text_of_all(folder));
  REQUIRE_FALSE(own.declares_shapes());
  REQUIRE(all.declares_shapes());
  test::Random random(5);
  std::size_t ties = 0, met = 0, without_minimum = 0;
  for (std::size_t turn = 0; turn < test::fewer_when_sanitized(30); ++turn) {
    const io::Source source("scene.json", R"({"format":"durero-scene","version":1,"elementos":[)" +
                                              elements_of_whole_numbers(random) + "]}");
    const Written mixed = read(source, own), alone = read(source, all);
    std::vector<scene::Query> queries;
    for (int i = 0; i < 60; ++i) {
      const auto whole = [&](double size) { return glm::dvec3(glm::ivec3(random.in_cube(size))); };
      const glm::dvec3 p = whole(6), v = i % 4 == 0 ? random.direction() : whole(3);
      if (v == glm::dvec3(0)) continue;
      queries.push_back({{model::Punto(p), model::Vector(v)}});
      const scene::Hit hit = engine::first_hit(*alone.engine, queries.back());
      if (hit.resultado != model::Resultado::hit) continue;
      queries.push_back({{model::Punto(hit.punto), model::Vector(random.direction())}, hit.elementos});
    }
    for (const scene::Query& query : queries) {
      const scene::Hit hit = engine::first_hit(*mixed.engine, query), other = engine::first_hit(*alone.engine, query);
      REQUIRE((hit == other));
      REQUIRE(engine::occluded_segment(*mixed.engine, query) == engine::occluded_segment(*alone.engine, query));
      ties += hit.elementos.size() > 1;
      met += hit.resultado == model::Resultado::hit && mixed.scene.name(hit.elementos[0]).name().starts_with("ring");
      without_minimum += hit.resultado == model::Resultado::no_minimum;
      for (const auto stretch : {surface::exact::RayStretch::segment, surface::exact::RayStretch::whole})
        REQUIRE((mixed.engine->points_between(mixed.scene, query, stretch, [](auto) { return true; }) ==
                 alone.engine->points_between(alone.scene, query, stretch, [](auto) { return true; })));
    }
  }
  CHECK(ties > 20);
  CHECK(met > 100);
  CHECK(without_minimum > 0);
}

TEST_CASE("Bodies stand beside surfaces of a text, and tie with them") {
  const Written written = read_text(
      R"({"id":"ring","tipo":"toro","centro":[0,0,0],"mayor":2,"menor":1},
         {"id":"box","tipo":"caja","esquinas":[[-3,-1,-1],[-2.5,1,1]]},
         {"id":"far","tipo":"caja","esquinas":[[5,-1,-1],[6,1,1]]})",
      surfaces + "torus.tex");
  const scene::Hit both = hit_of(written, {-5, 0, 0}, {1, 0, 0});
  CHECK(both.t == 2);
  CHECK(names(written, both) == Names{"box", "ring"});
  CHECK(names(written, hit_of(written, {9, 0, 0}, {-1, 0, 0})) == Names{"far"});
  CHECK(names(written, hit_of(written, {4, 0, 0}, {-1, 0, 0})) == Names{"ring"});
  CHECK(engine::occluded_segment(*written.engine, {{model::Punto(5.5, 4, 0), model::Vector(0, -8, 0)}}));
  CHECK(written.engine->normal(written.scene, *written.scene.find("far"), {5, 0, 0}) == glm::dvec3(-1, 0, 0));
}

TEST_CASE("The points that a ray meets between two are those of every element, and none where one passes no light") {
  const Written written = read_text(
      R"({"id":"ring","tipo":"toro","centro":[0,0,0],"mayor":2,"menor":1},
         {"id":"ball","tipo":"esfera","centro":[6,0,0],"radio":1})",
      surfaces + "torus.tex");
  const scene::Query across{{model::Punto(-4, 0, 0), model::Vector(8, 0, 0)}};
  const scene::ElementRef ring = *written.scene.find("ring"), ball = *written.scene.find("ball");
  const auto segment = surface::exact::RayStretch::segment, whole = surface::exact::RayStretch::whole;
  const auto every = [](scene::ElementRef) { return true; };
  const auto points = written.engine->points_between(written.scene, across, segment, every);
  REQUIRE(points);
  using surface::exact::ElementPoint;
  CHECK((*points ==
         std::vector<ElementPoint>{{ring, {-3, 0, 0}}, {ring, {-1, 0, 0}}, {ring, {1, 0, 0}}, {ring, {3, 0, 0}}}));
  CHECK(written.engine->points_between(written.scene, across, whole, every)->size() == 6);
  CHECK_FALSE(written.engine->points_between(written.scene, across, segment, [&](auto e) { return e != ring; }));
  CHECK(written.engine->points_between(written.scene, across, segment, [&](auto e) { return e != ball; }));
}

}  // namespace
}  // namespace durero::written
