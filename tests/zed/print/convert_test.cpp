#include "durero/zed/print/convert.hpp"

#include "durero/zed/types/typecheck.hpp"
#include "support/catch.hpp"
#include "zed/lines.hpp"
#include "zed/syntax/source.hpp"

using namespace durero::zed;
using namespace durero::zed::test;
using Catch::Contains;

namespace {

Specification read_as(const std::string& file, const std::string& text) { return read_sources({{file, text}}); }

std::string written(const std::string& file, const std::string& text, Form to) {
  return converted(text, to, read_as(file, text));
}

/// What stands between the paragraphs. A box begins a line, so a line end may have come before it.
std::vector<std::string> prose(const std::string& text) {
  std::vector<Defect> defects;
  std::vector<std::string> pieces;
  std::size_t at = 0;
  const auto add = [&](std::size_t to) {
    pieces.push_back(text.substr(at, to - at));
    if (!pieces.back().empty() && pieces.back().back() == '\n') pieces.back().pop_back();
  };
  for (const Block& block : cut(text, "", defects)) {
    const auto body = static_cast<std::size_t>(block.body.data() - text.data());
    add(block.unicode ? text.rfind('\n', body - 1) + 1 : text.rfind("\\begin{", body));
    at = body + block.body.size();
    at += block.unicode ? std::string("└").size() : text.find('}', at) + 1 - at;
  }
  add(text.size());
  return pieces;
}

/// Whether the last section has the same paragraphs as that of the other at its end.
bool same_paragraphs_at_end(const Specification& a, const Specification& b) {
  const auto& [left, right] = std::pair(a.sections.back().paragraphs, b.sections.back().paragraphs);
  return left.size() >= right.size() && std::equal(right.rbegin(), right.rend(), left.rbegin());
}

bool same_sections(const Specification& a, const Specification& b) {
  return std::ranges::equal(a.sections, b.sections, [](const Section& left, const Section& right) {
    return left.name == right.name && left.parents == right.parents && left.paragraphs == right.paragraphs;
  });
}

/// All Z texts of the tree that can be read, and no fewer than there should be.
std::vector<std::string> readable() {
  std::vector<std::string> files;
  for (const char* folder : {"tests/zed/corpus/right", "tests/zed/corpus/wrong", "spec", "spec/impresa", "demo"})
    for (const std::string& file : files_in(folder))
      if (read_as(file, contents(file)).ok()) files.push_back(file);
  CHECK(files.size() >= 200);
  return files;
}

/// A text in Unicode that becomes LaTeX with one paragraph, which is returned.
std::string in_latex_of(const std::string& box) { return written("u.utf8", box, Form::latex); }
std::string in_unicode_of(const std::string& box) { return written("l.tex", box, Form::unicode); }

std::string refusal(const std::string& text, Form to) {
  try {
    return written("t", text, to);
  } catch (const ZError& error) {
    return error.in("t").text();
  }
}

}  // namespace

TEST_CASE("every text says the same in Unicode, keeps its prose, and is the same Unicode again after a way to LaTeX") {
  for (const std::string& file : readable()) {
    CAPTURE(file);
    const std::string latex = contents(file), unicode = written(file, latex, Form::unicode);
    CHECK(form_of(latex) == Form::latex);
    REQUIRE(form_of(unicode) == Form::unicode);
    CHECK(same_sections(read_as(file, latex), read_as(file, unicode)));
    CHECK(prose(unicode) == prose(latex));
    const std::string back = written(file, unicode, Form::latex);
    CHECK(same_sections(read_as(file, latex), read_as(file, back)));
    CHECK(prose(back) == prose(latex));
    CHECK(written(file, back, Form::unicode) == unicode);
    CHECK(written(file, unicode, Form::unicode) == unicode);
    CHECK(written(file, latex, Form::latex) == latex);
  }
}

TEST_CASE("the program's own text comes back from Unicode byte for byte") {
  const std::vector<std::string> files = files_in("spec");
  CHECK(files.size() >= 5);
  for (const std::string& file : files) {
    CAPTURE(file);
    const std::string latex = contents(file);
    CHECK(written(file, written(file, latex, Form::unicode), Form::latex) == latex);
  }
}

