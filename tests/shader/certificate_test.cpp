#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/json/scene_file.hpp"
#include "durero/io/source.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/shader/fragment.hpp"
#include "shader/answers.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"
#include "support/tree.hpp"

using namespace durero;
using namespace durero::test;

#ifndef DURERO_EGL
TEST_CASE("no shader is drawn where EGL and OpenGL ES were not found") { WARN("no shader is drawn"); }
#else

namespace {

scene::Camera camera_at(const glm::dvec3& eye, const glm::dvec3& towards, double fov_y) {
  return {.eye = eye, .look_at = towards, .up = {0.1, 1, 0.05}, .fov_y = fov_y};
}

/// Elements of all types within [−2, 2]³, and a camera.
scene::Scene seen_scene(Random& random, std::size_t elements) {
  scene::Scene scene = random_scene(random, elements);
  scene.stage().camera = camera_at(random.in_cube(1) + glm::dvec3(0, 0, -4), random.in_cube(0.5), 40);
  return scene;
}

DrawnShader answers_of(const scene::Scene& scene) {
  return {shader::fragment_shader(scene, shader::ShaderOutput::answer), true};
}

/// The answers of a certificate whose bound on a rounding is ten thousand times smaller.
DrawnShader with_smaller_bound(const scene::Scene& scene) {
  std::string text = shader::fragment_shader(scene, shader::ShaderOutput::answer);
  const std::string_view bound = "const float U = ";
  text.insert(text.find(bound) + bound.size(), "0.0001 * ");
  return {text, true};
}

/// Whether two rays meet the same elements first.
bool same_first(const scene::Hit& a, const scene::Hit& b) {
  return a.resultado == b.resultado && a.elementos == b.elementos;
}

/// Directions from the eye between which the first element changes: two pixels beside each other, brought together.
std::vector<glm::dvec3> edges_seen(const engine::Engine& engine, const scene::PrimaryRays& rays, std::size_t most) {
  const std::vector<scene::Hit> hits = exact_hits(engine, rays);
  const scene::Resolution size = rays.resolution();
  const auto hit = [&](const glm::dvec3& v) {
    return engine::first_hit(engine, {{model::Punto(rays.eye()), model::Vector(v)}});
  };
  std::vector<glm::dvec3> edges;
  for (std::uint32_t y = 0; y < size.height; ++y)
    for (std::uint32_t x = 0; x + 1 < size.width && edges.size() < most; ++x) {
      const std::size_t at = std::size_t{y} * size.width + x;
      if (same_first(hits[at], hits[at + 1])) continue;
      glm::dvec3 one = rays.ray(x, y).v().xyz(), other = rays.ray(x + 1, y).v().xyz();
      for (int i = 0; i < 45; ++i) {
        const glm::dvec3 middle = 0.5 * (one + other);
        (same_first(hit(middle), hits[at]) ? one : other) = middle;
      }
      edges.push_back(one);
    }
  return edges;
}

}  // namespace

TEST_CASE("no pixel that is not in doubt has another element than the exact one, and few are in doubt") {
  const Offscreen offscreen;
  Random random(20261128);
  AnswerCounts all;
  for (const std::size_t elements : {1, 7, 14, 20, 40, 80}) {
    const scene::Scene scene = seen_scene(random, elements);
    const auto engine = engine::find("fast")->prepare(scene);
    DrawnShader shader = answers_of(scene);
    const AnswerCounts counts =
        counted_answers(shader, scene, *engine, scene::PrimaryRays(*scene.stage().camera, {480, 400}));
    INFO(elements << " elements: " << counts.doubtful << " of " << counts.pixels << " in doubt, " << counts.wrong
                  << " wrong");
    CHECK(counts.wrong == 0);
    CHECK(counts.doubtful * 50 < counts.pixels);
    all += counts;
  }
  CHECK(all.pixels >= 1000000);
  CHECK(all.met * 10 > all.pixels);
  CHECK(all.missed * 50 > all.pixels);
  WARN(offscreen.renderer() << ": " << all.pixels << " pixels, " << all.doubtful << " in doubt");
}

TEST_CASE("next to an edge a pixel is in doubt or exact, both are there, and a bound that is too small is seen") {
  const Offscreen offscreen;
  Random random(48);
  AnswerCounts all, by_less;
  for (int round = 0; round < 4; ++round) {
    scene::Scene scene = seen_scene(random, 12);
    const auto engine = engine::find("fast")->prepare(scene);
    DrawnShader shader = answers_of(scene), too_sure = with_smaller_bound(scene);
    const glm::dvec3 eye = scene.stage().camera->eye;
    for (const glm::dvec3& way : edges_seen(*engine, {*scene.stage().camera, {61, 43}}, 60)) {
      const scene::PrimaryRays rays(camera_at(eye, eye + way, 0.001 * (1 + double(all.pixels % 7))), {40, 40});
      all += counted_answers(shader, scene, *engine, rays);
      by_less += counted_answers(too_sure, scene, *engine, rays);
    }
  }
  INFO(all.doubtful << " of " << all.pixels << " in doubt, " << all.wrong << " wrong");
  CHECK(all.pixels > 100000);
  CHECK(all.wrong == 0);
  CHECK(all.doubtful * 50 > all.pixels);
  CHECK(all.doubtful * 4 < 3 * all.pixels);
  CHECK(by_less.wrong > 10);
  WARN(all.pixels << " pixels next to edges, " << all.doubtful << " in doubt; by a bound of 1/10000, " << by_less.wrong
                  << " wrong");
}

