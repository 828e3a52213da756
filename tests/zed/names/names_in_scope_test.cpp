#include "durero/zed/names/names_in_scope.hpp"

#include <algorithm>

#include "support/catch.hpp"
#include "zed/names/marked.hpp"

using namespace durero::zed;
using namespace durero::zed::test;

namespace {

/// The names at the mark, before which so many bytes are the beginning of one.
std::set<std::string> at_mark(const std::string& marked, std::size_t begun = 0) {
  const MarkedText mark(marked);
  std::set<std::string> names;
  const auto found = names_in_scope({{marked_file, mark.text}}, marked_file, mark.at - begun, mark.at);
  if (!found) return {"outside"};
  for (const VisibleName& each : *found) names.insert(each.name.text());
  return names;
}

using Names = std::set<std::string>;

}  // namespace

TEST_CASE("a scope has what is declared around a place, and the globals before it") {
  const std::string text = "─\nA == ℕ\n└\n┌ S\nx : A\n├\n∀ n : ℕ • n > ‸\n└\n─\nB == ℕ\n└\n";
  CHECK(at_mark(text) == Names{"A", "S", "x", "n"});
  CHECK(at_mark("┌ S\nx : ℕ\n└\n┌ Op\nΔS; y! : ℕ\n├\nx' = x‸\n└\n", 1) == Names{"S", "Op", "x", "x'", "y!"});
}

TEST_CASE("behind a point stand the components of the binding") {
  CHECK(at_mark("┌ P\nx, y : ℕ\n└\n─\na == {p : P | p.‸ = 1}\n└\n") == Names{"x", "y"});
  CHECK(at_mark("┌ P\nx, y : ℕ\n└\n╷\nf : ℕ → P\n└\n─\na == (f 1).x‸\n└\n", 1) == Names{"x", "y"});
  CHECK(
      at_mark(
          "\\begin{schema}{P}\nx, y : \\nat\n\\end{schema}\n\\begin{zed}\na == \\{p : P | p.‸ = 1\\}\n\\end{zed}\n") ==
      Names{"x", "y"});
}

TEST_CASE("in a paragraph that cannot be read, its tokens tell") {
  CHECK(at_mark("┌ S\nx : ℕ\n└\n┌ Op\nΔS\nn? : ℕ\n├\nx' = ( ∧ ‸\n└\n") == Names{"Op", "S", "x", "x'", "n?"});
}

TEST_CASE("outside of paragraphs no name is in scope") {
  CHECK(at_mark("Prose ‸ here.\n┌ S\nx : ℕ\n└\n") == Names{"outside"});
}

TEST_CASE("commands and plain names of the toolkit") {
  const std::vector<std::string> plain = plain_toolkit_names();
  CHECK(std::ranges::find(plain, "first") != plain.end());
  CHECK(std::ranges::find(plain, "dom") == plain.end());
  const CheckedTexts of = checked({{"m.tex", "%%Zchar \\real U+211D\n\\begin{zed} [ \\real ] \\end{zed}\n"}});
  const auto commands = latex_commands(of.read, "Specification");
  const std::pair<std::string, std::string> own("real", "ℝ"), known("cup", "∪");
  CHECK(std::ranges::find(commands, own) != commands.end());
  CHECK(std::ranges::find(commands, known) != commands.end());
}
