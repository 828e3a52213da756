#pragma once
/// The walk along a ray through a solid: from each root of its faces to the next, with the side of every face.

#include <optional>
#include <span>
#include <vector>

#include "composed/face.hpp"
#include "durero/composed/side_tree.hpp"
#include "durero/surface/exact_element.hpp"

namespace durero::composed {

using surface::exact::Parameter;

/// Which faces a ray starts on, by their numbers.
using Starts = std::vector<std::uint8_t>;

/// A place where a ray meets a face at some t > 0.
struct FaceCrossing {
  Parameter t;
  std::size_t face;
  bool turns;  ///< whether the side of the face changes there; a ray that touches a quadric stays on its side
};

/// The faces along a ray: their sides as it leaves its origin, and where it meets them, ascending.
struct FacesAlong {
  std::vector<std::int8_t> sides;       ///< 0 where the ray lies in the face
  std::vector<FaceCrossing> crossings;  ///< those at one t beside each other
};

/// Exactly. Precondition: there are as many starts as faces.
FacesAlong faces_along(std::span<const SolidFace> faces, const model::Rayo& rayo, const Starts& starts);

/// The first point of the surface, decided in about 50 bits.
struct QuickFirst {
  bool is_met;       ///< whether there is one
  std::size_t face;  ///< the face that it is a crossing of, and no other
  bool is_upper;     ///< whether it is the greater of two roots of that face
};

/// Nothing where the bits do not decide. A ray that runs along the surface from its origin on is not decided.
std::optional<QuickFirst> quick_first(std::span<const SolidFace> faces, const SideTree& tree, const model::Rayo& rayo,
                                      const Starts& starts);

/// The parameter of a crossing, exactly. Precondition: quick_first found it.
Parameter parameter(const SolidFace& face, bool starts_on, bool is_upper, const model::Rayo& rayo);

}  // namespace durero::composed
