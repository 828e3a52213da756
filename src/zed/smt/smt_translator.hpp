#pragma once
/// Predicates of Z are translated to formulas of SMT-LIB as far as these cover them: numbers and their arithmetic,
/// members of finite given sets and enumerated free types, tuples, bindings and finite sets of these, comparisons,
/// memberships, the connectives and quantifiers. A part that depends on no quantified variable is evaluated, and its
/// value translated.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "durero/zed/evaluate/evaluate.hpp"
#include "zed/evaluate/definitions.hpp"
#include "zed/operators.hpp"
#include "zed/smt/smt_term.hpp"

namespace durero::zed {

/// A name in scope: it stands for a term, for a value, or for a λ that is put in its place.
struct SmtMeaning;
struct SmtScope {
  const SmtScope* outer = nullptr;  ///< null where only the text's own names are seen further out
  std::map<Name, SmtMeaning> names{};
};
struct SmtMeaning {
  std::optional<SmtTerm> term{};
  std::optional<Value> value{};
  Term lambda{};  ///< it stands in this scope:
  const SmtScope* scope = nullptr;
};

/// A symbol of a script, with its sort: `Int`, `Real` or `Bool`.
struct SmtSymbol {
  std::string name, sort;
};

/// Quantifies a formula over symbols by `exists` or `forall`.
std::string smt_quantified(const std::string& by, const std::vector<SmtSymbol>& symbols, const std::string& body);

/// Variables that a schema text binds, and the conditions on them.
struct SmtBound {
  std::vector<std::pair<Name, SmtTerm>> variables{};
  Valuation known{};  ///< those that `x == e` gives a value at once
  std::vector<SmtSymbol> symbols{};
  std::vector<std::string> conditions{};
};

/// Variables that range over slots, and the declarations that do not.
struct SmtListing {
  std::vector<std::pair<Name, SmtTerm>> sets{};  ///< each variable with its set
  SchemaText rest{};                             ///< what else the schema text declares, and its predicates
  std::size_t cases = 1;                         ///< so many choices of the variables

  /// Says whether no variable is left that would need a symbol.
  bool is_whole() const;
};

/// The members of a given set or free type, where they are known and finitely many.
using SmtCarrier = std::function<std::optional<std::vector<Value>>(const Name& set)>;

/// A count that has another value as long as this lives.
class TemporaryCount {
 public:
  TemporaryCount(std::size_t& count, std::size_t value) : count_(count), before_(count) { count_ = value; }
  ~TemporaryCount() { count_ = before_; }
  TemporaryCount(const TemporaryCount&) = delete;
  TemporaryCount& operator=(const TemporaryCount&) = delete;

 private:
  std::size_t& count_;
  std::size_t before_;
};

/// All of it throws Untranslated for a term without translation, and what the evaluator throws but EvaluationError.
class SmtTranslator {
 public:
  /// The text and the evaluator outlive it.
  SmtTranslator(const Definitions& definitions, const Evaluator& evaluator, SmtCarrier carrier)
      : definitions_(definitions), evaluator_(evaluator), carrier_(std::move(carrier)) {}

  /// Binds the variables of a schema text in `inner`, whose outer scope is `scope`.
  SmtBound bind(const SchemaText& text, const SmtScope& scope, SmtScope& inner);
  /// Translates a predicate to a formula.
  std::string predicate(const Term& term, const SmtScope& scope);
  SmtTerm expression(const Term& term, const SmtScope& scope);
  /// Returns the members of a set of atoms, in the order of their places.
  const std::vector<Value>& members(const std::string& set);
  /// Returns the value of a term of constants; nothing of another.
  std::optional<Value> constant(const SmtTerm& term);
  /// Returns the definitions of the symbols that stand for long texts, in SMT-LIB.
  const std::string& shared_texts() const { return shared_; }
  /// Says whether some set was given most_slots members at most, though it may have more.
  bool is_bounded() const { return bounded_; }

  static constexpr std::size_t most_slots = 8;  ///< a set whose members are not listed has so many at most

 private:
  /// A function whose definition is put in the place of its application.
  struct Rule {
    SchemaText declared;
    std::vector<Name> parameters;
    Term value;
    const SmtScope* scope;
  };
  [[noreturn]] static void refuse(const Term& term, const std::string& why);
  void count();
  void written(std::size_t characters);
  std::string shared(const std::string& text, const std::string& sort);
  SmtTerm shared(SmtTerm term);
  SmtTerm fresh(const SmtTerm& shape, SmtBound& bound);
  void fresh_set(const SmtTerm& shape, SmtTerm& set, SmtBound& bound);

  // Names.
  const SmtMeaning* find(const Name& name, const SmtScope& scope) const;
  bool is_toolkit(const Term& term, const SmtScope& scope) const;
  bool is_closed(const Term& term, const SmtScope& scope) const;
  static Valuation known_values(const SmtScope& scope);
  Value value(const Term& term, const SmtScope& scope) const;
  SmtTerm of_value(const Value& value);
  SmtTerm of_members(const Value& set);
  SmtTerm named(const Term& term, const SmtScope& scope);
  bool mentions_set(const Term& term, const SmtScope& scope) const;
  void let(const SchemaText& text, const SmtScope& scope, SmtScope& inner);
  const Term* abbreviated(const Term& term, const SmtScope& scope) const;
  SchemaText schema_text(const Term& schema) const;

