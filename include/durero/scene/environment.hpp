#pragma once
/// What stands around a scene, infinitely far away: a colour for each direction.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "durero/scene/picture.hpp"

namespace durero::scene {

/// How directions are laid out. Upwards is +y, in all of them.
enum class Surroundings : std::uint8_t {
  gradient,         ///< no picture: from one colour straight below to another straight above
  box,              ///< six pictures, the faces of a cube, as cameras of 90° see them
  spherical,        ///< a mirror ball, seen from far away along −z
  equirectangular,  ///< a panorama: longitude across, latitude upwards, −z in the middle
};
/// Their keys in files, in step.
inline constexpr std::array<std::string_view, 4> surroundings_words{"gradient", "box", "spherical", "equirectangular"};

/// The faces of a box, in the order of its pictures.
inline constexpr std::array<std::string_view, 6> box_faces{"+x", "-x", "+y", "-y", "+z", "-z"};

/// How many pictures there are.
constexpr std::size_t pictures_of(Surroundings kind) noexcept {
  switch (kind) {
    case Surroundings::gradient:
      return 0;
    case Surroundings::box:
      return box_faces.size();
    case Surroundings::spherical:
    case Surroundings::equirectangular:
      return 1;
  }
  return 0;
}

/// An environment.
struct Environment {
  Surroundings kind = Surroundings::gradient;  ///< what it is made of
  std::array<glm::dvec3, 2> colors{};          ///< of a gradient: below and above, linear, each from 0
  std::vector<PictureFile> pictures{};         ///< as many as pictures_of() says
  bool operator==(const Environment&) const = default;
};

}  // namespace durero::scene
