#include "durero/zed/syntax/markup.hpp"

#include "durero/zed/print/print.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "support/catch.hpp"

namespace durero::zed {
namespace {

std::string section(const std::string& name, const std::string& parents, const std::string& body) {
  return "\\begin{zsection}\n\\SECTION " + name + " \\parents " + parents + "\n\\end{zsection}\n" + body;
}

TEST_CASE("a directive names a command, and a section passes it on to its children") {
  const std::string declares = "%%Zchar \\real U+211D\n%%Zword \\mine mio\n\\begin{zed} [A] \\end{zed}\n";
  const Specification read =
      read_texts({{"a.tex", section("a", "standard\\_toolkit", declares)},
                  {"b.tex", section("b", "a", "%%Zinchar \\Cup U+22D3\n\\begin{zed} [B] \\end{zed}")},
                  {"c.tex", section("c", "b", "\\begin{zed} x == \\real \\end{zed}")},
                  {"d.tex", section("d", "standard\\_toolkit", "\\begin{zed} [D] \\end{zed}")}});
  for (const Defect& defect : read.defects) FAIL_CHECK(defect.text());
  CHECK(read.markup.at("a") == Markup{{"real", "ℝ"}, {"mine", "mio"}});
  CHECK(read.markup.at("b") == Markup{{"real", "ℝ"}, {"mine", "mio"}, {"Cup", "⋓"}});
  CHECK(read.markup.at("c") == read.markup.at("b"));
  CHECK(read.markup.at("d").empty());
  CHECK(std::get<Definition>(read.find("c")->paragraphs.at(0).form).value == parse_unicode("ℝ"));
}

TEST_CASE("a command is read and printed by the mark-up that is given") {
  const Markup markup = {{"real", "ℝ"}, {"mine", "mio"}};
  const Term term = parse_unicode("mio ∈ ℙ ℝ");
  CHECK(parse_latex("\\mine \\in \\power \\real", markup) == term);
  CHECK(parse_latex(to_latex(term, markup), markup) == term);
  CHECK(to_latex(term, markup).find("\\real") != std::string::npos);
  CHECK_THROWS_AS(parse_latex("\\mine \\in \\power \\real"), ZError);
}

TEST_CASE("what a directive cannot say is a defect at its place") {
  const auto said = [](const std::string& directive) {
    const Specification read = read_text("Prose.\n" + directive + "\n\\begin{zed} [A] \\end{zed}\n", "a.tex");
    return read.defects.empty() ? std::string() : read.defects[0].text();
  };
  CHECK(said("%%Zchar \\real U+211D") == "");
  CHECK(said("%%Zinchar \\mine U+0026") == "");
  CHECK(said("%%Zsign \\real U+211D") == "a.tex:2:1: unknown directive %%Zsign; expected %%Zchar or %%Zword");
  const std::string malformed = "a.tex:2:1: malformed directive; expected a command, then its character or word";
  CHECK(said("%%Zchar real U+211D") == malformed);
  CHECK(said("%%Zchar \\real") == malformed);
  CHECK(said("%%Zword \\real real real") == malformed);
  for (const char* word : {"a(b", "0.25", "1", "a'"}) {
    CAPTURE(word);
    CHECK(said(std::string("%%Zword \\mine ") + word) ==
          std::string("a.tex:2:1: malformed word ") + word + "; expected one word of Z");
  }
  for (const char* word : {"\\a", "{}", "{a'}", "\\also"}) {
    CAPTURE(word);
    CHECK(said(std::string("%%Zword \\mine ") + word) ==
          std::string("a.tex:2:1: malformed word ") + word + "; expected words of Z");
  }
  for (const char* word : {"mine", "a_b", "=="}) CHECK(said(std::string("%%Zinword \\mine ") + word) == "");
  for (const char* character : {"211D", "U+", "U+41", "U+D800", "U+110000", "U+211G", "U+99999999999"}) {
    CAPTURE(character);
    CHECK(said(std::string("%%Zchar \\real ") + character) ==
          std::string("a.tex:2:1: malformed character ") + character +
              "; expected U+ and hexadecimal digits, beyond ASCII or a sign of Z");
  }
}

TEST_CASE("a directive gives a command words in mark-up, which mean what ISO Z and the directives before say") {
  const Specification read = read_text(R"(
%%Zinword \to \fun
%%Zpreword \some {\power}_{1}
%%Zinword \is {==}
%%Zpreword \none \lnot\exists
%%Zinword \over {\oplus}/
%%Zword \nothing \langle\rangle
%%Zinword \onto \to
\begin{zed} f \is \nat \to \nat \end{zed}
\begin{zed} g \is \nat \onto \some \nat \end{zed}
\begin{zed} h == \nothing \end{zed}
\begin{zed} \function 30 \leftassoc (\_ \over \_) \end{zed}
\begin{axdef} \_ \over \_ : \nat \cross \nat \fun \nat \where \none x : \nat @ x \over 1 = 2 \end{axdef}
)",
                                       "a.tex");
  REQUIRE(read.ok());
  const auto& paragraphs = read.sections.at(0).paragraphs;
  CHECK(std::get<Definition>(paragraphs.at(0).form).value == parse_unicode("ℕ → ℕ"));
  CHECK(std::get<Definition>(paragraphs.at(1).form).value == parse_unicode("ℕ → ℙ₁ ℕ"));
  CHECK(std::get<Definition>(paragraphs.at(2).form).value == parse_unicode("⟨⟩"));
  const auto& box = std::get<Axiomatic>(paragraphs.at(3).form);
  const Operators& operators = read.operators.at("Specification");
  const Markup markup = {{"distributed", "⊕/"}};
  CHECK(box.text.predicates.at(0).term ==
        parse_latex("\\lnot \\exists x : \\nat @ x \\distributed 1 = 2", markup, operators));
}

}  // namespace
}  // namespace durero::zed
