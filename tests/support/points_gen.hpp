#pragma once
/// RapidCheck generators of exact points, rays, and scenes of few elements that touch and cross.

#include "durero/model/operaciones.hpp"
#include "durero/model/puntos.hpp"
#include "support/model_gen.hpp"

namespace durero::test {

inline rc::Gen<model::Rmas> any_rmas() {
  return rc::gen::map(any_length(), [](double r) { return model::Rmas(r); });
}

inline rc::Gen<model::Random> any_random() {
  return rc::gen::map(rc::gen::arbitrary<std::uint64_t>(), [](std::uint64_t seed) { return model::Random(seed); });
}

/// A ray from a point of the grid, often along an axis or a diagonal.
inline rc::Gen<model::Rayo> any_ray() {
  const auto component = rc::gen::map(rc::gen::inRange(-4, 5), [](int i) { return double(i); });
  const auto grid = rc::gen::apply([](double x, double y, double z) { return model::Vector(x, y, z); }, component,
                                   component, component);
  const auto direction = rc::gen::suchThat(rc::gen::oneOf(grid, any_vector()),
                                           [](const model::Vector& v) { return v != model::Vector(0, 0, 0); });
  return rc::gen::apply([](model::Punto p, model::Vector v) { return model::Rayo(p, v); }, any_point(), direction);
}

/// The scene after some operations, most of which can be done.
inline model::Escena any_scene() {
  model::Escena escena = model::Init();
  for (const model::Operation& operation : *any_operations()) model::apply_total(escena, operation);
  return escena;
}

}  // namespace durero::test

namespace durero::number {

inline std::ostream& operator<<(std::ostream& out, const Surd& s) {
  return out << s.x << " + " << s.y << "*sqrt(" << s.delta << ')';
}

}  // namespace durero::number

namespace durero::model {

inline std::ostream& operator<<(std::ostream& out, const Rmas& r) { return out << r.value(); }
inline std::ostream& operator<<(std::ostream& out, const ExactPoint& p) {
  return out << '(' << p.x << ", " << p.y << ", " << p.z << ')';
}
inline std::ostream& operator<<(std::ostream& out, const Rayo& ray) { return out << ray.p() << " + t" << ray.v(); }
inline std::ostream& operator<<(std::ostream& out, const Random&) { return out << "random numbers"; }

}  // namespace durero::model
