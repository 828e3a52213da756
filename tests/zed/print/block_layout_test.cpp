#include "durero/zed/print/block_layout.hpp"

#include "support/catch.hpp"
#include "zed/lines.hpp"

using namespace durero::zed;
using namespace durero::zed::test;

namespace {

std::string laid_out(const std::string& text) {
  const Specification read = read_sources({{"m.tex", text}});
  REQUIRE(read.ok());
  return replaced(text, block_layout(text, read));
}

}  // namespace

TEST_CASE("a paragraph gets the layout of spec/, with its comments and labels, and prose is kept") {
  CHECK(laid_out(
            "  Prose\n   stays.\n\\begin{schema}{S} x:\\nat % how many\n\\where x<9 % S.inv.1\n\\end{schema} more\n") ==
        "  Prose\n   stays.\n\\begin{schema}{S}\n  x:\\nat % how many\n\\where\n  x<9 % S.inv.1\n\\end{schema} more\n");
}

TEST_CASE("a text in Unicode, and a paragraph that would be too wide, stay as they are") {
  CHECK(laid_out("┌ S\nx:ℕ\n└\n") == "┌ S\nx:ℕ\n└\n");
  std::string wide = "\\begin{zed}\n    a==1";
  for (int i = 0; i < 30; ++i) wide += "+\n1000";
  wide += "\n\\end{zed}\n";
  CHECK(laid_out(wide) == wide);
  CHECK(laid_out(wide + "\\begin{zed}\nb==1\n\\end{zed}\n") == wide + "\\begin{zed}\n  b==1\n\\end{zed}\n");
}

TEST_CASE("the texts of spec/ have this layout, and what was laid out is not changed again") {
  for (const std::string& file : files_in("spec")) {
    const std::string text = contents(file);
    INFO(file);
    CHECK(block_layout(text, read_sources({{file, text}})).empty());
  }
  for (const std::string& file : files_in("tests/zed/corpus/right")) {
    const std::string text = contents(file);
    const Specification read = read_sources({{file, text}});
    if (!read.ok()) continue;
    INFO(file);
    std::string once;
    try {
      once = replaced(text, block_layout(text, read));
    } catch (const ZError&) {
      continue;
    }
    const Specification again = read_sources({{file, once}});
    CHECK(again.ok());
    CHECK(replaced(once, block_layout(once, again)) == once);
    CHECK(again.sections.back().paragraphs == read.sections.back().paragraphs);
  }
}
