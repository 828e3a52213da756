#pragma once
/// The coordinates (u, v) of a surface's points are the inverse of f_p of the realism seed (1.2), and the tangents its
/// derivatives. An axis d leaves the direction of angle 0 open, which scene::axes_across() fixes; a sphere's axis is
/// +y.
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

/// The coordinates of a point on its surface.
struct TextureCoordinates {
  double u;  ///< across, or around
  double v;  ///< upwards, or along
  bool operator==(const TextureCoordinates&) const = default;
};

/// The tangents ∂f_p/∂u and ∂f_p/∂v: tangent and bitangent. Their cross product is null at a pole, and on a triangle
/// whose vertices have coordinates without an area; it is on the outer side, unless these coordinates go round the
/// other way. Where the vertices have tangents too, these are interpolated linearly and freed of their part along the
/// normal.
struct Tangents {
  glm::dvec3 u;  ///< the derivative by u
  glm::dvec3 v;  ///< the derivative by v
};

/// The coordinates of a point of the element.
TextureCoordinates coordinates(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point);

/// The coordinates of a point that the shape of the element has by itself, whatever coordinates its vertices have.
TextureCoordinates own_coordinates(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point);

/// The point f_p(u, v) of the element.
glm::dvec3 point_at(const scene::Scene& scene, scene::ElementRef element, const TextureCoordinates& at);

/// The tangents at the point f_p(u, v) of the element.
Tangents tangents(const scene::Scene& scene, scene::ElementRef element, const TextureCoordinates& at);

}  // namespace durero::render
