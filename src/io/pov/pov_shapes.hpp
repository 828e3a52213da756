#pragma once
/// The surfaces that a POV-Ray text describes by numbers, and what transformations make of them.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "durero/scene/any_shape.hpp"
#include "durero/scene/vertex_normals.hpp"
#include "io/axis.hpp"
#include "pov_transform.hpp"
#include "pov_words.hpp"

namespace durero::io {

/// A shape describes a surface, whether it has caps where its axis ends, and the normals of its vertices.
struct PovShape {
  scene::AnyShape surface;
  bool is_closed = false;
  std::optional<scene::VertexNormals> normals{};  ///< of a smooth triangle
  /// @{ What the surface is made of when it is placed: two ends, the wide one first, or how far a plane is.
  std::optional<std::array<RoundEnd, 2>> ends{};
  std::optional<double> distance{};
  /// @}
  double hole = 0;  ///< the radius of the hole in a disc
};

/// Reads shapes, and counts what of them is rounded.
class PovShapes {
 public:
  explicit PovShapes(PovWords& in) : in_(in) {}

  /// The words of all shapes.
  static constexpr std::array<std::string_view, 7> words{"sphere", "cylinder", "cone",           "disc",
                                                         "plane",  "triangle", "smooth_triangle"};
  /// Reads the numbers of the shape of that word, from behind its {.
  PovShape read(std::string_view word);
  /// A shape where its transformation puts it; nothing where that is no shape of its type. `at` is its word.
  std::optional<PovShape> placed(std::size_t at, std::string_view word, const PovShape& shape, const PovTransform& by);
  void name_losses(std::vector<std::string>& lost) const;

 private:
  PovShape sphere();
  PovShape cylinder();
  PovShape cone();
  PovShape disc();
  PovShape plane();
  PovShape triangle();
  PovShape smooth_triangle();
  PovShape between(const RoundEnd& one, const RoundEnd& other);
  scene::Plane plane_at(std::size_t at, glm::dvec3 vector, double distance, const PovTransform& by);
  glm::dvec3 turned(std::size_t at, std::string_view word, const glm::dvec3& normal, const PovTransform& by);
  glm::dvec3 vertex(std::string_view what);
  glm::dvec3 direction(std::string_view what);

  PovWords& in_;
  EndRoundings rounded_;
  std::size_t directions_ = 0, planes_ = 0, flat_ = 0, moved_ = 0;
};

}  // namespace durero::io
