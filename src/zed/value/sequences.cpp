/// Sequences are functions from 1‥n; the toolkit makes what follows of them (ISO/IEC 13568, B.8).

#include <algorithm>

#include "durero/zed/value/undecided.hpp"
#include "zed/value/functions.hpp"
#include "zed/value/growing_function.hpp"
#include "zed/value/sets.hpp"
#include "zed/value/small_members.hpp"
#include "zed/value/toolkit_functions.hpp"

namespace durero::zed {
namespace {

using Values = std::vector<Value>;

Value sequence(const Values& items) { return sequence_of(items); }

/// Returns the items in order; nothing for a relation that is no sequence. Its pairs are sorted by their first parts,
/// so the positions 1‥n, each once, stand in this order.
std::optional<Values> items(const Value& value) {
  Values in_order;
  for (const Value& pair : enumerated(value, "the items of")) {
    const Real* position = first(pair).real();
    if (!position || *position != Real(static_cast<double>(in_order.size() + 1))) return std::nullopt;
    in_order.push_back(second(pair));
  }
  return in_order;
}

/// Computes a function of the items, which is undefined where its argument is no sequence, or, with `nonempty`, an
/// empty one.
template <class Operation>
Value of_items(const Value& value, bool nonempty, Operation&& operation) {
  return with(value, [&]() -> Value {
    const auto in_order = items(value);
    if (!in_order || (nonempty && in_order->empty())) return {};
    return operation(*in_order);
  });
}

class SequenceSet : public Set {
 public:
  /// A set of non-empty sequences is seq₁, one of sequences with distinct items is iseq.
  SequenceSet(Value of, bool nonempty, bool distinct) : of_(std::move(of)), nonempty_(nonempty), distinct_(distinct) {}

  Truth contains(const Value& value, Context& context) const override {
    if (!value.set()) return lost(context);
    const auto in_order = items(value);
    if (!in_order || (nonempty_ && in_order->empty())) return Truth::no;
    if (distinct_ && has_intensional(value))
      throw LackingEvaluation(Lack::members, "whether the items differ cannot be decided");
    if (distinct_ && Value::set(*in_order).set()->members()->size() != in_order->size()) return Truth::no;
    Truth each = Truth::yes;
    for (const Value& item : *in_order) {
      const Truth inside = contains_value(of_, item, context);
      if (inside == Truth::no) return inside;
      if (inside == Truth::open) each = inside;
    }
    return each;
  }

  bool closed() const override { return zed::closed(of_); }

  bool declares_sequences() const override { return true; }
  Value as_declared(const Value& member) const override {
    const bool parts = of_.set()->declares_sequences();
    const auto in_order = member.set() && member.set()->members() && (parts || !member.set()->is_sequence())
                              ? items(member)
                              : std::nullopt;
    if (!in_order) return member;
    Values declared;
    for (const Value& item : *in_order) declared.push_back(parts ? of_.set()->as_declared(item) : item);
    return sequence(declared);
  }

  // The sequences of distinct members of a finite set are finitely many, and so are those of none.
  const std::vector<Value>* members() const override {
    const auto* of = of_.set()->members();
    if (!of || of_.set()->family() || !(distinct_ || of->empty()) || of->size() > most_listed_items) return nullptr;
    if (!listed_) listed_ = up_to(*of, of->size());
    return listed_->set()->members();
  }
  std::size_t listed() const override { return listed_ ? listed_->set()->listed() : 0; }

  std::optional<Value> members_up_to(std::size_t size, Context&) const override {
    const auto* of = of_.set()->family() ? nullptr : of_.set()->members();
    return of ? up_to(*of, size) : std::nullopt;
  }

  std::vector<Value> some_members(const SmallScope& scope, Context& context) const override {
    if (members()) return Set::some_members(scope, context);
    std::vector<Value> items = of_.set()->some_members(scope, context);
    if (items.size() > most_tried_items) items.resize(most_tried_items);
    return sequences_of(items, scope.most, nonempty_, distinct_);
  }

  std::vector<FunctionSpace> function_spaces(const SmallScope& scope, Context& context) const override {
    if (of_.set()->family()) return {};
    const auto* of = of_.set()->members();
    const Values to = of ? *of : sorted(of_.set()->some_members(scope, context));
    std::vector<FunctionSpace> spaces;
    for (std::size_t length = nonempty_ ? 1 : 0; length <= most_tried_length; ++length) {
      Values places;
      for (std::size_t i = 1; i <= length; ++i) places.emplace_back(Real(static_cast<double>(i)));
      spaces.push_back({std::move(places), to, Arrow{.total = true, .injective = distinct_}, false});
    }
    return spaces;
  }

  std::string spelled(Wording wording) const override {
    return std::string("(") + (distinct_ ? "iseq " : nonempty_ ? "seq₁ " : "seq ") + of_.set()->spelled(wording) + ")";
  }

 private:
  static constexpr std::size_t most_listed_items = 7;  // of 7 members there are 13700 sequences, and of 8 some 110000
  static constexpr std::size_t most_tried_items = 5;   // of 5 there are 31 sequences of at most 2
  static constexpr std::size_t most_tried_length = 8;  // of sequences that grow

