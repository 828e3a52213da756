#pragma once
/// A matching pairs some things with places that suit them, each place once.

#include <cstddef>
#include <limits>
#include <vector>

namespace durero::conform {

/// The places that suit each of so many things, by their numbers.
using Suiting = std::vector<std::vector<std::size_t>>;

/// A search for the largest matching, thing by thing: one that finds its places taken makes others move on.
class Matching {
 public:
  Matching(const Suiting& suiting, std::size_t places) : suiting_(&suiting), taken_by_(places, none) {}

  /// The things that the largest matching leaves without a place, ascending.
  std::vector<std::size_t> left_out() {
    std::vector<std::size_t> left;
    for (std::size_t thing = 0; thing < suiting_->size(); ++thing) {
      seen_.assign(taken_by_.size(), false);
      if (!finds_place(thing)) left.push_back(thing);
    }
    return left;
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  bool finds_place(std::size_t thing) {
    for (const std::size_t place : (*suiting_)[thing]) {
      if (seen_[place]) continue;
      seen_[place] = true;
      if (taken_by_[place] != none && !finds_place(taken_by_[place])) continue;
      taken_by_[place] = thing;
      return true;
    }
    return false;
  }

  const Suiting* suiting_;
  std::vector<std::size_t> taken_by_;  // the thing at each place
  std::vector<bool> seen_{};           // the places that the search has been at
};

}  // namespace durero::conform
