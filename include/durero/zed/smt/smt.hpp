#pragma once
/// A program that speaks SMT-LIB 2 is asked where the evaluator does not decide a quantified predicate. Its answer is
/// believed in one case alone: the values that it finds are put in, and the text, evaluated, says that they are a
/// witness of the ∃, or a counter-example of the ∀. That it finds none proves nothing here.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "durero/zed/evaluate/evaluate.hpp"

namespace durero::zed {

/// The reply of the program.
struct SmtReply {
  std::string output;     ///< it wrote this
  std::string failure{};  ///< why there is no reply: `gives no answer within 10 s`; empty where there is one
};

/// A program that speaks SMT-LIB 2.
struct SmtProgram {
  std::string name;                                          ///< messages name it so
  std::function<SmtReply(const std::string& script)> ask{};  ///< sends it a script, and returns its reply
};

/// The outcome of asking a solver.
struct SmtFinding {
  Truth truth = Truth::open;  ///< open, unless the text says so of the values found
  Valuation values{};         ///< the witness, or the counter-example; the last where there are several
  std::string said{};  ///< `z3 finds the witness x == 7, …`, `z3 finds no counter-example`, or why it is not asked
};

/// The members of a given set, where they are known and finitely many.
using KnownMembers = std::function<std::optional<std::vector<Value>>(const Name& set)>;

/// Asks the program about the quantifiers of a predicate which the evaluator does not decide: outermost ones, with ∧,
/// ∨, ¬, ⇒ and ⇔ around them, and { D | P } = ∅, which says ¬ ∃ D • P. Of ∃₁ two witnesses are looked for, which make
/// it false. `sections` are those of the evaluator. What is evaluated counts the steps of the evaluator; throws
/// StepsSpent.
SmtFinding ask_program(const SmtProgram& program, const Term& predicate, const std::vector<Section>& sections,
                       const Evaluator& evaluator, const Valuation& locals = {}, const KnownMembers& members = {});

}  // namespace durero::zed
