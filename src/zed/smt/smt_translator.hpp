#pragma once
/// Predicates of Z are translated to formulas of SMT-LIB as far as these cover them: numbers and their arithmetic,
/// members of finite given sets and enumerated free types, tuples and bindings of these, comparisons, memberships, the
/// connectives and quantifiers. A part that depends on no quantified variable is evaluated, and its value translated.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "durero/zed/evaluate/evaluate.hpp"
#include "zed/evaluate/definitions.hpp"
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

/// A symbol of a script, with its sort, Int or Real.
struct SmtSymbol {
  std::string name;
  bool real = false;
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

/// The members of a given set or free type, where they are known and finitely many.
using SmtCarrier = std::function<std::optional<std::vector<Value>>(const Name& set)>;

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
  SmtTerm fresh(const SmtTerm& shape, std::vector<SmtSymbol>& symbols);

  // Names.
  const SmtMeaning* find(const Name& name, const SmtScope& scope) const;
  bool is_toolkit(const Term& term, const SmtScope& scope) const;
  bool is_closed(const Term& term, const SmtScope& scope) const;
  Value value(const Term& term, const SmtScope& scope) const;
  SmtTerm of_value(const Value& value);
  void let(const SchemaText& text, const SmtScope& scope, SmtScope& inner);
  const Term* abbreviated(const Term& term, const SmtScope& scope) const;
  SchemaText schema_text(const Term& schema) const;

  // Predicates.
  std::string relation(const Term& term, const SmtScope& scope);
  std::string related(const std::string& by, const Term& a, const Term& b, const SmtScope& scope);
  std::optional<std::string> emptiness(const Term& a, const Term& b, const SmtScope& scope);
  std::string quantified(const Term& term, const SmtScope& scope);
  std::string exists_one(const Term& term, const SmtScope& scope);
  std::string schema(const Term& term, const SmtScope& scope);

  // Expressions.
  SmtTerm parts(const Term& term, const SmtScope& scope);
  SmtTerm selection(const Term& term, const SmtScope& scope);
  SmtTerm conditional(const Term& term, const SmtScope& scope);
  SmtTerm application(const Term& term, const SmtScope& scope);
  std::optional<SmtTerm> arithmetic(const std::string& by, const Term& argument, const SmtScope& scope);
  std::optional<std::vector<Rule>> rules(const Term& function, const SmtScope& scope) const;
  std::vector<Rule> axioms(const Meaning& function) const;
  SmtTerm applied(const std::vector<Rule>& rules, const SmtTerm& argument);
  SmtTerm looked_up(const Value& function, const SmtTerm& argument);

  // Sets.
  SmtMembership member(const SmtTerm& element, const Term& set, const SmtScope& scope);
  std::optional<SmtMembership> in_toolkit_set(const SmtTerm& element, const Term& set, const SmtScope& scope);
  SmtMembership in_comprehension(const SmtTerm& element, const Term& set, const SmtScope& scope);
  SmtMembership in_schema(const SmtTerm& element, const Term& set);
  SmtMembership in_value(const SmtTerm& element, const Term& set, const SmtScope& scope);
  SmtTerm shape(const Term& set, const SmtScope& scope);
  std::optional<SmtTerm> toolkit_shape(const Term& set, const SmtScope& scope);
  SmtTerm comprehension_shape(const Term& set, const SmtScope& scope);

  static constexpr std::size_t most_terms = 100'000;  // of one predicate, so that no expansion outgrows memory
  const Definitions& definitions_;
  const Evaluator& evaluator_;
  SmtCarrier carrier_;
  std::map<std::string, std::vector<Value>> members_;
  std::unordered_set<std::string> expanding_;  // functions whose definition is put in
  SmtScope global_;
  std::size_t symbols_ = 0, terms_ = 0;
};

}  // namespace durero::zed
