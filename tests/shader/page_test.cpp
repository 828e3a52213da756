#include "durero/shader/page.hpp"

#include <stdexcept>

#include "durero/model/operaciones.hpp"
#include "durero/scene/stage.hpp"
#include "durero/shader/fragment.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

scene::Scene ball() {
  scene::Scene scene;
  scene.add(model::Elemento("ball"), scene::Sphere{{0, 0, 0}, 1});
  scene.stage().camera = scene::Camera{{0, 0.25, -4}, {0, 0, 0}, {0, 1, 0}, 40};
  return scene;
}

}  // namespace

TEST_CASE("a page has its shaders, its camera and its names, and asks no other file") {
  const scene::Scene scene = ball();
  const std::string page = shader::shader_page(scene, "ball <1> & more");
  CHECK_THAT(page, Catch::Contains(shader::fragment_shader(scene, shader::ShaderOutput::color)));
  CHECK_THAT(page, Catch::Contains(std::string(shader::vertex_shader())));
  CHECK_THAT(
      page,
      Catch::Contains("{ eye: [0, 0.25, -4], look_at: [0, 0, 0], up: [0, 1, 0], fov_y: 40, aspect: 1.7777777777777777, "
                      "mirrored: false }"));
  CHECK_THAT(page, Catch::Contains("const names = [\"ball\"];"));
  CHECK_THAT(page, Catch::Contains("<title>ball &lt;1> &amp; more</title>"));
  for (const char* other : {"http:", "https:", "src=", "href=", "import(", "fetch(", "@TITLE@", "@CAMERA@", "@NAMES@"})
    CHECK_THAT(page, !Catch::Contains(other));
}

TEST_CASE("a scene that a shader cannot hold has no page") {
  scene::Scene scene = ball();
  scene.stage().camera->aperture = 1;
  CHECK_THROWS_AS(shader::shader_page(scene, "lens"), std::domain_error);
}
