// R42 and R43: a sphere is the unit ball by a map, an upright cylinder and cone are those of one, byte for byte.
#include "durero/composed/engine.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>
#include <tuple>

#include "durero/conform/families/families.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/body.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using model::Resultado;

namespace {

const engine::EngineRow& row(std::string_view name) { return *engine::find(name); }

model::ExactVector exact(const glm::dvec3& v) { return {number::exact(v.x), number::exact(v.y), number::exact(v.z)}; }

model::Mapa stretched(const glm::dvec3& centro, double across, double along) {
  const auto r = number::exact(across), h = number::exact(along);
  return {exact(centro), {r, 0, 0}, {0, r, 0}, {0, 0, h}};
}

void add_body(scene::Scene& scene, const model::Elemento& name, scene::Body body) {
  scene.set_body(test::add(scene, name, scene::stand_in), std::move(body));
}

/// What the shape is as an instance of that of one, where it is one; else as an instance of itself.
scene::Instance as_instance(const scene::Sphere& s) {
  return {scene::Sphere{{0, 0, 0}, 1}, stretched(s.centro, s.radio, s.radio)};
}
scene::Instance as_instance(const scene::Cylinder& s) {
  if (s.vector != glm::dvec3(0, 0, 1)) return {s, model::identity()};
  return {scene::Cylinder{{0, 0, 0}, 1, {0, 0, 1}, 1}, stretched(s.centro, s.radio, s.altura)};
}
scene::Instance as_instance(const scene::Cone& s) {
  if (s.vector != glm::dvec3(0, 0, 1)) return {s, model::identity()};
  model::Mapa mapa = stretched(s.centro, 1, s.altura);
  mapa.x.x = mapa.y.y = number::exact(s.proporcion) * number::exact(s.altura);
  return {scene::Cone{{0, 0, 0}, 1, {0, 0, 1}, 1}, mapa};
}
template <class Shape>
scene::Instance as_instance(const Shape& shape) {
  return {shape, model::identity()};
}

/// The same scene with every `one_of`-th element as an instance.
scene::Scene with_instances(const scene::Scene& of, std::size_t one_of) {
  scene::Scene scene;
  std::size_t i = 0;
  of.for_each([&](scene::ElementRef e, const auto& shape) {
    if (i++ % one_of == 0) {
      add_body(scene, of.name(e), {as_instance(shape)});
    } else {
      test::add(scene, of.name(e), shape);
    }
  });
  return scene;
}

/// Everything that a hit says, elements by their names.
using Said = std::tuple<Resultado, double, glm::dvec3, std::vector<std::string>>;

Said said(const scene::Scene& scene, const scene::Hit& hit) {
  std::vector<std::string> names;
  for (const scene::ElementRef element : hit.elementos) names.push_back(scene.name(element).name());
  std::ranges::sort(names);
  return {hit.resultado, hit.t, hit.punto, names};
}

/// The query with its elements in another scene.
scene::Query in(const scene::Scene& there, const scene::Scene& here, const scene::Query& query) {
  scene::Query moved{query.rayo, {}};
  for (const scene::ElementRef e : query.en) moved.en.push_back(*there.find(here.name(e).name()));
  std::ranges::sort(moved.en);
  return moved;
}

/// The points that stand before a light, elements by their names; nothing where one of them passes none.
using Between = std::optional<std::vector<std::pair<std::string, glm::dvec3>>>;

Between between(const engine::Engine& engine, const scene::Scene& scene, const scene::Query& query,
                surface::exact::RayStretch stretch, std::string_view opaque) {
  const auto points =
      engine.points_between(scene, query, stretch, [&](scene::ElementRef e) { return scene.name(e).name() != opaque; });
  if (!points) return std::nullopt;
  std::vector<std::pair<std::string, glm::dvec3>> named;
  for (const auto& [element, point] : *points) named.emplace_back(scene.name(element).name(), point);
  return named;
}

/// The first element, which with_instances makes an instance.
std::string first_name(const scene::Scene& scene) {
  std::string first;
  scene.for_each([&](scene::ElementRef e, const auto&) {
    if (first.empty()) first = scene.name(e).name();
  });
  return first;
}

void check_same(const scene::Scene& plain, const std::vector<scene::Query>& rays, std::size_t one_of) {
  const scene::Scene scene = with_instances(plain, one_of);
  const auto expected = row("exact").prepare(plain);
  const auto engine = composed::prepared(row("fast"), scene);
  std::vector<scene::Query> queries;
  for (const scene::Query& ray : rays) queries.push_back(in(scene, plain, ray));
  const auto hits = engine::first_hits(*engine, queries);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    REQUIRE(said(scene, hits[i]) == said(plain, engine::first_hit(*expected, rays[i])));
    REQUIRE(engine::occluded_segment(*engine, queries[i]) == engine::occluded_segment(*expected, rays[i]));
    for (const auto stretch : {surface::exact::RayStretch::segment, surface::exact::RayStretch::whole})
      for (const std::string& opaque : {std::string(), first_name(plain)})
        REQUIRE(between(*engine, scene, queries[i], stretch, opaque) ==
                between(*expected, plain, rays[i], stretch, opaque));
  }
}

}  // namespace

TEST_CASE("Elements as instances have the bytes of the elements, on every family, with the origins of its rays") {
  for (const conform::Family& family : conform::families_of_few())
    for (std::uint64_t seed = 1; seed <= test::fewer_when_sanitized(6); ++seed) {
      CAPTURE(family.name, seed);
      const conform::Case made = generate(family, seed, 12);
      for (const std::size_t one_of : {1, 2}) check_same(made.scene, made.rays, one_of);
    }
}

