#define HWY_TARGET_INCLUDE "trace/triangle_block.cpp"  // as seen from src/
#include "lanes/for_each_target.hpp"
//
#include <bit>
#include <cstring>
#include <limits>

#include "durero/trace/triangle_block.hpp"
#include "trace/block_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {
namespace {

void corners_in_columns(const TriangleBlock& block, TriangleBlock::Columns& columns) {
  const SingleTag tag;
  for (std::size_t at = 0; at < TriangleBlock::size; at += hn::Lanes(tag)) {
    const SingleMask used = used_from(block, at);
    const LaneCorners corners = corners_of(block, at);
    const Triple in_order[] = {corners.a, corners.b, corners.c};
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto store = [&](Singles some, std::size_t axis) HWY_ATTR {
        const Singles nothing = hn::Set(tag, std::numeric_limits<float>::quiet_NaN());
        hn::StoreU(hn::IfThenElse(used, some, nothing), tag, &columns[i][axis][at]);
      };
      store(in_order[i].x, 0), store(in_order[i].y, 1), store(in_order[i].z, 2);
    }
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::trace {
namespace {
HWY_EXPORT(corners_in_columns);
}  // namespace

void unpack(const TriangleBlock& block, TriangleBlock::Columns& columns) {
  HWY_DYNAMIC_DISPATCH(corners_in_columns)(block, columns);
}

void BlockBuilder::push_back(const scene::Triangle& triangle, std::uint32_t element) {
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3& p = triangle.vertices[i];
    const Point own{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    const auto same = [&](const Point& other, std::size_t axis) {  // −0 is not 0
      return std::bit_cast<std::uint32_t>(other[axis]) == std::bit_cast<std::uint32_t>(own[axis]);
    };
    std::size_t number = 0;
    while (number < points_ && !(same(point_[number], 0) && same(point_[number], 1) && same(point_[number], 2)))
      ++number;
    if (number == points_) point_[points_++] = own;
    numbers_[i][count_] = static_cast<std::uint8_t>(number);
  }
  elements_[count_++] = element;
}

void BlockBuilder::write(std::byte* to) const {
  const auto put = [&](const auto& what) {
    std::memcpy(to, &what, sizeof what);
    to += sizeof what;
  };
  const std::size_t points = this->points();
  const bool shared = points < 3 * count_;
  put(std::array<std::uint8_t, TriangleBlock::head>{static_cast<std::uint8_t>(count_),
                                                    static_cast<std::uint8_t>(points)});
  if (shared) put(numbers_);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (shared) {
      for (std::size_t number = 0; number < points; ++number) put(point_[number][axis]);
    } else {
      for (const auto& corner : numbers_)
        for (std::size_t lane = 0; lane < count_; ++lane) put(point_[corner[lane]][axis]);
    }
  for (std::size_t lane = 0; lane < count_; ++lane) put(elements_[lane]);
}

}  // namespace durero::trace
#endif
