#pragma once
/// The OpenEXR file of a picture: linear, of binary32, nothing cut.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "durero/render/image.hpp"
#include "durero/render/picture.hpp"
#include "durero/render/seen.hpp"

namespace durero::render {

/// Channels beside the colour, and what their numbers stand for.
struct Channels {
  std::vector<Seen> pixels;        ///< as many as the picture has, rows from the top
  std::vector<std::string> names;  ///< of the elements, that of number 1 first
};

/// The bytes of an OpenEXR file with the primaries of sRGB: channels R, G, B, each component rounded to binary32; with
/// channels also Z (depth), N.X, N.Y, N.Z (normal), and the whole numbers `id` and `level`, and the attribute
/// `elements`. Notes are attributes by their keyword in small letters. Same content, same bytes. Throws
/// std::runtime_error when the library refuses.
std::string encode_exr(const Picture& picture, std::span<const Note> notes = {},
                       const std::optional<Channels>& channels = {});

}  // namespace durero::render
