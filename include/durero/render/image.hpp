#pragma once
/// A picture of 8-bit sRGB pixels, and its PNG file.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "durero/scene/stage.hpp"

namespace durero::render {

/// The byte of a component of a linear colour: its value on the sRGB curve (IEC 61966-2-1), which is 12.92·c up to
/// 0.0031308 and 1.055·c^(1/2.4) − 0.055 above, scaled to 0 … 255 and rounded to the nearest, halves up. What is below
/// 0 and what is no number (the product of a black material and an infinite light) is 0; what is above 1 is 255.
std::uint8_t srgb_byte(double linear) noexcept;

/// A picture, black at first.
struct Image {
  /// Of that size.
  explicit Image(scene::Resolution size) : resolution(size), rgb(std::size_t(size.width) * size.height * 3) {}

  /// Sets pixel (x, y), (0, 0) upper left, to a linear colour: each component becomes its srgb_byte.
  void set(std::uint32_t x, std::uint32_t y, const glm::dvec3& color);

  scene::Resolution resolution;   ///< in pixels
  std::vector<std::uint8_t> rgb;  ///< rows from the top, three bytes a pixel
};

/// A line of text that a file of a picture carries along: in PNG a chunk, in OpenEXR an attribute.
struct Note {
  std::string keyword;  ///< as PNG has them: `Software`; 1 to 79 characters of ASCII
  std::string text;     ///< UTF-8
};

/// The bytes of a PNG file, which declares its pixels to be sRGB: by the chunk sRGB, and for readers that do not know
/// it by the chunks gAMA and cHRM that come nearest. Notes of ASCII are chunks tEXt, others iTXt. Same image and notes,
/// same bytes. Throws std::runtime_error when libpng refuses.
std::string encode_png(const Image& image, std::span<const Note> notes = {});

}  // namespace durero::render
