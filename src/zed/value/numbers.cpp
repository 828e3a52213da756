/// The toolkit has sets of numbers, and their arithmetic and order.

#include "zed/value/functions.hpp"
#include "zed/value/sets.hpp"
#include "zed/value/toolkit_functions.hpp"

namespace durero::zed {
namespace {

constexpr int most_listed_numbers = 1 << 20;  // an interval with more members is not listed

/// Returns the least or the greatest member of a set of numbers; undefined for the empty set.
Value extreme(const Value& set, bool greatest) {
  return with(set, [&]() -> Value {
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

}  // namespace

namespace functions {

Value all_numbers() { return everything("𝔸"); }
Value all_integers() { return integers("ℤ", std::nullopt); }
Value naturals() { return integers("ℕ", 0); }
Value positive_naturals() { return integers("ℕ₁", 1); }

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

Value interval(const Value& a, const Value& b, Context&) {
  return with(a, b, [&]() -> Value {
    const Real &from = *a.real(), &to = *b.real();
    if (!from.is_integer() || !to.is_integer()) throw EvaluationError("‥ between numbers that are not integers");
    if (to - from > Real(most_listed_numbers)) throw TooManyMembers(a.text() + "‥" + b.text());
    std::vector<Value> members;
    for (Real number = from; number <= to; number = number + Real(1)) members.emplace_back(number);
    return finite(std::move(members));
  });
}

Value minimum(const Value& set, Context&) { return extreme(set, false); }
Value maximum(const Value& set, Context&) { return extreme(set, true); }

}  // namespace functions
}  // namespace durero::zed
