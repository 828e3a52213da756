/// Facts of every kind of expression, each with its opposite: what is true is found true, and its negation false. They
/// are looked for where their like in ZLive's own tests are (tests/peers/zlive.sh), and for each of a finite set.

#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "support/catch.hpp"

namespace durero::zed {
namespace {

constexpr const char* text = R"(
─
COLOUR ::= red | green | blue
└
─
LIST ::= none | put⟪ℕ × LIST⟫
└
╷
size, least : LIST → ℕ
|
size none = 0
∀ n : ℕ; l : LIST • size (put (n, l)) = 1 + size l
least none = 9
∀ n : ℕ; l : LIST • least (put (n, l)) = min {n, least l}
└
╷
half, digits : ℕ → ℕ
|
half 0 = 0
half 1 = 0
∀ n : ℕ • half (n + 2) = half n + 1
∀ n : ℕ | n < 10 • digits n = 1
∀ n : ℕ | n ≥ 10 • digits n = 1 + digits (n div 10)
└
┌ A
x, x' : ℕ
out! : ℕ
|
x < 4
x' = x + 1
out! = x * x
└
┌ B
x : 0 ‥ 9
y : ℕ
|
y = x + x
└
)";

const std::vector<const char*> facts = {
    // numbers
    "7 div 2 = 3",
    "- 7 div 2 = - 4",
    "- 7 mod 2 = 1",
    "7 mod - 2 = - 1",
    "¬ 7 div 0 = 3",
    "¬ 7 mod 0 = 7",
    "2 * 3 + 4 = 10",
    "2 - 3 - 4 = - 5",
    "1 < 2 ≤ 2 < 3",
    "min {3, 1, 2} = 1",
    "max (2 ‥ 5) = 5",
    "¬ min ∅ = 0",
    "10 * 10 * 10 * 10 * 10 * 10 * 10 * 10 * 10 * 10 = 10000000000",
    "# (3 ‥ 1) = 0",
    "succ 3 = 4",
    "0 ∈ ℕ",
    "0 ∉ ℕ₁",
    "- 1 ∈ ℤ",
    "- 1 ∉ ℕ",
    // sets
    "{1, 2} = {2, 1, 1}",
    "{1} ⊂ {1, 2}",
    "¬ {1} ⊂ {1}",
    "{1, 2} ∪ {2, 3} = 1 ‥ 3",
    "{1, 2} ∩ {2, 3} = {2}",
    "{1, 2} ∖ {2, 3} = {1}",
    "⋃ {{1}, {2}} = {1, 2}",
    "⋂ {{1, 2}, {2}} = {2}",
    "# ℙ {1, 2, 3} = 8",
    "{1, 2} ∈ ℙ ℕ",
    "∅ ∈ 𝔽 ℕ",
    "∅ ∉ ℙ₁ ℕ",
    "{x : 1 ‥ 3 • x * x} = {1, 4, 9}",
    "{x, y : 1 ‥ 2 | x < y} = {(1, 2)}",
    "disjoint ⟨{1}, {2}⟩",
    "¬ disjoint ⟨{1, 2}, {2}⟩",
    "⟨{1}, {2}⟩ partition {1, 2}",
    "¬ ⟨{1}⟩ partition {1, 2}",
    "(1, {2}) ∈ ℕ × ℙ ℕ",
    "first (1, 2) = 1",
    "(1, 2).2 = 2",
    // relations and functions
    "dom {1 ↦ 2, 3 ↦ 4} = {1, 3}",
    "ran {1 ↦ 2, 3 ↦ 4} = {2, 4}",
    "{1 ↦ 2, 3 ↦ 4} ∼ = {2 ↦ 1, 4 ↦ 3}",
    "{1} ◁ {1 ↦ 2, 3 ↦ 4} = {1 ↦ 2}",
    "{1} ⩤ {1 ↦ 2, 3 ↦ 4} = {3 ↦ 4}",
    "{1 ↦ 2, 3 ↦ 4} ▷ {2} = {1 ↦ 2}",
    "{1 ↦ 2, 3 ↦ 4} ⩥ {2} = {3 ↦ 4}",
    "{1 ↦ 2} ⊕ {1 ↦ 3} = {1 ↦ 3}",
    "{1 ↦ 2, 2 ↦ 3}⦇{1}⦈ = {2}",
    "{1 ↦ 2} ⨾ {2 ↦ 3} = {1 ↦ 3}",
    "{2 ↦ 3} ∘ {1 ↦ 2} = {1 ↦ 3}",
    "({1 ↦ 2, 2 ↦ 3} ⁺) = {1 ↦ 2, 2 ↦ 3, 1 ↦ 3}",
    "id {1, 2} = {1 ↦ 1, 2 ↦ 2}",
    "{1 ↦ 2} ∈ ℕ ⇸ ℕ",
    "{1 ↦ 2, 1 ↦ 3} ∉ ℕ ⇸ ℕ",
    "{1 ↦ 2, 3 ↦ 2} ∉ ℕ ⤔ ℕ",
    "{1 ↦ 2, 2 ↦ 1} ∈ 1 ‥ 2 ⤖ 1 ‥ 2",
    "# (1 ‥ 2 → 1 ‥ 3) = 9",
    "{1 ↦ 2} 1 = 2",
    "¬ {1 ↦ 2} 3 = 2",
    "¬ {1 ↦ 2} 3 ≠ 2",
    "¬ {1 ↦ 2, 1 ↦ 3} 1 = 2",
    "(λ n : ℕ | n > 1 • n * n) 3 = 9",
    "¬ (λ n : ℕ | n > 1 • n * n) 1 = 1",
    // sequences
    "⟨1, 2⟩ ⁀ ⟨3⟩ = ⟨1, 2, 3⟩",
    "# ⟨4, 4⟩ = 2",
    "head ⟨4, 5⟩ = 4",
    "last ⟨4, 5⟩ = 5",
    "tail ⟨4, 5⟩ = ⟨5⟩",
    "front ⟨4, 5⟩ = ⟨4⟩",
    "rev ⟨1, 2, 3⟩ = ⟨3, 2, 1⟩",
    "¬ head ⟨⟩ = 1",
    "⟨1, 2⟩ 2 = 2",
    "⟨1, 2⟩ ∈ seq ℕ",
    "⟨1, 1⟩ ∉ iseq ℕ",
    "⟨0⟩ ∉ seq₁ (1 ‥ 5)",
    "squash {2 ↦ 7, 9 ↦ 8} = ⟨7, 8⟩",
    "{1, 3} ↿ ⟨4, 5, 6⟩ = ⟨4, 6⟩",
    "⟨4, 5, 6⟩ ↾ {4, 6} = ⟨4, 6⟩",
    "⟨1⟩ prefix ⟨1, 2⟩",
    "⟨2⟩ suffix ⟨1, 2⟩",
    "⟨2⟩ infix ⟨1, 2, 3⟩",
    "⁀/ ⟨⟨1⟩, ⟨2, 3⟩⟩ = ⟨1, 2, 3⟩",
    // quantifiers, and what is looked for
    "∃ x : ℕ • x + 3 = 5",
    "∀ x : 1 ‥ 9 • x * x < 82",
    "∃₁ x : ℕ • x + x = 8",
    "¬ ∃₁ x : 1 ‥ 9 • x mod 2 = 0",
    "∃ x : ℕ • x < 5 ∧ half x = 2",
    "{x : ℕ | half x = 1 ∧ x ≤ 7} = {2, 3}",
    "(μ x : ℕ | x < 9 ∧ half x = 4) = 8",
    "∃ x : ℕ • digits x = 2",
    "∀ x : ℕ | x < 20 • digits x ≤ 2",
    "¬ ∀ x : ℕ • half x < 3",
    "∃ x, y : ℕ • x * y = 12",
    "∃ x : ℤ • x * x = 9 ∧ x < 0",
    "∃ x : ℕ; y : {1, 2} • x + 1 = y + y ∧ y > 1",
    "{x : ℕ; y : {1, 2} | x + 1 = y + y} = {(1, 1), (3, 2)}",
    "(let n == 3 • n * n) = 9",
    "(if 1 < 2 then 3 else 4) = 3",
    "(μ n : 1 ‥ 9 | n * n = 49) = 7",
    "{n : ℕ | n * n ≤ 9} = 0 ‥ 3",
    // free types
    "red ≠ green",
    "COLOUR = {red, green, blue}",
    "# (COLOUR → COLOUR) = 27",
    "put (1, none) ≠ none",
    "put (1, none) ≠ put (2, none)",
    "size (put (1, put (2, none))) = 2",
    "least (put (4, put (2, none))) = 2",
    "∃ n : ℕ • put (n, none) = put (3, none)",
    "∃ n : 0 ‥ 9 • least (put (n, put (5, none))) = 4",
    "∃ n : ℕ • n < 9 ∧ least (put (n, put (5, none))) = 4",
    "∃ l : LIST • l = put (1, none) ∧ size l = 1",
    // schemas
    "{B} ∖ {B} = ∅",
    "# B = 10",
    "⦉x == 1, y == 2⦊ ∈ B",
    "⦉x == 1, y == 3⦊ ∉ B",
    "∃ A • out! = 9",
    "¬ ∃ A • out! = 16",
    "∀ A • x' > x",
    "∃ B • y = 6 ∧ x = 3",
    "(μ B | y = 6).x = 3",
    "⦉x == 3⦊ ∈ (pre A)",
    "⦉x == 4⦊ ∉ (pre A)",
    "{B | x < 2 • y} = {0, 2}",
    "[B | x = 1] = {⦉x == 1, y == 2⦊}",
};

TEST_CASE("facts are true, and their negations false") {
  const Specification read = read_text(text, "facts");
  for (const Defect& defect : read.defects) FAIL(defect.text());
  const Evaluator evaluator(read.sections);
  for (const char* fact : facts) {
    INFO(fact);
    CHECK(evaluator.holds(parse_unicode(fact)) == Truth::yes);
    CHECK(evaluator.holds(parse_unicode(std::string("¬ (") + fact + ")")) == Truth::no);
  }
}

}  // namespace
}  // namespace durero::zed
