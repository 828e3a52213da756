#pragma once
/// Evaluates Z on given values: expressions, predicates, and whether values satisfy a schema and which of its
/// conjuncts they break.
///
/// Conventions. An application of a function outside its domain, or of a relation that is no function there, has no
/// value, and the predicate that it stands in directly (a relation) is false. Quantified variables range over finite
/// sets, or are determined by the one-point rule: `x = e` determines x, and so does an equation that is linear in x, a
/// number; the rule sees through definitions, so `p ∈ ⋃ { t : Rmas • E }` finds t. What neither gives is an error
/// that says so, never a guess. Numbers are exact: `Real`. The root of a number is known to be one by its axiom,
/// `f(r) * f(r) = r`; a power by its laws, where twice its exponent is whole.
///
/// An evaluator compiles each paragraph when it is first used, and is not for use by two threads at once. The
/// intensional sets, functions and schema checks that it gave are not for use after its end.

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "durero/zed/syntax/reader.hpp"
#include "durero/zed/value/steps.hpp"
#include "durero/zed/value/value.hpp"

namespace durero::zed {

/// Values for names. For a name that stands in the list twice, the last counts.
using Valuation = std::vector<std::pair<Name, Value>>;

/// A finding is a conjunct of a schema, which is a predicate or a declaration `x ∈ S`, with its truth.
struct ConjunctTruth {
  std::string label;         ///< a declaration has none
  std::string predicate;     ///< it is written in Unicode
  std::string strokes;       ///< the state that it speaks of has them: `'` for Escena ' in an operation
  Place place;               ///< the predicate begins here, or S of `x ∈ S`; 0:0 where no text says it, as in ΞS
  Truth truth = Truth::yes;  ///< `open` where it depends on a component that is not given
};

/// Compiles a schema once, and asks it of values in the order of its components.
class SchemaCheck {
 public:
  /// Returns the names of the components, in the order of their declaration.
  const std::vector<Name>& components() const;
  /// Says whether the values, one for each component, satisfy the schema. A component that is not known is `Open`.
  /// Throws EvaluationError where the values are not as many as the components.
  Truth holds(std::span<const Value> values) const;
  /// The truth of the last predicate of a schema, and of all conjuncts before it.
  struct Apart {
    Truth before;  ///< the declarations, and the predicates but one
    Truth last;    ///< the last predicate, which is asked only where these hold; open elsewhere
  };
  /// The facts that are known about the values.
  struct KnownTruth {
    std::vector<bool> parts;  ///< which declarations and predicates hold, in their order; none where it is empty
    std::vector<BindingPtr> bindings;  ///< the values of some components are those of this binding
  };
  /// Returns both truths apart. The conjunct that was last found false is asked first, as it is likely to be false
  /// again. Precondition: the schema is a text [ D | P ] with a predicate. Throws as holds() does.
  Apart apart(std::span<const Value> values, const KnownTruth& known) const;
  /// Says whether some conjunct before the last predicate is false, whatever values stand for the open ones. An
  /// undecided conjunct refutes nothing. Preconditions: those of apart().
  bool refuted(std::span<const Value> values, const KnownTruth& known) const;
  /// Returns the truth of the last predicate alone. Precondition and errors: those of apart().
  Truth last(std::span<const Value> values, const KnownTruth& known) const;
  /// Returns every conjunct with its truth. A disjunction gives those of a side that holds; else those of the side
  /// with the fewest false conjuncts.
  std::vector<ConjunctTruth> findings(std::span<const Value> values) const;

 private:
  friend class Evaluator;
  struct State;
  std::shared_ptr<const State> state_;
};

/// Compiles a schema once, and looks for values of some of its components that satisfy it with the others.
class Completion {
 public:
  /// Returns the names of the components that are looked for.
  const std::vector<Name>& sought() const;
  /// Calls `visit`, which returns false to stop, for values of the sought components that satisfy the schema with these
  /// values of the others, in their order; the same values may come again. The answer is no where there are none, yes
  /// where all were found, and open where there may be others, as nothing determines or lists them.
  Truth each(std::span<const Value> known, const std::function<bool(std::span<const Value> sought)>& visit) const;
  /// Looks for one way, also among small values where nothing determines or lists them, and calls `visit` for it. The
  /// answer is yes where there was a visit, no where there is no way, and open where none was found.
  Truth first(std::span<const Value> known, const std::function<void(std::span<const Value> sought)>& visit) const;

 private:
  friend class Evaluator;
  struct State;
  struct Visited;
  std::shared_ptr<const State> state_;
};

/// Evaluates terms with the meaning that the paragraphs of some sections give to names.
class Evaluator {
 public:
  /// Evaluates on these sections. `given` has values of names that they declare and do not define, and finite sets for
  /// given sets, which have no other members then; throws EvaluationError for any other name. What is asked counts its
  /// steps, in `steps` where that is given, which outlives the evaluator; all that follow then throw StepsSpent where
  /// they take too many.
  explicit Evaluator(std::vector<Section> sections, const Valuation& given = {}, Steps* steps = nullptr);
  ~Evaluator();
  /// Takes over the other evaluator, which is then for its end or an assignment only. Its earlier results stay in use.
  Evaluator(Evaluator&&) noexcept;
  /// Takes over the other evaluator likewise. Earlier results of this one are not for use any more.
  Evaluator& operator=(Evaluator&&) noexcept;

  /// Returns the value of an expression, or the truth of a predicate, with these local names. All that follow throw
  /// EvaluationError for what cannot be decided.
  Value value(const Term& expression, const Valuation& locals = {}) const;
  /// Returns the truth of a predicate, or of a schema in its place, with these local names.
  Truth holds(const Term& predicate, const Valuation& locals = {}) const;
  /// Returns the value of a declared name.
  Value value(const Name& name) const;
  /// Returns some small members of a set (Set::some_members).
  std::vector<Value> some_members(const Value& set, const SmallScope& scope) const;
  /// Says whether value ∈ set.
  Truth contains(const Value& set, const Value& value) const;
  /// Returns the polynomials in t, of degree two at most, whose signs decide `value(t) ∈ set` for a number t that is
  /// not given. Between neighbouring roots of these it is true throughout, or false throughout. Throws EvaluationError
  /// where it depends on t in any other way.
  std::vector<Polynomial> comparisons(const Value& set, const std::function<Value(Unknown t)>& value) const;
  /// Returns function(argument), which is undefined outside the domain.
  Value apply(const Value& function, const Value& argument) const;

  /// Returns the constants: names of axiomatic boxes that are known by no case, λ or law.
  std::vector<Name> constants() const;
  /// Returns the constants whose value was chosen so far among several that satisfy the facts about them, with these
  /// values: results that depend on one were found for its value.
  Valuation taken() const;
  /// Throws Unsatisfied where the value given for a constant makes a fact of the text about it false.
  void check_given(const Name& constant) const;

  /// Compiles the schema of this name. Throws EvaluationError where the name is no schema's.
  SchemaCheck schema(const Name& name) const;
  /// Compiles it where these components of it are known, and the others sought.
  Completion completion(const Name& schema, const std::vector<Name>& known) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace durero::zed
