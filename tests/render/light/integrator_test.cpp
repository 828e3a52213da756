// Path tracing, held to what can be known without it: furnaces, balances, and means that must agree.
#include "durero/render/light/integrator.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "durero/model/operaciones.hpp"
#include "durero/render/render.hpp"
#include "durero/render/sample/maps.hpp"
#include "durero/scene/stage.hpp"
#include "render/light/follower.hpp"
#include "support/catch.hpp"

using namespace durero;
using render::Integrator;
using render::LightSampling;
using scene::Material;

namespace {

/// A mean and its standard deviation.
struct Mean {
  double value, deviation;
};

Mean mean_of(const std::vector<double>& all) {
  double sum = 0, squares = 0;
  for (const double one : all) sum += one, squares += one * one;
  const auto n = static_cast<double>(all.size());
  return {sum / n, std::sqrt(std::max(0.0, squares - sum * sum / n) / (n - 1) / n)};
}

/// What independent samples bring along rays of their own: red.
Mean brought(const render::Follower& follower, const std::vector<scene::Query>& rays) {
  std::vector<render::SampleSource> sources(rays.size());
  for (std::uint32_t i = 0; i < rays.size(); ++i) sources[i] = {render::key_of(i >> 16, 0, 0), i & 0xFFFF, true};
  std::vector<double> all;
  for (const render::PathRadiance& one : follower.brought(rays, sources)) all.push_back(one.color.x);
  return mean_of(all);
}

constexpr render::PathLimits paths(LightSampling sampling = LightSampling::both) {
  return {.max_depth = 1000, .integrator = Integrator::path, .light_sampling = sampling};
}

void put(scene::Scene& scene, const char* name, const Material& material) {
  scene.stage().materials.push_back(material);
  scene.set_material(*scene.find(name), static_cast<std::uint32_t>(scene.stage().materials.size() - 1));
}

/// A wall of two triangles: a corner and two edges.
void add_wall(scene::Scene& scene, const std::string& name, const glm::dvec3& corner, const glm::dvec3& u,
              const glm::dvec3& v, const Material& material) {
  using model::Punto;
  scene.apply(
      model::Agregar_Triangulo{model::Elemento(name + "1"), {Punto(corner), Punto(corner + u), Punto(corner + v)}});
  scene.apply(model::Agregar_Triangulo{model::Elemento(name + "2"),
                                       {Punto(corner + u + v), Punto(corner + v), Punto(corner + u)}});
  put(scene, (name + "1").c_str(), material);
  put(scene, (name + "2").c_str(), material);
}

Material grey(double share) { return {.name = "", .color = glm::dvec3(share)}; }

/// A closed box after that of Cornell, from (0, 0, 0) to (2, 2, 2), a disc under its lid that shines on both sides, and
/// a ball of the material.
scene::Scene cornell(const Material& ball) {
  scene::Scene scene;
  add_wall(scene, "floor", {0, 0, 0}, {2, 0, 0}, {0, 0, 2}, grey(0.7));
  add_wall(scene, "lid", {0, 2, 0}, {2, 0, 0}, {0, 0, 2}, grey(0.7));
  add_wall(scene, "back", {0, 0, 2}, {2, 0, 0}, {0, 2, 0}, grey(0.7));
  add_wall(scene, "front", {0, 0, 0}, {2, 0, 0}, {0, 2, 0}, grey(0.7));
  add_wall(scene, "left", {0, 0, 0}, {0, 2, 0}, {0, 0, 2}, grey(0.6));
  add_wall(scene, "right", {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, grey(0.1));
  scene.apply(model::Agregar_Disco{model::Elemento("lamp"), {1, 1.9, 1}, 0.4, {0, 1, 0}});
  put(scene, "lamp", {.name = "", .color = glm::dvec3(0.5), .emission = glm::dvec3(10)});
  scene.apply(model::Agregar_Esfera{model::Elemento("ball"), {1.3, 0.5, 1.2}, 0.5});
  put(scene, "ball", ball);
  return scene;
}

}  // namespace

TEST_CASE("a closed furnace shines by 1/(1 - a), of any shape and at any place") {
  for (const double albedo : {0.5, 0.9}) {
    const Material wall{.name = "", .color = glm::dvec3(albedo), .emission = glm::dvec3(1)};
    scene::Scene ball;
    ball.apply(model::Agregar_Esfera{model::Elemento("ball"), {0, 0, 0}, 1});
    put(ball, "ball", wall);
    scene::Scene can;
    can.apply(model::Agregar_Cilindro{model::Elemento("can"), {0, -1, 0}, 0.7, {0, 1, 0}, 2});
    can.apply(model::Agregar_Disco{model::Elemento("bottom"), {0, -1, 0}, 0.7, {0, 1, 0}});
    can.apply(model::Agregar_Cono{model::Elemento("top"), {0, 1, 0}, 0.7, {0, 1, 0}, 1});
    for (const char* name : {"can", "bottom", "top"}) put(can, name, wall);
    for (const scene::Scene* furnace : {&ball, &can})
      for (const LightSampling sampling : {LightSampling::both, LightSampling::lights, LightSampling::directions}) {
        const auto engine = engine::find("fast")->prepare(*furnace);
        const render::Follower follower(*furnace, *engine, paths(sampling));
        const Mean seen = brought(follower, std::vector<scene::Query>(8192, {{{0.2, 0.3, 0.1}, {0.3, 0.7, 0.2}}}));
        CHECK(seen.value == Approx(1 / (1 - albedo)).margin(3 * seen.deviation + 1e-9));
        CHECK(seen.deviation < 0.15);
      }
  }
}

TEST_CASE("every material that sends on all that it receives is invisible in an even light") {
  const Material all[] = {{.name = "", .color = glm::dvec3(1)},
                          {.name = "", .color = glm::dvec3(0), .k_ps = 1},
                          {.name = "", .color = glm::dvec3(0), .k_ps = 1, .gloss = 12},
                          {.name = "", .color = glm::dvec3(0), .k_t = 1, .index = 1.5},
                          {.name = "", .color = glm::dvec3(0.25), .k_ps = 0.5, .gloss = 5, .k_t = 0.25, .index = 1.5}};
  for (const Material& material : all) {
    scene::Scene scene;
    scene.stage().background = glm::dvec3(1);
    scene.apply(model::Agregar_Esfera{model::Elemento("ball"), {0, 0, 0}, 1});
    put(scene, "ball", material);
    const auto engine = engine::find("fast")->prepare(scene);
    const render::Follower follower(scene, *engine, paths());
    const Mean seen = brought(follower, std::vector<scene::Query>(4096, {{{0, 0.6, -3}, {0, 0, 1}}}));
    CHECK(seen.value == Approx(1).margin(3 * seen.deviation + 1e-9));
    CHECK(seen.deviation < 0.02);
  }
}

TEST_CASE("a highlight sends on 2 k_s/(e + 1) of an even light, from above") {
  scene::Scene scene;
  scene.stage().background = glm::dvec3(1);
  scene.apply(model::Agregar_Disco{model::Elemento("disc"), {0, 0, 0}, 1, {0, 1, 0}});
  put(scene, "disc", {.name = "", .color = glm::dvec3(0.5), .k_d = 0.4, .k_s = 0.9, .e = 9});
  const auto engine = engine::find("fast")->prepare(scene);
  const render::Follower follower(scene, *engine, paths());
  const Mean seen = brought(follower, std::vector<scene::Query>(16384, {{{0, 1, 0}, {0, -1, 0}}}));
  CHECK(seen.value == Approx(0.2 + 2 * 0.9 / 10).margin(3 * seen.deviation));
}

TEST_CASE("lights of the stage give a path what Whitted's local model gives, but for k_a and ambient") {
  scene::Scene scene;
  scene.stage().lights = {{{1, 3, 1}, {2, 1, 0.5}}};
  scene.stage().directional_lights = {{{1, -1, 0}, {0.5, 0.5, 1}}};
  scene.apply(model::Agregar_Plano{model::Elemento("floor"), {0, 0, 0}, {0, 1, 0}});
  put(scene, "floor", {.name = "", .color = {0.5, 0.6, 0.7}, .k_d = 0.8, .k_s = 0.3, .e = 7});
  const auto engine = engine::find("fast")->prepare(scene);
  const scene::Query query{{{0, 1, 0}, {0.4, -1, 0.3}}};
  const glm::dvec3 whitted = render::brought(scene, *engine, {&query, 1}, {1}).at(0).color;
  // The background is black, and a floor alone sends itself no light: of any depth it is lit by its lights alone.
  render::PathLimits limits = paths();
  limits.max_depth = 1;
  const glm::dvec3 lit = render::brought(scene, *engine, {&query, 1}, limits).at(0).color;
  CHECK(render::brought(scene, *engine, {&query, 1}, paths()).at(0).color == lit);
  for (int i = 0; i < 3; ++i) CHECK(lit[i] == Approx(whitted[i]));
}

TEST_CASE("in a closed box all that shines is taken: the balance of Cornell's box") {
  // With black walls but for their albedo, each surface of the area A takes (1 − a)·E·A of the irradiance E.
  const scene::Scene scene = cornell(grey(0.4));
  const auto engine = engine::find("fast")->prepare(scene);
  const render::Follower follower(scene, *engine, paths());
  double taken = 0, doubt = 0;
  scene.for_each([&](scene::ElementRef element, const auto& shape) {
    const double albedo = scene.stage().materials[*scene.material(element)].color.x;
    std::vector<scene::Query> rays;
    double area = 0;
    for (std::uint32_t i = 0; i < 4096; ++i) {
      const render::SampleSource source{render::key_of(element.index, 5, 0), i};
      const glm::dvec2 place = source.pair(0), turn = source.pair(1);
      glm::dvec3 point, normal;
      using Shape = std::decay_t<decltype(shape)>;
      if constexpr (std::is_same_v<Shape, scene::Triangle>) {
        const auto& [a, b, c] = shape.vertices;
        const glm::dvec2 w = render::in_triangle(place);
        point = a + w.x * (b - a) + w.y * (c - a);
        const glm::dvec3 across = glm::cross(b - a, c - a);
        area = glm::length(across) / 2;
        normal = glm::normalize(across);
        if (glm::dot(normal, glm::dvec3(1) - point) < 0) normal = -normal;  // into the box
      } else if constexpr (std::is_same_v<Shape, scene::Sphere>) {
        normal = render::on_sphere(place);
        point = shape.centro + shape.radio * normal;
        area = 4 * std::numbers::pi * shape.radio * shape.radio;
      } else if constexpr (std::is_same_v<Shape, scene::Disc>) {
        const glm::dvec2 w = shape.radio * render::in_disc(place);
        point = shape.centro + glm::dvec3(w.x, 0, w.y);
        normal = i % 2 == 0 ? shape.vector : -shape.vector;
        area = 2 * std::numbers::pi * shape.radio * shape.radio;
      }
      rays.push_back({{model::Punto(point), model::Vector(render::by_cosine(turn, normal))}, {element}});
    }
    const Mean incoming = brought(follower, rays);
    const double share = (1 - albedo) * area * std::numbers::pi;
    taken += share * incoming.value;
    doubt += std::pow(share * incoming.deviation, 2);
  });
  const double shone = 2 * std::numbers::pi * 0.4 * 0.4 * std::numbers::pi * 10;
  CHECK(taken == Approx(shone).margin(3 * std::sqrt(doubt)));
  CHECK(std::sqrt(doubt) < 0.02 * shone);
}

TEST_CASE("points of lights, directions of surfaces and both together have one mean; both together err least") {
  const Material satin{.name = "", .color = glm::dvec3(0.2), .k_ps = 0.6, .gloss = 30};
  const Material glass{.name = "", .color = glm::dvec3(0), .k_ps = 0.1, .k_t = 0.85, .index = 1.5};
  for (const Material& ball : {satin, glass}) {
    const scene::Scene scene = cornell(ball);
    const auto engine = engine::find("fast")->prepare(scene);
    std::map<LightSampling, Mean> means;
    for (const LightSampling sampling : {LightSampling::both, LightSampling::lights, LightSampling::directions}) {
      const render::Follower follower(scene, *engine, paths(sampling));
      std::vector<scene::Query> rays;
      for (std::uint32_t i = 0; i < 16384; ++i) {
        const glm::dvec2 place = render::SampleSource{3, i}.pair(0);
        rays.push_back({{{1, 1, 0.2}, {place.x - 0.5, place.y - 0.7, 1}}});
      }
      means[sampling] = brought(follower, rays);
    }
    const auto agree = [&](LightSampling a, LightSampling b) {
      CHECK(std::abs(means[a].value - means[b].value) < 3 * std::hypot(means[a].deviation, means[b].deviation));
    };
    agree(LightSampling::both, LightSampling::lights);
    agree(LightSampling::both, LightSampling::directions);
    CHECK(means[LightSampling::both].deviation <= 1.05 * means[LightSampling::lights].deviation);
    CHECK(means[LightSampling::both].deviation < means[LightSampling::directions].deviation);
  }
}

TEST_CASE("64 seeds have the mean of one long run") {
  scene::Scene scene = cornell({.name = "", .color = glm::dvec3(0.3), .k_ps = 0.5, .gloss = 100});
  scene.stage().camera = scene::Camera{{1, 1, 0.1}, {1, 0.8, 2}, {0, 1, 0}, 80};
  const auto engine = engine::find("fast")->prepare(scene);
  const auto light = [&](std::uint32_t seed, std::uint32_t most) {
    const render::RenderSettings frame{.size = scene::Resolution{8, 6},
                                       .samples = {.sampling = render::Sampling::net, .most = most, .seed = seed},
                                       .integrator = Integrator::path};
    double sum = 0;
    for (const glm::dvec3& color : render::render(scene, *engine, {}, frame).rgb) sum += color.x;
    return sum / 48;
  };
  std::vector<double> seeds;
  for (std::uint32_t seed = 1; seed <= 64; ++seed) seeds.push_back(light(seed, 9));
  const Mean mean = mean_of(seeds);
  // The long run has 1.8 times the samples of all seeds together, so that its own deviation is no more than theirs.
  CHECK(mean.value == Approx(light(0, 1024)).margin(3 * std::sqrt(2) * mean.deviation));
  CHECK(mean.deviation < 0.02 * mean.value);
}

TEST_CASE("paths go as deep as they must, and Whitted's rays as their materials need") {
  scene::Stage stage;
  CHECK(render::depth_of(stage) == 1);
  CHECK(render::depth_of(stage, Integrator::path) == scene::greatest_depth);
  stage.max_depth = 7;
  CHECK(render::depth_of(stage, Integrator::path) == 7);
}
