#include "durero/render/image.hpp"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace durero::render {

void Image::set(std::uint32_t x, std::uint32_t y, const glm::dvec3& color) {
  std::uint8_t* pixel = &rgb[(std::size_t(y) * resolution.width + x) * 3];
  for (int i = 0; i < 3; ++i)
    pixel[i] = static_cast<std::uint8_t>(std::floor(std::clamp(color[i], 0.0, 1.0) * 255 + 0.5));
}

std::string encode_png(const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = image.resolution.width;
  header.height = image.resolution.height;
  header.format = PNG_FORMAT_RGB;
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
