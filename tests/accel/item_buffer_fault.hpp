#pragma once
/// A friend of ItemBuffer, which stands in the type's own namespace.

#include <cstdint>

#include "durero/accel/item_buffer.hpp"

namespace durero::accel {

/// Plants another identity where a pixel keeps one.
struct ItemBufferFault {
  static void plant(ItemBuffer& buffer, std::uint32_t pixel, scene::ElementRef e) {
    const ItemBuffer::Pixel& of = buffer.pixels_[pixel];
    if (of.count == 1) buffer.items_[of.first] = e;
  }
  static bool keeps_one(const ItemBuffer& buffer, std::uint32_t pixel) { return buffer.pixels_[pixel].count == 1; }
};

}  // namespace durero::accel
