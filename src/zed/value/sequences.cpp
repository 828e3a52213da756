/// Sequences: functions from 1‥n, and what the toolkit makes of them (ISO/IEC 13568, B.8).

#include <algorithm>
#include <unordered_map>

#include "zed/value/functions.hpp"
#include "zed/value/sets.hpp"

namespace durero::zed {
namespace {

using Values = std::vector<Value>;

Value sequence(const Values& items) {
  Values pairs;
  for (const Value& one : items) pairs.push_back(Value::pair(Real(static_cast<double>(pairs.size() + 1)), one));
  return finite(std::move(pairs));
}

/// The items in order; nothing for a relation that is no sequence. Its pairs are sorted by their first parts, so the
/// positions 1‥n, each once, stand in this order.
std::optional<Values> items(const Value& value) {
  Values found;
  for (const Value& pair : enumerated(value, "the items of")) {
    const Real* position = first(pair).real();
    if (!position || *position != Real(static_cast<double>(found.size() + 1))) return std::nullopt;
    found.push_back(second(pair));
  }
  return found;
}

/// A function of the items; undefined where its argument is no sequence, or (`some`) an empty one.
template <class Operation>
Value of_items(const Value& value, bool some, Operation&& operation) {
  return with(value, [&]() -> Value {
    const auto here = items(value);
    if (!here || (some && here->empty())) return {};
    return operation(*here);
  });
}

Value head(const Value& s, Context&) {
  return of_items(s, true, [](const Values& all) { return all.front(); });
}

Value last(const Value& s, Context&) {
  return of_items(s, true, [](const Values& all) { return all.back(); });
}

Value tail(const Value& s, Context&) {
  return of_items(s, true, [](const Values& all) { return sequence({all.begin() + 1, all.end()}); });
}

Value front(const Value& s, Context&) {
  return of_items(s, true, [](const Values& all) { return sequence({all.begin(), all.end() - 1}); });
}

Value reversed(const Value& s, Context&) {
  return of_items(s, false, [](const Values& all) { return sequence({all.rbegin(), all.rend()}); });
}

Value joined(const Value& a, const Value& b, Context&) {
  return with(a, b, [&]() -> Value {
    auto left = items(a);
    const auto right = items(b);
    if (!left || !right) return {};
    left->insert(left->end(), right->begin(), right->end());
    return sequence(*left);
  });
}

Value all_joined(const Value& sequences, Context& context) {
  return of_items(sequences, false, [&](const Values& all) {
    Value made = empty_set();
    for (const Value& one : all) made = joined(made, one, context);
    return made;
  });
}

/// A finite function of integers, its pairs renumbered from 1 in the order of their first parts.
Value squashed(const Value& function, Context&) {
  return with(function, [&]() -> Value {
    Values found;
    const Value* before = nullptr;
    for (const Value& pair : enumerated(function, "the items of")) {
      if (before && same(*before, first(pair))) return {};
      before = &first(pair);
      found.push_back(second(pair));
    }
    return sequence(found);
  });
}

Value extracted(const Value& positions, const Value& s, Context& context) {
  return squashed(restricted(s, positions, 0, true, context), context);
}

Value filtered(const Value& s, const Value& set, Context& context) {
  return squashed(restricted(s, set, 1, true, context), context);
}

Value successor(const Value& number, Context&) {
  return with(number, [&]() -> Value {
    if (!number.real()->is_integer()) return {};
    return *number.real() + Real(1);
  });
}

class SequenceSet : public Set {
 public:
  SequenceSet(Value of, bool some, bool distinct) : of_(std::move(of)), some_(some), distinct_(distinct) {}

  Truth contains(const Value& value, Context& context) const override {
    if (!value.set()) return Truth::open;
    const auto here = items(value);
    if (!here || (some_ && here->empty())) return Truth::no;
    if (distinct_ && has_intensional(value)) throw EvaluationError("whether the items differ cannot be decided");
    if (distinct_ && Value::set(*here).set()->members()->size() != here->size()) return Truth::no;
    Truth all = Truth::yes;
    for (const Value& one : *here) {
      const Truth in = contains_value(of_, one, context);
      if (in == Truth::no) return in;
      if (in == Truth::open) all = in;
    }
    return all;
  }

  std::string text() const override {
    return std::string("(") + (distinct_ ? "iseq " : some_ ? "seq₁ " : "seq ") + of_.set()->text() + ")";
  }

 private:
  Value of_;
  bool some_, distinct_;
};

/// Where in b the items of a stand in a row: at its start, at its end, or anywhere.
enum class Part { start, end, anywhere };

Truth is_part(const Value& a, const Value& b, Part part) {
  if (a.is_undefined() || b.is_undefined()) return Truth::no;
  if (waiting(a) || waiting(b)) return Truth::open;
  if (has_intensional(a) || has_intensional(b)) throw EvaluationError("sequences of sets that nobody can compare");
  const auto some = items(a), all = items(b);
  if (!some || !all || some->size() > all->size()) return Truth::no;
  const auto equal_items = [](const Value& x, const Value& y) { return same(x, y); };
  if (part == Part::anywhere)
    return truth(some->empty() ||
                 std::search(all->begin(), all->end(), some->begin(), some->end(), equal_items) != all->end());
  const auto from = part == Part::start ? all->begin() : all->end() - static_cast<std::ptrdiff_t>(some->size());
  return truth(std::equal(some->begin(), some->end(), from, equal_items));
}

}  // namespace

Truth is_prefix(const Value& a, const Value& b, Context&) { return is_part(a, b, Part::start); }
Truth is_suffix(const Value& a, const Value& b, Context&) { return is_part(a, b, Part::end); }
Truth is_infix(const Value& a, const Value& b, Context&) { return is_part(a, b, Part::anywhere); }

const ToolkitFunction* sequence_function(const std::string& name) {
  static const std::unordered_map<std::string, ToolkitFunction> table{
      {"succ", {.one = successor}}, {"head", {.one = head}},     {"last", {.one = last}},
      {"tail", {.one = tail}},      {"front", {.one = front}},   {"rev", {.one = reversed}},
      {"_⁀_", {.two = joined}},     {"⁀/", {.one = all_joined}}, {"squash", {.one = squashed}},
      {"_↿_", {.two = extracted}},  {"_↾_", {.two = filtered}},
  };
  const auto found = table.find(name);
  return found == table.end() ? nullptr : &found->second;
}

std::optional<Value> sequence_set(const std::string& name, const Value& of) {
  const bool some = name == "seq₁_", distinct = name == "iseq_";
  if (!some && !distinct && name != "seq_") return std::nullopt;
  if (!of.set()) return of;
  return SetPtr(std::make_shared<const SequenceSet>(of, some, distinct));
}

}  // namespace durero::zed
