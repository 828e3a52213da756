#include "durero/conform/families/asked_grid.hpp"

#include <fmt/format.h>

#include <numeric>

#include "durero/conform/ask/question.hpp"
#include "durero/conform/families/suite.hpp"
#include "durero/conform/judge/judge.hpp"
#include "durero/conform/judge/minimise.hpp"
#include "durero/conform/report/tally.hpp"
#include "durero/io/source.hpp"
#include "durero/model/operaciones.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

const AskedGrid ramp{
    .name = "m", .columns = 2, .rows = 3, .x = 1, .y = 2, .dx = 0.5, .dy = 4, .heights = {0, 0, 0, 1, 1, 1}};

scene::Scene scene_of(const scene::Mesh& mesh) {
  scene::Scene scene;
  scene.apply_total(scene::MeshAddition{mesh});
  return scene;
}

const SuiteOptions of_grids{.rays = 64, .bodies = {BodyKind::campo}};
const Profile profile_of_grids{.bodies = {BodyKind::campo}};

SuiteCase terrain() {
  SuiteCase of = suite_case(of_grids, *find_family("terrain"), 0);
  answer(of);
  return of;
}

std::string question(const SuiteCase& of) {
  std::vector<std::size_t> all(of.the_case.rays.size());
  std::iota(all.begin(), all.end(), 0U);
  return question_text(of, Caps::open, all);
}

Question read(const std::string& text) {
  std::FILE* const file = std::tmpfile();
  REQUIRE(file != nullptr);
  std::fwrite(text.data(), 1, text.size(), file);
  std::rewind(file);
  std::optional<Question> read;
  try {
    read = QuestionReader(*file).next();
  } catch (...) {
    std::fclose(file);
    throw;
  }
  std::fclose(file);
  return *std::move(read);
}

std::string refusal(const std::string& line) {
  try {
    read("scene a\n" + line + "\nrays 0\n");
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "nothing is wrong";
}

}  // namespace

TEST_CASE("a mesh is a grid where its points and faces are, exactly") {
  const scene::Mesh mesh = mesh_of(ramp);
  CHECK(mesh.puntos.size() == 6);
  CHECK(mesh.caras.size() == 4);
  CHECK(mesh.puntos[4] == glm::dvec3(1.5, 6, 1));
  const std::optional<AskedGrid> grid = grid_of(scene_of(mesh));
  REQUIRE(grid);
  CHECK(grid->columns == 2);
  CHECK(grid->rows == 3);
  CHECK(grid->dx == 0.5);
  CHECK(grid->dy == 4);
  CHECK(grid->heights == ramp.heights);
  scene::Mesh moved = mesh;
  moved.puntos.set(4, glm::dvec3(1.5, 6.5, 1));
  CHECK_FALSE(grid_of(scene_of(moved)));
  scene::Mesh turned = mesh;
  turned.caras[0] = {1, 0, 4};
  CHECK_FALSE(grid_of(scene_of(turned)));
  scene::Scene more = scene_of(mesh);
  test::add(more, scene::Sphere{{}, 1});
  CHECK_FALSE(grid_of(more));
  CHECK_FALSE(grid_of({}));
}

TEST_CASE("a system of height fields alone is asked grids, and one with triangles the triangles") {
  for (const Family& family : families()) CHECK((cases(of_grids, family) > 0) == (family.name == "terrain"));
  SuiteOptions both = of_grids;
  both.tipos = {model::Tipo::soy_triangulo};
  CHECK(cases(both, *find_family("seams")) > 0);
  CHECK_FALSE(suite_case(both, *find_family("terrain"), 0).is_grid);
  const SuiteCase of = terrain();
  CHECK(of.is_grid);
  const std::string text = question(of);
  CHECK(text.starts_with("scene terrain/0000\ncampo m "));
  CHECK(text.find("triangulo") == text.npos);
  const Question again = read(text);
  CHECK(again.rays == of.the_case.rays);
  REQUIRE(grid_of(again.scene));
  CHECK(grid_of(again.scene)->heights == grid_of(of.the_case.scene)->heights);
  CHECK(again.scene.meshes()[0].caras == of.the_case.scene.meshes()[0].caras);
}

TEST_CASE("a grid that is malformed is refused at its place") {
  CHECK(refusal("campo m 2 2 0 0 1 1 0 0 0 1") == "nothing is wrong");
  CHECK(refusal("campo m 2 2 0 0 1 1 0 0 0").starts_with("question:2:26: 3 heights; expected 4"));
  CHECK(refusal("campo m 1 2 0 0 1 1 0 0").starts_with("question:2:9: \"1\"; expected a number of points"));
  CHECK(refusal("campo m 2 2.5 0 0 1 1 0 0 0 0 0").starts_with("question:2:11: \"2.5\"; expected a number of points"));
  CHECK(refusal("campo m 2 2 0 0 0 1 0 0 0 1").starts_with("question:2:17: a way that is not positive"));
  CHECK(refusal("campo m 2 2 0 0 1e308 1 0 0 0 1").find("points beyond all numbers") != std::string::npos);
  CHECK(refusal("campo m 1e300 2 0 0 1 1 0").starts_with("question:2:9: \"1e300\""));
  CHECK(refusal("campo m 2 2 0 0 1 1 0 0 0 x").starts_with("question:2:27: \"x\""));
}

TEST_CASE("hits on a grid are those of its triangles, named by one, by the mesh or by nothing") {
  const SuiteCase of = terrain();
  CHECK(outside(of, 0, profile_of_grids).empty());
  CHECK(outside(of, 0, {.bodies = {BodyKind::caja}}) == "no triangulo");
  std::size_t hits = 0;
  for (std::size_t ray = 0; ray < of.truths.size(); ++ray) {
    const scene::Hit& hit = of.truths[ray].hit;
    if (hit.resultado != model::Resultado::hit) continue;
    ++hits;
    const auto verdict = [&](const std::string& name, double t) {
      return judge(of, ray, read_answer(fmt::format("hit {} {:a}", name, t), of, Caps::open), profile_of_grids).verdict;
    };
    CHECK(verdict("m", hit.t) == Verdict::exact);
    CHECK(verdict("-", hit.t) == Verdict::exact);
    CHECK(verdict(std::string(of.the_case.scene.name(hit.elementos[0]).name()), hit.t) == Verdict::exact);
    CHECK(is_failure(verdict("m", hit.t * 1.5 + 1)));
  }
  CHECK(hits > 20);
  CHECK(read_answer("hit n 1", of, Caps::open).outcome == Claim::Outcome::unanswered);
}

TEST_CASE("a failure on a grid is made small by its ray alone") {
  const Ask blind = [](const SuiteCase&) { return Claim{.outcome = Claim::Outcome::miss}; };
  const SuiteCase whole = terrain();
  for (std::size_t ray = 0; ray < whole.truths.size(); ++ray) {
    const SuiteCase of = with_ray_alone(whole, ray);
    const ClaimJudgement is = judge(of, 0, blind(of), profile_of_grids);
    if (!is_failure(is.verdict)) continue;
    const Finding least = minimised({of, ray, blind(of), is}, profile_of_grids, blind);
    CHECK(least.of.is_grid);
    CHECK(least.of.the_case.scene.size() == of.the_case.scene.size());
    CHECK(question(least.of).find("\ncampo m ") != std::string::npos);
    return;
  }
  FAIL("no ray hits the grid");
}
