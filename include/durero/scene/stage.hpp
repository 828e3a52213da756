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
  glm::dvec3 eye;
  glm::dvec3 look_at;
  glm::dvec3 up;
  double fov_y;
  bool operator==(const Camera&) const = default;
};

/// A point light. Colours are linear RGB, with the primaries of sRGB; 1 is the brightest that a picture shows.
struct Light {
  glm::dvec3 position;
  glm::dvec3 color;
  bool operator==(const Light&) const = default;
};

/// The look of an element under Lambert's law: the share of each colour that it sends back, in [0, 1].
struct Material {
  std::string name;
  glm::dvec3 color;
  bool operator==(const Material&) const = default;
};

struct Resolution {
  std::uint32_t width;
  std::uint32_t height;
  bool operator==(const Resolution&) const = default;
};

/// Every part is optional in a scene file; what is absent stays absent when the file is written again.
struct Stage {
  std::optional<Camera> camera;
  std::optional<Resolution> resolution;
  std::optional<glm::dvec3> background;
  std::vector<Light> lights;
  std::vector<Material> materials;  ///< ascending by name
  bool operator==(const Stage&) const = default;
};

}  // namespace durero::scene
