#pragma once
/// Queries whose memory is used again: neither a new one nor the end of one asks for memory or gives it back.

#include <cstddef>
#include <span>
#include <vector>

#include "durero/model/tipos.hpp"
#include "durero/scene/query.hpp"

namespace durero::render {

/// Makes one set the other. Of one element, which nearly all have, no call is needed.
inline void assign(scene::ElementSet& to, const scene::ElementSet& from) {
  if (from.size() != 1) {
    to = from;
    return;
  }
  to.clear();
  to.push_back(from[0]);
}

class QueryPool {
 public:
  /// @{ The operations of a vector.
  std::size_t size() const noexcept { return size_; }
  const scene::Query& operator[](std::size_t i) const { return held_[i]; }
  void clear() noexcept { size_ = 0; }
  /// @}
  /// Adds a query.
  void push(const model::Rayo& ray, const scene::ElementSet& en) {
    if (size_ == held_.size()) held_.push_back({ray});
    scene::Query& query = held_[size_++];
    query.rayo = ray;
    assign(query.en, en);
  }
  /// Leaves the first `size` alone. Precondition: there are so many.
  void shorten(std::size_t size) noexcept { size_ = size; }
  /// All of them, until the next one is added.
  std::span<const scene::Query> all() const { return {held_.data(), size_}; }

 private:
  std::vector<scene::Query> held_;
  std::size_t size_ = 0;
};

}  // namespace durero::render
