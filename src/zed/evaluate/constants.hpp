#pragma once
/// Constants are the names of axiomatic boxes that no case, λ or law defines. An equation `c = e` gives a constant its
/// value, and all other facts about it are then checks. Constants that facts relate are sought together; where that
/// leaves a choice, a value is taken from a small range, and taken() tells so.

#include <utility>
#include <vector>

#include "zed/evaluate/definitions.hpp"

namespace durero::zed {

class Compiler;

/// Says whether predicates of the box define the name by cases, as a λ or by the laws of a power.
bool is_by_cases(const Name& name, const Axiomatic& form);
/// Returns e of an equation `name = e`, where the name is not in e; else null.
const Term* other_side(const Term& equation, const Name& name);
/// Returns the set that the box declares the name from, or null.
const Term* declared_set(const Name& name, const Axiomatic& form);

class Constants {
 public:
  explicit Constants(Compiler& compiler) : compiler_(compiler) {}

  /// Returns the value of a constant, and stores it, and the values of all constants found with it, in their meanings.
  /// Throws Unsatisfied where a fact about it is false, Undetermined where nothing gives it a value.
  Value value(Meaning& constant, Context& context);
  /// Throws Unsatisfied where the value of the constant makes a fact false that concerns it and constants whose values
  /// equations give. Precondition: it has a value.
  void check(const Meaning& constant, Context& context);

  /// The names of all constants.
  std::vector<Name> names();
  /// The constants that no equation determines, with the values that were taken for them.
  const std::vector<std::pair<Name, Value>>& taken() const { return taken_; }

 private:
  /// A conjunct of an axiomatic box that defines no function and no set, and the constants in it.
  struct Fact {
    Predicate predicate;
    std::vector<Meaning*> constants;
  };
  const std::vector<Fact>& facts();
  void add_facts(const Axiomatic& form);
  void add_declaration(Meaning& constant);
  Value by_equation(const Meaning& constant, Context& context);
  Value as_declared(const Value& value, const Meaning& constant, Context& context);
  bool is_given_by_equation(const Meaning& constant);
  bool is_known_apart(Meaning& constant, Context& context);
  std::vector<Meaning*> known_together(Meaning& constant, Context& context);
  Value looked_for(Meaning& constant, Context& context);

  Compiler& compiler_;
  std::vector<Meaning*> constants_;
  std::vector<Fact> facts_;
  bool has_facts_ = false;
  std::vector<std::pair<Name, Value>> taken_;
};

}  // namespace durero::zed
