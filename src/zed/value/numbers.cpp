/// The toolkit has sets of numbers, and their arithmetic and order.

#include <fmt/format.h>

#include "durero/zed/value/undecided.hpp"
#include "zed/value/functions.hpp"
#include "zed/value/number_sets.hpp"
#include "zed/value/sets.hpp"
#include "zed/value/toolkit_functions.hpp"

namespace durero::zed {
namespace {

constexpr int greatest_exponent = 1 << 20;    // of a power: a greater one would fill the memory
constexpr int most_listed_numbers = 1 << 20;  // an interval with more members is not listed

class NonzeroIntegers : public Set {
 public:
  Truth contains(const Value& value, Context& context) const override {
    const Truth here = contains_value(functions::all_integers(), value, context);
    return here == Truth::no ? here : both(here, relations::unequal(value, Real(), context));
  }
  Numbers numbers() const override { return Numbers::integers; }
  std::vector<Value> some_members(const SmallScope& scope, Context& context) const override {
    std::vector<Value> some = functions::all_integers().set()->some_members(scope, context);
    std::erase_if(some, [](const Value& number) { return sign(*number.real()) == 0; });
    return some;
  }
  std::string spelled(Wording) const override { return "ℤ₁"; }
};

/// Returns the least or the greatest member of a set of numbers; undefined for the empty set.
Value extreme(const Value& set, bool greatest, Context& context) {
  return with(set, [&]() -> Value {
    if (set.set() && !set.set()->members())
      if (auto number = extreme_number(set, greatest, context)) return std::move(*number);
    const auto& members = enumerated(set, "the least member of");
    if (members.empty()) return {};
    return greatest ? members.back() : members.front();
  });
}

/// In div and mod, n = q * d + r with 0 ≤ r < d or d < r ≤ 0. They are undefined for d = 0 and for numbers that are no
/// integers.
template <class Result>
Value divided(const Value& a, const Value& b, Result&& result) {
  return with(a, b, [&]() -> Value {
    const Real &n = *a.real(), &d = *b.real();
    if (sign(d) == 0 || !n.is_integer() || !d.is_integer()) return {};
    return result(n, d, integer_quotient(n, d));
  });
}

/// Returns base to a whole exponent that is not negative, by its binary digits.
Real whole_power(Real base, Real exponent, Context& context) {
  Real product(1);
  while (sign(exponent) > 0) {
    const Real half = integer_quotient(exponent, Real(2));
    if (!(exponent == half + half)) product = product * base;
    if (sign(half) > 0) base = base * base;
    context.steps.take(1 + product.words() + base.words());
    exponent = half;
  }
  return product;
}

}  // namespace

namespace functions {

Value all_numbers() { return everything("𝔸"); }
Value all_integers() { return integers("ℤ", std::nullopt); }
Value naturals() { return integers("ℕ", 0); }
Value positive_naturals() { return integers("ℕ₁", 1); }
Value nonzero_integers() { return SetPtr(std::make_shared<const NonzeroIntegers>()); }

Value addition(const Value& a, const Value& b, Context&) { return sum(a, b); }
Value subtraction(const Value& a, const Value& b, Context&) { return difference(a, b); }
Value multiplication(const Value& a, const Value& b, Context&) { return product(a, b); }
Value negation(const Value& a, Context&) { return difference(Real(), a); }

Value quotient(const Value& a, const Value& b, Context&) {
  return divided(a, b, [](const Real&, const Real&, const Real& q) { return q; });
}

Value remainder(const Value& a, const Value& b, Context&) {
  return divided(a, b, [](const Real& n, const Real& d, const Real& q) { return n - q * d; });
}

Value fraction(const Value& a, const Value& b, Context&) {
  return with(a, b, [&]() -> Value {
    if (!a.real() || !b.real()) throw EvaluationError("division of what is no number");
    if (sign(*b.real()) == 0) return {};
    return exactly([&] { return *a.real() / *b.real(); });
  });
}

Value root(const Value& a, Context&) {
  return with(a, [&]() -> Value {
    if (!a.real()) throw EvaluationError("the root of what is no number");
    return exactly([&] { return square_root(*a.real()); });
  });
}

Value power(const Value& base, const Value& exponent, Context& context) {
  return with(base, exponent, [&]() -> Value {
    if (!base.real() || !exponent.real()) throw EvaluationError("the power of what is no number");
    if (*base.real() == Real(1)) return Real(1);
    const Real twice = *exponent.real() * Real(2);
    if (!twice.is_integer() || sign(twice) < 0 || twice > Real(2 * greatest_exponent))
      throw LackingEvaluation(
          Lack::number,
          fmt::format("a power with the exponent {} is not evaluated; a whole number up to {}, or half of one, is",
                      exponent.text(), greatest_exponent));
    return exactly([&] {
      if (exponent.real()->is_integer()) return whole_power(*base.real(), *exponent.real(), context);
      return square_root(whole_power(*base.real(), twice, context));
    });
  });
}

Value interval(const Value& a, const Value& b, Context&) {
  return with(a, b, [&]() -> Value {
    const Real &from = *a.real(), &to = *b.real();
    if (!from.is_integer() || !to.is_integer()) throw EvaluationError("‥ between numbers that are not integers");
    if (to - from > Real(most_listed_numbers)) return long_interval(from, to);
    std::vector<Value> members;
    const Real one(1);
    for (Real number = from; number <= to; number = number + one) members.emplace_back(number);
    return finite(std::move(members));
  });
}

Value minimum(const Value& set, Context& context) { return extreme(set, false, context); }
Value maximum(const Value& set, Context& context) { return extreme(set, true, context); }

}  // namespace functions
}  // namespace durero::zed
