/// The relations of the toolkit.

#include <algorithm>
#include <unordered_map>

#include "zed/value/functions.hpp"
#include "zed/value/sets.hpp"

namespace durero::zed {
namespace {

template <class Compare>
Truth ordered(const Value& a, const Value& b, Context& context, Compare&& holds) {
  if (a.is_undefined() || b.is_undefined()) return Truth::no;
  if (waiting(a) || waiting(b)) return compared(a, b, context);
  if (!a.real() || !b.real()) throw EvaluationError("numbers are compared that are none");
  return truth(holds(*a.real(), *b.real()));
}

/// disjoint E: no two sets of the family E share a member.
Truth pairwise_disjoint(const Value& family, Context& context) {
  if (family.is_undefined()) return Truth::no;
  if (waiting(family)) return Truth::open;
  const auto& indexed = enumerated(family, "whether this family is disjoint:");
  for (std::size_t i = 0; i < indexed.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Value shared = intersection(second(indexed[i]), second(indexed[j]), context);
      if (waiting(shared)) return Truth::open;
      if (!enumerated(shared, "whether this is empty:").empty()) return Truth::no;
    }
  }
  return Truth::yes;
}

/// E partition S: E is disjoint, and S is the union of its sets.
Truth is_partition(const Value& family, const Value& whole, Context& context) {
  const Truth apart = pairwise_disjoint(family, context);
  if (apart != Truth::yes) return apart;
  std::vector<Value> sets;
  for (const Value& one : enumerated(family, "the union of")) sets.push_back(second(one));
  return equal(big_union(Value::set(std::move(sets)), context), whole, context);
}

const std::unordered_map<std::string, ToolkitRelation>& relations() {
  static const std::unordered_map<std::string, ToolkitRelation> table{
      {"_=_", equal},
      {"_≠_",
       [](const Value& a, const Value& b, Context& c) {
         if (a.is_undefined() || b.is_undefined()) return Truth::no;
         const Necessary not_here(c, false);
         return !equal(a, b, c);
       }},
      {"_∈_", [](const Value& a, const Value& b, Context& c) { return contains_value(b, a, c); }},
      {"_∉_",
       [](const Value& a, const Value& b, Context& c) {
         if (a.is_undefined() || b.is_undefined()) return Truth::no;
         const Necessary not_here(c, false);
         return !contains_value(b, a, c);
       }},
      {"_⊆_", subset},
      {"_⊂_",
       [](const Value& a, const Value& b, Context& c) {
         const Truth in = subset(a, b, c);
         if (in != Truth::yes) return in;
         const Necessary not_here(c, false);
         return !equal(a, b, c);
       }},
      {"_<_", [](const Value& a, const Value& b, Context& c) { return ordered(a, b, c, std::less<>()); }},
      {"_≤_", [](const Value& a, const Value& b, Context& c) { return ordered(a, b, c, std::less_equal<>()); }},
      {"_>_", [](const Value& a, const Value& b, Context& c) { return ordered(a, b, c, std::greater<>()); }},
      {"_prefix_", is_prefix},
      {"_suffix_", is_suffix},
      {"_infix_", is_infix},
      {"disjoint_", [](const Value& a, const Value&, Context& c) { return pairwise_disjoint(a, c); }},
      {"_partition_", is_partition},
      {"_≥_", [](const Value& a, const Value& b, Context& c) { return ordered(a, b, c, std::greater_equal<>()); }},
  };
  return table;
}

class RelationValue : public Set {
 public:
  RelationValue(std::string name, ToolkitRelation holds) : name_(std::move(name)), holds_(holds) {}
  Truth contains(const Value& value, Context& context) const override {
    if (name_ == "disjoint_") return holds_(value, {}, context);
    if (!value.tuple()) return Truth::open;
    const Necessary not_here(context, false);
    return holds_(first(value), second(value), context);
  }
  std::string text() const override { return "(" + name_ + ")"; }

 private:
  std::string name_;
  ToolkitRelation holds_;
};

}  // namespace

ToolkitRelation toolkit_relation(const std::string& name) {
  const auto found = relations().find(name);
  return found == relations().end() ? nullptr : found->second;
}

Value relation_value(const std::string& name) {
  return SetPtr(std::make_shared<const RelationValue>(name, toolkit_relation(name)));
}

}  // namespace durero::zed
