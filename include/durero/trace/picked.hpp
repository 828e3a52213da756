#pragma once
/// Permuted views of arrays. Many rays can be answered in the order that suits a structure, while each answer is
/// written to its query's place. The rays of such a view are made here too.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/scene/query.hpp"
#include "durero/trace/ray.hpp"

namespace durero::trace {

/// A view of entries of an array, in an order of its own. It refers to the array and to the places, which must outlive
/// it.
template <class T>
class IndexedView {
 public:
  /// The whole array in its own order.
  template <class Array>
    requires std::constructible_from<std::span<T>, Array&>
  IndexedView(Array& all) : all_(all), size_(all_.size()) {}
  /// The entries at `places`, in that order.
  IndexedView(std::span<T> all, std::span<const std::uint32_t> places)
      : all_(all), places_(places.data()), size_(places.size()) {}

  /// @{ The operations of an array.
  std::size_t size() const noexcept { return size_; }
  T& operator[](std::size_t i) const { return all_[place(i)]; }
  /// @}
  /// The place of an entry in the whole array.
  std::size_t place(std::size_t i) const { return places_ == nullptr ? i : places_[i]; }
  /// A view of the entries at other places of the whole array.
  IndexedView at_places(std::span<const std::uint32_t> places) const { return {all_, places}; }
  /// Whether the order is the view's own.
  bool is_permuted() const noexcept { return places_ != nullptr; }

 private:
  std::span<T> all_;
  const std::uint32_t* places_ = nullptr;  // null for the array's own order
  std::size_t size_;
};

/// The `count` entries from `begin` on of a permuted array; an empty `order` is the array's own order.
template <class T>
IndexedView<T> picked(std::span<T> all, std::span<const std::uint32_t> order, std::size_t begin, std::size_t count) {
  if (!order.empty()) return {all, order.subspan(begin, count)};
  std::span<T> part = all.subspan(begin, count);
  return IndexedView<T>(part);
}

/// A query asks for the first hit, or whether a segment is occluded.
enum class QueryKind : std::uint8_t { first, segment };

/// The order in which a source answers queries fastest, by source.order(queries, asked): a permutation of their
/// numbers, or empty for the queries' own order.
template <class Source>
std::vector<std::uint32_t> order_of(const Source& source, std::span<const scene::Query> queries, QueryKind asked) {
  if constexpr (requires { source.order(queries, asked); }) {
    return source.order(queries, asked);
  } else {
    return {};
  }
}

/// @{ Prefetches bytes that will be needed soon.
inline void ask_for(std::span<const std::byte> bytes) {
  constexpr std::size_t line = 64;  // the bytes of a cache line, or a multiple
  for (std::size_t at = 0; at < bytes.size(); at += line) __builtin_prefetch(&bytes[at]);
  if (!bytes.empty()) __builtin_prefetch(&bytes.back());
  asm volatile("" : : "r"(bytes.data()));  // an effect, without which GCC drops all calls
}
template <class T>
void ask_for(const T& object) {
  ask_for(std::as_bytes(std::span(&object, 1)));
}
/// @}

/// The rays of some queries, in order; also(number, query, ray) is called with each. A ray is told the one element that
/// it starts on, if it is ordinary, starts on one alone, and the source has no extraordinary elements. The elements
/// that they start on are prefetched some rays ahead, and so are permuted queries; others come in the order of memory.
template <class Source, class Also>
std::vector<Ray> rays_of(const Source& source, IndexedView<const scene::Query> queries, Also also) {
  constexpr std::size_t ahead = 16;
  const bool none_apart = source.extraordinary().empty();
  std::vector<Ray> rays;
  rays.reserve(queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i) {
    if (queries.is_permuted() && i + 2 * ahead < queries.size()) ask_for(queries[i + 2 * ahead]);
    if (i + ahead < queries.size() && !queries[i + ahead].en.empty()) source.ask_for_own(queries[i + ahead].en[0]);
    const scene::Query& query = queries[i];
    Ray& ray = rays.emplace_back(query.rayo);
    if (none_apart && ray.ordinary && query.en.size() == 1) ray.start_on(source.own(query.en[0]));
    also(i, query, ray);
  }
  return rays;
}

}  // namespace durero::trace
