#include "durero/shader/fragment.hpp"

#include <cmath>
#include <stdexcept>

#include "durero/model/operaciones.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"

using namespace durero;
using namespace durero::test;
using shader::ShaderOutput;

namespace {

scene::Scene ball() {
  scene::Scene scene;
  scene.stage().materials = {{.name = "m", .color = {0.5, 0.5, 0.5}}};
  scene.add(model::Elemento("ball"), scene::Sphere{{0, 0, 0}, 1}, 0);
  scene.stage().camera = scene::Camera{{0, 0, -4}, {0, 0, 0}, {0, 1, 0}, 40};
  return scene;
}

std::string refusal(const scene::Scene& scene) {
  try {
    shader::fragment_shader(scene, ShaderOutput::color);
  } catch (const std::domain_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a shader holds constants of its scene, and its outputs differ in one line") {
  const scene::Scene scene = ball();
  const std::string color = shader::fragment_shader(scene, ShaderOutput::color);
  CHECK_THAT(color, Catch::StartsWith("#version 300 es\n"));
  CHECK_THAT(color, Catch::Contains("// 0 ball\n"));
  CHECK_THAT(color, Catch::Contains("#define SPHERES 1\n#define ROUNDS 0\n"));
  CHECK_THAT(color, Catch::Contains("vec4 SPHERE[1] = vec4[1](\n    vec4(0.0, 0.0, 0.0, 1.0));"));
  std::string answer = shader::fragment_shader(scene, ShaderOutput::answer);
  answer.replace(answer.find("#define WRITES 1"), 16, "#define WRITES 0");
  CHECK(answer == color);
  CHECK_THAT(std::string(shader::vertex_shader()), Catch::StartsWith("#version 300 es\n"));
}

TEST_CASE("what a shader cannot hold is refused by name") {
  scene::Scene scene = ball();
  scene::Stage& stage = scene.stage();
  CHECK(refusal(scene).empty());
  const auto with_material = [&](const scene::Material& material) {
    scene::Scene other = ball();
    other.stage().materials = {material};
    other.stage().textures = {{.name = "t", .pattern = scene::Pattern::image}};
    return refusal(other);
  };
  CHECK(with_material({.name = "m", .bump = scene::Bump{.texture = "t"}}) ==
        "material m has a relief; expected none in a shader");
  CHECK(with_material({.name = "m", .gloss = 20}) == "material m has a gloss; expected none in a shader");
  scene::Material image{.name = "m"};
  image.textures.names[0] = "t";
  CHECK(with_material(image) == "material m has an image; expected none in a shader");
  stage.environment = scene::Environment{.kind = scene::Surroundings::spherical};
  CHECK(refusal(scene) == "the environment is a picture; expected a gradient or a background in a shader");
  stage.environment.reset();
  stage.lights = {{.position = {0, 1e60, 0}, .color = {1, 1, 1}}};
  CHECK(refusal(scene) == "a number of the scene is beyond binary32; expected smaller ones in a shader");
  stage.lights.clear();
  scene.add(model::Elemento("far"), scene::Sphere{{0, 3e7, 0}, 1});
  CHECK(refusal(scene) == "element far has a number beyond 2^24; expected smaller ones in a shader");
  stage.camera.reset();
  CHECK(refusal(scene) == "the scene has no camera; expected one");
}

TEST_CASE("elements that a shader cannot hold are refused by name, and too many and none") {
  scene::Scene scene = ball();
  scene.add(model::Elemento("cone"), scene::TruncatedCone{{0, 0, 0}, 1, 1e-9, {0, 1, 0}, 1});
  CHECK(refusal(scene) == "element cone has a number beyond 2^24; expected smaller ones in a shader");
  scene = ball();
  scene.add(model::Elemento("sail"), scene::Triangle{{glm::dvec3(0, 0, 0), {1, 0, 0}, {0, 1, 0}}});
  scene.set_vertex_normals(*scene.find("sail"), {glm::dvec3(0, 0, 1), {0, 0, 1}, {0, 1, 1}});
  CHECK(refusal(scene) == "element sail has normals at its vertices; expected none in a shader");
  Random random(1);
  scene = random_scene(random, 257);
  scene.stage().camera = ball().stage().camera;
  CHECK(refusal(scene) == "the scene has 257 elements; expected 1 to 256 in a shader");
  scene = scene::Scene();
  scene.stage().camera = ball().stage().camera;
  CHECK(refusal(scene) == "the scene has 0 elements; expected 1 to 256 in a shader");
}

TEST_CASE("at most fifteen materials let light through") {
  scene::Scene scene = ball();
  for (int i = 0; i < 16; ++i) {
    scene.stage().materials.push_back({.name = "n" + std::to_string(i), .k_t = 0.5});
    scene.add(model::Elemento("e" + std::to_string(i)), scene::Sphere{{i, 0, 0}, 1}, i + 1);
  }
  CHECK(refusal(scene) == "16 materials let light through; expected 15 at most in a shader");
}

TEST_CASE("a view has the rays of its camera, to the rounding of binary32") {
  scene::Camera camera{{1.5, -2, 3}, {0.25, 1, 0.5}, {0.1, 1, 0}, 37};
  camera.mirrored = GENERATE(false, true);
  const scene::PrimaryRays rays(camera, {321, 200});
  const shader::ShaderView view(rays);
  CHECK(view.size == std::array{321.0F, 200.0F});
  for (const auto& [x, y] : {std::pair{0U, 0U}, std::pair{320U, 0U}, std::pair{17U, 199U}}) {
    const model::Rayo ray = rays.ray(x, y);
    const double right = x + 0.5 - 321 / 2.0, up = 200 / 2.0 - y - 0.5;
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(double(view.eye[i]) == ray.p().xyz()[int(i)]);
      CHECK(view.forward[i] + right * view.step_x[i] + up * view.step_y[i] ==
            Approx(ray.v().xyz()[int(i)]).margin(1e-7));
    }
  }
}
