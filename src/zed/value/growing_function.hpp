#pragma once
/// A search for a function gives one argument after the other its value, and asks on the way what is so already.

#include <optional>
#include <vector>

#include "durero/zed/value/value.hpp"
#include "zed/operators.hpp"

namespace durero::zed {

/// The functions of a form from a finite set to some values.
struct FunctionSpace {
  std::vector<Value> from, to;  ///< they are sorted
  Arrow form;
  bool whole = true;  ///< the set that it is of has no other members
};

/// A function that is known at the first arguments.
class GrowingFunction {
 public:
  /// Knows it at no argument. Precondition: the space outlives it.
  explicit GrowingFunction(const FunctionSpace& space) : space_(space), uses_(space.to.size(), 0) {}

  /// Says whether some function of the space begins so, as far as the numbers of arguments and values tell.
  bool may_be_whole() const {
    const std::size_t left = space_.from.size() - places_.size(), free = space_.to.size() - taken_;
    return (!space_.form.surjective || free <= left) && !(space_.form.total && space_.form.injective && left > free);
  }
  /// Says whether it is known at each argument.
  bool is_whole() const { return places_.size() == space_.from.size(); }
  /// Calls `visit` with the function known at one argument more, for each way in which it may go on.
  template <class Visit>
  void each_way_on(const Visit& visit) {
    if (!space_.form.total) with(nowhere, visit);
    for (std::size_t j = 0; j < space_.to.size(); ++j)
      if (!space_.form.injective || uses_[j] == 0) with(j, visit);
  }
  /// Returns the function as a value: at an argument that it is not known at, it has some value or none. A whole one is
  /// a finite set.
  Value value() const;

 private:
  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

  template <class Visit>
  void with(std::size_t place, const Visit& visit) {
    places_.push_back(place);
    if (place != nowhere && uses_[place]++ == 0) ++taken_;
    if (may_be_whole()) visit();
    if (place != nowhere && --uses_[place] == 0) --taken_;
    places_.pop_back();
  }

  const FunctionSpace& space_;
  std::vector<std::size_t> places_;  // of the values in the space, by the argument; `nowhere` where it has none
  std::vector<std::size_t> uses_;    // so many arguments have each value
  std::size_t taken_ = 0;            // so many values have arguments
};

}  // namespace durero::zed
