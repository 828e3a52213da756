#include "durero/scene/closing.hpp"

#include "durero/model/operaciones.hpp"
#include "durero/scene/addition.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"

using namespace durero;
using model::Elemento;
using scene::Disc;

namespace {

/// The discs that a closing adds, base first.
std::vector<Disc> discs(const scene::Scene& scene, const scene::Lids& lids) {
  scene::Scene closed = scene;
  const std::size_t before = closed.shapes<Disc>().size();
  for (const scene::Edit& lid : lids.additions) REQUIRE(closed.apply_total(lid).ok());
  const auto all = closed.shapes<Disc>().subspan(before);
  return {all.begin(), all.end()};
}

scene::Scene solids() {
  scene::Scene scene;
  scene.stage().materials = {{.name = "glass"}};
  scene.apply(model::Agregar_Cilindro{Elemento("can"), {1, 2, 3}, 0.5, {0, 0.6, 0.8}, 2});
  scene.apply(model::Agregar_Cono{Elemento("hat"), {1, 2, 3}, 0.5, {0, 1, 0}, 3});
  scene.apply(model::Agregar_Tronco{Elemento("cup"), {1, 2, 3}, 0.25, 0.5, {0, -1, 0}, 3});
  scene.apply(model::Agregar_Esfera{Elemento("ball"), {1, 2, 3}, 1});
  scene.set_material(*scene.find("cup"), 0);
  return scene;
}

void check(const Disc& disc, const glm::dvec3& centro, double radio, const glm::dvec3& vector) {
  CHECK(disc.centro == centro);
  CHECK(disc.radio == radio);
  CHECK(disc.vector == vector);
}

}  // namespace

TEST_CASE("discs at base and top, of the radii there, face outwards, and a cone has no top") {
  const scene::Scene scene = solids();
  const scene::Lids cup = lids(scene, {"cup", "b", "t"});
  const auto of_cup = discs(scene, cup);
  REQUIRE(of_cup.size() == 2);
  check(of_cup[0], {1, 2, 3}, 1.75, {0, 1, 0});
  check(of_cup[1], {1, -1, 3}, 0.25, {0, -1, 0});
  CHECK(cup.exact);
  CHECK(cup.additions[0].material == 0U);
  const scene::Lids hat = lids(scene, {"hat", "b", "b"});
  const auto of_hat = discs(scene, hat);
  REQUIRE(of_hat.size() == 1);
  check(of_hat[0], {1, 2, 3}, 1.5, {0, -1, 0});
  CHECK(hat.exact);
  CHECK_FALSE(hat.additions[0].material.has_value());
}

TEST_CASE("what is no binary64 is rounded once, and said") {
  const scene::Scene scene = solids();
  const scene::Lids can = lids(scene, {"can", "b", "t"});
  const auto of_can = discs(scene, can);
  REQUIRE(of_can.size() == 2);
  check(of_can[0], {1, 2, 3}, 0.5, {0, -0.6, -0.8});
  CHECK(of_can[1].centro.y == Approx(3.2).epsilon(1e-15));
  CHECK(of_can[1].centro.z == Approx(4.6).epsilon(1e-15));
  CHECK_FALSE(can.exact);
  scene::Scene other;
  other.apply(model::Agregar_Cono{Elemento("hat"), {0, 0, 0}, 0.1, {0, 1, 0}, 0.1});
  CHECK_FALSE(lids(other, {"hat", "b", "t"}).exact);
}

TEST_CASE("each precondition of closing by its label") {
  scene::Scene scene = solids();
  CHECK(lids(scene, {"none", "b", "t"}).violated == &scene::close_pre_1);
  CHECK(lids(scene, {"ball", "b", "t"}).violated == &scene::close_pre_2);
  CHECK(lids(scene, {"can", "b", "b"}).violated == &scene::close_pre_3);
  scene.apply(model::Agregar_Cilindro{Elemento("long"), {0, 1e308, 0}, 1, {0, 1, 0}, 1e308});
  CHECK(lids(scene, {"long", "b", "t"}).violated == &scene::close_pre_4);
  for (const char* const e : {"none", "ball", "long"}) CHECK(lids(scene, {e, "b", "t"}).additions.empty());
}
