// The Z text confirms what the exact oracle finds, and objects to it once anything of it is changed.
#include "durero/spec/confirmation.hpp"

#include <cmath>

#include "durero/model/operaciones.hpp"
#include "durero/surface/exact.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"

namespace durero::spec {
namespace {

using model::Resultado;
using scene::ElementRef;
using scene::Hit;
using test::Random;

model::Rayo along_z(double x, double y) { return {{x, y, 0}, {0, 0, 1}}; }

std::string objection(const scene::Scene& scene, const model::Rayo& rayo, const Hit& hit,
                      const scene::ElementSet& en = {}) {
  return Confirmation(scene).objection({rayo, en}, hit).value_or("");
}

ElementRef find(const scene::Scene& scene, const char* name) { return *scene.find(name); }

/// Two unit spheres: b around (0, 0, 5), and a beside it by so little that their points round alike.
scene::Scene alike() {
  scene::Scene scene;
  scene.apply(model::Agregar_Esfera{model::Elemento("a"), {0, 1e-9, 5}, 1});
  scene.apply(model::Agregar_Esfera{model::Elemento("b"), {0, 0, 5}, 1});
  return scene;
}

/// A hit with one of its numbers moved to the next binary64, its element exchanged, or another outcome.
Hit changed(Random& random, const scene::Scene& scene, const Hit& hit) {
  const auto next = [&](double& x) { x = std::nextafter(x, random.below(2) == 0 ? -INFINITY : INFINITY); };
  Hit other = hit;
  if (hit.resultado == Resultado::miss) {
    other.resultado = Resultado::hit;
    other.elementos.push_back(find(scene, "e0"));
    return other;
  }
  switch (random.below(4)) {
    case 0:
      next(other.t);
      break;
    case 1:
      next(other.punto[static_cast<int>(random.below(3))]);
      break;
    case 2:
      other.elementos[0] = find(scene, ("e" + std::to_string(random.below(scene.size()))).c_str());
      break;
    default:
      other.resultado = Resultado::miss;
      other.elementos.clear();
  }
  return other;
}

}  // namespace

// Hay_Interseccion.post.1, Hay_Interseccion.post.2, Hay_Interseccion.post.3, Hay_Interseccion.pre.1,
// No_Hay_Interseccion.pre.1
TEST_CASE("the text confirms the exact oracle's hits of random rays, and objects to each change of them") {
  const std::uint64_t seed = 20261121;
  CAPTURE(seed);
  Random random(seed);
  std::size_t hits = 0, changes = 0;
  for (std::size_t i = 0; i < test::fewer_when_sanitized(60); ++i) {
    const scene::Scene scene = test::random_scene(random, 4);
    const Confirmation confirmation(scene);
    for (int n = 0; n < 8; ++n) {
      const model::Rayo rayo = test::random_ray(random);
      const Hit hit = surface::exact::first_hit(scene, rayo, {});
      hits += hit.resultado == Resultado::hit;
      CHECK(confirmation.objection({rayo}, hit).value_or("") == "");
      const Hit other = changed(random, scene, hit);
      if (other == hit) continue;
      ++changes;
      CHECK(confirmation.objection({rayo}, other));
    }
  }
  CHECK(hits > test::fewer_when_sanitized(150));
  CHECK(changes > test::fewer_when_sanitized(300));
}

TEST_CASE("a farther point that rounds to the same numbers is not the reduction") {
  const scene::Scene scene = alike();
  const ElementRef a = find(scene, "a"), b = find(scene, "b");
  const auto judged = [&](const scene::ElementSet& elements) {
    return objection(scene, along_z(0, 0), {Resultado::hit, 4, {0, 0, 4}, elements});
  };
  CHECK(judged({b}) == "");
  CHECK(judged({a}) == "Hay_Interseccion.post.3: elementos! are others");
  CHECK(judged({a, b}) == "Hay_Interseccion.post.3: elementos! are others");
}

TEST_CASE("a hit is judged by its bits: no other zero, no other last place") {
  const scene::Scene scene = alike();
  const ElementRef b = find(scene, "b");
  const auto judged = [&](double t, const glm::dvec3& point) {
    return objection(scene, along_z(0, 0), {Resultado::hit, t, point, {b}});
  };
  const std::string other = "no intersection has t and point that round to those of the hit";
  CHECK(judged(4, {0, 0, 4}) == "");
  CHECK(judged(4, {-0.0, 0, 4}) == other);
  CHECK(judged(4, {0, -0.0, 4}) == other);
  CHECK(judged(4, {0, 0, std::nextafter(4, 5)}) == other);
  CHECK(judged(std::nextafter(4, 3), {0, 0, 4}) == other);
  CHECK(judged(6, {0, 0, 6}) == "Hay_Interseccion.post.1: another is nearer");
}

TEST_CASE("a coordinate that is negative and too small for a binary64 rounds to −0") {
  scene::Scene scene;
  scene.apply(model::Agregar_Esfera{model::Elemento("s"), {0, 0, 5}, 1});
  // t = 2 and a little: the point's x is −t·2⁻¹⁰⁷⁴/… below half of the least binary64.
  const model::Rayo rayo{{0, 0, 3.75}, {-0x1p-1074, 0, 1}};
  const Hit hit = surface::exact::first_hit(scene, rayo, {});
  REQUIRE(hit.t == 0.25);
  REQUIRE((hit.punto.x == 0 && std::signbit(hit.punto.x)));
  CHECK(objection(scene, rayo, hit) == "");
  Hit other = hit;
  other.punto.x = 0;
  CHECK(objection(scene, rayo, other) != "");
}

TEST_CASE("misses and rays without a nearest point") {
  scene::Scene scene = alike();
  scene.apply(model::Agregar_Cilindro{model::Elemento("c"), {9, 0, 0}, 1, {0, 0, 1}, 4});
  const ElementRef b = find(scene, "b"), c = find(scene, "c");
  CHECK(objection(scene, along_z(4, 4), {}) == "");
  CHECK(objection(scene, along_z(4, 4), {Resultado::miss, 0, {}, {b}}) ==
        "No_Hay_Interseccion.post.1: elementos! are others");
  CHECK(objection(scene, along_z(0, 0.5), {}) == "No_Hay_Interseccion.pre.1: a point of the ray lies on a");
  CHECK(objection(scene, along_z(4, 4), {Resultado::hit, 1, {4, 4, 1}, {b}}) ==
        "Hay_Interseccion.pre.1: no point of the ray lies on an element");
  CHECK(objection(scene, along_z(10, 0), {Resultado::no_minimum, 0, {}, {c}}) == "");
  CHECK(objection(scene, along_z(10, 0), {Resultado::no_minimum, 0, {}, {b, c}}) ==
        "No_Hay_Minimo.post.1: elementos! are others");
  CHECK(objection(scene, along_z(10, 0), {Resultado::hit, 4, {10, 0, 4}, {c}}) ==
        "Hay_Interseccion.pre.1: no point is nearest on c");
  CHECK(objection(scene, along_z(4, 4), {Resultado::no_minimum, 0, {}, {c}}) ==
        "No_Hay_Minimo.pre.1: no point of the ray lies on an element");
  CHECK(objection(scene, along_z(0, 0), {Resultado::no_minimum, 0, {}, {b}}) ==
        "No_Hay_Minimo.pre.2: a nearest point exists");
}

TEST_CASE("a ray that starts on elements is judged by what it reaches of them") {
  const scene::Scene scene = alike();
  const ElementRef b = find(scene, "b");
  // The stored origin is beside the point of b that it stands for, so without the name the near side of b is first.
  const model::Rayo inwards{{0, 0, 3.9999}, {0, 0, 1}};
  const Hit of_name = surface::exact::first_hit(scene, inwards, b),
            without = surface::exact::first_hit(scene, inwards, {});
  REQUIRE(of_name.elementos != without.elementos);
  CHECK(objection(scene, inwards, of_name, {b}) == "");
  CHECK(objection(scene, inwards, without, {}) == "");
  CHECK(objection(scene, inwards, without, {b}) != "");
  CHECK(objection(scene, inwards, of_name, {}) != "");
}

}  // namespace durero::spec
