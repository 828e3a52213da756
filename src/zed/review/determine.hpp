#pragma once
/// Finds which components of an after-state the facts of an operation determine.

#include <set>
#include <vector>

#include "zed/review/expand.hpp"

namespace durero::zed {

class Determiner {
 public:
  Determiner(const Expander& expander, Budget& budget) : expander_(expander), budget_(budget) {}

  /// Removes from `open` what the facts determine, until nothing changes.
  void determine(std::set<Name>& open, const std::vector<Term>& facts);

 private:
  void by_fact(std::set<Name>& open, const Term& fact);
  void by_equation(std::set<Name>& open, const Term& left, const Term& right);
  void by_value(std::set<Name>& open, const Term& pattern, const Term& value);
  void by_sides(std::set<Name>& open, const std::vector<Term>& sides);
  void by_cases(std::set<Name>& open, const std::vector<Term>& facts);
  void by_body(std::set<Name>& open, const Node& node);
  void by_schema(std::set<Name>& open, const Term& schema);
  std::set<Name> components(const Term& schema) const;
  std::vector<Name> bound_by_theta(const Node& theta) const;
  std::map<Name, Term> parts(const Term& term) const;
  bool refers(const Term& term, const std::set<Name>& open) const;

  const Expander& expander_;
  Budget& budget_;
  unsigned schemas_ = 0;  // the depth of schemas within schemas here
};

}  // namespace durero::zed
