/// The toolkit has sets of relations and of functions.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "durero/zed/value/undecided.hpp"
#include "zed/value/functions.hpp"
#include "zed/value/growing_function.hpp"
#include "zed/value/integer_lines.hpp"
#include "zed/value/sets.hpp"
#include "zed/value/settled_functions.hpp"
#include "zed/value/small_members.hpp"

namespace durero::zed {
namespace {

constexpr double most_listed_functions = 1 << 16;  // sets of functions with more members are known by membership only
constexpr std::size_t most_counted = 1 << 14;      // pairs of a relation: greater numbers of functions are not counted
constexpr std::size_t most_listed_arguments = 64;  // of functions that are listed, where there is a choice
constexpr std::size_t most_grown_arguments = 256;  // of a function that gets its values one by one in a search

void refuse_uncomparable(const std::vector<Value>& pairs, std::size_t part) {
  for (const Value& pair : pairs)
    if (has_intensional(pair.tuple()->parts[part]))
      throw LackingEvaluation(Lack::members, "whether it is a function cannot be decided: the members of " +
                                                 pair.tuple()->parts[part].text() + " cannot be enumerated");
}

/// Pairs are sorted by their first parts, so in a function no two neighbours agree in them.
bool is_function(const std::vector<Value>& pairs) {
  if (pairs.size() > 1) refuse_uncomparable(pairs, 0);
  return std::adjacent_find(pairs.begin(), pairs.end(), [](const Value& a, const Value& b) {
           return same(a.tuple()->parts[0], b.tuple()->parts[0]);
         }) == pairs.end();
}

std::vector<Value> seconds(const std::vector<Value>& pairs) {
  std::vector<Value> values;
  values.reserve(pairs.size());
  for (const Value& pair : pairs) values.push_back(pair.tuple()->parts[1]);
  return values;
}

/// The number of functions of the form, for the sizes of the sets, in numbers that add and multiply. One argument after
/// the other gets a value or, where the form is not total, none; how many may follow depends only on how many values
/// were taken so far. Nothing where a count on the way is more than `most`.
template <class Number>
std::optional<Number> number_of_functions(const Arrow& form, std::size_t from, std::size_t to, const Number* most) {
  const auto number = [](std::size_t n) { return Number(static_cast<int>(n)); };
  std::vector<Number> ways{Number(1)};  // by the number of values taken
  for (std::size_t i = 0; i < from; ++i) {
    std::vector<Number> longer(std::min(i + 1, to) + 1, Number(0));
    Number all(0);
    for (std::size_t taken = 0; taken < ways.size(); ++taken) {
      const std::size_t stay = (form.total ? 0 : 1) + (form.injective ? 0 : taken);
      longer[taken] = longer[taken] + number(stay) * ways[taken];
      if (taken < to) longer[taken + 1] = longer[taken + 1] + number(to - taken) * ways[taken];
    }
    for (std::size_t taken = 0; taken < longer.size(); ++taken) {
      if (form.surjective && to - taken > from - i - 1) longer[taken] = Number(0);  // too few arguments are left
      all = all + longer[taken];
    }
    if (most && all > *most) return std::nullopt;
    ways = std::move(longer);
  }
  if (form.surjective) return ways.size() > to ? ways[to] : Number(0);
  return std::accumulate(ways.begin(), ways.end(), Number(0));
}

/// Says whether each argument has one choice: its value, or none.
bool is_choiceless(const Arrow& form, std::size_t to) { return to + (form.total ? 0 : 1) <= 1; }

/// Says whether so few relations are of the form that they may be listed.
bool listable(const Arrow& form, std::size_t from, std::size_t to) {
  if (form.function) {
    if (is_choiceless(form, to)) return true;
    if (form.total && form.injective && from > to) return true;  // there is none
    if (from > most_listed_arguments) return false;
    return number_of_functions(form, from, to, &most_listed_functions).has_value();
  }
  // For every member of the domain's set, a relation has some of the members of the other.
  return to == 0 || from == 0 || (to < 20 && std::exp2(from * to) <= most_listed_functions);
}

void add_functions(GrowingFunction& begun, std::vector<Value>& all) {
  if (begun.is_whole()) return all.push_back(begun.value());
  begun.each_way_on([&] { add_functions(begun, all); });
}

/// All functions of a space.
std::vector<Value> functions_between(const FunctionSpace& space) {
  std::vector<Value> all;
  if (is_choiceless(space.form, space.to.size())) {
    std::vector<Value> pairs;
    for (const Value& from : space.from)
      for (const Value& to : space.to) pairs.push_back(Value::pair(from, to));
    const bool is_total = pairs.size() == space.from.size() || !space.form.total;
    const bool is_injective = pairs.size() <= 1 || !space.form.injective;
    const bool is_surjective = pairs.size() >= space.to.size() || !space.form.surjective;
    if (is_total && is_injective && is_surjective) all.push_back(finite(std::move(pairs)));
    return all;
  }
  GrowingFunction begun(space);
  if (begun.may_be_whole()) add_functions(begun, all);
  return all;
}

/// All relations between two finite sets.
std::vector<Value> relations(const std::vector<Value>& from, const std::vector<Value>& to) {
  std::vector<std::vector<Value>> sets{{}};
  for (const Value& a : from)
    for (const Value& b : to)
      for (std::size_t i = 0, end = sets.size(); i < end; ++i) {
        sets.push_back(sets[i]);
        sets.back().push_back(Value::pair(a, b));
      }
  std::vector<Value> all;
  all.reserve(sets.size());
  for (auto& pairs : sets) all.push_back(finite(std::move(pairs)));
  return all;
}

class FunctionSet : public Set {
 public:
  FunctionSet(Value from, Value to, const Arrow& form, std::string_view symbol)
      : from_(std::move(from)), to_(std::move(to)), form_(form), symbol_(symbol) {}

