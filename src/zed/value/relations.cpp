/// These are the relations of the toolkit.

#include <algorithm>
#include <functional>

#include "zed/value/functions.hpp"
#include "zed/value/sets.hpp"
#include "zed/value/toolkit_functions.hpp"

namespace durero::zed {
namespace {

template <class Compare>
Truth ordered(const Value& a, const Value& b, Context& context, Compare&& holds) {
  if (a.is_undefined() || b.is_undefined()) return Truth::no;
  if (waiting(a) || waiting(b)) return compared(a, b, context);
  if (!a.real() || !b.real()) throw EvaluationError("numbers are compared that are none");
  return truth(holds(*a.real(), *b.real()));
}

}  // namespace

namespace relations {

Truth unequal(const Value& a, const Value& b, Context& context) {
  if (a.is_undefined() || b.is_undefined()) return Truth::no;
  const Necessary nothing_here(context, false);
  return !equal(a, b, context);
}

Truth element_of(const Value& a, const Value& set, Context& context) { return contains_value(set, a, context); }

Truth no_element_of(const Value& a, const Value& set, Context& context) {
  if (a.is_undefined() || set.is_undefined()) return Truth::no;
  const Necessary nothing_here(context, false);
  return !contains_value(set, a, context);
}

Truth proper_subset(const Value& a, const Value& b, Context& context) {
  const Truth inside = subset(a, b, context);
  if (inside != Truth::yes) return inside;
  const Necessary nothing_here(context, false);
  return !equal(a, b, context);
}

Truth less(const Value& a, const Value& b, Context& context) { return ordered(a, b, context, std::less<>()); }
Truth at_most(const Value& a, const Value& b, Context& context) { return ordered(a, b, context, std::less_equal<>()); }
Truth greater(const Value& a, const Value& b, Context& context) { return ordered(a, b, context, std::greater<>()); }
Truth at_least(const Value& a, const Value& b, Context& context) {
  return ordered(a, b, context, std::greater_equal<>());
}

/// disjoint E says that no two sets of the family E share a member.
Truth is_disjoint(const Value& family, Context& context) {
  if (family.is_undefined()) return Truth::no;
  if (waiting(family)) return lost(context);
  const auto& indexed = enumerated(family, "whether this family is disjoint:");
  const Computing intersections(context);
  for (std::size_t i = 0; i < indexed.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      context.steps.take(1 + steps_for(second(indexed[i])) + steps_for(second(indexed[j])));
      const Value shared = intersection(second(indexed[i]), second(indexed[j]), context);
      if (waiting(shared)) return lost(context);
      if (!enumerated(shared, "whether this is empty:").empty()) return Truth::no;
    }
  }
  return Truth::yes;
}

/// E partition S says that E is disjoint, and S is the union of its sets.
Truth is_partition(const Value& family, const Value& whole, Context& context) {
  const Truth apart = is_disjoint(family, context);
  if (apart != Truth::yes) return apart;
  std::vector<Value> sets;
  for (const Value& pair : enumerated(family, "the union of")) sets.push_back(second(pair));
  return equal(big_union(Value::set(std::move(sets)), context), whole, context);
}

}  // namespace relations

namespace {

class RelationValue : public Set {
 public:
  explicit RelationValue(const OperatorRow& row) : row_(row) {}
  Truth contains(const Value& value, Context& context) const override {
    if (row_.evaluation.property) return row_.evaluation.property(value, context);
    if (!value.tuple()) return lost(context);
    const Necessary nothing_here(context, false);
    return row_.evaluation.relation(first(value), second(value), context);
  }
  std::string spelled(Wording) const override { return "(" + std::string(row_.name) + ")"; }

 private:
  const OperatorRow& row_;
};

}  // namespace

Value toolkit_relation(const OperatorRow& row) { return SetPtr(std::make_shared<const RelationValue>(row)); }

}  // namespace durero::zed
