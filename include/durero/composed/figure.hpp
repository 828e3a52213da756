#pragma once
/// The points of a body as a ray meets them, exactly.

#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "durero/model/tipos.hpp"
#include "durero/scene/body.hpp"
#include "durero/surface/bounds.hpp"
#include "durero/surface/exact_element.hpp"

namespace durero::composed {

using surface::exact::Parameter;

/// The first meeting of a ray with a closed set of points: none, at some t > 0, or at points as near to its origin as
/// one likes.
struct First {
  std::optional<Parameter> t{};  ///< the least parameter, where there is one
  bool no_minimum = false;       ///< the points come down to t → 0⁺; there is no t then
};

/// The points of one body. Any number of threads may ask.
class Figure {
 public:
  virtual ~Figure() = default;

  /// The first meeting of a ray. `on`: the ray starts on the body, whose constant term is then exactly 0 there
  /// (instancia_desde).
  virtual First first(const model::Rayo& rayo, bool on) const = 0;
  /// Whether the ray meets it at some 0 < t < 1.
  bool hides(const model::Rayo& rayo, bool on) const;
  /// The parameters of all points that the ray meets on a stretch, ascending. Nothing where it runs along it there.
  virtual std::optional<std::vector<Parameter>> parameters(const model::Rayo& rayo, bool on,
                                                           surface::exact::RayStretch stretch) const = 0;
  /// Whether the ray may meet it at some t > 0: a quick answer, false only where it meets it nowhere.
  virtual bool may_meet(const model::Rayo& rayo, bool on) const = 0;
  /// A box that holds every point; infinite where no finite one does.
  virtual surface::Box box() const = 0;
  /// The unit normal at a point, as shading uses it: on the outer side, or the null vector where there is none.
  virtual glm::dvec3 normal(const glm::dvec3& point) const = 0;

 protected:
  Figure() = default;
  Figure(const Figure&) = default;
  Figure& operator=(const Figure&) = default;
};

/// The points of a body.
std::unique_ptr<const Figure> figure(const scene::Body& body);

}  // namespace durero::composed
