#pragma once
/// Predicates are compiled to properties, and a search finds values of quantified variables.

#include <memory>
#include <string>
#include <vector>

#include "zed/value/context.hpp"

namespace durero::zed {

class Search;

/// An equation is `x = e` among the conjuncts of a predicate: it determines x wherever it must hold and e does not
/// depend on x.
struct Equation {
  unsigned slot = 0;
  Code value;
  std::vector<unsigned> reads;  ///< the value depends on these slots
};

/// A property is a compiled predicate. A declaration `x : S` is one too: `x ∈ S`.
struct Property {
  enum class Kind { all, any, exists, test };
  Kind kind = Kind::all;
  std::vector<Property> parts;           ///< all and any have operands, exists one body
  std::shared_ptr<const Search> search;  ///< exists looks for its variables so
  Test test;                             ///< a test asks this
  std::vector<Equation> equations;       ///< a test `x = e` determines these
  unsigned declared = 0;                 ///< a declaration declares the variable in this slot
  Code set;                              ///< a declaration has a set, and no other property has
  std::vector<unsigned> reads;           ///< this set depends on these slots

  /// The property of a whole closed schema names the slot that may hold its binding, and the schema. A binding
  /// remembers the schema that it was found to satisfy.
  std::optional<unsigned> whole{};
  const void* schema = nullptr;

  // These say where the property comes from, for findings.
  std::string label;
  Term term;            ///< it is null for what is not written as a predicate of its own
  std::string strokes;  ///< the state that it speaks of has them: `'` under Escena '
  std::string text;     ///< a conjunct of a schema is written in Unicode, other properties are not
};

Property all_of(std::vector<Property> parts);
Property test_of(Test test, Term term = {});

Truth evaluate(const Property& property, Frame& frame);

/// A search looks for the values of variables.
struct Variable {
  std::string name;
  unsigned slot = 0;
  Code set;              ///< it is declared from this; null where only the goal says what it may be
  bool checked = false;  ///< the goal states its membership in the set already
  Code value;            ///< an equation that determines it has this other side; null where none does
};

/// Decides `∃ variables • goal` and enumerates every way to make it hold. A variable gets its values in one of three
/// ways: an equation among the conjuncts of the goal gives it; its set, where finite, is gone through; else it stays
/// unknown while the goal is evaluated, and the equations that the evaluation meets determine it (`equal`).
class Search {
 public:
  /// Finds the equations in the goal. `wholes` are the slots of bindings of whole schemas, which are empty while their
  /// components are looked for.
  Search(std::vector<Variable> variables, Property goal, std::vector<unsigned> wholes = {});

  using Visit = std::function<bool(Frame&)>;  ///< it returns false to stop

  /// Calls `visit` for each way to make the goal, and `extra`, hold. The answer is no where there was none, yes where
  /// there was one or more, and open where that cannot be said; `visit` may have been called then.
  Truth each(Frame& frame, const Visit& visit, const Test& extra = {}) const;
  Truth exists(Frame& frame, const Test& extra = {}) const { return each(frame, {}, extra); }

  /// Says whether, with the values in the variables' slots, every variable is in its set and the goal holds.
  Truth holds(Frame& frame) const;
  /// Says whether every variable is determined or in a finite set, so that each() enumerates.
  bool enumerable(Frame& frame) const;
  /// Says whether every value of the variables' types makes the goal hold.
  bool total(Frame& frame) const;
  /// Says whether equations give every variable its value, so that determine() sets them all.
  bool determined() const { return order_.size() == variables_.size(); }
  void determine(Frame& frame) const;

  const std::vector<Variable>& variables() const { return variables_; }
  const Property& goal() const { return goal_; }

 private:
  struct Run;
  std::vector<Variable> variables_;
  std::vector<std::size_t> order_;  // each determined variable stands behind what it depends on
  Property goal_;
  std::vector<unsigned> wholes_;
};

/// Adds every equation, and every declared set, among the conjuncts of a property.
void collect(const Property& property, std::vector<const Equation*>& equations, std::vector<const Property*>& declared);

/// Makes ∃ variables • property, distributed over ∨, so that each side may determine them by its own equations.
Property exists_property(std::vector<Variable> variables, Property property);

}  // namespace durero::zed
