#include "scoped_solutions.hpp"

#include <algorithm>
#include <limits>

namespace durero::spec {

using zed::Name;
using zed::Truth;
using zed::Valuation;
using zed::Value;

namespace {

/// A question tries so many values at most, which takes about a second.
constexpr std::size_t most_tries = 20'000;

/// No bound on the bindings that a search visits.
constexpr std::size_t no_quota = std::numeric_limits<std::size_t>::max();

std::vector<Name> names_alone(const Valuation& known) {
  std::vector<Name> names;
  for (const auto& [name, value] : known) names.push_back(name);
  return names;
}

/// The values whose names are among these.
Valuation of_names(const Valuation& values, const std::vector<Name>& names) {
  Valuation kept;
  for (const auto& value : values)
    if (std::find(names.begin(), names.end(), value.first) != names.end()) kept.push_back(value);
  return kept;
}

}  // namespace

bool ScopedSolutions::Before::operator()(const std::vector<Value>& a, const std::vector<Value>& b) const {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                      [](const Value& x, const Value& y) { return zed::compare(x, y) < 0; });
}

bool ScopedSolutions::each(const std::string& schema, const Valuation& given,
                           const std::function<bool(const Valuation&)>& visit) {
  Search search{schema, visit};
  Valuation known = of_names(given, parts_.check(schema).components());
  return look(search, known, no_quota);
}

ScopedSample ScopedSolutions::sample(const std::string& schema, std::size_t most) {
  ScopedSample sample;
  const auto take = [&](const Valuation& binding) {
    if (sample.bindings.size() == most) return false;
    sample.bindings.push_back(binding);
    return true;
  };
  const std::function<bool(const Valuation&)> visit = take;
  Valuation known;
  Search whole{schema, visit};
  look(whole, known, no_quota);
  sample.all = !whole.stopped && !whole.cut;
  if (sample.all) return sample;
  sample.bindings.clear();
  Search spread{schema, visit};
  look(spread, known, most);
  return sample;
}

Truth ScopedSolutions::some(const std::string& schema, const Valuation& given) {
  bool found = false;
  const bool all = each(schema, given, [&](const Valuation&) {
    found = true;
    return false;
  });
  return found ? Truth::yes : all ? Truth::no : Truth::open;
}

Truth ScopedSolutions::holds(const std::string& schema, const Valuation& values) const {
  parts_.begin_question();
  const zed::SchemaCheck& check = parts_.check(schema);
  try {
    return check.holds(in_order(check.components(), values));
  } catch (const zed::EvaluationError&) {
    return Truth::open;
  }
}

/// Says whether there are no bindings with these values but those that were visited.
bool ScopedSolutions::look(Search& search, Valuation& known, std::size_t quota) {
  std::vector<Name> names;
  std::vector<Value> values;
  for (const auto& [name, value] : known) {
    names.push_back(name);
    values.push_back(value);
  }
  parts_.begin_question();
  const zed::Completion& completion = parts_.completion(search.schema, names);
  std::vector<Valuation> found;
  Truth all = Truth::open;
  try {
    all = completion.each(values, [&](std::span<const Value> sought) {
      found.push_back(known);
      for (std::size_t i = 0; i < sought.size(); ++i) found.back().emplace_back(completion.sought()[i], sought[i]);
      return ++search.tried < most_tries;
    });
  } catch (const zed::EvaluationError& error) {
    why_open_ = error.what();
  }
  for (const Valuation& binding : found) {
    if (search.stopped) return false;
    const bool is_new = search.visited.insert(in_order(parts_.check(search.schema).components(), binding)).second;
    search.stopped = is_new && !search.visit(binding);
  }
  if (search.stopped) return false;
  if (all == Truth::open && !completion.sought().empty()) return go_through(search, known, quota);
  return all != Truth::open && search.tried < most_tries;
}

/// Gives the component with the fewest members in the scope each of them; with a quota, so many of them that are evenly
/// apart, each with its part of the quota. The first of these depends on the values before, so that no two components
/// go in step.
bool ScopedSolutions::go_through(Search& search, Valuation& known, std::size_t quota) {
  const std::vector<Name> sought = parts_.completion(search.schema, names_alone(known)).sought();
  const auto next = std::min_element(sought.begin(), sought.end(), [&](const Name& a, const Name& b) {
    return values_.of(search.schema, a).values.size() < values_.of(search.schema, b).values.size();
  });
  const ScopedMembers members = values_.of(search.schema, *next);
  const std::size_t size = members.values.size(), count = std::min(size, quota);
  bool all = members.all && count == size;
  if (!members.all) why_open_ = "the values of " + next->text() + " do not end with the scope";
  search.cut = search.cut || count < size;
  const std::size_t first = count < size ? (search.tried * 7919) % size : 0;  // a prime: the remainders go round
  for (std::size_t i = 0; i < count; ++i) {
    if (++search.tried >= most_tries) search.cut = true;
    if (search.tried >= most_tries) return false;
    known.emplace_back(*next, members.values[(first + i * size / count) % size]);
    all = look(search, known, quota == no_quota ? no_quota : (quota + count - 1) / count) && all;
    known.pop_back();
    if (search.stopped) return false;
  }
  return all;
}

}  // namespace durero::spec
