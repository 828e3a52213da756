#include "zed/value/growing_function.hpp"

#include <algorithm>

#include "durero/zed/value/undecided.hpp"
#include "zed/value/sets.hpp"

namespace durero::zed {
namespace {

/// A function between finite sets, of which some arguments have their value, or none, and of the others it is open.
class PartlyKnownFunction final : public Set {
 public:
  /// `known` are the values of the first arguments, undefined where the function has none.
  PartlyKnownFunction(const FunctionSpace& space, std::vector<Value> known)
      : from_(space.from), known_(std::move(known)), total_(space.form.total) {}

  Truth contains(const Value& pair, Context& context) const override {
    const TupleValue* tuple = pair.tuple();
    if (!tuple || has_open(tuple->parts[0])) return lost(context);
    const auto at = place(tuple->parts[0]);
    if (!at) return Truth::no;
    if (*at >= known_.size()) return lost(context);
    return known_[*at].is_undefined() ? Truth::no : equal(known_[*at], tuple->parts[1], context);
  }
  Value apply(const Value& argument, Context&) const override {
    if (has_open(argument)) return Open{};
    const auto at = place(argument);
    if (!at) return {};
    return *at < known_.size() ? known_[*at] : Value(Open{});
  }
  Truth in_domain(const Value& argument, Context& context) const override {
    if (has_open(argument)) return lost(context);
    const auto at = place(argument);
    if (!at) return Truth::no;
    if (*at < known_.size()) return truth(!known_[*at].is_undefined());
    return total_ ? Truth::yes : lost(context);
  }
  std::optional<std::vector<Value>> partners(const Value&, std::size_t, Context&) const override {
    return std::nullopt;
  }
  std::optional<Real> size() const override {
    return total_ ? std::optional(Real(static_cast<double>(from_.size()))) : std::nullopt;
  }
  bool closed() const override { return false; }
  std::string spelled(Wording) const override { return "a function that is known in part"; }

 private:
  std::optional<std::size_t> place(const Value& argument) const {
    const auto at = std::lower_bound(from_.begin(), from_.end(), argument, precedes);
    if (at == from_.end() || !same(*at, argument)) return std::nullopt;
    return static_cast<std::size_t>(at - from_.begin());
  }

  const std::vector<Value>& from_;
  std::vector<Value> known_;
  bool total_;
};

}  // namespace

Value GrowingFunction::value() const {
  std::vector<Value> known;
  for (const std::size_t place : places_) known.push_back(place == nowhere ? Value() : space_.to[place]);
  if (!is_whole()) return SetPtr(std::make_shared<const PartlyKnownFunction>(space_, std::move(known)));
  std::vector<Value> pairs;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (!known[i].is_undefined()) pairs.push_back(Value::pair(space_.from[i], known[i]));
  return finite(std::move(pairs));
}

}  // namespace durero::zed
