/// Conditions of what a world defines: relations, connectives and quantifiers.

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

#include "zed/evaluate/random_cases.hpp"

namespace durero::zed::test {
namespace {

Values with(Values here, std::size_t place, Number value) {
  here[place] = value;
  return here;
}

constexpr Number last = 2;  // what is counted is in 0‥2

bool at_each(const Condition& is_so, const Values& here, std::size_t place, const std::function<bool(int)>& enough) {
  int so = 0;
  for (Number n = 0; n <= last; ++n) so += is_so.means(with(here, place, n)) ? 1 : 0;
  return enough(so);
}

}  // namespace

Condition Maker::condition(int depth, std::size_t scope) {
  if (depth == 0) return comparison(0, scope);
  const bool binds = scope < variables_.size();
  switch (random_.below(binds ? 10 : 6)) {
    case 0:
    case 1:
      return comparison(depth, scope);
    case 2:
      return membership(depth, scope);
    case 3:
      return in_function(depth, scope);
    case 4:
      return of_trees(depth, scope);
    case 5:
    case 6:
      return connective(depth, scope);
    case 7:
    case 8:
      return quantified(depth, scope);
    default:
      return of_sets(depth, scope);
  }
}

Condition Maker::comparison(int depth, std::size_t scope) {
  struct Row {
    const char* sign;
    bool (*holds)(Number, Number);
  };
  static const std::vector<Row> rows = {{"=", [](Number p, Number q) { return p == q; }},
                                        {"=", [](Number p, Number q) { return p == q; }},
                                        {"≠", [](Number p, Number q) { return p != q; }},
                                        {"<", [](Number p, Number q) { return p < q; }},
                                        {"≥", [](Number p, Number q) { return p >= q; }}};
  const Expression a = expression(std::max(depth - 1, 0), scope), b = expression(std::max(depth - 1, 0), scope);
  const Row row = random_.one_of(rows);
  return {fmt::format("{} {} {}", a.z, row.sign, b.z), [a, b, row](const Values& here) {
            const auto p = a.means(here), q = b.means(here);
            return p && q && row.holds(*p, *q);
          }};
}

Condition Maker::membership(int depth, std::size_t scope) {
  const Expression a = expression(depth - 1, scope), b = expression(depth - 1, scope);
  const bool in = random_.below(3) != 0;
  const char* sign = in ? "∈" : "∉";
  switch (random_.below(4)) {
    case 0: {
      const Relation& of = random_.one_of(world_.relations);
      return {fmt::format("({}, {}) {} {}", a.z, b.z, sign, of.name), [a, b, in, &of](const Values& here) {
                const auto p = a.means(here), q = b.means(here);
                return p && q && of.has(*p, *q) == in;
              }};
    }
    case 1:
      return {fmt::format("{} {} {{1, {}}}", a.z, sign, b.z), [a, b, in](const Values& here) {
                const auto p = a.means(here), q = b.means(here);
                return p && q && (*p == 1 || *p == *q) == in;
              }};
    default: {
      const NumberSet& of = random_.one_of(world_.sets);
      return {fmt::format("{} {} {}", a.z, sign, of.name), [a, in, &of](const Values& here) {
                const auto p = a.means(here);
                return p && of.has(*p) == in;
              }};
    }
  }
}

/// e ∈ dom f and (e, e) ∈ f.
Condition Maker::in_function(int depth, std::size_t scope) {
  const Expression a = expression(depth - 1, scope), b = expression(depth - 1, scope);
  const Function& of = random_.one_of(world_.functions);
  if (random_.below(2) == 0)
    return {fmt::format("{} ∈ dom {}", a.z, of.name), [a, &of](const Values& here) {
              const auto p = a.means(here);
              return p && of.at(*p);
            }};
  return {fmt::format("({} ↦ {}) ∈ {}", a.z, b.z, of.name), [a, b, &of](const Values& here) {
            const auto p = a.means(here), q = b.means(here);
            return p && q && of.at(*p) == q;
          }};
}

Condition Maker::connective(int depth, std::size_t scope) {
  const Condition a = condition(depth - 1, scope), b = condition(depth - 1, scope);
  const auto two = [&](const char* sign, bool (*holds)(bool, bool)) {
    return Condition{fmt::format("({} {} {})", a.z, sign, b.z),
                     [a, b, holds](const Values& here) { return holds(a.means(here), b.means(here)); }};
  };
  switch (random_.below(6)) {
    case 0:
    case 1:
      return two("∧", [](bool p, bool q) { return p && q; });
    case 2:
      return two("∨", [](bool p, bool q) { return p || q; });
    case 3:
      return two("⇒", [](bool p, bool q) { return !p || q; });
    case 4:
      return two("⇔", [](bool p, bool q) { return p == q; });
    default:
      return {fmt::format("(¬ {})", a.z), [a](const Values& here) { return !a.means(here); }};
  }
}

Condition Maker::quantified(int depth, std::size_t scope) {
  const Condition is_so = condition(depth - 1, scope + 1);
  const char* name = variables_[scope];
  const auto all = [&](const char* z, std::function<bool(int)> enough) {
    return Condition{fmt::format(fmt::runtime(z), name, last, is_so.z),
                     [is_so, scope, enough](const Values& here) { return at_each(is_so, here, scope, enough); }};
  };
  const auto some = [](int so) { return so > 0; };
  const auto each = [](int so) { return so == last + 1; };
  switch (random_.below(7)) {
    case 0:
      return all("(∃ {0} : 0 ‥ {1} • {2})", some);
    case 1:
      return all("(∃ {0} : ℕ • {0} ≤ {1} ∧ {2})", some);
    case 2:
      return all("(∃ {0} : ℕ | {2} • {0} ≤ {1})", some);
    case 3:
      return all("(∀ {0} : 0 ‥ {1} • {2})", each);
    case 4:
      return all("(∀ {0} : ℕ | {0} ≤ {1} • {2})", each);
    case 5:
      return all("(∃₁ {0} : 0 ‥ {1} • {2})", [](int so) { return so == 1; });
    default: {
      const Expression is = expression(depth - 1, scope);
      return {fmt::format("(∃ {0} : ℕ • {0} = {1} ∧ {2})", name, is.z, is_so.z),
              [is, is_so, scope](const Values& here) {
                const auto value = is.means(here);
                return value && *value >= 0 && is_so.means(with(here, scope, *value));
              }};
    }
  }
}

/// Sets by conditions in what is made of sets.
Condition Maker::of_sets(int depth, std::size_t scope) {
  const Condition is_so = condition(depth - 1, scope + 1);
  const Expression a = expression(depth - 1, scope);
  const std::string set = fmt::format("{{{} : ℕ | {}}}", variables_[scope], is_so.z);
  const auto so = [is_so, scope](const Values& here, Number n) { return is_so.means(with(here, scope, n)); };
  switch (random_.below(5)) {
    case 0:
      return {fmt::format("disjoint ⟨{{0, 1}}, {}⟩", set),
              [so](const Values& here) { return !so(here, 0) && !so(here, 1); }};
    case 1:
      return {fmt::format("({{0 ↦ 1, 1 ↦ 2}} ▷ {}) = ∅", set),
              [so](const Values& here) { return !so(here, 1) && !so(here, 2); }};
    case 2:
      return {fmt::format("{{0, 1}} ∩ {} = {{1}}", set),
              [so](const Values& here) { return !so(here, 0) && so(here, 1); }};
    case 3:
      return {fmt::format("{{0, 2}} ⊆ {}", set), [so](const Values& here) { return so(here, 0) && so(here, 2); }};
    default:
      return {fmt::format("{} ∈ {}", a.z, set), [a, so](const Values& here) {
                const auto value = a.means(here);
                return value && *value >= 0 && so(here, *value);
              }};
  }
}

Condition Maker::of_trees(int depth, std::size_t scope) {
  const Tree of = tree(depth - 1, scope);
  const Expression a = expression(depth - 1, scope), b = expression(depth - 1, scope);
  switch (random_.below(3)) {
    case 0:
      return {fmt::format("{} ∈ odd", of.z), [of](const Values& here) { return of.odd(here).value_or(false); }};
    case 1:
      return {fmt::format("({}, {}) = ({}, 1)", a.z, b.z, b.z), [a, b](const Values& here) {
                const auto p = a.means(here), q = b.means(here);
                return p && q && *p == *q && *q == 1;
              }};
    default:
      return {fmt::format("tip ({}) = tip ({})", a.z, b.z), [a, b](const Values& here) {
                const auto p = a.means(here), q = b.means(here);
                return p && q && *p >= 0 && *p == *q;
              }};
  }
}

}  // namespace durero::zed::test
