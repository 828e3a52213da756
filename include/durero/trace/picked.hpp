#pragma once
/// Some of the entries of an array, in an order of their own: so many rays can be answered in an order that suits a
/// structure, and each answer stands where its question does. And their rays.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/scene/query.hpp"
#include "durero/trace/ray.hpp"

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

/// What queries are asked for: what is met first, or whether something is met before their ends.
enum class Asked : std::uint8_t { first, segment };

/// The order in which a source would rather answer, by source.order(queries, asked): each query once; or empty, as they
/// come.
template <class Source>
std::vector<std::uint32_t> order_of(const Source& source, std::span<const scene::Query> queries, Asked asked) {
  if constexpr (requires { source.order(queries, asked); }) {
    return source.order(queries, asked);
  } else {
    return {};
  }
}

/// @{ Asks memory for what will be needed soon.
inline void ask_for(std::span<const std::byte> bytes) {
  constexpr std::size_t line = 64;  // of the cache, or a multiple of it
  for (std::size_t at = 0; at < bytes.size(); at += line) __builtin_prefetch(&bytes[at]);
  if (!bytes.empty()) __builtin_prefetch(&bytes.back());
  asm volatile("" : : "r"(bytes.data()));  // else GCC drops every call, as of a function that does nothing
}
template <class T>
void ask_for(const T& object) {
  ask_for(std::as_bytes(std::span(&object, 1)));
}
/// @}

/// The rays of some queries, in order, with also(number, query, ray) of each while they are at hand. Where no element
/// is extraordinary for the source, an ordinary ray that starts on one alone is told. Memory is asked for each query
/// some time before its turn, and for what it starts on when the query has come.
template <class Source, class Also>
std::vector<Ray> rays_of(const Source& source, Picked<const scene::Query> queries, Also also) {
  constexpr std::size_t ahead = 16;
  const bool none_apart = source.extraordinary().empty();
  std::vector<Ray> rays;
  rays.reserve(queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i) {
    if (i + 2 * ahead < queries.size()) ask_for(queries[i + 2 * ahead]);
    if (i + ahead < queries.size() && !queries[i + ahead].en.empty()) source.ask_for_own(queries[i + ahead].en[0]);
    const scene::Query& query = queries[i];
    Ray& ray = rays.emplace_back(query.rayo);
    if (none_apart && ray.ordinary && query.en.size() == 1) ray.start_on(source.own(query.en[0]));
    also(i, query, ray);
  }
  return rays;
}

}  // namespace durero::trace
