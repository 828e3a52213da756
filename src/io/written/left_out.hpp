#pragma once
/// The elements that a format has no place for, counted by what they are.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "durero/scene/scene.hpp"

namespace durero::io {

class LeftOutElements {
 public:
  /// Counts a shape by its type.
  template <class Shape>
  void add(const Shape&) {
    ++shapes_[scene::place_of<Shape>];
  }
  /// Counts a body: a copy or a solid.
  void add(const scene::Body& body);
  /// Adds a line for each kind. `format` is the name of the other format.
  void name_losses(std::vector<std::string>& lost, std::string_view format) const;

 private:
  std::array<std::size_t, scene::shape_count> shapes_{};
  std::size_t instances_ = 0, solids_ = 0;
};

}  // namespace durero::io
