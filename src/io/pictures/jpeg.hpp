#pragma once
/// A JPEG file, by libjpeg.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace durero::io {

/// Rows from the top, three bytes a texel.
struct Jpeg {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgb{};
};

/// Decodes it into `to`. What libjpeg says against it, also where it would go on after; empty where it says nothing.
/// `most` texels are decoded.
std::string decode_jpeg(std::string_view bytes, std::size_t most, Jpeg& to);

}  // namespace durero::io
