#include "durero/zed/syntax/markup.hpp"

#include <string_view>

#include "durero/zed/syntax/defect.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "support/catch.hpp"

namespace durero::zed {
namespace {

TEST_CASE("a command stands for its text, and one that nothing names is an error") {
  const Markup markup{{"punto", "Punto"}, {"real", "ℝ"}};
  CHECK(parse_latex("\\punto", markup) == parse_unicode("Punto"));
  CHECK(parse_latex("x \\in \\real", markup) == parse_unicode("x ∈ ℝ"));
  CHECK_THROWS_AS(parse_latex("\\punto"), ZError);
}

TEST_CASE("a command is looked for by any text") {
  const Markup markup{{"real", "ℝ"}};
  CHECK(markup.contains(std::string_view("real")));
  CHECK_FALSE(markup.contains(std::string_view("rea")));
}

TEST_CASE("the directives of a text are its section's mark-up") {
  const Specification read =
      read_text("%%Zchar \\real U+211D\n%%Zword \\punto Punto\n\\begin{zed} [\\punto] \\end{zed}\n", "directives.tex");
  REQUIRE(read.ok());
  const Markup& markup = read.markup.at(read.sections.back().name);
  CHECK(markup.at("real") == "ℝ");
  CHECK(markup.at("punto") == "Punto");
  CHECK(read.sections.back().paragraphs.front() == parse_unicode_paragraph("[Punto]"));
}

}  // namespace
}  // namespace durero::zed
