// The verdicts on a user's own scene and rays, as lines and as JSON.
#include "durero/conform/report/judged_rays.hpp"

#include <stdexcept>
#include <string>

#include "conform/judged.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/mesh_edit.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;
using namespace durero::model;
using namespace durero::test;

namespace {

using Outcome = Claim::Outcome;

/// A sphere, and a mesh of one face behind it.
scene::Scene own_scene() {
  scene::Scene scene;
  scene.apply(Agregar_Esfera{Elemento("ball"), Punto(0, 0, 5), 1});
  const scene::Mesh mesh{Elemento("m"), {{-4, -4, 9}, {4, -4, 9}, {0, 4, 9}}, {{0, 1, 2}}};
  REQUIRE(scene.apply_total(scene::MeshEdit(scene::MeshAddition{mesh})).ok());
  return scene;
}

SuiteCase own() {
  std::vector<scene::Query> rays;
  for (const double x : {0, 2, 9}) rays.push_back({Rayo(Punto(x, 0, 0), Vector(0, 0, 1)), {}});
  SuiteCase of = own_case(own_scene(), std::move(rays));
  answer(of);
  return of;
}

std::vector<ClaimJudgement> judged(const SuiteCase& of, const Claims& claims) {
  std::vector<ClaimJudgement> judgements;
  for (std::size_t i = 0; i < claims.size(); ++i) judgements.push_back(judge(of, i, claims[i], profile_of_all()));
  return judgements;
}

}  // namespace

TEST_CASE("a user's own rays are judged as those of a suite") {
  const SuiteCase of = own();
  CHECK(of.name() == "own/0000");
  const Claims right = right_claims(of);
  CHECK(judged_rays_text(of, right, judged(of, right)) == "3 rays: 3 exact\n");
  CHECK(judged_rays_json(of, right, judged(of, right)) ==
        "{\"ray\":0,\"verdict\":\"exact\"}\n{\"ray\":1,\"verdict\":\"exact\"}\n{\"ray\":2,\"verdict\":\"exact\"}\n");
  Claims wrong = right;
  wrong[0] = {Outcome::miss};
  wrong[1] = {Outcome::hit, of.the_case.scene.find("m:0"), 8.5, {}};
  wrong[2] = {};
  CHECK(judged_rays_text(of, wrong, judged(of, wrong)) ==
        "3 rays: 1 missed, 1 misplaced, 1 skipped\n"
        "ray 0 missed: expected ball at t = 4, point (0, 0, 4); got a miss\n"
        "ray 1 misplaced: expected m:0 at t = 9, point (2, 0, 9); got m:0 at t = 8.5\n"
        "  backward error 2^48.8 of its unit\n"
        "ray 2 skipped: no answer\n");
  const std::string json = judged_rays_json(of, wrong, judged(of, wrong));
  CHECK(json.starts_with(
      "{\"ray\":0,\"verdict\":\"missed\",\"expected\":\"ball at t = 4, point (0, 0, 4)\",\"got\":\"a miss\"}\n"));
  CHECK(json.ends_with("{\"ray\":2,\"verdict\":\"skipped\",\"clause\":\"no answer\"}\n"));
}

TEST_CASE("claims on a user's own rays need no case, and those on a suite do") {
  const SuiteCase of = own();
  const auto read = [&](const char* name, const char* text) {
    return read_claims(io::Source(name, text), {&of, 1})[0];
  };
  CHECK(read("h.jsonl", "{\"ray\":1,\"outcome\":\"miss\"}") == Claims{{}, {Outcome::miss}, {}});
  CHECK(read("h.jsonl", "{\"case\":\"own/0000\",\"ray\":1,\"outcome\":\"miss\"}") == Claims{{}, {Outcome::miss}, {}});
  CHECK(read("h.csv", "ray,t\n2,\n0,4\n") == Claims{{Outcome::hit, {}, 4.0, {}}, {}, {Outcome::miss}});
  CHECK_THROWS_WITH(read("h.jsonl", "{\"case\":\"tiny/0000\",\"ray\":1,\"outcome\":\"miss\"}"),
                    "h.jsonl:1:9: no case \"tiny/0000\"; expected a case of the suite");
  CHECK_THROWS_WITH(read("h.jsonl", "{\"ray\":3,\"outcome\":\"miss\"}"),
                    "h.jsonl:1:8: ray 3 of 3; expected a ray of the case, from 0");
  const SuiteCase of_suite = answered_case("generic", 0);
  CHECK_THROWS_WITH(read_claims(io::Source("h.jsonl", "{\"ray\":1,\"outcome\":\"miss\"}"), {&of_suite, 1}),
                    "h.jsonl:1:1: key \"case\" is missing in a claim; expected it");
  CHECK_THROWS_WITH(read_claims(io::Source("h.csv", "ray,t\n0,1\n"), {&of_suite, 1}),
                    "h.csv:1:1: no column \"case\"; expected case and ray");
}

TEST_CASE("a ray of one's own that names the elements that it starts on is refused") {
  scene::Scene scene = own_scene();
  const scene::ElementRef ball = *scene.find("ball");
  CHECK_THROWS_AS(own_case(scene, {{Rayo(Punto(0, 0, 4), Vector(0, 0, 1)), {ball}}}), std::invalid_argument);
}
