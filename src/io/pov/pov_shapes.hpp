#pragma once
/// The surfaces that a POV-Ray text describes by literal numbers.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "durero/scene/any_shape.hpp"
#include "durero/scene/vertex_normals.hpp"
#include "io/axis.hpp"
#include "pov_words.hpp"

namespace durero::io {

/// A shape describes a surface, whether it has caps where its axis ends, and the normals of its vertices.
struct PovShape {
  scene::AnyShape surface;
  bool is_closed = false;
  std::optional<scene::VertexNormals> normals{};  ///< of a smooth triangle
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
  void name_losses(std::vector<std::string>& lost) const;

 private:
  /// An end of a cylinder or a cone.
  struct End {
    glm::dvec3 at;
    double radius;
  };

  PovShape sphere();
  PovShape cylinder();
  PovShape cone();
  PovShape disc();
  PovShape plane();
  PovShape triangle();
  PovShape smooth_triangle();
  PovShape along_axis(std::string_view word, std::size_t at, const End& wide, const End& narrow);
  scene::AnyShape narrowing(const Axis& axis, const End& wide, const End& narrow);
  glm::dvec3 vertex(std::string_view what);
  glm::dvec3 direction(std::string_view what);

  PovWords& in_;
  std::size_t axes_ = 0, proportions_ = 0, directions_ = 0, planes_ = 0, flat_ = 0;
};

}  // namespace durero::io
