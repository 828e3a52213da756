#include "durero/zed/value/settled_function.hpp"

#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "support/catch.hpp"

namespace durero::zed {
namespace {

struct Row {
  const char *text, *value;  ///< of a predicate: true, false
};

/// The values are computed by hand.
constexpr Row expressions[] = {
    {"(λ i : ℕ₁ • 5) 3", "5"},
    {"(λ i : ℕ₁ • 5) 0", "undefined"},
    {"((λ i : ℕ₁ • 5) ⊕ {1 ↦ 7}) 1", "7"},
    {"((λ i : ℕ₁ • 5) ⊕ {1 ↦ 7}) 2", "5"},
    {"(λ i : ℕ₁ • 5) ⊕ {1 ↦ 7}", "(λ n : ℕ₁ • 5) ⊕ {1 ↦ 7}"},
    {"(λ i : ℕ₁ • 5) ⊕ {1 ↦ 7} ⊕ {1 ↦ 5}", "(λ n : ℕ₁ • 5)"},
    {"(λ i : ℕ₁ • 5) ⊕ {0 ↦ 5}", "(λ n : ℕ • 5)"},
    {"((λ i : ℕ₁ • 5) ⊕ {0 ↦ 7}) 0", "7"},
    {"(λ i : ℕ • 5) ⊕ {1/2 ↦ 7}", "(λ n : ℕ • 5) ⊕ {1/2 ↦ 7}"},
    {"ran ((λ i : ℕ • 5) ⊕ {2 ↦ 7})", "{5, 7}"},
    {"dom ((λ i : ℕ • 5) ⊕ {2 ↦ 7})", "ℕ"},
    {"(0‥2) ◁ ((λ i : ℕ₁ • 5) ⊕ {2 ↦ 7})", "{1 ↦ 5, 2 ↦ 7}"},
    {"((λ i : ℕ₁ • 5) ⊕ {2 ↦ 7}) ⦇ 1‥9 ⦈", "{5, 7}"},
    {"let y == 4 • (λ i : ℕ₁ • y) ⊕ {2 ↦ y + 1}", "(λ n : ℕ₁ • 4) ⊕ {2 ↦ 5}"},
    {"(λ i : ℕ₁ • if i = 1 then 7 else 5) 1", "7"},
    {"(λ i : ℕ • {x : 1‥3 | x = i}) 2", "{2}"},
};

constexpr Row predicates[] = {
    {"(λ i : ℕ₁ • 5) = (λ i : ℕ₁ • 4 + 1)", "true"},
    {"(λ i : ℕ₁ • 5) = (λ i : ℕ • 5)", "false"},
    {"(λ i : ℕ₁ • 5) = (λ i : ℕ₁ • 6)", "false"},
    {"(λ i : ℕ₁ • 5) ⊕ {0 ↦ 5} = (λ i : ℕ • 5)", "true"},
    {"(λ i : ℕ₁ • 5) ⊕ {0 ↦ 6} = (λ i : ℕ • 5)", "false"},
    {"(λ i : ℕ₁ • 5) ⊕ {3 ↦ 6} = (λ i : ℕ₁ • 5) ⊕ {2 ↦ 6}", "false"},
    {"(λ i : ℕ₁ • 5) = {1 ↦ 5}", "false"},
    {"2 ↦ 5 ∈ (λ i : ℕ₁ • 5)", "true"},
    {"2 ↦ 6 ∈ (λ i : ℕ₁ • 5)", "false"},
    {"(λ i : ℕ₁ • 5) ∈ ℕ₁ → ℕ", "true"},
    {"(λ i : ℕ₁ • 5) ∈ ℕ → ℕ", "false"},
    {"(λ i : ℕ₁ • 5) ∈ ℕ ⇸ ℕ", "true"},
    {"(λ i : ℕ₁ • 5) ∈ ℤ ⇸ {5, 6}", "true"},
    {"(λ i : ℕ₁ • 5) ∈ ℤ → ℕ", "false"},
    {"(λ i : ℕ₁ • 5) ∈ (2‥9) ⇸ ℕ", "false"},
    {"(λ i : ℕ • 5) ∈ ℕ₁ → ℕ", "false"},
    {"(λ i : ℕ₁ • 5) ⊕ {0 ↦ 6} ∈ ℕ₁ → ℕ", "false"},
    {"(λ i : ℕ₁ • 5) ⊕ {0 ↦ 6} ∈ ℕ → ℕ", "true"},
    {"(λ i : ℕ₁ • 5) ⊕ {3 ↦ - 1} ∈ ℕ₁ → ℕ", "false"},
    {"(λ i : ℕ₁ • 5) ∈ ℕ₁ ⇻ ℕ", "false"},
    {"(λ i : ℕ₁ • 5) ∈ ℕ₁ ⤔ ℕ", "false"},
    {"(λ i : ℕ₁ • 5) ⊕ {1 ↦ 6} ∈ ℕ₁ ↠ {5, 6}", "true"},
    {"(λ i : ℕ₁ • 5) ∈ ℕ₁ ↠ {5, 6}", "false"},
    {"(λ i : ℕ₁ • 5) ∈ ℕ₁ ↔ ℕ", "true"},
    {"dom ((λ i : ℕ₁ • 5) ⊕ {3 ↦ 6}) = ℕ₁", "true"},
    {"dom (λ i : ℕ • 5) = ℕ₁", "false"},
    {"∃ f : {(λ i : ℕ₁ • 5), (λ i : ℕ₁ • 6)} • f 1 = 6", "true"},
    {"∃ x : ℕ • ((λ i : ℕ₁ • 5) ⊕ {2 ↦ 7}) x = 7 ∧ x = 2", "true"},
    {"# {(λ i : ℕ₁ • 5), (λ i : ℕ₁ • 6), (λ i : ℕ₁ • 3 + 2)} = 2", "true"},
    {"ℕ = ℕ₁", "false"},
    {"ℤ = ℤ ∧ ℕ ≠ {1, 2}", "true"},
};

std::string word(Truth truth) { return truth == Truth::yes ? "true" : truth == Truth::no ? "false" : "open"; }

}  // namespace

TEST_CASE("settled functions are applied, overridden, compared and are members of sets of functions") {
  const Evaluator evaluator({});
  for (const Row& row : expressions) {
    CAPTURE(row.text);
    CHECK(evaluator.value(parse_unicode(row.text)).text() == row.value);
  }
  for (const Row& row : predicates) {
    CAPTURE(row.text);
    CHECK(word(evaluator.holds(parse_unicode(row.text))) == row.value);
  }
}

TEST_CASE("a settled function has one form, and its text is read as itself") {
  const Value a = settled_function(1, {Value::pair(Real(0), Real(3)), Value::pair(Real(2), Real(5))}, Real(5));
  const Value b = settled_function(0, {Value::pair(Real(0), Real(3))}, Real(5));
  CHECK(same(a, b));
  CHECK(a.text() == "(λ n : ℕ • 5) ⊕ {0 ↦ 3}");
  const Evaluator evaluator({});
  CHECK(same(evaluator.value(parse_unicode(a.text())), a));
  CHECK_FALSE(has_intensional(a));
  const Value less = settled_function(0, {Value::pair(Real(0), Real(2))}, Real(5));
  CHECK((compare(less, a) < 0) != (compare(a, less) < 0));
}

TEST_CASE("a restriction to infinitely many, and a set of integers that nobody knows, are not decided") {
  const Evaluator evaluator({});
  for (const char* text : {"{1} ⩤ (λ i : ℕ₁ • 5) = ∅", "(λ i : ℕ₁ • 5) ∈ {n : ℤ | n * n * n > 7 * n * n} → ℕ"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(evaluator.holds(parse_unicode(text)), EvaluationError);
  }
}

}  // namespace durero::zed
