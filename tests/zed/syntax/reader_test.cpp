#include "durero/zed/syntax/reader.hpp"

#include <fmt/core.h>

#include <fstream>
#include <map>

#include "support/catch.hpp"
#include "support/tree.hpp"

using namespace durero::zed;

namespace {

std::vector<std::pair<std::string, Place>> labels_of(const Section& section) {
  std::vector<std::pair<std::string, Place>> labels;
  const auto add = [&labels](const SchemaText& text) {
    for (const Predicate& predicate : text.predicates)
      if (!predicate.label.empty()) labels.emplace_back(predicate.label, predicate.place);
  };
  for (const Paragraph& paragraph : section.paragraphs) {
    if (const auto* box = std::get_if<Schema>(&paragraph.form)) add(box->text);
    if (const auto* box = std::get_if<Axiomatic>(&paragraph.form)) add(box->text);
    const auto* definition = std::get_if<Definition>(&paragraph.form);
    if (definition && !definition->label.empty()) labels.emplace_back(definition->label, paragraph.place);
  }
  return labels;
}

}  // namespace

TEST_CASE("the Z text of spec/ is read without a defect") {
  std::vector<std::string> files;
  for (const char* stem : {"tipos", "escena", "operaciones", "puntos", "interseccion"})
    files.push_back(fmt::format("{}/spec/{}.tex", durero::test::source_dir(), stem));
  const Specification spec = read_files(files);
  for (const Defect& defect : spec.defects) UNSCOPED_INFO(defect.text());
  CHECK(spec.ok());
  CHECK(spec.sections.size() == 5);
}

TEST_CASE("each label of spec/ is that of one conjunct or definition, which ends on its line") {
  std::size_t labels = 0, lines = 0;
  for (const char* stem : {"tipos", "escena", "operaciones", "puntos", "interseccion"}) {
    const std::string file = fmt::format("{}/spec/{}.tex", durero::test::source_dir(), stem);
    std::ifstream in(file);
    std::map<std::string, unsigned> where;
    std::string text;
    for (unsigned line = 1; std::getline(in, text); ++line) {
      const std::size_t comment = text.rfind("% ");
      if (comment == text.npos) continue;
      const std::string label = text.substr(comment + 2);
      for (const char* kind : {".pre.", ".post.", ".inv.", ".def.", ".axiom."})
        if (label.find(kind) != label.npos && label.find(' ') == label.npos) where[label] = line;
    }
    lines += where.size();
    const Specification spec = read_files({file});
    unsigned before = 0;  // the line of the label before, which this predicate begins behind
    for (const auto& [label, place] : labels_of(*spec.find(stem))) {
      CAPTURE(label);
      CHECK(place.line > before);
      CHECK(place.line <= where.at(label));
      before = where.at(label);
      ++labels;
    }
  }
  CHECK(labels == lines);
  CHECK(labels > 100);
}

TEST_CASE("a cycle of parents is said to be one, and what is unknown or comes too late is told apart") {
  const auto section = [](const std::string& name, const std::string& parents) {
    return "\\begin{zsection}\n\\SECTION " + name + " \\parents " + parents + "\n\\end{zsection}\n";
  };
  const auto said = [](const std::map<std::string, std::string>& texts) {
    const Specification spec = read_texts(texts);
    return spec.defects.empty() ? std::string() : spec.defects[0].text();
  };
  using Catch::Matchers::Contains;
  CHECK_THAT(said({{"a.tex", section("a", "b")}, {"b.tex", section("b", "a")}}),
             Contains("the parents go in a cycle, back to a"));
  CHECK_THAT(said({{"a.tex", section("a", "a")}}), Contains("the parents go in a cycle, back to a"));
  CHECK_THAT(said({{"a.tex", section("a", "b") + section("b", "prelude")}}),
             Contains("the parent b stands behind its child"));
  CHECK_THAT(said({{"a.tex", section("a", "nowhere")}}), Contains("unknown parent nowhere"));
  CHECK(said({{"a.tex", section("a", "b, c")}, {"b.tex", section("b", "c")}, {"c.tex", section("c", "prelude")}}) ==
        "");
}

TEST_CASE("texts in memory have their parents among themselves, sources of files beside them too") {
  const std::string beside = durero::test::source_dir() + "/spec/child.tex";
  const std::string child = "\\begin{zsection}\n\\SECTION child \\parents tipos\n\\end{zsection}\n";
  CHECK(read_sources({{beside, child}}).ok());
  CHECK_FALSE(read_texts({{beside, child}}).ok());
}

