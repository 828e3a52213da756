#include "durero/zed/types/typecheck.hpp"

#include <fmt/core.h>

#include <set>

#include "durero/zed/review/review.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "support/catch.hpp"
#include "zed/lines.hpp"

using namespace durero::zed;
using namespace durero::zed::test;

namespace {

Lines reported(const std::vector<std::string>& files) {
  Lines defects_by_line;
  const Specification read = read_files(files);
  report(read.defects, defects_by_line);
  const Typing typing = check(read);
  report(typing.defects, defects_by_line);
  report(doubled_operations(read, typing), defects_by_line);  // E04 is an opinion: ISO Z takes it
  return defects_by_line;
}

Specification text(const std::string& body) { return read_text(body, "here.tex"); }

/// Returns what is wrong first with these predicates of two sets, of which nothing else tells the type; or "right".
std::string judged(const std::string& predicates) {
  const Typing typing = check(text(R"(\begin{zed} g[X] == X \end{zed} \begin{axdef} s == g; t == g; x : \nat \where )" +
                                   predicates + R"( \end{axdef})"));
  return typing.ok() ? "right" : typing.defects[0].what;
}

}  // namespace

TEST_CASE("spec/ has no type error") {
  for (const auto& [file, lines] : reported(files_in("spec")))
    for (const auto& [line, all] : lines) FAIL_CHECK(all[0]);
}

TEST_CASE("the type defects of the printed text are reported at their lines, and nothing else is") {
  const std::vector<std::string> files = files_in("spec/impresa");
  Lines marked;
  for (const std::string& file : files)
    marks(
        file, [](const std::string& word) { return word.size() == 3 && word[0] == 'E' && std::isdigit(word[1]); },
        marked);
  const Lines seen = reported(files);
  const std::set<std::string> of_types = {"E01", "E02", "E03", "E04", "E08"};
  std::set<std::string> numbers_seen;
  for (const auto& [file, lines] : marked)
    for (const auto& [line, numbers] : lines)
      for (const std::string& number : numbers) {
        if (!of_types.contains(number)) continue;
        CAPTURE(file, line, number);
        CHECK(has(seen, file, line));
        numbers_seen.insert(number);
      }
  CHECK(numbers_seen == of_types);
  for (const auto& [file, lines] : seen)
    for (const auto& [line, what] : lines) {
      CAPTURE(what);
      CHECK(has(marked, file, line));
    }
}

TEST_CASE("an error names both types in Z notation, and its place") {
  const Typing typing =
      check(text("\\begin{zed} [A] \\end{zed}\n\\begin{axdef}\n  a : A\n\\where\n  a = 1\n\\end{axdef}\n"));
  REQUIRE(typing.defects.size() == 1);
  CHECK(typing.defects[0].text() == "here.tex:5:3: = between A and 𝔸; expected one type on both sides");
}

TEST_CASE("an error says what may be meant") {
  const auto expected = [](const std::string& body) {
    const Typing typing = check(text("\\begin{schema}{Contador} n : \\nat \\end{schema}\n" + body));
    return typing.defects.empty() ? "" : typing.defects[0].expected;
  };
  CHECK(expected("\\begin{zed} Op == [ \\Delta Contadr ] \\end{zed}") ==
        "expected a declared name; did you mean ΔContador?");
  CHECK(expected("\\begin{zed} Op == [ \\Delta Contador | m' = n' + 1 \\land Contadro ] \\end{zed}") ==
        "expected a declared name");
  CHECK(expected("\\begin{zed} Op == [ contador : \\nat | contadro = 1 ] \\end{zed}") ==
        "expected a declared name; did you mean contador?");
  CHECK(expected("\\begin{axdef} a, b : \\nat \\where a = 1\n b = 2 \\end{axdef}") ==
        "expected a function before its argument, or a new line \\\\ between the two");
  CHECK(expected("\\begin{axdef} a, b : \\nat \\where a = 1~b \\end{axdef}") ==
        "expected a function before its argument");
  const std::string divides =
      "\\begin{zed} \\relation (\\_ ~divides~ \\_) \\end{zed}\n"
      "\\begin{axdef} \\_ ~divides~ \\_ : \\nat \\rel \\nat; a : \\nat \\where ";
  CHECK(expected(divides + "a divides a \\end{axdef}") ==
        "expected a declared name; did you mean a divides a (a~divides~a in LaTeX)?");
  CHECK(expected(divides + "(a divides 6, 1) = (1, 1) \\end{axdef}") ==
        "expected a declared name; did you mean a divides 6 (a~divides~6 in LaTeX)?");
  CHECK(expected("\\begin{schema}{Op} y? : \\nat \\where y = 1 \\end{schema}") ==
        "expected a declared name, such as y?");
  CHECK(expected(divides + "a6 = 1 \\end{axdef}") == "expected a declared name");
  CHECK(expected(divides + "a^{2} = 1 \\end{axdef}") ==
        "expected a declared name; an iteration has blanks, R ↗ n ↙ (R~^{~n~} in LaTeX)");
}

