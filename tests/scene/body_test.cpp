#include "durero/scene/body.hpp"

#include <stdexcept>

#include "durero/model/operaciones.hpp"
#include "durero/scene/edit.hpp"
#include "durero/scene/scene.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;

namespace {

model::Mapa stretched(int by) { return {{0, 0, 0}, {by, 0, 0}, {0, by, 0}, {0, 0, by}}; }

scene::Body ball_times(int by) { return {scene::Instance{scene::Sphere{{1, 2, 3}, 4}, stretched(by)}}; }

const model::Mapa& mapa(const scene::Body& body) { return std::get<scene::Instance>(body.form).mapa; }

}  // namespace

TEST_CASE("A copy of a body is a body of the map that makes both steps") {
  const model::Mapa by{{1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
  const scene::Body copy = scene::copied(by, ball_times(2));
  CHECK(mapa(copy) == model::compuesto(by, stretched(2)));
  CHECK(std::get<scene::Sphere>(std::get<scene::Instance>(copy.form).shape).radio == 4);
  CHECK(scene::word_of(copy) == "instancia");
}

TEST_CASE("A body stands in the tables as a sphere, and stays with its name through edits") {
  scene::Scene scene;
  const auto first = test::add(scene, scene::Sphere{{0, 0, 0}, 1});
  const auto disc = test::add(scene, scene::Disc{{0, 0, 0}, 1, {0, 0, 1}});
  CHECK_FALSE(scene.has_bodies());
  CHECK_THROWS_AS(scene.set_body(disc, ball_times(2)), std::domain_error);
  const auto body = test::add(scene, model::Elemento("pebble"), scene::stand_in);
  scene.set_body(body, ball_times(3));
  CHECK(scene.has_bodies());
  CHECK(scene.body(first) == nullptr);
  CHECK(mapa(*scene.body(body)) == stretched(3));
  const scene::Scene copy = scene;
  scene.apply(model::Eliminar_Elemento{scene.name(first)});  // the last sphere moves into the gap
  CHECK(mapa(*scene.body(*scene.find("pebble"))) == stretched(3));
  CHECK(mapa(*copy.body(body)) == stretched(3));
  scene.apply(model::Eliminar_Elemento{model::Elemento("pebble")});
  CHECK_FALSE(scene.has_bodies());
  const auto again = test::add(scene, model::Elemento("pebble"), scene::Sphere{{0, 0, 0}, 1});
  CHECK(scene.body(again) == nullptr);
}
