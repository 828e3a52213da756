#pragma once
/// The geometry of one element, as the compact tables hold it. Each field has the letters of the attribute it stores
/// (mi_centro, mi_radio, …); each value satisfies the invariant of model::Escena, which scene::Scene has checked.

#include <glm/vec3.hpp>

namespace durero::scene {

/// |q|² − radio² = 0, with q = w − centro (puntos_esfera).
struct Sphere {
  glm::dvec3 centro;
  double radio;
};

/// |q − s·vector|² − radio² = 0 ∧ 0 ≤ s ≤ altura, with s = q·vector (puntos_cilindro).
struct Cylinder {
  glm::dvec3 centro;
  double radio;
  glm::dvec3 vector;
  double altura;
};

/// |q − s·vector|² − (proporcion·(altura − s))² = 0 ∧ 0 ≤ s ≤ altura (puntos_cono): base at centro, apex at altura.
struct Cone {
  glm::dvec3 centro;
  double proporcion;
  glm::dvec3 vector;
  double altura;
};

}  // namespace durero::scene
