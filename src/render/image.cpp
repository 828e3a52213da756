#include "durero/render/image.hpp"

#include <png.h>

#include <cmath>
#include <stdexcept>

namespace durero::render {

std::uint8_t srgb_byte(double linear) noexcept {
  if (!(linear > 0)) return 0;
  if (linear >= 1) return 255;
  const double value = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::floor(value * 255 + 0.5));
}

void Image::set(std::uint32_t x, std::uint32_t y, const glm::dvec3& color) {
  std::uint8_t* pixel = &rgb[(std::size_t(y) * resolution.width + x) * 3];
  for (int i = 0; i < 3; ++i) pixel[i] = srgb_byte(color[i]);
}

std::string encode_png(const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = image.resolution.width;
  header.height = image.resolution.height;
  header.format = PNG_FORMAT_RGB;  // for 8-bit pixels libpng then writes the chunk sRGB
  png_alloc_size_t size = 0;
  const auto write = [&](void* to) {
    if (!png_image_write_to_memory(&header, to, &size, 0, image.rgb.data(), 0, nullptr))
      throw std::runtime_error(header.message);
  };
  write(nullptr);  // asks for the size
  std::string bytes(size, '\0');
  write(bytes.data());
  bytes.resize(size);
  return bytes;
}

}  // namespace durero::render
