#include "durero/conform/families/asked_body.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "durero/contract/contract.hpp"
#include "durero/scene/addition.hpp"
#include "durero/scene/solids.hpp"

namespace durero::conform {
namespace {

using model::Vector;

model::Mapa map_of(const AskedBody& body) {
  const auto& [x, y, z] = body.sides;
  return {Vector(body.centro), Vector(x), Vector(y), Vector(z)};
}

/// The cube of the points whose coordinates are 1 at most.
scene::Body unit_cube() { return {scene::box_between(glm::dvec3(-1), glm::dvec3(1)).value()}; }

scene::Body exact_capsule(const AskedBody& body) {
  const auto& [x, y, z] = body.sides;
  const scene::Body wall = scene::unmoved(scene::Cylinder{{0, -1, 0}, 1, {0, 1, 0}, 2});
  const double radio = length_of(x);
  return {scene::Compound{scene::Compound::Operation::united,
                          {scene::copied(map_of(body), wall), scene::unmoved(scene::Sphere{body.centro - y, radio}),
                           scene::unmoved(scene::Sphere{body.centro + y, radio})}}};
}

glm::dvec3 direction_of(const glm::dvec3& v) { return v / length_of(v); }

/// The cylinder of that radius around the stretch from centro − y to centro + y; x and z are of length 1 across it.
scene::Body exact_wall(const glm::dvec3& centro, const glm::dvec3& y, const glm::dvec3& x, const glm::dvec3& z,
                       double radio) {
  const scene::Body wall = scene::unmoved(scene::Cylinder{{0, -1, 0}, 1, {0, 1, 0}, 2});
  return scene::copied({Vector(centro), Vector(radio * x), Vector(y), Vector(radio * z)}, wall);
}

/// A box that is longer by the radius along each side in turn, cylinders around the edges and balls around the corners.
scene::Body exact_rounded_box(const AskedBody& body) {
  scene::Compound all{scene::Compound::Operation::united, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    AskedBody longer = body;
    longer.sides[i] = (length_of(body.sides[i]) + body.radio) * direction_of(body.sides[i]);
    all.parts.push_back(scene::copied(map_of(longer), unit_cube()));
    const glm::dvec3 across = direction_of(body.sides[j]), centro = body.centro;
    const glm::dvec3 other = direction_of(glm::cross(direction_of(body.sides[i]), across));
    for (const glm::dvec3& side : {centro - body.sides[j], centro + body.sides[j]}) {
      for (const glm::dvec3& edge : {side - body.sides[k], side + body.sides[k]})
        all.parts.push_back(exact_wall(edge, body.sides[i], across, other, body.radio));
    }
  }
  const auto& [x, y, z] = body.sides;
  for (const glm::dvec3& end : {body.centro - x, body.centro + x}) {
    for (const glm::dvec3& edge : {end - y, end + y}) {
      for (const glm::dvec3& corner : {edge - z, edge + z})
        all.parts.push_back(scene::unmoved(scene::Sphere{corner, body.radio}));
    }
  }
  return {all};
}

/// A box that a torus lies in: its sides go to twice the radius of the ring, which is larger than the tube's.
scene::Body box_around(AskedBody torus) {
  const glm::dvec3 across = direction_of(glm::cross(direction_of(torus.sides[2]), direction_of(torus.sides[0])));
  torus.sides = {2.0 * torus.sides[0], 2 * length_of(torus.sides[0]) * across, 2.0 * torus.sides[2]};
  return scene::copied(map_of(torus), unit_cube());
}

}  // namespace

double length_of(const glm::dvec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (largest == 0 || !std::isfinite(largest)) return largest;
  const int k = std::ilogb(largest);
  const long double x = std::ldexp(v.x, -k), y = std::ldexp(v.y, -k), z = std::ldexp(v.z, -k);
  return std::ldexp(static_cast<double>(std::sqrt(x * x + y * y + z * z)), k);
}

bool is_body(const AskedBody& body) {
  const auto is_finite = [](const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  };
  if (!is_finite(body.centro) || !std::ranges::all_of(body.sides, is_finite)) return false;
  if (has_radius(body.kind) && !(body.radio > 0 && std::isfinite(body.radio))) return false;
  if (body.kind == BodyKind::toro && !(body.radio < length_of(body.sides[0]))) return false;
  const model::Mapa mapa = map_of(body);
  return number::sign(model::mixto(mapa.x, mapa.y, mapa.z)) != 0;
}

scene::Body exact_body(const AskedBody& body) {
  switch (body.kind) {
    case BodyKind::caja:
    case BodyKind::copia_caja:
      return scene::copied(map_of(body), unit_cube());
    case BodyKind::elipsoide:
    case BodyKind::copia_esfera:
      return {scene::Instance{scene::Sphere{{}, 1}, map_of(body)}};
    case BodyKind::capsula:
      return exact_capsule(body);
    case BodyKind::caja_redonda:
      return exact_rounded_box(body);
    case BodyKind::toro:
      return box_around(body);
    case BodyKind::campo:
      break;
  }
  contract::unreachable();
}

const AskedBody* find_body(std::span<const NamedBody> bodies, scene::ElementRef element) {
  const auto found = std::ranges::find(bodies, element, &NamedBody::element);
  return found == bodies.end() ? nullptr : &found->body;
}

bool add_body(scene::Scene& scene, const model::Elemento& name, const AskedBody& body) {
  if (!is_body(body) || !scene.add(name, scene::stand_in).ok()) return false;
  scene.set_body(scene.find(name.name()).value(), exact_body(body));
  return true;
}

}  // namespace durero::conform
