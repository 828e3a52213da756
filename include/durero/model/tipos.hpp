#pragma once
/// spec/tipos.tex: the types of the specification. A stored number is a binary64 and denotes the rational it is;
/// a wrong value cannot be built.

#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

#include "durero/contract/contract.hpp"

namespace durero::model {

inline constexpr contract::clause Rmas_inv_1{"Rmas.inv.1", "r > 0"};
inline constexpr contract::clause Rayo_inv_1{"Rayo.inv.1", "¬ (v.x = 0 ∧ v.y = 0 ∧ v.z = 0)"};
inline constexpr contract::clause Unitario_inv_1{
    "Unitario.inv.1", "1 − tolerancia_unidad ≤ d.x * d.x + d.y * d.y + d.z * d.z ≤ 1 + tolerancia_unidad"};
inline constexpr contract::clause Vertices_inv_1{
    "Vertices.inv.1",
    "¬ ((v.b.y − v.a.y) * (v.c.z − v.a.z) = (v.b.z − v.a.z) * (v.c.y − v.a.y) ∧ (v.b.z − v.a.z) * (v.c.x − v.a.x) = "
    "(v.b.x − v.a.x) * (v.c.z − v.a.z) ∧ (v.b.x − v.a.x) * (v.c.y − v.a.y) = (v.b.y − v.a.y) * (v.c.x − v.a.x))"};

/// tolerancia_unidad.def.1: how far the squared length of an axis may be from one, 2⁻⁵⁰.
inline constexpr double tolerancia_unidad = 0x1p-50;

/// A strictly positive finite binary64 (Rmas). Throws contract_violation Rmas.inv.1 on 0, negatives, ∞ and NaN.
class Rmas {
 public:
  /// Precondition: contains(value); throws otherwise.
  explicit Rmas(double value);
  /// The number, as it was given.
  double value() const noexcept { return value_; }
  /// value ∈ Rmas
  static bool contains(double value) noexcept;
  auto operator<=>(const Rmas&) const = default;

 private:
  double value_;
};

namespace detail {
/// Throws std::domain_error, which names the type and the three numbers, one of which is no real.
[[noreturn, gnu::cold]] void refuse(const char* type, const glm::dvec3& xyz);

/// Written where it is used, as the constructors are that call it: rays are made by the million.
inline void require_reals(const char* type, const glm::dvec3& xyz) {
  if (!(std::isfinite(xyz.x) && std::isfinite(xyz.y) && std::isfinite(xyz.z))) refuse(type, xyz);
}
}  // namespace detail

/// A position: three finite binary64 (Punto). Throws std::domain_error on ∞ and NaN, which are no reals.
class Punto {
 public:
  /// @{ Of three numbers. Throws std::domain_error where one is not finite.
  Punto(double x, double y, double z) : xyz_(x, y, z) { detail::require_reals("Punto", xyz_); }
  explicit Punto(const glm::dvec3& xyz) : Punto(xyz.x, xyz.y, xyz.z) {}
  /// @}
  /// @{ The numbers, as they were given.
  double x() const noexcept { return xyz_.x; }
  double y() const noexcept { return xyz_.y; }
  double z() const noexcept { return xyz_.z; }
  const glm::dvec3& xyz() const noexcept { return xyz_; }
  /// @}
  /// Whether the numbers are equal, so that −0 is 0.
  bool operator==(const Punto& other) const noexcept { return xyz_ == other.xyz_; }

 private:
  glm::dvec3 xyz_;
};

/// A direction: three finite binary64 (Vector). Throws std::domain_error on ∞ and NaN.
class Vector {
 public:
  /// @{ Of three numbers. Throws std::domain_error where one is not finite.
  Vector(double x, double y, double z) : xyz_(x, y, z) { detail::require_reals("Vector", xyz_); }
  explicit Vector(const glm::dvec3& xyz) : Vector(xyz.x, xyz.y, xyz.z) {}
  /// @}
  /// @{ The numbers, as they were given.
  double x() const noexcept { return xyz_.x; }
  double y() const noexcept { return xyz_.y; }
  double z() const noexcept { return xyz_.z; }
  const glm::dvec3& xyz() const noexcept { return xyz_; }
  /// @}
  /// Whether the numbers are equal, so that −0 is 0.
  bool operator==(const Vector& other) const noexcept { return xyz_ == other.xyz_; }

 private:
  glm::dvec3 xyz_;
};

/// A vector whose exact squared length is within tolerancia_unidad of 1 (Unitario): what an axis must be.
/// Throws contract_violation Unitario.inv.1 otherwise. The stored components are used as they are.
class Unitario {
 public:
  /// Precondition: contains(d); throws otherwise.
  explicit Unitario(const Vector& d);
  /// The vector, as it was given.
  const Vector& vector() const noexcept { return d_; }
  /// d ∈ Unitario, exactly.
  static bool contains(const Vector& d);
  bool operator==(const Unitario&) const noexcept = default;

 private:
  Vector d_;
};

/// A ray { p + t·v | t > 0 } (Rayo); v need not be a unit vector. Throws contract_violation Rayo.inv.1 when v = 0.
class Rayo {
 public:
  /// Precondition: v ≠ 0; throws otherwise.
  Rayo(const Punto& p, const Vector& v) : p_(p), v_(v) {
    contract::require(Rayo_inv_1, !(v.x() == 0 && v.y() == 0 && v.z() == 0));
  }
  /// The origin, which is no point of the ray.
  const Punto& p() const noexcept { return p_; }
  /// The direction, of any length.
  const Vector& v() const noexcept { return v_; }
  bool operator==(const Rayo&) const noexcept = default;

