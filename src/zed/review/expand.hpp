#pragma once
/// An expansion writes a schema out with all that it includes, for the checks beyond types.

#include <map>
#include <set>
#include <unordered_map>
#include <vector>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "durero/zed/types/typecheck.hpp"

namespace durero::zed {

/// An expansion is a schema written out.
struct Expansion {
  std::vector<std::pair<Name, Term>> declared;  ///< it declares these components by `:`, from these sets
  std::vector<Term> facts;                      ///< its predicates are here, conjunctions split
  std::set<Name> states;                        ///< each ΔS and ΞS in it has its S here, but where S is an operation
  bool opaque = false;                          ///< something in it could not be written out
};

class Expander {
 public:
  Expander(const Specification& specification, const Typing& typing);

  Expansion schema(const Term& term) const;
  Expansion text(const SchemaText& text) const;

  /// Returns the components of a schema, by its name.
  std::set<Name> components(const Name& schema) const;

  /// Returns the components of a schema that is a name, Δ and Ξ of one among them; nothing of any other.
  std::set<Name> spoken_of(const Term& schema) const;

  /// Returns the constants of the free type that this one belongs to; none if it is not a constant, or its type has
  /// constructors.
  std::set<Name> siblings(const Name& constant) const;

  /// Returns the declarations and facts of the axiomatic boxes.
  const Expansion& axioms() const { return axioms_; }

 private:
  void add(const Term& schema, Expansion& to, unsigned depth) const;
  void add(const SchemaText& text, Expansion& to, unsigned depth) const;
  void add_named(const Name& name, Expansion& to, unsigned depth) const;
  void add_decorated(const Name& base, const std::string& stroke, Expansion& to, unsigned depth) const;
  void add_decorated_anew(const Name& base, const std::string& stroke, Expansion& to, unsigned depth) const;

  const Typing& typing_;
  std::unordered_map<Name, const SchemaText*> boxes_;
  std::unordered_map<Name, Term> definitions_;
  std::map<Name, std::set<Name>> siblings_;
  Expansion axioms_;
  /// The expansions of decorated schemas S ', by S and the stroke, each written out once.
  mutable std::map<std::pair<Name, std::string>, Expansion> decorated_;
};

/// Counts the work of a check, so that no text makes it hang: spec/ takes 10^6 steps, some comparisons each.
class Budget {
 public:
  void spend(std::size_t steps) {
    if (steps > left_) throw Spent();
    left_ -= steps;
  }
  struct Spent {};

 private:
  std::size_t left_ = 50000000;
};

/// Splits ∧ and chains of relations: a ≤ b ≤ c gives a ≤ b and b ≤ c.
void conjuncts(const Term& predicate, std::vector<Term>& to);

/// Makes the warning that is given where the budget is spent.
Defect too_large(const Specification& specification, const std::string& looked_for);

/// Puts strokes to each of these names, where it is free in the term.
Term decorate(const Term& term, const std::set<Name>& names, const std::string& strokes);

}  // namespace durero::zed