TEST_CASE("a name of the toolkit that no ancestor declares is told by the parent that would give it") {
  const auto expected = [](const std::string& parents, const std::string& value) {
    const Typing typing = check(text("\\begin{zsection} \\SECTION s \\parents " + parents +
                                     " \\end{zsection}\n\\begin{zed} n == " + value + " \\end{zed}"));
    return typing.defects.empty() ? "" : typing.defects[0].expected;
  };
  CHECK(expected("function\\_toolkit", "\\max \\{1\\}") ==
        "expected sequence_toolkit among the ancestors, or a declaration");
  CHECK(expected("number\\_toolkit", "\\{ x : \\nat | x \\neq 1 \\}") ==
        "expected set_toolkit among the ancestors, or a declaration");
  CHECK(expected("sequence\\_toolkit", "\\max \\{1\\}").empty());
  CHECK(expected("function\\_toolkit", "haed") == "expected a declared name");
  CHECK(expected("sequence\\_toolkit", "haed") == "expected a declared name; did you mean head?");
}

TEST_CASE("several errors are reported, not only the first") {
  const Typing typing =
      check(text("\\begin{zed} [A] \\end{zed}\n\\begin{zed} B == x \\end{zed}\n\\begin{zed} C == A + 1 \\end{zed}\n"));
  REQUIRE(typing.defects.size() == 2);
  CHECK(typing.defects[0].place.line == 2);
  CHECK(typing.defects[1].place.line == 3);
}

TEST_CASE("what is selected from a value of a function that is in error is not known") {
  const Typing typing =
      check(text("\\begin{zed} [X] \\end{zed}\n\\begin{schema}{S} f : X \\pfun Missing; x : X \\end{schema}\n"
                 "\\begin{schema}{T} S \\where (f(x)).b = 1 \\end{schema}\n"));
  REQUIRE(typing.defects.size() == 2);
  CHECK(typing.defects[0].what == "Missing is not declared");
  CHECK(typing.defects[1].what == "f x has the type ?");
}

TEST_CASE("the components of a schema may be told behind its use, wherever a schema stands") {
  for (const char* right : {
           R"(s \hide (x) = t \\ s = [x, y : \nat])",
           R"(s [y/x] = t \\ s = [x : \nat])",
           R"((\pre s) = t \\ s = [x, x' : \nat])",
           R"((s \semi s) = t \\ s = [x, x' : \nat])",
           R"((\lnot s) = t \\ s = [x : \nat])",
           R"((s \land [z : \nat]) = t \\ s = [x : \nat] \\ t = [x, z : \nat])",
           R"((\exists s @ [x, y : \nat]) = t \\ s = [x : \nat] \\ t = [y : \nat])",
           R"((\exists y : \nat @ s) = t \\ s = [x, y : \nat] \\ t = [x : \nat])",
           R"([s | x > 0] = t \\ s = [x : \nat])",
           R"((\forall s @ y = 1) \\ s = [y : \nat] \\ t = \{1\})",
           R"(\{ s | x = \{1\} \} = t \\ s = [x : \power \nat])",
           R"(\{ s | true \} = t \\ t = \{ \lblot y == \{1\} \rblot \} \\ s = [y : \power \nat])",
           R"(\theta s = \lblot x == 1 \rblot \\ s = [x : \nat] \\ t = s)",
           R"(s \\ t = s \\ s = [x : \nat])",
           R"((\forall c : s \hide (x) @ c.y = 1) \\ s = [x, y : \nat] \\ t = s)",
           R"(t \hide (y) = [z : \nat] \\ s \hide (x) = t \\ s = [x, y, z : \nat])",
           R"(t \hide (y) = [z : \nat] \\ \{ s | t = [x : \nat] \} = \{\} \\ )"
           R"(s = [t : \power [x : \nat]] \\ t = [y, z : \nat])",
           R"(\exists e : s @ (e \hide (x) = t \land e = [x, y : \nat]))",
       }) {
    CAPTURE(right);
    CHECK(judged(right) == "right");
  }
}

