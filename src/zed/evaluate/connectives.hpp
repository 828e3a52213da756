#pragma once
/// The connectives and quantifiers combine schemas that are written out, for unfold.cpp.

#include <optional>

#include "durero/zed/evaluate/unfold.hpp"
#include "zed/evaluate/flat.hpp"

namespace durero::zed {

/// Returns declarations of these names; neighbours of one set stand in one of them.
SchemaText declarations_of(const std::vector<std::pair<Name, Term>>& declared);

/// The schema connectives. Each returns nothing where the set of all values of a component's type is not known, or a
/// name would be captured.
class Connectives {
 public:
  using Result = std::optional<Flat>;

  Connectives(const Definitions& definitions, const Carriers& carriers)
      : definitions_(definitions), carriers_(carriers) {}

  Result disjunction(const Flat& left, const Flat& right) const;
  Result implication(const Flat& left, const Flat& right) const { return joined(Kind::implication, left, right); }
  Result equivalence(const Flat& left, const Flat& right) const { return joined(Kind::equivalence, left, right); }
  Result negation(const Flat& of) const;
  /// S ⨡ T is S ∧ T without the components that only S has.
  Result projection(const Flat& left, const Flat& right) const;
  /// ∀, ∃ or ∃₁ bound • the schema.
  Result quantified(Kind kind, const Flat& bound, const Flat& of) const;

 private:
  Result joined(Kind kind, const Flat& left, const Flat& right) const;
  std::vector<Term> said_by(const Flat& flat, const Flat& declared) const;
  Term whole(const Name& name, const Term& set) const;
  Result declared_widely(const Flat& a, const Flat& b, bool keep_common) const;
  bool captures(const Flat& bound, const Flat& of) const;

  const Definitions& definitions_;
  const Carriers& carriers_;
};

}  // namespace durero::zed
