#include <string>
#include <string_view>

#include "conform/families/family_table.hpp"
#include "durero/surface/exact.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using namespace durero::conform;

namespace {

/// Which of a family's two questions the ray answers with yes: "", "m" for a member, "me" for an exact one.
std::string answers(std::string_view family, const scene::Scene& scene, const model::Rayo& rayo) {
  const scene::Query query{rayo, {}};
  const Questions& questions = row_of(*find_family(family)).questions;
  const AnsweredQuery answered{scene, query, surface::exact::first_hit(scene, rayo)};
  return std::string(questions.is_member(answered) ? "m" : "") + (questions.is_exact(answered) ? "e" : "");
}

}  // namespace

TEST_CASE("a disc's rim and its plane are told from its middle") {
  scene::Scene scene;
  add(scene, scene::Disc{{0, 0, 0}, 5, {0, 0, 1}});
  const glm::dvec3 down(0, 0, -1);
  CHECK(answers("disc", scene, ray({1, 2, 8}, down)) == "m");
  CHECK(answers("disc", scene, ray({3, 4, 8}, down)) == "me");
  CHECK(answers("disc", scene, ray({0x1.8000000000001p1, 4, 8}, down)) == "m");  // passes beside the rim
  CHECK(answers("disc", scene, ray({4, 4, 8}, down)).empty());
  CHECK(answers("disc", scene, ray({3, 4, 8}, -down)).empty());  // the rim is behind
  CHECK(answers("disc", scene, ray({-9, 1, 0}, {1, 0, 0})) == "me");
  CHECK(answers("disc", scene, ray({0, 1, 0}, {1, 0, 0})) == "me");  // no minimum
  CHECK(answers("disc", scene, ray({-9, 6, 0}, {1, 0, 0})).empty());
}

TEST_CASE("a rim that closes an element is told from the rims of either") {
  scene::Scene scene;
  add(scene, scene::Cylinder{{0, 0, 0}, 5, {0, 0, 1}, 10});
  add(scene, scene::Disc{{0, 0, 0}, 5, {0, 0, 1}});
  CHECK(answers("cap", scene, ray({3, 4, -8}, {0, 0, 1})) == "me");
  CHECK(answers("cap", scene, ray({6, 8, -5}, {-3, -4, 5})) == "me");
  CHECK(answers("cap", scene, ray({6, 8, 11}, {-3, -4, -1})).empty());  // through the open rim
  CHECK(answers("cap", scene, ray({1, 1, -8}, {0, 0, 1})).empty());
  CHECK(answers("cap", scene, ray({1, 1, 5}, {0, 0, -1})) == "m");  // from inside
}

TEST_CASE("an edge that is shared is told from one that is not, and from the inside") {
  scene::Scene scene;
  add(scene, scene::Triangle{{glm::dvec3(0, 0, 0), glm::dvec3(8, 0, 0), glm::dvec3(0, 8, 0)}});
  add(scene, scene::Triangle{{glm::dvec3(0, 0, 0), glm::dvec3(8, 0, 0), glm::dvec3(0, -8, 3)}});
  const glm::dvec3 down(0, 0, -1);
  CHECK(answers("edge", scene, ray({3, 0, 8}, down)) == "me");
  CHECK(answers("edge", scene, ray({0, 0, 8}, down)) == "me");
  CHECK(answers("edge", scene, ray({0, 3, 8}, down)) == "m");
  CHECK(answers("edge", scene, ray({3, 0x1p-40, 8}, down)) == "m");
  CHECK(answers("edge", scene, ray({2, 2, 8}, down)).empty());
  CHECK(answers("edge", scene, ray({3, 0, -8}, down)).empty());  // the edge is behind
}

TEST_CASE("a sliver and a huge triangle are told from ordinary ones") {
  const auto one = [](const scene::Corners& vertices) {
    scene::Scene scene;
    add(scene, scene::Triangle{vertices});
    return scene;
  };
  const glm::dvec3 a(0, 0, 0), b(0x1p10, 0, 0), down(0, 0, -1);
  const scene::Scene thin = one({a, b, {0, 1, 0}}), wide = one({a, b, {0, 0x1p9, 0}});
  CHECK(answers("sliver", thin, ray({1, 0.5, 8}, down)) == "m");
  CHECK(answers("sliver", thin, ray({1, 0, 8}, down)) == "me");
  CHECK(answers("sliver", thin, ray({1, 2, 8}, down)).empty());
  CHECK(answers("sliver", wide, ray({1, 0.5, 8}, down)).empty());
  CHECK(answers("sliver", wide, ray({1, 0.5, 0x1p-10}, down)) == "m");
}

TEST_CASE("what overlaps in one plane is told from what does not") {
  scene::Scene scene;
  add(scene, scene::Triangle{{glm::dvec3(0, 0, 0), glm::dvec3(8, 0, 0), glm::dvec3(0, 8, 0)}});
  add(scene, scene::Disc{{0, 0, 0}, 5, {0, 0, -1}});
  CHECK(answers("coplanar", scene, ray({1, 1, 8}, {0, 0, -1})) == "me");
  CHECK(answers("coplanar", scene, ray({-1, -1, 8}, {0, 0, -1})).empty());
  CHECK(answers("coplanar", scene, ray({-3, -1, 0x1p-30}, {1, 0, -0x1p-30})) == "m");
  CHECK(answers("coplanar", scene, ray({1, 1, 0}, {1, 0, 0})) == "me");
  CHECK(answers("coplanar", scene, ray({-9, -1, 0}, {1, 0, 0})) == "m");  // the disc alone
}
