#pragma once
/// The answer to Primera_Interseccion: outcome, elements, and t and point rounded once from their exact values.

#include <glm/vec3.hpp>

#include "durero/model/resultado.hpp"
#include "durero/scene/element_ref.hpp"

namespace durero::scene {

/// What a ray meets first. It is a value: it refers to the scene by places alone, until its next edit.
struct Hit {
  model::Resultado resultado = model::Resultado::miss;  ///< resultado!
  double t = 0;            ///< hit: t!, the exact parameter rounded once (∞ where it rounds to it); otherwise 0
  glm::dvec3 punto{};      ///< hit: punto!, each coordinate rounded once; otherwise 0
  ElementSet elementos{};  ///< elementos!: hit, every element that the point lies on; no_minimum, those that have none

  bool operator==(const Hit&) const = default;
};

}  // namespace durero::scene