TEST_CASE("at the side of a wide picture a direction is rounded most: what is seen there is in doubt or exact") {
  const Offscreen offscreen;
  Random random(7);
  scene::Scene scene;
  scene.add(model::Elemento("ball"), scene::Sphere{{0, 0, 128}, 0.125});
  scene.stage().camera = camera_at({0, 0, 0}, {0, 0, 1}, 120);
  const auto engine = engine::find("fast")->prepare(scene);
  DrawnShader shader = answers_of(scene);
  AnswerCounts all;
  for (int i = 0; i < 1000; ++i) {
    // A corner of the picture looks along the edge of the ball, to a few parts in 10⁶.
    const double angle = random.uniform(0, 6.28), sine = 0.125 / 128 + random.uniform(-6e-6, 6e-6);
    const glm::dvec3 way(sine * std::cos(angle), sine * std::sin(angle), std::sqrt(1 - sine * sine));
    scene::Camera camera = *scene.stage().camera;
    const glm::dvec3 corner = glm::normalize(scene::PrimaryRays(camera, {8, 8}).ray(0, 0).v().xyz());
    const glm::dvec3 axis = glm::normalize(glm::cross(corner, way));
    const double cosine = glm::dot(corner, way), turn = std::sqrt(1 - cosine * cosine);
    const auto turned = [&](const glm::dvec3& x) {
      return cosine * x + turn * glm::cross(axis, x) + (1 - cosine) * glm::dot(axis, x) * axis;
    };
    camera.look_at = turned(camera.look_at);
    camera.up = turned(camera.up);
    camera.mirrored = i % 2 == 1;
    all += counted_answers(shader, scene, *engine, {camera, {8, 8}});
  }
  CHECK(all.wrong == 0);
  CHECK(all.doubtful > 100);
  CHECK(all.met > 100);
}

TEST_CASE("at the horizon of a plane, and along the axis of a cylinder, a pixel is in doubt or exact") {
  const Offscreen offscreen;
  scene::Scene scene;
  const glm::dvec3 up = glm::normalize(glm::dvec3(0.1, 1, 0.05)), along = glm::cross(up, {0.6, 0, 0.8});
  scene.add(model::Elemento("ground"), scene::Plane{{0, 0, 0}, up});
  scene.add(model::Elemento("tube"), scene::Cylinder{3.0 * up, 0.5, up, 4});
  const auto engine = engine::find("fast")->prepare(scene);
  scene.stage().camera = camera_at({0, 1, 0}, {0, 1, 1}, 40);
  DrawnShader shader = answers_of(scene);
  for (const double fov : {3e-5, 1e-3, 20.0}) {
    const glm::dvec3 eye = 1.7 * up + 0.3 * along;
    const scene::PrimaryRays horizon({eye, eye + along, up, fov}, {48, 48});
    const AnswerCounts counts = counted_answers(shader, scene, *engine, horizon);
    CHECK(counts.wrong == 0);
    CHECK((counts.met > 500 || fov < 1e-4));
    CHECK((counts.missed > 500 || fov < 1e-4));
    CHECK((counts.doubtful > 500 || fov > 1e-4));
    const scene::PrimaryRays axis({eye, eye + up, along, fov}, {48, 48});
    CHECK(counted_answers(shader, scene, *engine, axis).wrong == 0);
  }
}

TEST_CASE("where two elements are one point for all of a surface, every pixel of it is in doubt") {
  const Offscreen offscreen;
  scene::Scene scene;
  scene.add(model::Elemento("one"), scene::Sphere{{0, 0, 0}, 1});
  scene.add(model::Elemento("other"), scene::Sphere{{0, 0, 0}, 1});
  scene.stage().camera = camera_at({0, 0, -4}, {0, 0, 0}, 20);
  const auto engine = engine::find("fast")->prepare(scene);
  DrawnShader shader = answers_of(scene);
  const AnswerCounts counts =
      counted_answers(shader, scene, *engine, scene::PrimaryRays(*scene.stage().camera, {64, 64}));
  CHECK(counts.wrong == 0);
  CHECK(counts.met == 0);
  CHECK(counts.doubtful > 2000);
}

TEST_CASE("far from the origin, where binary32 is coarse, more is in doubt and nothing is wrong") {
  const Offscreen offscreen;
  std::size_t before = 0;
  for (const double far : {0.0, 1e3, 1e5, 1e7}) {
    const glm::dvec3 at(far, -far, far);
    scene::Scene scene;
    scene.add(model::Elemento("ball"), scene::Sphere{at, 1});
    scene.add(model::Elemento("rod"), scene::Cylinder{at + glm::dvec3(0.5, -1, 0), 0.3, {0, 1, 0}, 2});
    scene.stage().camera = camera_at(at + glm::dvec3(0, 0, -5), at, 40);
    const auto engine = engine::find("fast")->prepare(scene);
    DrawnShader shader = answers_of(scene);
    const AnswerCounts counts =
        counted_answers(shader, scene, *engine, scene::PrimaryRays(*scene.stage().camera, {96, 96}));
    CHECK(counts.wrong == 0);
    CHECK(counts.doubtful >= before);
    before = counts.doubtful;
  }
  CHECK(before > 5000);
}

#endif
