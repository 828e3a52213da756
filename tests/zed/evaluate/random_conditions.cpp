/// Expressions and conditions of what a world defines.

#include <fmt/format.h>

#include <algorithm>

#include "zed/evaluate/random_cases.hpp"

namespace durero::zed::test {
namespace {

using Partial = std::optional<Number>;

Number floor_div(Number n, Number d) { return n >= 0 ? n / d : -((-n + d - 1) / d); }

/// The number, where it is small enough.
Partial bounded(Partial value) {
  if (value && std::abs(*value) > 1'000'000) throw TooFar();
  return value;
}

Partial both(const Partial& a, const Partial& b, const std::function<Partial(Number, Number)>& of) {
  return a && b ? bounded(of(*a, *b)) : std::nullopt;
}

Expression constant(Number value) {
  return {std::to_string(value), [value](const Values&) { return Partial(value); }};
}

/// The same values with one more.
Values with(Values here, std::size_t place, Number value) {
  here[place] = value;
  return here;
}

}  // namespace

Expression Maker::expression(int depth, std::size_t scope) {
  if (depth == 0 || random_.below(5) == 0) {
    if (random_.below(3) == 0) return constant(static_cast<Number>(random_.below(5)));
    const std::size_t place = random_.below(scope);
    return {variables_[place], [place](const Values& here) { return Partial(here[place]); }};
  }
  switch (random_.below(9)) {
    case 0:
    case 1:
      return arithmetic(depth, scope);
    case 2:
    case 3:
    case 4:
      return application(depth, scope);
    case 5:
      return of_finite_function(depth, scope);
    case 6:
      return scope < variables_.size() ? of_lambda(depth, scope) : choice(depth, scope);
    case 7:
      return scope < variables_.size() ? count(depth, scope) : choice(depth, scope);
    default:
      return scope < variables_.size() ? the_one(depth, scope) : choice(depth, scope);
  }
}

Expression Maker::arithmetic(int depth, std::size_t scope) {
  const Expression a = expression(depth - 1, scope), b = expression(depth - 1, scope);
  const auto by = static_cast<Number>(2 + random_.below(2));
  const auto two = [&](const char* z, std::function<Partial(Number, Number)> of) {
    return Expression{fmt::format(fmt::runtime(z), a.z, b.z),
                      [a, b, of](const Values& here) { return both(a.means(here), b.means(here), of); }};
  };
  const auto one = [&](const char* z, Number (*of)(Number, Number)) {
    return Expression{fmt::format(fmt::runtime(z), a.z, by), [a, by, of](const Values& here) {
                        const Partial value = a.means(here);
                        return value ? bounded(of(*value, by)) : value;
                      }};
  };
  switch (random_.below(6)) {
    case 0:
      return two("({} + {})", [](Number p, Number q) { return Partial(p + q); });
    case 1:
      return two("({} - {})", [](Number p, Number q) { return Partial(p - q); });
    case 2:
      return two("(first ({}, {}))", [](Number p, Number) { return Partial(p); });
    case 3:
      return one("({} * {})", [](Number p, Number q) { return p * q; });
    case 4:
      return one("({} div {})", [](Number p, Number q) { return floor_div(p, q); });
    default:
      return one("({} mod {})", [](Number p, Number q) { return p - q * floor_div(p, q); });
  }
}

Expression Maker::application(int depth, std::size_t scope) {
  const Expression a = expression(depth - 1, scope), b = expression(depth - 1, scope);
  switch (random_.below(6)) {
    case 0: {
      const PairFunction& of = random_.one_of(world_.pair_functions);
      return {fmt::format("{}({}, {})", of.name, a.z, b.z),
              [a, b, &of](const Values& here) { return both(a.means(here), b.means(here), of.at); }};
    }
    case 1: {
      const Tree of = tree(depth - 1, scope);
      return {fmt::format("size ({})", of.z), of.size};
    }
    case 2:
      return {fmt::format("total ⟨{}, {}⟩", a.z, b.z), [a, b, &world = world_](const Values& here) {
                return both(a.means(here), b.means(here), [&world](Number p, Number q) {
                  return p < 0 || q < 0 ? std::nullopt : Partial(p + q + world.total_of_none);
                });
              }};
    default: {
      const Function& of = random_.one_of(world_.functions);
      return {fmt::format("{}({})", of.name, a.z), [a, &of](const Values& here) {
                const Partial argument = a.means(here);
                return argument ? bounded(of.at(*argument)) : std::nullopt;
              }};
    }
  }
}

/// ({0 ↦ c, 2 ↦ d} ⊕ {e ↦ c}) applied.
Expression Maker::of_finite_function(int depth, std::size_t scope) {
  const Expression at = expression(depth - 1, scope), over = expression(depth - 1, scope);
  const auto c = static_cast<Number>(random_.below(5)), d = static_cast<Number>(random_.below(5));
  const bool plain = random_.below(2) == 0;
  return {plain ? fmt::format("({{0 ↦ {}, 2 ↦ {}}} ({}))", c, d, at.z)
                : fmt::format("(({{0 ↦ {}, 2 ↦ {}}} ⊕ {{{} ↦ {}}}) ({}))", c, d, over.z, d, at.z),
          [at, over, c, d, plain](const Values& here) {
            return both(at.means(here), plain ? Partial(-1) : over.means(here), [c, d, plain](Number p, Number q) {
              if (!plain && p == q) return Partial(d);
              return p == 0 ? Partial(c) : p == 2 ? Partial(d) : std::nullopt;
            });
          }};
}

Expression Maker::of_lambda(int depth, std::size_t scope) {
  const Condition guard = condition(depth - 1, scope + 1);
  const Expression body = expression(depth - 1, scope + 1), at = expression(depth - 1, scope);
  return {fmt::format("((λ {} : ℕ | {} • {}) ({}))", variables_[scope], guard.z, body.z, at.z),
          [guard, body, at, scope](const Values& here) -> Partial {
            const Partial argument = at.means(here);
            if (!argument || *argument < 0) return std::nullopt;
            const Values inside = with(here, scope, *argument);
            return guard.means(inside) ? body.means(inside) : std::nullopt;
          }};
}

Expression Maker::choice(int depth, std::size_t scope) {
  const Condition which = condition(depth - 1, scope);
  const Expression a = expression(depth - 1, scope), b = expression(depth - 1, scope);
  return {fmt::format("(if {} then {} else {})", which.z, a.z, b.z),
          [which, a, b](const Values& here) { return which.means(here) ? a.means(here) : b.means(here); }};
}

/// How many of 0‥2 are so, or the least of them.
Expression Maker::count(int depth, std::size_t scope) {
  const Condition is_so = condition(depth - 1, scope + 1);
  const bool least = random_.below(2) == 0;
  return {fmt::format("({} {{{} : 0 ‥ 2 | {}}})", least ? "min" : "#", variables_[scope], is_so.z),
          [is_so, least, scope](const Values& here) -> Partial {
            Number found = 0;
            for (Number n = 0; n <= 2; ++n) {
              if (!is_so.means(with(here, scope, n))) continue;
              if (least) return n;
              ++found;
            }
            return least ? std::nullopt : Partial(found);
          }};
}

/// μ of what an equation gives.
Expression Maker::the_one(int depth, std::size_t scope) {
  const Expression is = expression(depth - 1, scope), of = expression(depth - 1, scope + 1);
  return {fmt::format("(μ {0} : ℕ | {0} = {1} • {2})", variables_[scope], is.z, of.z),
          [is, of, scope](const Values& here) {
            const Partial value = is.means(here);
            return value && *value >= 0 ? of.means(with(here, scope, *value)) : std::nullopt;
          }};
}

Maker::Tree Maker::tree(int depth, std::size_t scope) {
  const std::size_t form = depth <= 0 ? random_.below(2) : random_.below(3);
  if (form == 0)
    return {"leaf", [&world = world_](const Values&) { return Partial(world.size_of_leaf); },
            [](const Values&) { return std::optional(false); }};
  if (form == 1) {
    const Expression n = expression(std::max(depth - 1, 0), scope);
    const auto at = [n](const Values& here, const auto& of) -> std::optional<decltype(of(Number()))> {
      const Partial value = n.means(here);
      return value && *value >= 0 ? std::optional(of(*value)) : std::nullopt;
    };
    return {fmt::format("tip ({})", n.z),
            [at, &world = world_](const Values& here) { return at(here, world.size_of_tip); },
            [at, &world = world_](const Values& here) { return at(here, world.tip_is_odd); }};
  }
  const Tree left = tree(depth - 1, scope), right = tree(depth - 1, scope);
  return {fmt::format("node ({}, {})", left.z, right.z),
          [left, right, &world = world_](const Values& here) {
            return both(left.size(here), right.size(here),
                        [&world](Number p, Number q) { return Partial(p + q + world.size_of_node); });
          },
          [left, right](const Values& here) -> std::optional<bool> {
            const auto a = left.odd(here), b = right.odd(here);
            return a && b ? std::optional(*a == *b) : std::nullopt;
          }};
}

}  // namespace durero::zed::test
