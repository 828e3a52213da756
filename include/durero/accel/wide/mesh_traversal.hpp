#pragma once
/// Traversal of a wide hierarchy of triangle blocks by bundles of coherent rays in binary32. It answers most rays of a
/// mesh without binary64 (trace/single_rays.hpp), and hands the others back.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "durero/accel/wide/wide_node.hpp"
#include "durero/trace/single_rays.hpp"
#include "durero/trace/triangle_block.hpp"

namespace durero::accel {

/// A range of numbers of binary32.
struct Range32 {
  float low, high;                                     ///< the ends
  float width() const { return high - low; }           ///< their distance, rounded
  float size() const { return std::max(-low, high); }  ///< the greatest magnitude
};

/// A tree whose leaves are all blocks of triangles, within the range of the test in binary32.
struct MeshTree {
  std::span<const WideNode> nodes;  ///< each before its children and the root first
  trace::TriangleBlocks blocks;     ///< the leaves
  std::array<Range32, 3> all;       ///< the box of the root
  float narrow;                     ///< the greatest width of a bundle
};

/// Answers the rays of a bundle that it can answer, and adds the others to rays.left. Precondition: rays were pushed.
void search(const MeshTree& tree, trace::SingleSearch search, trace::SingleRays& rays);

}  // namespace durero::accel