TEST_CASE("a file in Unicode is read as one in LaTeX is, with its places") {
  const std::string unicode =
      "Prose.\n─ section mia parents standard_toolkit\n└\n─\n[A, B]\nT ::= a | b⟪A⟫\n└\n┌ S[X]\nx : ℙ X\n├─\nx ≠ ∅  % "
      "S.inv.1\n└\n╷\nc : ℕ\n|\nc > 0\n└\n═[X]\nf : ℙ X\n└\n┌─ Q\n│ y : ℕ\n├──\n│ y ≠ 1\n│ y ≠ 2\n└──\n";
  const std::string latex =
      "\\begin{zsection} \\SECTION mia \\parents standard\\_toolkit \\end{zsection}\\begin{zed} [A, B] \\\\ T ::= a "
      "| b \\ldata A \\rdata \\end{zed}\\begin{schema}{S}[X] x : \\power X \\where x \\neq \\emptyset % S.inv.1\n"
      "\\end{schema}\\begin{axdef} c : \\nat \\where c > 0 \\end{axdef}\\begin{gendef}[X] f : \\power X "
      "\\end{gendef}\\begin{schema}{Q} y : \\nat \\where y \\neq 1 \\\\ y \\neq 2 \\end{schema}";
  const Specification read = read_text(unicode, "u.utf8"), other = read_text(latex, "l.tex");
  REQUIRE(read.ok());
  REQUIRE(read.sections.size() == 1);
  REQUIRE(other.ok());
  CHECK(read.sections[0].name == "mia");
  CHECK(read.sections[0].paragraphs == other.sections[0].paragraphs);
  CHECK(read.sections[0].paragraphs.size() == 6);
  CHECK(read.sections[0].paragraphs[2].place == Place{8, 3});
  const Specification wrong = read_text("─\nx == 1 +\n└\n\n┌ S\n│ x : ℕ\n", "u.utf8");
  REQUIRE(wrong.defects.size() == 2);
  CHECK(wrong.defects[0].text().starts_with("u.utf8:2:"));
  CHECK(wrong.defects[1].text() == "u.utf8:5:1: the paragraph does not end; expected └, the end of its box");
}

TEST_CASE("a template holds in all of its section and in its children, and nowhere else") {
  const std::string section = "\\begin{zsection} \\SECTION a \\parents standard\\_toolkit \\end{zsection}\n",
                    child = "\\begin{zsection} \\SECTION b \\parents a \\end{zsection}\n",
                    other = "\\begin{zsection} \\SECTION c \\parents standard\\_toolkit \\end{zsection}\n",
                    declared = "\\begin{axdef} \\_ ~below~ \\_ : \\num \\rel \\num \\end{axdef}\n",
                    made = "\\begin{zed} \\relation (\\_ ~below~ \\_) \\end{zed}\n",
                    used = "\\begin{zed} \\vdash? 1~below~2 \\end{zed}\n";
  const Specification inherited = read_text(section + declared + used + made + child + used, "t.tex");
  REQUIRE(inherited.ok());
  CHECK(inherited.operators.at("b").size() == 1);
  const Specification apart = read_text(section + declared + made + other + used, "t.tex");
  REQUIRE(apart.ok());  // there it is a name to which 1 is applied
  CHECK(apart.operators.at("c").empty());
  CHECK(apart.operators.at("a").size() == 1);
}

TEST_CASE("a conjecture that stands in a theorem is read, and prose in one is none") {
  const auto conjectures = [](const std::string& theorem) {
    const auto read =
        read_text("\\begin{zed} [A] \\end{zed}\n\\begin{theorem}" + theorem + "\\end{theorem}\n", "t.tex");
    std::string told = std::to_string(read.sections.at(0).paragraphs.size() - 1);
    for (const Defect& defect : read.defects) told += " " + defect.text();
    return told;
  };
  CHECK(conjectures("{T} \\vdash? 1 = 2 ") == "1");
  CHECK(conjectures("{T}[X] \\vdash? \\emptyset[X] = \\emptyset ") == "1");
  CHECK(conjectures(" \\vdash? 1 = 2 ") == "1");
  CHECK(conjectures("{T} \\vdash? 1 = ") ==
        "0 t.tex:2:31: the text ends too early; expected an expression or a predicate");
  CHECK(conjectures(" Of prose. ") == "0");
  CHECK(conjectures(" Prose, then \\vdash? 1 = 2 ") ==
        "0 t.tex:2:1: warning: a theorem is not read, and its conjecture is not tried; expected \\begin{theorem}{NAME} "
        "\\vdash? … \\end{theorem}");
}

TEST_CASE("a paragraph of Unicode may stand on one line, and others behind it") {
  const auto read = read_text(
      "─ [ A ] └\nprose └\n─ [B] └── ─ section_ == {1} └ prose\n┌ S x : ℕ | x > 3 % └\n│ x < 5 └\n", "u.zed8");
  CHECK(read.defects.empty());
  REQUIRE(read.sections.size() == 1);
  CHECK(read.sections[0].paragraphs.size() == 4);
  const auto open = read_text("─ [ A ]\n─ [B] └\n", "u.zed8");
  REQUIRE(open.defects.size() == 1);
  CHECK(open.defects[0].text() == "u.zed8:1:1: the paragraph does not end; expected └, the end of its box");
}

TEST_CASE("two points are an interval in either mark-up") {
  for (const char* text : {"\\begin{zed} A == 1 .. 5 \\end{zed}", "\\begin{zed} A == 1..5 \\end{zed}",
                           "\\begin{zed} A == 1 \\upto 5 \\end{zed}", "─ A == 1..5 └\n"})
    CHECK(read_text(text, "t").defects.empty());
}

