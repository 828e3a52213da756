#pragma once
/// A tone maps colours without a bound to those of a screen, from 0 to 1 (the post-process of the realism seed).

#include <array>
#include <string_view>

#include "durero/render/output/image.hpp"
#include "durero/render/output/picture.hpp"

namespace durero::render {

/// The map of a component c. Each is monotone: of two components the greater one becomes no smaller byte.
enum class Tone {
  clamp,    ///< c as it is, cut at 1
  max,      ///< c over the greatest finite component of the picture, which becomes exactly 1; c where all are 0
  reinhard  ///< 1 − 1/(1 + c), that is c/(1 + c): below 1 whatever c is, and an infinite c is 1
};

/// Their names, in the order of Tone.
inline constexpr std::array<std::string_view, 3> tone_names{"clamp", "max", "reinhard"};

/// The picture in that tone, each component its scene::srgb_byte.
Image toned(const Picture& picture, Tone tone);

}  // namespace durero::render
