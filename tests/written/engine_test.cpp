#include "durero/written/engine.hpp"

#include "durero/conform/families/families.hpp"
#include "durero/io/json/scene_file.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
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

}  // namespace
}  // namespace durero::written
