#pragma once
/// A watch ends a search from outside: an interrupt, or the end of its time, is seen between two candidates.

#include <cstdint>
#include <exception>
#include <functional>
#include <utility>

namespace durero::spec {

/// The error of a search that its watch ended.
class StoppedSearch : public std::exception {
 public:
  const char* what() const noexcept override { return "the search was stopped"; }
};

/// Asks from time to time whether to go on. While nobody watches, it asks nothing.
class SearchWatch {
 public:
  /// From here on `may_go_on` is asked; an empty one ends the watch.
  void watch(std::function<bool()> may_go_on) {
    may_go_on_ = std::move(may_go_on);
    counted_ = 0;
  }
  /// Counts a candidate; every 256th asks, so that it costs nothing beside them. Throws StoppedSearch.
  void count() {
    if (++counted_ % 256 == 0) ask();
  }
  /// Asks at once, as before a question that may take long. Throws StoppedSearch.
  void ask() const {
    if (may_go_on_ && !may_go_on_()) throw StoppedSearch();
  }

 private:
  std::function<bool()> may_go_on_{};
  std::uint64_t counted_ = 0;
};

}  // namespace durero::spec