 private:
  Punto p_;
  Vector v_;
};

/// Three points, in the order in which they are given (Terna).
struct Terna {
  Punto a, b, c;  ///< the points

  bool operator==(const Terna&) const noexcept = default;
};

/// The three vertices of a triangle: points that do not lie on one line, exactly (Vertices). Throws contract_violation
/// Vertices.inv.1 otherwise.
class Vertices {
 public:
  /// Precondition: contains(v); throws otherwise.
  explicit Vertices(const Terna& v);
  /// The points, as they were given.
  const Terna& terna() const noexcept { return v_; }
  /// v ∈ Vertices, exactly.
  static bool contains(const Terna& v);
  bool operator==(const Vertices&) const noexcept = default;

 private:
  Terna v_;
};

/// The name of an element (Elemento): 1 to 128 of A–Z a–z 0–9 _ . : -. Throws std::invalid_argument otherwise.
class Elemento {
 public:
  /// Precondition: is_name(name); throws otherwise.
  explicit Elemento(std::string name);
  /// @{ The characters.
  const std::string& name() const& noexcept { return name_; }
  std::string name() && noexcept { return std::move(name_); }
  /// @}
  /// Whether the text can be a name.
  static bool is_name(std::string_view text) noexcept;
  auto operator<=>(const Elemento&) const = default;

 private:
  std::string name_;
};

/// What an element is (Tipo), and its name in the text.
enum class Tipo : std::uint8_t { soy_esfera, soy_cilindro, soy_cono, soy_tronco, soy_plano, soy_disco, soy_triangulo };
/// The names, in the order of Tipo.
inline constexpr auto tipo_names = std::to_array<std::string_view>(
    {"soy_esfera", "soy_cilindro", "soy_cono", "soy_tronco", "soy_plano", "soy_disco", "soy_triangulo"});
static_assert(Tipo{tipo_names.size() - 1} == Tipo::soy_triangulo);

/// How many types there are.
inline constexpr std::size_t tipo_count = tipo_names.size();

/// What an operation did, or why it did nothing (Respuesta), and its name in the text.
enum class Respuesta : std::uint8_t {
  elemento_agregado,
  elemento_eliminado,
  esfera_agregada,
  cilindro_agregado,
  cono_agregado,
  tronco_agregado,
  plano_agregado,
  disco_agregado,
  triangulo_agregado,
  esfera_eliminada,
  cilindro_eliminado,
  cono_eliminado,
  tronco_eliminado,
  plano_eliminado,
  disco_eliminado,
  triangulo_eliminado,
  elemento_ya_existe,
  elemento_no_existe,
  tipo_incorrecto,
  radio_no_positivo,
  vector_no_unitario,
  altura_no_positiva,
  proporcion_no_positiva,
  vertices_alineados,
  malla_agregada,
  malla_eliminada,
  malla_reemplazada,
  vertice_movido,
  malla_ya_existe,
  malla_no_existe,
  cara_incompleta,
  cara_sin_nombre,
  vertice_no_existe,
  es_de_malla,
  elemento_cambiado,
  material_no_existe,
  grupo_no_existe,
  hecho,
  deshecho,
  rehecho,
  transaccion_rechazada,
  nada_que_deshacer,
  nada_que_rehacer
};
/// The names, in the order of Respuesta.
inline constexpr auto respuesta_names = std::to_array<std::string_view>({"elemento_agregado",
                                                                         "elemento_eliminado",
                                                                         "esfera_agregada",
                                                                         "cilindro_agregado",
                                                                         "cono_agregado",
                                                                         "tronco_agregado",
                                                                         "plano_agregado",
                                                                         "disco_agregado",
                                                                         "triangulo_agregado",
                                                                         "esfera_eliminada",
                                                                         "cilindro_eliminado",
                                                                         "cono_eliminado",
                                                                         "tronco_eliminado",
                                                                         "plano_eliminado",
                                                                         "disco_eliminado",
                                                                         "triangulo_eliminado",
                                                                         "elemento_ya_existe",
                                                                         "elemento_no_existe",
                                                                         "tipo_incorrecto",
                                                                         "radio_no_positivo",
                                                                         "vector_no_unitario",
                                                                         "altura_no_positiva",
                                                                         "proporcion_no_positiva",
                                                                         "vertices_alineados",
                                                                         "malla_agregada",
                                                                         "malla_eliminada",
                                                                         "malla_reemplazada",
                                                                         "vertice_movido",
                                                                         "malla_ya_existe",
                                                                         "malla_no_existe",
                                                                         "cara_incompleta",
                                                                         "cara_sin_nombre",
                                                                         "vertice_no_existe",
                                                                         "es_de_malla",
                                                                         "elemento_cambiado",
                                                                         "material_no_existe",
                                                                         "grupo_no_existe",
                                                                         "hecho",
                                                                         "deshecho",
                                                                         "rehecho",
                                                                         "transaccion_rechazada",
                                                                         "nada_que_deshacer",
                                                                         "nada_que_rehacer"});
static_assert(Respuesta{respuesta_names.size() - 1} == Respuesta::nada_que_rehacer);

/// @{ Its name in the text.
constexpr std::string_view name(Tipo tipo) noexcept { return tipo_names[static_cast<std::size_t>(tipo)]; }
constexpr std::string_view name(Respuesta r) noexcept { return respuesta_names[static_cast<std::size_t>(r)]; }
/// @}

}  // namespace durero::model
