#pragma once
/// The operations of the toolkit on settled functions.

#include <optional>

#include "durero/zed/value/settled_function.hpp"
#include "zed/operators.hpp"
#include "zed/value/context.hpp"

namespace durero::zed {

/// A settled function in its normal form: the pair of least − 1 is absent, and so is each pair of an integer from
/// `least` on whose second part is `rest`. So there is one form of each.
class SettledFunction final : public Set {
 public:
  /// Preconditions: those of settled_function().
  SettledFunction(int least, std::vector<Value> pairs, Value rest);

  int least() const { return least_; }
  const std::vector<Value>& pairs() const { return pairs_; }  ///< sorted
  const Value& rest() const { return rest_; }
  /// The value at a number; undefined outside the domain.
  Value at(const Value& number) const;
  /// Its domain, where that is ℕ or ℕ₁; undefined where it is another set.
  Value domain() const;
  /// Its finite range.
  Value range() const;

  Truth contains(const Value& pair, Context& context) const override;
  Value apply(const Value& argument, Context& context) const override;
  Truth in_domain(const Value& argument, Context& context) const override;
  std::optional<std::vector<Value>> partners(const Value& known, std::size_t part, Context& context) const override;
  std::string spelled(Wording wording) const override;

 private:
  int least_;
  std::vector<Value> pairs_;
  Value rest_;
};

/// The settled function that a value is; null where it is none.
const SettledFunction* settled(const Value& value);
/// The same of a set.
const SettledFunction* settled(const Set& set);
/// Orders settled functions totally.
std::strong_ordering compare_settled(const SettledFunction& a, const SettledFunction& b);
/// a ⊕ b, where it is a settled function; nothing where that is not known.
std::optional<Value> settled_overriding(const Value& a, const Value& b, Context& context);
/// Whether a settled function is in the set that an arrow makes between two sets. Throws EvaluationError where that is
/// not known.
Truth settled_is_in(const SettledFunction& function, const Value& from, const Value& to, const Arrow& arrow,
                    Context& context);

}  // namespace durero::zed
