#pragma once
/// spec/puntos.tex: every object is a set of points. Each function is the definition of the same name, carried out in
/// exact arithmetic; the label of the definition stands beside it. The points of each type stand in model/tipo/.

#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "durero/model/exact_point.hpp"
#include "durero/model/operation.hpp"
#include "durero/model/tipos.hpp"

namespace durero::model {

/// r * r (cuadrado.def.1)
Surd cuadrado(const Surd& r);

/// The non-negative root of a rational number (raizcuadrada.def.1). Throws std::domain_error where r < 0.
Surd raizcuadrada(const Rational& r);

/// How far w has advanced along dir from centro (avance.def.1).
Surd avance(const ExactPoint& w, const Punto& centro, const Vector& dir);

/// The squared distance of w from the foot at its advance (alejamiento.def.1).
Surd alejamiento(const ExactPoint& w, const Punto& centro, const Vector& dir);

/// The scalar product of two vectors, which Z cannot tell from points (producto.def.1, E28).
Surd producto(const ExactPoint& u, const ExactPoint& v);

/// What random points are drawn from.
using Random = std::mt19937_64;

/// A set of points (ℙ Punto): a value that knows exactly which points are its members, and that can draw some.
class Puntos {
 public:
  /// Whether a point is a member.
  using Membership = std::function<bool(const ExactPoint&)>;
  /// A member, at random; nothing where it finds none.
  using Sampling = std::function<std::optional<ExactPoint>(Random&)>;

  /// The set of the points for which `membership` holds. A set without `sampling` draws nothing.
  explicit Puntos(Membership membership, Sampling sampling = {})
      : membership_(std::move(membership)), sampling_(std::move(sampling)) {}

  /// w ∈ this set.
  bool contains(const ExactPoint& w) const { return membership_(w); }

  /// A member, at random; nothing where the set is empty or does not say how to draw.
  std::optional<ExactPoint> sample(Random& random) const { return sampling_ ? sampling_(random) : std::nullopt; }

 private:
  Membership membership_;
  Sampling sampling_;
};

/// ⋃ sets: the points of any of them; draws from one of them at random.
Puntos big_union(std::vector<Puntos> sets);

/// The points of a ray, at every positive parameter (puntos_de_rayo.def.1).
Puntos puntos_de_rayo(const Rayo& ray);

/// The parameter t with w = p + t·v, where there is one.
std::optional<Surd> parameter(const Rayo& ray, const ExactPoint& w);

/// The points of one element of a scene (puntos_de_elemento.def.1). Precondition: e ∈ elementos; throws
/// std::out_of_range otherwise. The set keeps no reference to the scene.
Puntos puntos_de_elemento(const Escena& escena, const Elemento& e);

/// The points of all the elements of a scene (puntos_de_escena.def.1).
Puntos puntos_de_escena(const Escena& escena);

}  // namespace durero::model
