#pragma once
/// A picture of 8-bit RGB pixels, and its PNG file.

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "durero/scene/stage.hpp"

namespace durero::render {

struct Image {
  explicit Image(scene::Resolution size) : resolution(size), rgb(std::size_t(size.width) * size.height * 3) {}

  /// Sets pixel (x, y), (0, 0) upper left. Each component is cut to [0, 1] and scaled to 0 … 255, halves up.
  void set(std::uint32_t x, std::uint32_t y, const glm::dvec3& color);

  scene::Resolution resolution;
  std::vector<std::uint8_t> rgb;  ///< rows from the top, three bytes a pixel
};

/// The bytes of a PNG file. Same image, same bytes. Throws std::runtime_error when libpng refuses.
std::string encode_png(const Image& image);

}  // namespace durero::render
