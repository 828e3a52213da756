#pragma once
/// The answer to Primera_Interseccion: outcome, elements, and t and point rounded once from their exact values.

#include <glm/vec3.hpp>

#include "durero/model/resultado.hpp"
#include "durero/scene/element_ref.hpp"

namespace durero::scene {

struct Hit {
  model::Resultado resultado = model::Resultado::miss;
  double t = 0;            ///< hit: t!, the exact parameter rounded once (∞ where it rounds to it); otherwise 0
  glm::dvec3 punto{};      ///< hit: punto!, each coordinate rounded once; otherwise 0
  ElementSet elementos{};  ///< elementos!: hit, every element that the point lies on; no_minimum, those that have none

  bool operator==(const Hit&) const = default;
};

}  // namespace durero::scene
