#pragma once
/// A block of triangles with the memory that it is a view of.

#include <vector>

#include "durero/trace/triangle_block.hpp"

namespace durero::test {

/// A block that triangles are added to.
class HeldBlock {
 public:
  /// Adds a triangle in the next lane.
  void push_back(const scene::Triangle& triangle, std::uint32_t element) {
    builder_.push_back(triangle, element);
    units_.clear();
    builder_.append_to(units_);
    units_.resize(units_.size() + trace::TriangleBlock::room);
  }
  /// The block. Precondition: there is a triangle.
  trace::TriangleBlock view() const { return trace::TriangleBlock(units_.data()); }

 private:
  trace::BlockBuilder builder_;
  std::vector<trace::TriangleBlock::Unit> units_;
};

}  // namespace durero::test
