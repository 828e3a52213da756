#pragma once
/// A choice finds values for several names that make predicates true together. Equations give values, and finite sets
/// list them; where these leave a choice, it takes the first of a small range that does.

#include <string>
#include <vector>

#include "zed/evaluate/compiler.hpp"

namespace durero::zed {

class WitnessSearch {
 public:
  WitnessSearch(Compiler& compiler, Context& context) : compiler_(compiler), context_(context) {}

  /// @{ Adds a name with the set that it is declared from, and a predicate.
  void add(const Name& name, const Term& set);
  void require(const Predicate& predicate) { predicates_.push_back(predicate); }
  /// @}

  /// Says whether there are values: no where there are none, open where none of the values tried is known to do.
  Truth find();
  /// Returns the values, in the order of the names. Precondition: find() says that there are.
  const std::vector<Value>& values() const { return values_; }
  /// Says whether the value of a name was chosen where others may do as well.
  bool was_taken(std::size_t name) const { return taken_[name]; }
  /// Returns the names, with commas between them.
  std::string names_text() const;

 private:
  Truth look(std::vector<std::size_t>& tried);
  Truth complete(const std::vector<std::size_t>& tried);
  std::vector<Value> candidates(std::size_t name);

  Compiler& compiler_;
  Context& context_;
  std::vector<Name> names_;
  std::vector<Term> sets_;
  std::vector<Predicate> predicates_;
  std::vector<Value> values_;  // in step with names_
  std::vector<bool> taken_;    // in step with names_
  int tries_ = 0;
};

}  // namespace durero::zed
