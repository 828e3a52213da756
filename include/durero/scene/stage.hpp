#pragma once
/// What a picture needs beside the elements: camera, resolution, background, lights and materials. None of it takes
/// part in the meaning of an intersection.

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace durero::scene {

/// A pinhole camera (Algorithm II.1's eye and window). Lengths in scene units; fov_y the full vertical angle, degrees.
struct Camera {
  glm::dvec3 eye;      ///< where the rays start
  glm::dvec3 look_at;  ///< what the middle of the picture shows
  glm::dvec3 up;       ///< what points upwards in the picture, of any length
  double fov_y;        ///< degrees, above 0 and below 180
  bool operator==(const Camera&) const = default;
};

/// A point light. Colours are linear RGB, with the primaries of sRGB; 1 is the brightest that a picture shows.
struct Light {
  glm::dvec3 position;  ///< where it stands
  glm::dvec3 color;     ///< how bright it is, the same at every distance
  bool operator==(const Light&) const = default;
};

/// The look of an element under Lambert's law: the share of each colour that it sends back, in [0, 1].
struct Material {
  std::string name;  ///< in files
  glm::dvec3 color;  ///< red, green and blue
  bool operator==(const Material&) const = default;
};

/// The size of a picture, in pixels.
struct Resolution {
  std::uint32_t width;   ///< of a row
  std::uint32_t height;  ///< how many rows
  bool operator==(const Resolution&) const = default;
};

/// Every part is optional in a scene file; what is absent stays absent when the file is written again.
struct Stage {
  std::optional<Camera> camera;          ///< where the picture is seen from
  std::optional<Resolution> resolution;  ///< of the picture
  std::optional<glm::dvec3> background;  ///< the linear colour of rays that meet nothing
  std::vector<Light> lights;             ///< in the order of the file
  std::vector<Material> materials;       ///< ascending by name
  bool operator==(const Stage&) const = default;
};

}  // namespace durero::scene