TEST_CASE("the name of an operator begins a line") {
  const Specification read = read_text(
      "\\begin{zed} \\function 30 \\leftassoc (\\_ ~p~ \\_) \\\\ \\function 30 \\leftassoc (\\_ ~q~ \\_) \\end{zed}\n"
      "\\begin{zed} \\varg p \\varg == 1 \\\\ \\varg q \\varg == 2 \\end{zed}",
      "s.tex");
  CHECK(read.ok());
  REQUIRE(read.sections.size() == 1);
  CHECK(read.sections[0].paragraphs.size() == 2);
}

TEST_CASE("operators of one precedence associate to one side in all that a section sees") {
  const auto section = [](const std::string& name, const std::string& parents, const std::string& templates) {
    return "\\begin{zsection} \\SECTION " + name + " \\parents " + parents + " \\end{zsection}\n" +
           (templates.empty() ? "" : "\\begin{zed} " + templates + " \\end{zed}\n");
  };
  const std::string left = "\\function 50 \\leftassoc (\\_ ~l~ \\_)",
                    right = "\\function 50 \\rightassoc (\\_ ~r~ \\_)";
  const auto said = [](const std::string& text) {
    const Specification read = read_text(text, "s.tex");
    return read.ok() ? std::string() : read.defects.at(0).text();
  };
  CHECK(said(section("a", "prelude", left) + section("b", "prelude", right)).empty());
  CHECK(said(section("a", "prelude", left) + section("b", "prelude", right) + section("c", "a, b", "")) ==
        "s.tex:5:17: _ r _ and _ l _, of precedence 50, associate to different sides; expected one side, or another "
        "precedence");
  CHECK(said(section("a", "prelude", left + " \\\\ " + right)).starts_with("s.tex:2:"));
  CHECK(said(section("a", "number\\_toolkit", right)).empty());  // ⊕ is of relation_toolkit
  CHECK(said(section("a", "relation\\_toolkit", "") + section("b", "a", right)).find("_⊕_") != std::string::npos);
  CHECK(said(section("a", "sequence\\_toolkit", right)) ==
        "s.tex:2:13: _ r _ and _⊕_, of precedence 50, associate to different sides; expected one side, or another "
        "precedence");
  CHECK(said(section("a", "standard\\_toolkit", "") + section("b", "a", right)).starts_with("s.tex:3:"));
  CHECK(said(section("a", "set\\_toolkit", right)).empty());  // ⊕ is of another part of the toolkit
  CHECK(said(section("a", "standard\\_toolkit", "\\relation (\\_ ~r~ \\_) \\\\ \\function (~p~ \\_)")).empty());
}

TEST_CASE("a file in UTF-16 is named so") {
  for (const char* mark : {"\xFF\xFE", "\xFE\xFF"}) {
    const auto read = read_text(mark + std::string("x"), "u");
    REQUIRE(read.defects.size() == 1);
    CHECK(read.defects[0].text() == "u:1:1: the file is in UTF-16; expected UTF-8");
  }
}

TEST_CASE("an operand that is joined to an operator's word is warned of, with its right spelling") {
  const auto warned = [](const std::string& templates) {
    std::string said;
    for (const Defect& warning : read_text(templates, "t").warnings) said += warning.text() + "\n";
    return said;
  };
  CHECK(warned("\\begin{zed}\n  \\relation (\\_ divides \\_)\n\\end{zed}") ==
        "t:2:17: warning: the _ in divides_ is a letter of this operator's word, and no operand; expected ~ before an "
        "operand, as LaTeX joins what blanks separate: divides~\\_\n");
  CHECK_THAT(warned("\\begin{zed}\n  \\function (low \\_ high)\n\\end{zed}"), Catch::Matchers::Contains("low~\\_"));
  CHECK_THAT(warned("─\nrelation (_ divides_)\n└\n"),
             Catch::Matchers::Contains("a blank before an operand: divides _"));
  CHECK(warned("\\begin{zed}\n  \\relation (\\_ is\\_in~\\_)\n\\end{zed}").empty());
  CHECK(warned("─\nrelation (_ is_in _)\n└\n").empty());
}

TEST_CASE("sources are read in their order, each from what is given") {
  const auto text = [](const std::string& name) {
    return "\\begin{zsection}\n\\SECTION " + name + "\n\\end{zsection}\n\\begin{zed}[" + name + "x]\\end{zed}\n";
  };
  const Specification spec = read_sources({{"nowhere/b.tex", text("b")}, {"nowhere/a.tex", text("a")}});
  CHECK(spec.ok());
  REQUIRE(spec.sections.size() == 2);
  CHECK(spec.sections[0].name == "b");
}

TEST_CASE("a defect shows no byte that a terminal would obey") {
  const Specification spec = read_text("\\begin{zed}\n  x == \x1b\xff\n\\end{zed}\n", "a\x07.tex");
  REQUIRE(spec.defects.size() == 1);
  CHECK_THAT(spec.defects[0].text(), Catch::Matchers::StartsWith("a\\x07.tex:2:8: ") &&
                                         Catch::Matchers::Contains("\\x1b") && !Catch::Matchers::Contains("\x1b"));
}
