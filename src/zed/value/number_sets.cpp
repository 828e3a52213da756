#include "zed/value/number_sets.hpp"

#include <algorithm>

#include "zed/value/cuts.hpp"
#include "zed/value/formed_set.hpp"
#include "zed/value/sets.hpp"
#include "zed/value/toolkit_functions.hpp"

namespace durero::zed {
namespace {

constexpr std::size_t most_points = 1024;  // of a finite set that a line is cut at: each is compared with every stretch

/// Says whether the membership of numbers in a set may be followed along their line.
bool has_line(const Set& set) {
  if (set.numbers() == Numbers::none || !set.closed()) return false;
  const auto* members = set.members();
  return !members || members->size() <= most_points;
}

/// A line has the numbers of a kind, and something is so, or is not, on all of a stretch of it.
class Line {
 public:
  using TruthAlong = std::function<Truth(const Value& t, Context& context)>;
  Line(Numbers numbers, Steps& steps, int depth, TruthAlong asked)
      : numbers_(numbers), context_(steps), asked_(std::move(asked)) {
    context_.depth = depth;
    t_ = Unknown{context_.fresh()};
    cuts_ = cuts_of(t_.id, numbers_, context_, [&] { return asked_(t_, context_); });
  }

  bool is_followed() const { return cuts_.has_value(); }
  Numbers numbers() const { return numbers_; }
  const Cuts& cuts() const { return *cuts_; }
  Truth at(const Real& t) {
    context_.values_found[t_.id] = t;
    const Necessary nothing_here(context_, false);
    return asked_(t, context_);
  }

 private:
  Numbers numbers_;
  Context context_;
  TruthAlong asked_;
  Unknown t_{};
  std::optional<Cuts> cuts_;
};

class LongInterval : public Set {
 public:
  LongInterval(Real from, Real to, Real size) : from_(std::move(from)), to_(std::move(to)), size_(std::move(size)) {}
  Truth contains(const Value& value, Context& context) const override {
    Truth here = contains_value(functions::all_integers(), value, context);
    if (here != Truth::no) here = both(here, relations::at_most(from_, value, context));
    return here == Truth::no ? here : both(here, relations::at_most(value, to_, context));
  }
  Numbers numbers() const override { return Numbers::integers; }
  std::optional<Real> size() const override { return size_; }
  std::vector<Value> some_members(const SmallScope& scope, Context&) const override {
    std::vector<Value> some;
    for (const Real& number : scope.numbers)
      if (some.size() < scope.most && number.is_integer() && from_ <= number && number <= to_)
        some.emplace_back(number);
    if (some.empty()) some = {from_, to_};
    return some;
  }
  std::string spelled(Wording) const override { return from_.text() + "‥" + to_.text(); }

 private:
  Real from_, to_, size_;
};

}  // namespace

std::optional<Truth> numbers_are_among(const Value& a, const Value& b, Context& context) {
  if (!a.set() || !b.set() || !has_line(*a.set()) || !b.set()->closed()) return std::nullopt;
  if (const auto* points = b.set()->members(); points && points->size() > most_points) return std::nullopt;
  try {
    Line outside(a.set()->numbers(), context.steps, context.depth, [&](const Value& t, Context& inside) {
      const Truth in = contains_value(a, t, inside);
      return in == Truth::no ? in : both(in, !contains_value(b, t, inside));
    });
    if (!outside.is_followed()) return std::nullopt;
    const Truth some = some_number(outside.numbers(), outside.cuts(), [&](const Real& t) { return outside.at(t); });
    return some == Truth::open ? std::nullopt : std::optional(!some);
  } catch (const EvaluationError&) {  // it is decided in another way, or not at all
    return std::nullopt;
  }
}

std::optional<Value> extreme_number(const Value& set, bool greatest, Context& context) {
  if (!set.set() || !has_line(*set.set())) return std::nullopt;
  try {
    Line line(set.set()->numbers(), context.steps, context.depth,
              [&](const Value& t, Context& inside) { return contains_value(set, t, inside); });
    if (!line.is_followed()) return std::nullopt;
    return zed::extreme_number(
        line.numbers(), line.cuts(), [&](const Real& t) { return line.at(t); }, greatest);
  } catch (const EvaluationError&) {  // it is decided in another way, or not at all
    return std::nullopt;
  }
}

bool is_infinite(const Value& set, Context& context) {
  if (const auto* formed = dynamic_cast<const FormedSet*>(set.set())) return formed->is_infinite();
  if (!set.set() || set.set()->members() || !has_line(*set.set())) return false;
  try {
    Line line(set.set()->numbers(), context.steps, context.depth,
              [&](const Value& t, Context& inside) { return contains_value(set, t, inside); });
    return line.is_followed() &&
           zed::is_infinite(line.numbers(), line.cuts(), [&](const Real& t) { return line.at(t); });
  } catch (const EvaluationError&) {  // it is not known
    return false;
  }
}

std::optional<Value> listed_numbers(const Set& set, Steps& steps) {
  if (!has_line(set)) return std::nullopt;
  try {
    Line line(set.numbers(), steps, 0, [&](const Value& t, Context& inside) { return set.contains(t, inside); });
    if (!line.is_followed()) return std::nullopt;
    const auto numbers = every_number(line.numbers(), line.cuts(), [&](const Real& t) { return line.at(t); });
    if (!numbers) return std::nullopt;
    std::vector<Value> members;
    for (const Real& t : *numbers) {
      if (line.at(t) != Truth::yes) return std::nullopt;
      members.emplace_back(t);
    }
    return finite(std::move(members));
  } catch (const EvaluationError&) {  // the members stay known by membership
    return std::nullopt;
  }
}

Numbers numbers_of_both(const Set& a, const Set& b) {
  const auto is_empty = [](const Set& set) { return set.members() && set.members()->empty(); };
  if (is_empty(a)) return b.numbers();
  if (is_empty(b)) return a.numbers();
  const Numbers x = a.numbers(), y = b.numbers();
  if (x == Numbers::none || y == Numbers::none) return Numbers::none;
  return x == Numbers::integers ? y : x;
}

Value long_interval(Real from, Real to) {
  const Real one(1);
  Real size = to - from + one;
  return SetPtr(std::make_shared<const LongInterval>(std::move(from), std::move(to), std::move(size)));
}

}  // namespace durero::zed