  std::optional<Value> up_to(const Values& of, std::size_t length) const {
    auto sequences = all_sequences(of, length, distinct_);
    if (!sequences) return std::nullopt;
    if (nonempty_) sequences->erase(sequences->begin());
    return Value::set(std::move(*sequences));
  }

  Value of_;
  bool nonempty_, distinct_;
  mutable std::optional<Value> listed_;
};

Value sequence_set(const Value& of, bool nonempty, bool distinct) {
  if (!of.set()) return of;
  return SetPtr(std::make_shared<const SequenceSet>(of, nonempty, distinct));
}

/// Says where in b the items of a stand in a row: at its start, at its end, or anywhere.
enum class SequencePosition { start, end, anywhere };

Truth is_part(const Value& a, const Value& b, SequencePosition part, Context& context) {
  if (a.is_undefined() || b.is_undefined()) return Truth::no;
  if (waiting(a) || waiting(b)) return lost(context);
  if (has_intensional(a) || has_intensional(b))
    throw LackingEvaluation(Lack::members, "sequences of sets that nobody can compare");
  const auto piece = items(a), whole = items(b);
  if (!piece || !whole || piece->size() > whole->size()) return Truth::no;
  const auto equal_items = [](const Value& x, const Value& y) { return same(x, y); };
  if (part == SequencePosition::anywhere)
    return truth(piece->empty() ||
                 std::search(whole->begin(), whole->end(), piece->begin(), piece->end(), equal_items) != whole->end());
  const auto from =
      part == SequencePosition::start ? whole->begin() : whole->end() - static_cast<std::ptrdiff_t>(piece->size());
  return truth(std::equal(piece->begin(), piece->end(), from, equal_items));
}

}  // namespace

namespace functions {

Value successor(const Value& number, Context&) {
  return with(number, [&]() -> Value {
    if (!number.real()->is_integer() || sign(*number.real()) < 0) return {};
    return *number.real() + Real(1);
  });
}

/// ⟨a, b⟩ is written as this function of the set {(1, a), (2, b)}: the sequence is that set.
Value sequence_of_pairs(const Value& pairs, Context&) {
  return of_items(pairs, false, [](const Values& items) { return sequence(items); });
}

Value sequences(const Value& set, Context&) { return sequence_set(set, false, false); }
Value nonempty_sequences(const Value& set, Context&) { return sequence_set(set, true, false); }
Value injective_sequences(const Value& set, Context&) { return sequence_set(set, false, true); }

Value head(const Value& s, Context&) {
  return of_items(s, true, [](const Values& items) { return items.front(); });
}

Value last(const Value& s, Context&) {
  return of_items(s, true, [](const Values& items) { return items.back(); });
}

Value tail(const Value& s, Context&) {
  return of_items(s, true, [](const Values& items) { return sequence({items.begin() + 1, items.end()}); });
}

Value front(const Value& s, Context&) {
  return of_items(s, true, [](const Values& items) { return sequence({items.begin(), items.end() - 1}); });
}

Value reversed(const Value& s, Context&) {
  return of_items(s, false, [](const Values& items) { return sequence({items.rbegin(), items.rend()}); });
}

Value concatenation(const Value& a, const Value& b, Context&) {
  return with(a, b, [&]() -> Value {
    auto left = items(a);
    const auto right = items(b);
    if (!left || !right) return {};
    left->insert(left->end(), right->begin(), right->end());
    return sequence(*left);
  });
}

Value distributed_concatenation(const Value& sequences, Context& context) {
  return of_items(sequences, false, [&](const Values& items) {
    Value whole = empty_set();
    for (const Value& piece : items) {
      context.steps.take(1 + steps_for(whole));
      whole = concatenation(whole, piece, context);
    }
    return whole;
  });
}

/// Renumbers the pairs of a finite function of integers from 1 in the order of their first parts.
Value squashed(const Value& function, Context&) {
  return with(function, [&]() -> Value {
    Values in_order;
    const Value* before = nullptr;
    for (const Value& pair : enumerated(function, "the items of")) {
      if (before && same(*before, first(pair))) return {};
      before = &first(pair);
      in_order.push_back(second(pair));
    }
    return sequence(in_order);
  });
}

Value extraction(const Value& positions, const Value& s, Context& context) {
  return squashed(restricted(s, positions, 0, true, context), context);
}

Value filtering(const Value& s, const Value& set, Context& context) {
  return squashed(restricted(s, set, 1, true, context), context);
}

}  // namespace functions

namespace relations {

Truth is_prefix(const Value& a, const Value& b, Context& context) {
  return is_part(a, b, SequencePosition::start, context);
}
Truth is_suffix(const Value& a, const Value& b, Context& context) {
  return is_part(a, b, SequencePosition::end, context);
}
Truth is_infix(const Value& a, const Value& b, Context& context) {
  return is_part(a, b, SequencePosition::anywhere, context);
}

}  // namespace relations

}  // namespace durero::zed
