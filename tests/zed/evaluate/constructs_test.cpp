#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/print/print.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "durero/zed/types/typecheck.hpp"
#include "support/catch.hpp"

/// Every construct of expressions and predicates, one a line: it is read, printed in both mark-ups and read back,
/// type-checked, and evaluated. What each stands for is computed by hand.

namespace durero::zed {
namespace {

struct Row {
  const char *text, *value;  ///< of a predicate: true, false
};

constexpr Row numbers[] = {
    {"2 + 3 * 4 - 1", "13"},
    {"2 - 3 - 4", "-5"},
    {"- 2 + 3", "1"},
    {"(- 7) div 2", "-4"},
    {"7 mod (- 2)", "-1"},
    {"1 div 0", "undefined"},
    {"1 ≤ 2 < 3", "true"},
    {"2 ≥ 3 ∨ 3 > 3", "false"},
    {"min {3, 2, 9}", "2"},
    {"max {3, 2, 9}", "9"},
    {"min (∅ ∩ {1})", "undefined"},
    {"succ 3", "4"},
    {"max ran {1 ↦ 5, 2 ↦ 3}", "5"},
    {"min dom {3 ↦ 1} + 1", "4"},
    {"(min _) {4, 2}", "2"},
    {"2‥4", "{2, 3, 4}"},
    {"3 ∈ ℕ₁ ∧ 0 ∈ ℕ ∧ - 1 ∈ ℤ", "true"},
    {"- 1 ∈ ℕ ∨ 0 ∈ ℕ₁", "false"},
    {"- 1 ∈ ℤ₁ ∧ 0 ∉ ℤ₁", "true"},
    {"{x : ℤ₁ | x * x ≤ 4}", "{-2, -1, 1, 2}"},
};

constexpr Row sets[] = {
    {"{1, 2} ∪ {3}", "{1, 2, 3}"},
    {"{1, 2} ∩ {2, 3}", "{2}"},
    {"{1, 2, 3} ∖ {2}", "{1, 3}"},
    {"{1, 2} ⊖ {2, 3}", "{1, 3}"},
    {"⋃ {{1}, {2, 3}}", "{1, 2, 3}"},
    {"⋂ {{1, 2}, {2, 3}}", "{2}"},
    {"# {4, 4, 5}", "2"},
    {"1 ∈ {1} ∧ 2 ∉ {1}", "true"},
    {"{1} ⊆ {1} ∧ ∅ ⊂ {1}", "true"},
    {"{1} ⊂ {1}", "false"},
    {"ℙ {1, 2}", "{∅, {1}, {2}, {1, 2}}"},
    {"ℙ₁ {1}", "{{1}}"},
    {"𝔽 {1}", "{∅, {1}}"},
    {"𝔽₁ {1}", "{{1}}"},
    {"{1, 2} × {3}", "{1 ↦ 3, 2 ↦ 3}"},
    {"{x : 1‥5 | x > 3}", "{4, 5}"},
    {"{x : 1‥5 | x > 3 • x * x}", "{16, 25}"},
    {"{x, y : 1‥3 | x < y}", "{1 ↦ 2, 1 ↦ 3, 2 ↦ 3}"},
    {"{x : 1‥2; y : 3‥3 • (y, x)}", "{3 ↦ 1, 3 ↦ 2}"},
    {"(1, (2, 3)).2.1", "2"},
    {"⦉a == 1, b == 2⦊", "⦉a == 1, b == 2⦊"},
    {"⦉a == 1, b == 2⦊.b", "2"},
    {"5 ∈ {x : ℤ | x > 3}", "true"},
};

constexpr Row relations[] = {
    {"dom {1 ↦ 2, 3 ↦ 4}", "{1, 3}"},
    {"ran {1 ↦ 2, 3 ↦ 4}", "{2, 4}"},
    {"{1} ◁ {1 ↦ 2, 3 ↦ 4}", "{1 ↦ 2}"},
    {"{1} ⩤ {1 ↦ 2, 3 ↦ 4}", "{3 ↦ 4}"},
    {"{1 ↦ 2, 3 ↦ 4} ▷ {4}", "{3 ↦ 4}"},
    {"{1 ↦ 2, 3 ↦ 4} ⩥ {4}", "{1 ↦ 2}"},
    {"{1 ↦ 2, 3 ↦ 4} ⊕ {1 ↦ 7}", "{1 ↦ 7, 3 ↦ 4}"},
    {"{1 ↦ 2, 3 ↦ 4} ∼", "{2 ↦ 1, 4 ↦ 3}"},
    {"{1 ↦ 2, 3 ↦ 4} ⦇ {1} ⦈", "{2}"},
    {"{1 ↦ 2} ⨾ {2 ↦ 3}", "{1 ↦ 3}"},
    {"{2 ↦ 3} ∘ {1 ↦ 2}", "{1 ↦ 3}"},
    {"{1 ↦ 2, 2 ↦ 3} ⁺", "{1 ↦ 2, 1 ↦ 3, 2 ↦ 3}"},
    {"{1 ↦ 2, 2 ↦ 3} ∗ ⦇ {1, 9} ⦈", "{1, 2, 3, 9}"},
    {"(7, 7) ∈ {1 ↦ 2} ∗ ∧ (1, 2) ∈ {1 ↦ 2} ∗", "true"},
    {"(2, 1) ∈ {1 ↦ 2} ∗", "false"},
    {"({1 ↦ 2} ∗) 5", "5"},
    {"({1 ↦ 2} ∗) 1", "undefined"},
    {"{1 ↦ 2} ∗", "({(1, 2)} ∗)"},
    {"{1 ↦ 2, 2 ↦ 3} ⨾ {2 ↦ 3} ∗", "{1 ↦ 2, 1 ↦ 3, 2 ↦ 3}"},
    {"{1 ↦ 2, 2 ↦ 3} ↗ 2 ↙", "{1 ↦ 3}"},
    {"{1 ↦ 2, 2 ↦ 3} ↗ - 1 ↙", "{2 ↦ 1, 3 ↦ 2}"},
    {"{1 ↦ 2, 2 ↦ 3, 3 ↦ 1} ↗ 1000001 ↙", "{1 ↦ 3, 2 ↦ 1, 3 ↦ 2}"},
    {"(1, 1) ∈ {1 ↦ 2} ↗ 0 ↙ ∧ (1, 2) ∉ {1 ↦ 2} ↗ 0 ↙", "true"},
    {"(iter 3) {1 ↦ 2, 2 ↦ 1}", "{1 ↦ 2, 2 ↦ 1}"},
    {"(succ ↗ 3 ↙) 4", "7"},
    {"succ ↗ 2 ↙ ⦇ {1, 5} ⦈", "{3, 7}"},
    {"(4, 6) ∈ succ ↗ 2 ↙ ∧ (4, 7) ∉ succ ↗ 2 ↙", "true"},
    {"{1 ↦ 2} ∗ ↗ 2 ↙ ⦇ {1} ⦈", "{1, 2}"},
    {"(_ ↗ _ ↙) ({1 ↦ 2, 2 ↦ 1}, 2)", "{1 ↦ 1, 2 ↦ 2}"},
    {"id {1, 2}", "{1 ↦ 1, 2 ↦ 2}"},
    {"first (1, 2) + second (1, 2)", "3"},
    {"(1, 2) ∈ (_ < _)", "true"},
    {"(2, 1) ∈ (_ < _)", "false"},
    {"(_ + _) (1, 2)", "3"},
    {"{1 ↦ 2, 1 ↦ 3} 1", "undefined"},
    {"{1 ↦ 2} 3", "undefined"},
};

// Of the functions between two sets, those of each kind: of A to B there are |B|^|A| total ones, …
constexpr Row functions[] = {
    {"# (1‥2 ↔ 1‥2)", "16"},
    {"# (1‥2 ⇸ 1‥2)", "9"},
    {"# (1‥2 → 1‥2)", "4"},
    {"# (1‥2 ⤔ 1‥2)", "7"},
    {"# (1‥2 ↣ 1‥3)", "6"},
    {"# (1‥2 ⤀ 1‥2)", "2"},
    {"# (1‥3 ↠ 1‥2)", "6"},
    {"# (1‥3 ⤖ 1‥3)", "6"},
    {"# (1‥2 ⇻ 1‥2)", "9"},
    {"# (1‥2 ⤕ 1‥2)", "7"},
    {"1‥1 → 1‥2", "{{1 ↦ 1}, {1 ↦ 2}}"},
    {"∀ f : 1‥2 → 1‥2 • dom f = 1‥2", "true"},
    {"∀ f : 1‥2 ⇸ 1‥2 • dom f = 1‥2", "false"},
    {"(μ f : ℕ ⇸ ℕ | dom f = ∅) = ∅", "true"},
    {"∀ f : ℕ ↔ ℤ | ran f = 1‥0 • # f = 0", "true"},
    {"∃ f : ℕ ⇸ ℕ • dom f = {1} ∧ f 1 = 3", "true"},
    {"{1 ↦ 2, 2 ↦ 3} ∈ ℕ ⤔ ℕ", "true"},
    {"{1 ↦ 2, 2 ↦ 2} ∈ ℕ ⤔ ℕ", "false"},
    {"{1 ↦ 2} ∈ 1‥2 → ℕ", "false"},
    {"(λ x : ℕ • x + 1) 4", "5"},
    {"λ x : 1‥2; y : 1‥2 | x < y • x + y", "{(1, 2) ↦ 3}"},
    {"(μ x : 1‥9 | x * x = 49)", "7"},
    {"(μ x : 1‥9 | x > 2)", "undefined"},
    {"μ x : 1‥9 | x * x = 49 • x - 1", "6"},
    {"if 1 < 2 then 3 else 4", "3"},
    {"let x == 3; y == 4 • x + y", "7"},
    {"let x == 3 • x = 4", "false"},
    {"∀ x : 1‥3 • ∃ y : 1‥4 • y = x + 1", "true"},
    {"∃₁ x : 1‥5 • x > 3", "false"},
    {"∃₁ x : 1‥5 • x > 4", "true"},
    {"¬ (1 = 1 ∧ 1 = 2) ⇒ (1 = 2 ⇔ 2 = 1)", "true"},
};

constexpr Row schemas[] = {
    {"[x : 1‥2; y : 1‥1 | x > y]", "{⦉x == 2, y == 1⦊}"},
    {"[[x : 1‥2] ∧ [y : 1‥1]]", "{⦉x == 1, y == 1⦊, ⦉x == 2, y == 1⦊}"},
    {"[[x : 1‥2] ∨ [x : 3‥3]]", "{⦉x == 1⦊, ⦉x == 2⦊, ⦉x == 3⦊}"},
    {"{[x : 1‥2] ' | true}", "{⦉x == 1⦊, ⦉x == 2⦊}"},
    {"{[x : 1‥2] ' ''; y : 3‥3 | true}", "{⦉x == 1⦊ ↦ 3, ⦉x == 2⦊ ↦ 3}"},
    {"{ | true}", "{⦉⦊}"},
    {"∀ • 1 = 1", "true"},
    {"⦉x == 5⦊ ∈ (¬ [x : 1‥2])", "true"},
    {"⦉x == 5⦊ ∈ ([x : 1‥2] ⇒ [x : 3‥3])", "true"},
    {"⦉x == 1⦊ ∈ ([x : 1‥2] ⇒ [x : 3‥3])", "false"},
    {"⦉x == 1⦊ ∈ ([x : 1‥2] ⇔ [x : 2‥3])", "false"},
    {"[x, y : 1‥2 | x < y] ⧹ (y)", "{⦉x == 1⦊}"},
    {"[∃ y : 1‥2 • [x, y : 1‥2 | x < y]]", "{⦉x == 1⦊}"},
    {"[∃ y : 1‥2 • [x : 1‥y]]", "[∃ y : 1 ‥ 2 • [x : 1 ‥ y]]"},  // its set depends on y: nothing to list it by
    {"⦉x == 2⦊ ∈ [∃ y : 1‥2 • [x : 1‥y]]", "true"},
    {"⦉x == 1⦊ ∈ (∀ y : 1‥2 • [x, y : 1‥2 | x ≤ y])", "true"},
    {"⦉x == 2⦊ ∈ (∀ y : 1‥2 • [x, y : 1‥2 | x ≤ y])", "false"},
    {"⦉x == 1⦊ ∈ (∃₁ y : 1‥2 • [x, y : 1‥2 | x < y])", "true"},
    {"pre [x, x' : 1‥2 | x' = x + 1]", "{⦉x == 1⦊}"},
    {"[x, x' : 1‥3 | x' = x + 1] ⨟ [x, x' : 1‥3 | x' = x + 1]", "{⦉x == 1, x' == 3⦊}"},
    {"[a! : 1‥2] ⨠ [a? : 2‥3; b : 1‥1]", "{⦉b == 1⦊}"},
    {"[x : 1‥2][y/x]", "{⦉y == 1⦊, ⦉y == 2⦊}"},
    {"[x : 1‥1]'", "{⦉x' == 1⦊}"},
    {"[x, y : 1‥2] ⨡ [x : 1‥1]", "{⦉x == 1⦊}"},
    {"{[x : 1‥2] • θ [x : 1‥2]}", "{⦉x == 1⦊, ⦉x == 2⦊}"},
    {"λ [x : 1‥2] • x", "{⦉x == 1⦊ ↦ 1, ⦉x == 2⦊ ↦ 2}"},
    {"∀ [x : 1‥3] • x < 4", "true"},
    {"∃ n : 1‥2 • [n : 2‥3]", "true"},
    {"⦉a == 1⦊ ∈ [a : ℤ]", "true"},
};

constexpr Row sequences[] = {
    {"⟨4, 5⟩", "⟨4, 5⟩"},
    {"⟨1, 2⟩ ⁀ ⟨3⟩", "⟨1, 2, 3⟩"},
    {"⁀/ ⟨⟨1⟩, ⟨2⟩⟩", "⟨1, 2⟩"},
    {"rev ⟨1, 2, 3⟩", "⟨3, 2, 1⟩"},
    {"head ⟨1, 2⟩", "1"},
    {"last ⟨1, 2⟩", "2"},
    {"tail ⟨1, 2⟩", "⟨2⟩"},
    {"front ⟨1, 2⟩", "⟨1⟩"},
    {"head {2 ↦ 3}", "undefined"},
    {"last (⟨1⟩ ↾ ∅)", "undefined"},
    {"squash {2 ↦ 5, 7 ↦ 6}", "⟨5, 6⟩"},
    {"{1, 3} ↿ ⟨4, 5, 6⟩", "⟨4, 6⟩"},
    {"⟨4, 5, 6⟩ ↾ {4, 6}", "⟨4, 6⟩"},
    {"⟨1⟩ prefix ⟨1, 2⟩", "true"},
    {"⟨2⟩ prefix ⟨1, 2⟩", "false"},
    {"⟨2⟩ suffix ⟨1, 2⟩", "true"},
    {"⟨2, 3⟩ infix ⟨1, 2, 3⟩", "true"},
    {"⟨1, 3⟩ infix ⟨1, 2, 3⟩", "false"},
    {"⟨1, 1⟩ ∈ seq {1}", "true"},
    {"⟨1, 2⟩ ∈ seq {1}", "false"},
    {"{2 ↦ 1} ∈ seq {1}", "false"},
    {"⟨1, 1⟩ ∈ iseq {1}", "false"},
    {"⟨⟩ ∈ seq₁ {1}", "false"},
    {"disjoint ⟨{1}, {2}⟩", "true"},
    {"disjoint ⟨{1}, {1}⟩", "false"},
    {"⟨{1}, {2}⟩ partition {1, 2}", "true"},
    {"⟨{1}, {2}⟩ partition {1, 2, 3}", "false"},
};

std::string value_of(const Term& term, bool expression) {
  const Evaluator evaluator(std::vector<Section>{});
  if (expression) return evaluator.value(term).text();
  const Truth truth = evaluator.holds(term);
  return truth == Truth::open ? "open" : truth == Truth::yes ? "true" : "false";
}

const Typing& toolkit_alone() {
  static const Typing typing = [] {
    const Specification none =
        read_text("\\begin{zsection} \\SECTION none \\parents standard\\_toolkit \\end{zsection}", "none");
    return check(none);
  }();
  return typing;
}

template <std::size_t size>
void holds(const Row (&rows)[size]) {
  for (const Row& row : rows) {
    CAPTURE(row.text);
    const Term term = parse_unicode(row.text);
    CHECK(parse_unicode(to_unicode(term)) == term);
    CHECK(parse_latex(to_latex(term)) == term);
    const Typing typing = check_term(toolkit_alone(), "none", term);
    for (const Defect& defect : typing.defects) FAIL_CHECK(defect.text());
    CHECK(value_of(term, typing.type_of(term).has_value()) == row.value);
  }
}

}  // namespace

TEST_CASE("numbers are read, printed, typed and evaluated") { holds(numbers); }
TEST_CASE("sets, tuples and bindings are read, printed, typed and evaluated") { holds(sets); }
TEST_CASE("relations are read, printed, typed and evaluated") { holds(relations); }
TEST_CASE("functions, choices and quantifiers are read, printed, typed and evaluated") { holds(functions); }
TEST_CASE("schema expressions are read, printed, typed and evaluated") { holds(schemas); }
TEST_CASE("sequences are read, printed, typed and evaluated") { holds(sequences); }

TEST_CASE("what the evaluator does not know, or cannot list, it says") {
  const auto why = [](const char* text) -> std::string {
    try {
      return value_of(parse_unicode(text), true);
    } catch (const EvaluationError& error) {
      return error.what();
    }
  };
  CHECK(why("(_ < _) ↗ 2 ↙ ⦇ {1} ⦈") == "the image of 1 through (_<_) is not known");
  CHECK(why("(_ < _) ∗") == "the closure of (_<_): its members cannot be enumerated");
  CHECK(why("# (ℕ × ℕ)") == "the size of (ℕ × ℕ): its members cannot be enumerated");
  CHECK(why("# (seq {1})") == "the size of (seq {1}): its members cannot be enumerated");
  CHECK(why("# (1‥200 → 1‥200)") ==
        "the size of (this finite set → this finite set): its members cannot be enumerated");
}

}  // namespace durero::zed