  // Predicates.
  std::string open_predicate(const Term& term, const SmtScope& scope);
  std::string relation(const Term& term, const SmtScope& scope);
  std::string related(const std::string& by, const Term& a, const Term& b, const SmtScope& scope);
  std::string closed_relation(const Term& term, const SmtScope& scope);
  std::optional<std::string> emptiness(const Term& a, const Term& b, const SmtScope& scope);
  std::optional<std::string> set_relation(const std::string& by, const Term& a, const Term& b, const SmtScope& scope);
  std::string inclusion(const Term& a, const Term& b, const SmtScope& scope);
  std::string quantified(const Term& term, const SmtScope& scope);
  std::string exists_one(const Term& term, const SmtScope& scope);
  std::string schema(const Term& term, const SmtScope& scope);

  // Choices of variables that range over slots.
  using EachCase = std::function<void(const SmtScope& inner, const SmtBound& bound)>;
  SmtListing listing(const SchemaText& text, const SmtScope& scope, bool any_set);
  void each_case(const SmtListing& listing, const SmtScope& scope, const EachCase& each);
  std::optional<SmtTerm> slots_of(const Term& set, const SmtScope& scope, bool any_set);
  std::optional<std::vector<SmtTerm>> listed(const Term& set, const SmtScope& scope, std::size_t most);
  std::optional<std::vector<SmtTerm>> listed_product(const Term& set, const SmtScope& scope, std::size_t most);
  SmtTerm characteristic(const SchemaText& text, const SmtScope& inner);
  std::optional<std::string> exactly_one(const Term& term, const SmtScope& scope);

  // Expressions.
  SmtTerm open_expression(const Term& term, const SmtScope& scope);
  SmtTerm parts(const Term& term, const SmtScope& scope);
  SmtTerm selection(const Term& term, const SmtScope& scope);
  SmtTerm conditional(const Term& term, const SmtScope& scope);
  SmtTerm application(const Term& term, const SmtScope& scope);
  std::optional<SmtTerm> arithmetic(const std::string& by, const Term& argument, const SmtScope& scope);
  std::optional<std::vector<Rule>> rules(const Term& function, const SmtScope& scope) const;
  std::vector<Rule> axioms(const Meaning& function) const;
  SmtTerm applied(const std::vector<Rule>& rules, const SmtTerm& argument);
  SmtTerm looked_up(const Value& function, const SmtTerm& argument);

  // Expressions that are sets.
  SmtTerm set_expression(const Term& term, const SmtScope& scope);
  SmtTerm comprehension(const Term& term, const SmtScope& scope);
  std::optional<SmtTerm> set_operation(const std::string& by, const Term& argument, const SmtScope& scope);
  std::optional<SmtTerm> filtered(const std::string& by, const Term& a, const Term& b, const SmtScope& scope);
  SmtTerm intersection_of(const Term& a, const Term& b, const SmtScope& scope);
  SmtTerm kept(const SmtTerm& set, std::optional<std::size_t> part, const Term& in, bool inside, const SmtScope& scope);
  std::string has_value(const Term& set, const SmtScope& scope);

  // Memberships.
  SmtMembership member(const SmtTerm& element, const Term& set, const SmtScope& scope);
  std::optional<SmtMembership> in_toolkit_set(const SmtTerm& element, const Term& set, const SmtScope& scope);
  SmtMembership in_comprehension(const SmtTerm& element, const Term& set, const SmtScope& scope);
  SmtMembership in_schema(const SmtTerm& element, const Term& set);
  SmtMembership in_value(const SmtTerm& element, const Term& set, const SmtScope& scope);
  std::optional<SmtMembership> in_family(const SmtTerm& element, const Term& set, const SmtScope& scope);
  SmtMembership all_in(const SmtTerm& set, std::optional<std::size_t> part, const Term& in, const SmtScope& scope);
  SmtMembership in_arrow(const SmtTerm& relation, const Arrow& arrow, const Term& set, const SmtScope& scope);
  SmtMembership covers(const SmtTerm& relation, std::size_t part, const Term& set, const SmtScope& scope);
  SmtMembership in_sequences(const SmtTerm& sequence, const Term& set, const SmtScope& scope);

  // Forms of members.
  std::optional<SmtTerm> family_shape(const Term& set, const SmtScope& scope);
  SmtTerm subset_shape(const Term& of, const SmtScope& scope);
  SmtTerm arrow_shape(const Arrow& arrow, const Term& set, const SmtScope& scope);
  bool is_inhabited(const Term& set, const SmtScope& scope);
  void bound_slots(const SmtTerm& variable, const Term& set, const SmtScope& scope, SmtBound& bound);
  SmtTerm sequence_shape(const Term& set, const SmtScope& scope);
  SmtTerm some_slots(const SmtTerm& member);
  SmtTerm schema_shape(const Term& schema);
  SmtTerm shape(const Term& set, const SmtScope& scope);
  std::optional<SmtTerm> toolkit_shape(const Term& set, const SmtScope& scope);
  SmtTerm comprehension_shape(const Term& set, const SmtScope& scope);

  static constexpr std::size_t most_written = 200'000'000;  // characters of all terms, as they are made
  static constexpr std::size_t most_terms = 100'000;        // of one predicate, so that no expansion outgrows memory
  const Definitions& definitions_;
  const Evaluator& evaluator_;
  SmtCarrier carrier_;
  std::map<std::string, std::vector<Value>> members_;
  std::map<std::string, std::string> names_of_texts_;
  std::string shared_;
  std::unordered_set<std::string> expanding_;  // functions whose definition is put in
  SmtScope global_;
  std::size_t symbols_ = 0, terms_ = 0, written_ = 0;
  std::size_t quantifiers_ = 0;  // so many are around this place whose variables are symbols
  std::size_t expansion_ = 1;    // so many choices of variables are written out around this one
  bool bounded_ = false;
};

}  // namespace durero::zed
