#include "durero/scene/stage.hpp"

#include "support/catch.hpp"

using namespace durero::scene;

namespace {

Stage whole() {
  return {.camera = Camera{{0, 0, -5}, {0, 0, 0}, {0, 1, 0}, 45},
          .resolution = Resolution{640, 480},
          .background = glm::dvec3(0.5),
          .lights = {{{0, 9, 0}, {1, 1, 1}}},
          .materials = {{"red", {1, 0, 0}}}};
}

}  // namespace

TEST_CASE("a stage starts without any part, and what is absent is not what is 0") {
  const Stage none;
  CHECK_FALSE((none.camera || none.resolution || none.background));
  CHECK(none.lights.empty());
  CHECK(none.materials.empty());
  Stage black;
  black.background = glm::dvec3(0);
  CHECK_FALSE(black == none);
}

TEST_CASE("stages are equal where every number of every part is") {
  CHECK(whole() == whole());
  CHECK_FALSE(whole() == Stage());
  const auto differs = [](auto change) {
    Stage stage = whole();
    change(stage);
    return !(stage == whole());
  };
  CHECK(differs([](Stage& s) { s.camera->eye.x = 1; }));
  CHECK(differs([](Stage& s) { s.camera->look_at.x = 1; }));
  CHECK(differs([](Stage& s) { s.camera->up.x = 1; }));
  CHECK(differs([](Stage& s) { s.camera->fov_y = 46; }));
  CHECK(differs([](Stage& s) { s.resolution->width = 641; }));
  CHECK(differs([](Stage& s) { s.resolution->height = 481; }));
  CHECK(differs([](Stage& s) { s.background = std::nullopt; }));
  CHECK(differs([](Stage& s) { s.lights[0].position.x = 1; }));
  CHECK(differs([](Stage& s) { s.lights[0].color.x = 0; }));
  CHECK(differs([](Stage& s) { s.lights.clear(); }));
  CHECK(differs([](Stage& s) { s.materials[0].name = "rot"; }));
  CHECK(differs([](Stage& s) { s.materials[0].color.x = 0; }));
  CHECK(differs([](Stage& s) { s.materials[0].textures.names[0] = "a"; }));
  CHECK(differs([](Stage& s) { s.materials[0].bump = Bump{"a"}; }));
  CHECK(differs([](Stage& s) { s.textures = {{.name = "a"}}; }));
  CHECK(differs([](Stage& s) { s.environment = Environment{}; }));
}
