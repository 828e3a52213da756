#include "durero/conform/families/asked_body.hpp"

#include <glm/geometric.hpp>
#include <set>

#include "durero/composed/figure.hpp"
#include "durero/conform/families/suite.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

constexpr std::array<glm::dvec3, 3> boxed = {{{3, 0, 0}, {0, 2, 0}, {0, 0, 1}}};
constexpr std::array<glm::dvec3, 3> round_across = {{{1, 0, 0}, {0, 2, 0}, {0, 0, 1}}};

/// The parameters of the points of a body on a ray.
std::vector<double> met(const AskedBody& body, const glm::dvec3& p, const glm::dvec3& v) {
  const auto figure = composed::figure(exact_body(body));
  const auto points = figure->parameters(test::ray(p, v), false, surface::exact::RayStretch::whole).value();
  std::vector<double> all;
  for (const auto& t : points) all.push_back(number::round_to_binary64(t));
  return all;
}

using Numbers = std::vector<double>;

}  // namespace

TEST_CASE("a ray meets a box, an ellipsoid and a capsule where their equations say") {
  const AskedBody box{BodyKind::caja, {0, 0, 10}, boxed};
  CHECK(met(box, {0, 0, 0}, {0, 0, 1}) == Numbers{9, 11});
  CHECK(met(box, {2.5, 0.5, 10}, {1, 0, 0}) == Numbers{0.5});
  CHECK(met(box, {3.5, 0, 0}, {0, 0, 1}).empty());
  const AskedBody ellipsoid{BodyKind::elipsoide, {0, 0, 10}, boxed};
  CHECK(met(ellipsoid, {-10, 0, 10}, {2, 0, 0}) == Numbers{3.5, 6.5});
  CHECK(met(ellipsoid, {3, 0, 0}, {0, 0, 1}) == Numbers{10});
  const AskedBody capsule{BodyKind::capsula, {0, 0, 10}, round_across};
  CHECK(met(capsule, {0, 9, 10}, {0, -1, 0}) == Numbers{6, 12});
  CHECK(met(capsule, {0, 1.5, 0}, {0, 0, 1}) == Numbers{9, 11});
  CHECK(met(capsule, {0.6, 2, 0}, {0, 0, 1}) == Numbers{9.2, 10.8});
  CHECK(met(capsule, {0.9, 2.9, 0}, {0, 0, 1}).empty());
}

TEST_CASE("a ray meets a rounded box at its flat sides, around its edges and around its corners") {
  const AskedBody rounded{BodyKind::caja_redonda, {0, 0, 10}, boxed, 0.5};
  CHECK(met(rounded, {0, 0, 0}, {0, 0, 1}) == Numbers{8.5, 11.5});
  CHECK(met(rounded, {3, 2, 0}, {0, 0, 1}) == Numbers{8.5, 11.5});
  CHECK(met(rounded, {3.3, 0, 0}, {0, 0, 1}) == Numbers{8.6, 11.4});
  CHECK(met(rounded, {3.3, 2, 0}, {0, 0, 1}) == Numbers{8.6, 11.4});
  CHECK(met(rounded, {0, 2.4, 0}, {0, 0, 1}) == Numbers{8.7, 11.3});
  CHECK(met(rounded, {3 + 2.0 / 7, 2 + 1.5 / 7, 0}, {0, 0, 1}).size() == 2);
  CHECK(met(rounded, {3.4, 2.4, 0}, {0, 0, 1}).empty());
  CHECK(met(rounded, {0, 0, 10}, {1, 0, 0}) == Numbers{3.5});
  const AskedBody turned{BodyKind::caja_redonda, {}, {{{2, 1, 2}, {-2, 2, 1}, {-1, -2, 2}}}, 1.5};
  CHECK(met(turned, {12, 6, 12}, {-2, -1, -2}) == Numbers{4.5, 7.5});
  CHECK_FALSE(is_body({BodyKind::caja_redonda, {}, boxed}));
  CHECK_FALSE(is_body({BodyKind::caja_redonda, {}, boxed, -1}));
  CHECK_FALSE(is_body({BodyKind::caja_redonda, {}, boxed, HUGE_VAL}));
}

TEST_CASE("a torus is a ring of a radius and a tube that leaves a hole, and stands as a box around it") {
  const std::array<glm::dvec3, 3> ring = {{{2, 0, 0}, {0, 1, 0}, {0, 0, 2}}};
  CHECK(is_body({BodyKind::toro, {}, ring, 1}));
  CHECK_FALSE(is_body({BodyKind::toro, {}, ring}));
  CHECK_FALSE(is_body({BodyKind::toro, {}, ring, 2}));
  CHECK(met({BodyKind::toro, {0, 0, 10}, ring, 1}, {0, 0, 0}, {0, 0, 1}) == Numbers{6, 14});
}

