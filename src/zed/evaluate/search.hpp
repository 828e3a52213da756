#pragma once
/// Predicates are compiled to properties, and a search finds values of quantified variables.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "zed/value/context.hpp"

namespace durero::zed {

class Solver;
class LinearQuestion;

/// An equation is `x = e` among the conjuncts of a predicate: it determines x wherever it must hold and e does not
/// depend on x.
struct Equation {
  unsigned slot = 0;
  Code value;
  std::vector<unsigned> reads;  ///< the value depends on these slots
};

/// A bound is what a conjunct says of a variable: wherever it holds, the value is one of finitely many.
struct ValueBound {
  unsigned slot = 0;
  /// Returns a finite set with each such value that is in the set from which the variable is declared. Undefined where
  /// they cannot be listed yet.
  std::function<Value(Frame&, const Value& declared)> values;
};

/// A property is a compiled predicate. A declaration `x : S` is one too: `x ∈ S`.
struct Property {
  enum class Kind { all, any, exists, test };
  Kind kind = Kind::all;
  std::vector<Property> parts;                     ///< all and any have operands, exists one body
  std::shared_ptr<const Solver> search;            ///< exists looks for its variables so
  std::shared_ptr<const LinearQuestion> linear{};  ///< and may decide by this where the search does not
  Test test;                                       ///< a test asks this
  std::vector<Equation> equations;                 ///< a test `x = e` determines these
  std::vector<Equation> spans;                     ///< a test `dom x = e` or `ran x = e` determines x where e is empty
  std::vector<ValueBound> bounds{};                ///< a test bounds these variables
  std::vector<Property> links{};                   ///< a test a < b < c is the conjunction of these
  unsigned declared = 0;                           ///< a declaration declares the variable in this slot
  Code set;                                        ///< a declaration has a set, and no other property has
  std::vector<unsigned> reads;                     ///< this set depends on these slots
  /// The slots that a relation depends on, with those of the variables that its operands bind; other properties leave
  /// them out.
  std::optional<std::vector<unsigned>> depends{};

  /// The property of a whole closed schema names the slot that may hold its binding, and the schema. A binding
  /// remembers the schema that it was found to satisfy.
  std::optional<unsigned> whole{};
  const void* schema = nullptr;

  // The members below give the origin of the property, for findings.
  std::string label;
  Term term;            ///< it is null for a property that is not written as a predicate of its own
  std::string strokes;  ///< the state that it speaks of has them: `'` under Escena '
  /// A conjunct of a schema is written as its term, or as `declares ∈ term` or `declares = term`.
  enum class Written : std::uint8_t { no, term, member, equal };
  Written written = Written::no;
  Name declares;
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
class Solver {
 public:
  /// Finds the equations in the goal. `wholes` are the slots of bindings of whole schemas, which are empty while their
  /// components are looked for.
  Solver(std::vector<Variable> variables, Property goal, std::vector<unsigned> wholes = {});

  using Visit = std::function<bool(Frame&)>;  ///< it returns false to stop

  /// Calls `visit` for each way to make the goal, and `extra`, hold. The answer is no where there was none, yes where
  /// there was one or more, and open where that cannot be said; `visit` may have been called then.
  Truth each(Frame& frame, const Visit& visit, const Test& extra = {}) const;
  Truth exists(Frame& frame, const Test& extra = {}) const { return each(frame, {}, extra); }
  /// Looks for one way, also among small values as exists() does, and calls `visit` for it. The answer is that of
  /// exists(), and yes only where there was a visit.
  Truth first(Frame& frame, const Visit& visit) const;

  /// Says whether, with the values in the variables' slots, every variable is in its set and the goal holds.
  Truth holds(Frame& frame) const;
  /// Says whether every variable is determined or in a finite set, so that each() enumerates.
  bool enumerable(Frame& frame) const;
  /// Says which numbers the only variable ranges over; none where there are several variables, or it is not known.
  Numbers numbers(Frame& frame) const;
  /// Says whether a search for all values is worth while: some variable is a number of an infinite set, or has a bound,
  /// the others are determined or in finite sets, and the goal states more than memberships in these sets.
  bool may_be_listed(Frame& frame) const;
  /// Says whether every value of the variables' types makes the goal hold.
  bool total(Frame& frame) const;
  /// Says whether equations give every variable its value, so that determine() sets them all.
  bool determined() const { return order_.size() == variables_.size(); }
  void determine(Frame& frame) const;
  /// Gives the empty relation to each variable whose domain or range is empty by the goal. Says whether there are any.
  bool determine_empty(Frame& frame) const;

  const std::vector<Variable>& variables() const { return variables_; }
  const Property& goal() const { return goal_; }

  /// @{ Looks for numbers in `set` for a variable that is not known yet. candidates() returns every number that is
  /// allowed by the conjuncts, and by `extra`, without any other unknown; some_number() tells whether some number makes
  /// the goal and `extra` hold. Nothing where that cannot be decided.
  std::optional<std::vector<Real>> candidates(const Variable& variable, const Set& set, Frame& frame,
                                              const Test& extra) const;
  std::optional<Truth> some_number(const Variable& variable, const Set& set, Frame& frame, const Test& extra) const;
  /// @}
  /// Returns finitely many values that a variable which is not known yet can only have: the fewest that a bound gives.
  /// Nothing where none does.
  std::optional<std::vector<Value>> bounded(const Variable& variable, const Value& declared, Frame& frame) const;
  /// Returns the numbers that are tried where nothing bounds them: small ones, and the numerals of the goal with their
  /// neighbours.
  const std::vector<Real>& numbers_to_try() const { return numbers_to_try_; }

 private:
  struct Run;
  Truth all_of_run(Run& run) const;
  bool refuted(Frame& frame) const;
  std::vector<Variable> variables_;
  std::vector<std::size_t> order_;  // each determined variable stands behind what it depends on
  Property goal_;
  std::vector<Test>
      apart_;  // these conjuncts of the goal depend on no variable, so they are asked before any is sought
  std::vector<Equation> spans_;
  std::vector<ValueBound> bounds_;
  std::vector<Real> numbers_to_try_;
  std::vector<unsigned> wholes_;
};

/// Says whether a property states memberships of variables in sets and no more.
bool only_declarations(const Property& property);

/// Adds the conjuncts of a property that are no conjunctions; those of a < b < c are its links.
void conjuncts_of(const Property& property, std::vector<const Property*>& to);

/// Adds every equation for the domain or the range of a variable, among the conjuncts of a property.
void collect_spans(const Property& property, std::vector<Equation>& spans);

/// Adds every equation, and every declared set, among the conjuncts of a property.
void collect(const Property& property, std::vector<const Equation*>& equations, std::vector<const Property*>& declared);

/// Makes ∃ variables • property, distributed over ∨ as sides_of() does, so that each side may determine them by its own
/// equations.
Property exists_property(std::vector<Variable> variables, Property property);

/// Returns properties of which one at least holds where this one does, with ∧ distributed over ∨ as far as there are at
/// most `most_sides` of them: each may determine the variables by its own equations.
std::vector<Property> sides_of(const Property& property);
inline constexpr std::size_t most_sides = 64;

}  // namespace durero::zed
