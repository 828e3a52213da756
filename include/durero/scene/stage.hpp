#pragma once
/// What a picture needs beside the elements: camera, resolution, surroundings, lights and materials. None of it takes
/// part in the meaning of an intersection.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "durero/scene/environment.hpp"
#include "durero/scene/texture.hpp"

namespace durero::scene {

/// A camera (Algorithm II.1's eye and window): a pinhole, or a thin lens about the eye. Lengths in scene units; fov_y
/// the full vertical angle, degrees.
struct Camera {
  glm::dvec3 eye;         ///< where the rays start
  glm::dvec3 look_at;     ///< what the middle of the picture shows
  glm::dvec3 up;          ///< what points upwards in the picture, of any length
  double fov_y;           ///< degrees, above 0 and below 180
  double aperture = 0;    ///< the diameter of the lens, from 0: a pinhole
  double focus = 0;       ///< the distance of the plane in focus, along the view; 0 stands for that of look_at
  double shutter = 0;     ///< the time that it is open, from 0: the picture is the mean over the times from 0 to there
  glm::dvec3 motion{};    ///< the way of eye and look_at in a unit of time
  bool mirrored = false;  ///< its picture is turned left to right, as cameras of left-handed systems show a scene
  bool operator==(const Camera&) const = default;
};

/// The shapes of lights.
enum class LightShape {
  point,      ///< a point
  disc,       ///< a disc about the position
  sphere,     ///< the surface of a sphere about the position
  triangle,   ///< a triangle with a corner at the position
  rectangle,  ///< a parallelogram about the position
};

/// The extent of a light about its position.
struct LightExtent {
  LightShape shape = LightShape::point;  ///< which of the members below count
  double radius = 0;                     ///< of a disc or a sphere, above 0
  glm::dvec3 normal{};                   ///< of a disc, of any length but 0
  std::array<glm::dvec3, 2> edges{};     ///< of a triangle or a rectangle; they are not parallel

  /// Whether the light has no extent.
  bool is_point() const noexcept { return shape == LightShape::point; }
  bool operator==(const LightExtent&) const = default;
};

/// A cone that a light shines into, about the way from its position to a place (Cono_de_Luz of spec/luz.tex). Angles
/// are from the axis, in degrees.
struct LightCone {
  glm::dvec3 towards;    ///< the place, which is not the light's position
  double inner = 30;     ///< the light is full up to this angle, from 0 to outer
  double outer = 45;     ///< there is none beyond this angle, above 0 and up to 90
  double tightness = 0;  ///< the power of the cosine of the angle that narrows the light, from 0
  bool operator==(const LightCone&) const = default;
};

/// A light at a place. Colours are linear RGB, with the primaries of sRGB; 1 is the brightest that a picture shows.
struct Light {
  glm::dvec3 position;   ///< where it stands
  glm::dvec3 color;      ///< how bright it is, the same at every distance; of a shape, as each of its points alone is
  LightExtent extent{};  ///< its shape
  std::optional<LightCone> cone{};  ///< the cone that each of its points shines into; without one, all around
  bool operator==(const Light&) const = default;
};

/// A light so far away that it comes from one direction everywhere. Colours as of a point light.
struct DirectionalLight {
  glm::dvec3 direction;  ///< in which it shines, of any length but 0
  glm::dvec3 color;      ///< how bright it is
  bool operator==(const DirectionalLight&) const = default;
};

/// The look of an element: what it sends towards the eye of each light that it sees, of what a mirror would show, of
/// what lies behind it, and of its own. Shares lie in [0, 1]; the names are those of the source text's formulas. What a
/// file leaves out is as here: Lambert's law alone.
struct Material {
  std::string name{};  ///< in files
  glm::dvec3 color{};  ///< C: the shares of red, green and blue that it sends back
  double k_a = 0;      ///< of each light that reaches it, whatever the angle
  double k_d = 1;      ///< of each light, by Lambert's law
  double k_s = 0;      ///< of each light, as a highlight of the light's own colour
  double e = 1;        ///< how narrow the highlight is, from 0
  double k_ps = 0;     ///< of what a mirror would show
  glm::dvec3 M_PS{1};  ///< the colour of the mirror
  double gloss =
      std::numeric_limits<double>::infinity();  ///< exponent of the lobe about the mirrored direction, from 0
  double k_t = 0;                               ///< of what lies behind
  glm::dvec3 M_T{1};                            ///< the colour of what shines through
  double index = 1;                             ///< of refraction, above 0
  glm::dvec3 emission{};                        ///< M_E: what it shines of itself, each from 0
  glm::dvec3 ambient{};        ///< A_G: what reaches it from nowhere in particular and is sent on, each from 0
  TextureUses textures{};      ///< what multiplies the above from point to point
  std::optional<Bump> bump{};  ///< its relief
  bool operator==(const Material&) const = default;

  /// Whether the picture follows rays beyond it.
  bool sends_rays_on() const noexcept { return k_ps > 0 || k_t > 0; }
};

/// The size of a picture, in pixels.
struct Resolution {
  std::uint32_t width;   ///< of a row
  std::uint32_t height;  ///< how many rows
  bool operator==(const Resolution&) const = default;
};

/// The most rays in a row that a picture may follow.
inline constexpr std::uint32_t greatest_depth = 1000;

/// Every part is optional in a scene file; what is absent stays absent when the file is written again.
struct Stage {
  std::optional<Camera> camera;                        ///< where the picture is seen from
  std::optional<Resolution> resolution;                ///< of the picture
  std::optional<glm::dvec3> background;                ///< the linear colour of rays that meet nothing
  std::vector<Light> lights;                           ///< in the order of the file
  std::vector<DirectionalLight> directional_lights{};  ///< in the order of the file
  std::vector<Material> materials;                     ///< ascending by name
  std::optional<std::uint32_t> max_depth;    ///< of the rays that a pixel follows, the first one being of depth 1
  std::vector<Texture> textures{};           ///< ascending by name
  std::optional<Environment> environment{};  ///< what rays that meet nothing bring, in place of a background
  bool operator==(const Stage&) const = default;
};

}  // namespace durero::scene
