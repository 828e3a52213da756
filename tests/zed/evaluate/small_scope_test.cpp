/// The finds of a search among sets, sequences, functions and rules, against what is so of each value of a small scope
/// in turn: the second is asked of known values alone, or is computed here of numbers.

#include <fmt/format.h>

#include <cstdlib>
#include <map>

#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "durero/zed/types/typecheck.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "zed/evaluate/random_cases.hpp"

namespace durero::zed::test {
namespace {

constexpr std::uint64_t most_scope_steps = 400'000;

std::uint64_t scope_seed() {
  const char* seed = std::getenv("DURERO_SEED");
  return seed ? std::strtoull(seed, nullptr, 10) : 1;
}

/// Answers questions; nothing where one is not decided.
class ScopeAnswers {
 public:
  explicit ScopeAnswers(std::uint64_t most_steps = most_scope_steps)
      : most_steps_(most_steps), evaluator_(sections(), {}, &steps_) {}

  std::string truth(const std::string& predicate, const Valuation& locals = {}) {
    return decided([&]() -> std::string {
      const Truth here = evaluator_.holds(parse_unicode(predicate), locals);
      return here == Truth::open ? "" : here == Truth::yes ? "true" : "false";
    });
  }
  std::string value(const std::string& expression) {
    return decided([&] {
      const Value value = evaluator_.value(parse_unicode(expression));
      return value.is_open() || (value.set() && !value.set()->members()) ? "" : value.text();
    });
  }
  Value listed(const std::string& expression) {
    steps_ = Steps(most_steps_);
    return evaluator_.value(parse_unicode(expression));
  }

 private:
  static std::vector<Section> sections() {
    const Specification read = read_text("─\nT ::= t0 | t1⟪0 ‥ 1⟫\n└\n", "scope");
    REQUIRE(read.defects.empty());
    return read.sections;
  }
  template <class Ask>
  std::string decided(Ask&& ask) {
    steps_ = Steps(most_steps_);
    try {
      return ask();
    } catch (const EvaluationError&) {
      return {};
    } catch (const StepsSpent&) {
      return {};
    }
  }

