#pragma once
/// The parts that all divisions of space into cells share: the scene's elements, a list of elements for each cell, and
/// a mailbox for each ray.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/accel/line.hpp"
#include "durero/accel/slab.hpp"
#include "durero/accel/work.hpp"
#include "durero/scene/element_ref.hpp"
#include "durero/scene/scene.hpp"
#include "durero/surface/bounds.hpp"

namespace durero::accel {

/// The elements of a scene, numbered for a division of space. It keeps a reference to the scene.
struct Contents {
  /// Numbers the elements of a scene, which must outlive it unedited. O(n) for n elements.
  explicit Contents(const scene::Scene& scene);

  const scene::Scene* scene;                ///< the scene, unedited since
  std::vector<scene::ElementRef> elements;  ///< those with a finite box, by number
  std::vector<scene::ElementRef> apart;     ///< the others: not ordinary, or without a finite box
  surface::Box box;                         ///< of all numbered elements; a point where there are none

  /// The box of a numbered element.
  surface::Box box_of(std::uint32_t number) const;
};

/// A pair of an element and a cell that its surface touches.
struct Reference {
  std::uint32_t element, cell;  ///< both by number
  bool operator==(const Reference&) const = default;
};

/// Lists of numbers, one for each of `rows` rows.
class Lists {
 public:
  Lists() = default;
  /// @{ The elements of each cell, or the cells of each element, in the order of the references. O(rows + references).
  static Lists elements_of_cells(std::span<const Reference> references, std::size_t cells);
  static Lists cells_of_elements(std::span<const Reference> references, std::size_t elements);
  /// @}
  /// The list of a row.
  std::span<const std::uint32_t> operator[](std::size_t row) const {
    return {items_.data() + begins_[row], items_.data() + begins_[row + 1]};
  }
  std::size_t rows() const { return begins_.size() - 1; }   ///< the number of lists
  std::size_t references() const { return items_.size(); }  ///< the sum of their lengths
  /// The transposed lists: for each of `columns` numbers the rows that list it, ascending.
  Lists inverse(std::size_t columns) const;
  std::size_t bytes() const;  ///< the memory in bytes
  bool operator==(const Lists&) const = default;

 private:
  template <class RowOf, class ItemOf>
  static Lists made(std::span<const Reference> references, std::size_t rows, RowOf row_of, ItemOf item_of);

  std::vector<std::uint32_t> begins_{0};  // the begin of each row, and the end of the last
  std::vector<std::uint32_t> items_;
};

/// The mailbox of a ray: the elements that it was tested against, so that an element in many cells is tested once. It
/// belongs to the ray and not to the element, so that threads share nothing. It is a hash table with room for most
/// rays' elements.
class Mailbox {
 public:
  /// Notes an element; false where it was noted before.
  bool note(std::uint32_t element) {
    const std::uint32_t letter = element + 1;  // 0 is an empty place
    std::uint32_t at = place(letter);
    for (; places_[at] != 0; at = (at + 1) & mask_) {
      if (places_[at] == letter) return false;
    }
    places_[at] = letter;
    if (++count_ * 2 > mask_) grow();
    return true;
  }
  Mailbox() = default;
  Mailbox(const Mailbox&) = delete;
  Mailbox& operator=(const Mailbox&) = delete;

 private:
  std::uint32_t place(std::uint32_t letter) const { return letter * 0x9E3779B1u >> 7 & mask_; }
  void grow();

  std::array<std::uint32_t, 64> first_{};
  std::vector<std::uint32_t> more_;
  std::uint32_t* places_ = first_.data();
  std::uint32_t mask_ = 63, count_ = 0;
};

/// The base of all structures of cells, which make the lists.
class InCells {
 public:
  /// The scene of the structure.
  const scene::Scene& scene() const noexcept { return *contents_.scene; }
  /// The elements that are in no cell, which every ray is tested against.
  std::span<const scene::ElementRef> extraordinary() const noexcept { return contents_.apart; }
  /// The numbered elements.
  const Contents& contents() const noexcept { return contents_; }
  /// The elements of each cell; inverse() gives the cells of each element.
  const Lists& lists() const noexcept { return lists_; }

 protected:
  explicit InCells(const scene::Scene& scene) : contents_(scene) {}  ///< numbers the elements; the lists are empty
  /// The part of the size that is known without the cells: elements, references, and the bytes of both.
  Size size_of_lists() const;

  Contents contents_;  ///< the numbered elements
  Lists lists_;        ///< the elements of each cell
};

/// Visits the elements of a cell's list that the ray was not tested against yet, until visit(e) answers true. Whether
/// it did.
template <class Visit>
bool look_through(std::span<const std::uint32_t> list, const Contents& contents, Mailbox& mailbox, Work& work,
                  Visit& visit) {
  ++work.cells;
  for (const std::uint32_t number : list) {
    if (!mailbox.note(number)) {
      ++work.repeated;
      continue;
    }
    ++work.candidates;
    if (visit(contents.elements[number])) return true;
  }
  return false;
}

/// Visits the elements of the cells along a ray, until visit(e) answers true. Whether it did. walk_cells(line, look)
/// must call look(cell, event) for the cells in the order of the ray, with the crossing by which each is entered, until
/// look answers true.
///
/// A ray may meet an element of a cell outside the cell, and beyond points in the next cell. The traversal therefore
/// ends not at the first cell with a hit, but at the first that is entered beyond the limit: an element listed only
/// from there on has no point of the ray at or before the limit.
template <class Limit, class Visit, class WalkCells>
bool search_cells(const Contents& contents, const Lists& lists, const trace::Ray& ray, Limit& limit, Visit& visit,
                  Work& work, WalkCells walk_cells) {
  if (contents.elements.empty()) return false;
  ++work.volumes;
  if (!stretch(contents.box, Beam(ray), limit()).meets()) {
    ++work.by_miss;
    return false;
  }
  Mailbox mailbox;
  bool found = false;
  walk_cells(AxisRay(ray), [&](std::size_t cell, const PlaneCrossing& event) {
    if (AxisRay::beyond(event, limit())) {
      ++work.by_distance;
      return true;
    }
    found = look_through(lists[cell], contents, mailbox, work, visit);
    return found;
  });
  return found;
}

}  // namespace durero::accel