  bool total() const override { return !form_.function && !form_.finite && from_.set()->total() && to_.set()->total(); }

  Truth contains(const Value& value, Context& context) const override {
    if (!value.set()) return lost(context);
    if (const auto* function = settled(value)) return settled_is_in(*function, from_, to_, form_, context);
    if (!value.set()->members())
      if (const auto of_line = line_in_it(value, context)) return *of_line;
    const auto& pairs = enumerated(value, "whether it is a function, for");
    if (form_.function && !is_function(pairs)) return Truth::no;
    const Truth inside = both(each_in(pairs, 0, from_, context), each_in(pairs, 1, to_, context));
    if (inside != Truth::yes) return inside;
    if (form_.injective && pairs.size() > 1) refuse_uncomparable(pairs, 1);
    const Value image = form_.injective || form_.surjective ? Value::set(seconds(pairs)) : Value();
    if (form_.injective && image.set()->members()->size() != pairs.size()) return Truth::no;
    Truth result = Truth::yes;
    if (form_.total) result = subset(from_, domain(value, context), context);
    if (form_.surjective) result = both(result, subset(to_, image, context));
    return result;
  }

  bool declares_sequences() const override {
    return from_.set()->declares_sequences() || to_.set()->declares_sequences();
  }
  Value as_declared(const Value& member) const override {
    const auto* members = member.set() ? member.set()->members() : nullptr;
    if (!members || !declares_sequences()) return member;
    std::vector<Value> pairs;
    for (const Value& pair : *members)
      pairs.push_back(Value::pair(from_.set()->as_declared(first(pair)), to_.set()->as_declared(second(pair))));
    return Value::set(std::move(pairs));
  }

  bool closed() const override { return zed::closed(from_) && zed::closed(to_); }
  std::size_t listed() const override { return listed_ ? listed_->set()->listed() : 0; }

  const std::vector<Value>* members() const override {
    if (listed_) return listed_->set()->members();
    const auto *from = from_.set()->members(), *to = to_.set()->members();
    if (!from || !to || !listable(form_, from->size(), to->size())) return nullptr;
    std::vector<Value> all;
    if (form_.function)
      all = functions_between({*from, *to, form_});
    else
      all = relations(*from, *to);
    listed_ = Value::set(std::move(all));
    return listed_->set()->members();
  }

