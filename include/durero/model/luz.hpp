#pragma once
/// spec/luz.tex: what a surface sends towards the eye, how far light is followed back, and the rays of a picture. Each
/// function is the definition of the same name, carried out in exact arithmetic, for one component of a colour.

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "durero/model/iluminacion.hpp"
#include "durero/model/judgement.hpp"
#include "durero/model/operation.hpp"
#include "durero/model/tipos.hpp"

namespace durero::model {

inline constexpr contract::clause Parte_inv_1{"Parte.inv.1", "0 ≤ k ≤ 1"};
inline constexpr contract::clause Cantidad_inv_1{"Cantidad.inv.1", "r ≥ 0"};
inline constexpr contract::clause Material_inv_1{"Material.inv.1", "k_a ∈ Parte"};
inline constexpr contract::clause Material_inv_2{"Material.inv.2", "k_d ∈ Parte"};
inline constexpr contract::clause Material_inv_3{"Material.inv.3", "k_s ∈ Parte"};
inline constexpr contract::clause Material_inv_4{"Material.inv.4", "k_ps ∈ Parte"};
inline constexpr contract::clause Material_inv_5{"Material.inv.5", "k_t ∈ Parte"};
inline constexpr contract::clause Material_inv_6{"Material.inv.6", "C ∈ Parte"};
inline constexpr contract::clause Material_inv_7{"Material.inv.7", "M_PS ∈ Parte"};
inline constexpr contract::clause Material_inv_8{"Material.inv.8", "M_T ∈ Parte"};
inline constexpr contract::clause Material_inv_9{"Material.inv.9", "emisividad ∈ Cantidad"};
inline constexpr contract::clause Material_inv_10{"Material.inv.10", "A_G ∈ Cantidad"};
inline constexpr contract::clause Material_inv_11{"Material.inv.11", "e ∈ Cantidad"};
inline constexpr contract::clause Material_inv_12{"Material.inv.12", "indice ∈ Rmas"};
inline constexpr contract::clause Fuente_inv_1{"Fuente.inv.1", "S ∈ Cantidad"};
inline constexpr contract::clause Fuente_inv_2{"Fuente.inv.2", "V = 0 ∨ V = 1"};
inline constexpr contract::clause Cono_de_Luz_inv_1{"Cono_de_Luz.inv.1", "producto(eje, eje) = 1"};
inline constexpr contract::clause Cono_de_Luz_inv_2{"Cono_de_Luz.inv.2", "0 < borde ≤ pleno ≤ 1"};
inline constexpr contract::clause Cono_de_Luz_inv_3{"Cono_de_Luz.inv.3", "estrechez ∈ Cantidad"};
inline constexpr contract::clause Ventana_inv_1{"Ventana.inv.1", "H ≥ 1"};
inline constexpr contract::clause Ventana_inv_2{"Ventana.inv.2", "V ≥ 1"};

/// A share of light.
struct Parte {
  /// k ∈ Parte (Parte.inv.1)
  static Judgement contains(const Rational& k) { return {&Parte_inv_1, k >= 0 && k <= 1}; }
};

/// An amount of light.
struct Cantidad {
  /// r ∈ Cantidad (Cantidad.inv.1)
  static Judgement contains(const Rational& r) { return {&Cantidad_inv_1, r >= 0}; }
};

/// The look of a surface at a point. A plain value: inv() evaluates its invariants.
struct Material {
  /// @{ The component of that name in the text.
  Rational k_a, k_d, k_s, k_ps, k_t;
  Rational C, M_PS, M_T;
  Rational emisividad, A_G, e, indice;
  /// @}
};

/// Material.inv.1 to Material.inv.12.
Judgements inv(const Material& m);

/// m ∈ conserva: it sends on no more than it receives (conserva.def.1). No invariant: it is warned of what does not.
bool conserva(const Material& m);

/// A light, as a point has it.
struct Fuente {
  ExactDirection l;  ///< where it stands
  Rational S;        ///< how bright it is
  Rational V;        ///< 1 where it is visible, 0 where it is not
};

/// Fuente.inv.1 and Fuente.inv.2.
Judgements inv(const Fuente& f);

/// The greater of the two (mayor.def.1).
Surd mayor(const Surd& a, const Surd& b);

/// x to the power of a, whatever a ≥ 0 where x = 1; else where a is whole (elevado.def.1, elevado.def.2,
/// elevado.def.3). Throws std::domain_error where a is negative, above 2^20 or not whole: the power then has no name in
/// our numbers, or too long a one; and where x is negative.
Surd elevado(const Surd& x, const Rational& a);

/// (θEscena, p, q, en) ∈ visible: nothing stands between p, on the elements `en`, and q (visible.def.1). Throws
/// std::domain_error where a component of q − p is no binary64: the ray then has no name here.
bool visible(const Escena& escena, const Punto& p, const Punto& q, const std::set<Elemento>& en);

/// (θEscena, p, l, en) ∈ visible_lejos: nothing stands in the direction l (visible_lejos.def.1).
bool visible_lejos(const Escena& escena, const Punto& p, const Vector& l, const std::set<Elemento>& en);

/// (θEscena, rayo, en, e, punto) ∈ ante: e has that point before the parameter one of the ray (ante.def.1).
bool ante(const Escena& escena, const Rayo& rayo, const std::set<Elemento>& en, const Elemento& e,
          const ExactPoint& punto);

/// (θEscena, rayo, en, e, punto) ∈ ante_lejos: e has that point on the ray (ante_lejos.def.1).
bool ante_lejos(const Escena& escena, const Rayo& rayo, const std::set<Elemento>& en, const Elemento& e,
                const ExactPoint& punto);

/// A point of an element that stands before a light.
struct Encuentro {
  Elemento e;        ///< the element
  ExactPoint punto;  ///< the point
};

/// c of (S, n, c) ∈ enumerado, where S is all that stands before a light (enumerado.def.1); nothing where there is no
/// such c: the ray runs along an element. `segment`: S is of ante, else of ante_lejos.
std::optional<std::vector<Encuentro>> enumerado(const Escena& escena, const Rayo& rayo, const std::set<Elemento>& en,
                                                bool segment);

/// resto of (dada, resto) ∈ atenuado: what is left behind the first i of them at i (atenuado.def.1).
std::vector<Rational> atenuado(std::span<const Rational> dada);

/// k of (S, paso, k) ∈ transmitido, where c counts S (transmitido.def.1).
Rational transmitido(std::span<const Encuentro> c, const std::function<Rational(const Encuentro&)>& paso);

/// g of (f, k, g) ∈ menguada: the light of which a share is left (menguada.def.1).
Fuente menguada(const Fuente& f, const Rational& k);

// Precondition of all that follows: what a function is given lies in one field.

/// The only n with (a, b, c, u, v, n) ∈ normal_suave: the direction that a point of a triangle is shaded by, between
/// the normals of its corners (normal_suave.def.1).
ExactDirection normal_suave(const ExactDirection& a, const ExactDirection& b, const ExactDirection& c, const Surd& u,
                            const Surd& v);

/// A cone that a light shines into.
struct Cono_de_Luz {
  ExactDirection eje;  ///< its axis, of length one
  Rational pleno;      ///< the cosine up to which the light is full
  Rational borde;      ///< the cosine beyond which there is none
  Rational estrechez;  ///< the power of the cosine that narrows it
};

/// Cono_de_Luz.inv.1 to Cono_de_Luz.inv.3.
Judgements inv(const Cono_de_Luz& c);

/// The only k with (c, w, k) ∈ intensidad: the share of the light along the unit vector w (intensidad.def.1). Throws as
/// elevado() does. Preconditions: inv(c), and w has the length one.
Surd intensidad(const Cono_de_Luz& c, const ExactDirection& w);

/// The cosine of the highlight (especular.def.1).
Surd especular(const ExactDirection& l, const ExactDirection& n, const ExactDirection& v);

/// What of a light in the direction l is sent towards v (directa.def.1). Throws as elevado() does.
Surd directa(const Material& m, const ExactDirection& n, const ExactDirection& v, const ExactDirection& l);

/// A term of the sum over the lights (aportacion.def.1). Throws as elevado() does.
Surd aportacion(const Material& m, const ExactDirection& n, const ExactDirection& v, const Fuente& f);

/// What comes from no light (indirecta.def.1).
Surd indirecta(const Material& m, const Surd& r, const Surd& t);

/// All that a point sends (radiancia.def.1).
Surd radiancia(const Material& m, const Surd& suma, const Surd& r, const Surd& t);

/// suma of (dada, suma) ∈ acumulado: that of the first i at i (acumulado.def.1).
std::vector<Surd> acumulado(std::span<const Surd> dada);

/// What there is to follow (Trazado), of ways that are numbered from 0.
struct Trazado {
  /// A way (Camino): the components of the text at it.
  struct Camino {
    bool llega = false;          ///< whether it leads to a surface
    Surd fondo{};                ///< what it brings where it does not
    Material material{};         ///< of the point where it does
    Surd de_luces{};             ///< what the lights give there
    std::size_t reflejado = 0;   ///< the mirrored way
    std::size_t refractado = 0;  ///< the refracted one
  };
  std::vector<Camino> caminos;  ///< what they lead to are of these
};

/// L(n, c) of (t, maximo, L) ∈ trazador, for every way c (trazador.def.1). It takes as many steps as there are depths
/// from n to the greatest: the recursion ends.
std::vector<Surd> trazador(const Trazado& t, std::int64_t maximo, std::int64_t n);

/// The window before the eye.
struct Ventana {
  ExactPoint ojo, esquina;     ///< the eye, and the corner
  ExactDirection ancho, alto;  ///< the edges from the corner
  std::int64_t H = 1, V = 1;   ///< the columns and rows of pixels
};

/// Ventana.inv.1 and Ventana.inv.2.
Judgements inv(const Ventana& w);

/// The q of (w, x, y, q) ∈ centro_de_pixel (centro_de_pixel.def.1). Precondition: inv(w), and x, y are of a pixel.
ExactPoint centro_de_pixel(const Ventana& w, std::int64_t x, std::int64_t y);

/// (w, x, y, rayo) ∈ rayo_de_pixel (rayo_de_pixel.def.1). Precondition: inv(w).
bool rayo_de_pixel(const Ventana& w, std::int64_t x, std::int64_t y, const Rayo& rayo);

}  // namespace durero::model
