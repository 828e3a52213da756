#pragma once
/// The points of a mesh. They stand in binary32 as long as each of them is exact there, as most meshes' points are, and
/// else in binary64. Reading one widens it exactly.

#include <cstddef>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <variant>
#include <vector>

namespace durero::scene {

/// A place in rows whose elements are made when they are read, for a loop over all.
template <class Rows>
class RowIterator {
 public:
  /// The rows must outlive it.
  RowIterator(const Rows& of, std::size_t row) noexcept : of_(&of), row_(row) {}
  /// Precondition: it is not at the end.
  auto operator*() const noexcept { return (*of_)[row_]; }
  /// Precondition: it is not at the end.
  RowIterator& operator++() noexcept {
    ++row_;
    return *this;
  }
  /// Precondition: they are of the same rows.
  bool operator==(const RowIterator& other) const noexcept { return row_ == other.row_; }

 private:
  const Rows* of_;
  std::size_t row_;
};

/// Points by number.
class MeshPoints {
 public:
  MeshPoints() = default;
  /// @{ These points.
  MeshPoints(const std::vector<glm::dvec3>& points);
  MeshPoints(std::initializer_list<glm::dvec3> points) : MeshPoints(std::vector<glm::dvec3>(points)) {}
  /// @}

  /// How many there are.
  std::size_t size() const noexcept { return is_single() ? singles().size() : doubles().size(); }
  /// There is none.
  bool empty() const noexcept { return size() == 0; }
  /// The point of a number. Precondition: number < size().
  glm::dvec3 operator[](std::size_t number) const noexcept {
    return is_single() ? glm::dvec3(singles()[number]) : doubles()[number];
  }
  /// @{ The first, and behind the last.
  RowIterator<MeshPoints> begin() const noexcept { return {*this, 0}; }
  RowIterator<MeshPoints> end() const noexcept { return {*this, size()}; }
  /// @}
  /// They are equal, number by number.
  bool operator==(const MeshPoints& other) const noexcept;

  /// Makes room for so many points in all.
  void reserve(std::size_t points);
  /// Adds a point.
  void push_back(const glm::dvec3& point);
  /// Sets the point of a number. Setting back what stood there before does not throw. Precondition: number < size().
  void set(std::size_t number, const glm::dvec3& point);
  /// The bytes that hold the points.
  std::size_t bytes() const noexcept;

 private:
  using Singles = std::vector<glm::vec3>;
  using Doubles = std::vector<glm::dvec3>;

  bool is_single() const noexcept { return points_.index() == 0; }
  const Singles& singles() const noexcept { return *std::get_if<Singles>(&points_); }
  const Doubles& doubles() const noexcept { return *std::get_if<Doubles>(&points_); }
  void widen_for(const glm::dvec3& point);

  std::variant<Singles, Doubles> points_;
};

}  // namespace durero::scene
