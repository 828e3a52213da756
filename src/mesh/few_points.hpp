#pragma once
/// The corners of a face, or those of them that another face has too.

#include <boost/container/static_vector.hpp>
#include <glm/vec3.hpp>

namespace durero::mesh {

/// Up to three points.
using FewPoints = boost::container::static_vector<glm::dvec3, 3>;

/// The corners of two faces, each once: those that both have, and those that one alone has.
struct SharedCorners {
  FewPoints both, first, second;
};

}  // namespace durero::mesh