TEST_CASE("Upright cylinders and cones by those of one have their bytes") {
  test::Random random(11);
  scene::Scene plain;
  for (int i = 0; i < 8; ++i) {
    test::add(plain, scene::Cylinder{random.in_cube(1), random.uniform(0.1, 0.5), {0, 0, 1}, random.uniform(0.1, 1)});
    test::add(plain, scene::Cone{random.in_cube(1), random.uniform(0.1, 0.5), {0, 0, 1}, random.uniform(0.1, 1)});
    test::add(plain, scene::Sphere{random.in_cube(1), random.uniform(0.1, 0.4)});
  }
  std::vector<scene::Query> rays;
  for (int i = 0; i < 4000; ++i) rays.push_back({test::random_ray(random)});
  check_same(plain, rays, 1);
}

TEST_CASE("A tie names elements of both kinds, and so does a ray without a nearest point") {
  scene::Scene scene;
  const scene::Cylinder can{{0, 0, 0}, 1, {0, 0, 1}, 2};
  test::add(scene, model::Elemento("can"), can);
  add_body(scene, model::Elemento("copy"), {scene::Instance{can, model::identity()}});
  add_body(scene, model::Elemento("other"), {scene::Instance{can, model::identity()}});
  const auto engine = composed::prepared(row("fast"), scene);
  const std::vector<std::string> all{"can", "copy", "other"};
  const auto from_outside = said(scene, engine::first_hit(*engine, {test::ray({-3, 0.5, 1}, {1, 0, 0})}));
  CHECK(std::get<0>(from_outside) == Resultado::hit);
  CHECK(std::get<3>(from_outside) == all);
  const auto along = said(scene, engine::first_hit(*engine, {test::ray({1, 0, 1}, {0, 0, 1})}));
  CHECK(std::get<0>(along) == Resultado::no_minimum);
  CHECK(std::get<3>(along) == all);
}

TEST_CASE("Parameters that round to one number are told apart exactly") {
  // The copy stands nearer by less than a unit in the last place of t.
  scene::Scene scene;
  test::add(scene, model::Elemento("ball"), scene::Sphere{{4, 0, 0}, 1});
  model::Mapa mapa = stretched({4, 0, 0}, 1, 1);
  mapa.centro.x -= number::exact(0x1p-60);
  add_body(scene, model::Elemento("copy"), {scene::Instance{scene::Sphere{{0, 0, 0}, 1}, mapa}});
  const auto engine = composed::prepared(row("fast"), scene);
  const auto there = said(scene, engine::first_hit(*engine, {test::ray({0, 0, 0}, {1, 0, 0})}));
  CHECK(std::get<1>(there) == 3);
  CHECK(std::get<3>(there) == std::vector<std::string>{"copy"});
  const auto back = said(scene, engine::first_hit(*engine, {test::ray({8, 0, 0}, {-1, 0, 0})}));
  CHECK(std::get<3>(back) == std::vector<std::string>{"ball"});
}

TEST_CASE("Numbers beyond the range of boxes are answered too") {
  scene::Scene scene;
  add_body(scene, model::Elemento("far"), {as_instance(scene::Sphere{{0x1p200, 0, 0}, 0x1p190})});
  add_body(scene, model::Elemento("tiny"), {as_instance(scene::Sphere{{0, 0, 0}, 0x1p-200})});
  const auto engine = composed::prepared(row("fast"), scene);
  const auto hit = engine::first_hit(*engine, {test::ray({0x1p-150, 0, 0}, {1, 0, 0})});
  CHECK(hit.resultado == Resultado::hit);
  CHECK(said(scene, hit) != said(scene, engine::first_hit(*engine, {test::ray({-0x1p-150, 0, 0}, {1, 0, 0})})));
}

TEST_CASE("Without bodies the engine is that of the row, and every row takes bodies") {
  test::Random random(12);
  const scene::Scene plain = test::random_scene(random, 12);
  const scene::Scene scene = with_instances(plain, 3);
  const scene::GroupedScene grouped{scene};
  const scene::Query ray{test::random_ray(random)};
  const auto expected = said(plain, engine::first_hit(*row("exact").prepare(plain), ray));
  CHECK(said(plain, engine::first_hit(*composed::prepared(row("fast"), plain), ray)) == expected);
  for (const engine::EngineRow& each : engine::engines()) {
    if (!each.exact_bytes) continue;
    CAPTURE(each.name);
    CHECK(said(scene, engine::first_hit(*composed::prepared(each, "automatic", grouped), ray)) == expected);
  }
  CHECK_THROWS_AS(composed::prepared(row("fast"), "no such", grouped), std::invalid_argument);
}

TEST_CASE("Each element has its own normal") {
  scene::Scene scene;
  const auto ball = test::add(scene, scene::Sphere{{0, 0, 0}, 1});
  add_body(scene, model::Elemento("flat"),
           {scene::Instance{scene::Sphere{{0, 0, 0}, 1}, {{5, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}}}});
  const auto engine = composed::prepared(row("fast"), scene);
  const glm::dvec3 slanted(std::sqrt(0.5), std::sqrt(0.5), 0);
  CHECK(glm::length(engine->normal(scene, ball, slanted) - slanted) < 1e-12);
  const glm::dvec3 of_copy = engine->normal(scene, *scene.find("flat"), {5 + std::sqrt(2.0), std::sqrt(0.5), 0});
  CHECK(glm::length(of_copy - glm::normalize(glm::dvec3(0.5, 1, 0))) < 1e-12);
}
