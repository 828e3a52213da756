// Schemas as predicates and as sets: inclusion, decoration, Δ Ξ, θ, the schema calculus, and which conjuncts are false.
#include <algorithm>

#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "support/catch.hpp"

namespace durero::zed {
namespace {

constexpr const char* source = R"(
\begin{zed} [ Cosa ] \end{zed}
\begin{zed} Color ::= rojo | verde | mezcla \ldata \nat \rdata \end{zed}
\begin{schema}{Contador}
  n, limite : \nat
\where
  n \leq limite  % Contador.inv.1
\end{schema}
\begin{schema}{Sumar}
  \Delta Contador \\
  k? : \nat \\
  total! : \nat
\where
  k? > 0  % Sumar.pre.1
\also
  n' = n + k?  % Sumar.post.1
\also
  limite' = limite  % Sumar.post.2
\also
  total! = n'  % Sumar.post.3
\end{schema}
\begin{schema}{Lleno}
  \Xi Contador \\
  k? : \nat \\
  total! : \nat
\where
  n + k? > limite  % Lleno.pre.1
\also
  total! = n  % Lleno.post.1
\end{schema}
\begin{zed} SumarTotal == Sumar \lor Lleno \end{zed}
\begin{zed} Callado == Sumar \hide (total!) \end{zed}
\begin{zed} DosVeces == Sumar \hide (total!) \semi Sumar \hide (total!) \end{zed}
\begin{zed} Posible == \pre Sumar \end{zed}
\begin{zed} Otro == Contador [m / n] \end{zed}
\begin{schema}{Emite} x! : \nat \where x! = 3 \end{schema}
\begin{schema}{Recibe} x? : \nat; y : \nat \where y = x? + 1 \end{schema}
\begin{zed} Tubo == Emite \pipe Recibe \end{zed}
\begin{zed} Par[X, Y] == X \cross Y \end{zed}
\begin{gendef}[X, Y]
  cambiar : X \cross Y \fun Y \cross X
\where
  \forall a : X; b : Y @ cambiar(a, b) = (b, a)
\end{gendef}
\begin{schema}{Caja}[X]
  dentro : \power X \\
  cuantos : \nat
\where
  cuantos = \# dentro
\end{schema}
\begin{axdef}
  doble : \nat \fun \nat \\
  siete : \nat
\where
  \forall a : \nat @ doble(a) = 2 * a
\also
  2 * siete = 14
\end{axdef}
)";

const Evaluator& evaluator() {
  static const Evaluator evaluator = [] {
    const Specification read = read_text(source, "source");
    for (const Defect& defect : read.defects) UNSCOPED_INFO(defect.text());
    REQUIRE(read.ok());
    return Evaluator(read.sections);
  }();
  return evaluator;
}

std::string value(const std::string& expression) { return evaluator().value(parse_unicode(expression)).text(); }
Truth holds(const std::string& predicate) { return evaluator().holds(parse_unicode(predicate)); }

std::vector<Value> values(const SchemaCheck& check, const std::vector<std::pair<std::string, int>>& given) {
  std::vector<Value> in_order(check.components().size(), Open{});
  for (std::size_t i = 0; i < in_order.size(); ++i) {
    for (const auto& [name, number] : given) {
      if (check.components()[i].text() == name) in_order[i] = Real(number);
    }
  }
  return in_order;
}

Truth satisfies(const char* schema, const std::vector<std::pair<std::string, int>>& given) {
  const SchemaCheck check = evaluator().schema({schema, ""});
  return check.holds(values(check, given));
}

std::vector<std::string> broken(const char* schema, const std::vector<std::pair<std::string, int>>& given) {
  const SchemaCheck check = evaluator().schema({schema, ""});
  std::vector<std::string> labels;
  for (const ConjunctTruth& finding : check.findings(values(check, given))) {
    if (finding.truth == Truth::no)
      labels.push_back((finding.label.empty() ? finding.predicate : finding.label) + finding.strokes);
  }
  return labels;
}

using Labels = std::vector<std::string>;

TEST_CASE("an operation holds, or its false conjuncts are named") {
  CHECK(satisfies("Sumar", {{"n", 1}, {"limite", 9}, {"n'", 3}, {"limite'", 9}, {"k?", 2}, {"total!", 3}}) ==
        Truth::yes);
  CHECK(broken("Sumar", {{"n", 1}, {"limite", 9}, {"n'", 4}, {"limite'", 9}, {"k?", 2}, {"total!", 4}}) ==
        Labels{"Sumar.post.1"});
  CHECK(broken("Sumar", {{"n", 8}, {"limite", 9}, {"n'", 10}, {"limite'", 9}, {"k?", 2}, {"total!", 10}}) ==
        Labels{"Contador.inv.1'"});
  CHECK(broken("Sumar", {{"n", 1}, {"limite", 9}, {"n'", 1}, {"limite'", 9}, {"k?", 0}, {"total!", 1}}) ==
        Labels{"Sumar.pre.1"});
  CHECK(broken("Sumar", {{"n", 1}, {"limite", 9}, {"n'", 0}, {"limite'", 9}, {"k?", -1}, {"total!", 0}}) ==
        Labels{"k? ∈ ℕ", "Sumar.pre.1"});
}

TEST_CASE("what is not given leaves open what depends on it, and no more") {
  const SchemaCheck check = evaluator().schema({"Sumar", ""});
  const auto all = check.findings(values(check, {{"n", 1}, {"limite", 0}, {"k?", 0}}));
  const auto truth_of = [&](const std::string& label) {
    return std::find_if(all.begin(), all.end(), [&](auto& finding) { return finding.label + finding.strokes == label; })
        ->truth;
  };
  CHECK(truth_of("Contador.inv.1") == Truth::no);
  CHECK(truth_of("Sumar.pre.1") == Truth::no);
  CHECK(truth_of("Sumar.post.1") == Truth::open);
  CHECK(truth_of("Contador.inv.1'") == Truth::open);
  CHECK(satisfies("Sumar", {{"n", 1}, {"limite", 9}, {"k?", 1}}) == Truth::open);
}

TEST_CASE("disjunction, hiding, composition, pre, renaming, piping") {
  CHECK(satisfies("SumarTotal", {{"n", 9}, {"limite", 9}, {"n'", 9}, {"limite'", 9}, {"k?", 1}, {"total!", 9}}) ==
        Truth::yes);
  CHECK(satisfies("SumarTotal", {{"n", 1}, {"limite", 9}, {"n'", 1}, {"limite'", 9}, {"k?", 1}, {"total!", 1}}) ==
        Truth::no);
  CHECK(satisfies("Callado", {{"n", 1}, {"limite", 9}, {"n'", 2}, {"limite'", 9}, {"k?", 1}}) == Truth::yes);
  CHECK(broken("Callado", {{"n", 1}, {"limite", 9}, {"n'", 3}, {"limite'", 9}, {"k?", 1}}) == Labels{"Sumar.post.1"});
  CHECK(satisfies("DosVeces", {{"n", 1}, {"limite", 9}, {"n'", 7}, {"limite'", 9}, {"k?", 3}}) == Truth::yes);
  CHECK(satisfies("DosVeces", {{"n", 1}, {"limite", 9}, {"n'", 4}, {"limite'", 9}, {"k?", 3}}) == Truth::no);
  CHECK(satisfies("Posible", {{"n", 1}, {"limite", 9}, {"k?", 8}}) == Truth::yes);
  CHECK(satisfies("Posible", {{"n", 1}, {"limite", 9}, {"k?", 9}}) == Truth::no);
  CHECK(satisfies("Otro", {{"m", 1}, {"limite", 1}}) == Truth::yes);
  CHECK(satisfies("Otro", {{"m", 2}, {"limite", 1}}) == Truth::no);
  CHECK(satisfies("Tubo", {{"y", 4}}) == Truth::yes);
  CHECK(satisfies("Tubo", {{"y", 5}}) == Truth::no);
}

TEST_CASE("schemas as sets of bindings, θ, and quantification over them") {
  CHECK(holds("⦉n == 1, limite == 2⦊ ∈ Contador") == Truth::yes);
  CHECK(holds("⦉n == 3, limite == 2⦊ ∈ Contador") == Truth::no);
  CHECK(holds("∃ Contador • n = 2 ∧ limite = n + 1") == Truth::yes);
  CHECK(holds("∃ Contador • n = 2 ∧ limite = n - 1") == Truth::no);
  CHECK(value("{Contador | n = 2 ∧ limite = 3}") == "{⦉limite == 3, n == 2⦊}");
  CHECK(value("{Contador | n = 2 ∧ limite = 3 • θ Contador}") == "{⦉limite == 3, n == 2⦊}");
  // An equation of two θ determines each component.
  CHECK(value("{Contador; Contador ′ | n = 2 ∧ limite = 3 ∧ θ Contador ′ = θ Contador • limite′ - n′}") == "{1}");
  CHECK(value("(λ Contador • limite - n) ⦉n == 1, limite == 5⦊") == "4");
  CHECK(value("(λ Contador • limite - n) ⦉n == 6, limite == 5⦊") == "undefined");
  CHECK(value("# [a, b : 1‥3 | a < b]") == "3");
}

TEST_CASE("axiomatic functions and constants, free types") {
  CHECK(value("doble(21)") == "42");
  CHECK(value("doble(- 1)") == "undefined");
  CHECK(value("siete") == "7");
  CHECK(value("mezcla(3)") == "mezcla(3)");
  CHECK(value("mezcla(- 3)") == "undefined");
  CHECK(holds("mezcla(3) = mezcla(1 + 2)") == Truth::yes);
  CHECK(holds("mezcla(3) = rojo") == Truth::no);
}

TEST_CASE("generic paragraphs, with actuals and without") {
  CHECK(value("Par[1‥2, {3}]") == "{1 ↦ 3, 2 ↦ 3}");
  CHECK(value("cambiar(1, rojo)") == "(rojo, 1)");
  CHECK(value("Caja[1‥1]") == "{⦉cuantos == 0, dentro == ∅⦊, ⦉cuantos == 1, dentro == {1}⦊}");
  CHECK(holds("⦉dentro == {1}, cuantos == 1⦊ ∈ Caja[1‥2]") == Truth::yes);
  CHECK(holds("⦉dentro == {3}, cuantos == 1⦊ ∈ Caja[1‥2]") == Truth::no);
  CHECK(holds("⦉dentro == {3}, cuantos == 1⦊ ∈ Caja[ℕ]") == Truth::yes);
  CHECK(value("{c : Caja[1‥1] | c.cuantos = 1 • c.dentro}") == "{{1}}");
  CHECK(holds("∃ dentro : ℙ (1‥1); cuantos : 1‥1 • Caja[1‥1]") == Truth::yes);
}

TEST_CASE("an undefined application makes the predicate that it stands in false, and its negation true") {
  CHECK(holds("{1 ↦ 2}(3) = 2") == Truth::no);
  CHECK(holds("{1 ↦ 2}(3) ≠ 2") == Truth::no);
  CHECK(holds("¬ {1 ↦ 2}(3) = 2") == Truth::yes);
  CHECK(holds("{1 ↦ 2, 1 ↦ 3}(1) ∈ ℕ") == Truth::no);
}

TEST_CASE("a declaration does not see the names declared beside it, nor an included schema the variables beside it") {
  CHECK(value("{y : 1‥2 • # {y : 1‥3; [x : 1‥y] • (x, y)}}") == "{3, 6}");
  CHECK(value("{y : 2‥2 • # {y : 1‥3; [x : 1‥9 | x < y]}}") == "{3}");
  CHECK(value("{y : 2‥2 • # [y : 1‥3; x : 1‥y]}") == "{6}");
  CHECK(value("{y : 2‥2 • # [y : 1‥3; x : 1‥y]'}") == "{6}");
  CHECK(value("{y : 2‥2 • # ([y : 1‥3; x : 1‥y] ⧹ (y))}") == "{2}");
  CHECK(value("{y : 2‥2 • # {y : 1‥3; x : 1‥y}}") == "{6}");
  CHECK(value("{y : 2‥2 • # (λ y : 1‥3; x : 1‥y • 0)}") == "{6}");
  CHECK(holds("∃ y : 2‥2 • [y : 1‥3; x : 1‥y] = [x : 1‥2; y : 1‥3]") == Truth::yes);
}

TEST_CASE("what is not decided is an error or open, never a guess") {
  CHECK(holds("∃ x : ℕ • x * x * x = 2") == Truth::open);
  CHECK(holds("∀ x, y : ℕ • x * x < x * x + y + 5") == Truth::open);
  CHECK_THROWS_AS(holds("{x : ℕ | x mod 3 > 1} = {x : ℕ | x mod 2 > 0}"), EvaluationError);
  CHECK_THROWS_AS(value("# {x : ℕ | x mod 3 > 1}"), EvaluationError);
  CHECK_THROWS_WITH(value("# {x, y : ℕ | x > 1}"),
                    Catch::Contains("{ x, y : ℕ | x > 1 }") && Catch::Contains("enumerated"));
}

TEST_CASE("the one-point rule looks where the equation must hold, and only there") {
  CHECK(holds("∃ x : ℕ • 2 * x + 1 = 7") == Truth::yes);
  CHECK(holds("∃ x : ℕ • 2 * x + 1 = 6") == Truth::no);
  CHECK(holds("∃ x, y : ℕ • x = y + 1 ∧ y = 3 ∧ x < 5") == Truth::yes);
  CHECK(holds("∃ x : ℕ • (x, 2) = (5, 2) ∧ x > 4") == Truth::yes);
  CHECK(holds("∃ f : ℕ ⇸ ℕ • ¬ f = {1 ↦ 3}") == Truth::yes);
  CHECK(holds("∃ x : ℕ • ¬ x = 3") == Truth::yes);
  CHECK(holds("∃ x : ℕ • (x = 3 ∨ x = 4) ∧ x > 3") == Truth::yes);
  CHECK(value("(μ x : ℕ | x + 2 = 9)") == "7");
  CHECK(value("(μ x : 1‥5 | x > 3)") == "undefined");
}

}  // namespace
}  // namespace durero::zed