  std::optional<Real> size() const override {
    const auto *from = from_.set()->members(), *to = to_.set()->members();
    if (!from || !to || from_.set()->family() || to_.set()->family()) return std::nullopt;
    if (std::max(from->size(), to->size()) > most_counted || from->size() * to->size() > most_counted)
      return std::nullopt;
    if (form_.function) return number_of_functions<Real>(form_, from->size(), to->size(), nullptr);
    Real number(1);
    for (std::size_t i = 0; i < from->size() * to->size(); ++i) number = number + number;
    return number;
  }

  // A space of functions into an infinite set has a few members of that set as its values.
  std::vector<FunctionSpace> function_spaces(const SmallScope& scope, Context& context) const override {
    const auto *from = from_.set()->members(), *to = to_.set()->members();
    if (!form_.function || !from || from_.set()->family() || to_.set()->family()) return {};
    if (from->size() > most_grown_arguments) return {};
    if (to) return {{*from, *to, form_}};
    if (form_.surjective) return {};
    return {{*from, sorted(to_.set()->some_members(scope, context)), form_, false}};
  }

  std::optional<Value> members_up_to(std::size_t size, Context& context) const override {
    const auto *from = from_.set()->members(), *to = to_.set()->members();
    if (!from || !to || from_.set()->family() || to_.set()->family()) return std::nullopt;
    if (from->size() > most_bounded_members ||
        to->size() > most_bounded_members / std::max<std::size_t>(from->size(), 1))
      return std::nullopt;
    auto sets = all_subsets(pairs_of(*from, *to), size);
    if (!sets) return std::nullopt;
    std::erase_if(*sets, [&](const Value& each) { return contains(each, context) == Truth::no; });
    return Value::set(std::move(*sets));
  }

  std::vector<Value> some_members(const SmallScope& scope, Context& context) const override {
    if (members()) return Set::some_members(scope, context);
    std::vector<Value> to = to_.set()->some_members(scope, context);
    if (form_.total) {
      const auto* from = from_.set()->members();
      return from ? some_total(*from, to, scope.most) : some_infinite(to, scope, context);
    }
    std::vector<Value> from = from_.set()->some_members(scope, context);
    if (from.size() > most_tried_parts) from.resize(most_tried_parts);
    if (to.size() > most_tried_parts) to.resize(most_tried_parts);
    return subsets_of(pairs_of(from, to), scope.most, false);
  }

  std::string spelled(Wording wording) const override {
    return "(" + from_.set()->spelled(wording) + " " + symbol_ + " " + to_.set()->spelled(wording) + ")";
  }

 private:
  static constexpr std::size_t most_tried_parts = 4;  // of 16 pairs there are 137 sets of at most 2
  // Of an infinite table: 18 places, 12 values and 2 values elsewhere make 432 tables with one other value.
  static constexpr std::size_t most_tried_places = 18, most_tried_values = 12, most_tried_rests = 2;

  static std::vector<Value> pairs_of(const std::vector<Value>& from, const std::vector<Value>& to) {
    std::vector<Value> pairs;
    for (const Value& first : from)
      for (const Value& second : to) pairs.push_back(Value::pair(first, second));
    return pairs;
  }

  /// Total functions from these values, not all: those to the first few values, then constant ones, and one that gives
  /// each argument a value of its own.
  static std::vector<Value> some_total(const std::vector<Value>& from, const std::vector<Value>& to, std::size_t most) {
    std::size_t few = 0, ways = 0;
    const auto functions = [&](std::size_t values) {
      std::size_t product = 1;
      for (std::size_t i = 0; i < from.size() && product <= most; ++i) product *= values;
      return product;
    };
    while (few < to.size() && functions(few + 1) <= most) ways = functions(++few);
    std::vector<Value> some;
    const auto add = [&](auto&& place) {
      std::vector<Value> pairs;
      for (std::size_t i = 0; i < from.size(); ++i) pairs.push_back(Value::pair(from[i], to[place(i)]));
      some.push_back(finite(std::move(pairs)));
    };
    for (std::size_t way = 0; way < ways; ++way) {
      std::size_t rest = way;
      add([&](std::size_t) {
        const std::size_t place = rest % few;
        rest /= few;
        return place;
      });
    }
    for (std::size_t i = few; i < to.size() && !from.empty(); ++i) add([&](std::size_t) { return i; });
    if (from.size() <= to.size() && few < from.size()) add([](std::size_t i) { return i; });
    return some;
  }

