#pragma once
/// Textures, environments and the coordinates of surfaces in POV-Ray's language: by patterns and warps of its own where
/// it has them, else by functions, which are of places, and whose values are numbers: a colour is three of them.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "durero/scene/any_shape.hpp"
#include "durero/scene/environment.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"
#include "durero/scene/texture.hpp"

namespace durero::io {

/// The expressions of x, y and z that are the (u, v) of a point of an element (render/coordinates.hpp). Their gradients
/// lie in the surface.
struct PovCoordinates {
  std::string u;
  std::string v;
  double length = 1;  ///< of a unit of v on it, about
  /// What lays the unit square of a pattern's x and y on the surface, half a unit of z above it; empty where nothing
  /// does.
  std::string place{};
  double depth = 1;  ///< of that unit of z
};

/// Of one element.
PovCoordinates pov_coordinates(const scene::Scene& scene, scene::ElementRef element);
/// Of a shape, whose vertices have no coordinates of their own.
PovCoordinates pov_coordinates(const scene::AnyShape& shape);

/// The expressions that are the red, the green and the blue of something.
using PovChannels = std::array<std::string, 3>;

/// A pigment whose red, green and blue are those numbers, each times that of a colour; behind the colours stands a
/// text.
std::string pov_pigment(const PovChannels& channels, const glm::dvec3& color, std::string_view behind = "");

/// What a pattern chooses between.
enum class PovLevel : std::uint8_t { color, texture };

/// The textures of a scene that can be written, and what they need declared before the first use.
class PovPatterns {
 public:
  explicit PovPatterns(const std::vector<scene::Texture>& textures);

  /// The declarations of the functions that stand in a text, a line each.
  std::string declarations(std::string_view text) const;
  /// Of the texture of that name at u and v, two expressions; nothing of one whose file is of no kind that POV-Ray
  /// knows by its name.
  std::optional<PovChannels> channels(const std::string& name, const PovCoordinates& at) const;
  /// The pattern of the texture of that name, with these in place of its two colours; of waves, all between them too.
  /// `is_placed` tells whether what it chooses between may be laid on the surface with it. Precondition: it is no
  /// image.
  std::string pattern(const std::string& name, const PovCoordinates& at, PovLevel level, std::string_view first,
                      std::string_view second, bool is_placed = true) const;
  /// The picture of the texture of that name as a pigment; empty where a function must stand for it, or nothing.
  std::string picture(const std::string& name, const PovCoordinates& at) const;
  /// A normal that this relief turns; empty where its texture cannot be written.
  std::string normal(const scene::Bump& relief, const PovCoordinates& at) const;
  /// Whether that normal is, in the limit, the one that is drawn here.
  bool is_exact(const scene::Bump& relief) const;
  /// How many textures are left out.
  std::size_t unknown() const { return unknown_; }
  /// @{ The texture of that name, and whether it can be written.
  const scene::Texture& named(const std::string& name) const;
  bool is_known(const std::string& name) const;
  /// @}

 private:
  const std::vector<scene::Texture>& textures_;
  std::size_t unknown_ = 0;
};

/// What the sky is in a direction x, y, z of length 1: a sky_sphere, with what it needs declared; empty where a file is
/// of no kind that POV-Ray knows by its name.
std::string pov_sky(const scene::Environment& environment);

}  // namespace durero::io
