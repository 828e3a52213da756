#pragma once
/// An object of a POV-Ray text, as it stands there.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "durero/scene/body.hpp"
#include "pov_light.hpp"
#include "pov_look.hpp"
#include "pov_patch.hpp"
#include "pov_shapes.hpp"
#include "pov_surfaces.hpp"

namespace durero::io {

/// What an object tells of its look: the number of its material, or that it has none.
struct ObjectMaterial {
  bool is_told = false;
  std::optional<std::uint32_t> material{};
  std::optional<PovPlace> at{};  ///< where its textures stand
};

/// An object as it stands in the text: a shape, or what another holds.
struct PovObject {
  std::size_t at;  ///< its word
  std::string_view word;
  std::string text{};  ///< of what it consists of, without attributes
  std::optional<PovShape> shape{};
  std::optional<std::array<glm::dvec3, 2>> box{};  ///< its corners
  std::optional<PovSurface> surface{};
  std::vector<PovPiece> pieces{};  ///< that it consists of, where they are all
  std::optional<PovElement> element{};
  std::optional<PovPatch> patch{};
  std::vector<PovClip> clips{};    ///< by what it is clipped, as that is moved
  std::optional<PovClip> bound{};  ///< its bound, likewise, where it could clip
  std::optional<PovLight> light{};
  std::vector<PovObject> parts{};
  ObjectMaterial look{};
  std::array<bool, 3> flags{};  ///< in step with their words
  PovTransform moved{};         ///< by its own transformations
  bool is_left_out = false;     ///< no scene has such
  bool is_inverse = false;      ///< its inside is outside
  bool has_lost_clip = false;   ///< it is clipped by what is no PovClip

  bool may_be_cut = false;  ///< its bound may not hold all of it

  bool is_clipped() const { return has_lost_clip || !clips.empty(); }
};

}  // namespace durero::io
