#pragma once
/// Polygons become triangles of a scene.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "durero/scene/scene.hpp"
#include "triangulation.hpp"

namespace durero::io {

/// The looks of a polygon's corners, in their order; either may be empty.
struct CornerLooks {
  std::vector<glm::dvec2> uv{};
  std::vector<glm::dvec3> normals{};
};

/// Adds polygons to a scene as triangles that are named PREFIX1, PREFIX2, …: the number of a triangle is its place in
/// the file, those that are left out included. What no triangle can stand for is left out, and counted.
class Polygons {
 public:
  Polygons(scene::Scene& scene, std::string prefix) : scene_(scene), prefix_(std::move(prefix)) {}

  /// Precondition: three vertices or more, finite; the material is one of the stage's; as many uv, or none, and as many
  /// normals, or none. A triangle with a normal that is null or not finite is flat, and is counted.
  void add(std::span<const glm::dvec3> polygon, std::optional<std::uint32_t> material = {},
           const CornerLooks& looks = {});
  /// How many triangles have been added or left out: the number of the last one.
  std::size_t number() const noexcept { return number_; }
  /// The name that a triangle has, were it left out.
  std::string name(std::size_t number) const;
  /// Appends a line for each kind of thing that was left out.
  void name_losses(std::vector<std::string>& lost) const;

 private:
  void look(scene::ElementRef element, const CornerLooks& looks, const CornerNumbers& corners);

  scene::Scene& scene_;
  std::string prefix_;
  std::size_t number_ = 0, aligned_ = 0, uncut_ = 0, flat_ = 0;
};

}  // namespace durero::io
