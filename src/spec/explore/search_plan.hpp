#pragma once
/// A search for values of names, planned once: in which order facts are asked, equations give values, and sets are
/// listed.

#include "translator.hpp"

namespace durero::spec {

/// How often a fact was found true, and false.
struct FactCount {
  zed::Term fact;
  std::uint64_t yes = 0, no = 0;
};

/// How a search for values is planned.
struct PlanWish {
  std::vector<FactCount>* counts = nullptr;  ///< counts what is asked of the facts; null: nothing is counted
  std::vector<zed::Term> uncounted{};        ///< but for these
  std::vector<zed::Term> held{};             ///< facts that are known to hold, and are not asked
  /// Goes each side of each disjunction of facts on its own, where sides overlap and where no name is sought in it too.
  bool split = false;
  /// Tries some numbers where nothing bounds them, and names the names in bounded(). Else the search is not planned.
  bool bound_numbers = false;
};

class SearchPlan {
 public:
  /// Without steps; `watch`, which outlives it, may end its searches.
  explicit SearchPlan(SearchWatch& watch) : watch_(&watch) {}
  /// Calls `visit`, which returns false to stop, with values of the names in the frame; the same values may come again
  /// where repeats() says so. Returns false where it was stopped. Throws Undecided, and StoppedSearch.
  bool each(IdFrame frame, const std::function<bool()>& visit) const { return from(0, frame, visit); }
  /// Says whether the same values may come several times.
  bool repeats() const { return repeats_; }
  /// The names for which only some numbers are tried.
  const std::set<zed::Name>& bounded() const { return bounded_; }
  /// The sides of disjunctions on the way to what is visited now, where the plan splits them.
  const std::vector<zed::Term>& sides() const { return sides_; }
  /// Every combination of sides that the plan goes, in order.
  const std::vector<std::vector<zed::Term>>& all_sides() const { return all_sides_; }

 private:
  friend class PlanMaker;
  /// A step either asks or gives, and says whether to go on; or it goes on for each of several values.
  struct Step {
    IdTest test;
    std::function<bool(IdFrame frame, const std::function<bool()>& on)> go;
  };
  bool from(std::size_t step, IdFrame frame, const std::function<bool()>& visit) const;

  SearchWatch* watch_;
  std::vector<Step> steps_;
  bool repeats_ = false;
  std::set<zed::Name> bounded_;
  mutable std::vector<zed::Term> sides_;
  std::vector<std::vector<zed::Term>> all_sides_;
};

/// Plans the search. Throws NotInterned where nothing gives or lists the values of a name.
std::shared_ptr<const SearchPlan> planned_search(TermTranslator& translator, const SoughtNames& sought,
                                                 const PlanWish& wish = {});

}  // namespace durero::spec
