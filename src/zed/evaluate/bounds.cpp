#include "zed/evaluate/bounds.hpp"

#include <algorithm>
#include <set>

#include "zed/syntax/match.hpp"
#include "zed/value/functions.hpp"
#include "zed/value/sets.hpp"
#include "zed/value/small_members.hpp"

namespace durero::zed {
namespace {

constexpr int greatest_tried = 16;                // the greatest number tried that no predicate names
constexpr std::size_t longest_tried_numeral = 9;  // the most digits of a numeral that is tried
constexpr std::size_t most_tried_numerals = 16;   // the most numerals of a goal that are tried

/// The values that a bound leaves, made of the value of the other side and of the set of the declaration.
using Leaves = Value (*)(const Value& other, const Value& declared, Context& context);

Value only_left(const Value& value, const Value&, Context&) {
  return has_intensional(value) ? Value() : Value::set({value});
}

Value members_of(const Value& set, const Value&, Context&) { return set; }

Value subsets_left(const Value& set, const Value&, Context&) { return set.set() ? power_set(set, {}) : Value(); }

/// Every sequence whose items stand in a row in s.
Value infixes_left(const Value& s, const Value&, Context&) {
  std::vector<Value> items, pieces{sequence_of({})};
  if (!s.set()) return {};
  for (const Value& pair : *s.set()->members()) {
    const Real* position = pair.tuple() ? first(pair).real() : nullptr;
    if (!position || *position != Real(static_cast<double>(items.size() + 1))) return {};
    items.push_back(second(pair));
  }
  if (items.size() * items.size() > most_bounded_members) return {};
  for (auto from = items.begin(); from != items.end(); ++from)
    for (auto to = from; to != items.end(); ++to) pieces.push_back(sequence_of({from, to + 1}));
  return Value::set(std::move(pieces));
}

template <bool less>
Value of_size_left(const Value& size, const Value& declared, Context& context) {
  const Real* most = size.real();
  if (!most || !declared.set()) return {};
  const Real greatest = less ? *most - Real(1) : *most;
  if (sign(greatest) < 0) return empty_set();
  if (greatest > Real(static_cast<double>(most_bounded_members))) return {};
  std::size_t count = 0;
  while (Real(static_cast<double>(count + 1)) <= greatest) ++count;
  return declared.set()->members_up_to(count, context).value_or(Value());
}

ValueBound bound(unsigned slot, const Code& other, Leaves leaves) {
  return {
      slot, [other, leaves](Frame& frame, const Value& declared) -> Value {
        const Necessary nothing_here(frame.context, false);
        try {
          const Value known = other(frame);
          if (has_open(known) || !closed(known) || (known.set() && (!known.set()->members() || known.set()->family())))
            return {};
          return leaves(known, declared, frame.context);
        } catch (const EvaluationError&) {  // it bounds nothing yet
          return {};
        }
      }};
}

/// Calls `visit` for each operand of a term that is made by one infix operator.
void each_operand(const Term& term, const char* word, const std::function<bool(const Name&)>& is_toolkit,
                  const std::function<void(const Term&)>& visit) {
  const Node* pair = match::operands(term, word);
  if (!pair || !is_toolkit(term->children[0]->name)) return visit(term);
  for (const Term& operand : pair->children) each_operand(operand, word, is_toolkit, visit);
}

}  // namespace

std::vector<ValueBound> bounds_of(const RelationOf& relation,
                                  const std::function<std::optional<unsigned>(const Term&)>& slot,
                                  const std::function<bool(const Name&)>& is_toolkit) {
  std::vector<ValueBound> bounds;
  const std::string& word = relation.word;
  const auto add = [&](const Term& variable, const Operand& other, Leaves leaves) {
    if (const auto at = slot(variable)) bounds.push_back(bound(*at, other.code, leaves));
  };
  const auto add_size = [&](const Operand& sized, const Operand& other, Leaves leaves) {
    const Term* of = match::argument_of(sized.term, "#_");
    if (of && is_toolkit(sized.term->children[0]->name)) add(*of, other, leaves);
  };
  if (word == "_∈_") add(relation.left.term, relation.right, members_of);
  if (word == "_⊆_" || word == "_⊂_") add(relation.left.term, relation.right, subsets_left);
  if (word == "_prefix_" || word == "_suffix_" || word == "_infix_")
    add(relation.left.term, relation.right, infixes_left);
  if (word == "_≤_") add_size(relation.left, relation.right, of_size_left<false>);
  if (word == "_<_") add_size(relation.left, relation.right, of_size_left<true>);
  if (word == "_≥_") add_size(relation.right, relation.left, of_size_left<false>);
  if (word == "_>_") add_size(relation.right, relation.left, of_size_left<true>);
  if (word != "_=_") return bounds;
  for (const bool swapped : {false, true}) {
    const Operand &made = swapped ? relation.right : relation.left, &other = swapped ? relation.left : relation.right;
    add(made.term, other, only_left);
    add_size(made, other, of_size_left<false>);
    for (const auto& [operation, leaves] : {std::pair<const char*, Leaves>{"_⁀_", infixes_left}, {"_∪_", subsets_left}})
      if (match::operands(made.term, operation))
        each_operand(made.term, operation, is_toolkit,
                     [&, leaves = leaves](const Term& operand) { add(operand, other, leaves); });
  }
  return bounds;
}

std::vector<ValueBound> collected_bounds(const Property& property) {
  std::vector<ValueBound> bounds = property.kind == Property::Kind::test ? property.bounds : std::vector<ValueBound>();
  if (property.kind == Property::Kind::all)
    for (const Property& part : property.parts) {
      std::vector<ValueBound> more = collected_bounds(part);
      std::move(more.begin(), more.end(), std::back_inserter(bounds));
    }
  if (property.kind != Property::Kind::any) return bounds;
  std::vector<std::vector<ValueBound>> sides;
  for (const Property& part : property.parts) sides.push_back(collected_bounds(part));
  for (const ValueBound& first : sides.front()) {
    std::vector<ValueBound> of_slot;
    for (const std::vector<ValueBound>& side : sides)
      for (const ValueBound& each : side)
        if (each.slot == first.slot && of_slot.size() == static_cast<std::size_t>(&side - sides.data()))
          of_slot.push_back(each);
    if (of_slot.size() != sides.size()) continue;
    bounds.push_back({first.slot, [of_slot](Frame& frame, const Value& declared) {
                        Value whole = empty_set();
                        for (const ValueBound& each : of_slot) {
                          const Value values = each.values(frame, declared);
                          if (!values.set() || !values.set()->members()) return Value();
                          whole = set_union(whole, values, frame.context);
                        }
                        return whole;
                      }});
  }
  return bounds;
}

namespace {

void add_numerals(const Term& term, std::set<Real>& to) {
  if (term->kind == Kind::number && term->name.word.size() <= longest_tried_numeral)
    for (const int step : {0, 1, -1}) to.insert(Real::natural(term->name.word) + Real(step));
  for (const Term& part : term->children) add_numerals(part, to);
  if (!term->text) return;
  for (const Declaration& declaration : term->text->declarations) add_numerals(declaration.term, to);
  for (const Predicate& predicate : term->text->predicates) add_numerals(predicate.term, to);
}

void add_numerals(const Property& property, std::set<Real>& to) {
  if (property.term) return add_numerals(property.term, to);
  for (const Property& part : property.parts) add_numerals(part, to);
}

}  // namespace

std::vector<Real> small_numbers(const Property& property) {
  std::vector<Real> numbers{Real()};
  for (int n = 1; n <= greatest_tried; ++n) {
    numbers.emplace_back(n);
    numbers.emplace_back(-n);
  }
  std::set<Real> numerals;
  add_numerals(property, numerals);
  std::size_t named = 0;
  for (const Real& numeral : numerals)
    if (numeral > Real(greatest_tried) && ++named <= most_tried_numerals) numbers.push_back(numeral);
  return numbers;
}

std::optional<std::vector<Value>> Solver::bounded(const Variable& variable, const Value& declared, Frame& frame) const {
  std::optional<std::vector<Value>> fewest;
  for (const ValueBound& bound : bounds_) {
    if (bound.slot != variable.slot) continue;
    const Value values = bound.values(frame, declared);
    const auto* members = values.set() ? values.set()->members() : nullptr;
    if (!members || values.set()->family()) continue;
    if (!fewest || members->size() < fewest->size()) fewest = *members;
  }
  if (fewest && declared.set() && declared.set()->declares_sequences())
    for (Value& each : *fewest) each = declared.set()->as_declared(each);
  return fewest;
}

}  // namespace durero::zed
