#pragma once
/// The ways that a schema admits.

#include "machine_parts.hpp"

namespace durero::spec {

/// The ways that a schema admits with some values: those that its equations give and its sets list; and where these
/// leave a name open, those with some values of that name that are tried in turn. What is tried is judged by the schema
/// alone, so a way that is found is one, and what is not found may yet be.
class Ways {
 public:
  /// Of the schema of this name, `most` at most; numbers are looked for about those of `before` too. Both outlive it.
  Ways(const Machine::Parts& parts, const std::string& schema, const zed::Valuation& before, std::size_t most)
      : parts_(parts), schema_(schema), before_(before), most_(most) {}
  /// Adds those with these values. Says whether to go on: a bound was met where not.
  bool add(const zed::Valuation& known);
  /// Adds those with these values that equations give and finite sets list. Says whether these are all, or all that a
  /// bound admits.
  bool add_listed(const zed::Valuation& known);
  /// Adds those with these values and each choice of samples for the inputs.
  void add_each(const zed::Valuation& known, const std::vector<zed::Name>& inputs);
  /// Returns what was found. Throws the EvaluationError that kept it from finding anything.
  ReachedTransitions found();

 private:
  std::optional<zed::Truth> complete(const zed::Valuation& known);
  bool look(zed::Valuation& known);
  std::optional<zed::Name> next_to_try(zed::Valuation& known) const;
  std::size_t possible(zed::Valuation& known, const zed::Name& name) const;
  std::vector<zed::Value> values(const zed::Name& name) const;

  const Machine::Parts& parts_;
  const std::string& schema_;
  const zed::Valuation& before_;
  std::size_t most_, tried_ = 0;
  ReachedTransitions found_{};
  std::optional<zed::EvaluationError> error_{};
};

}  // namespace durero::spec
