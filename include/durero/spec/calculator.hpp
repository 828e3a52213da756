#pragma once
/// Expressions and predicates that one types, evaluated by the Z text.

#include <optional>
#include <string>
#include <unordered_set>

#include "durero/model/operation.hpp"
#include "durero/spec/spec.hpp"
#include "durero/zed/smt/smt.hpp"
#include "durero/zed/syntax/defect.hpp"
#include "durero/zed/types/typecheck.hpp"

namespace durero::spec {

/// A term as one types it: in LaTeX where a command of LaTeX is in it, with the commands that the text names; else in
/// Unicode. Throws zed::ZError.
zed::Term parsed(const std::string& typed);
/// What a text adds to how terms are written: commands of LaTeX, and the operators of its templates.
struct Notation {
  zed::Markup markup;        ///< commands, by their names
  zed::Operators operators;  ///< by their words
};
/// What the sections of a text add, together.
Notation notation_of(const zed::Specification& specification);
/// The same as above with the notation of another text.
zed::Term parsed(const std::string& typed, const Notation& notation);

/// A part of a term that was evaluated, with its own parts.
struct ExplainedTerm {
  std::string term;   ///< in Unicode; `witness` or `counter-example` of the values that make an ∃ true or a ∀ false
  std::string value;  ///< `true`, `false`, `not decided`, or the value; of a witness its values, `x == 1, y == 2`
  bool is_witness = false;             ///< it stands for values, and no term of the text
  std::vector<ExplainedTerm> parts{};  ///< in the order of the text; of a witness, what is asked of it
};

/// The lines of Calculator::explain(): one for each part, below and to the right of what it is a part of.
std::string explanation_text(const ExplainedTerm& whole);

/// Names that are local to a term, such as `radio?`, with their types and values.
struct LocalNames {
  std::vector<std::pair<zed::Name, zed::Type>> types;  ///< in the order in which they were given
  zed::Valuation values;                               ///< in step
};

/// Sees the whole text, and Escena's components and the elements of a scene where there is one. An element's name is
/// written between quotation marks, `"a-b"`, or plainly where it is a word that the text leaves free. Numbers may be
/// decimal, `0.25`, and / and √ are known. What is printed can be typed again, as an empty set bears its type, `∅[𝔸]`;
/// only sets that are known by membership cannot.
class Calculator {
 public:
  Calculator();
  /// Of another text. Throws zed::ZError where it has an error of types; its own defects are the caller's to look at.
  explicit Calculator(zed::Specification specification);
  /// Of that scene, which it copies.
  explicit Calculator(const model::Escena& escena);
  /// Gives constants values, `NAME=VALUE` each. Throws ConstantError (constants.hpp).
  void let(const std::vector<std::string>& typed);
  /// Gives given sets members, `SET=3` or `SET=ann,bob`, and constants values, `NAME=VALUE`. The members have these
  /// words for names, or SET1, SET2, …; what is evaluated then holds within these. Returns a line for each set. Throws
  /// ConstantError.
  std::vector<std::string> scope(const std::vector<std::string>& typed);

  /// The values that names have by now: elements, constants, given sets, and the names of their members.
  const zed::Valuation& given() const { return given_; }

  /// What an expression or a predicate comes to.
  struct Result {
    std::string text;        ///< the value, `undefined`, `true` or `false`; a schema that is not listed is written out
    bool yes = false;        ///< there is a value, or the predicate holds
    zed::Valuation taken{};  ///< what was taken for constants to which nothing gives a value
    std::string solved{};    ///< `z3 finds the witness x == 7, …`, where a solver's values decide a predicate
  };
  /// Counts the steps. Throws zed::ZError where the term cannot be read or has no type, zed::EvaluationError where it
  /// is not decided, zed::StepsSpent where it takes more steps than it may. A solver, if any, is asked of a predicate
  /// that is not decided otherwise, and the steps count from 0 again for what it finds.
  Result evaluate(const std::string& typed, zed::Steps& steps, const LocalNames& locals = {},
                  const zed::SmtProgram* solver = nullptr) const;
  /// Adds a local name, such as `radio?`, with the value of a term, which may have the names before it. Throws as
  /// evaluate() does, and zed::ZError where the name is none or the term has no value.
  void add_local(LocalNames& to, const std::string& name, const std::string& typed, zed::Steps& steps) const;
  /// The names of the members of a finite set of elements, ascending. Throws as evaluate() does, and zed::ZError where
  /// the term is no such set.
  std::vector<std::string> names(const std::string& typed, zed::Steps& steps) const;
  /// A line for the term, and indented below it one for each of its parts, with its value: so which conjunct is false;
  /// and below a ∀ that is false, or an ∃ that is true, the values that make it so, and the body with these. Throws as
  /// evaluate() does, but where a part is not decided, which it then says.
  std::string explain(const std::string& typed, zed::Steps& steps) const;
  /// The tree of the term's parts, each with its value; it throws as explain() does.
  ExplainedTerm explained(const std::string& typed, zed::Steps& steps, const LocalNames& locals = {}) const;
  /// The same with as many steps as it takes.
  Result evaluate(const std::string& typed) const {
    zed::Steps unbounded;
    return evaluate(typed, unbounded);
  }

 private:
  void declare(const model::Escena& escena);
  std::string declare(const zed::Name& set, const std::vector<std::string>& members, zed::Axiomatic& box);
  /// The term, or, of a connective of schemas whose components are not in scope, the schema; with its typing.
  zed::Typing check(zed::Term& term, const LocalNames& locals = {}) const;
  std::string spelled(const zed::AtomName& atom) const;
  std::string expected(const zed::Defect& defect) const;
  /// The schema as one text without others in it, as `pre Op`; nothing where that cannot be.
  std::optional<std::string> written_out(const zed::Term& schema, const zed::Type& type,
                                         const zed::Typing& typing) const;
  /// What stands for the formals of a generic schema that is named without actuals, by the types that were found.
  std::optional<std::vector<zed::Term>> actuals_of(const zed::Term& generic, const zed::Typing& typing) const;

  zed::Specification specification_;
  zed::Typing typing_;
  zed::Valuation given_;
  std::unordered_set<std::string> plain_;  // the elements that have a plain name
};

}  // namespace durero::spec
