// Quantifiers over whole numbers, as linear conditions decide them: against the points of a window, gone through by
// meanings that the test gives each formula itself.
#include "zed/evaluate/linear_question.hpp"

#include <fmt/format.h>

#include <array>

#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"
#include "zed/evaluate/said_by_exists.hpp"

namespace durero::zed {
namespace {

Truth truth_of(const std::string& predicate) {
  static const Evaluator evaluator(std::vector<Section>{});
  try {
    return evaluator.holds(parse_unicode(predicate));
  } catch (const EvaluationError&) {
    return Truth::open;
  }
}

TEST_CASE("linear comparisons of all whole numbers are decided") {
  for (const char* truth : {"∀ x, y : ℕ • x + y ≥ x",
                            "∀ x, y, z : ℤ • x ≤ y ∧ y ≤ z ⇒ x ≤ z",
                            "∀ x, y : ℕ | x < y • x + 1 ≤ y",
                            "∀ x, y : ℤ • 2 * x ≠ 2 * y + 1",
                            "∀ x, y : ℤ • 2 * x < y ∨ ¬ 2 * x < y",
                            "∀ x, y : ℤ • x + y ∈ ℤ",
                            "∀ x, y : ℕ • x + y ∈ ℕ ∧ x + y + 1 ∈ ℕ₁",
                            "∀ x, y : ℕ₁ • x + y > 1",
                            "∀ x, y : ℤ | x ∈ y ‥ y + 2 • x - y < 3",
                            "∀ x, y : ℤ • (x < y ⇔ y > x)",
                            "∀ x, y : ℤ | x < y < x + 2 • y = x + 1",
                            "∀ x, y : ℤ • - (x - y) = y - x",
                            "∀ x : 3 ‥ 1; y : ℕ • y < 0",
                            "∀ s : seq ℕ; x : ℕ • x ≥ 0",
                            "∀ x : ℕ • ∃ y : ℕ • y > x",
                            "∀ x, y : ℤ | x + 1 < y • ∃ z : ℤ • x < z ∧ z < y",
                            "∀ n : 0 ‥ 5 • ∀ x, y : ℕ | x ≥ n • n * x + y ≥ n * n",
                            "∀ x, y : ℕ • ∀ z : x ‥ x + y • z ≥ x",
                            "∀ x, y : ℕ • 1 div 0 ≤ x ⇒ x + y ≥ x",
                            "∃₁ x, y : ℤ • x + y = 5 ∧ x - y = 1",
                            "∀ y : ℤ • ∃₁ x : ℤ | x < 9 - y • x + y = 3 ∧ x < 100 - y",
                            "{x, y : ℤ | 2 * x = 2 * y + 1} = ∅",
                            "∅ ≠ {x, y : ℤ | 2 * x = 2 * y + 2}",
                            "∀ n : ℤ • {x : ℤ | x > n ∧ x < n + 1} = {}",
                            "∀ x, y : ℕ | x > 1000000007 ∧ y > x • x + y > 2000000016"}) {
    INFO(truth);
    CHECK(truth_of(truth) == Truth::yes);
    CHECK(truth_of("¬ (" + std::string(truth) + ")") == Truth::no);
  }
  for (const char* falsity :
       {"∃ x, y : ℤ • x + y > x + y", "∃ x, y : ℤ • 2 * x = 2 * y + 1", "∀ x, y : ℤ • 7 * x + 11 * y ≠ 100000001",
        "∀ x, y : ℕ | x > 1000000007 ∧ y > x • x + y > 2000000017", "∀ x, y : ℤ • ∃ z : ℤ • x < z ∧ z < y",
        "∀ y : ℤ • ∃₁ y : y ‥ 2 * y • y > 3", "∃ y : 3 ‥ 3 • ∃₁ y : y ‥ y + 1 • y ≥ 3", "∃₁ x, y : ℕ • x + y = 1",
        "∃₁ x : ℤ • 2 * x > 10", "∃₁ x : ℤ • 2 * x = 11 ∧ x > 3", "{x, y : ℤ | 2 * x = 2 * y + 2} = ∅",
        "∃ x : ℕ • ∀ y : ℕ • y ≤ x", "∃ x, y : ℕ • x + y < x ∨ x + y < y", "∀ x, y : ℕ • x - y ∈ ℕ",
        "∀ x, y : ℤ | x + y > 50 • x > 25 ∨ y > 26", "∃ x : 3 ‥ 1; y : ℕ • y ≥ 0",
        "∃ x, y : ℕ • 1 div 0 ≤ x ∧ x + y < x"}) {
    INFO(falsity);
    CHECK(truth_of(falsity) == Truth::no);
  }
}

TEST_CASE("applications of functions that are lines are linear where they have a value") {
  for (const char* truth :
       {"∃ f : ℕ → ℕ • ∀ n : ℕ • f n > n", "∃ f : ℕ → ℕ • ∀ n, m : ℕ • f n = f m", "∀ x, y : ℕ • succ x + y > x",
        "∀ x, y : ℤ • succ x > x ∨ x < 0 ∨ y > x", "∀ x, y : ℤ • ¬ succ x > x ⇒ x < 0 ∨ x > y + y",
        "let f == (λ n : ℕ • 2 * n - 3) • ∀ x, y : ℕ₁ • f (x + y) > 0",
        "let f == (λ n : ℕ • 7) • ∀ x, y : ℕ • f x ≤ y + 7", "∀ x : ℕ • ∀ y : 0 ‥ succ x • y ≤ x + 1"}) {
    INFO(truth);
    CHECK(truth_of(truth) == Truth::yes);
  }
  for (const char* falsity : {"∃ x, y : ℤ • succ x = x + 1 ∧ x < 0 ∧ y > x", "∀ x, y : ℤ | y ≥ x • succ x > x",
                              "∃ x, y : ℤ • succ x ∉ ℕ ∧ x < y"}) {
    INFO(falsity);
    CHECK(truth_of(falsity) == Truth::no);
  }
}

TEST_CASE("an application is no line where the function has other values, and nothing follows where it has none") {
  CHECK(truth_of("let f == (λ n : ℕ • 0) ⊕ {1000 ↦ 50} • ∀ x, y : ℕ • f x ≤ y + 4") != Truth::yes);
  CHECK(truth_of("let f == (λ n : ℕ • n * n) • ∀ x, y : ℕ • f x + y ≥ x") == Truth::open);
  CHECK(truth_of("let f == {2 ↦ 3} • ∀ x, y : ℕ | x < y • f x ≤ y + 4") != Truth::yes);
}

TEST_CASE("a part that is no linear comparison of whole numbers decides nothing") {
  for (const char* open : {"∀ x, y : ℕ • x * y ≥ 0", "∀ x, y : ℕ • x div 2 + y ≥ y", "∀ x, y : ℕ • x mod 2 ≤ y + 1",
                           "∀ x, y : 𝔸 • x + y > x ∨ y ≤ 0", "∀ x, y : ℕ • x + 1/2 ≠ y",
                           "∀ x, y : ℤ • ∃ z : ℤ • 2 * z = x + y ∨ 2 * z = x + y + 1"}) {
    INFO(open);
    CHECK(truth_of(open) == Truth::open);
  }
  // A number that is not whole, or none, is in no comparison, and in no set of whole numbers.
  CHECK(truth_of("∀ x, y : ℕ • 1/2 ∉ ℤ ∨ x + y < x") != Truth::no);
  CHECK(truth_of("∃ x, y : ℕ • 1/2 ∈ ℤ ∧ x + y > x") != Truth::yes);
  CHECK(truth_of("∃ x, y : ℕ • 1 div 0 ∉ ℤ ∧ x + y > x") == Truth::no);
  // A name of the text's own is not that of the toolkit.
  const auto short_name = read_text("\\begin{zed} NN == \\nat \\end{zed}", "short.tex");
  CHECK(Evaluator(short_name.sections).holds(parse_unicode("∀ x, y : NN • x + y ≥ x")) == Truth::yes);
  const auto own = read_text(
      "\\begin{axdef} f : \\num \\cross \\num \\fun \\num \\\\ N : \\power \\num \\where N = \\{ x : \\num | x > 2 \\}"
      " \\end{axdef}",
      "own.tex");
  CHECK(Evaluator(own.sections).holds(parse_unicode("∃ x : N; y : ℤ • x < 3 ∧ y > x")) == Truth::no);
}

using Point = std::map<std::string, long>;

/// A formula as it is written, and what it says of numbers.
struct WrittenFormula {
  std::string z;
  std::function<bool(const Point&)> holds;
};
struct WrittenNumber {
  std::string z;
  std::function<long(const Point&)> value;
};

std::string numeral(long n) { return n < 0 ? fmt::format("-({})", -n) : std::to_string(n); }

WrittenNumber any_number(const std::vector<std::string>& names) {
  WrittenNumber sum{numeral(*rc::gen::inRange(-4, 5)), {}};
  const long constant = sum.z[0] == '-' ? -std::stol(sum.z.substr(2)) : std::stol(sum.z);
  std::vector<std::pair<std::string, long>> terms;
  for (const std::string& name : names) {
    const long coefficient = *rc::gen::inRange(-2, 3);
    if (coefficient == 0) continue;
    terms.emplace_back(name, coefficient);
    if (*rc::gen::inRange(0, 2) == 0)
      sum.z += fmt::format(" + {} * {}", numeral(coefficient), name);
    else
      sum.z = fmt::format("({}) - {} * {}", sum.z, name, numeral(-coefficient));
  }
  sum.value = [constant, terms](const Point& point) {
    long value = constant;
    for (const auto& [name, coefficient] : terms) value += coefficient * point.at(name);
    return value;
  };
  return sum;
}

bool compares(int sign, const std::string& relation) {
  if (relation == "<") return sign < 0;
  if (relation == "≤") return sign <= 0;
  if (relation == ">") return sign > 0;
  if (relation == "≥") return sign >= 0;
  return (sign == 0) == (relation == "=");
}

/// A relation, or one that linear conditions do not follow: with a product, or an operand without a value or whole one.
WrittenFormula any_relation(const std::vector<std::string>& names) {
  const WrittenNumber a = any_number(names), b = any_number(names), c = any_number(names);
  const auto relation = *rc::gen::elementOf(std::vector<std::string>{"<", "≤", ">", "≥", "=", "≠"});
  const auto order = [relation](long left, long right) { return compares(left < right ? -1 : left > right, relation); };
  switch (*rc::gen::inRange(0, 11)) {
    case 7:  // of succ and of id ℕ there is a value from 0 on
      return {fmt::format("succ ({}) {} (id ℕ) ({})", a.z, relation, b.z),
              [=](const Point& p) { return a.value(p) >= 0 && b.value(p) >= 0 && order(a.value(p) + 1, b.value(p)); }};
    case 0:
      return {fmt::format("{} ∈ ({}) ‥ ({})", a.z, b.z, c.z),
              [=](const Point& p) { return b.value(p) <= a.value(p) && a.value(p) <= c.value(p); }};
    case 1:
      return {fmt::format("{} ∉ ℕ", a.z), [=](const Point& p) { return a.value(p) < 0; }};
    case 2:
      return {fmt::format("{} < {} ≤ {}", a.z, b.z, c.z),
              [=](const Point& p) { return a.value(p) < b.value(p) && b.value(p) <= c.value(p); }};
    case 3:
      return {fmt::format("({}) * x {} {}", a.z, relation, b.z),
              [=](const Point& p) { return order(a.value(p) * p.at("x"), b.value(p)); }};
    case 4:
      return {fmt::format("1 div 0 {} {}", relation, a.z), [](const Point&) { return false; }};
    case 5:
      return {fmt::format("1 / 2 {} {}", relation, a.z), [=](const Point& p) { return order(1, 2 * a.value(p)); }};
    case 6:
      return {"1 / 2 ∉ ℤ", [](const Point&) { return true; }};
    default:
      return {fmt::format("{} {} {}", a.z, relation, b.z),
              [=](const Point& p) { return order(a.value(p), b.value(p)); }};
  }
}

WrittenFormula any_formula(const std::vector<std::string>& names, int depth);

WrittenFormula any_quantified(const std::vector<std::string>& names, int depth) {
  const WrittenNumber low = any_number(names), high = any_number(names);
  const std::string name = *rc::gen::elementOf(std::vector<std::string>{"z", "w", "y"});  // y is one outside too
  std::vector<std::string> inside = names;
  const bool is_new = std::find(inside.begin(), inside.end(), name) == inside.end();
  if (is_new) inside.push_back(name);
  const WrittenFormula body = any_formula(inside, depth - 1);
  const int form = *rc::gen::inRange(0, is_new ? 5 : 4);  // the bounds stand inside of the last
  const std::vector<std::string> forms = {"(∀ {0} : ({1}) ‥ ({2}) • {3})", "(∃ {0} : ({1}) ‥ ({2}) • {3})",
                                          "(∃₁ {0} : ({1}) ‥ ({2}) • {3})", "{{{0} : ({1}) ‥ ({2}) | {3}}} = ∅",
                                          "∅ ≠ {{{0} : ℤ | {0} ∈ ({1}) ‥ ({2}) ∧ {3}}}"};
  return {fmt::format(fmt::runtime(forms[static_cast<std::size_t>(form)]), name, low.z, high.z, body.z),
          [=](const Point& point) {
            Point here = point;
            const long first = low.value(point), last = high.value(point);
            long count = 0;
            for (long n = first; n <= last; ++n) {
              here[name] = n;
              count += body.holds(here) ? 1 : 0;
            }
            const std::array<bool, 5> so = {count == std::max(last - first + 1, 0L), count > 0, count == 1, count == 0,
                                            count > 0};
            return so[static_cast<std::size_t>(form)];
          }};
}

WrittenFormula any_formula(const std::vector<std::string>& names, int depth) {
  const int form = depth == 0 ? 9 : *rc::gen::inRange(0, 10);
  if (form >= 7) return any_relation(names);
  if (form >= 5) return any_quantified(names, depth);
  const WrittenFormula a = any_formula(names, depth - 1);
  if (form == 0) return {fmt::format("¬ ({})", a.z), [=](const Point& p) { return !a.holds(p); }};
  const WrittenFormula b = any_formula(names, depth - 1);
  switch (form) {
    case 1:
      return {fmt::format("(({}) ∧ ({}))", a.z, b.z), [=](const Point& p) { return a.holds(p) && b.holds(p); }};
    case 2:
      return {fmt::format("(({}) ∨ ({}))", a.z, b.z), [=](const Point& p) { return a.holds(p) || b.holds(p); }};
    case 3:
      return {fmt::format("(({}) ⇒ ({}))", a.z, b.z), [=](const Point& p) { return !a.holds(p) || b.holds(p); }};
    default:
      return {fmt::format("(({}) ⇔ ({}))", a.z, b.z), [=](const Point& p) { return a.holds(p) == b.holds(p); }};
  }
}

/// Asks the question of a quantifier of x and y, where `is_so` says of which values the predicate holds.
Truth asked(const std::string& quantifier, const std::function<bool(const Point&)>& is_so) {
  static const Evaluator evaluator(std::vector<Section>{});
  const LinearSurroundings around{
      [](const Name&) { return true; },
      [](const Name&) -> const Term* { return nullptr; },
      [](const Declaration&) { return Components(); },
      [&](const Term& term) -> Code { return [term](Frame&) { return evaluator.value(term); }; },
      [](const Name& name) { return name.word == "x" ? 0U : 1U; },
      [](const Node& one) { return just_one_by_exists(one, Definitions({})); }};
  const Term term = parse_unicode(quantifier);
  const auto question = linear_question(*term, around);
  REQUIRE(question);
  Steps steps;
  Context context(steps);
  Frame frame(2, context);
  return question->some(frame, [&](Frame& inside) {
    const auto number = [&](std::size_t slot) { return std::stol(inside.slots[slot].real()->text()); };
    return truth(is_so({{"x", number(0)}, {"y", number(1)}}));
  });
}

TEST_CASE("the bounds of sets, and of an inner variable with the name of an outer one, are those that hold") {
  const auto least_sum = [](long least, long most) {
    return [=](const Point& p) { return p.at("x") >= least && p.at("y") >= least && p.at("x") + p.at("y") <= most; };
  };
  CHECK(asked("∃ x, y : ℕ • x + y ≤ 0", least_sum(0, 0)) == Truth::yes);
  CHECK(asked("∃ x, y : ℕ • x + y ≤ - 1", least_sum(0, -1)) == Truth::no);
  CHECK(asked("∃ x, y : ℕ₁ • x + y ≤ 2", least_sum(1, 2)) == Truth::yes);
  CHECK(asked("∃ x, y : ℕ₁ • x + y ≤ 1", least_sum(1, 1)) == Truth::no);
  const auto no_successor = [](const Point& p) { return p.at("x") < 0 && p.at("y") > p.at("x"); };
  CHECK(asked("∃ x, y : - 3 ‥ 3 • ¬ succ x > x ∧ y > x", no_successor) == Truth::yes);
  CHECK(asked("∃ x, y : - 3 ‥ 3 • succ x > x ∧ x < 0 ∧ y > x", [](const Point&) { return false; }) == Truth::no);
  const auto is_one = [](const Point& p) { return p.at("x") == 0 && p.at("y") == 1; };  // 1 and 2 are two
  CHECK(asked("∃ x, y : 0 ‥ 3 • x = 0 ∧ y = 1 ∧ ¬ (∃₁ y : y ‥ 2 • y ≥ 0)", is_one) == Truth::yes);
  // the part that is not linear denies the inner ∃, and not the part that is
  CHECK(asked("∃ x, y : 0 ‥ 3 • x = 0 ∧ y = 1 ∧ ¬ (∃ z : 0 ‥ 3 • z = x ∧ z * z = y)", is_one) == Truth::yes);
  const auto is_origin = [](const Point& p) { return p.at("x") == 0 && p.at("y") == 0; };
  CHECK(asked("∃ x, y : 0 ‥ 3 • x = 0 ∧ y = 0 ∧ (∃ y : 2 ‥ 3 • y > x + 1)", is_origin) == Truth::yes);
  CHECK(asked("∃ x, y : 0 ‥ 3 • x = 0 ∧ y = 3 ∧ (∃ y : 0 ‥ 1 • y > x + 1)", is_origin) == Truth::no);
}

TEST_CASE("where sides of disjunctions are not followed, nothing is said to be impossible") {
  std::string sides = "x = 1";
  for (int n = 2; n <= 200; ++n) sides += fmt::format(" ∨ x = {}", n);
  const auto is_so = [](long least) {
    return [least](const Point& p) { return p.at("x") >= least && p.at("x") <= p.at("y") && p.at("x") <= 200; };
  };
  CHECK(asked("∃ x, y : ℤ | x ≥ 200 ∧ x ≤ y • " + sides, is_so(200)) == Truth::open);
  CHECK(asked("∃ x, y : ℤ | x ≥ 2 ∧ x ≤ y • " + sides, is_so(2)) == Truth::yes);
}

TEST_CASE("what is decided of random formulas is what the points of a window say") {
  int count = 0, decided = 0;
  durero::test::property("random formulas", [&] {
    const bool all = *rc::gen::inRange(0, 2) == 0;
    const long low = *rc::gen::inRange(-3, 1), high = *rc::gen::inRange(-1, 4);
    const WrittenFormula premise = any_formula({"x", "y"}, 1), body = any_formula({"x", "y"}, 3);
    const auto is_so = [&](const Point& p) {
      const auto in = [&](long n) { return low <= n && n <= high; };
      return in(p.at("x")) && in(p.at("y")) && premise.holds(p) && body.holds(p) != all;
    };
    const std::string z =
        fmt::format("{} x, y : {} ‥ {} | {} • {}", all ? "∀" : "∃", numeral(low), numeral(high), premise.z, body.z);
    bool some = false;
    for (long x = low; x <= high; ++x)
      for (long y = low; y <= high; ++y) some = some || is_so({{"x", x}, {"y", y}});
    const Truth said = asked(z, is_so);
    RC_LOG() << z << "\n";
    RC_ASSERT(said == Truth::open || (said == Truth::yes) == some);
    ++count;
    decided += said == Truth::open ? 0 : 1;
  });
  INFO(decided << " of " << count << " were decided");
  CHECK(decided * 10 >= count * 6);  // three in four are
}

}  // namespace
}  // namespace durero::zed