TEST_CASE("a text is refused where its schemas, told behind their use, do not fit it") {
  CHECK(judged(R"(s \hide (x) = t \\ s = [y : \nat])") == "x is no component of the schema");
  CHECK(judged(R"(s \hide (x) = t \\ t = [y : \nat])") == "an expression of type ℙ ? stands before ⧹");
  CHECK(judged(R"(s \hide (x) = t \\ s = \{1\})") == "an expression of type ℙ 𝔸 stands before ⧹");
  CHECK(judged(R"(s \hide (x) = t \\ s = [x, y : \nat] \\ t = [z : \nat])") == "= between ℙ [y : 𝔸] and ℙ [z : 𝔸]");
  CHECK(judged(R"(s \hide (x) = t \\ s = [x : g])") == "the generic actuals of g are not determined");
  CHECK(judged(R"(\{ s | x = \{1\} \} = t \\ s = [y : \nat])") == "= between 𝔸 and ℙ 𝔸");
  CHECK(judged(R"(\{ s | y = 1 \} = t \\ s = [x : \nat])") == "y is not declared");
  CHECK(judged(R"([s | x > 0] = t \\ s = [x : \power \nat])") == "> between ℙ 𝔸 and 𝔸");
  CHECK(judged(R"((\forall y : \nat @ s) \\ s = [y : \power \nat] \\ t = s)") == "y has the type 𝔸");
  CHECK(judged(R"((s \semi [x : \nat]) = t \\ s = [x' : \power \nat])") == "⨟ joins x' of type ℙ 𝔸 with x of type 𝔸");
  // a part that one pass does not know is no part that agrees with all
  CHECK(
      judged(R"(t \hide (z) = \{\} \\ t = [z : \{(s \hide (x), 1)\}] \\ t = [z : \{(5, 1)\}] \\ s = [x, y : \nat])") ==
      "= between ℙ [z : ℙ [y : 𝔸] × 𝔸] and ℙ [z : 𝔸 × 𝔸]");
}

TEST_CASE("every expression of spec/ gets a type without variables") {
  const Specification spec = read_files(files_in("spec"));
  const Typing typing = check(spec);
  CHECK(typing.types.size() > 1000);
  for (const auto& [node, type] : typing.types) CHECK_FALSE(type.has_variables());
  const Global* alcance = typing.find("interseccion", {"alcance", ""});
  REQUIRE(alcance);
  CHECK(alcance->scheme.type.parts()[0].parts().size() == 2);
}

TEST_CASE("an expression is checked in the scope of a section") {
  const Typing known = check(read_files(files_in("spec")));
  const auto type_in = [&known](const std::string& section, const char* expression) {
    const Term term = parse_unicode(expression);
    const Typing typing = check_term(known, section, term);
    return typing.ok() ? typing.type_of(term)->text() : typing.defects[0].text();
  };
  CHECK(type_in("puntos", "cuadrado") == "ℙ (𝔸 × 𝔸)");
  CHECK(type_in("tipos", "{soy_esfera, soy_cono} ∖ ∅") == "ℙ Tipo");
  CHECK(type_in("tipos", "cuadrado") == "expression:1:1: cuadrado is not declared; expected a declared name");
  CHECK(type_in("escena", "λ Escena; e : elementos • e") ==
        "expression:1:15: elementos is not declared; expected a declared name; did you mean Elemento?");
  CHECK(type_in("tipos", "∅") ==
        "expression:1:1: the generic actuals of ∅ are not determined; expected ∅[…], or a use that gives its type");
}

TEST_CASE("a generic definition is generic in what was inferred, too") {
  const std::string given = "\\begin{zed} [A, B] \\\\ P[X] == \\emptyset \\cup \\{ x : X | x = x \\} \\end{zed}\n";
  CHECK(check(text(given + "\\begin{axdef} a : P[A]; b : P[B] \\where a \\in A \\land b \\in B \\end{axdef}")).ok());
  CHECK_FALSE(check(text(given + "\\begin{axdef} a : P[A]; b : P[B] \\where a = b \\end{axdef}")).ok());
}

TEST_CASE("the whole of spec/ is read and checked: no defect") { CHECK(review(read_files(files_in("spec"))).empty()); }

TEST_CASE("types that double at every step are refused, in little time and space") {
  std::string body = "\\begin{zed}\n  a0 == 1 \\\\\n";
  for (int i = 1; i < 200; ++i) body += fmt::format("  a{} == (a{}, a{}) \\\\\n", i, i - 1, i - 1);
  body += "  z == 1\n\\end{zed}\n";
  const Specification read = text(body);
  REQUIRE(read.ok());
  const Typing typing = check(read);
  REQUIRE_FALSE(typing.ok());
  CHECK(typing.defects[0].what.find("a type of more than") == 0);
}
