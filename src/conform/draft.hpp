#pragma once
/// A case of one ray whose numbers can be changed at will: what minimise.cpp tries its changes on.

#include <optional>
#include <string>
#include <vector>

#include "durero/conform/suite.hpp"
#include "durero/scene/any_shape.hpp"

namespace durero::conform {

struct Draft {
  struct Element {
    std::string name;
    scene::AnyShape shape;
  };
  std::vector<Element> elements;
  glm::dvec3 p{}, v{};
  std::vector<std::string> on;  ///< the names of what the ray starts on
  bool are_closed = false;      ///< discs close the elements that have ends

  /// Of the only ray of the case. Discs that close solids are left out; they follow their walls.
  explicit Draft(const SuiteCase& of);

  /// Its case, answered, with the family and the number of the given one; nothing where the model refuses an element or
  /// the ray.
  std::optional<SuiteCase> built(const SuiteCase& like) const;
};

/// What of a shape a change may touch. An attribute is one of these.
struct Places {
  std::vector<glm::dvec3*> points;  ///< its centre, or its vertices
  std::vector<glm::dvec3*> axes;    ///< its unit vector
  std::vector<double*> lengths;
  std::vector<double*> ratios;
};
Places places(scene::AnyShape& shape);

/// The scene and the origin times 2^k, and v with them: the same crossings at the same t.
void scale(Draft& draft, int k);
/// Of its first element, in the first place, a length; where it has none, the largest coordinate of its points.
double size_of(const Draft& draft);

}  // namespace durero::conform
