#include "durero/zed/names/rename.hpp"

#include "support/catch.hpp"
#include "zed/lines.hpp"
#include "zed/names/marked.hpp"

using namespace durero::zed;
using namespace durero::zed::test;
using Catch::Contains;

namespace {

std::string renamed_marked(const std::string& marked, const std::string& to) {
  const MarkedText mark(marked);
  const CheckedTexts of = checked({{marked_file, mark.text}});
  const CrossReference names = cross_reference(of);
  const Occurrence* occurrence = names.at(marked_file, mark.at);
  REQUIRE(occurrence);
  try {
    const auto replacements = renamed(of, names, *occurrence, to);
    const auto own = replacements.find(marked_file);
    return own == replacements.end() ? mark.text : replaced(mark.text, own->second);
  } catch (const ZError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("a component is renamed with its strokes in whatever carries it") {
  CHECK(renamed_marked("┌ S\nx : ℕ\n└\n┌ Op\nΔS\n├\n‸x' = x + 1\n└\n─\nT == {S • θ S .x}\n└\n", "total") ==
        "┌ S\ntotal : ℕ\n└\n┌ Op\nΔS\n├\ntotal' = total + 1\n└\n─\nT == {S • θ S .total}\n└\n");
  CHECK(renamed_marked("┌ S\nx? : ℕ\n├\n‸x? > 1\n└\n", "y?") == "┌ S\ny? : ℕ\n├\ny? > 1\n└\n");
}

TEST_CASE("a schema is renamed behind Δ, too, and LaTeX spells the name its way") {
  CHECK(
      renamed_marked("\\begin{schema}{S}\nx : \\nat\n\\end{schema}\n\\begin{schema}{Op}\n\\Xi ‸S\n\\end{schema}\n",
                     "mi_estado") ==
      "\\begin{schema}{mi\\_estado}\nx : \\nat\n\\end{schema}\n\\begin{schema}{Op}\n\\Xi mi\\_estado\n\\end{schema}\n");
  CHECK(renamed_marked("\\begin{zed}\n‸a == 1 \\\\ b == a + 1\n\\end{zed}\n", "mi\\_a") ==
        "\\begin{zed}\nmi\\_a == 1 \\\\ b == mi\\_a + 1\n\\end{zed}\n");
}

TEST_CASE("what would be captured, or taken for something else, is refused") {
  const std::string free = "┌ S\nx, y : ℕ\n├\n∀ n : ℕ • n > x\n└\n";
  CHECK_THAT(renamed_marked("┌ S\n‸x, y : ℕ\n├\n∀ n : ℕ • n > x\n└\n", "n"),
             Contains("would stand for something else"));
  CHECK_THAT(renamed_marked("┌ S\nx, y : ℕ\n├\n∀ ‸n : ℕ • n > x\n└\n", "x"),
             Contains("would stand for something else"));
  CHECK_THAT(renamed_marked("┌ S\n‸x, y : ℕ\n└\n", "y"), Contains("would stand for something else"));
  CHECK_THAT(renamed_marked("┌ S\nx : ℕ\n└\n─\nT == {‸y : ℕ; s : S | ∃ S • θ S = s ∧ y = 1}\n└\n", "x"),
             Contains("expected"));
  CHECK_THAT(renamed_marked("─\n‸a == 1\nb == 2\n└\n", "b"), Contains("is declared already"));
  CHECK_THAT(renamed_marked("─\n‸a == 1\nb == {dom : ℕ | dom > a}\n└\n", "dom"), Contains("expected"));
  // A θ takes the component from the scope: with this name it would take another.
  CHECK_THAT(renamed_marked("┌ S\nx : ℕ\n└\n─\nT == {S • {‸y : ℕ | y = 1 • θ S}}\n└\n", "x"),
             Contains("would stand for something else"));
}

TEST_CASE("names that are not the text's, and words that are no names, are refused") {
  CHECK_THAT(renamed_marked("─\na == ‸dom {(1, 2)}\n└\n", "b"), Contains("a name of the toolkit"));
  CHECK_THAT(renamed_marked("─\na == 1 ‸+ 2\n└\n", "b"), Contains("an operator"));
  CHECK_THAT(renamed_marked("─\n‸a == 1\n└\n", "a b"), Contains("no word of Z"));
  CHECK_THAT(renamed_marked("─\n‸a == 1\n└\n", "∪"), Contains("has a meaning in Z"));
  CHECK_THAT(renamed_marked("─\n‸a == 1\n└\n", ""), Contains("no word of Z"));
  CHECK_THAT(renamed_marked("┌ S\n‸x? : ℕ\n└\n", "x!"), Contains("other strokes"));
  CHECK_THAT(renamed_marked("─\n‸a == 1 +\n└\n", "b"), Contains("expected"));
  CHECK(renamed_marked("─\n‸a == 1\n└\n", "a") == "─\na == 1\n└\n");
}

TEST_CASE("each name of spec/ that a renaming takes gives a text of the same meaning") {
  std::map<std::string, std::string> texts;
  for (const std::string& file : files_in("spec")) texts[file] = contents(file);
  const CheckedTexts of = checked(texts);
  const CrossReference names = cross_reference(of);
  std::set<std::size_t> tried;
  std::size_t done = 0;
  for (const auto& [file, all] : names.files)
    for (const Occurrence& each : all) {
      if (each.is_operator || !each.referent || !tried.insert(*each.referent).second) continue;
      if (names.referents[*each.referent].form == Referent::Form::toolkit || tried.size() % 40 != 0) continue;
      INFO(file << " " << each.name.text());
      CHECK_NOTHROW(renamed(of, names, each, "zz_fresh"));
      ++done;
    }
  CHECK(done > 10);
}
