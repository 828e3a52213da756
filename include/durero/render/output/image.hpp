#pragma once
/// A picture of 8-bit sRGB pixels, and its PNG file.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "durero/scene/stage.hpp"

namespace durero::render {

/// A picture, black at first.
struct Image {
  /// A black image of that size.
  explicit Image(scene::Resolution size) : resolution(size), rgb(std::size_t(size.width) * size.height * 3) {}

  /// Sets pixel (x, y), (0, 0) upper left, to a linear colour: each component becomes its scene::srgb_byte.
  void set(std::uint32_t x, std::uint32_t y, const glm::dvec3& color);

  scene::Resolution resolution;   ///< in pixels
  std::vector<std::uint8_t> rgb;  ///< rows from the top, three bytes a pixel
};

/// A note is a line of text in a picture's file: a chunk of PNG, an attribute of OpenEXR.
struct Note {
  std::string keyword;  ///< a keyword as in PNG, such as `Software`: 1 to 79 characters of ASCII
  std::string text;     ///< UTF-8
};

/// The bytes of a PNG file, which declares its pixels to be sRGB: by the chunk sRGB, and for other readers by the
/// nearest chunks gAMA and cHRM. Notes of ASCII are chunks tEXt, others iTXt. The same image and notes give the same
/// bytes. Throws std::runtime_error when libpng refuses.
std::string encode_png(const Image& image, std::span<const Note> notes = {});

}  // namespace durero::render
