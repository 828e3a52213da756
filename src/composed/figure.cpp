#include "durero/composed/figure.hpp"

#include <glm/geometric.hpp>

#include "durero/composed/moved_shape.hpp"
#include "durero/composed/solid.hpp"

namespace durero::composed {
namespace {

/// The points of an instance.
class Copy final : public Figure {
 public:
  explicit Copy(const scene::Instance& instance) : shape_(instance) {}

  First first(const model::Rayo& rayo, bool on) const override {
    const surface::exact::Reach reach = shape_.reach(rayo, on);
    if (reach.empty()) return {};
    if (reach.no_minimum()) return {.no_minimum = true};
    return {.t = reach.first()};
  }

  std::optional<std::vector<Parameter>> parameters(const model::Rayo& rayo, bool on,
                                                   surface::exact::RayStretch stretch) const override {
    return surface::exact::parameters_on(shape_.reach(rayo, on), stretch);
  }

  bool may_meet(const model::Rayo& rayo, bool on) const override { return shape_.may_meet(rayo, on); }

  surface::Box box() const override { return shape_.box(); }

  glm::dvec3 normal(const glm::dvec3& point) const override {
    const glm::dvec3 gradient = shape_.gradient(point);
    const double length = glm::length(gradient);
    return length > 0 ? gradient / length : glm::dvec3(0);
  }

 private:
  MovedShape shape_;
};

std::unique_ptr<const Figure> made(const scene::Instance& instance) { return std::make_unique<const Copy>(instance); }

std::unique_ptr<const Figure> made(const scene::Compound& solid) { return std::make_unique<const SolidFigure>(solid); }

}  // namespace

bool Figure::hides(const model::Rayo& rayo, bool on) const {
  const First met = first(rayo, on);
  return met.no_minimum || (met.t && lies_on(surface::exact::RayStretch::segment, *met.t));
}

std::unique_ptr<const Figure> figure(const scene::Body& body) {
  return std::visit([](const auto& form) { return made(form); }, body.form);
}

}  // namespace durero::composed
