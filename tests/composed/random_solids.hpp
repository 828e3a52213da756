#pragma once
// Random trees of solids on a coarse grid, where faces coincide, touch and share edges often, as bodies and as what the
// text says of them; and anywhere, with a reference of its own for the points that lie on no face.
#include <glm/vec3.hpp>
#include <random>
#include <utility>
#include <vector>

#include "durero/model/solidos.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/solids.hpp"

namespace durero::test {

/// A tree as a body, and by the text.
struct RandomSolid {
  scene::Body body;
  model::Solido solido;
};

class SolidDraw {
 public:
  /// Numbers of the grid, or any.
  SolidDraw(std::uint64_t seed, bool on_grid) : random_(seed), on_grid_(on_grid) {}

  int whole(int low, int high) {
    return low + static_cast<int>(random_() % static_cast<std::uint64_t>(high - low + 1));
  }
  double real(double low, double high) { return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1p-53); }
  double coordinate() { return on_grid_ ? whole(-4, 4) * 0.5 : real(-2, 2); }
  double length() { return on_grid_ ? whole(1, 4) * 0.5 : real(0.2, 2); }
  glm::dvec3 point() {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    return {x, y, z};
  }
  glm::dvec3 axis() {
    const double sign = whole(0, 1) == 0 ? -1 : 1;
    switch (whole(0, 4)) {
      case 0:
        return {sign, 0, 0};
      case 1:
        return {0, sign, 0};
      case 2:
        return {0, 0, sign};
      case 3:
        return {0.6 * sign, 0.8, 0};
      default:
        return {0, 0.28, 0.96 * sign};
    }
  }
  model::Rayo ray() {
    const glm::dvec3 p = point();
    glm::dvec3 v(0);
    while (v == glm::dvec3(0)) v = on_grid_ ? glm::dvec3(whole(-2, 2), whole(-2, 2), whole(-2, 2)) : point();
    return {model::Punto(p), model::Vector(v)};
  }

  RandomSolid leaf();
  /// At most so deep.
  RandomSolid tree(int depth);

 private:
  std::mt19937_64 random_;
  bool on_grid_;
};

inline scene::Body body_of(const scene::AnyShape& shape) { return scene::unmoved(shape); }

inline RandomSolid SolidDraw::leaf() {
  using model::Punto, model::Rmas, model::Unitario, model::Vector;
  const glm::dvec3 c = point(), d = axis();
  const double r = length(), h = length(), k = length();
  const Unitario unit{Vector(d)};
  switch (whole(0, 5)) {
    case 0:
      return {body_of(scene::Cylinder{c, r, d, h}), model::solido_cilindro(Punto(c), Rmas(r), unit, Rmas(h))};
    case 1:
      return {body_of(scene::Cone{c, k, d, h}), model::solido_cono(Punto(c), Rmas(k), unit, Rmas(h))};
    case 2:
      return {body_of(scene::TruncatedCone{c, r, k, d, h}),
              model::solido_tronco(Punto(c), Rmas(r), Rmas(k), unit, Rmas(h))};
    case 3:
      return {body_of(scene::Plane{c, d}), model::solido_plano(Punto(c), unit)};
    default:
      return {body_of(scene::Sphere{c, r}), model::solido_esfera(Punto(c), Rmas(r))};
  }
}

inline RandomSolid SolidDraw::tree(int depth) {
  if (depth == 0 || whole(0, 3) == 0) return leaf();
  RandomSolid first = tree(depth - 1), second = tree(depth - 1);
  using enum scene::Compound::Operation;
  const auto operation = std::array{united, intersected, subtracted}[static_cast<std::size_t>(whole(0, 2))];
  model::Solido joined = operation == united        ? first.solido | second.solido
                         : operation == intersected ? first.solido & second.solido
                                                    : first.solido - second.solido;
  return {{scene::Compound{operation, {std::move(first.body), std::move(second.body)}}}, std::move(joined)};
}

}  // namespace durero::test
