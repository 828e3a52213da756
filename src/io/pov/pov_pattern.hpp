#pragma once
/// Textures, environments and the coordinates of surfaces as functions of POV-Ray's language. Its functions are of
/// places, and their values are numbers: a colour is three of them.

#include <array>
#include <optional>
#include <string>
#include <vector>

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
};

/// Of one element.
PovCoordinates pov_coordinates(const scene::Scene& scene, scene::ElementRef element);

/// The expressions that are the red, the green and the blue of something.
using PovChannels = std::array<std::string, 3>;

/// The textures of a scene that can be written, and what they need declared before the first use.
class PovPatterns {
 public:
  explicit PovPatterns(const std::vector<scene::Texture>& textures);

  /// Declarations, a line each.
  const std::string& declarations() const { return declarations_; }
  /// Of the texture of that name at u and v, two expressions; nothing of one whose file is of no kind that POV-Ray
  /// knows by its name.
  std::optional<PovChannels> channels(const std::string& name, const PovCoordinates& at) const;
  /// A normal that this relief turns; empty where its texture cannot be written.
  std::string normal(const scene::Bump& relief, const PovCoordinates& at) const;
  /// Whether that normal is, in the limit, the one that is drawn here.
  bool is_exact(const scene::Bump& relief) const;
  /// How many textures are left out.
  std::size_t unknown() const { return unknown_; }

 private:
  const scene::Texture& named(const std::string& name) const;

  const std::vector<scene::Texture>& textures_;
  std::string declarations_;
  std::size_t unknown_ = 0;
};

/// What the sky is in a direction x, y, z of length 1: a sky_sphere, with what it needs declared; empty where a file is
/// of no kind that POV-Ray knows by its name.
std::string pov_sky(const scene::Environment& environment);

}  // namespace durero::io
