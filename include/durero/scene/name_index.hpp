#pragma once
/// From the name of an element to its place in the tables, in O(1).
///
/// A hash table with linear probing whose cells hold only a hash and a place; the names stay in the tables. Why not
/// a library's: to undo a removal after a broken postcondition the name must go back without asking for memory, which
/// tsl::robin_map does not promise, and a node container costs two more cache misses an edit.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "durero/scene/element_ref.hpp"
#include "durero/scene/shapes.hpp"

namespace durero::scene {

/// The places of names, of which it keeps the hashes alone.
class NameIndex {
 public:
  /// So many bits of a cell hold the type of an element, and the others its index.
  static constexpr unsigned type_bits = std::bit_width(shape_count - 1);
  static_assert(type_bits <= 3, "a table of more than 2^29 elements, or more than eight types, needs larger cells");
  /// ElementRef::index is at most this: a cell with all bits set is unused.
  static constexpr std::uint32_t last_index = (~std::uint32_t{0} >> type_bits) - 1;

  /// A hash of a name.
  using hash_type = std::uint32_t;

  /// The same on every machine.
  static hash_type hash(std::string_view name) noexcept;

  /// How many names are in.
  std::size_t size() const noexcept { return size_; }

  /// Makes room for one more name. The only member that asks for memory; the strong guarantee holds.
  void reserve_one_more();

  /// The place of the name with this hash for which `is_it(place)` holds.
  template <class IsIt>
  std::optional<ElementRef> find(hash_type hash, IsIt&& is_it) const noexcept {
    if (cells_.empty()) return std::nullopt;
    for (std::size_t i = home(hash); cells_[i].is_used(); i = next(i))
      if (cells_[i].hash == hash && is_it(cells_[i].place())) return cells_[i].place();
    return std::nullopt;
  }

  /// Whether some name with this hash lies at this place.
  bool knows(hash_type hash, ElementRef place) const noexcept {
    return find(hash, [&](ElementRef other) { return other == place; }).has_value();
  }

  /// Adds a name that is not in. Precondition: reserve_one_more() since the last insert, or an erase.
  void insert(hash_type hash, ElementRef place) noexcept;
  /// Removes the name at this place. Precondition: it is in.
  void erase(hash_type hash, ElementRef place) noexcept;
  /// Tells that the name at place `from` now lies at place `to`. Precondition: it is in.
  void move(hash_type hash, ElementRef from, ElementRef to) noexcept;

 private:
  /// Eight bytes, so that a probe seldom leaves a cache line: the type is the lowest bits of `packed`.
  struct Cell {
    static constexpr std::uint32_t unused = ~std::uint32_t{0};

    hash_type hash = 0;
    std::uint32_t packed = unused;

    Cell() = default;
    Cell(hash_type h, ElementRef place)
        : hash(h), packed(place.index << type_bits | static_cast<std::uint32_t>(place.tipo)) {}
    bool is_used() const noexcept { return packed != unused; }
    ElementRef place() const noexcept {
      return {static_cast<model::Tipo>(packed & ((1u << type_bits) - 1)), packed >> type_bits};
    }
  };

  std::size_t home(hash_type hash) const noexcept { return hash & (cells_.size() - 1); }
  std::size_t next(std::size_t i) const noexcept { return (i + 1) & (cells_.size() - 1); }
  std::size_t cell_of(hash_type hash, ElementRef place) const noexcept;

  std::vector<Cell> cells_;  // a power of two of them, at most half of them used
  std::size_t size_ = 0;
};

}  // namespace durero::scene
