#pragma once
/// The coordinates (u, v) of the points of every surface, f_p of the realism seed (1.2) and its inverse, and the
/// tangents. What an axis d leaves open, where an angle is 0, scene::axes_across() says; a sphere's axis is +y.
///
///   esfera           u the longitude over 2π, v the latitude from −π/2 to π/2 as 0 to 1; poles at v = 0 and 1
///   cilindro, tronco u the angle over 2π, v = s/altura
///   cono             likewise; its apex, v = 1, is a pole
///   plano            u and v in units of length along the two axes, from centro
///   disco            (½, ½) in the centre, the rim at the distance ½ from it
///   triangulo        a + u·(b − a) + v·(c − a); where its vertices have coordinates (scene::Wrap), what is linear
///                    between those
///
/// Round surfaces have a seam at angle 0, where u, in [0, 1), steps from 1 to 0. At a pole u is 0.

#include <glm/vec3.hpp>

#include "durero/scene/scene.hpp"

namespace durero::render {

/// Where on its surface a point lies.
struct Coordinates {
  double u;  ///< across, or around
  double v;  ///< upwards, or along
  bool operator==(const Coordinates&) const = default;
};

/// ∂f_p/∂u and ∂f_p/∂v: tangent and bitangent. Their cross product is null at a pole, and on a triangle whose vertices
/// have coordinates without an area; it is on the outer side, but where those go round the other way. Where the
/// vertices have tangents too, these are what is linear between them, freed of its part along the normal.
struct Tangents {
  glm::dvec3 u;  ///< where u grows
  glm::dvec3 v;  ///< where v grows
};

/// Of a point of the element.
Coordinates coordinates(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point);

/// f_p: the point of the element that has them.
glm::dvec3 point_at(const scene::Scene& scene, scene::ElementRef element, const Coordinates& at);

/// At the point of the element that has them.
Tangents tangents(const scene::Scene& scene, scene::ElementRef element, const Coordinates& at);

}  // namespace durero::render
