#include "durero/accel/wide/leaf_columns.hpp"

#include <cmath>
#include <cstring>

namespace durero::accel {
namespace {

/// A coordinate of four triangles. (Highway has no SSE2 target, so its vectors would have one lane here.)
using Lanes [[gnu::vector_size(16)]] = float;
constexpr std::size_t lanes = sizeof(Lanes) / sizeof(float);

Lanes load(const float* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}
Lanes least(Lanes a, Lanes b) { return a < b ? a : b; }
Lanes greatest(Lanes a, Lanes b) { return a > b ? a : b; }

}  // namespace

void unpack(trace::TriangleBlocks blocks, std::uint32_t index, WideNode& node) {
  const trace::TriangleBlock block = blocks[index];
  trace::TriangleBlock::Columns vertices;
  trace::unpack(block, vertices);
  const scene::ElementRef first = LeafColumns::first_of(index);
  static_assert(WideNode::width == trace::TriangleBlock::size);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t at = 0; at < WideNode::width; at += lanes) {
      const auto of = [&](std::size_t vertex) { return load(&vertices[vertex][axis][at]); };
      const Lanes a = of(0), b = of(1), c = of(2);
      const auto has = a == a;
      const Lanes low = has ? least(least(a, b), c) : Lanes{} + HUGE_VALF;
      const Lanes high = has ? greatest(greatest(a, b), c) : Lanes{} - HUGE_VALF;
      std::memcpy(&node.planes[axis][at], &low, sizeof low);
      std::memcpy(&node.planes[axis + 3][at], &high, sizeof high);
    }
  for (std::uint32_t lane = 0; lane < WideNode::width; ++lane)
    node.children[lane] =
        block.has(lane) ? WideChild{first.index + lane, first.tipo, WideChild::Kind::element} : WideChild{};
}

}  // namespace durero::accel
