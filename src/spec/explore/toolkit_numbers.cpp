#include "toolkit_numbers.hpp"

#include <algorithm>

namespace durero::spec {
namespace {

/// The members of an interval that is listed: more are left to the evaluator.
constexpr std::int64_t most_listed = 1'000'000;

using Checked = bool (*)(std::int64_t, std::int64_t, std::int64_t*);

template <Checked compute>
ValueId arithmetic(InternedValues& values, ValueId a, ValueId b) {
  std::int64_t result = 0;
  if (compute(values.whole_number(a), values.whole_number(b), &result)) throw NotInterned("a number is not small");
  return values.number(result);
}

bool sum_overflows(std::int64_t a, std::int64_t b, std::int64_t* to) { return __builtin_add_overflow(a, b, to); }
bool difference_overflows(std::int64_t a, std::int64_t b, std::int64_t* to) { return __builtin_sub_overflow(a, b, to); }
bool product_overflows(std::int64_t a, std::int64_t b, std::int64_t* to) { return __builtin_mul_overflow(a, b, to); }

/// The greatest whole number that is at most a / b.
std::int64_t floor_quotient(std::int64_t a, std::int64_t b) {
  if (b == 0 || b == -1) throw NotInterned("a division by 0, or of the least number");
  return a / b - ((a % b != 0 && (a < 0) != (b < 0)) ? 1 : 0);
}

template <bool least>
ValueId extreme(InternedValues& values, ValueId set) {
  const auto members = values.members(set);
  if (members.empty()) throw NotInterned("an extreme of no numbers");
  std::int64_t best = values.whole_number(members[0]);
  for (const ValueId member : members) {
    const std::int64_t number = values.whole_number(member);
    best = least ? std::min(best, number) : std::max(best, number);
  }
  return values.number(best);
}

}  // namespace

ValueId number_sum(InternedValues& values, ValueId a, ValueId b) { return arithmetic<sum_overflows>(values, a, b); }
ValueId number_difference(InternedValues& values, ValueId a, ValueId b) {
  return arithmetic<difference_overflows>(values, a, b);
}
ValueId number_product(InternedValues& values, ValueId a, ValueId b) {
  return arithmetic<product_overflows>(values, a, b);
}
ValueId negative_of(InternedValues& values, ValueId a) { return number_difference(values, values.number(0), a); }

ValueId number_quotient(InternedValues& values, ValueId a, ValueId b) {
  return values.number(floor_quotient(values.whole_number(a), values.whole_number(b)));
}
ValueId number_remainder(InternedValues& values, ValueId a, ValueId b) {
  const std::int64_t n = values.whole_number(a), d = values.whole_number(b);
  return values.number(n - d * floor_quotient(n, d));
}

ValueId number_interval(InternedValues& values, ValueId a, ValueId b) {
  const std::int64_t low = values.whole_number(a), high = values.whole_number(b);
  ValueList all;
  if (low <= high && static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) > most_listed)
    throw NotInterned("an interval is large");
  for (std::int64_t n = low; n <= high; ++n) all.push_back(values.number(n));
  return values.set(all);
}

ValueId successor(InternedValues& values, ValueId a) {
  if (values.whole_number(a) < 0) throw NotInterned("the successor of a negative number");
  return number_sum(values, a, values.number(1));
}

ValueId least_of(InternedValues& values, ValueId set) { return extreme<true>(values, set); }
ValueId greatest_of(InternedValues& values, ValueId set) { return extreme<false>(values, set); }

}  // namespace durero::spec
