#pragma once
/// The difference of two pictures is a picture.

#include <cstdint>

#include "durero/render/output/image.hpp"

namespace durero::raster {

/// The difference of two pictures.
struct PictureDifference {
  render::Image image;       ///< of each byte, how far apart the two are
  std::uint64_t pixels = 0;  ///< pixels with any difference
  int greatest = 0;          ///< of all bytes, 0 to 255
};

/// The difference of two pictures of one size. Throws std::invalid_argument where they are of two.
PictureDifference difference(const render::Image& one, const render::Image& other);

}  // namespace durero::raster
