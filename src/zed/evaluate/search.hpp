#pragma once
/// Predicates, compiled, and the search for values of quantified variables.

#include <memory>
#include <string>
#include <vector>

#include "zed/value/context.hpp"

namespace durero::zed {

class Search;

/// `x = e` among the conjuncts of a predicate: it determines x wherever it must hold and e does not depend on x.
struct Equation {
  unsigned slot = 0;
  Code value;
  std::vector<unsigned> reads;  ///< the slots that the value depends on
};

/// A predicate. A declaration is one too: `x ∈ S`.
struct Property {
  enum class Kind { all, any, exists, test };
  Kind kind = Kind::all;
  std::vector<Property> parts;           ///< of all and any; of exists the one that it is about
  std::shared_ptr<const Search> search;  ///< of exists
  Test test;                             ///< of test
  std::vector<Equation> equations;       ///< of a test `x = e`
  unsigned declared = 0;                 ///< of a declaration: the slot …
  Code set;                              ///< … its set, empty otherwise …
  std::vector<unsigned> reads;           ///< … and the slots that the set depends on

  /// Of the property of a whole closed schema: the slot that may hold its binding, and the schema. A binding
  /// remembers the schema that it was found to satisfy.
  std::optional<unsigned> whole{};
  const void* schema = nullptr;

  // Where it comes from.
  std::string label;
  Term term;            ///< null for what is not written as a predicate of its own
  std::string strokes;  ///< of the state that it speaks of: `'` under Escena '
  std::string text;     ///< of a conjunct of a schema: in Unicode; empty otherwise
};

Property all_of(std::vector<Property> parts);
Property test_of(Test test, Term term = {});

Truth evaluate(const Property& property, Frame& frame);

/// A variable that is looked for, and where.
struct Variable {
  std::string name;
  unsigned slot = 0;
  Code set;              ///< null where only the goal says
  bool checked = false;  ///< membership stands in the goal already
  Code value;            ///< of the equation that determines it, if any
};

/// `∃ variables • goal`, and the enumeration of every way to make it hold. Three ways give a variable its values:
/// an equation, where one stands among the conjuncts of the goal; its set, where that is finite; else it is unknown
/// while the goal is evaluated, and the equations that the evaluation meets determine it (`equal`).
class Search {
 public:
  /// Sees the equations in the goal.
  /// `wholes`: the slots of bindings of whole schemas, which are empty while their components are looked for.
  Search(std::vector<Variable> variables, Property goal, std::vector<unsigned> wholes = {});

  using Visit = std::function<bool(Frame&)>;  ///< false to stop

  /// Calls `visit` for each way to make the goal, and `extra`, hold. No: there was none. Yes: there was one, or more.
  /// Open: that cannot be said; `visit` may have been called.
  Truth each(Frame& frame, const Visit& visit, const Test& extra = {}) const;
  Truth exists(Frame& frame, const Test& extra = {}) const { return each(frame, {}, extra); }

  /// With the variables' values in their slots: every variable is in its set, and the goal holds.
  Truth holds(Frame& frame) const;
  /// True where every variable is determined or in a finite set, so that each() enumerates.
  bool enumerable(Frame& frame) const;
  /// True where every value of the variables' types makes the goal hold.
  bool total(Frame& frame) const;
  /// Sets the determined variables, where their equations give them a value.
  bool determined() const { return order_.size() == variables_.size(); }
  void determine(Frame& frame) const;

  const std::vector<Variable>& variables() const { return variables_; }
  const Property& goal() const { return goal_; }

 private:
  struct Run;
  std::vector<Variable> variables_;
  std::vector<std::size_t> order_;  // of the determined variables, each behind what it depends on
  Property goal_;
  std::vector<unsigned> wholes_;
};

/// Every equation, and every declared set, among the conjuncts of a property.
void collect(const Property& property, std::vector<const Equation*>& equations, std::vector<const Property*>& declared);

/// ∃ variables • property, distributed over ∨, so that each side may determine them by its own equations.
Property exists_property(std::vector<Variable> variables, Property property);

}  // namespace durero::zed