  /// The first and the last of some values: small numbers come first, and numerals of what is asked last.
  static std::vector<Value> ends_of(const std::vector<Value>& values, std::size_t most) {
    if (values.size() <= most) return values;
    const auto half = static_cast<std::ptrdiff_t>(most / 2);
    std::vector<Value> ends(values.begin(), values.begin() + half);
    ends.insert(ends.end(), values.end() - half, values.end());
    return ends;
  }

  /// Whether the value is a line that is a member. Nothing where it is none, or that is not known.
  std::optional<Truth> line_in_it(const Value& value, Context& context) const {
    const auto line = integer_line(value, context);
    return line ? line_is_in(*line, from_, to_, form_, context) : std::nullopt;
  }

  /// Total functions from whole numbers, not all: lines, constant ones, and those with other values at few places.
  std::vector<Value> some_infinite(const std::vector<Value>& to, const SmallScope& scope, Context& context) const {
    const std::optional<int>* least = integers_from(*from_.set());
    std::vector<Value> some;
    if (!least) return some;
    for (const IntegerLine& line : small_lines(*least))
      if (line_is_in(line, from_, to_, form_, context) == Truth::yes) some.push_back(line_function(line));
    if (!*least) add_constant(some, to, context);
    if (*least && !form_.injective && !form_.finite) add_settled(some, **least, to, scope);
    if (some.size() > scope.most) some.resize(scope.most);
    return some;
  }

  /// Constant functions on ℤ of whole numbers.
  void add_constant(std::vector<Value>& some, const std::vector<Value>& to, Context& context) const {
    for (const Value& value : to) {
      if (!value.real() || !value.real()->is_integer()) continue;
      const IntegerLine line{std::nullopt, Real(), *value.real()};
      if (line_is_in(line, from_, to_, form_, context) == Truth::yes) some.push_back(line_function(line));
    }
  }

  void add_settled(std::vector<Value>& some, int least, const std::vector<Value>& to, const SmallScope& scope) const {
    std::vector<Value> places;
    for (const Value& rest : to) some.push_back(settled_function(least, {}, rest));
    for (const Real& number : scope.numbers)
      if (number.is_integer() && number >= Real(least)) places.emplace_back(number);
    const std::vector<Value> pairs = pairs_of(ends_of(places, most_tried_places), ends_of(to, most_tried_values));
    for (const Value& others : subsets_of(pairs, scope.most, true))
      for (std::size_t i = 0; i < std::min(to.size(), most_tried_rests); ++i)
        if (is_function(*others.set()->members()))
          some.push_back(settled_function(least, *others.set()->members(), to[i]));
  }

  static Truth each_in(const std::vector<Value>& pairs, std::size_t part, const Value& set, Context& context) {
    if (set.set()->total()) return Truth::yes;
    Truth result = Truth::yes;
    for (const Value& pair : pairs) {
      result = both(result, contains_value(set, pair.tuple()->parts[part], context));
      if (result == Truth::no) return result;
    }
    return result;
  }

  Value from_, to_;
  Arrow form_;
  std::string symbol_;
  mutable std::optional<Value> listed_;
};

}  // namespace

Value function_set(Value from, Value to, const Arrow& arrow, std::string_view symbol) {
  if (!from.set()) return from;
  if (!to.set()) return to;
  return SetPtr(std::make_shared<const FunctionSet>(std::move(from), std::move(to), arrow, symbol));
}

}  // namespace durero::zed
