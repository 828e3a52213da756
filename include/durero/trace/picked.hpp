#pragma once
/// Some of the entries of an array, in an order of their own: so many rays can be answered in an order that suits a
/// structure, and each answer stands where its question does.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace durero::trace {

/// Refers to the array and to the places, which must outlive it.
template <class T>
class Picked {
 public:
  /// All of them, as they stand.
  template <class Array>
    requires std::constructible_from<std::span<T>, Array&>
  Picked(Array& all) : all_(all), size_(all_.size()) {}
  /// Those at some places.
  Picked(std::span<T> all, std::span<const std::uint32_t> places)
      : all_(all), places_(places.data()), size_(places.size()) {}

  /// @{ As of an array.
  std::size_t size() const noexcept { return size_; }
  T& operator[](std::size_t i) const { return all_[places_ == nullptr ? i : places_[i]]; }
  /// @}

 private:
  std::span<T> all_;
  const std::uint32_t* places_ = nullptr;  // null: as they stand
  std::size_t size_;
};

/// Part of an array: `count` entries from `begin` on, by an order, or as they stand where that is empty.
template <class T>
Picked<T> picked(std::span<T> all, std::span<const std::uint32_t> order, std::size_t begin, std::size_t count) {
  if (!order.empty()) return {all, order.subspan(begin, count)};
  std::span<T> part = all.subspan(begin, count);
  return Picked<T>(part);
}

}  // namespace durero::trace
