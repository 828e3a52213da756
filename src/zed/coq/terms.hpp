#pragma once
/// The translator writes terms and predicates of Z as Coq text, for coq/coq.cpp.

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/types/typecheck.hpp"
#include "zed/coq/level.hpp"

namespace durero::zed::coq {

/// A carrier is a type of Coq that carries a Z set: a name, `set T`, or a product.
struct Carrier {
  enum class Form { named, set, product };
  Form form = Form::named;
  std::string name;  ///< it is empty where it is not known, as that of ∅
  std::vector<Carrier> parts;

  static Carrier named(std::string name) { return {Form::named, std::move(name), {}}; }
  static Carrier set(Carrier of) { return {Form::set, {}, {std::move(of)}}; }
  static Carrier product(std::vector<Carrier> of) { return {Form::product, {}, std::move(of)}; }
  std::string text(bool argument = false) const;  ///< an `argument` stands in parentheses where it is not one word
  const Carrier& element() const;                 ///< a set's elements have this carrier
};

/// An expression is Coq text with the level of its notation: what stands at a level below it must be in parentheses.
struct Expr {
  std::string text;
  int level = 0;
  Carrier type;
  std::string at(int most) const { return level <= most ? text : "(" + text + ")"; }
};

/// A slot is a component or an argument, and has a variable of Coq. Each state of a schema has one: `s` for S and `s'`
/// for S'.
struct Slot {
  Name name;  ///< a state has the schema's name, with its strokes
  std::string variable;
  Carrier type;
  bool state = false;
  Term set;  ///< a state has none
};
using Signature = std::vector<Slot>;

/// A symbol is what a name that a paragraph declares is in Coq.
struct CoqSymbol {
  enum class Form {
    carrier,    ///< the whole of a type: `univ`, or the predicate `ok` of a schema with an invariant
    value,      ///< a Definition
    function,   ///< a Definition of arguments
    partial,    ///< a Definition of arguments whose value is the set of its one value, or of none
    operation,  ///< a predicate on its components
  };
  Form form = Form::value;
  std::string text;
  Carrier type;  ///< a carrier's is that of its elements, a function's that of its value
  std::size_t arity = 0;
  std::string ok;       ///< a carrier has an invariant, or none
  Signature signature;  ///< an operation has one; for a schema of data it is its components
  bool prefixed = false;
};

/// A scope says what stands for the names in it.
struct CoqScope {
  std::map<Name, Expr> names;
  std::map<Name, Expr> states;               ///< θ asks for these
  std::map<std::string, std::string> known;  ///< "… ∈ f" leads to the variable that stands for the value of f there
  std::set<std::string> variables;
};

/// A frame has the values of partial applications that a predicate speaks of: variables, and what is asked of each.
using Frame = std::vector<std::pair<std::string, std::string>>;

/// Joins conjuncts by /\, and writes True for none; disjuncts by \/, and False for none.
Expr all_of(const std::vector<Expr>& conjuncts);
Expr any_of(const std::vector<Expr>& disjuncts);
/// Writes exists v …, … /\ body, or the body alone where the frame is empty.
Expr framed(const Frame& frame, const Expr& body);
/// Writes binders as `(a b : R) (S : set R)`, where `bare` without parentheses where one type is all.
std::string binders(const Signature& slots, bool bare);
std::string variable(const Name& name);
/// Writes the label A.kind.n as the identifier A_kind_n.
std::string identifier(std::string label);

/// Returns the name of S, and for S ' the name S'; nothing for another schema.
std::optional<Name> schema_name(const Term& schema);

/// Returns the arguments of a function of this arity, which stand in a tuple where they are several.
std::vector<Term> split(const Term& argument, std::size_t arity);

/// Splits a chain of ∧ or of ∨.
void flatten(Kind kind, const Term& term, std::vector<Term>& to);
/// Adds what is not there yet, by name. States stand before the rest.
void merge(Signature& to, const Signature& from);

class Translator {
 public:
  explicit Translator(const Typing& typing) : typing_(typing) {}

