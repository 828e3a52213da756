#include "zed/value/cuts.hpp"

#include <algorithm>

#include "zed/value/sets.hpp"

namespace durero::zed {
namespace {

using number::Integer;

Real whole(const Integer& value) { return Real(number::Surd(number::Rational(value))); }

/// A stretch of the line between two cuts; null: it has no end on that side.
struct Stretch {
  const Real* low = nullptr;
  const Real* high = nullptr;
};

std::vector<Stretch> stretches(const Cuts& cuts) {
  std::vector<Stretch> all;
  for (std::size_t i = 0; i <= cuts.size(); ++i)
    all.push_back({i > 0 ? &cuts[i - 1] : nullptr, i < cuts.size() ? &cuts[i] : nullptr});
  return all;
}

/// The least integer above a stretch's lower end; the greatest below its upper end where it has no lower one.
Integer first_integer(const Stretch& stretch) {
  if (stretch.low) return floor_of(*stretch.low) + 1;
  if (!stretch.high) return 0;
  const Integer below_end = floor_of(*stretch.high);
  return whole(below_end) == *stretch.high ? Integer(below_end - 1) : below_end;
}

/// A number of the stretch, where it has any.
std::optional<Real> sample(Numbers numbers, const Stretch& stretch) {
  if (numbers == Numbers::integers) {
    const Real first = whole(first_integer(stretch));
    if (stretch.high && first >= *stretch.high) return std::nullopt;
    return first;
  }
  if (stretch.low && stretch.high) return between(*stretch.low, *stretch.high);
  if (stretch.low) return above(*stretch.low);
  return stretch.high ? below(*stretch.high) : Real();
}

bool is_among(Numbers numbers, const Real& cut) { return numbers == Numbers::reals || cut.is_integer(); }

}  // namespace

Truth some_number(Numbers numbers, const Cuts& cuts, const At& at) {
  Truth some = Truth::no;
  const auto ask = [&](const Real& t) {
    if (some != Truth::yes)
      if (const Truth here = at(t); here != Truth::no) some = here;
  };
  for (const Stretch& stretch : stretches(cuts)) {
    if (const auto t = sample(numbers, stretch)) ask(*t);
    if (stretch.high && is_among(numbers, *stretch.high)) ask(*stretch.high);
  }
  return some;
}

std::optional<std::vector<Real>> every_number(Numbers numbers, const Cuts& cuts, const At& at) {
  std::vector<Real> every;
  for (const Stretch& stretch : stretches(cuts)) {
    const auto t = sample(numbers, stretch);
    if (t && at(*t) != Truth::no) {
      if (!stretch.low || !stretch.high || numbers == Numbers::reals) return std::nullopt;
      for (Integer each = first_integer(stretch); whole(each) < *stretch.high; ++each) {
        if (every.size() >= most_numbers) return std::nullopt;
        every.push_back(whole(each));
      }
    }
    if (stretch.high && is_among(numbers, *stretch.high) && at(*stretch.high) != Truth::no)
      every.push_back(*stretch.high);
  }
  return every;
}

namespace {

/// The least member of a stretch on which it is so, or the greatest: an integer beside its end. Undefined where it has
/// no end on that side, and where the numbers are dense.
Value end_of(Numbers numbers, const Stretch& stretch, bool greatest) {
  if (numbers != Numbers::integers || !(greatest ? stretch.high : stretch.low)) return {};
  return whole(greatest ? first_integer({nullptr, stretch.high}) : first_integer(stretch));
}

}  // namespace

std::optional<Value> extreme_number(Numbers numbers, const Cuts& cuts, const At& at, bool greatest) {
  std::vector<Stretch> all = stretches(cuts);
  if (greatest) std::reverse(all.begin(), all.end());
  for (const Stretch& stretch : all) {
    const auto t = sample(numbers, stretch);
    const Truth inside = t ? at(*t) : Truth::no;
    if (inside == Truth::open) return std::nullopt;
    if (inside == Truth::yes) return end_of(numbers, stretch, greatest);
    const Real* behind = greatest ? stretch.low : stretch.high;
    if (!behind || !is_among(numbers, *behind)) continue;
    const Truth there = at(*behind);
    if (there == Truth::open) return std::nullopt;
    if (there == Truth::yes) return Value(*behind);
  }
  return Value();
}

bool is_infinite(Numbers numbers, const Cuts& cuts, const At& at) {
  const std::vector<Stretch> all = stretches(cuts);
  return std::any_of(all.begin(), all.end(), [&](const Stretch& stretch) {
    if (numbers == Numbers::integers && stretch.low && stretch.high) return false;
    const auto t = sample(numbers, stretch);
    return t && at(*t) == Truth::yes;
  });
}

std::optional<Cuts> cuts_of(std::uint32_t t, Numbers numbers, Context& context, const std::function<Truth()>& truth) {
  if (context.watch) return std::nullopt;  // another number is followed, on which this one may depend
  Watch watch{t, numbers};
  const Necessary nothing_here(context, false);
  context.watch = &watch;
  const auto unwatched = [&] { context.watch = nullptr; };
  Truth here = Truth::no;
  try {
    here = truth();
  } catch (const EvaluationError&) {
    unwatched();
    return std::nullopt;
  } catch (...) {
    unwatched();
    throw;
  }
  unwatched();
  if (here != Truth::open) return Cuts();  // it is so at every number
  if (watch.lost || watch.compared.empty()) return std::nullopt;
  return exactly([&] { return roots(watch.compared); });
}

std::optional<Value> points_in_common(const Set& curve, const Set& other, Steps& steps) {
  Context context(steps);
  try {
    const auto along = curve.curve(context);
    if (!along) return std::nullopt;
    const auto common = [&](const Value& t, const Value& member) {
      return both(along->admits(t, member, context), other.contains(member, context));
    };
    const auto cuts = cuts_of(along->t.id, Numbers::reals, context, [&] { return common(along->t, along->member); });
    if (!cuts) return std::nullopt;
    const auto at = [&](const Real& t) {
      context.values_found[along->t.id] = t;
      return common(t, resolved(along->member, context));
    };
    const auto numbers = every_number(Numbers::reals, *cuts, at);
    if (!numbers) return std::nullopt;
    std::vector<Value> points;
    for (const Real& t : *numbers) {
      if (at(t) != Truth::yes) return std::nullopt;
      points.push_back(resolved(along->member, context));
    }
    return Value::set(std::move(points));
  } catch (const EvaluationError&) {  // the members stay known by membership
    return std::nullopt;
  }
}

}  // namespace durero::zed
