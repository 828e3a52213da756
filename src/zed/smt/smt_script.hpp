#pragma once
/// A script asks for values of the variables of one quantifier.

#include <optional>
#include <string>
#include <vector>

#include "zed/smt/smt_reply.hpp"
#include "zed/smt/smt_translator.hpp"

namespace durero::zed {

/// The values that are sought: those with which the claim holds.
struct SmtSought {
  SchemaText text;     ///< it declares the variables
  Term body;           ///< this holds of them beside its predicates
  std::string called;  ///< `witness`, `counter-example`
  Truth then;          ///< the truth of the whole predicate where values are found
  unsigned times = 1;  ///< so many values are sought that differ, 1 or 2

  /// Returns declarations, predicates and the body as one predicate of the variables.
  Term claim() const;
};

/// Returns what is sought of ∃, ∀ or ∃₁.
SmtSought sought_in(const Term& quantified);
/// Returns what is sought of { D | P } = ∅, or ≠, as of its truth where `=` stands; nothing for another relation.
std::optional<SmtSought> sought_in_emptiness(const Term& relation, const Definitions& definitions);

/// A script, and how values are read back.
class SmtScript {
 public:
  /// All of it outlives the script.
  SmtScript(const Definitions& definitions, const Evaluator& evaluator, SmtCarrier carrier)
      : translator_(definitions, evaluator, std::move(carrier)) {}
  /// Writes it. Throws Untranslated.
  std::string text(const SmtSought& sought, const Valuation& locals);
  /// Returns the values of the variables, for each of the times; nothing where the reply does not give them all.
  std::optional<std::vector<Valuation>> values(const SmtVerdict& verdict);
  /// Says within which sets values were sought: `whose sets have at most 8 members`; empty where within all.
  std::string bounds() const;

 private:
  std::optional<Value> value(const SmtTerm& variable, const SmtVerdict& verdict);
  std::optional<Value> set_value(const SmtTerm& variable, const SmtVerdict& verdict);

  SmtTranslator translator_;
  std::vector<SmtBound> bound_;
};

}  // namespace durero::zed
