#include "durero/scene/name_index.hpp"

#include <functional>

namespace durero::scene {

NameIndex::hash_type NameIndex::hash(std::string_view name) noexcept {
  const std::uint64_t wide = std::hash<std::string_view>{}(name);
  return static_cast<hash_type>(wide ^ (wide >> 32));
}

void NameIndex::reserve_one_more() {
  if (2 * (size_ + 1) <= cells_.size()) return;
  NameIndex larger;
  larger.cells_.resize(cells_.empty() ? 16 : 2 * cells_.size());
  for (const Cell& cell : cells_)
    if (cell.is_used()) larger.insert(cell.hash, cell.place());
  *this = std::move(larger);
}

void NameIndex::insert(hash_type hash, ElementRef place) noexcept {
  std::size_t i = home(hash);
  while (cells_[i].is_used()) i = next(i);
  cells_[i] = {hash, place};
  ++size_;
}

void NameIndex::erase(hash_type hash, ElementRef place) noexcept {
  std::size_t hole = cell_of(hash, place);
  // Close the gap: a later cell of the run may move into the hole unless its home lies after the hole.
  for (std::size_t i = next(hole); cells_[i].is_used(); i = next(i)) {
    const std::size_t mask = cells_.size() - 1;
    if (((i - home(cells_[i].hash)) & mask) < ((i - hole) & mask)) continue;
    cells_[hole] = cells_[i];
    hole = i;
  }
  cells_[hole] = {};
  --size_;
}

void NameIndex::move(hash_type hash, ElementRef from, ElementRef to) noexcept {
  cells_[cell_of(hash, from)] = {hash, to};
}

std::size_t NameIndex::cell_of(hash_type hash, ElementRef place) const noexcept {
  const std::uint32_t packed = Cell(hash, place).packed;
  std::size_t i = home(hash);
  while (cells_[i].packed != packed) i = next(i);
  return i;
}

}  // namespace durero::scene
