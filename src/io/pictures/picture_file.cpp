#include "durero/io/pictures/picture_file.hpp"

#include <fmt/format.h>
#include <png.h>

#include <array>

#include "durero/scene/srgb.hpp"
#include "durero/scene/stage.hpp"
#include "jpeg.hpp"

namespace durero::io {
namespace {

using scene::TexelImage;
using scene::TransferFunction;

void require_size(std::size_t width, std::size_t height) {
  if (width * height > most_texels)
    throw PictureError(fmt::format("it has {} by {} texels, more than {}", width, height, most_texels));
}

/// What each byte stands for.
std::array<double, 256> values_of(TransferFunction curve) {
  std::array<double, 256> values{};
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] =
        curve == TransferFunction::srgb ? linear_light(static_cast<std::uint8_t>(i)) : static_cast<double>(i) / 255;
  return values;
}

TexelImage picture_of_bytes(std::uint32_t width, std::uint32_t height, const std::vector<std::uint8_t>& rgb,
                            TransferFunction curve) {
  const auto values = values_of(curve);
  TexelImage picture{width, height};
  picture.texels.reserve(std::size_t{width} * height);
  for (std::size_t i = 0; i < rgb.size(); i += 3)
    picture.texels.emplace_back(values[rgb[i]], values[rgb[i + 1]], values[rgb[i + 2]]);
  return picture;
}

/// libpng's description of a file, whose memory is given back.
struct Png {
  png_image image{};
  Png() { image.version = PNG_IMAGE_VERSION; }
  ~Png() { png_image_free(&image); }
  Png(const Png&) = delete;
  Png& operator=(const Png&) = delete;

  template <class Sample>
  std::vector<Sample> samples(png_uint_32 format) {
    image.format = format;
    std::vector<Sample> all(std::size_t{image.width} * image.height * 3);
    if (!png_image_finish_read(&image, nullptr, all.data(), 0, nullptr)) fail();
    return all;
  }
  [[noreturn]] void fail() const { throw PictureError(fmt::format("libpng: {}", image.message)); }
};

/// libpng reads no further than the last texel. A file that was cut after it is told by its end chunk, which is not
/// there: from the eighth byte on each chunk is four bytes that hold the length of its data, four of its name, the data
/// and four more (ISO/IEC 15948, 5.3).
void require_end(std::string_view bytes) {
  const auto length_at = [&](std::size_t at) {
    std::size_t length = 0;
    for (const char byte : bytes.substr(at, 4)) length = length << 8U | static_cast<std::uint8_t>(byte);
    return length;
  };
  for (std::size_t at = 8; bytes.size() - at >= 12; at += 12 + length_at(at)) {
    if (bytes.substr(at + 4, 4) == "IEND") return;
    if (length_at(at) > bytes.size() - at - 12) break;
  }
  throw PictureError("it ends before its end chunk, IEND");
}

TexelImage picture_of_png(std::string_view bytes, TransferFunction curve) {
  Png png;
  if (!png_image_begin_read_from_memory(&png.image, bytes.data(), bytes.size())) png.fail();
  require_size(png.image.width, png.image.height);
  if ((png.image.format & PNG_FORMAT_FLAG_LINEAR) == 0) {
    const auto rgb = png.samples<std::uint8_t>(PNG_FORMAT_RGB);
    require_end(bytes);
    return picture_of_bytes(png.image.width, png.image.height, rgb, curve);
  }
  const auto rgb = png.samples<std::uint16_t>(PNG_FORMAT_LINEAR_RGB);
  require_end(bytes);
  TexelImage picture{png.image.width, png.image.height};
  picture.texels.reserve(rgb.size() / 3);
  for (std::size_t i = 0; i < rgb.size(); i += 3)
    picture.texels.push_back(glm::dvec3(rgb[i], rgb[i + 1], rgb[i + 2]) / 65535.0);
  return picture;
}

TexelImage picture_of_jpeg(std::string_view bytes, TransferFunction curve) {
  Jpeg jpeg;
  const std::string wrong = decode_jpeg(bytes, most_texels, jpeg);
  if (!wrong.empty()) throw PictureError("libjpeg: " + wrong);
  require_size(jpeg.width, jpeg.height);
  return picture_of_bytes(jpeg.width, jpeg.height, jpeg.rgb, curve);
}

}  // namespace

double linear_light(std::uint8_t srgb) noexcept { return scene::linear_of_srgb(srgb / 255.0); }

TexelImage picture_of(std::string_view bytes, TransferFunction curve) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return picture_of_png(bytes, curve);
  if (bytes.starts_with("\xff\xd8\xff")) return picture_of_jpeg(bytes, curve);
  throw PictureError("it is no picture");
}

}  // namespace durero::io