TEST_CASE("copies by mirrored and sheared maps are where the map puts them") {
  const std::array<glm::dvec3, 3> sheared = {{{-1, 0, 0}, {1, 1, 0}, {0, 0, 1}}};
  const AskedBody box{BodyKind::copia_caja, {0, 0, 0}, sheared};
  CHECK(met(box, {-9, 0.5, 0.5}, {1, 0, 0}) == Numbers{8.5, 10.5});
  CHECK(met(box, {-9, -0.5, 0.5}, {1, 0, 0}) == Numbers{7.5, 9.5});
  const AskedBody ball{BodyKind::copia_esfera, {0, 0, 0}, sheared};
  CHECK(met(ball, {-9, 1, 0}, {1, 0, 0}) == Numbers{10});
}

TEST_CASE("sides that do not span space, or are no numbers, make no body") {
  CHECK(is_body({BodyKind::caja, {}, boxed}));
  CHECK_FALSE(is_body({BodyKind::caja, {}, {{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}}));
  CHECK_FALSE(is_body({BodyKind::caja, {HUGE_VAL, 0, 0}, boxed}));
  scene::Scene scene;
  CHECK_FALSE(add_body(scene, model::Elemento("e0"), {BodyKind::elipsoide, {}, {}}));
  CHECK(scene.size() == 0);
  CHECK(add_body(scene, model::Elemento("e0"), {BodyKind::elipsoide, {}, boxed}));
  CHECK_FALSE(add_body(scene, model::Elemento("e0"), {BodyKind::caja, {}, boxed}));
  CHECK(scene.has_bodies());
}

TEST_CASE("a length is right however large the numbers are") {
  CHECK(length_of({3, 4, 0}) == 5);
  CHECK(length_of({2, -3, 6}) == 7);
  CHECK(length_of({0, 0, -7}) == 7);
  CHECK(length_of({3 * 0x1p1000, 4 * 0x1p1000, 0}) == 5 * 0x1p1000);
  CHECK(length_of({3 * 0x1p-1070, 4 * 0x1p-1070, 0}) == 5 * 0x1p-1070);
  CHECK(length_of({0, 0, 0}) == 0);
}

TEST_CASE("bodies are drawn of each kind that is asked for, with numbers of binary32 and sides at right angles") {
  std::set<BodyKind> seen;
  std::size_t mirrored = 0, turned = 0;
  for (const Family& family : families_of_bodies()) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const DrawnCase drawn = generate(family, seed, 8, {.numbers = NumberFormat::binary32}).value();
      CHECK_FALSE(drawn.bodies.empty());
      for (const auto& [element, body] : drawn.bodies) {
        CHECK(drawn.the_case.scene.body(element) != nullptr);
        seen.insert(body.kind);
        const auto& [x, y, z] = body.sides;
        for (const glm::dvec3& side : {body.centro, x, y, z}) CHECK(glm::dvec3(glm::vec3(side)) == side);
        mirrored += glm::dot(x, glm::cross(y, z)) < 0;
        turned += x.x != 0 && x.y != 0 && x.z != 0;
        if (body.kind == BodyKind::copia_caja || body.kind == BodyKind::copia_esfera) continue;
        CHECK((glm::dot(x, y) == 0 && glm::dot(y, z) == 0 && glm::dot(z, x) == 0));
        CHECK(glm::dot(x, glm::cross(y, z)) > 0);
        if (body.kind == BodyKind::capsula) CHECK(glm::dot(x, x) == glm::dot(z, z));
      }
    }
  }
  CHECK(seen.size() == body_count);
  CHECK(mirrored > 20);
  CHECK(turned > 40);
}

TEST_CASE("a system without bodies has no scene of them, and one of bodies alone has no other scene") {
  const SuiteOptions spheres{.tipos = {model::Tipo::soy_esfera}}, boxes{.bodies = {BodyKind::caja}};
  for (const Family& family : families()) {
    INFO(family.name);
    if (is_of_bodies(family)) CHECK(cases(spheres, family) == 0);
    CHECK((cases(boxes, family) > 0) == is_of_bodies(family));
  }
  const SuiteCase of = suite_case(boxes, families_of_bodies().front(), 0);
  for (const NamedBody& body : of.bodies) CHECK(body.body.kind == BodyKind::caja);
  CHECK(find_body(of.bodies, of.bodies[0].element) == &of.bodies[0].body);
  CHECK(find_body(of.bodies, {model::Tipo::soy_disco, 0}) == nullptr);
}
