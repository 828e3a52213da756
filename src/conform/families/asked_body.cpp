#include "durero/conform/families/asked_body.hpp"

#include <algorithm>
#include <cmath>

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
