#pragma once
/// A scene by its shapes: elements named e0, e1, … in the order of their addition.

#include <glm/geometric.hpp>
#include <stdexcept>
#include <string>

#include "durero/model/operation.hpp"
#include "durero/scene/scene.hpp"

namespace durero::test {

inline model::Elemento next_name(const scene::Scene& scene) {
  return model::Elemento("e" + std::to_string(scene.size()));
}

inline scene::ElementRef added(scene::Scene& scene, const model::Operation& operation) {
  const std::string name = next_name(scene).name();
  scene.apply(operation);
  return *scene.find(name);
}

/// Throws std::invalid_argument, with the broken clause's label, where the addition is refused.
template <class Shape>
scene::ElementRef add(scene::Scene& scene, const model::Elemento& name, const Shape& shape) {
  const model::Answer answer = scene.add(name, shape);
  if (!answer.ok()) throw std::invalid_argument(std::string(answer.violated->label));
  return *scene.find(name.name());
}

template <class Shape>
scene::ElementRef add(scene::Scene& scene, const Shape& shape) {
  return add(scene, next_name(scene), shape);
}

inline model::Rayo ray(const glm::dvec3& p, const glm::dvec3& v) { return {model::Punto(p), model::Vector(v)}; }

}  // namespace durero::test
