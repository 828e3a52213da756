#pragma once
/// Sets that are composed of others, listed choice by choice.

#include <utility>

#include "translator.hpp"

namespace durero::spec {

/// A set with more subsets, functions or tuples than so many is not listed for a search.
constexpr double most_composed = 1'000'000;

/// The size of a set, or `unlisted` where it has too many members.
inline double bounded_size(double size) { return size > most_composed ? unlisted : size; }

/// Goes every choice of one of `options` for each of so many places; `may` refuses a choice after those before it.
class ChoiceWalk {
 public:
  using May = std::function<bool(const std::vector<ValueId>& before, ValueId next)>;
  using Visit = std::function<bool(const std::vector<ValueId>& chosen)>;
  ChoiceWalk(const std::vector<std::vector<ValueId>>& options, May may, Visit visit)
      : options_(options), may_(std::move(may)), visit_(std::move(visit)) {}
  bool go() {
    if (chosen_.size() == options_.size()) return visit_(chosen_);
    for (const ValueId next : options_[chosen_.size()]) {
      if (!may_(chosen_, next)) continue;
      chosen_.push_back(next);
      const bool on = go();
      chosen_.pop_back();
      if (!on) return false;
    }
    return true;
  }

 private:
  const std::vector<std::vector<ValueId>>& options_;
  May may_;
  Visit visit_;
  std::vector<ValueId> chosen_;
};

}  // namespace durero::spec
