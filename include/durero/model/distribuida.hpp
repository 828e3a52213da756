#pragma once
/// spec/distribuida.tex: the mean that a picture is, a thin lens, a moving point, and the estimate along some of the
/// ways of light. Each function is the definition of the same name, carried out in exact arithmetic.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "durero/model/luz.hpp"

namespace durero::model {

inline constexpr contract::clause Sorteo_inv_1{"Sorteo.inv.1", "n ≥ 1"};
inline constexpr contract::clause Sorteo_inv_2{"Sorteo.inv.2", "∀ i : ℤ | 0 ≤ i < n ⦁ p(i) ≥ 0"};
inline constexpr contract::clause Sorteo_inv_3{"Sorteo.inv.3", "∃ suma : ℤ → ℝ ⦁ (p, suma) ∈ acumulado ∧ suma(n) = 1"};
inline constexpr contract::clause Lente_inv_1{"Lente.inv.1", "producto(eje, eje) = 1"};
inline constexpr contract::clause Lente_inv_2{"Lente.inv.2", "abertura ∈ Cantidad"};
inline constexpr contract::clause Lente_inv_3{"Lente.inv.3", "foco ∈ Rmas"};

/// A draw among outcomes that are numbered from 0. A plain value: inv() evaluates its invariants.
struct Sorteo {
  std::vector<Rational> p;  ///< the chance of each of the n outcomes
};

/// Sorteo.inv.1 to Sorteo.inv.3.
Judgements inv(const Sorteo& s);

// Preconditions of all that follows: inv() of each argument holds, a sequence has a number for each outcome, and the
// components lie in one field.

/// The only m of (s, x, m) ∈ media (media.def.1).
Surd media(const Sorteo& s, std::span<const Surd> x);

/// The only r of (m, n, v, s, F, r) ∈ de_luz_extensa (de_luz_extensa.def.1). Throws as elevado() does.
Surd de_luz_extensa(const Material& m, const ExactDirection& n, const ExactDirection& v, const Sorteo& s,
                    std::span<const Fuente> F);

/// A thin lens before the picture.
struct Lente {
  ExactPoint ojo;      ///< its middle
  ExactDirection eje;  ///< along which the camera looks
  Rational abertura;   ///< its diameter
  Rational foco;       ///< the distance of the plane in focus
};

/// Lente.inv.1 to Lente.inv.3.
Judgements inv(const Lente& l);

/// (l, q) ∈ puntos_de_lente (puntos_de_lente.def.1).
bool puntos_de_lente(const Lente& l, const ExactPoint& q);

/// The only f of (l, v, f) ∈ punto_en_foco (punto_en_foco.def.1); nothing where v leads away from the plane in focus.
std::optional<ExactPoint> punto_en_foco(const Lente& l, const ExactDirection& v);

/// (l, v, rayo) ∈ rayo_de_lente (rayo_de_lente.def.1).
bool rayo_de_lente(const Lente& l, const ExactDirection& v, const Rayo& rayo);

/// The only u of (l, q, w, u) ∈ visto_en_foco (visto_en_foco.def.1); nothing where w does not lie before the lens.
std::optional<ExactPoint> visto_en_foco(const Lente& l, const ExactPoint& q, const ExactPoint& w);

/// The only c of (l, z, c) ∈ circulo_de_confusion (circulo_de_confusion.def.1). Precondition: z > 0.
Surd circulo_de_confusion(const Lente& l, const Surd& z);

/// The only q of (p, v, t, q) ∈ desplazado (desplazado.def.1).
ExactPoint desplazado(const ExactPoint& p, const ExactDirection& v, const Rational& t);

/// The sequences of a shared sum, a number for each outcome.
struct Repartida {
  Sorteo p, q;              ///< the two draws
  std::vector<Rational> w;  ///< the weight of the first
  std::vector<Rational> o;  ///< the weight of the second
  std::vector<Rational> f;  ///< the summands
  std::vector<Rational> x;  ///< the number that an outcome of the first counts
  std::vector<Rational> y;  ///< the number that an outcome of the second counts
};

/// (p, q, w, o, f, x, y) ∈ repartida (repartida.def.1).
bool repartida(const Repartida& r);

/// The y of (c, x, y) ∈ ruleta (ruleta.def.1); nothing where no y is, or every y. Precondition: c ∈ Parte.
std::optional<Rational> ruleta(const Rational& c, const Rational& x);

}  // namespace durero::model
