// Instances (R42): what demo/surfaces/instances.tex says that an affine map makes of a surface of radius and height
// one.
#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "durero/composed/engine.hpp"
#include "durero/conform/families/families.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/source.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/body.hpp"
#include "durero/written/engine.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"
#include "support/sanitized.hpp"
#include "support/tree.hpp"

namespace durero::written {
namespace {

/// What an instance is: where the origin and the axes of its space go.
struct Instance {
  std::string_view tipo;
  glm::dvec3 centro, x, y, z;
};

std::string json(const glm::dvec3& v) { return fmt::format("[{},{},{}]", v.x, v.y, v.z); }

Written instances(const std::vector<std::pair<std::string, Instance>>& elements, const Text& text) {
  std::string all;
  for (const auto& [name, e] : elements)
    all += fmt::format(R"({}{{"id":"{}","tipo":"{}","centro":{},"x":{},"y":{},"z":{}}})", all.empty() ? "" : ",", name,
                       e.tipo, json(e.centro), json(e.x), json(e.y), json(e.z));
  return read(io::Source("scene.json", R"({"format":"durero-scene","version":1,"elementos":[)" + all + "]}"), text);
}

const Text& text() {
  static const Text read(test::source_dir() + "/demo/surfaces/instances.tex");
  return read;
}

/// Everything that a hit says, elements by their names.
using Said = std::tuple<model::Resultado, double, glm::dvec3, std::vector<std::string>>;

Said said(const scene::Scene& scene, const scene::Hit& hit) {
  std::vector<std::string> names;
  for (const scene::ElementRef element : hit.elementos) names.push_back(scene.name(element).name());
  std::ranges::sort(names);
  return {hit.resultado, hit.t, hit.punto, names};
}

/// The ball of one, and of the others the element that an instance without any change is.
scene::Scene unit_element(std::string_view tipo) {
  scene::Scene scene;
  const model::Elemento name("e");
  if (tipo == "elipsoide") scene.apply(model::Agregar_Esfera{name, {0, 0, 0}, 1});
  if (tipo == "cilindro_oblicuo") scene.apply(model::Agregar_Cilindro{name, {0, 0, 0}, 1, {0, 0, 1}, 1});
  if (tipo == "cono_oblicuo") scene.apply(model::Agregar_Cono{name, {0, 0, 0}, 1, {0, 0, 1}, 1});
  if (tipo == "disco_oblicuo") scene.apply(model::Agregar_Disco{name, {0, 0, 0}, 1, {0, 0, 1}});
  return scene;
}

glm::dvec3 mapped(const Instance& by, const glm::dvec3& v) { return v.x * by.x + v.y * by.y + v.z * by.z; }

/// A vector of whole numbers of a few binary digits, so that sums of products of such are exact.
glm::dvec3 whole_vector(int most) {
  const auto one = [&] { return double(*rc::gen::inRange(-most, most + 1)); };
  const double x = one(), y = one();
  return {x, y, one()};
}

TEST_CASE("A ball by the ball of one, seen from its space, has the bytes of the ball, on every family") {
  for (const conform::Family& family : conform::families_of_few())
    for (std::uint64_t seed = 1; seed <= test::fewer_when_sanitized(10); ++seed) {
      const conform::Case made = generate(family, seed, 12);
      scene::Scene balls;
      std::vector<std::pair<std::string, Instance>> same;
      made.scene.for_each([&]<class Shape>(scene::ElementRef element, const Shape& shape) {
        if constexpr (std::is_same_v<Shape, scene::Sphere>) {
          const model::Elemento& name = made.scene.name(element);
          const double r = shape.radio;
          balls.apply(model::Agregar_Esfera{name, model::Punto(shape.centro), r});
          same.push_back({name.name(), {"elipsoide", shape.centro, {r, 0, 0}, {0, r, 0}, {0, 0, r}}});
        }
      });
      if (same.empty()) continue;
      CAPTURE(family.name, seed);
      const auto exact = engine::find("exact")->prepare(balls);
      const Written written = instances(same, text());
      for (const scene::Query& ray : made.rays) {
        const scene::Query free{ray.rayo, {}};
        REQUIRE(said(balls, engine::first_hit(*exact, free)) ==
                said(written.scene, engine::first_hit(*written.engine, free)));
        REQUIRE(engine::occluded_segment(*exact, free) == engine::occluded_segment(*written.engine, free));
      }
    }
}

TEST_CASE("What an affine map makes of a surface and a ray meets where they met, with the same t") {
  for (const std::string_view tipo : {"elipsoide", "cilindro_oblicuo", "cono_oblicuo", "disco_oblicuo"}) {
    CAPTURE(tipo);
    const scene::Scene unit = unit_element(tipo);
    const auto exact = engine::find("exact")->prepare(unit);
    std::size_t asked = 0, hits = 0;
    test::property("of " + std::string(tipo), [&] {  // whole axes, and rays of eighths: all products are exact
      Instance by{tipo, whole_vector(9), whole_vector(9), whole_vector(9), whole_vector(9)};
      const double volume = glm::dot(by.x, glm::cross(by.y, by.z));
      RC_PRE(volume != 0);
      if (volume < 0) std::swap(by.x, by.y);
      const glm::dvec3 p = whole_vector(24) / 8.0, towards = whole_vector(8) / 8.0, v = towards - p;
      RC_PRE(v != glm::dvec3(0));
      const Written written = instances({{"e", by}}, text());
      const scene::Hit there = engine::first_hit(*exact, {{model::Punto(p), model::Vector(v)}});
      const scene::Hit here =
          engine::first_hit(*written.engine, {{model::Punto(by.centro + mapped(by, p)), model::Vector(mapped(by, v))}});
      RC_ASSERT(here.resultado == there.resultado);
      RC_ASSERT(here.t == there.t);
      ++asked;
      hits += there.resultado == model::Resultado::hit;
    });
    CHECK(10 * hits >= asked);
  }
}

/// What the program makes of the same: an instance of the shape of one, without a text.
scene::Scene own_instances(const std::vector<std::pair<std::string, Instance>>& elements) {
  const auto exact = [](const glm::dvec3& v) { return model::ExactVector(model::Vector(v)); };
  scene::Scene scene;
  for (const auto& [name, e] : elements) {
    const scene::Scene unit = unit_element(e.tipo);
    const model::Mapa mapa{exact(e.centro), exact(e.x), exact(e.y), exact(e.z)};
    unit.for_each([&](scene::ElementRef, const auto& shape) {
      scene.add(model::Elemento(name), scene::stand_in);
      scene.set_body(*scene.find(name), {scene::Instance{shape, mapa}});
    });
  }
  return scene;
}

/// A few instances that overlap, of random maps that do not turn to the left.
std::vector<std::pair<std::string, Instance>> random_instances(conform::Random& random) {
  std::vector<std::pair<std::string, Instance>> all;
  for (const std::string_view tipo : {"elipsoide", "cilindro_oblicuo", "cono_oblicuo", "disco_oblicuo", "elipsoide"}) {
    Instance e{tipo, random.in_cube(1), random.in_cube(1), random.in_cube(1), random.in_cube(1)};
    if (glm::dot(e.x, glm::cross(e.y, e.z)) < 0) std::swap(e.x, e.y);
    all.push_back({"e" + std::to_string(all.size()), e});
  }
  return all;
}

TEST_CASE("The program's instances answer as the text does, whatever the maps, rays and origins") {
  conform::Random random(5);
  const std::size_t scenes = test::fewer_when_sanitized(60), rays = 1250;
  std::size_t asked = 0, hits = 0;
  for (std::size_t i = 0; i < scenes; ++i) {
    const auto all = random_instances(random);
    const Written written = instances(all, text());
    const scene::Scene own = own_instances(all);
    const auto engine = composed::prepared(*engine::find("fast"), own);
    for (std::size_t j = 0; j < rays; ++j) {
      const glm::dvec3 p = random.in_cube(2);
      const scene::Query ray{{model::Punto(p), model::Vector(random.in_cube(1) - p)}, {}};
      const scene::Hit here = engine::first_hit(*engine, ray), there = engine::first_hit(*written.engine, ray);
      REQUIRE(said(own, here) == said(written.scene, there));
      REQUIRE(engine::occluded_segment(*engine, ray) == engine::occluded_segment(*written.engine, ray));
      ++asked;
      if (here.resultado != model::Resultado::hit) continue;
      ++hits;
      const glm::dvec3 v = random.in_cube(1);  // and from there on, as a mirror's ray
      const scene::Query on{{model::Punto(here.punto), model::Vector(v)}, here.elementos};
      const scene::Query on_there{on.rayo, there.elementos};
      REQUIRE(said(own, engine::first_hit(*engine, on)) ==
              said(written.scene, engine::first_hit(*written.engine, on_there)));
      ++asked;
    }
  }
  CHECK(4 * hits > asked);
}

TEST_CASE("The normal of an instance is at right angles to what the map makes of the tangents, and points outwards") {
  const Instance by{"elipsoide", {1, 2, 3}, {2, 1, 0}, {0, 3, 1}, {-1, 0, 2}};
  const Written written = instances({{"e", by}}, text());
  const glm::dvec3 at(0.6, 0, 0.8), tangent(-0.8, 0, 0.6);
  const glm::dvec3 n = written.engine->normal(written.scene, *written.scene.find("e"), by.centro + mapped(by, at));
  CHECK(std::abs(glm::dot(n, mapped(by, {0, 1, 0}))) < 1e-12);
  CHECK(std::abs(glm::dot(n, mapped(by, tangent))) < 1e-12);
  CHECK(glm::dot(n, mapped(by, at)) > 0);
}

TEST_CASE("Axes in one plane, and such as turn to the left, are no instance") {
  const auto refused = [](const Instance& instance) {
    try {
      instances({{"e", instance}}, text());
    } catch (const io::InputError& error) {
      return std::string(error.what()).find("mixto (x, y, z) > 0") != std::string::npos;
    }
    return false;
  };
  CHECK(refused({"elipsoide", {}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  CHECK(refused({"cono_oblicuo", {}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}));
  CHECK_FALSE(refused({"cono_oblicuo", {}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
}

}  // namespace
}  // namespace durero::written