TEST_CASE("a box is drawn as the standard draws it, with its lines, spaces, labels and comments") {
  const std::string latex =
      "Prose.\n"
      "\\begin{schema}{S}[X]\n  x, y' : \\power X \\\\\n  n : \\nat % a comment\n\\where\n  x \\neq y'  % "
      "S.inv.1\n\\also\n  n = 1 \\lor \\\\\n  \\t1 n = 2\n\\end{schema}\nMore.\n"
      "\\begin{gendef}[X]\n  f : \\power_1 X\n\\end{gendef}\n";
  CHECK(in_unicode_of(latex) ==
        "Prose.\n┌═ S[X]\nx, y′ : ℙ X\nn : ℕ % a comment\n|\nx ≠ y′  % S.inv.1\n\nn = 1 ∨\n  n = 2\n└\nMore.\n"
        "╷═[X]\nf : ℙ₁ X\n└\n");
}

TEST_CASE("blanks stand where a mark-up would join two words, or part them") {
  CHECK(in_latex_of("─\n⊢? ℙX ⊆ ℙℕ ∧ dom f = f a ′ 2\n└\n") ==
        "\\begin{zed}\n  \\vdash? \\power X \\subseteq \\power \\nat \\land \\dom f = f~a~' 2\n\\end{zed}\n");
  CHECK(in_unicode_of("\\begin{zed} \\vdash? 7\\div 2 \\in\\power{\\nat} \\end{zed}") == "─\n⊢? 7 div 2 ∈ ℙ ℕ\n└");
  CHECK(in_latex_of("─\n⊢? (- 1) - 1 = -2\n└") == "\\begin{zed}\n  \\vdash? (\\negate 1) - 1 = \\negate 2\n\\end{zed}");
  CHECK(in_latex_of("─\nx₁ == ΔS′\n└") == "\\begin{zed}\n  x_1 == \\Delta S'\n\\end{zed}");
}

TEST_CASE("the blanks between the sign of a box and a comment are kept") {
  const std::string unicode = "╷  % why\nx : ℕ\n└";
  CHECK(in_latex_of(unicode) == "\\begin{axdef}  % why\n  x : \\nat\n\\end{axdef}");
  CHECK(in_unicode_of(in_latex_of(unicode)) == unicode);
}

TEST_CASE("an iteration keeps its signs apart from the names around") {
  const std::string latex =
      "\\begin{zed}\n  \\vdash? f~^{~n + 1~} = (g)~^{~2~} \\cup (\\_~^{~\\_~})~(f, x^{2})\n\\end{zed}";
  const std::string unicode = "─\n⊢? f ↗ n + 1 ↙ = (g) ↗ 2 ↙ ∪ (_ ↗ _ ↙) (f, x↗2↙)\n└";
  CHECK(in_unicode_of(latex) == unicode);
  CHECK(in_latex_of("─\n⊢? f↗n↙ = f ↗ n ↙\n└") == "\\begin{zed}\n  \\vdash? f^{n} = f~^{~n~}\n\\end{zed}");
  CHECK(in_unicode_of(in_latex_of(unicode)) == unicode);
}

TEST_CASE("directives in the prose hold in Unicode as in LaTeX, and give the commands") {
  const std::string latex = "%%Zchar \\real U+211D\n\\begin{zed}\n  [ \\real, A ]\n\\end{zed}\n";
  const std::string unicode = "%%Zchar \\real U+211D\n─\n[ ℝ, A ]\n└\n";
  CHECK(in_unicode_of(latex) == unicode);
  CHECK(in_latex_of(unicode) == latex);
  const Specification wrong = read_text("%%Zchar \\real\n" + unicode, "u.utf8");
  REQUIRE(wrong.defects.size() == 1);
  CHECK_THAT(wrong.defects[0].text(), Contains("u.utf8:1:1: malformed directive"));
}