  std::uint64_t most_steps_;
  Steps steps_;
  Evaluator evaluator_;
};

/// A kind of variable: the sets from which it is declared, the values gone through, and what bounds it to them.
struct VariableKind {
  const char* declared;
  const char* gone_through;
  std::vector<std::string> bounds, atoms;
};

const std::vector<VariableKind>& variable_kinds() {
  static const std::vector<VariableKind> all = {
      {"seq (0 ‥ 2)",
       "({⟨⟩} ∪ {a : 0 ‥ 2 • ⟨a⟩} ∪ {a, b : 0 ‥ 2 • ⟨a, b⟩})",
       {"# v ≤ 2", "# v < 3", "2 ≥ # v", "3 > # v", "(# v = 2 ∨ # v ≤ 1)", "0 ≤ # v < 3"},
       {"# v = 1", "v prefix ⟨0, 1, 2⟩", "head v = 1", "1 ∈ ran v", "v = rev v", "v ⁀ ⟨1⟩ = ⟨1⟩ ⁀ v", "last v > head v",
        "(∀ i : dom v • v i ≥ 1)", "v 1 ≠ v 2", "ran v ⊆ {0, 2}", "(∃ w : seq (0 ‥ 2) • w ⁀ w = v)",
        "(∃ w : seq ℕ • v = ⟨1⟩ ⁀ w ∧ # w ≤ 3)", "v ∈ iseq (0 ‥ 2)", "v ∈ ⦃⦄"}},
      {"seq ℕ",
       "({⟨⟩, ⟨0⟩, ⟨1⟩, ⟨2⟩, ⟨0, 1⟩, ⟨1, 2⟩, ⟨0, 1, 2⟩})",
       {"v infix ⟨0, 1, 2⟩", "(∃ w, u : seq ℕ • w ⁀ v ⁀ u = ⟨0, 1, 2⟩)",
        "v ∈ {⟨⟩, ⟨0⟩, ⟨1⟩, ⟨2⟩, ⟨0, 1⟩, ⟨1, 2⟩, ⟨0, 1, 2⟩}", "(v prefix ⟨0, 1, 2⟩ ∨ v suffix ⟨0, 1, 2⟩ ∨ v = ⟨1⟩)"},
       {"# v ≥ 2", "head v = 1", "1 ∈ ran v", "v ⁀ ⟨2⟩ = ⟨0, 1, 2⟩", "⟨0⟩ ⁀ v prefix ⟨0, 1⟩", "last v = 2", "v ≠ ⟨⟩"}},
      {"ℙ ℕ",
       "ℙ (1 ‥ 3)",
       {"v ⊆ 1 ‥ 3", "v ∪ {1} = v ∪ {1} ∧ v ∪ {3} ⊆ 1 ‥ 3", "(∃ w : ℙ ℕ • v ∪ w = {1, 2, 3})", "v ∈ ℙ (1 ‥ 3)",
        "(v ⊂ {1, 2, 3} ∨ v ∪ ∅ = {1, 2, 3})"},
       {"1 ∈ v", "# v = 2", "# v ≤ 1", "v ⊆ {2, 3}", "v ∪ {1} = {1, 2}", "v ∩ {1, 2} = {1}", "min v = 2", "max v > 2",
        "(∃ w : ℙ ℕ • w ⊂ v ∧ # w = 1)", "(∀ n : v • n ≥ 2)", "v ⊂ 1 ‥ 2", "(∃ n : ℕ • n ∈ v ∧ n mod 2 = 0)"}},
      {"0 ‥ 1 ⇸ ℕ",
       "(0 ‥ 1 ⇸ 0 ‥ 2)",
       {"v ⊆ (0 ‥ 1) × (0 ‥ 2)", "v ∈ 0 ‥ 1 ⇸ 0 ‥ 2"},
       {"v 0 = 1", "dom v = {0}", "ran v ⊆ {1}", "# v = 1", "v ∈ 0 ‥ 1 → ℕ", "v⦇{0}⦈ = {2}", "v 0 < v 1",
        "v ⊕ {0 ↦ 1} = v", "(∃ n : ℕ • v n = n)", "v∼ ∈ ℕ ⇸ ℕ"}},
      {"0 ‥ 1 → 0 ‥ 2",
       "({a, b : 0 ‥ 2 • {(0, a), (1, b)}})",
       {"true", "v ⊆ (0 ‥ 1) × (0 ‥ 2)"},
       {"v 0 = 1", "v 0 < v 1", "ran v = {2}", "v ∈ 0 ‥ 1 ↣ ℕ", "(∃ n : ℕ • v n = n + 1)"}},
      {"0 ‥ 1 ⇸ 0 ‥ 300",  // the functions are too many to be listed: they grow
       "(0 ‥ 1 ⇸ 0 ‥ 2)",
       {"(∀ i : 0 ‥ 1 • i ∉ dom v ∨ v i ≤ 2)", "(∀ i : dom v • v i ∈ 0 ‥ 2)", "ran v ⊆ 0 ‥ 2"},
       {"v 0 = 1", "0 ∈ dom v", "v 1 = v 0", "(0, 1) ∈ v", "dom v = {0}", "# v = 1", "v⦇{0}⦈ = {2}", "v 0 < v 1",
        "(∃ n : 0 ‥ 2 • (1, n) ∈ v)", "v ⊕ {0 ↦ 1} = v", "1 ∈ ran v", "(let n == v 0 • n > 1)", "1 ∉ dom v"}},
      {"0 ‥ 2 ↣ 0 ‥ 50",
       "(0 ‥ 2 ↣ 0 ‥ 3)",
       {"v 0 ≤ 3 ∧ v 1 ≤ 3 ∧ v 2 ≤ 3", "(∀ i : 0 ‥ 2 • v i < 4)", "(∀ i : dom v • v i * v i < 10)"},
       {"v 0 = 1", "v 0 < v 1", "v 1 ≠ v 2 + 1", "(∀ i, j : 0 ‥ 2 | i < j • v i < v j)", "ran v = 1 ‥ 3",
        "{i : 0 ‥ 1 • v i} = {0, 2}", "v (v 0) = 0", "(∃ i : 0 ‥ 2 • v i = i)", "(v∼) 2 = 0", "v 3 = 1"}},
      {"T", "{t0, t1 0, t1 1}", {"true"}, {"v = t0", "(∃ n : 0 ‥ 1 • v = t1 n)", "v ∈ ran t1", "v ≠ t1 0"}},
  };
  return all;
}

std::string random_predicate(const VariableKind& kind, Random& random, int depth) {
  if (depth == 0 || random.below(3) == 0) {
    const std::string& atom = random.one_of(kind.atoms);
    return atom == "v ∈ ⦃⦄" ? "v = ⟨⟩" : atom;
  }
  const std::string p = random_predicate(kind, random, depth - 1);
  const std::string q = random_predicate(kind, random, depth - 1);
  switch (random.below(5)) {
    case 0:
      return fmt::format("(¬ {})", p);
    case 1:
      return fmt::format("({} ∨ {})", p, q);
    case 2:
      return fmt::format("({} ⇒ {})", p, q);
    default:
      return fmt::format("({} ∧ {})", p, q);
  }
}

/// The values gone through of which it is so; nothing where it is not decided of one.
std::optional<std::vector<Value>> those_of_scope(ScopeAnswers& oracle, const VariableKind& kind,
                                                 const std::string& said) {
  std::vector<Value> right;
  const Value all = oracle.listed(kind.gone_through);
  for (const Value& each : *all.set()->members()) {
    const std::string here = oracle.truth(said, {{Name{"v", ""}, each}});
    if (here.empty()) return std::nullopt;
    if (here == "true") right.push_back(each);
  }
  return right;
}

/// Asks a random question; counts it, and fails where the answer is wrong.
void ask_of(ScopeAnswers& oracle, const VariableKind& kind, Random& random, std::size_t& asked, std::size_t& open) {
  const std::string p = random_predicate(kind, random, 2), bound = random.one_of(kind.bounds);
  const auto right = those_of_scope(oracle, kind, p);
  if (!right) return;
  const std::size_t all = oracle.listed(kind.gone_through).set()->members()->size();
  const auto say = [](bool truth) { return std::string(truth ? "true" : "false"); };
  std::string z, said, expected;
  switch (random.below(5)) {
    case 0:
      z = fmt::format("∃ v : {} • {} ∧ {}", kind.declared, bound, p);
      said = oracle.truth(z);
      expected = say(!right->empty());
      break;
    case 1:
      z = fmt::format("∀ v : {} | {} • {}", kind.declared, bound, p);
      said = oracle.truth(z);
      expected = say(right->size() == all);
      break;
    case 2:
      z = fmt::format("∃₁ v : {} • {} ∧ {}", kind.declared, p, bound);
      said = oracle.truth(z);
      expected = say(right->size() == 1);
      break;
    case 3:
      z = fmt::format("∃ v : {} • {}", kind.declared, p);
      said = oracle.truth(z);
      expected = right->empty() ? said : "true";  // there may be one further on
      break;
    default:
      z = fmt::format("{{v : {} | {} ∧ {}}}", kind.declared, p, bound);
      said = oracle.value(z);
      expected = Value::set(*right).text();
      break;
  }
  ++asked;
  open += said.empty() ? 1 : 0;
  if (!said.empty() && said != expected) FAIL_CHECK(z << "\n  is " << expected << " and not " << said);
}

TEST_CASE("what is searched for of sets, sequences and functions is what is found by going through") {
  ScopeAnswers oracle;
  for (const VariableKind& kind : variable_kinds()) {
    Random random(scope_seed());
    std::size_t asked = 0, open = 0;
    const std::size_t questions = durero::test::fewer_when_sanitized(300);
    for (std::size_t i = 0; i < questions; ++i) ask_of(oracle, kind, random, asked, open);
    INFO(kind.declared << ": " << open << " of " << asked << " not decided");
    CHECK(asked > 0);
    CHECK(open * 3 <= asked);
  }
}

/// A relation of numbers as a rule, and the same of the numbers of a small scope alone.
struct NumberRule {
  std::string rule, listed;
};

NumberRule random_rule(Random& random, int depth) {
  static const std::vector<NumberRule> rules = {
      {"succ", "{x : 0 ‥ 90 • (x, x + 1)}"},
      {"(λ x : ℕ • 2 * x)", "{x : 0 ‥ 90 • (x, 2 * x)}"},
      {"(λ x : ℕ | x > 2 • x - 2)", "{x : 3 ‥ 90 • (x, x - 2)}"},
      {"{x : ℕ • (x, x + 3)}", "{x : 0 ‥ 90 • (x, x + 3)}"},
      {"{x : ℕ; y : 0 ‥ 1 • (x, x + y)}", "{x : 0 ‥ 90; y : 0 ‥ 1 • (x, x + y)}"},
      {"{x, y : ℕ | y = 5}", "{x, y : 0 ‥ 90 | y = 5}"},
      {"(ℕ × {3})", "((0 ‥ 90) × {3})"},
      {"(id ℕ)", "(id (0 ‥ 90))"},
      {"{1 ↦ 4, 2 ↦ 7, 2 ↦ 1}", "{1 ↦ 4, 2 ↦ 7, 2 ↦ 1}"},
  };
  if (depth == 0) return random.one_of(rules);
  const NumberRule a = random_rule(random, depth - 1), b = random_rule(random, depth - 1);
  static const std::vector<const char*> binary = {"({} ⨾ {})", "({} ∘ {})", "({} ⊕ {})",
                                                  "({} ∪ {})", "({} ∩ {})", "({} ∖ {})"};
  static const std::vector<const char*> unary = {"({{1, 2}} ◁ {})", "({{1, 2}} ⩤ {})", "({} ▷ {{3, 4, 5}})",
                                                 "({} ⩥ {{3, 4, 5}})", "({} ∼)"};
  if (random.below(2) == 0) {
    const char* form = random.one_of(unary);
    return {fmt::format(fmt::runtime(form), a.rule), fmt::format(fmt::runtime(form), a.listed)};
  }
  const char* form = random.one_of(binary);
  return {fmt::format(fmt::runtime(form), a.rule, b.rule), fmt::format(fmt::runtime(form), a.listed, b.listed)};
}

// At 0‥6 no rule leads beyond 90, but for what is inverted: its questions are of numbers that few steps reach.
TEST_CASE("a rule relates what the same relation of a small scope does") {
  ScopeAnswers oracle;
  Random random(scope_seed());
  std::size_t open = 0;
  const std::size_t questions = durero::test::fewer_when_sanitized(600);
  for (std::size_t i = 0; i < questions; ++i) {
    const NumberRule of = random_rule(random, 1 + static_cast<int>(random.below(2)));
    const std::size_t at = random.below(7), to = random.below(9);
    static const std::vector<const char*> forms = {"{0} {1}", "({1}, {2}) ∈ {0}", "{1} ∈ dom {0}", "{2} ∈ ran {0}",
                                                   "{0}⦇{{{1}, {2}}}⦈"};
    const char* form = random.one_of(forms);
    const auto z = [&](const std::string& relation) { return fmt::format(fmt::runtime(form), relation, at, to); };
    const bool is_value = std::string(form).find("∈") == std::string::npos;
    const std::string said = is_value ? oracle.value(z(of.rule)) : oracle.truth(z(of.rule));
    const std::string right = is_value ? oracle.value(z(of.listed)) : oracle.truth(z(of.listed));
    open += said.empty() ? 1 : 0;
    if (!said.empty() && said != right) FAIL_CHECK(z(of.rule) << "\n  is " << right << " and not " << said);
  }
  INFO(open << " of " << questions << " not decided");
  CHECK(open * 4 <= questions);
}

/// A set of integers, and which of −20‥20 it has: beyond −10 and 10 nothing changes.
struct IntegerSet {
  std::string z;
  std::function<bool(int)> has;
};

std::string numeral(int n) { return n < 0 ? fmt::format("(-({}))", -n) : std::to_string(n); }

IntegerSet random_integers(Random& random, int depth) {
  const int low = static_cast<int>(random.below(9)) - 4, high = low + static_cast<int>(random.below(5));
  if (depth == 0 || random.below(4) == 0) switch (random.below(7)) {
      case 0:
        return {"ℕ", [](int n) { return n >= 0; }};
      case 1:
        return {"ℕ₁", [](int n) { return n >= 1; }};
      case 2:
        return {"ℤ", [](int) { return true; }};
      case 3:
        return {fmt::format("{{x : ℤ | x < {}}}", numeral(low)), [low](int n) { return n < low; }};
      case 4:
        return {fmt::format("{{x : ℕ | x * x > {}}}", numeral(high)), [high](int n) { return n >= 0 && n * n > high; }};
      case 5:
        return {fmt::format("({} ‥ {})", numeral(low), numeral(high)),
                [low, high](int n) { return low <= n && n <= high; }};
      default:
        return {fmt::format("{{{}, {}}}", numeral(low), numeral(high)),
                [low, high](int n) { return n == low || n == high; }};
    }
  const IntegerSet a = random_integers(random, depth - 1), b = random_integers(random, depth - 1);
  switch (random.below(4)) {
    case 0:
      return {fmt::format("({} ∩ {})", a.z, b.z), [a, b](int n) { return a.has(n) && b.has(n); }};
    case 1:
      return {fmt::format("({} ∖ {})", a.z, b.z), [a, b](int n) { return a.has(n) && !b.has(n); }};
    case 2:
      return {fmt::format("(⋃ {{{}, {}}})", a.z, b.z), [a, b](int n) { return a.has(n) || b.has(n); }};
    default:
      return {fmt::format("({} ∪ {})", a.z, b.z), [a, b](int n) { return a.has(n) || b.has(n); }};
  }
}

constexpr int furthest_integer = 20;

std::string least_of(const IntegerSet& of, int sign) {
  for (int n = -furthest_integer; n <= furthest_integer; ++n)
    if (of.has(sign * n)) return n == -furthest_integer ? "undefined" : std::to_string(sign * n);
  return "undefined";
}

std::string size_of(const IntegerSet& of) {
  int members = 0;
  for (int n = -furthest_integer; n <= furthest_integer; ++n) members += of.has(n) ? 1 : 0;
  const bool infinite = of.has(-furthest_integer) || of.has(furthest_integer);
  return infinite ? "undefined" : std::to_string(members);
}

bool at_every(const std::function<bool(int)>& is_so) {
  for (int n = -furthest_integer; n <= furthest_integer; ++n)
    if (!is_so(n)) return false;
  return true;
}

TEST_CASE("sets of integers without a list are compared, counted and bounded as their members are") {
  ScopeAnswers oracle;
  Random random(scope_seed());
  std::size_t open = 0;
  const std::size_t questions = durero::test::fewer_when_sanitized(1500);
  for (std::size_t i = 0; i < questions; ++i) {
    const IntegerSet a = random_integers(random, 2), b = random_integers(random, 1);
    const auto say = [](bool truth) { return std::string(truth ? "true" : "false"); };
    const bool inside = at_every([&](int n) { return !a.has(n) || b.has(n); });
    const bool same = at_every([&](int n) { return a.has(n) == b.has(n); });
    std::string z, right;
    switch (random.below(6)) {
      case 0:
        z = fmt::format("{} = {}", a.z, b.z), right = say(same);
        break;
      case 1:
        z = fmt::format("{} ⊆ {}", a.z, b.z), right = say(inside);
        break;
      case 2:
        z = fmt::format("{} ⊂ {}", a.z, b.z), right = say(inside && !same);
        break;
      case 3:
        z = "min (" + a.z + ")", right = least_of(a, 1);
        break;
      case 4:
        z = "max (" + a.z + ")", right = least_of(a, -1);
        break;
      default:
        z = "# (" + a.z + ")", right = size_of(a);
        break;
    }
    const bool is_value = z.starts_with("m") || z.starts_with("#");
    const std::string said = is_value ? oracle.value(z) : oracle.truth(z);
    open += said.empty() ? 1 : 0;
    if (!said.empty() && said != right) FAIL_CHECK(z << "\n  is " << right << " and not " << said);
  }
  INFO(open << " of " << questions << " not decided");
  CHECK(open * 20 <= questions);
}

TEST_CASE("a witness, or a value against, of any kind is looked for among small ones, and proves what it shows") {
  ScopeAnswers asked;
  CHECK(asked.truth("∃ f : 1 ‥ 2 → ℕ • f 1 = 3 ∧ f 2 = 4") == "true");
  CHECK(asked.truth("∃ x, y, z : ℕ₁ • x * x + y * y = z * z") == "true");
  CHECK(asked.truth("∃ x : ℕ • x mod 7 = 3") == "true");
  CHECK(asked.truth("∃ x : ℕ • x div 10 = 123") == "");
  CHECK(asked.truth("∃ x : ℕ • x * x * x = 8000000 ∧ x > 199") == "true");
  CHECK(asked.truth("∃ A : ℙ (1 ‥ 30) • # A = 2") == "true");
  CHECK(asked.truth("∃ s : 𝔽 ℕ • # s = 2 ∧ (∀ n, m : s • n - m ≤ 1)") == "true");
  CHECK(asked.truth("∀ s, t : seq ℕ • s ⁀ t = t ⁀ s") == "false");
  CHECK(asked.truth("∀ s, t : seq ℕ • # (s ⁀ t) = # s + # t") == "");
  CHECK(asked.truth("∀ x : ℕ • ∃ y : ℕ • y = x + 1") == "true");
  CHECK(asked.truth("∀ x : ℕ • ∃ y : ℕ • y = x - 1") == "false");
}

TEST_CASE("members of a bounded size are all gone through") {
  ScopeAnswers asked;
  CHECK(asked.truth("∃ s : seq {1, 2} • # s = 3 ∧ s 1 ≠ s 2") == "true");
  CHECK(asked.truth("∃ s : seq {1, 2} • # s ≤ 3 ∧ s = s ⁀ s ∧ s ≠ ⟨⟩") == "false");
  CHECK(asked.value("# {s : seq {1, 2} | # s ≤ 2}") == "7");
  CHECK(asked.value("# {s : seq {1, 2} | # s < 2}") == "3");
  CHECK(asked.value("# {s : seq₁ {1, 2} | # s ≤ 2}") == "6");
  CHECK(asked.value("# (iseq {1, 2, 3})") == "16");
  CHECK(asked.value("# {s : ℙ ℕ | s ⊆ 1 ‥ 2}") == "4");
  CHECK(asked.value("# {s : ℙ (1 ‥ 30) | # s ≤ 2}") == "466");  // 1 + 30 + 30 · 29 / 2
  CHECK(asked.value("# {s, t : seq ℕ | s ⁀ t = ⟨1, 2, 3⟩}") == "4");
  CHECK(asked.value("# {s, t : ℙ ℕ | s ∪ t = {1, 2}}") == "9");
  CHECK(asked.value("{x, y : ℕ | y < x < 3}") == "{1 ↦ 0, 2 ↦ 0, 2 ↦ 1}");
  CHECK(asked.value("# {s : seq ℕ | s prefix ⟨1⟩ ∨ s = ⟨7⟩}") == "3");
  CHECK(asked.truth("∃ s : seq ℕ • (s prefix ⟨1⟩ ∨ # s = 3) ∧ # s > 2") == "true");
  CHECK(asked.value("# {f : 1 ‥ 3 ⇸ 1 ‥ 3 | # f ≤ 1}") == "10");
}

TEST_CASE("functions between finite sets are gone through, but for beginnings that make it false") {
  ScopeAnswers asked(20'000'000);
  const std::string queens = "∀ i, j : 1 ‥ 9 | i < j • q j - q i ≠ j - i ∧ q j - q i ≠ i - j";
  CHECK(asked.value("# {q : 1 ‥ 9 ⤖ 1 ‥ 9 | q 1 = 5 ∧ (" + queens + ")}") == "54");  // of 352, by the first queen
  CHECK(asked.truth("∃ q : 1 ‥ 9 ⤖ 1 ‥ 9 • q 1 = q 9 + 1 ∧ q 2 = q 1 + 1 ∧ (" + queens + ")") == "false");
  CHECK(asked.value("# {f : 1 ‥ 5 → 1 ‥ 12 | ∀ i : 1 ‥ 4 • f i ≤ f (i + 1)}") == "4368");  // 16 over 5
  CHECK(asked.value("# {f : 1 ‥ 5 ↣ 1 ‥ 12 | ∀ i : 1 ‥ 4 • f i < f (i + 1)}") == "792");   // 12 over 5
  CHECK(asked.value("# {f : 1 ‥ 9 ↠ 1 ‥ 4 | ∀ i : 1 ‥ 8 • f i ≤ f (i + 1)}") == "56");     // 8 over 3
  CHECK(asked.value("# {c : 1 ‥ 11 → 1 ‥ 3 | (∀ i : 1 ‥ 9 • c i ≠ c (i + 1)) ∧ c 10 ≠ c 1 ∧ c 11 = 1}") == "1026");
  CHECK(asked.value("# {f : 1 ‥ 6 ⤔ 1 ‥ 9 | ∀ i : 1 ‥ 6 • i ∉ dom f ∨ f i < 3}") == "43");  // 1 + 2 · 6 + 6 · 5
  CHECK(asked.truth("∃ f : 1 ‥ 3 → ℕ • f 1 + f 2 = 10 ∧ f 2 * f 3 = 12 ∧ f 3 > f 2") == "true");
  CHECK(asked.truth("∃ f : 1 ‥ 3 → ℕ • f 1 + f 2 = 10 ∧ f 2 * f 3 = 12 ∧ f 3 > 500") == "");
  CHECK(asked.truth("∃ s : seq (1 ‥ 100) • # s = 3 ∧ s 1 * s 2 * s 3 = 1001 ∧ s 1 < s 2 ∧ s 2 < s 3") == "true");
  CHECK(asked.truth("∃ s : seq ℕ • # s = 4 ∧ s 1 + s 2 = 20 ∧ s 2 * s 3 = 30 ∧ s 4 = 9") == "true");
  CHECK(asked.truth("∃ s : seq (1 ‥ 100) • # s = 6 ∧ s 1 = 7 ∧ s 2 = 9") == "true");
  CHECK(asked.truth("∀ f : 1 ‥ 90000 → {7} • f 5 = 7 ∧ # f = 90000") == "true");  // of one function nothing grows
  CHECK(asked.truth("∃ f : 1 ‥ 90000 → 1 ‥ 2 • f 5 = 3") == "");
  CHECK(asked.truth("∃ f : 1 ‥ 60000 ⤔ {7} • f 5 = 8") == "");
  CHECK(asked.truth("(1 ‥ 2 ↣ {7}) = ∅ ∧ (1 ‥ 2 → ∅) = ∅ ∧ (1 ‥ 2 ⇸ ∅) = {∅} ∧ (∅ ↠ {7}) = ∅") == "true");
  CHECK(asked.truth("(1 ‥ 2 ↠ 1 ‥ 2) = {{1 ↦ 1, 2 ↦ 2}, {1 ↦ 2, 2 ↦ 1}}") == "true");
  CHECK(asked.truth("∃ s : iseq (1 ‥ 20) • # s = 5 ∧ (∀ i : 1 ‥ 4 • s (i + 1) > 2 * s i)") == "");
  CHECK(ScopeAnswers().truth("∃ f : 1 ‥ 20 → 1 ‥ 20 • f (f 1 + f 20) = 21") == "");  // there are too many
}

TEST_CASE("a set of pairs is written as a sequence where it was made, or is declared, as one") {
  ScopeAnswers asked;
  CHECK(asked.value("⟨3, 3⟩") == "⟨3, 3⟩");
  CHECK(asked.value("{1, 2} × {3}") == "{1 ↦ 3, 2 ↦ 3}");
  CHECK(asked.value("id {1, 2}") == "{1 ↦ 1, 2 ↦ 2}");
  CHECK(asked.value("{1 ↦ 2} ⊕ {1 ↦ 3}") == "{1 ↦ 3}");
  CHECK(asked.value("⟨1⟩ ⁀ tail ⟨2, 3⟩") == "⟨1, 3⟩");
  CHECK(asked.value("tail ⟨2⟩") == "⟨⟩");
  CHECK(asked.value("{s : seq {1} | # s ≤ 1}") == "{⟨⟩, ⟨1⟩}");
  CHECK(asked.value("({1, 2} × {3}, ⟨3, 3⟩)") == "({1 ↦ 3, 2 ↦ 3}, ⟨3, 3⟩)");
  CHECK(asked.truth("{1, 2} × {3} = ⟨3, 3⟩") == "true");
  CHECK(asked.truth("∅ = ⟨⟩") == "true");
}

/// An expression with a value at random, of a kind by its depth.
std::string random_value(Random& random, int depth) {
  const auto inner = [&] { return random_value(random, depth - 1); };
  if (depth == 0) return std::to_string(random.below(4));
  const std::string a = inner();
  switch (random.below(6)) {
    case 0:
      return fmt::format("⟨{}⟩ ⁀ tail ⟨{}⟩", a, a);
    case 1:
      return fmt::format("{{{}}}", a);
    case 2:
      return fmt::format("({}, {})", a, random.below(4));
    case 3:
      return fmt::format("{{{} ↦ {}}}", random.below(3), a);
    case 4:
      return fmt::format("⦉p == {}, q == {}⦊", a, random.below(4));
    default:
      return fmt::format("⟨{0}, {0}⟩", a);
  }
}

TEST_CASE("a value that is written is read back as the same, and is written so again") {
  ScopeAnswers asked;
  Random random(scope_seed());
  for (std::size_t i = 0; i < durero::test::fewer_when_sanitized(300); ++i) {
    const std::string z = random_value(random, 1 + static_cast<int>(random.below(4)));
    const std::string written = asked.value(z);
    INFO(z << " is written " << written);
    CHECK(asked.truth(fmt::format("({}) = ({})", z, written)) == "true");
    CHECK(asked.value(written) == written);
  }
}

TEST_CASE("what is made of infinite functions is applied") {
  ScopeAnswers asked;
  CHECK(asked.value("(succ ∘ succ) 3") == "5");
  CHECK(asked.value("succ (-(1))") == "undefined");
  CHECK(asked.value("((λ x : ℕ • x * x) ⊕ {1 ↦ 7}) 3") == "9");
  CHECK(asked.value("((λ x : ℕ • x * x) ⊕ {1 ↦ 7}) 1") == "7");
  CHECK(asked.value("{x : ℕ • (x, x + 1)} 0") == "1");
  CHECK(asked.value("{x : ℕ; y : 1 ‥ 5 | y < x • (x, x + y)} 3") == "undefined");
  CHECK(asked.value("(succ ∼) 5") == "4");
  CHECK(asked.value("(succ ∼) 0") == "undefined");
  CHECK(asked.truth("2 ∈ ran {x : ℕ • (x, x + 2)}") == "true");
  CHECK(asked.truth("1 ∈ ran {x : ℕ • (x, x + 2)}") == "false");
  CHECK(asked.truth("t0 ∈ ran t1") == "false");
  CHECK(asked.value("((1 ‥ 10) × {3}) 10") == "3");
  CHECK(asked.value("((1 ‥ 10) × {3, 4}) 1") == "undefined");
}

TEST_CASE("the sizes of sets that nobody lists are counted") {
  ScopeAnswers asked;
  CHECK(asked.value("# (ℙ (1 ‥ 40))") == "1099511627776");
  for (const auto& [set, size] : std::map<std::string, std::string>{{"1 ‥ 9 ↔ 1 ‥ 9", "2417851639229258349412352"},
                                                                    {"1 ‥ 9 ⇸ 1 ‥ 9", "1000000000"},
                                                                    {"1 ‥ 9 → 1 ‥ 9", "387420489"},
                                                                    {"1 ‥ 9 ⤔ 1 ‥ 9", "17572114"},
                                                                    {"1 ‥ 7 ↣ 1 ‥ 9", "181440"},
                                                                    {"1 ‥ 9 ↠ 1 ‥ 5", "834120"},   // 5! · S(9, 5)
                                                                    {"1 ‥ 9 ⤀ 1 ‥ 5", "2739240"},  // 5! · S(10, 6)
                                                                    {"1 ‥ 10 ⤖ 1 ‥ 10", "3628800"},
                                                                    {"1 ‥ 30 ↣ 1 ‥ 9", "0"},
                                                                    {"1 ‥ 4 ↠ 1 ‥ 3", "36"},
                                                                    {"∅ ↠ {1}", "0"},
                                                                    {"∅ → ∅", "1"}}) {
    INFO(set);
    CHECK(asked.value("# (" + set + ")") == size);
  }
  CHECK(asked.value("# (ℙ₁ (1 ‥ 40))") == "1099511627775");
  CHECK(asked.value("# (1 ‥ 1000000000)") == "1000000000");
  CHECK(asked.value("# ((1 ‥ 1000000000) × {1, 2})") == "2000000000");
  CHECK(asked.truth("∅ × {1} = (1 ‥ 1000000000) × ∅") == "true");
  CHECK(asked.value("# T") == "3");
  CHECK(asked.truth("∀ x : 1 ‥ 1000000000 • x > 0") == "true");
}

TEST_CASE("sets that cannot be listed stand in the order of their words") {
  ScopeAnswers answers;
  const std::string a = "{x : ℕ | x mod 3 = 1}", b = "{x : ℕ | x mod 5 = 2}", c = "{x : ℕ | x mod 7 = 3}";
  const std::string sorted = answers.listed("{" + a + ", " + b + ", " + c + "}").text();
  for (int i = 0; i < 20; ++i) {
    CHECK(answers.listed("{" + c + ", " + a + ", " + b + "}").text() == sorted);
    CHECK(answers.listed("{" + b + ", " + c + ", " + a + "}").text() == sorted);
  }
}

TEST_CASE("constant functions on ℕ, and those with other values at few places, are tried") {
  ScopeAnswers answers;
  for (const char* predicate :
       {"∃ f : ℕ → ℕ • f 0 = 3", "∃ f : ℕ → ℕ • f 5 = f 6 + 1", "∃ f : ℕ₁ → 0 ‥ 1 • f 1 = 1 ∧ f 2 = 0",
        "∃ f : ℕ → ℕ • f 100 = 70 ∧ f 2 = 0", "∃ f : ℕ → T • f 0 = t0 ∧ f 1 ≠ t0", "∃ f : ℕ → ℕ • # (ran f) = 2",
        "∃ f : ℤ → ℕ • f 0 = 3", "∃ f : ℕ ↣ ℕ • f 0 = 3"}) {
    INFO(predicate);
    CHECK(answers.truth(predicate) == "true");
  }
  CHECK(answers.truth("∀ f : ℕ → ℕ • f 0 = f 1") == "false");
  for (const char* predicate :
       {"∃ f : ℕ ↣ ℕ • f 0 = 50", "∃ f : ℕ → ℕ • f 0 = - 1", "∃ f : ℕ → ℕ • ∀ n : ℕ • f n > n * n",
        "∃ f : ℤ → T • f 0 = t0", "∀ f : ℕ → ℕ • f 0 ≥ 0"}) {
    INFO(predicate);
    CHECK(answers.truth(predicate) == "");
  }
}

}  // namespace
}  // namespace durero::zed::test
