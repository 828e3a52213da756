#include "durero/accel/cells.hpp"

#include <glm/common.hpp>
#include <numeric>

#include "accel/finite_box.hpp"
#include "durero/surface/surfaces.hpp"

namespace durero::accel {

Contents::Contents(const scene::Scene& of) : scene(&of), box{} {
  of.for_each([&](scene::ElementRef e, const auto&) {
    const auto around = finite_box(of, e);
    if (!around) return apart.push_back(e);
    box = elements.empty() ? *around : surface::Box{glm::min(box.low, around->low), glm::max(box.high, around->high)};
    elements.push_back(e);
  });
}

surface::Box Contents::box_of(std::uint32_t number) const {
  return scene->visit(elements[number], [](const auto& shape) { return surface::box(shape); });
}

Size InCells::size_of_lists() const {
  const std::size_t known = contents_.elements.capacity() + contents_.apart.capacity();
  return {.elements = contents_.elements.size(),
          .apart = contents_.apart.size(),
          .references = lists_.references(),
          .bytes = lists_.bytes() + known * sizeof(scene::ElementRef)};
}

template <class RowOf, class ItemOf>
Lists Lists::made(std::span<const Reference> references, std::size_t rows, RowOf row_of, ItemOf item_of) {
  Lists lists;
  lists.begins_.assign(rows + 1, 0);
  for (const Reference& reference : references) ++lists.begins_[row_of(reference) + 1];
  std::partial_sum(lists.begins_.begin(), lists.begins_.end(), lists.begins_.begin());
  lists.items_.resize(references.size());
  std::vector<std::uint32_t> next = lists.begins_;
  for (const Reference& reference : references) {
    const std::size_t row = row_of(reference);
    const std::uint32_t place = next[row]++;
    lists.items_[place] = item_of(reference);
  }
  return lists;
}

Lists Lists::elements_of_cells(std::span<const Reference> references, std::size_t cells) {
  return made(
      references, cells, [](const Reference& r) { return r.cell; }, [](const Reference& r) { return r.element; });
}

Lists Lists::cells_of_elements(std::span<const Reference> references, std::size_t elements) {
  return made(
      references, elements, [](const Reference& r) { return r.element; }, [](const Reference& r) { return r.cell; });
}

Lists Lists::inverse(std::size_t columns) const {
  std::vector<Reference> references;
  references.reserve(items_.size());
  for (std::uint32_t row = 0; row < rows(); ++row)
    for (const std::uint32_t item : (*this)[row]) references.push_back({item, row});
  return cells_of_elements(references, columns);
}

std::size_t Lists::bytes() const { return (begins_.capacity() + items_.capacity()) * sizeof(std::uint32_t); }

void Mailbox::grow() {
  const std::vector<std::uint32_t> old(places_, places_ + mask_ + 1);
  mask_ = 4 * mask_ + 3;
  more_.assign(mask_ + 1, 0);
  places_ = more_.data();
  for (const std::uint32_t letter : old) {
    if (letter == 0) continue;
    std::uint32_t at = place(letter);
    while (places_[at] != 0) at = (at + 1) & mask_;
    places_[at] = letter;
  }
}

}  // namespace durero::accel
