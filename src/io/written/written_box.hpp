#pragma once
/// Boxes among the solids of a scene.

#include <glm/vec3.hpp>
#include <optional>

#include "durero/scene/body.hpp"

namespace durero::io {

/// A box along the axes, by its least and its greatest corner, and where it is put.
struct WrittenBox {
  glm::dvec3 low, high;
  const model::Mapa& by;  ///< of the body that it was found in
};

/// The box that a body is, made as scene::box_between makes it and perhaps copied by a map; nothing where it is another
/// body.
std::optional<WrittenBox> written_box(const scene::Body& body);

}  // namespace durero::io
