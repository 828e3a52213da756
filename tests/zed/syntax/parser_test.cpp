#include "durero/zed/syntax/parser.hpp"

#include "durero/zed/syntax/defect.hpp"
#include "support/catch.hpp"

namespace durero::zed {
namespace {

Term name(const char* word) { return reference({word, ""}); }

std::string refusal(const std::string& text) {
  try {
    parse_unicode(text);
  } catch (const ZError& error) {
    return error.in("E").text();
  }
  return {};
}

TEST_CASE("operators bind as the standard says, and associate to their side") {
  const auto same = [](const char* brief, const char* full) {
    CAPTURE(brief, full);
    CHECK(parse_unicode(brief) == parse_unicode(full));
  };
  same("a + b * c", "a + (b * c)");
  same("a - b - c", "(a - b) - c");
  same("a ∪ b ∩ c", "a ∪ (b ∩ c)");
  same("A → B → C", "A → (B → C)");
  same("A × B → C", "(A × B) → C");
  same("A ◁ B ◁ f", "A ◁ (B ◁ f)");
  same("p ⇒ q ⇒ r", "p ⇒ (q ⇒ r)");
  same("p ∧ q ∨ r ⇒ s", "((p ∧ q) ∨ r) ⇒ s");
  same("¬ p ∧ q", "(¬ p) ∧ q");
  same("f x y", "(f x) y");
  same("f x ∼", "(f x) ∼");
  same("- x + y", "(- x) + y");
  same("∀ x : A • p ∧ q", "∀ x : A • (p ∧ q)");
  same("dom f ∪ ran g", "(dom f) ∪ (ran g)");
  same("λ x : A • x + 1 = f", "(λ x : A • x + 1) = f");
  same("μ x : A • x ∈ S ∧ p", "((μ x : A • x) ∈ S) ∧ p");
  same("λ x : A • S ∧ T = f", "(λ x : A • S ∧ T) = f");
  same("λ x : A • ¬ S ⊆ f", "(λ x : A • ¬ S) ⊆ f");
  same("f ∪ λ x : A • x = g", "(f ∪ (λ x : A • x)) = g");
  same("∀ x : A • λ y : B • y = f", "∀ x : A • ((λ y : B • y) = f)");
  same("let x == a • x = b", "let x == a • (x = b)");
  same("f [S; T]", "f ([S; T])");
  same("f [x, y : A | p] [x : A]", "(f ([x, y : A | p])) ([x : A])");
  same("f [A] x", "(f[A]) x");
  same("f [let a == 0; b == 0 • a]", "f[(let a == 0; b == 0 • a)]");
  same("f [A, ∀ x : A; y : B • p]", "f[A, (∀ x : A; y : B • p)]");
  same("f [∀ x : A; y : B • p; S]", "f ([(∀ x : A; y : B • p); S])");
  CHECK_FALSE(parse_unicode("A × B × C") == parse_unicode("A × (B × C)"));
}

TEST_CASE("a term has the tree of its form") {
  CHECK(parse_unicode("a + b") == operation("_+_", {name("a"), name("b")}));
  CHECK(parse_unicode("A ⇸ B") == reference({"_⇸_", ""}, {name("A"), name("B")}));
  CHECK(parse_unicode("a ≤ b < c") == relation({{"_≤_", ""}, {"_<_", ""}}, {name("a"), name("b"), name("c")}));
  CHECK(parse_unicode("∅[A]") == reference({"∅", ""}, {name("A")}));
  CHECK(parse_unicode("S '")->kind == Kind::decoration);
  CHECK(parse_unicode("S'") == reference({"S", "'"}));
  CHECK(parse_unicode("{a, b}")->kind == Kind::set_extension);
  CHECK(parse_unicode("{a : A}")->kind == Kind::comprehension);
  CHECK(parse_unicode("0.25") == operation("_/_", {zed::number("25"), zed::number("100")}));
  CHECK(parse_unicode("⟨a⟩") == operation("⟨,,⟩", {parse_unicode("{(1, a)}")}));
}

TEST_CASE("both mark-ups give one tree") {
  const auto same = [](const char* latex, const char* unicode) {
    CAPTURE(latex, unicode);
    CHECK(parse_latex(latex) == parse_unicode(unicode));
  };
  same("\\forall x : A | x \\neq a @ x \\in S \\cup T", "∀ x : A | x ≠ a • x ∈ S ∪ T");
  same("f \\inv \\limg S \\rimg", "f ∼ ⦇ S ⦈");
  same("\\negate x + y", "- x + y");
  same("\\theta S~'", "θ S '");
  same("mi\\_radio~x", "mi_radio x");
  same("\\{ x : \\nat_1 @ x * x \\}", "{ x : ℕ₁ • x * x }");
}

TEST_CASE("what cannot be read is refused at its place, in characters") {
  CHECK(refusal("1 +") == "E:1:4: the text ends too early; expected an expression or a predicate");
  CHECK(refusal("∅ ∪ )") == "E:1:5: unexpected ); expected an expression or a predicate");
  CHECK(refusal("a b )").starts_with("E:1:5: unexpected )"));
  CHECK(refusal("(a, b") == "E:1:6: the text ends too early; expected )");
  CHECK(refusal("let x : A • x").starts_with("E:1:5: a let that does not define"));
  CHECK(refusal("x == ;").starts_with("E:1:3: unexpected =="));
}

TEST_CASE("nesting is read to the limit and no deeper") {
  const auto nested = [](std::size_t depth) { return std::string(depth, '(') + "x" + std::string(depth, ')'); };
  CHECK(refusal(nested(max_depth - 1)) == "");
  CHECK(refusal(nested(max_depth)).find("nests deeper than 500 levels") != std::string::npos);
}

TEST_CASE("a paragraph is read in the form that it is printed in") {
  const Paragraph box = parse_unicode_paragraph("┌─ S[X]\n│ x, y : X\n├─\n│ x = y  % S.inv.1\n│ x ≠ y\n└─\n");
  const Schema& schema = std::get<Schema>(box.form);
  CHECK(schema.name == Name{"S", ""});
  CHECK(schema.formals == std::vector<Name>{{"X", ""}});
  REQUIRE(schema.text.predicates.size() == 2);
  CHECK(schema.text.predicates[0].label == "S.inv.1");
  CHECK(schema.text.predicates[1].label == "");
  CHECK(std::get<Axiomatic>(parse_unicode_paragraph("┌─\n│ c : ℕ\n├─\n│ c = 1\n└─\n").form).formals.empty());
  CHECK(std::get<FreeType>(parse_unicode_paragraph("T ::= a | b⟪ℕ⟫").form).branches.size() == 2);
  CHECK(std::get<GivenTypes>(parse_unicode_paragraph("[A, B]").form).names.size() == 2);
  CHECK_THROWS_AS(parse_unicode_paragraph("[A]\n[B]"), ZError);
  CHECK_THROWS_AS(parse_unicode_paragraph("T ::= {a}"), ZError);
}

}  // namespace
}  // namespace durero::zed
