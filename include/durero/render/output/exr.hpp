#pragma once
/// The OpenEXR file of a picture holds its linear colours in binary32, without a cut.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "durero/render/output/image.hpp"
#include "durero/render/output/picture.hpp"
#include "durero/render/sample/seen.hpp"

namespace durero::render {

/// The channels beside the colour, with the names behind their numbers.
struct Channels {
  std::vector<PrimaryHit> pixels;  ///< one for each pixel of the picture, rows from the top
  std::vector<std::string> names;  ///< the names of the elements, that of number 1 first
};

/// The bytes of an OpenEXR file with the primaries of sRGB: channels R, G, B, each component rounded to binary32; with
/// channels also Z (depth), N.X, N.Y, N.Z (normal), and the whole numbers `id` and `level`, and the attribute
/// `elements`. Notes are attributes by their keyword in small letters. Same content, same bytes. Throws
/// std::runtime_error when the library refuses.
std::string encode_exr(const Picture& picture, std::span<const Note> notes = {},
                       const std::optional<Channels>& channels = {});

}  // namespace durero::render
