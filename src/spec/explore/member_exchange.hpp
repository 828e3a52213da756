#pragma once
/// The exchange of members of given sets that a text does not tell apart.

#include <string>

#include "planned_machine.hpp"

namespace durero::spec {

/// Exchanges of two members each. Together they make every permutation of the members of each set.
class MemberExchange {
 public:
  /// Of the given sets of a machine, but for those with a member that a constant of the text is or holds, or that the
  /// predicates name.
  MemberExchange(PlannedMachine& machine, const std::vector<zed::Term>& predicates);

  /// The sets whose members are exchanged.
  const std::vector<std::string>& sets() const { return sets_; }
  /// How many exchanges there are.
  std::size_t size() const { return swaps_.size(); }
  /// The state after one of them.
  void exchange(std::size_t at, std::span<const ValueId> state, std::vector<ValueId>& to);

 private:
  struct Swap {
    ValueId first, second;
    std::vector<ValueId> known{};  // what each value becomes; 0 where it was not asked yet
  };
  ValueId exchanged(Swap& swap, ValueId id);
  void drop_named(std::set<std::string>& sets, const std::vector<zed::Term>& predicates) const;
  void drop_held(std::set<std::string>& sets);

  PlannedMachine& machine_;
  std::vector<std::string> sets_;
  std::vector<Swap> swaps_;
};

}  // namespace durero::spec
