#include "durero/conform/ask/question.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include "durero/io/source.hpp"
#include "durero/model/operaciones.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;
using Outcome = Claim::Outcome;

namespace {

const model::Vector up(0, 1, 0);

/// One element of each type, discs that close the cylinder, and two rays.
SuiteCase sample() {
  SuiteCase of;
  of.family = find_family("generic");
  of.number = 3;
  scene::Scene& scene = of.the_case.scene;
  const auto e = [](const char* name) { return model::Elemento(name); };
  scene.apply(model::Agregar_Esfera{e("e0"), {0.1, 0, 5}, 1});
  scene.apply(model::Agregar_Cilindro{e("e1"), {1, 2, 3}, 0.5, up, 4});
  scene.apply(model::Agregar_Cono{e("e2"), {1, 2, 3}, 0.25, up, 4});
  scene.apply(model::Agregar_Tronco{e("e3"), {1, 2, 3}, 0.5, 0.25, up, 4});
  scene.apply(model::Agregar_Plano{e("e4"), {0, -1, 0}, up});
  scene.apply(model::Agregar_Disco{e("e5"), {1, 2, 3}, 0.5, up});
  scene.apply(model::Agregar_Disco{e("e6"), {1, 6, 3}, 0.5, up});
  scene.apply(model::Agregar_Triangulo{e("e7"), {{0, 0, 0}, {1, 0, 0}, {0, 1e300, 0}}});
  of.solids = {{*scene.find("e1"), {*scene.find("e5"), *scene.find("e6")}}};
  of.the_case.rays = {{{{0, 0, 0}, {0, 0, 1}}}, {{{-0.0, 5e-324, 1e22}, {0.1f, 1, -2}}}};
  return of;
}

std::string question(const SuiteCase& of, Caps caps) {
  std::vector<std::size_t> all(of.the_case.rays.size());
  std::iota(all.begin(), all.end(), 0U);
  return question_text(of, caps, all);
}

std::vector<Question> read_all(const std::string& text) {
  std::FILE* const file = std::tmpfile();
  REQUIRE(file != nullptr);
  std::fwrite(text.data(), 1, text.size(), file);
  std::rewind(file);
  std::vector<Question> questions;
  try {
    QuestionReader reader(*file);
    while (auto question = reader.next()) questions.push_back(std::move(*question));
  } catch (...) {
    std::fclose(file);
    throw;
  }
  std::fclose(file);
  return questions;
}

std::string refusal(const std::string& text) {
  try {
    read_all(text);
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "nothing is wrong";
}

Claim answer(std::string_view line, Caps caps = Caps::open) { return read_answer(line, sample(), caps); }

void check_malformed(std::string_view line, std::string_view wrong, Caps caps = Caps::open) {
  INFO(line);
  const Claim claim = answer(line, caps);
  CHECK(claim.outcome == Outcome::unanswered);
  CHECK(claim.why.starts_with("malformed answer "));
  CHECK(claim.why.ends_with(wrong));
  CHECK(claim.why.find('\n') == std::string::npos);
  CHECK_FALSE((claim.element || claim.t || claim.punto));
}

}  // namespace

TEST_CASE("a question says each element by its points and vectors, then its lengths") {
  CHECK(question(sample(), Caps::open) ==
        "scene generic/0003\n"
        "esfera e0 0.1 0 5 1\n"
        "cilindro e1 1 2 3 0 1 0 0.5 4\n"
        "cono e2 1 2 3 0 1 0 0.25 4\n"
        "tronco e3 1 2 3 0 1 0 0.5 0.25 4\n"
        "plano e4 0 -1 0 0 1 0\n"
        "disco e5 1 2 3 0 1 0 0.5\n"
        "disco e6 1 6 3 0 1 0 0.5\n"
        "triangulo e7 0 0 0 1 0 0 0 1e+300 0\n"
        "rays 2\n"
        "0 0 0 0 0 1\n"
        "-0 5e-324 1e+22 0.10000000149011612 1 -2\n");
}

TEST_CASE("a system of solids is not told of the discs that close them") {
  SuiteCase of = sample();
  const std::string text = question(of, Caps::solid);
  CHECK(text.find("disco") == text.npos);
  CHECK(text.find("cilindro e1") != text.npos);
  of.solids.front().discs.pop_back();  // a disc that closes nothing is told
  CHECK(question(of, Caps::solid).find("disco e6") != text.npos);
}

TEST_CASE("only the rays that are asked stand in a question") {
  const std::size_t second[] = {1};
  const std::string text = question_text(sample(), Caps::open, second);
  CHECK(text.ends_with("rays 1\n-0 5e-324 1e+22 0.10000000149011612 1 -2\n"));
}

TEST_CASE("a question is read as it was written") {
  const SuiteCase of = sample();
  const std::vector<Question> read = read_all(question(of, Caps::open) + question(of, Caps::solid));
  REQUIRE(read.size() == 2);
  CHECK(read[0].scene_name == "generic/0003");
  CHECK(read[0].rays == of.the_case.rays);
  CHECK(std::signbit(read[0].rays[1].rayo.p().x()));
  CHECK(read[0].scene.size() == 8);
  CHECK(read[1].scene.size() == 6);
  SuiteCase again = of;
  again.the_case = {read[0].scene, read[0].rays};
  CHECK(question(again, Caps::open) == question(of, Caps::open));
}

TEST_CASE("a question that is malformed is refused at its place") {
  CHECK(refusal("") == "nothing is wrong");
  CHECK(refusal("scene\n").starts_with("question:1:1: \"scene\"; expected scene"));
  CHECK(refusal("scene a\n").starts_with("question:2:1: the question ends; expected an element"));
  CHECK(refusal("scene a\n\n").starts_with("question:2:1: the line is empty"));
  CHECK(refusal("scene a\nesfera e0 0 0 0\nrays 0\n").starts_with("question:2:16: the line ends; expected a number"));
  CHECK(refusal("scene a\nesfera e0 0 0 0 1 1\nrays 0\n").starts_with("question:2:19: \"1\"; expected the end"));
  CHECK(refusal("scene a\nesfera e0 0 x 0 1\nrays 0\n").starts_with("question:2:13: \"x\"; expected a finite number"));
  CHECK(refusal("scene a\nesfera e0 0 inf 0 1\nrays 0\n").starts_with("question:2:13: \"inf\""));
  CHECK(refusal("scene a\nesfera e/0 0 0 0 1\nrays 0\n").starts_with("question:2:8: no name"));
  CHECK(refusal("scene a\nesfera e0 0 0 0 -1\nrays 0\n").starts_with("question:2:1: radio_no_positivo; expected"));
  CHECK(refusal("scene a\ncubo e0 0 0 0 1\nrays 0\n").starts_with("question:2:1: \"cubo\"; expected an element"));
  CHECK(refusal("scene a\nrays x\n").starts_with("question:2:6: rays without their number"));
  CHECK(refusal("scene a\nrays 2\n0 0 0 0 0 1\n").starts_with("question:4:1: the question ends; expected a ray"));
  CHECK(refusal("scene a\nrays 1\n0 0 0 0 0 0\n") ==
        "question:3:7: v is (0, 0, 0); expected ¬ (v.x = 0 ∧ v.y = 0 ∧ v.z = 0) (Rayo.inv.1)");
}

TEST_CASE("a body is said by its middle and sides, and by a radius where its kind has one") {
  constexpr std::array<glm::dvec3, 3> sides = {{{2, 0, 0}, {0, 1, 0}, {0, 0, 2}}};
  for (const auto& [kind, rest] :
       {std::pair(BodyKind::caja, ""), std::pair(BodyKind::caja_redonda, " 0.5"), std::pair(BodyKind::toro, " 0.5")}) {
    SuiteCase of = sample();
    of.the_case.scene = {};
    const AskedBody body{kind, {0, 0, 5}, sides, 0.5};
    REQUIRE(add_body(of.the_case.scene, model::Elemento("e0"), body));
    of.bodies = {{of.the_case.scene.find("e0").value(), body}};
    of.solids.clear();
    const std::string text = question(of, Caps::open);
    CHECK(text.find(std::string(word(kind)) + " e0 0 0 5 2 0 0 0 1 0 0 0 2" + rest + "\nrays 2\n") != text.npos);
    const Question read = read_all(text)[0];
    CHECK(read.scene.size() == 1);
    REQUIRE(read.bodies.size() == 1);
    CHECK(read.bodies[0].body.kind == kind);
    CHECK(read.bodies[0].body.sides == sides);
  }
  const std::string torus = "scene a\ntoro e0 0 0 5 2 0 0 0 1 0 0 0 2 0.5\n";
  CHECK(refusal(torus + "points 0\n") == "question:3:1: \"points\"; expected no torus beside points");
  CHECK(refusal(torus + "casts 0\n") == "question:3:1: \"casts\"; expected no bodies beside balls");
  CHECK(refusal("scene a\ncaja_redonda e0 0 0 5 2 0 0 0 1 0 0 0 2 0\n")
            .starts_with("question:2:41: \"0\"; expected a radius"));
}

TEST_CASE("the line of a system is its name and version") {
  CHECK(read_system_line("system Embree 3.13.5\r") == "Embree 3.13.5");
  CHECK(read_system_line("system") == std::nullopt);
  CHECK(read_system_line("systems a") == std::nullopt);
  CHECK(read_system_line("pybullet build time: now") == std::nullopt);
}

TEST_CASE("an answer is what its line says") {
  const SuiteCase of = sample();
  const scene::Scene& scene = of.the_case.scene;
  CHECK(answer("miss") == Claim{.outcome = Outcome::miss});
  CHECK(answer(" miss \r") == Claim{.outcome = Outcome::miss});
  CHECK(answer("hit e1 0x1.8p1") == Claim{.outcome = Outcome::hit, .element = scene.find("e1"), .t = 3.0});
  CHECK(answer("hit - 4 1 2 3") == Claim{.outcome = Outcome::hit, .t = 4.0, .punto = glm::dvec3(1, 2, 3)});
  CHECK(answer("hit e0 - 1 2 -inf") == Claim{.outcome = Outcome::hit,
                                             .element = scene.find("e0"),
                                             .punto = glm::dvec3(1, 2, -std::numeric_limits<double>::infinity())});
  CHECK(std::isnan(answer("hit e0 -nan").t.value()));
  CHECK(std::isnan(answer("hit e0 NaN").t.value()));
  CHECK(answer("refused  a degenerate\telement") == Claim{.why = "refused a degenerate element"});
}

TEST_CASE("a hit may say its element alone, or nothing") {
  CHECK(answer("hit e0 -") == Claim{.outcome = Outcome::hit, .element = sample().the_case.scene.find("e0")});
  CHECK(answer("hit - -") == Claim{.outcome = Outcome::hit});
}

TEST_CASE("nothing of a malformed answer is believed") {
  check_malformed("", "the line is empty");
  check_malformed("miss e0", "a miss is miss alone");
  check_malformed("Hit e0 4", "it begins with none of miss, hit, count and refused");
  check_malformed("hit", "a hit is ELEMENT T or ELEMENT T X Y Z");
  check_malformed("hit e0", "a hit is ELEMENT T or ELEMENT T X Y Z");
  check_malformed("hit e0 1 2 3", "a hit is ELEMENT T or ELEMENT T X Y Z");
  check_malformed("hit e0 1 2 3 4 5", "a hit is ELEMENT T or ELEMENT T X Y Z");
  check_malformed("hit e9 1", "the question has no such element");
  check_malformed("hit e5 1", "the question has no such element", Caps::solid);
  check_malformed("hit e0 one", "T is no number");
  check_malformed("hit e0 1 2 3 z", "X Y Z are no three numbers");
  check_malformed("\x1b[2Jmiss\n", "it begins with none of miss, hit, count and refused");
}

TEST_CASE("a claim reads back from its text") {
  const SuiteCase of = sample();
  const scene::Scene& scene = of.the_case.scene;
  const auto infinity = std::numeric_limits<double>::infinity();
  for (const Claim& claim : {Claim{.outcome = Outcome::miss}, Claim{.outcome = Outcome::hit, .t = infinity},
                             Claim{.outcome = Outcome::hit, .element = scene.find("e1"), .t = 0.1},
                             Claim{.outcome = Outcome::hit, .punto = glm::dvec3(5e-324, -0.0, 1e300)},
                             Claim{.outcome = Outcome::crashed, .why = "signal 6"}, Claim{.outcome = Outcome::hung},
                             Claim{.why = "refused a scene"}, Claim{.why = ""}}) {
    const std::string text = claim_text(claim, scene);
    INFO(text);
    CHECK(read_claim(text, scene) == claim);
  }
  CHECK_THROWS_AS(read_claim("refused a scene", scene), std::invalid_argument);
  CHECK_THROWS_AS(read_claim("hit e99 1", scene), std::invalid_argument);
}

TEST_CASE("a hit may say its normal, the side of the ray, and u and v, in the order of the protocol or another") {
  const SuiteCase of = sample();
  const auto read = [&](const char* line) { return read_answer(line, of, Caps::open); };
  const Claim full = read("hit e0 4 0 0 4 normal 0 0 -1 front uv 0.25 0.5");
  CHECK(full.outcome == Outcome::hit);
  CHECK(full.t == 4.0);
  CHECK(full.punto == glm::dvec3(0, 0, 4));
  CHECK(full.normal == glm::dvec3(0, 0, -1));
  CHECK(full.is_front == true);
  CHECK(full.uv == glm::dvec2(0.25, 0.5));
  CHECK(read("hit e0 4 0 0 4 uv 0.25 0.5 normal 0 0 -1 front") == full);
  CHECK(read("hit - - back").is_front == false);
  CHECK(read_claim(claim_text(full, of.the_case.scene), of.the_case.scene) == full);
  for (const char* bad : {"hit e0 4 normal 0 0", "hit e0 4 normal 0 0 -1 1", "hit e0 4 uv 1", "hit e0 4 uv 1 x",
                          "hit e0 4 front 1", "hit e0 front", "hit e0 4 5 front"})
    CHECK(read(bad).outcome == Outcome::unanswered);
}

TEST_CASE("a question about shadow rays has the end of each, and a hit alone is an answer to it") {
  SuiteCase of = sample();
  CHECK(read_answer("hit", of, Caps::open).outcome == Outcome::unanswered);
  of.question = QuestionKind::shadow;
  of.ranges = {{0, 4}, {0, 0.1}};
  const std::string text = question(of, Caps::open);
  CHECK(text.ends_with("shadows 2\n0 0 0 0 0 1 4\n-0 5e-324 1e+22 0.10000000149011612 1 -2 0.1\n"));
  const std::vector<Question> read = read_all(text + question(sample(), Caps::open));
  REQUIRE(read.size() == 2);
  CHECK(read[0].ranges == of.ranges);
  CHECK(read[0].rays.size() == 2);
  CHECK(read[1].ranges.empty());
  CHECK(read_answer("hit", of, Caps::open) == Claim{.outcome = Outcome::hit});
  CHECK(read_answer("hit e0 4", of, Caps::open).outcome == Outcome::hit);
  CHECK(read_answer("miss", of, Caps::open).outcome == Outcome::miss);
  CHECK_THROWS_AS(read_all("scene a\nshadows 1\n0 0 0 0 0 1\n"), io::InputError);
  CHECK_THROWS_AS(read_all("scene a\nrays 1\n0 0 0 0 0 1 4\n"), io::InputError);
  CHECK_THROWS_AS(read_all("scene a\nshadows 1\n0 0 0 0 0 1 -4\n"), io::InputError);
}

TEST_CASE("a question about ranges has both ends of each, and a hit alone is no answer to it") {
  SuiteCase of = sample();
  of.question = QuestionKind::range;
  of.ranges = {{0.5, 4}, {3, 0.1}};
  const std::string text = question(of, Caps::open);
  CHECK(text.ends_with("ranges 2\n0 0 0 0 0 1 0.5 4\n-0 5e-324 1e+22 0.10000000149011612 1 -2 3 0.1\n"));
  const std::vector<Question> read = read_all(text);
  CHECK(read[0].kind == QuestionKind::range);
  CHECK(read[0].ranges == of.ranges);
  CHECK(read_answer("hit", of, Caps::open).outcome == Outcome::unanswered);
  CHECK(read_answer("hit e0 4", of, Caps::open).outcome == Outcome::hit);
  CHECK_THROWS_AS(read_all("scene a\nranges 1\n0 0 0 0 0 1 4\n"), io::InputError);
  CHECK_THROWS_AS(read_all("scene a\nranges 1\n0 0 0 0 0 1 4 5 6\n"), io::InputError);
}

TEST_CASE("a question about all hits is answered by a list, and one about their number by that") {
  SuiteCase of = sample();
  of.question = QuestionKind::all;
  CHECK(question(of, Caps::open).ends_with("crossings 2\n0 0 0 0 0 1\n-0 5e-324 1e+22 0.10000000149011612 1 -2\n"));
  CHECK(read_all(question(of, Caps::open))[0].kind == QuestionKind::all);
  const auto read = [&](const char* line) { return read_answer(line, of, Caps::open); };
  const Claim list = read("hit e0 4 0 0 4 normal 0 0 -1 ; hit - 5 ; hit e1 - back");
  REQUIRE(list.behind.size() == 2);
  CHECK(list.t == 4.0);
  CHECK(list.normal == glm::dvec3(0, 0, -1));
  CHECK(list.behind[0] == Claim{.outcome = Outcome::hit, .t = 5});
  CHECK(list.behind[1].element == of.the_case.scene.find("e1"));
  CHECK(list.behind[1].is_front == false);
  CHECK(read_claim(claim_text(list, of.the_case.scene), of.the_case.scene) == list);
  CHECK(read("hit e0 4").behind.empty());
  CHECK(read("miss").outcome == Outcome::miss);
  for (const char* bad : {"hit e0 4 ;", "hit e0 4 ; miss", "hit e0 4 ; e0 5", "; hit e0 4", "hit e0 4 ; hit e99 5",
                          "hit e0 4; hit e0 5", "count 2", "hit"})
    CHECK(read(bad).outcome == Outcome::unanswered);
  CHECK(read("hit e0 4 ; hit e5 5").outcome == Outcome::hit);
  for (const char* of_disc : {"hit e5 4 ; hit e0 5", "hit e0 4 ; hit e5 5", "hit e0 4 ; hit e1 5 ; hit e6 6"})
    CHECK(read_answer(of_disc, of, Caps::solid).why.ends_with("the question has no such element"));
  of.question = QuestionKind::count;
  CHECK(question(of, Caps::open).find("\ncounts 2\n") != std::string::npos);
  CHECK(read("count 2") == Claim{.outcome = Outcome::hit, .count = 2});
  CHECK(read("count 0") == Claim{.outcome = Outcome::miss, .count = 0});
  CHECK(read("miss") == read("count 0"));
  CHECK(read_claim("count 2", of.the_case.scene) == read("count 2"));
  for (const char* bad : {"count", "count -1", "count 1.5", "count 2 3", "hit e0 4", "2"})
    CHECK(read(bad).outcome == Outcome::unanswered);
  of.question = QuestionKind::first;
  CHECK(read("hit e0 4 ; hit e0 5").why == "malformed answer \"hit e0 4 ; hit e0 5\": one hit was asked for");
  CHECK(read("count 2").why == "malformed answer \"count 2\": no count was asked for");
}
