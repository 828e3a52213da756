#pragma once
/// The camera of a POV-Ray text.

#include <glm/vec3.hpp>
#include <optional>

#include "durero/scene/stage.hpp"
#include "pov_transform.hpp"
#include "pov_words.hpp"

namespace durero::io {

/// A camera as the language has it.
struct PovCamera {
  glm::dvec3 location{0}, direction{0, 0, 1}, right{4.0 / 3, 0, 0}, up{0, 1, 0}, sky{0, 1, 0};
  std::optional<double> angle{};
  std::optional<glm::dvec3> look_at{}, focal_point{};
  double aperture = 0;
  PovTransform moved{};
  bool is_other = false;  ///< it sees by other rays than a scene's
};

/// A camera of a scene, the size of its picture, and whether its pixels have the rays of the one that was read.
struct ReadCamera {
  scene::Camera camera;
  std::optional<scene::Resolution>
      size;  ///< the one that is told, or whose pixels are next to squares; or the default one
  bool is_exact;
};

/// Reads the camera that stands here, whose words may stand in any order: POV-Ray carries them out in one of its own
/// since version 3.5. In a text of an older version a place behind look_at is another's, and is refused. Without a size
/// the picture is so high that pixels are next to squares, and as wide as the default one. Nothing where a scene has no
/// such camera. Throws InputError.
std::optional<ReadCamera> read_pov_camera(PovWords& in, std::optional<double> version,
                                          std::optional<scene::Resolution> size);

}  // namespace durero::io
