#include "durero/zed/names/explanation.hpp"

#include "support/catch.hpp"
#include "zed/lines.hpp"
#include "zed/names/marked.hpp"

using namespace durero::zed;
using namespace durero::zed::test;

namespace {

/// What is said at the mark: FORM NOTATION : TYPE = VALUE.
std::string explained(const std::string& marked) {
  const MarkedText mark(marked);
  const CheckedTexts of = checked({{marked_file, mark.text}});
  const auto told = explanation(of, cross_reference(of), marked_file, mark.at);
  if (!told) return "nothing";
  std::string all = told->form + (told->form.empty() ? "" : " ") + told->notation;
  if (!told->type.empty()) all += " : " + told->type;
  if (!told->value.empty()) all += " = " + told->value;
  return all;
}

}  // namespace

TEST_CASE("a name is explained by its form, type and value") {
  CHECK(explained("─\na == 2 + 3\nb == ‸a + 1\n└\n") == "definition a : 𝔸 = 5");
  CHECK(explained("─\n‸a == 2 + 3\n└\n") == "definition a : 𝔸 = 5");
  CHECK(explained("─\nT ::= ‸leaf | node⟪T⟫\n└\n") == "constant of a free type leaf : T");
  CHECK(explained("┌ S\nx : ℙ ℕ\n├\n‸x = ∅\n└\n") == "component x : ℙ 𝔸");
  CHECK(explained("┌ S\nx : ℕ\n└\n┌ Op\n‸ΔS\n└\n") == "schema ΔS : ℙ [x : 𝔸; x' : 𝔸]");
  CHECK(explained("─\nf == λ n : ℕ • ‸n\n└\n") == "variable n : 𝔸");
  CHECK(explained("─\na == ‸dom {(1, 2)}\n└\n") == "name of the toolkit dom : ℙ (ℙ (𝔸 × 𝔸) × ℙ 𝔸)");
}

TEST_CASE("an expression is explained at the sign that makes it") {
  CHECK(explained("─\na == 1 ‸+ 2 + 3\n└\n") == "1 + 2 : 𝔸 = 3");
  CHECK(explained("─\na == 1 + 2 ‸+ 3\n└\n") == "1 + 2 + 3 : 𝔸 = 6");
  CHECK(explained("─\na == 1 ‸+ (2 + 3)\n└\n") == "1 + (2 + 3) : 𝔸 = 6");
  CHECK(explained("─\na == ‸{n : ℕ | n < 3}\n└\n") == "{ n : ℕ | n < 3 } : ℙ 𝔸 = {0, 1, 2}");
  CHECK(explained("─\n⊢? ‸∀ n : 1 ‥ 3 • n < 3\n└\n") == "∀ n : 1 ‥ 3 • n < 3 = false");
  CHECK(explained("─\n⊢? 1 ≤ 2 ‸< 3\n└\n") == "1 ≤ 2 < 3 = true");
  CHECK(explained("\\begin{zed}\na == \\{1, 2\\} ‸\\cup \\{3\\}\n\\end{zed}\n") == "{1, 2} ∪ {3} : ℙ 𝔸 = {1, 2, 3}");
  CHECK(explained("─\na == ‸⟨1, 2⟩\n└\n") == "⟨1, 2⟩ : ℙ (𝔸 × 𝔸)");
}

TEST_CASE("a value is told of closed terms only, and of what constants determine") {
  CHECK(explained("─\nn == 7\nf == λ n : ℕ • ‸n + 1\n└\n") == "variable n : 𝔸");
  CHECK(explained("─\nn == 7\nf == λ n : ℕ • n ‸+ 1\n└\n") == "n + 1 : 𝔸");
  CHECK(explained("─\nn == 7\nf == λ m : ℕ • n ‸+ 1\n└\n") == "n + 1 : 𝔸 = 8");
  CHECK(explained("╷\nn : ℕ\n└\n─\nm == n ‸+ 1\n└\n") == "n + 1 : 𝔸");
  CHECK(explained("─\na == 1 ‸div 0\n└\n") == "1 div 0 : 𝔸 = undefined");
  CHECK(explained("─\na == # ‸(ℙ (1 ‥ 40))\n└\n") == "nothing");
  CHECK(explained("─\na == ‸# (ℙ (1 ‥ 25))\n└\n") == "# ℙ (1 ‥ 25) : 𝔸 = 33554432");
  CHECK(explained("─\na == 1 ‸+ 2\nb == c\n└\n") == "1 + 2 : 𝔸");
  CHECK(explained("┌ S\nx : ℕ\n└\n─\nx == 1\n└\n┌ T\nS\n├\nx ‸+ 1 = 2\n└\n").find("=") == std::string::npos);
}

TEST_CASE("the declaration of a global is shown") {
  const MarkedText mark("┌ S\nx : ℕ\n└\n┌ Op\n‸ΔS\n└\n");
  const CheckedTexts of = checked({{marked_file, mark.text}});
  const auto told = explanation(of, cross_reference(of), marked_file, mark.at);
  REQUIRE(told);
  CHECK(told->declaration.find("x : ℕ") != std::string::npos);
}

TEST_CASE("each byte of the Z texts at hand can be asked") {
  std::size_t told = 0;
  for (const std::string& file : files_in("demo")) {
    const std::string text = contents(file);
    const CheckedTexts of = checked({{file, text}});
    const CrossReference names = cross_reference(of);
    for (std::size_t at = 0; at < text.size(); at += 7) told += explanation(of, names, file, at) ? 1 : 0;
  }
  CHECK(told > 50);
}
