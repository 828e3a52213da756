#include "toolkit_operators.hpp"

#include <algorithm>
#include <iterator>

#include "toolkit_numbers.hpp"

namespace durero::spec {
namespace {

using Ids = ValueList;

ValueId first_of(const InternedValues& values, ValueId pair) { return values.parts(pair)[0]; }
ValueId second_of(const InternedValues& values, ValueId pair) { return values.parts(pair)[1]; }

template <class Merge>
ValueId merged_members(InternedValues& values, ValueId a, ValueId b, Merge&& merge) {
  const auto left = values.members(a), right = values.members(b);
  Ids all;
  all.reserve(left.size() + right.size());
  merge(left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(all));
  return values.sorted_set(all);
}

ValueId set_union(InternedValues& values, ValueId a, ValueId b) {
  return merged_members(values, a, b, [](auto... each) { std::set_union(each...); });
}
ValueId set_intersection(InternedValues& values, ValueId a, ValueId b) {
  return merged_members(values, a, b, [](auto... each) { std::set_intersection(each...); });
}
ValueId set_difference(InternedValues& values, ValueId a, ValueId b) {
  return merged_members(values, a, b, [](auto... each) { std::set_difference(each...); });
}
ValueId symmetric_difference(InternedValues& values, ValueId a, ValueId b) {
  return merged_members(values, a, b, [](auto... each) { std::set_symmetric_difference(each...); });
}

ValueId maplet(InternedValues& values, ValueId a, ValueId b) { return values.pair(a, b); }

template <std::size_t part, bool in>
ValueId restricted_pairs(InternedValues& values, ValueId relation, ValueId to) {
  Ids kept;
  for (const ValueId pair : values.members(relation))
    if (values.has(to, values.parts(pair)[part]) == in) kept.push_back(pair);
  return values.sorted_set(kept);
}
template <bool in>
ValueId domain_restricted(InternedValues& values, ValueId set, ValueId relation) {
  return restricted_pairs<0, in>(values, relation, set);
}

ValueId domain_of(InternedValues& values, ValueId relation) {
  Ids all;
  for (const ValueId pair : values.members(relation)) all.push_back(first_of(values, pair));
  return values.set(all);
}
ValueId range_of(InternedValues& values, ValueId relation) {
  Ids all;
  for (const ValueId pair : values.members(relation)) all.push_back(second_of(values, pair));
  return values.set(all);
}
ValueId inverse_of(InternedValues& values, ValueId relation) {
  Ids all;
  for (const ValueId pair : values.members(relation))
    all.push_back(values.pair(second_of(values, pair), first_of(values, pair)));
  return values.set(all);
}
ValueId image_of(InternedValues& values, ValueId relation, ValueId set) {
  Ids all;
  for (const ValueId pair : values.members(relation))
    if (values.has(set, first_of(values, pair))) all.push_back(second_of(values, pair));
  return values.set(all);
}
ValueId overridden(InternedValues& values, ValueId relation, ValueId by) {
  return set_union(values, domain_restricted<false>(values, domain_of(values, by), relation), by);
}
ValueId composed_pairs(InternedValues& values, ValueId first, ValueId then) {
  Ids all;
  for (const ValueId a : values.members(first))
    for (const ValueId b : values.members(then))
      if (second_of(values, a) == first_of(values, b))
        all.push_back(values.pair(first_of(values, a), second_of(values, b)));
  return values.set(all);
}
ValueId backward_composed(InternedValues& values, ValueId then, ValueId first) {
  return composed_pairs(values, first, then);
}
ValueId transitive_closure(InternedValues& values, ValueId relation) {
  for (ValueId now = relation;;) {
    const ValueId more = set_union(values, now, composed_pairs(values, now, relation));
    if (more == now) return now;
    now = more;
  }
}

ValueId distributed_union(InternedValues& values, ValueId sets) {
  Ids all;
  for (const ValueId set : values.members(sets)) {
    const auto members = values.members(set);
    all.insert(all.end(), members.begin(), members.end());
  }
  return values.set(all);
}
ValueId count_of(InternedValues& values, ValueId set) {
  return values.number(static_cast<std::int64_t>(values.members(set).size()));
}

ValueId concatenated(InternedValues& values, ValueId a, ValueId b) {
  std::vector<ValueId> all = sequence_elements(values, a);
  const std::vector<ValueId> more = sequence_elements(values, b);
  all.insert(all.end(), more.begin(), more.end());
  return sequence_of(values, all);
}
std::vector<ValueId> some_elements(InternedValues& values, ValueId sequence) {
  std::vector<ValueId> all = sequence_elements(values, sequence);
  if (all.empty()) throw NotInterned("a part of an empty sequence");
  return all;
}
ValueId head_of(InternedValues& values, ValueId a) { return some_elements(values, a).front(); }
ValueId last_of(InternedValues& values, ValueId a) { return some_elements(values, a).back(); }
ValueId tail_of(InternedValues& values, ValueId a) {
  std::vector<ValueId> all = some_elements(values, a);
  all.erase(all.begin());
  return sequence_of(values, all);
}
ValueId front_of(InternedValues& values, ValueId a) {
  std::vector<ValueId> all = some_elements(values, a);
  all.pop_back();
  return sequence_of(values, all);
}
ValueId reverse_of(InternedValues& values, ValueId a) {
  std::vector<ValueId> all = sequence_elements(values, a);
  std::reverse(all.begin(), all.end());
  return sequence_of(values, all);
}
ValueId unchanged(InternedValues&, ValueId a) { return a; }
ValueId first_part(InternedValues& values, ValueId pair) { return first_of(values, pair); }
ValueId second_part(InternedValues& values, ValueId pair) { return second_of(values, pair); }
bool equal_ids(InternedValues& values, ValueId a, ValueId b) {
  if (a == b) return true;
  const auto open = [&](ValueId id) { return values.form(id) == InternedForm::other; };
  if (open(a) || open(b)) throw NotInterned("a value is known by membership");
  return false;
}
bool unequal_ids(InternedValues& values, ValueId a, ValueId b) { return !equal_ids(values, a, b); }
bool is_member(InternedValues& values, ValueId a, ValueId b) { return values.has(b, a); }
bool is_no_member(InternedValues& values, ValueId a, ValueId b) { return !values.has(b, a); }
bool is_subset(InternedValues& values, ValueId a, ValueId b) {
  const auto some = values.members(a), all = values.members(b);
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}
bool is_proper_subset(InternedValues& values, ValueId a, ValueId b) { return a != b && is_subset(values, a, b); }
bool is_less(InternedValues& values, ValueId a, ValueId b) { return values.whole_number(a) < values.whole_number(b); }
bool is_greater(InternedValues& values, ValueId a, ValueId b) { return is_less(values, b, a); }
bool is_at_most(InternedValues& values, ValueId a, ValueId b) { return !is_less(values, b, a); }
bool is_at_least(InternedValues& values, ValueId a, ValueId b) { return !is_less(values, a, b); }

template <class Operator>
struct NamedOperator {
  std::string_view name;
  Operator compute;
};

constexpr NamedOperator<UnaryOperator> unary_operators[] = {
    {"dom", domain_of},       {"ran", range_of},   {"_∼", inverse_of},  {"_⁺", transitive_closure},
    {"⋃", distributed_union}, {"#_", count_of},    {"-_", negative_of}, {"min", least_of},
    {"max", greatest_of},     {"head", head_of},   {"last", last_of},   {"tail", tail_of},
    {"front", front_of},      {"rev", reverse_of}, {"⟨,,⟩", unchanged}, {"first", first_part},
    {"second", second_part},  {"succ", successor},
};

constexpr NamedOperator<BinaryOperator> binary_operators[] = {
    {"_∪_", set_union},
    {"_∩_", set_intersection},
    {"_∖_", set_difference},
    {"_⊖_", symmetric_difference},
    {"_+_", number_sum},
    {"_-_", number_difference},
    {"_*_", number_product},
    {"_div_", number_quotient},
    {"_mod_", number_remainder},
    {"_‥_", number_interval},
    {"_↦_", maplet},
    {"_⁀_", concatenated},
    {"_⊕_", overridden},
    {"_◁_", domain_restricted<true>},
    {"_⩤_", domain_restricted<false>},
    {"_▷_", restricted_pairs<1, true>},
    {"_⩥_", restricted_pairs<1, false>},
    {"_⨾_", composed_pairs},
    {"_∘_", backward_composed},
    {"_⦇_⦈", image_of},
};

constexpr NamedOperator<BinaryRelation> binary_relations[] = {
    {"_=_", equal_ids},        {"_≠_", unequal_ids}, {"_∈_", is_member},  {"_∉_", is_no_member}, {"_⊆_", is_subset},
    {"_⊂_", is_proper_subset}, {"_<_", is_less},     {"_≤_", is_at_most}, {"_>_", is_greater},   {"_≥_", is_at_least},
};

template <class Table>
auto found_in(const Table& table, std::string_view name) {
  const auto at = std::find_if(std::begin(table), std::end(table), [&](const auto& row) { return row.name == name; });
  return at == std::end(table) ? decltype(at->compute)(nullptr) : at->compute;
}

}  // namespace

UnaryOperator unary_operator(std::string_view name) { return found_in(unary_operators, name); }
BinaryOperator binary_operator(std::string_view name) { return found_in(binary_operators, name); }
BinaryRelation binary_relation(std::string_view name) { return found_in(binary_relations, name); }

ValueId applied_pairs(const InternedValues& values, ValueId function, ValueId argument) {
  ValueId found = 0;
  for (const ValueId pair : values.members(function)) {
    const auto parts = values.parts(pair);
    if (parts[0] != argument) continue;
    if (found != 0) return 0;
    found = parts[1];
  }
  return found;
}

std::vector<ValueId> sequence_elements(const InternedValues& values, ValueId sequence) {
  const auto pairs = values.members(sequence);
  std::vector<ValueId> elements(pairs.size(), 0);
  for (const ValueId pair : pairs) {
    const auto parts = values.parts(pair);
    const std::int64_t place = values.whole_number(parts[0]);
    if (place < 1 || place > static_cast<std::int64_t>(pairs.size()) ||
        elements[static_cast<std::size_t>(place - 1)] != 0)
      throw NotInterned("a set is no sequence");
    elements[static_cast<std::size_t>(place - 1)] = parts[1];
  }
  return elements;
}

ValueId sequence_of(InternedValues& values, const std::vector<ValueId>& elements) {
  Ids pairs;
  for (std::size_t i = 0; i < elements.size(); ++i)
    pairs.push_back(values.pair(values.number(static_cast<std::int64_t>(i + 1)), elements[i]));
  return values.set(pairs);
}

}  // namespace durero::spec
