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
  CHECK(said("%%Zsign \\real U+211D") == "a.tex:2:1: unknown directive %%Zsign; expected %%Zchar or %%Zword");
  const std::string malformed = "a.tex:2:1: malformed directive; expected a command, then its character or word";
  CHECK(said("%%Zchar real U+211D") == malformed);
  CHECK(said("%%Zchar \\real") == malformed);
  CHECK(said("%%Zword \\real real real") == malformed);
  for (const char* word : {"a{b}", "a(b", "0.25", "1", "a'", "\\a"}) {
    CAPTURE(word);
    CHECK(said(std::string("%%Zword \\mine ") + word) ==
          std::string("a.tex:2:1: malformed word ") + word + "; expected one word of Z");
  }
  for (const char* word : {"mine", "a_b", "=="}) CHECK(said(std::string("%%Zinword \\mine ") + word) == "");
  for (const char* character : {"211D", "U+", "U+41", "U+D800", "U+110000", "U+211G", "U+99999999999"}) {
    CAPTURE(character);
    CHECK(said(std::string("%%Zchar \\real ") + character) == std::string("a.tex:2:1: malformed character ") +
                                                                  character +
                                                                  "; expected U+ and hexadecimal digits, beyond ASCII");
  }
}

}  // namespace
}  // namespace durero::zed
