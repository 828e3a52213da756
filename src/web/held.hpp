#pragma once
/// Things that were read are kept by their texts, so that a call that names one again need not read it. This changes no
/// answer.

#include <algorithm>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace durero::web {

/// The last things that were made of texts.
template <class Value>
class Held {
 public:
  /// Keeps so many.
  explicit Held(std::size_t most) : most_(most) {}

  /// The value of a text: the kept one, or what `make` makes of it. An exception of `make` passes, and nothing is kept.
  std::shared_ptr<const Value> of(const std::string& text, const std::function<std::shared_ptr<const Value>()>& make) {
    const auto found = std::ranges::find(kept_, text, &std::pair<std::string, std::shared_ptr<const Value>>::first);
    if (found != kept_.end()) {
      std::rotate(kept_.begin(), found, found + 1);  // the one that was asked for last stands first
    } else {
      kept_.emplace_front(text, make());
      if (kept_.size() > most_) kept_.pop_back();
    }
    return kept_.front().second;
  }

 private:
  std::size_t most_;
  std::deque<std::pair<std::string, std::shared_ptr<const Value>>> kept_{};
};

}  // namespace durero::web
