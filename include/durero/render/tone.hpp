#pragma once
/// How colours without a bound become such as a screen shows, from 0 to 1 (the post-process of the realism seed).

#include <array>
#include <string_view>

#include "durero/render/image.hpp"
#include "durero/render/picture.hpp"

namespace durero::render {

/// What is done with a component c. Each is monotone: of two components the greater one becomes no smaller byte.
enum class Tone {
  clamp,    ///< c as it is; what is above 1 is cut
  max,      ///< c over the greatest finite component of the picture, which becomes exactly 1; as it is where all are 0
  reinhard  ///< 1 − 1/(1 + c), that is c/(1 + c): below 1 whatever c is, and an infinite c is 1
};

/// Their names, in the order of Tone.
inline constexpr std::array<std::string_view, 3> tone_names{"clamp", "max", "reinhard"};

/// The picture in that tone, each component its srgb_byte.
Image toned(const Picture& picture, Tone tone);

}  // namespace durero::render
