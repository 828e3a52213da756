#include "durero/spec/calculator.hpp"

#include <fmt/format.h>

#include "durero/model/operaciones.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/spec/constants.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"
#include "support/scenes.hpp"

namespace durero::spec {
namespace {

std::string value(const Calculator& calculator, const std::string& typed) { return calculator.evaluate(typed).text; }

model::Escena spheres(const std::vector<std::string>& names) {
  model::Escena escena;
  for (const std::string& name : names)
    model::apply(escena, model::Agregar_Esfera{model::Elemento(name), model::Punto(0, 0, 5), 1});
  return escena;
}

TEST_CASE("what is printed is typed again and gives the same") {
  const Calculator calculator;
  for (const auto& [typed, printed] : std::vector<std::pair<std::string, std::string>>{
           {"1 / 3", "1/3"},
           {"0.25", "1/4"},
           {"0.1 + 0.2", "3/10"},
           {"12.50 * 2", "25"},
           {"-(7 / 2)", "-7/2"},
           {"raizcuadrada(2) / 2", "1/2*√2"},
           {"1/2 + 3/4 * √ 5", "1/2+3/4*√5"},
           {"1/2 - 3/4 * √ 5", "1/2-3/4*√5"},
           {"√ 3 * √ 3", "3"},
           {"√ (1 + 2 * √ 3)", "√(1+2*√3)"},
           {"{ 1/2, 0.5, 0.75 }", "{1/2, 3/4}"},
           {"⦉x == 0.5, y == -1/3, z == 2⦊", "⦉x == 1/2, y == -1/3, z == 2⦊"},
           {"{ 0.5 ↦ soy_cono }", "{1/2 ↦ soy_cono}"},
           {"((1, 2), 3).1.2", "2"},
           {"{1} ∖ {1}", "∅[𝔸]"},
           {"∅[ℝ]", "∅[𝔸]"},
           {"\\emptyset[\\nat]", "∅[𝔸]"},
           {"{ t : Tipo | t ≠ t }", "∅[Tipo]"},
           {"ℙ {soy_cono}", "{∅[Tipo], {soy_cono}}"},
           {"({1}, ∅[ℙ ℕ], 2)", "({1}, ∅[ℙ 𝔸], 2)"},
           {"{ 1 ↦ {2} ∖ {2} }", "{1 ↦ ∅[𝔸]}"},
           {"{ ({2} ∖ {2}) ↦ 1 }", "{∅[𝔸] ↦ 1}"},
           {"{ (1, 2, ∅[Tipo]) }", "{(1, 2, ∅[Tipo])}"},
           {"⦉x == {1 ↦ 2} ∖ {1 ↦ 2}, y == 1⦊", "⦉x == ∅[𝔸 × 𝔸], y == 1⦊"},
           {"∅[Punto]", "∅[[x : 𝔸; y : 𝔸; z : 𝔸]]"},
           {"∅[ℙ (Elemento × (ℕ × Tipo))]", "∅[ℙ (Elemento × (𝔸 × Tipo))]"},
           {"⟨⟩ ⁀ ({1 ↦ soy_cono} ∖ {1 ↦ soy_cono})", "⟨⟩"},
       }) {
    CAPTURE(typed);
    CHECK(value(calculator, typed) == printed);
    CHECK(value(calculator, printed) == printed);
  }
  CHECK_FALSE(calculator.evaluate("1 / 0").yes);
  CHECK(value(calculator, "\\{ 1, 2 \\} \\cup \\{ 3 \\}") == "{1, 2, 3}");
  CHECK_THROWS_AS(calculator.evaluate("√ (-(1))"), zed::EvaluationError);
}

TEST_CASE("every dyadic number and every root that is printed is typed again") {
  const Calculator calculator;
  test::property("of moderate numbers", [&] {
    const int n = *rc::gen::inRange(-1000, 1000), d = *rc::gen::inRange(1, 1000), r = *rc::gen::inRange(0, 1000);
    const std::string printed = value(calculator, fmt::format("({}) / {} + √({} / {})", n, d, r, d));
    RC_ASSERT(value(calculator, printed) == printed);
    RC_ASSERT(calculator.evaluate(fmt::format("{} = ({}) / {} + √({} / {})", printed, n, d, r, d)).yes);
  });
}

TEST_CASE("an element of any name has a spelling") {
  const std::vector<std::string> names = {"a", "a-b", "1.2:x", "-", "if", "dom", "elementos", "x_1", "Escena"};
  const Calculator calculator(spheres(names));
  for (const std::string& name : names) {
    CAPTURE(name);
    CHECK(calculator.evaluate("\"" + name + "\" ∈ elementos").yes);
    CHECK(value(calculator, "de_que_tipo(\"" + name + "\")") == "soy_esfera");
  }
  CHECK(calculator.evaluate("\"a\" = a ∧ \"x_1\" = x_1 ∧ a ≠ \"a-b\"").yes);
  const std::string all = value(calculator, "elementos");
  CHECK(all == R"({"-", "1.2:x", "Escena", a, "a-b", "dom", "elementos", "if", x_1})");
  CHECK(calculator.evaluate(all + " = elementos").yes);
  CHECK(value(calculator, "mi_radio ▷ {1}").find("\"a-b\" ↦ 1") != std::string::npos);
  CHECK_THROWS_AS(calculator.evaluate("\"nadie\""), zed::ZError);
  CHECK_THROWS_AS(calculator.evaluate("\"a"), zed::ZError);
  CHECK_THROWS_WITH(calculator.evaluate("\"\""), Catch::Contains("a quoted name ends here"));
  CHECK_THROWS_AS(calculator.evaluate("\"a b\""), zed::ZError);
}

TEST_CASE("the components of a scene without elements are printed with their types") {
  const Calculator calculator{model::Escena()};
  CHECK(value(calculator, "elementos") == "∅[Elemento]");
  CHECK(value(calculator, "mi_radio") == "∅[Elemento × 𝔸]");
  CHECK(calculator.evaluate("∅[Elemento] = elementos ∧ ∅[Elemento × 𝔸] = mi_radio").yes);
  CHECK_THROWS_AS(calculator.evaluate("∅[𝔸] = elementos"), zed::ZError);
  const std::string state = value(calculator, "θ Escena");
  CHECK(state.find("elementos == ∅[Elemento]") != std::string::npos);
  CHECK(value(calculator, state) == state);
  CHECK(calculator.evaluate(state + " = θ Escena").yes);
}

TEST_CASE("a scene of ten thousand elements is a scene like another") {
  std::vector<std::string> names;
  for (int i = 0; i < 10000; ++i) names.push_back(fmt::format("s-{}", i));
  model::Escena escena;
  for (const std::string& name : names) {  // as scene::retrieve makes it, without a check for each
    const model::Elemento e(name);
    escena.elementos.insert(e);
    escena.de_que_tipo.emplace(e, model::Tipo::soy_esfera);
  }
  const Calculator calculator(escena);
  CHECK(value(calculator, "# elementos") == "10000");
  CHECK(calculator.evaluate("\"s-0\" ∈ elementos ∧ de_que_tipo(\"s-9999\") = soy_esfera").yes);
}

TEST_CASE("a connective of schemas is a schema, and a predicate is true or false") {
  const Calculator calculator;
  CHECK(value(calculator, "[x : 1‥2] ∨ [x : 3‥3]") == "{⦉x == 1⦊, ⦉x == 2⦊, ⦉x == 3⦊}");
  CHECK(value(calculator, "∀ x : 1‥9 • x * x ≤ 81") == "true");
  CHECK_FALSE(calculator.evaluate("1 > 2").yes);
  CHECK_THROWS_AS(calculator.evaluate("∀ x, y : ℕ • x * x + y ≥ x"), zed::EvaluationError);
  CHECK_THROWS_AS(calculator.evaluate("nadie"), zed::ZError);
}

TEST_CASE("an explanation is a tree, and its text a line for each part of it") {
  const Calculator calculator;
  zed::Steps steps;
  const std::string asked = "∀ x : 1‥3 • x < 3 ∧ x > 0";
  const ExplainedTerm whole = calculator.explained(asked, steps);
  CHECK(whole.value == "false");
  REQUIRE(whole.parts.size() == 1);
  const ExplainedTerm& witness = whole.parts[0];
  CHECK(witness.term == "counter-example");
  CHECK(witness.value == "x == 3");
  CHECK(witness.is_witness);
  REQUIRE(witness.parts.size() == 1);
  REQUIRE(witness.parts[0].parts.size() == 2);
  CHECK_FALSE(witness.parts[0].is_witness);
  CHECK(witness.parts[0].parts[0].term == "x < 3");
  CHECK(witness.parts[0].parts[0].value == "false");
  CHECK(witness.parts[0].parts[1].value == "true");
  CHECK(calculator.explain(asked, steps) ==
        "∀ x : 1 ‥ 3 • x < 3 ∧ x > 0  ▸  false\n  counter-example  ▸  x == 3\n    x < 3 ∧ x > 0  ▸  false\n"
        "      x < 3  ▸  false\n        x  ▸  3\n      x > 0  ▸  true\n        x  ▸  3\n");
}

TEST_CASE("local names have their values in a term, and its parts too") {
  const Calculator calculator(spheres({"a", "b"}));
  zed::Steps steps;
  LocalNames locals;
  calculator.add_local(locals, "e?", "b", steps);
  calculator.add_local(locals, "radio?", "3/2", steps);
  calculator.add_local(locals, "twice", "2 * radio?", steps);
  CHECK(calculator.evaluate("twice + 1", steps, locals).text == "4");
  CHECK(calculator.evaluate("e? ∈ elementos ∧ radio? ∈ Rmas", steps, locals).yes);
  CHECK(calculator.explained("e? ∈ elementos", steps, locals).parts.at(0).value == "b");
  CHECK_THROWS_AS(calculator.evaluate("twice", steps), zed::ZError);
  CHECK_THROWS_AS(calculator.add_local(locals, "1", "2", steps), zed::ZError);
  CHECK_THROWS_AS(calculator.add_local(locals, "x", "1 = 1", steps), zed::ZError);
  CHECK_THROWS_AS(calculator.add_local(locals, "x", "1/0", steps), zed::ZError);
  CHECK(locals.values.size() == 3);
}

TEST_CASE("a scope gives given sets members that have names, and constants values") {
  const std::string text = "\\begin{zed} [N, M] \\end{zed}\n\\begin{axdef} k : \\nat \\end{axdef}\n";
  Calculator calculator(zed::read_text(text, "t.tex"));
  CHECK_THROWS_AS(calculator.evaluate("∀ n, m : N • n = m"), zed::EvaluationError);
  CHECK(calculator.scope({"N=2", "k=7", "M=ann,bob"}) ==
        std::vector<std::string>{"within N = {N1, N2}", "within M = {ann, bob}"});
  CHECK(calculator.evaluate("∀ n, m : N • n = m").text == "false");
  CHECK(calculator.evaluate("# N + k").text == "9");
  CHECK(calculator.evaluate("M ∖ {ann}").text == "{bob}");
  CHECK(calculator.evaluate("∃ f : N ⤖ M • f N1 = bob").yes);
  for (const char* wrong : {"N=", "N=a-b", "N=k", "N=a,a", "k=0 - 1", "unknown=3"})
    CHECK_THROWS_AS(Calculator(zed::read_text(text, "t.tex")).scope({wrong}), ConstantError);
}

TEST_CASE("a set of elements gives their names, ascending, and nothing else is such a set") {
  const Calculator calculator(spheres({"b", "a-1", "c", "radio"}));
  zed::Steps steps;
  using Elements = std::vector<std::string>;
  CHECK(calculator.names("elementos", steps) == Elements{"a-1", "b", "c", "radio"});
  CHECK(calculator.names("{ e : elementos | mi_radio e < 1 }", steps).empty());
  CHECK(calculator.names("{ c, \"a-1\", c }", steps) == Elements{"a-1", "c"});
  CHECK(calculator.names("∅[Elemento]", steps).empty());
  CHECK_THROWS_AS(calculator.names("b", steps), zed::ZError);
  CHECK_THROWS_AS(calculator.names("mi_radio", steps), zed::ZError);
  CHECK_THROWS_AS(calculator.names("1 = 1", steps), zed::ZError);
  CHECK_THROWS_AS(calculator.names("{ 1 }", steps), zed::ZError);
  CHECK_THROWS_AS(calculator.names("Elemento", steps), zed::EvaluationError);
}

}  // namespace
}  // namespace durero::spec
