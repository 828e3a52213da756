// Conversion to and from Spivey's Z: what was written is read again by its rules, and is the same.
#include <algorithm>
#include <cstdlib>
#include <random>
#include <set>

#include "durero/zed/print/convert.hpp"
#include "durero/zed/types/typecheck.hpp"
#include "support/catch.hpp"
#include "zed/lines.hpp"
#include "zed/syntax/bag_toolkit.hpp"

namespace durero::zed {
namespace {

using zed::test::contents;
using zed::test::files_in;

Specification read_named(const std::string& text) { return read_sources({{"s.tex", text}}); }

std::string spivey_of(const std::string& text) { return converted(text, Form::spivey, read_named(text)); }
std::string iso_of(const std::string& text) { return converted(text, Form::latex, read_named(text)); }

/// The paragraphs of the last section, of a text without a defect.
std::vector<Paragraph> paragraphs_of(const std::string& text) {
  const Specification read = read_named(text);
  for (const Defect& defect : read.defects) UNSCOPED_INFO(defect.text());
  REQUIRE(read.ok());
  return read.sections.back().paragraphs;
}

const std::string header = "\\begin{zsection} \\SECTION s \\parents standard\\_toolkit \\end{zsection}\n";

/// Spivey's text of a `zed` paragraph of ISO's, without the comment that its header becomes and the sign.
std::string zed_in_spivey(const std::string& zed) {
  static const std::string before = "% section s parents standard_toolkit\n\n";
  const std::string text = spivey_of(header + "\\begin{zed}\n  " + zed + "\n\\end{zed}");
  REQUIRE(form_of(text) == Form::spivey);
  return text.substr(text.find(before) + before.size());
}

std::string refused_in_spivey(const std::string& zed) {
  try {
    return spivey_of(header + "\\begin{zed} " + zed + " \\end{zed}");
  } catch (const ZError& error) {
    return std::to_string(error.place.line) + ":" + std::to_string(error.place.column) + ": " + error.what_is_wrong;
  }
}

TEST_CASE("texts of ISO are the same in Spivey's Z, and back, or are refused at their place") {
  int written = 0;
  for (const std::string& file : files_in("tests/zed/corpus/right")) {
    CAPTURE(file);
    const std::string iso = contents(file);
    std::string spivey;
    try {
      spivey = spivey_of(iso);
    } catch (const ZError& error) {
      CHECK(error.place.line > 0);
      continue;
    }
    ++written;
    CHECK(form_of(spivey) == Form::spivey);
    CHECK(paragraphs_of(spivey) == paragraphs_of(iso));
    CHECK(check(read_named(spivey)).defects.size() == check(read_named(iso)).defects.size());
    const std::string back = iso_of(spivey);
    CHECK(form_of(back) == Form::latex);
    CHECK(paragraphs_of(back) == paragraphs_of(iso));
  }
  CHECK(written >= 90);
}

TEST_CASE("schemas are defined by \\defs and decorated by a stroke, and operators are directives") {
  CHECK(spivey_of(header + R"(%%Zword \boxplus boxplus
\begin{zed}
  \function 30 \leftassoc (\_ \boxplus \_) \\ % adds
  \relation (even~\_)
\end{zed}
\begin{schema}{S}
  x : \num
\end{schema}
\begin{zed}
  T == [ S~' ; S | x' = \negate x - \negate 1 ] \\
  U == T \\
  n == \{ x : \num @ x \}
\end{zed}
)") == R"(% section s parents standard_toolkit

%%Zword \boxplus boxplus
%%inop \boxplus 3
% adds
%%prerel even

\begin{schema}{S}
  x : \num
\end{schema}
\begin{zed}
  T \defs [ S' ; S | x' = - x - - 1 ] \\
  U \defs T \\
  n == \{ x : \num @ x \}
\end{zed}
)");
}

TEST_CASE("a quantifier that is an operand has parentheses, and a line end in brackets a sign") {
  CHECK(zed_in_spivey("A == [ x : \\num | x > 0 \\land \\exists y, z : \\num @ y > x ]") ==
        "\\begin{zed}\n  A \\defs [ x : \\num | x > 0 \\land (\\exists y, z : \\num @ y > x) ]\n\\end{zed}");
  CHECK(zed_in_spivey(
            "f == \\lambda x : \\num @ x \\\\ g == (\\lambda x : \\num @ x) \\\\ h == (\\mu x : \\num @ x, 2)") ==
        "\\begin{zed}\n  f == (\\lambda x : \\num @ x) \\\\\n  g == (\\lambda x : \\num @ x) \\\\\n"
        "  h == ((\\mu x : \\num @ x), 2)\n\\end{zed}");
  CHECK(zed_in_spivey("\\vdash? \\lambda x : \\num | x = 1 @ x + 1 = \\{ (1, 2) \\}") ==
        "\\begin{theorem}{}\n  \\vdash? (\\lambda x : \\num | x = 1 @ x + 1) = \\{ (1, 2) \\}\n\\end{theorem}");
  CHECK(zed_in_spivey("A == \\{ x : \\num | x > 0 \\\\ (x < 3 \\\\ x \\neq 2) @ x + \\\\ 1 \\}") ==
        "\\begin{zed}\n  A == \\{ x : \\num | x > 0; \\\\\n  (x < 3 \\land \\\\\n  x \\neq 2) @ x + \\\\\n  1 "
        "\\}\n\\end{zed}");
  CHECK(zed_in_spivey("A == 1 \\\\ \\t1 + 2") == "\\begin{zed}\n  A == 1\n  + 2\n\\end{zed}");
}

TEST_CASE("a conjecture is a theorem, and the rest of its block stays one") {
  CHECK(zed_in_spivey("[A] \\\\ B == A \\\\ % why\n \\vdash? A = B % B.conj.1\n") ==
        "\\begin{zed}\n  [A] \\\\\n  B == A % why\n\\end{zed}\n"
        "\\begin{theorem}{}\n  \\vdash? A = B % B.conj.1\n\\end{theorem}");
}

/// The paragraphs of a `zed` in Spivey's Z, written in ISO's LaTeX or in Unicode.
std::string zed_in_iso(const std::string& zed, Form to = Form::latex) {
  const std::string text = "\\usepackage{fuzz}\n\\begin{zed}\n" + zed + "\n\\end{zed}\n";
  const std::string written = converted(text, to, read_named(text));
  CHECK(paragraphs_of(written) == paragraphs_of(text));
  const std::string box = to == Form::latex ? "\\begin{zed}\n" : "─\n";
  const std::size_t from = written.find_first_not_of(' ', written.rfind(box) + box.size());
  return written.substr(from, written.rfind('\n', written.size() - 2) - from);
}

TEST_CASE("what binds otherwise in ISO's Z has parentheses there, and nothing else has") {
  CHECK(zed_in_iso("A == s \\cup t \\dres f \\rres u") == "A == s \\cup t \\dres f \\rres u");
  CHECK(zed_in_iso("A == f \\rres s \\dres g") == "A == (f \\rres s) \\dres g");
  CHECK(zed_in_iso("A == f \\rres (s \\dres g)") == "A == f \\rres (s \\dres g)");
  CHECK(zed_in_iso("A == f \\comp g \\oplus h \\rres u") == "A == f \\comp g \\oplus h \\rres u");
  CHECK(zed_in_iso("A == \\# s i + 1") == "A == (\\# s)~i + 1");
  CHECK(zed_in_iso("S \\defs A \\land B \\semi C \\hide (x)") == "S == (A \\land B) \\semi (C \\hide (x))");
  CHECK(zed_in_iso("S \\defs A \\land B \\hide (x)", Form::unicode) == "S == (A ∧ B) ⧹ (x)");
  CHECK(zed_in_iso("S \\defs A \\land B") == "S == A \\land B");
}

TEST_CASE("a membership in a named relation is one of a pair in ISO's Z") {
  CHECK(zed_in_iso("A == \\{ x, y : \\num | x \\inrel{R} y \\}") == "A == \\{ x, y : \\num | (x, y) \\in R \\}");
  CHECK(zed_in_iso("A == \\{ x, y : \\num | x + 1 \\inrel{R} y \\land y = 2 \\}", Form::unicode) ==
        "A == { x, y : ℤ | (x + 1, y) ∈ R ∧ y = 2 }");
  CHECK(zed_in_iso("A == \\{ x : \\num | x \\inrel{R} a \\cup f \\dres s \\}") ==
        "A == \\{ x : \\num | (x, a \\cup (f \\dres s)) \\in R \\}");
}

/// A term of random infix operators of Spivey's Z, some operands of which stand in parentheses.
std::string random_expression(std::mt19937_64& random, int depth) {
  static const std::vector<std::string> signs = {"\\mapsto", "\\upto", "+",       "-",      "\\cup",  "\\setminus",
                                                 "\\cat",    "*",      "\\cap",   "\\comp", "\\circ", "\\filter",
                                                 "\\oplus",  "\\dres", "\\ndres", "\\rres", "\\nrres"};
  static const std::vector<std::string> names = {"f", "g", "s", "t", "\\# s", "\\dom f", "f x"};
  if (depth == 0) return names[random() % names.size()];
  const std::string left = random_expression(random, static_cast<int>(random() % static_cast<unsigned>(depth))),
                    right = random_expression(random, static_cast<int>(random() % static_cast<unsigned>(depth)));
  const std::string all = left + " " + signs[random() % signs.size()] + " " + right;
  return random() % 4 == 0 ? "(" + all + ")" : all;
}

/// A term of random schema operators, without quantifiers.
std::string random_schema(std::mt19937_64& random, int depth) {
  static const std::vector<std::string> signs = {"\\land", "\\lor",  "\\implies", "\\iff",
                                                 "\\semi", "\\pipe", "\\project"};
  if (depth == 0) return std::string(1, static_cast<char>('A' + random() % 4));
  const std::string left = random_schema(random, static_cast<int>(random() % static_cast<unsigned>(depth)));
  switch (random() % 4) {
    case 0:
      return (random() % 2 == 0 ? "\\pre " : "\\lnot ") + left;
    case 1:
      return left + " \\hide (x)";
    default:
      return left + " " + signs[random() % signs.size()] + " " +
             random_schema(random, static_cast<int>(random() % static_cast<unsigned>(depth)));
  }
}

TEST_CASE("a converted text reads back as the same tree, whatever operators stand together") {
  const char* const given = std::getenv("DURERO_SEED");
  const std::uint64_t seed = given ? std::stoull(given) : std::random_device()();
  INFO("DURERO_SEED=" << seed);
  std::mt19937_64 random(seed);
  for (int i = 0; i < 300; ++i) {
    const std::string zed =
        i % 2 == 0 ? "A == " + random_expression(random, 5) : "S \\defs " + random_schema(random, 5);
    CAPTURE(zed);
    CHECK_NOTHROW(zed_in_iso(zed, i % 4 < 2 ? Form::latex : Form::unicode));
  }
}

TEST_CASE("names of the toolkit, iterations and bags have Spivey's commands") {
  CHECK(zed_in_spivey("R == succ~^{~2~} \\cup succ \\limg \\{max~A, 1 \\upto 2\\} \\rimg") ==
        "\\begin{zed}\n  R == succ \\bsup 2 \\esup \\cup succ \\limg \\{max~A, 1 \\upto 2\\} \\rimg\n\\end{zed}");
  const std::string bags =
      "\\usepackage{fuzz}\n\\begin{axdef} b : \\bag \\num \\where b = \\lbag 1 \\rbag \\uplus b \\end{axdef}\n";
  const std::string iso = iso_of(bags);
  CHECK(paragraphs_of(spivey_of(iso)) == paragraphs_of(bags));
  CHECK_THAT(spivey_of(iso), Catch::Contains("b = \\lbag 1 \\rbag \\uplus b"));
}

TEST_CASE("an operator's own character is kept by its directive") {
  const std::string text = "%%Zchar \\boxx U+229E\n" + header +
                           "\\begin{zed} \\function 40 \\leftassoc (\\_ \\boxx \\_) \\end{zed}\n"
                           "\\begin{axdef} \\_ \\boxx \\_ : \\num \\cross \\num \\fun \\num \\end{axdef}\n";
  const std::string spivey = spivey_of(text);
  CHECK_THAT(spivey, Catch::Contains("%%inop \\boxx 4\n"));
  CHECK(paragraphs_of(spivey) == paragraphs_of(text));
}

TEST_CASE("what Spivey's Z has no form for is refused at its place") {
  CHECK(refused_in_spivey("A == 𝔸") == "2:18: the character 𝔸 means nothing here");
  CHECK(refused_in_spivey("A == \\arithmos") == "2:18: 𝔸 cannot be written in Spivey's Z");
  CHECK(refused_in_spivey("A == (1, 2).1") == "2:18: .1 of a tuple cannot be written in Spivey's Z");
  CHECK(refused_in_spivey("A == \\lblot x == 1 \\rblot") == "2:18: a binding ⦉ … ⦊ cannot be written in Spivey's Z");
  CHECK(refused_in_spivey("A == \\power [ x : \\num ]") ==
        "2:25: a schema within an expression cannot be written in Spivey's Z");
  CHECK(refused_in_spivey("A == [ x : \\num ] \\\\ B == [ A ; y == 1 ]") ==
        "2:45: a declaration by == cannot be written in Spivey's Z");
  CHECK(refused_in_spivey("A ::= a | b \\ldata B \\rdata & B ::= c \\ldata A \\rdata") ==
        "2:49: & between free types cannot be written in Spivey's Z");
  CHECK(refused_in_spivey("\\function 35 \\leftassoc (\\_ ~p~ \\_)") ==
        "2:13: this operator cannot be written in Spivey's Z");
  CHECK(refused_in_spivey("\\relation (\\_ ~p~ \\_ ~q~ \\_)") == "2:13: this operator cannot be written in Spivey's Z");
  CHECK(refused_in_spivey("\\phi == 1 \\\\ \\phi x == 2") == "2:26: the name ϕx cannot be written in Spivey's Z");
  const auto refused = [](const std::string& text) {
    try {
      return spivey_of(text);
    } catch (const ZError& error) {
      return std::to_string(error.place.line) + ": " + error.what_is_wrong;
    }
  };
  CHECK(refused(header + "\\begin{zsection} \\SECTION t \\parents standard\\_toolkit \\end{zsection}") ==
        "2: a second section cannot be written in Spivey's Z");
  CHECK(refused("\\begin{zsection} \\SECTION t \\parents set\\_toolkit \\end{zsection}") ==
        "1: a section of these parents cannot be written in Spivey's Z");
  CHECK(refused(header + "\\begin{schema}{S} \\where 1 = 1 \\end{schema}") ==
        "2: a schema text without a declaration cannot be written in Spivey's Z");
}

TEST_CASE("what fuzz cannot take is refused, or written otherwise") {
  const std::string template_of = "\\generic 5 \\rightassoc (\\_ ~onto~ \\_) \\\\ ";
  CHECK(refused_in_spivey(template_of + "\\_ ~onto~ \\_ [X, Y] == X \\rel Y") ==
        "2:54: a definition of an operator by _ cannot be written in Spivey's Z");
  CHECK_THAT(zed_in_spivey(template_of + "X ~onto~ Y == X \\rel Y"), Catch::Contains("X~ onto~ Y == X \\rel Y"));
  CHECK(refused_in_spivey("A == (\\# \\_)[B]") == "2:19: the function (# _) cannot be written in Spivey's Z");
  CHECK(refused_in_spivey("A == (\\negate \\_)") == "2:19: the function (- _) cannot be written in Spivey's Z");
  CHECK(zed_in_spivey("A == \\# B + \\negate 1") == "\\begin{zed}\n  A == \\# B + - 1\n\\end{zed}");
  CHECK_THAT(spivey_of("┌ S\n  x : ℕ\n|\n  x > 1\n└\n"),
             Catch::Contains("\\begin{schema}{S}\n  x : \\nat\n\\where\n  \\t1 x > 1\n\\end{schema}"));
  CHECK_THROWS_WITH(spivey_of(header), Catch::Contains("a section without a paragraph cannot be written"));
  CHECK(refused_in_spivey("S == [ x, S : \\num ]") ==
        "2:23: the name S of a schema for another cannot be written in Spivey's Z");
}

TEST_CASE("a name that Spivey's Z has for bags is refused where a text declares it") {
  const Typing typing = check(read_named("\\begin{zed} A == \\lbag 1 \\rbag \\end{zed}"));
  std::set<std::string> declared;
  for (const auto& [name, global] : typing.scopes.at("bag_toolkit")) declared.insert(name.text());
  CHECK(declared == std::set<std::string>(bag_names.begin(), bag_names.end()));
  const auto refusal = [](const std::string& name) {
    return name + ", which Spivey's toolkit declares for bags, cannot be written in Spivey's Z";
  };
  CHECK(refused_in_spivey("[ A, count ]") == "2:18: " + refusal("count"));
  CHECK(refused_in_spivey("items == 1") == "2:13: " + refusal("items"));
  CHECK(refused_in_spivey("A ::= a | count") == "2:23: " + refusal("count"));
  CHECK(refused_in_spivey("count ::= a") == "2:13: " + refusal("count"));
  CHECK(zed_in_spivey("a == \\{ count : \\num @ count + 1 \\}") ==
        "\\begin{zed}\n  a == \\{ count : \\num @ count + 1 \\}\n\\end{zed}");  // a name of its own there
  CHECK_THROWS_WITH(spivey_of(header + "\\begin{axdef} a, items : \\num \\end{axdef}"),
                    Catch::Contains(refusal("items")));
  CHECK_THROWS_WITH(spivey_of(header + "\\begin{schema}{count} a : \\num \\end{schema}"),
                    Catch::Contains(refusal("count")));
  CHECK_THROWS_WITH(
      spivey_of(header +
                "%%Zinchar \\uplus U+228E\n\\begin{zed} \\function 30 \\leftassoc (\\_ \\uplus \\_) \\end{zed}\n"
                "\\begin{axdef} \\_ \\uplus \\_ : \\num \\cross \\num \\fun \\num \\end{axdef}"),
      Catch::Contains(refusal("_ ⊎ _")));
}

TEST_CASE("what binds otherwise in Spivey's Z is refused, and not changed") {
  // ISO: (f 1)∼, and S ∧ (S ⧹ (x)); Spivey: f (1∼), and (S ∧ S) ⧹ (x).
  CHECK(refused_in_spivey("A == f~1 \\inv") == "2:13: this paragraph would be another in Spivey's Z");
  CHECK(zed_in_spivey("A == (f~1) \\inv \\\\ B == f \\inv") ==
        "\\begin{zed}\n  A == (f~1) \\inv \\\\\n  B == f \\inv\n\\end{zed}");
  CHECK(refused_in_spivey("S == [ x : \\num ] \\\\ B == S \\land S \\hide (x)") ==
        "2:34: this paragraph would be another in Spivey's Z");
}

TEST_CASE("a predicate by itself is a box without declarations in ISO's mark-up, and comes back") {
  const std::string spivey =
      "\\usepackage{fuzz}\n\\begin{axdef}\n  x : \\num\n\\end{axdef}\n\\begin{zed}\n  x > 3 \\\\\n  [A]\n\\end{zed}\n";
  const std::string unicode = converted(spivey, Form::unicode, read_named(spivey));
  CHECK(unicode == "\\usepackage{fuzz}\n╷\nx : ℤ\n└\n╷\n|\nx > 3\n└\n─\n[A]\n└\n");
  CHECK(paragraphs_of(unicode) == paragraphs_of(spivey));
  const std::string iso = iso_of(spivey);
  CHECK_THAT(iso, Catch::Contains("\\SECTION Specification \\parents standard\\_toolkit") &&
                      Catch::Contains("\\begin{axdef}\n\\where\n  x > 3\n\\end{axdef}\n\\begin{zed}\n  [A]"));
  for (const std::string& text : {unicode, iso}) {
    const std::string back = converted(text, Form::spivey, read_named(text));
    CHECK(paragraphs_of(back) == paragraphs_of(spivey));
    CHECK_THAT(back, Catch::Contains("\\begin{zed}\n  x > 3\n\\end{zed}"));
  }
}

TEST_CASE("Spivey's Z stays as it is") {
  const std::string text = "\\begin{zed} S \\defs   [ x:\\nat ]. \\end{zed}";
  CHECK(form_of(text) == Form::spivey);
  CHECK(spivey_of(text) == text);
}

}  // namespace
}  // namespace durero::zed
