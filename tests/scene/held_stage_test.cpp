#include "durero/scene/held_stage.hpp"

#include <type_traits>
#include <utility>

#include "durero/scene/stage.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

scene::HeldStage with_a_light() {
  scene::HeldStage stage;
  (*stage).lights.push_back({{1, 2, 3}, {4, 5, 6}});
  return stage;
}

}  // namespace

TEST_CASE("an empty holder stands for the stage that says nothing") {
  const scene::HeldStage stage;
  CHECK((*stage).lights.empty());
  CHECK(!(*stage).camera);
}

TEST_CASE("a holder is a value: a copy is another stage, and a change of one leaves the other") {
  scene::HeldStage stage = with_a_light(), copy = stage;
  CHECK(&*stage != &*copy);
  CHECK((*copy).lights == (*stage).lights);
  (*copy).lights.clear();
  CHECK((*stage).lights.size() == 1);
  copy = stage;
  CHECK((*copy).lights.size() == 1);
  copy = std::as_const(copy);  // of itself
  CHECK((*copy).lights.size() == 1);
  stage = scene::HeldStage();
  CHECK((*std::as_const(stage)).lights.empty());
  CHECK((*copy).lights.size() == 1);
}

TEST_CASE("a holder that was moved from stands for the stage that says nothing") {
  scene::HeldStage stage = with_a_light();
  const scene::HeldStage other = std::move(stage);
  CHECK((*other).lights.size() == 1);
  CHECK((*std::as_const(stage)).lights.empty());
  STATIC_REQUIRE(std::is_nothrow_move_constructible_v<scene::HeldStage>);
  STATIC_REQUIRE(std::is_nothrow_move_assignable_v<scene::HeldStage>);
}
