// Spivey's Z: by what it is known, and what is read otherwise than in ISO's mark-up.
#include "zed/syntax/spivey.hpp"

#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/print/print.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "durero/zed/types/typecheck.hpp"
#include "support/catch.hpp"

namespace durero::zed {
namespace {

std::string sign_of(const std::string& text) {
  const auto known = spivey_text(text);
  return known ? known->sign + " " + std::to_string(known->place.line) + ":" + std::to_string(known->place.column)
               : "ISO";
}

/// The defects of reading and of types; nothing where there are none.
std::string defects_of(const std::string& text) {
  const Specification read = read_text(text, "s.tex");
  std::string told;
  for (const Defect& defect : read.defects) told += defect.text() + "\n";
  if (read.ok())
    for (const Defect& defect : check(read).defects) told += defect.text() + "\n";
  return told;
}

const std::string fuzz = "\\usepackage{fuzz}\n";

TEST_CASE("a text is Spivey's by its first sign, and ISO's where it has a section header") {
  CHECK(sign_of("x\n  \\usepackage[lucida]{graphicx, fuzz}") == "\\usepackage{fuzz} 2:3");
  CHECK(sign_of("\\documentstyle[fuzz,12pt]{article}") == "\\documentstyle[fuzz] 1:1");
  CHECK(sign_of("\\begin{zed} S \\defs T \\end{zed}") == "\\defs 1:15");
  CHECK(sign_of("\\begin{syntax} T ::= a \\end{syntax}") == "\\begin{syntax} 1:1");
  CHECK(sign_of("%%inop \\foo 3\n") == "%%inop 1:1");
  CHECK(sign_of("%%Zword \\foo foo\n") == "ISO");
  CHECK(sign_of("%\\usepackage{fuzz}\n") == "ISO");
  CHECK(sign_of("10\\% \\usepackage{fuzz}\n") == "\\usepackage{fuzz} 1:6");
  CHECK(sign_of("\\usepackage{czt}\n\\usepackage{fuzz}\n") == "ISO");
  CHECK(sign_of("\\usepackage{oz}\n") == "\\usepackage{oz} 1:1");
  CHECK(sign_of("\\usepackage{oz}\n\\lblot a == 1 \\rblot\n") == "ISO");
  CHECK(sign_of("\\usepackage{fuzz}\n\\lblot a == 1 \\rblot\n") == "\\usepackage{fuzz} 1:1");
  CHECK(sign_of("\\usepackage{oz}\n\\lblot a == 1 \\rblot\nA \\defs B \\lblot\n") == "\\defs 3:3");
  CHECK(sign_of("\\usepackage{fuzz}\n\\begin{zsection} \\SECTION s \\end{zsection}") == "ISO");
  const std::string decorated =
      "\\begin{schema}{A\\_B} x : \\num \\end{schema}\n\\begin{schema}{I} A\\_B' \\end{schema}";
  CHECK(sign_of(decorated) == "ISO");
  CHECK(sign_of(decorated + "\n\\begin{document}") == "A_B' 2:19");
  CHECK(sign_of("\\usepackage{czt} \\defs\n" + decorated + "\n\\begin{document}") == "A_B' 3:19");
  CHECK(sign_of("\\begin{schema}{A} x : \\num \\end{schema}\n\\begin{schema}{I} A~' \\where x' = 0 \\end{schema}") ==
        "ISO");
}

TEST_CASE("a stroke behind a schema's name decorates it, and behind another's is of the name") {
  CHECK(defects_of(fuzz + "\\begin{schema}{S} x, known : \\num \\end{schema}\n"
                          "\\begin{schema}{I} S' \\where x' = 0 \\\\ known' = \\theta S'.x \\end{schema}\n"
                          "\\begin{zed} T \\defs [ S | x > 0 ] \\also U \\defs [ S'; T' | x' = x'' ] \\end{zed}") ==
        "s.tex:4:65: x'' is not declared; expected a declared name, such as x'\n");
}

TEST_CASE("blanks separate words") {
  CHECK(defects_of(fuzz + "\\begin{axdef} f : \\num \\fun \\num; a : \\num \\where f a = 1 2 \\end{axdef}") ==
        "s.tex:2:57: 1 has the type 𝔸; expected a function before its argument\n");
  CHECK(defects_of("\\begin{axdef} f : \\num \\fun \\num; a : \\num \\where f a = 1 2 \\end{axdef}") ==
        "s.tex:1:51: fa is not declared; expected a declared name; did you mean f a (f~a in LaTeX)?\n");
}

TEST_CASE("what Spivey's Z writes is read") {
  CHECK(defects_of(fuzz + R"(
\begin{syntax} OP & ::= & plus | minus \also EXP & ::= & const \ldata \num \rdata \\ & | & binop \ldata OP \cross EXP \rdata. \end{syntax}
\begin{axdef} x, y : \num; s : \power \num; R : \num \rel \num \where
  x = -1 \also y = 3 - -x * -2 \\ s = \empty \cup (1 .. 3) \\ x \inrel{R} y \land R\bsup 2 \esup = R \end{axdef}
\begin{zed} x < y \also \forall n : s @ n > x \\ [A, B] \\ N == \{ n : \num | n > 0 \spot n \} \end{zed}
\begin{schema}{P}[X] p : \power X \end{schema}
\begin{zed} Q \defs P[A] \land [~ b : B ~] \end{zed})") == "");
}

TEST_CASE("directives of fuzz declare operators, and leave a paragraph out with a warning") {
  const std::string text = fuzz + R"(
%%inop \boxplus 3
%%inrel precedes
%%prerel \even
%%postop \half
%%pregen \pairs
%%ingen \onto
%%ignore \strut
%%tame \boxplus
\begin{axdef} \_ \boxplus \_ : \num \cross \num \fun \num; \_ precedes \_ : \num \rel \num; \even \_ : \power \num; \_ \half : \num \fun \num
\where \strut 1 \boxplus 2 * 3 precedes 4 \half \\ \even 2 \end{axdef}
\begin{zed} \pairs X == X \cross X \\ X \onto Y == X \fun Y \\ T == \pairs \num \onto \num \end{zed}
%%unchecked
\begin{zed} nonsense ~ \end{zed}
)";
  CHECK(defects_of(text) == "s.tex:14:1: warning: the paragraph behind this is not read; expected no %%unchecked\n");
  CHECK(defects_of(fuzz + "%%inop \\foo\n\\begin{zed} [A] \\end{zed}") ==
        "s.tex:2:1: an %%inop without a priority; expected one of 1 to 6 behind the words\n");
  CHECK(defects_of(fuzz + "%%inrel\n\\begin{zed} [A] \\end{zed}") ==
        "s.tex:2:1: a directive %%inrel of nothing; expected words behind it\n");
}

TEST_CASE("a line behind %% is hidden from LaTeX alone") {
  const std::string text = fuzz +
                           "%% \\begin{zed} [NAME] \\end{zed}\n%%\n%%% [A]\n\\begin{zed}\n%% A == NAME \\\\\n"
                           "% B == nothing\n%%tame A\nC == A\n\\end{zed}\n";
  CHECK(defects_of(text) == "");
  CHECK(read_text(text, "s.tex").sections.at(0).paragraphs.size() == 3);
}

/// The terms of one definition, as Unicode, in Spivey's Z and in ISO's.
std::pair<std::string, std::string> both_readings(const std::string& term) {
  const auto read = [&term](const std::string& sign) {
    const Specification text = read_text(sign + "\\begin{zed} X == " + term + " \\end{zed}", "s.tex");
    REQUIRE(text.ok());
    return to_unicode(std::get<Definition>(text.sections.back().paragraphs.at(0).form).value);
  };
  return {read(fuzz), read("")};
}

TEST_CASE("operators bind as fuzz binds them") {
  using Readings = std::pair<std::string, std::string>;
  CHECK(both_readings("A \\semi B \\hide (x) \\project C").first == "A ⨟ (B ⧹ (x)) ⨡ C");
  CHECK(both_readings("f~x \\inv") == Readings{"f (x ∼)", "f x ∼"});
  CHECK(both_readings("(f~x) \\inv") == Readings{"f x ∼", "f x ∼"});
  CHECK(both_readings("f~x \\limg S \\rimg").first == both_readings("f~x \\limg S \\rimg").second);
  CHECK(both_readings("A \\land B \\hide (x)") == Readings{"(A ∧ B) ⧹ (x)", "A ∧ B ⧹ (x)"});
  CHECK(both_readings("A \\implies B \\semi C \\lor D") == Readings{"(A ⇒ B) ⨟ (C ∨ D)", "A ⇒ B ⨟ C ∨ D"});
  CHECK(both_readings("A \\pipe B \\project C \\hide (x)").first == "A ⨠ B ⨡ C ⧹ (x)");
  CHECK(both_readings("\\pre A \\semi B").first == "pre A ⨟ B");
  CHECK(both_readings("A \\dres B \\dres R") == Readings{"(A ◁ B) ◁ R", "A ◁ B ◁ R"});
  CHECK(both_readings("\\# f~x") == Readings{"(# f) x", "# f x"});
}

TEST_CASE("words of ISO's operators and keywords are names where a text of Spivey's Z declares them") {
  const std::string text =
      "\\begin{axdef} id, x : \\num; function, if : \\num \\where id = function + if \\end{axdef}\n"
      "\\begin{syntax} S & ::= & seq \\ldata \\num \\rdata | mod \\\\ & | & skip \\end{syntax}\n"
      "\\begin{axdef} s : S; t : \\seq S \\where s = seq~3 \\land s \\neq mod \\land \\id S = \\id S \\end{axdef}\n";
  CHECK(defects_of(fuzz + text) == "");
  CHECK_THAT(defects_of(text.substr(0, text.find("\\begin{syntax}"))), Catch::Contains("s.tex:1:17: unexpected ,"));
  CHECK(defects_of(fuzz + "\\begin{axdef} x, y : \\num \\where x = y mod 2 \\end{axdef}") == "");
  CHECK(spivey_text(fuzz + "\\begin{zed} \\forall s : \\seq X; t : seq X @ s = t \\end{zed}")->names.empty());
  CHECK(spivey_text(fuzz + "prefix', infix , \\_a? : X\n| div\n& partition == 1\nsuffix~::= a")->names ==
        std::set<std::string, std::less<>>{"div", "infix", "partition", "prefix", "suffix"});
}

TEST_CASE("bags have their values") {
  const Specification read = read_text(fuzz +
                                           "\\begin{axdef} b, c : \\bag \\num \\where b = \\lbag 3, 4, 3 \\rbag \\\\ c "
                                           "= b \\uplus items \\langle 4 \\rangle "
                                           "\\end{axdef}",
                                       "s.tex");
  REQUIRE(read.ok());
  const Typing typing = check(read);
  CHECK(typing.defects.empty());
  REQUIRE(read.sections.size() == 2);
  CHECK(is_built_in(read.sections.front()));
  CHECK_FALSE(is_built_in(read.sections.back()));
}

TEST_CASE("the text says which it is") {
  CHECK(read_text(fuzz + "\\begin{zed} [A] \\end{zed}", "s.tex").spivey ==
        std::map<std::string, std::string>{{"s.tex", "\\usepackage{fuzz} at line 1"}});
  CHECK(read_text("\\begin{zed} [A] \\end{zed}", "s.tex").spivey.empty());
}

}  // namespace
}  // namespace durero::zed
