#pragma once
/// What every division of space into cells holds: its elements, the list of each cell, and for one ray, which elements
/// were handed over already.

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

/// The elements of a scene as a division of space knows them. Keeps a reference to the scene.
struct Contents {
  /// O(n) for n elements.
  explicit Contents(const scene::Scene& scene);

  const scene::Scene* scene;                ///< unedited since
  std::vector<scene::ElementRef> elements;  ///< those with a box; a cell lists their numbers, which are places here
  std::vector<scene::ElementRef> apart;     ///< those that are not ordinary, and those without a finite box
  surface::Box box;                         ///< of all elements with a box; of none, a point

  /// Of one element with a box.
  surface::Box box_of(std::uint32_t number) const;
};

/// An element, by its number, and a cell that its surface touches.
struct Reference {
  std::uint32_t element, cell;  ///< both by number
  bool operator==(const Reference&) const = default;
};

/// Lists of numbers, one for each of `rows` rows.
class Lists {
 public:
  Lists() = default;
  /// @{ Of each cell its elements, and of each element its cells: in the order of the references. O(rows + references).
  static Lists elements_of_cells(std::span<const Reference> references, std::size_t cells);
  static Lists cells_of_elements(std::span<const Reference> references, std::size_t elements);
  /// @}
  /// The list of a row.
  std::span<const std::uint32_t> operator[](std::size_t row) const {
    return {items_.data() + begins_[row], items_.data() + begins_[row + 1]};
  }
  std::size_t rows() const { return begins_.size() - 1; }   ///< how many lists
  std::size_t references() const { return items_.size(); }  ///< how many numbers in all of them
  /// The same references the other way round: of each of `columns` numbers, the rows that list it, ascending.
  Lists inverse(std::size_t columns) const;
  std::size_t bytes() const;  ///< of memory
  bool operator==(const Lists&) const = default;

 private:
  template <class RowOf, class ItemOf>
  static Lists made(std::span<const Reference> references, std::size_t rows, RowOf row_of, ItemOf item_of);

  std::vector<std::uint32_t> begins_{0};  // of each row, and the end of the last
  std::vector<std::uint32_t> items_;
};

/// Which elements one ray has been tested against: an element in many cells is handed over once. It belongs to the ray
/// and not to the element, so threads share nothing. A hash table with room at first for as many as most rays meet.
class Mailbox {
 public:
  /// Takes note of an element; false where it was noted before.
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

/// What every structure of cells is made of: the base of each, which makes the lists.
class InCells {
 public:
  /// The scene that it was made of.
  const scene::Scene& scene() const noexcept { return *contents_.scene; }
  /// The elements that are in no cell.
  std::span<const scene::ElementRef> extraordinary() const noexcept { return contents_.apart; }
  /// What the cells list.
  const Contents& contents() const noexcept { return contents_; }
  /// Of each cell its elements, and by inverse() of each element its cells.
  const Lists& lists() const noexcept { return lists_; }

 protected:
  explicit InCells(const scene::Scene& scene) : contents_(scene) {}  ///< of a scene, with no lists yet
  /// What is known without the cells themselves: elements, references, and the bytes of both.
  Size size_of_lists() const;

  Contents contents_;  ///< what the lists number
  Lists lists_;        ///< of each cell
};

/// Hands over the elements of a cell's list that the ray was not yet tested against, until visit(e) answers true.
/// Whether it did.
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

/// The elements of the cells along a ray, handed over until visit(e) answers true. Whether it did.
/// walk_cells(line, look) calls look(cell, event) for the cells in the order of the ray, with the crossing by which
/// each is entered, until it answers true.
///
/// An element of a cell may be met outside it, and farther than what the next cell holds. So the walk does not end with
/// the first cell in which something is hit, but before the first that is entered beyond the limit: whatever is listed
/// only from there on has no point of the ray at or before it.
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
  walk_cells(Line(ray), [&](std::size_t cell, const Crossing& event) {
    if (Line::beyond(event, limit())) {
      ++work.by_distance;
      return true;
    }
    found = look_through(lists[cell], contents, mailbox, work, visit);
    return found;
  });
  return found;
}

}  // namespace durero::accel
