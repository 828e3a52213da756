#include "durero/zed/print/print.hpp"

#include <fmt/core.h>

#include "durero/zed/syntax/parser.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "support/property.hpp"
#include "support/tree.hpp"
#include "zed/generate.hpp"
#include "zed/syntax/block_parser.hpp"
#include "zed/syntax/lexer.hpp"

using namespace durero::zed;
using durero::test::property;

namespace rc {
template <>
struct Arbitrary<Term> {
  static Gen<Term> arbitrary() {
    return gen::withSize([](int size) { return durero::zed::test::expression(size); });
  }
};
template <>
struct Arbitrary<Paragraph> {
  static Gen<Paragraph> arbitrary() {
    return gen::withSize([](int size) { return durero::zed::test::paragraph(size); });
  }
};
}  // namespace rc

namespace durero::zed {
void showValue(const Term& term, std::ostream& os) { os << to_unicode(term) << "\n" << to_latex(term); }
void showValue(const Paragraph& paragraph, std::ostream& os) { os << to_unicode(paragraph) << to_latex(paragraph); }
}  // namespace durero::zed

namespace {

Paragraph read_back(const std::string& latex, const Markup& markup) {
  std::vector<Defect> defects;
  const std::vector<Block> blocks = cut(latex, "printed", defects);
  if (blocks.size() != 1 || !defects.empty()) throw std::runtime_error("not one paragraph: " + latex);
  std::vector<ZError> mended;
  std::vector<Paragraph> read = parse_block(blocks[0].environment, lex_latex(blocks[0], markup, {}), mended);
  if (read.size() != 1 || !mended.empty()) throw std::runtime_error("not one paragraph: " + latex);
  return read[0];
}

}  // namespace

TEST_CASE("every paragraph of spec/ is read back as it was from what is printed, in both mark-ups") {
  const Specification spec = read_files({fmt::format("{}/spec/interseccion.tex", durero::test::source_dir()),
                                         fmt::format("{}/spec/operaciones.tex", durero::test::source_dir())});
  std::size_t count = 0;
  for (const Section& section : spec.sections) {
    const Markup& markup = spec.markup.at(section.name);
    for (const Paragraph& paragraph : section.paragraphs) {
      CAPTURE(to_unicode(paragraph), to_latex(paragraph, markup));
      CHECK(read_back(to_latex(paragraph, markup), markup) == paragraph);
      CHECK(parse_unicode_paragraph(to_unicode(paragraph)) == paragraph);
      ++count;
    }
  }
  CHECK(count > 60);
}

TEST_CASE("a generated tree is read back as it was from what is printed, in both mark-ups") {
  property("Unicode", [](const Term& term) { RC_ASSERT(parse_unicode(to_unicode(term)) == term); });
  property("LaTeX", [](const Term& term) { RC_ASSERT(parse_latex(to_latex(term)) == term); });
  property("paragraphs in Unicode",
           [](const Paragraph& paragraph) { RC_ASSERT(parse_unicode_paragraph(to_unicode(paragraph)) == paragraph); });
  property("paragraphs in LaTeX",
           [](const Paragraph& paragraph) { RC_ASSERT(read_back(to_latex(paragraph), {}) == paragraph); });
}

TEST_CASE("parentheses are printed where reading back needs them, and nowhere else") {
  for (const char* text : {"a + b + c",
                           "a + (b + c)",
                           "a * (b + c) - d",
                           "A ⇸ B → C",
                           "(A ⇸ B) → C",
                           "p ⇒ q ⇒ r",
                           "(p ⇒ q) ⇒ r",
                           "(∃ x : T • p) ∧ q",
                           "q ∧ ∃ x : T • p ∧ r",
                           "¬ p ∧ q",
                           "¬ (p ∧ q)",
                           "f x + g (x + 1)",
                           "ℙ A × ℙ (A × B)",
                           "(A × B) × C",
                           "dom f ∼",
                           "dom (f ∼)",
                           "{e?} ⩤ f'",
                           "0 ≤ s ≤ h",
                           "(A ∨ B) ⧹ (r!) ∧ [r! : T | r! = x]",
                           "(μ x : T | p)",
                           "λ x : T • (x ⊆ y)",
                           "λ x : T • (¬ (x ⊆ y ∧ p))",
                           "λ x : T • A ∧ ∀ y : T • x = y",
                           "(λ x : T • x) = f",
                           "θ Escena'",
                           "θ Escena '",
                           "Escena '",
                           "# (a ∪ b)",
                           "- x + y",
                           "rayo?.p.x",
                           "f ⦇ {a, b} ⦈"})
    CHECK(to_unicode(parse_unicode(text)) == text);
}

TEST_CASE("a point behind a number is printed as no decimal's") {
  const Term selection = make({.kind = Kind::tuple_selection,
                               .place = {},
                               .name = {"1", ""},
                               .children = {number("0")},
                               .names = {},
                               .text = {}});
  CHECK(to_unicode(selection) == "(0).1");
  CHECK(parse_unicode(to_unicode(selection)) == selection);
  CHECK(to_unicode(parse_unicode("0.25")) == "25 / 100");
}
