#include "zed/smt/smt_values.hpp"

#include "zed/evaluate/describe.hpp"
#include "zed/smt/smt_term.hpp"

namespace durero::zed {

bool is_all_numbers(const Value& set) {
  return set.set() && set.set()->total() && set.set()->numbers() == Numbers::reals;
}

// The size comes first: a set of too many members is not listed.
const std::vector<Value>* members_up_to(const Value& set, std::size_t most) {
  if (!set.set()) return nullptr;
  const auto size = set.set()->size();
  if (size && *size > Real(static_cast<int>(most))) return nullptr;
  const auto* members = set.set()->members();
  return members && members->size() <= most ? members : nullptr;
}

const std::vector<Value>& few_members(const Value& value, const Term& set) {
  constexpr std::size_t most = 1024;
  if (const auto* members = members_up_to(value, most)) return *members;
  const bool finite = value.set() && (value.set()->size() || value.set()->members());
  throw Untranslated(describe(*set) + (finite ? " has too many members to be written out" : " is not translated"));
}

}  // namespace durero::zed
