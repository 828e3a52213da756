// Functions slope · x + constant on whole numbers: in which sets of functions they are, against their values in a
// window.
#include "zed/value/integer_lines.hpp"

#include <set>

#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"
#include "zed/value/sets.hpp"

namespace durero::zed {
namespace {

const Evaluator& toolkit() {
  static const Evaluator evaluator(std::vector<Section>{});
  return evaluator;
}

Truth truth_of(const std::string& predicate) {
  try {
    return toolkit().holds(parse_unicode(predicate));
  } catch (const EvaluationError&) {
    return Truth::open;
  }
}

TEST_CASE("a λ over whole numbers with a linear body is in the sets of functions that its line is in") {
  for (const char* truth :
       {"(λ x : ℕ • x) ∈ ℕ → ℕ", "(λ x : ℕ • x) ∈ ℕ ⤖ ℕ", "(λ x : ℕ • x + 1) ∈ ℕ ⤖ ℕ₁", "(λ x : ℤ • - x) ∈ ℤ ⤖ ℤ",
        "succ ∈ ℕ ↣ ℕ", "succ ∈ ℕ ⤖ ℕ₁", "succ ∈ ℤ ⇸ ℤ", "(id ℕ) ∈ ℕ ⤖ ℕ", "(λ x : ℕ • 3 * x - 3 * x + 2) ∈ ℕ → {1, 2}",
        "(λ x : ℕ • 5) ∈ ℕ ↠ {5}", "(λ x : ℤ • 2 * x + 1) ∈ ℤ ↣ ℤ", "(λ x : ℕ • x) ∈ ℤ ↔ ℕ",
        "(λ x : ℕ₁ • x - 1) ∈ ℕ₁ ⤖ ℕ", "(let n == 4 • (λ x : ℕ • n * x) ∈ ℕ ↣ ℕ)", "(λ x : ℕ • x) ∈ ℕ ⤔ ℤ",
        "{x : ℕ • x ↦ x + 1} ∈ ℕ ⤖ ℕ₁", "{x : ℤ • (x, 3)} ∈ ℤ → ℕ", "(λ x : ℕ • 2) ∈ ℕ → {y : ℕ | y mod 2 = 0}"}) {
    INFO(truth);
    CHECK(truth_of(truth) == Truth::yes);
  }
  for (const char* falsity :
       {"(λ x : ℕ • x + 1) ∈ ℕ ⤖ ℕ", "(λ x : ℕ • x - 1) ∈ ℕ → ℕ", "(λ x : ℤ • x) ∈ ℤ → ℕ", "(λ x : ℕ • - x) ∈ ℕ → ℕ",
        "(λ x : ℕ • 2 * x) ∈ ℕ ↠ ℕ", "(λ x : ℕ • 5) ∈ ℕ ↣ ℕ", "(λ x : ℤ • 5) ∈ ℤ ↣ ℤ", "(λ x : ℕ • x) ∈ ℤ → ℤ",
        "(λ x : ℕ₁ • x) ∈ ℕ → ℕ", "(λ x : ℤ • x) ∈ ℕ ⇸ ℤ", "succ ∈ ℤ → ℤ", "(λ x : ℕ • x) ∈ ℕ ⇻ ℕ",
        "(λ x : ℕ • x) ∈ ℕ → 0 ‥ 9", "(λ x : ℕ • x) ∈ 0 ‥ 9 ⇸ ℕ", "(λ x : ℕ • 5) ∈ ℕ ↠ {5, 6}",
        "(λ x : ℕ • 5) ∈ ℕ → {6}", "(λ x : ℕ • x) ∈ 𝔸 → 𝔸", "(λ x : ℤ • x) ∈ ℤ ↠ 𝔸"}) {
    INFO(falsity);
    CHECK(truth_of(falsity) == Truth::no);
  }
  for (const char* open :
       {"(λ x : ℕ • x * x) ∈ ℕ → ℕ", "(λ x : ℕ • x div 2) ∈ ℕ → ℕ", "(λ x : ℕ | x > 2 • x) ∈ ℕ → ℕ",
        "(λ x : ℕ | x > 2 ∧ x ≠ 5 • x) ∈ ℕ → ℕ", "{x : ℕ • x + 1 ↦ x} ∈ ℕ ⇸ ℕ", "{x : ℕ • (x, x, x)} ∈ ℙ (ℕ × ℕ × ℕ)",
        "(λ x, y : ℕ • x + y) ∈ ℕ × ℕ → ℕ", "(λ x : ℕ • x) ∈ ℕ → ℤ₁", "(λ x : ℕ • if x > 3 then x else 0) ∈ ℕ → ℕ"}) {
    INFO(open);
    CHECK(truth_of(open) == Truth::open);
  }
}

TEST_CASE("lines are tried as witnesses of functions on whole numbers") {
  for (const char* truth :
       {"∃ f : ℕ → ℕ • ∀ x : 1 ‥ 3 • f x = x + 1", "∃ f : ℕ → ℕ • f 3 = 4 ∧ f 7 = 8", "∃ f : ℕ ↣ ℕ • f 2 = 4",
        "∃ f : ℤ → ℤ • f 3 = 3 ∧ f (- 5) = - 5", "∃ f : ℕ ⤖ ℕ • f 3 = 3", "∃ f : ℕ₁ ⤖ ℕ • f 3 = 2"}) {
    INFO(truth);
    CHECK(truth_of(truth) == Truth::yes);
  }
  CHECK(truth_of("∃ f : ℕ ⤖ ℕ • f 3 = 4") != Truth::yes);  // of the lines succ alone has that value
}

TEST_CASE("a line is a function that is written as a term of the same values") {
  Steps steps;
  Context context(steps);
  for (const IntegerLine& line : {IntegerLine{0, Real(2), Real(-3)}, IntegerLine{1, Real(1), Real(0)},
                                  IntegerLine{{}, Real(-1), Real(4)}, IntegerLine{-2, Real(0), Real(7)}}) {
    const Value made = line_function(line);
    const Value read = toolkit().value(parse_unicode(made.text()));
    INFO(made.text());
    for (int x = -4; x <= 4; ++x) {
      const Value here = made.set()->apply(Real(x), context), there = read.set()->apply(Real(x), context);
      CHECK(same(here, there));
      CHECK((made.set()->in_domain(Real(x), context) == Truth::yes) == !here.is_undefined());
      if (here.is_undefined()) continue;
      CHECK(*here.real() == line.slope * Real(x) + line.constant);
      CHECK(made.set()->contains(Value::pair(Real(x), here), context) == Truth::yes);
      CHECK(made.set()->contains(Value::pair(Real(x), *here.real() + Real(1)), context) == Truth::no);
    }
    CHECK(made.set()->apply(Real(0.5), context).is_undefined());
    CHECK(made.set()->apply(Value(Open{}), context).is_open());
  }
}

/// A set of whole numbers, with its members in a window.
struct WindowSet {
  std::string z;
  Value set;
  std::set<int> members;
};

constexpr int far_off = 60;  // coefficients are to 4: a value that leaves a set does so within this window

WindowSet any_set() {
  std::set<int> members;
  const auto from = [&](int least) {
    for (int n = least; n <= far_off; ++n) members.insert(n);
    return members;
  };
  switch (*rc::gen::inRange(0, 5)) {
    case 0:
      return {"ℤ", integers("ℤ", std::nullopt), from(-far_off)};
    case 1:
      return {"ℕ", integers("ℕ", 0), from(0)};
    case 2:
      return {"ℕ₁", integers("ℕ₁", 1), from(1)};
    default: {
      std::vector<Value> few;
      const int least = *rc::gen::inRange(-3, 4), count = *rc::gen::inRange(0, 4);
      for (int n = least; n < least + count; ++n) members.insert(n), few.emplace_back(Real(n));
      return {"few", Value::set(few), members};
    }
  }
}

TEST_CASE("a line is in a set of functions as its values in a window say") {
  int asked = 0, known = 0;
  test::property("random lines, sets and arrows", [&] {
    const int slope = *rc::gen::inRange(-3, 4), constant = *rc::gen::inRange(-4, 5), first = *rc::gen::inRange(-2, 3);
    const bool has_least = *rc::gen::inRange(0, 4) != 0;
    const WindowSet from = any_set(), to = any_set();
    const auto flag = [] { return *rc::gen::inRange(0, 2) == 0; };
    const Arrow arrow{.function = flag(), .total = flag(), .injective = flag(), .surjective = flag(), .finite = false};
    std::set<int> domain, range;
    bool is_inside = true;
    for (int x = has_least ? first : -far_off; x <= far_off; ++x) {
      const int y = slope * x + constant;
      is_inside = is_inside && from.members.contains(x) &&
                  (to.members.contains(y) || (y > far_off && to.members.contains(far_off)) ||
                   (y < -far_off && to.members.contains(-far_off)));
      domain.insert(x);
      range.insert(y);
    }
    bool expected = is_inside && !(arrow.injective && range.size() < domain.size());
    for (const int x : from.members) expected = expected && !(arrow.total && !domain.contains(x));
    for (const int y : to.members)
      if (-9 <= y && y <= 9) expected = expected && !(arrow.surjective && !range.contains(y));
    Steps steps;
    Context context(steps);
    IntegerLine line{has_least ? std::optional(first) : std::nullopt, Real(slope), Real(constant)};
    const auto said = line_is_in(line, from.set, to.set, arrow, context);
    RC_LOG() << slope << " * x + " << constant << ", " << from.z << ", " << to.z << "\n";
    ++asked;
    if (!said) return;
    ++known;
    RC_ASSERT((*said == Truth::yes) == expected);
    Arrow finite = arrow;
    finite.finite = true;
    RC_ASSERT(line_is_in(line, from.set, to.set, finite, context) == Truth::no);
  });
  INFO(known << " of " << asked << " were decided");
  CHECK(known == asked);
}

}  // namespace
}  // namespace durero::zed
