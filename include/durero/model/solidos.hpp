#pragma once
/// spec/solidos.tex: solids that are bounded by quadrics, and the surface that a ray meets of them. Each function is
/// the definition of the same name, carried out in exact arithmetic.

#include <array>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "durero/model/puntos.hpp"

namespace durero::model {

inline constexpr contract::clause Cuadrica_inv_1{
    "Cuadrica.inv.1", "¬ (xx = 0 ∧ yy = 0 ∧ zz = 0 ∧ yz = 0 ∧ zx = 0 ∧ xy = 0 ∧ x = 0 ∧ y = 0 ∧ z = 0 ∧ uno = 0)"};

/// A polynomial of degree two at most in the coordinates (Cuadrica). Throws contract_violation Cuadrica.inv.1 where all
/// its coefficients are zero.
class Cuadrica {
 public:
  /// The number of coefficients.
  static constexpr std::size_t size = 10;
  /// The coefficients xx, yy, zz, yz, zx, xy, x, y, z and uno, in this order.
  using Coefficients = std::array<Rational, size>;

  /// Precondition: some coefficient is not zero; throws otherwise.
  explicit Cuadrica(Coefficients coefficients);
  /// The coefficients, in the order of their names.
  const Coefficients& coefficients() const { return coefficients_; }
  /// By the coefficients, in their order; for sets of quadrics.
  auto operator<=>(const Cuadrica&) const = default;

 private:
  Coefficients coefficients_;
};

/// The value of the polynomial at a point (valor.def.1).
Surd valor(const Cuadrica& c, const ExactPoint& w);

/// The only k with (a, b, k) ∈ multiplo; nothing where there is none (multiplo.def.1).
std::optional<Rational> multiplo(const Cuadrica& a, const Cuadrica& b);

/// Quadrics: what a point is inside of, or is counted inside of.
using Cuadricas = std::set<Cuadrica>;

/// @{ The quadrics among cs that a point is inside of (dentro.def.1), and those that it is outside of (fuera.def.1).
Cuadricas dentro(const Cuadricas& cs, const ExactPoint& w);
Cuadricas fuera(const Cuadricas& cs, const ExactPoint& w);
/// @}

/// The parts of cs in the allotments of repartos(ds, fs), each once (repartos.def.1).
std::vector<Cuadricas> repartos(const Cuadricas& cs, const Cuadricas& ds, const Cuadricas& fs);

/// A solid: a set of allotments, which tells by its quadrics alone what is in it.
struct Solido {
  Cuadricas cuadricas;                             ///< (this, cuadricas) ∈ hecho_de
  std::function<bool(const Cuadricas&)> contains;  ///< l ∈ this
};

/// What is in either solid (solido_union.def.1).
Solido solido_union(const Solido& s, const Solido& t);
/// What is in both (solido_interseccion.def.1).
Solido solido_interseccion(const Solido& s, const Solido& t);
/// What is in the first alone (solido_diferencia.def.1).
Solido solido_diferencia(const Solido& s, const Solido& t);
/// @{ The same, as operators.
inline Solido operator|(const Solido& s, const Solido& t) { return solido_union(s, t); }
inline Solido operator&(const Solido& s, const Solido& t) { return solido_interseccion(s, t); }
inline Solido operator-(const Solido& s, const Solido& t) { return solido_diferencia(s, t); }
/// @}
/// All allotments but those of s: the rest of space.
Solido complemento(const Solido& s);

/// The solid of a sphere (solido_esfera.def.1).
Solido solido_esfera(const Punto& centro, const Rmas& radio);
/// What lies behind a plane (solido_plano.def.1).
Solido solido_plano(const Punto& centro, const Unitario& dir);
/// The space between two planes across an axis (solido_tramo.def.1).
Solido solido_tramo(const Punto& centro, const Unitario& dir, const Rmas& h);
/// The solid of a cylinder, with its lids (solido_cilindro.def.1).
Solido solido_cilindro(const Punto& centro, const Rmas& radio, const Unitario& dir, const Rmas& h);
/// The solid of a cone, with its base (solido_cono.def.1).
Solido solido_cono(const Punto& centro, const Rmas& prop, const Unitario& dir, const Rmas& h);
/// The solid of a truncated cone, with its lids (solido_tronco.def.1).
Solido solido_tronco(const Punto& centro, const Rmas& radio, const Rmas& prop, const Unitario& dir, const Rmas& h);

/// The points that some allotment puts in the solid (cuerpo.def.1).
Puntos cuerpo(const Solido& s);
/// The points that every allotment puts in it (interior.def.1).
Puntos interior(const Solido& s);
/// What the body has and the interior has not (superficie.def.1).
Puntos superficie(const Solido& s);

/// en ∈ con_multiplos, as far as the quadrics of cs (con_multiplos.def.1).
bool con_multiplos(const Cuadricas& cs, const Cuadricas& en);

/// @{ The sides among cs of a point that a ray from p sees, which starts on the quadrics en (dentro_desde.def.1,
/// fuera_desde.def.1).
Cuadricas dentro_desde(const Cuadricas& cs, const Punto& p, const Cuadricas& en, const ExactPoint& w);
Cuadricas fuera_desde(const Cuadricas& cs, const Punto& p, const Cuadricas& en, const ExactPoint& w);
/// @}

/// (s, rayo, en, w) ∈ superficie_desde (superficie_desde.def.1).
bool superficie_desde(const Solido& s, const Rayo& rayo, const Cuadricas& en, const ExactPoint& w);

/// The only q with (rayo, t, q) ∈ en_parametro (en_parametro.def.1). Precondition: t > 0.
ExactPoint en_parametro(const Rayo& rayo, const Surd& t);

/// (s, cs) ∈ hecho_de, asked of every set of the quadrics of s and of cs (hecho_de.def.1).
bool hecho_de(const Solido& s, const Cuadricas& cs);

}  // namespace durero::model
