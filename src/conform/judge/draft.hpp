#pragma once
/// A draft is a case of one ray whose numbers can be changed at will; minimise.cpp tries its changes on it.

#include <optional>
#include <string>
#include <vector>

#include "durero/conform/families/suite.hpp"
#include "durero/scene/any_shape.hpp"

namespace durero::conform {

/// Any shape, or a body.
template <class Shapes>
struct AskedShapeOf;
template <class... Shape>
struct AskedShapeOf<std::variant<Shape...>> {
  using type = std::variant<Shape..., AskedBody>;
};
using AskedShape = AskedShapeOf<scene::AnyShape>::type;

/// The word of its type or kind.
std::string_view word_of(const AskedShape& shape);

struct Draft {
  struct Element {
    std::string name;
    AskedShape shape;
  };
  std::vector<Element> elements;
  glm::dvec3 p{}, v{};
  QuestionKind question = QuestionKind::first;
  std::optional<AskedRange> range{};  ///< of the ray, where has_numbers(question)
  std::vector<std::string> on;        ///< the names of the elements that the ray starts on
  bool are_closed = false;            ///< discs close the elements that have ends
  bool is_grid = false;               ///< the elements are those of a grid, and may not be changed

  /// A draft of a case with one ray. Discs that close solids are left out; they follow from their walls.
  explicit Draft(const SuiteCase& of);

  /// The answered case that the draft describes, with the family and the number of `like`; nothing where the model
  /// refuses an element or the ray.
  std::optional<SuiteCase> built(const SuiteCase& like) const;

 private:
  bool are_of(const scene::Scene& scene) const;  ///< whether the elements are the triangles of that scene
};

/// The numbers of a shape or a body that a change may touch. Each is of one of these kinds.
struct Places {
  std::vector<glm::dvec3*> points;  ///< the centre, or the vertices
  std::vector<glm::dvec3*> axes;    ///< the unit vector
  std::vector<glm::dvec3*> sides;   ///< those of a body
  std::vector<double*> lengths;
  std::vector<double*> ratios;
};
Places places(AskedShape& shape);

/// The ends of the draft's range.
std::vector<double*> ends(Draft& draft);
/// The numbers behind the draft's ray: the ends of its range, or the radius of its ball.
std::vector<double*> numbers_behind(Draft& draft);
/// Scales the range of the draft, if it has one.
void scale_range(Draft& draft, double factor);
/// Scales v, and the range so that it stays where it is.
void scale_direction(Draft& draft, double factor);
/// Moves the origin by so many v, and the range so that it stays where it is, as far as it is ahead. A shadow ray's
/// begins at the origin all the same.
void move_along(Draft& draft, double t);
/// Scales the scene, the origin and v by 2^k: the crossings stay at the same t.
void scale(Draft& draft, int k);
/// Scales the scene and the origin by 2^k, and v not: the crossings' t is scaled as well.
void scale_with_t(Draft& draft, int k);
/// Moves the elements and the origin.
void translate(Draft& draft, const glm::dvec3& by);
/// The size of the draft: the first length of its first element; without one, the largest coordinate of the element's
/// sides or points, or 1 where that is 0. Precondition: there is an element.
double size_of(const Draft& draft);

}  // namespace durero::conform