TEST_CASE("a text in Unicode may speak of environments, and one in LaTeX of those that are not Z") {
  CHECK(form_of("% \\begin{zed}\n\\begin{document}\n─\n[A]\n└\n") == Form::unicode);
  CHECK(form_of("\\begin{zed} [A] \\end{zed}\n─\n") == Form::latex);
  CHECK(form_of("no Z") == Form::latex);
  CHECK(in_latex_of("% \\begin{zed}\n\\begin{document}\n─\n[A]\n└ rest\n") ==
        "% \\begin{zed}\n\\begin{document}\n\\begin{zed}\n  [A]\n\\end{zed} rest\n");
}

TEST_CASE("what the other mark-up cannot say is refused at its place") {
  CHECK_THAT(refusal("─\nx == \"a-b\"\n└", Form::latex), Contains("t:2:6: \"a-b\" cannot be written in LaTeX mark-up"));
  CHECK_THAT(refusal("─\nx == 0.25\n└", Form::latex), Contains("t:2:6: 0.25 cannot be written in LaTeX mark-up"));
  CHECK_THAT(refusal("─\n[A]\nx == ñ\n└", Form::latex), Contains("t:3:6: ñ cannot be written"));
  CHECK_THAT(refusal("\\begin{zed}\n f == g % why\n 2 \\end{zed}", Form::unicode),
             Contains("t:3:2: 2 cannot be written in Unicode"));
  CHECK_THAT(refusal("\\begin{zed} [A] \\end{zed}\n─ x\n", Form::unicode),
             Contains("prose begins a line as a box of Unicode does"));
  CHECK_THAT(refusal("\\begin{zed} [A] \\end{zed}─", Form::unicode),
             Contains("prose begins a line as a box of Unicode does"));
}

TEST_CASE("Spivey's Z is written in ISO's, in either mark-up") {
  const std::string spivey =
      "\\usepackage{fuzz}\n%%inop \\boxplus 3\n%%prerel \\even\n"
      "\\begin{syntax} T & ::= & a | b \\end{syntax}\n"
      "\\begin{axdef} \\_ \\boxplus \\_ : \\num \\cross \\num \\fun \\num \\\\ \\even \\_ : \\power \\num "
      "\\end{axdef}\n"
      "\\begin{schema}{S} x : \\num; b : \\bag T \\end{schema}\n"
      "\\begin{zed} Init \\defs [ S' | x' = -1 \\boxplus 2 \\land b' = \\empty \\uplus \\lbag a \\rbag ] \\end{zed}\n";
  REQUIRE(read_as("s.tex", spivey).ok());
  CHECK(form_of(spivey) == Form::spivey);
  const std::string unicode = written("s.tex", spivey, Form::unicode);
  CHECK_THAT(unicode,
             Contains("─ section Specification parents standard_toolkit, bag_toolkit └\n"
                      "─ function 30 leftassoc (_ boxplus _) └\n─ relation (even _) └\n─\nT   ::=   a | b\n└"));
  CHECK_THAT(unicode,
             Contains("[ S ′ | x′ = - 1 boxplus 2 ∧\nb′ = ∅ ⊎ ⟦ a ⟧ ]") || Contains("[ S ′ | x′ = - 1 boxplus 2 ∧ b′"));
  const std::string iso = written("s.tex", spivey, Form::latex);
  CHECK(form_of(iso) == Form::latex);
  CHECK_THAT(iso, Contains("\\begin{zsection}"));
  for (const std::string& text : {unicode, iso}) {
    const Specification again = read_as("again", text);
    for (const Defect& defect : again.defects) UNSCOPED_INFO(defect.text() << text);
    REQUIRE(again.ok());
    CHECK(check(again).defects.empty());
    CHECK(same_paragraphs_at_end(again, read_as("s.tex", spivey)));
  }
}

TEST_CASE("what ISO has no place for is refused at its place") {
  const auto refusal = [](const std::string& zed) {
    try {
      return written("s.tex", "\\begin{axdef} x : \\num \\end{axdef}\n\\begin{zed} " + zed + " \\end{zed} \\defs\n",
                     Form::unicode);
    } catch (const ZError& error) {
      return std::to_string(error.place.line) + ": " + error.what_is_wrong;
    }
  };
  CHECK_THAT(refusal("R == \\{ y : \\num | 0 < y \\inrel{succ} x \\}"),
             Contains("\\inrel cannot be written in Unicode"));
}
