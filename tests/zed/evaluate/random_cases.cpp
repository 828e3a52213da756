#include "zed/evaluate/random_cases.hpp"

#include <fmt/format.h>

#include <memory>

namespace durero::zed::test {
namespace {

using Meaning = std::function<std::optional<Number>(Number)>;

constexpr Number furthest = 40;  // a recursion from a greater argument is left out

/// A line of a box, and the boxes.
std::string box(const std::string& declared, const std::vector<std::string>& lines) {
  std::string text = "╷\n" + declared + "\n|\n";
  for (const std::string& line : lines) text += line + "\n";
  return text + "└\n\n";
}

/// What a clause says of n, and of the value `before` of the function one step earlier.
struct Step {
  std::string z;  ///< with {0} for that value
  std::function<Number(Number n, Number before)> value;
};

const std::vector<Step>& steps() {
  static const std::vector<Step> all = {
      {"{0} + 1", [](Number, Number before) { return before + 1; }},
      {"{0} + n", [](Number n, Number before) { return before + n; }},
      {"(2 * {0} + 1) mod 7", [](Number, Number before) { return (2 * before + 1) % 7; }},
      {"(n + 1) * {0} mod 11", [](Number n, Number before) { return (n + 1) * before % 11; }},
      {"7", [](Number, Number) { return 7; }},
      {"n", [](Number n, Number) { return n; }},
      {"3 - {0}", [](Number, Number before) { return 3 - before; }},
  };
  return all;
}

/// f(0) = c, f(1) = d, …, f(n + k) by a step from f(n).
Function recursive(const std::string& name, Random& random, std::string& text) {
  const std::size_t bases = 1 + random.below(2);
  std::vector<Number> first;
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < bases; ++i) {
    first.push_back(static_cast<Number>(random.below(4)));
    lines.push_back(fmt::format("{} {} = {}", name, i, first.back()));
  }
  const Step& step = random.one_of(steps());
  const std::string before = fmt::format("{}(n)", name);
  lines.push_back(fmt::format("∀ n : ℕ • {}(n + {}) = {}", name, bases, fmt::format(fmt::runtime(step.z), before)));
  text += box(name + " : ℕ → ℤ", lines);
  const auto by = static_cast<Number>(bases);
  return {name, [first, by, value = step.value](Number at) -> std::optional<Number> {
            if (at < 0) return std::nullopt;
            if (at > furthest) throw TooFar();
            Number here = first[static_cast<std::size_t>(at % by)];
            for (Number n = at % by; n < at; n += by) here = value(n, here);
            return here;
          }};
}

/// Two clauses with guards, which may leave some arguments out.
Function guarded(const std::string& name, Random& random, std::string& text) {
  const auto low = static_cast<Number>(random.below(4));
  const Number high = low + static_cast<Number>(random.below(2));
  const Step *below = &random.one_of(steps()), *above = &random.one_of(steps());
  const bool implied = random.below(2) == 0;
  const auto value = [](const Step& step) { return fmt::format(fmt::runtime(step.z), "2"); };
  const char* form = implied ? "∀ n : ℕ • n {} {} ⇒ {}(n) = {}" : "∀ n : ℕ | n {} {} • {}(n) = {}";
  text += box(name + " : ℕ ⇸ ℤ", {fmt::format(fmt::runtime(form), "<", low, name, value(*below)),
                                  fmt::format(fmt::runtime(form), "≥", high, name, value(*above))});
  return {name, [low, high, below, above](Number at) -> std::optional<Number> {
            if (at < 0) return std::nullopt;
            if (at < low) return below->value(at, 2);
            return at >= high ? std::optional(above->value(at, 2)) : std::nullopt;
          }};
}

/// f = λ n : ℕ | n > c • …, or with a choice.
Function lambda(const std::string& name, Random& random, std::string& text) {
  const auto least = static_cast<Number>(random.below(3));
  const Step *step = &random.one_of(steps()), *other = &random.one_of(steps());
  const bool chooses = random.below(2) == 0;
  const auto value = [](const Step& of) { return fmt::format(fmt::runtime(of.z), "2"); };
  text +=
      box(name + " : ℕ ⇸ ℤ",
          {chooses ? fmt::format("{} = (λ n : ℕ • if n < {} then {} else {})", name, least, value(*step), value(*other))
                   : fmt::format("{} = (λ n : ℕ | n ≥ {} • {})", name, least, value(*step))});
  return {name, [least, step, other, chooses](Number at) -> std::optional<Number> {
            if (at < 0) return std::nullopt;
            if (chooses) return at < least ? step->value(at, 2) : other->value(at, 2);
            return at >= least ? std::optional(step->value(at, 2)) : std::nullopt;
          }};
}

/// p(0, n) = …, p(m + 1, n) = … from p(m, n).
PairFunction of_pairs(const std::string& name, Random& random, std::string& text) {
  const Step *first = &random.one_of(steps()), *next = &random.one_of(steps());
  text += box(name + " : ℕ × ℕ → ℤ",
              {fmt::format("∀ n : ℕ • {}(0, n) = {}", name, fmt::format(fmt::runtime(first->z), "1")),
               fmt::format("∀ m, n : ℕ • {}(m + 1, n) = {}", name,
                           fmt::format(fmt::runtime(next->z), fmt::format("{}(m, n)", name)))});
  return {name, [first, next](Number m, Number n) -> std::optional<Number> {
            if (m < 0 || n < 0) return std::nullopt;
            if (m > furthest) throw TooFar();
            Number here = first->value(n, 1);
            for (Number i = 0; i < m; ++i) here = next->value(n, here);
            return here;
          }};
}

/// 0 ∈ S, 1 ∉ S, n + 2 ∈ S as n is, or is not; or by one condition.
NumberSet set(const std::string& name, Random& random, std::string& text) {
  const std::string declared = name + " : ℙ ℕ";
  if (random.below(3) == 0) {
    const auto by = static_cast<Number>(2 + random.below(2));
    text += box(declared, {fmt::format("∀ n : ℕ • n ∈ {} ⇔ n mod {} = 1", name, by)});
    return {name, [by](Number n) { return n >= 0 && n % by == 1; }};
  }
  const bool zero = random.below(2) == 0, one = random.below(2) == 0, turns = random.below(2) == 0;
  text += box(declared, {fmt::format("0 {} {}", zero ? "∈" : "∉", name), fmt::format("1 {} {}", one ? "∈" : "∉", name),
                         fmt::format("∀ n : ℕ • n + 2 ∈ {0} ⇔ {1} n ∈ {0}", name, turns ? "¬" : "")});
  return {name, [zero, one, turns](Number n) {
            if (n < 0) return false;
            if (n > furthest) throw TooFar();
            return (n % 2 == 0 ? zero : one) != (turns && n / 2 % 2 == 1);
          }};
}

Relation relation(const std::string& name, Random& random, std::string& text) {
  const bool recursive = random.below(2) == 0;
  const bool base = random.below(2) == 0;
  std::vector<std::string> lines = {fmt::format("∀ n : ℕ • (0, n) {} {}", base ? "∈" : "∉", name)};
  lines.push_back(recursive ? fmt::format("∀ m, n : ℕ • (m + 1, n) ∈ {0} ⇔ ¬ (m, n) ∈ {0}", name)
                            : fmt::format("∀ m, n : ℕ • (m + 1, n) ∈ {} ⇔ m < n", name));
  text += box(name + " : ℕ ↔ ℕ", lines);
  return {name, [recursive, base](Number m, Number n) {
            if (m < 0 || n < 0) return false;
            if (m > furthest) throw TooFar();
            if (m == 0) return base;
            return recursive ? base == (m % 2 == 0) : m - 1 < n;
          }};
}

/// size, odd and total: of trees and of sequences.
void structured(World& world, Random& random) {
  world.size_of_leaf = static_cast<Number>(random.below(3));
  world.size_of_node = static_cast<Number>(random.below(3));
  world.total_of_none = static_cast<Number>(random.below(3));
  const Step* tip = &random.one_of(steps());
  const auto least = static_cast<Number>(random.below(3));
  world.size_of_tip = [tip](Number n) { return tip->value(n, 1); };
  world.tip_is_odd = [least](Number n) { return n >= least; };
  world.text += "─\nTREE ::= leaf | tip⟪ℕ⟫ | node⟪TREE × TREE⟫\n└\n\n";
  world.text += box("size : TREE → ℤ",
                    {fmt::format("size leaf = {}", world.size_of_leaf),
                     "∀ n : ℕ • size (tip n) = " + fmt::format(fmt::runtime(tip->z), "1"),
                     fmt::format("∀ l, r : TREE • size (node (l, r)) = size l + size r + {}", world.size_of_node)});
  world.text += box("odd : ℙ TREE", {"leaf ∉ odd", fmt::format("∀ n : ℕ • tip n ∈ odd ⇔ n ≥ {}", least),
                                     "∀ l, r : TREE • node (l, r) ∈ odd ⇔ (l ∈ odd ⇔ r ∈ odd)"});
  world.text += box("total : seq ℕ → ℕ", {fmt::format("total ⟨⟩ = {}", world.total_of_none),
                                          "∀ n : ℕ; q : seq ℕ • total (⟨n⟩ ⁀ q) = n + total q"});
}

}  // namespace

std::size_t Random::below(std::size_t end) {
  std::uint64_t z = state_ += 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return (z ^ (z >> 31U)) % end;
}

World random_world(Random& random) {
  World world;
  world.functions.push_back(recursive("f", random, world.text));
  world.functions.push_back(guarded("g", random, world.text));
  world.functions.push_back(lambda("h", random, world.text));
  world.pair_functions.push_back(of_pairs("p", random, world.text));
  world.sets.push_back(set("s", random, world.text));
  world.relations.push_back(relation("r", random, world.text));
  structured(world, random);
  return world;
}

}  // namespace durero::zed::test
