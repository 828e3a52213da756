#include "durero/conform/families/asked_surface.hpp"

#include "durero/conform/judge/truth.hpp"
#include "durero/written/engine.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"
#include "support/tree.hpp"

using namespace durero;
using namespace durero::conform;

TEST_CASE("surfaces of a scene by a text are found beside its shapes, and met where the text says") {
  const std::string folder = test::source_dir() + "/demo/surfaces/";
  const auto text = std::make_shared<const written::Text>(folder + "torus.tex");
  const written::Written read = written::read(io::read_source(folder + "torus.json"), *text, io::Bodies::refused);
  const std::vector<NamedSurface> all = surfaces_of(read.scene, read.elements, text);
  REQUIRE(all.size() == 1);
  CHECK(read.scene.name(all[0].element).name() == "ring");
  CHECK(all[0].surface.type == "toro");
  const OtherElements others({}, all);
  CHECK(others.surface(all[0].element) == &all[0].surface);
  CHECK(others.surface(*read.scene.find("ball")) == nullptr);
  CHECK(others.body(all[0].element) == nullptr);

  // Along x through the middle, at the height of the ball's middle: four points of the ring, and two of the ball.
  const scene::Query ray{test::ray(glm::dvec3(-10, 0.5, 0), glm::dvec3(1, 0, 0)), {}};
  const SceneTruths truths(read.scene, 1, others);
  const ExactAnswer answer = truths.with_all(ray);
  REQUIRE(answer.all.size() == 6);
  CHECK(answer.hit.elementos == scene::ElementSet{all[0].element});
  CHECK(answer.all[2].elementos == scene::ElementSet{*read.scene.find("ball")});
  CHECK(all_crossings(read.scene, ray, others).size() == 6);
  std::vector<scene::Hit> hits(1);
  read.engine->first_hits(std::vector{ray}, hits);
  CHECK(hits[0].t == answer.hit.t);
  CHECK(truths.within(ray, {9, 12}).hit.elementos == answer.all[2].elementos);
}
