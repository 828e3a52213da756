#include "zed/value/small_members.hpp"

#include <algorithm>
#include <cmath>

#include "zed/value/sets.hpp"

namespace durero::zed {
namespace {

using Values = std::vector<Value>;

constexpr std::size_t most_items = 1 << 20;  // of all members of a bounded size together

/// Grows lists of values by one more value, level by level: first the empty list, then those of one value, and so on. A
/// value stands in a list as often as `extends` allows, which takes the list and the place of the value.
template <class Extends, class Visit>
void by_size(std::size_t values, std::size_t longest, Extends&& extends, Visit&& visit) {
  std::vector<std::vector<std::size_t>> level{{}};
  for (std::size_t size = 0; !level.empty(); ++size) {
    for (const auto& list : level)
      if (!visit(list)) return;
    if (size == longest) return;
    std::vector<std::vector<std::size_t>> longer;
    for (const auto& list : level)
      for (std::size_t i = 0; i < values && longer.size() <= most_bounded_members; ++i) {
        if (!extends(list, i)) continue;
        longer.push_back(list);
        longer.back().push_back(i);
      }
    level = std::move(longer);
  }
}

bool ascends(const std::vector<std::size_t>& list, std::size_t i) { return list.empty() || list.back() < i; }

Values picked(const Values& from, const std::vector<std::size_t>& places) {
  Values some;
  some.reserve(places.size());
  for (const std::size_t place : places) some.push_back(from[place]);
  return some;
}

Values usable(Values values) {
  std::erase_if(values, [](const Value& value) { return value.is_undefined() || has_open(value); });
  return values;
}

}  // namespace

Value sequence_of(const std::vector<Value>& items) {
  Values pairs;
  pairs.reserve(items.size());
  for (const Value& item : items) pairs.push_back(Value::pair(Real(static_cast<double>(pairs.size() + 1)), item));
  return finite_sequence(std::move(pairs));
}

std::vector<Value> subsets_of(std::vector<Value> values, std::size_t most, bool nonempty) {
  const Values base = usable(std::move(values));
  Values subsets;
  by_size(base.size(), base.size(), ascends, [&](const auto& places) {
    if (subsets.size() == most) return false;
    if (!nonempty || !places.empty()) subsets.push_back(Value::set(picked(base, places)));
    return true;
  });
  return subsets;
}

std::optional<std::vector<Value>> all_subsets(const std::vector<Value>& sorted, std::size_t size) {
  Values subsets;
  std::size_t items = 0;
  bool all = true;
  by_size(sorted.size(), size, ascends, [&](const auto& places) {
    items += places.size();
    all = subsets.size() < most_bounded_members && items <= most_items;
    if (all) subsets.push_back(finite(picked(sorted, places)));
    return all;
  });
  return all ? std::optional(std::move(subsets)) : std::nullopt;
}

std::vector<Value> sequences_of(const std::vector<Value>& values, std::size_t most, bool nonempty, bool distinct) {
  const Values items = usable(values);
  Values sequences;
  const auto extends = [&](const std::vector<std::size_t>& list, std::size_t i) {
    return !distinct || std::find(list.begin(), list.end(), i) == list.end();
  };
  by_size(items.size(), most, extends, [&](const auto& places) {
    if (sequences.size() == most) return false;
    if (!nonempty || !places.empty()) sequences.push_back(sequence_of(picked(items, places)));
    return true;
  });
  return sequences;
}

std::optional<std::vector<Value>> all_sequences(const std::vector<Value>& values, std::size_t length, bool distinct) {
  Values sequences;
  bool all = true;
  const auto extends = [&](const std::vector<std::size_t>& list, std::size_t i) {
    return !distinct || std::find(list.begin(), list.end(), i) == list.end();
  };
  std::size_t listed = 0;
  by_size(values.size(), length, extends, [&](const auto& places) {
    listed += places.size();
    all = sequences.size() < most_bounded_members && listed <= most_items;
    if (all) sequences.push_back(sequence_of(picked(values, places)));
    return all;
  });
  return all ? std::optional(std::move(sequences)) : std::nullopt;
}

std::vector<Value> some_tuples(const std::vector<Value>& factors, const SmallScope& scope, Context& context) {
  std::vector<Values> of_each;
  const double share = std::pow(static_cast<double>(scope.most), 1.0 / static_cast<double>(factors.size()));
  for (const Value& factor : factors) {
    of_each.push_back(factor.set()->some_members(scope, context));
    of_each.back().resize(std::min(of_each.back().size(), std::max<std::size_t>(2, static_cast<std::size_t>(share))));
  }
  std::vector<Values> rows{{}};
  for (const Values& some : of_each) {
    std::vector<Values> longer;
    for (const Values& row : rows)
      for (const Value& value : some) {
        longer.push_back(row);
        longer.back().push_back(value);
      }
    rows = std::move(longer);
  }
  Values tuples;
  for (Values& row : rows) tuples.push_back(Value::tuple(std::move(row)));
  return tuples;
}

}  // namespace durero::zed