  std::map<Name, CoqSymbol> symbols;
  std::string state;  ///< this schema is the state; its variable is `s`

  Expr term(const Term& term, CoqScope& scope, Frame& frame) const;
  Expr predicate(const Term& term, const CoqScope& scope) const;
  /// Writes a set in a place of its own, as `fun x => …` where it is no name and no operation on sets.
  Expr set(const Term& set, const CoqScope& scope) const;
  /// Writes x ∈ set, where x is a variable of Coq, or nothing where the set is a whole type.
  std::vector<Expr> constraint(const Expr& x, const Term& set, const CoqScope& scope) const;
  Expr member(const Expr& x, const Term& set, const CoqScope& scope) const;
  /// Writes that y is the value of the term.
  Expr is_value(const Expr& y, const Term& term, const CoqScope& scope) const;

  Carrier carrier(const Term& set, const CoqScope& scope = {}) const;  ///< its elements have this carrier
  bool whole(const Term& set) const;                                   ///< says whether the set is all of its carrier
  bool is_set(const Term& term) const;                                 ///< its Z type says so
  Signature declare(const SchemaText& text, CoqScope& scope) const;
  void declare(const Slot& slot, CoqScope& scope) const;
  /// Writes x ∈ S for each x : S of the text, where S is seen from `outer`, then its predicates, which are seen from
  /// `inner`.
  std::vector<Expr> conditions(const SchemaText& text, const Signature& slots, const CoqScope& outer,
                               const CoqScope& inner) const;
  std::string fresh(const std::string& stem, const CoqScope& scope) const;
  bool taken(const std::string& variable, const CoqScope& scope) const;
  Signature signature(const Term& schema) const;
  Expr call(const Name& schema, const CoqScope& scope, Place place) const;
  Slot state_slot(const Name& name, Place place) const;
  const CoqSymbol* find(const Name& name) const;

 private:
  Expr reference(const Node& node, CoqScope& scope, Frame& frame) const;
  Expr application(const Node& node, CoqScope& scope, Frame& frame) const;
  Expr operation(const std::string& word, const std::vector<Term>& arguments, CoqScope& scope, Frame& frame,
                 const Node& node) const;
  Expr selection(const Node& node, CoqScope& scope, Frame& frame) const;
  Expr tuple(const Node& node, CoqScope& scope, Frame& frame) const;
  Expr set_extension(const Node& node, CoqScope& scope, Frame& frame) const;
  Expr conditional_set(const Term& conditional, const CoqScope& scope) const;
  Expr conditional_number(const Node& node, CoqScope& scope, Frame& frame) const;
  Expr product(const Term& product, CoqScope& scope, Frame& frame) const;
  Expr generalized_union(const Term& family, CoqScope& scope, Frame& frame) const;
  Expr partial(const std::string& in, const std::string& before, const Carrier& type, CoqScope& scope,
               Frame& frame) const;
  Expr apply_partial(const Node& node, const Expr* y, CoqScope& scope, Frame& frame) const;
  Expr comprehension(const Node& node, const CoqScope& scope) const;
  Expr conditional(const Node& node, const CoqScope& scope,
                   const std::function<Expr(const Term&, const CoqScope&)>& leaf) const;
  Expr relation(const Node& node, CoqScope& scope, Frame& frame, bool denied) const;
  Expr one_relation(const Name& by, const Term& left, const Term& right, const Expr& a, CoqScope& scope,
                    Frame& frame) const;
  Expr quantified(const Node& node, const CoqScope& scope) const;
  std::vector<Expr> included(const SchemaText& text, const CoqScope& scope) const;
  std::vector<Name> after(const Term& schema) const;
  Expr without(const Term& schema, const std::vector<Name>& names, const CoqScope& scope) const;
  bool is_partial(const Node& application, const CoqScope& scope) const;

  const Typing& typing_;
};

[[noreturn]] void uncovered(Place place, const std::string& what);

}  // namespace durero::zed::coq
