#pragma once
/// spec/tipos.tex: the types of the specification. A stored number is a binary64 and denotes the rational it is;
/// a wrong value cannot be built.

#include <array>
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
  explicit Rmas(double value);
  double value() const noexcept { return value_; }
  static bool contains(double value) noexcept;
  auto operator<=>(const Rmas&) const = default;

 private:
  double value_;
};

/// A position: three finite binary64 (Punto). Throws std::domain_error on ∞ and NaN, which are no reals.
class Punto {
 public:
  Punto(double x, double y, double z);
  explicit Punto(const glm::dvec3& xyz) : Punto(xyz.x, xyz.y, xyz.z) {}
  double x() const noexcept { return xyz_.x; }
  double y() const noexcept { return xyz_.y; }
  double z() const noexcept { return xyz_.z; }
  const glm::dvec3& xyz() const noexcept { return xyz_; }
  bool operator==(const Punto& other) const noexcept { return xyz_ == other.xyz_; }

 private:
  glm::dvec3 xyz_;
};

/// A direction: three finite binary64 (Vector). Throws std::domain_error on ∞ and NaN.
class Vector {
 public:
  Vector(double x, double y, double z);
  explicit Vector(const glm::dvec3& xyz) : Vector(xyz.x, xyz.y, xyz.z) {}
  double x() const noexcept { return xyz_.x; }
  double y() const noexcept { return xyz_.y; }
  double z() const noexcept { return xyz_.z; }
  const glm::dvec3& xyz() const noexcept { return xyz_; }
  bool operator==(const Vector& other) const noexcept { return xyz_ == other.xyz_; }

 private:
  glm::dvec3 xyz_;
};

/// A vector whose exact squared length is within tolerancia_unidad of 1 (Unitario): what an axis must be.
/// Throws contract_violation Unitario.inv.1 otherwise. The stored components are used as they are.
class Unitario {
 public:
  explicit Unitario(const Vector& d);
  const Vector& vector() const noexcept { return d_; }
  static bool contains(const Vector& d);
  bool operator==(const Unitario&) const noexcept = default;

 private:
  Vector d_;
};

/// A ray { p + t·v | t > 0 } (Rayo); v need not be a unit vector. Throws contract_violation Rayo.inv.1 when v = 0.
class Rayo {
 public:
  Rayo(const Punto& p, const Vector& v);
  const Punto& p() const noexcept { return p_; }
  const Vector& v() const noexcept { return v_; }
  bool operator==(const Rayo&) const noexcept = default;

 private:
  Punto p_;
  Vector v_;
};

/// Three points, in the order in which they are given (Terna).
struct Terna {
  Punto a, b, c;

  bool operator==(const Terna&) const noexcept = default;
};

/// The three vertices of a triangle: points that do not lie on one line, exactly (Vertices). Throws contract_violation
/// Vertices.inv.1 otherwise.
class Vertices {
 public:
  explicit Vertices(const Terna& v);
  const Terna& terna() const noexcept { return v_; }
  static bool contains(const Terna& v);
  bool operator==(const Vertices&) const noexcept = default;

 private:
  Terna v_;
};

/// The name of an element (Elemento): 1 to 128 of A–Z a–z 0–9 _ . : -. Throws std::invalid_argument otherwise.
class Elemento {
 public:
  explicit Elemento(std::string name);
  const std::string& name() const noexcept { return name_; }
  static bool is_name(std::string_view text) noexcept;
  auto operator<=>(const Elemento&) const = default;

 private:
  std::string name_;
};

/// What an element is (Tipo), and its name in the text.
enum class Tipo : std::uint8_t { soy_esfera, soy_cilindro, soy_cono, soy_tronco, soy_plano, soy_disco, soy_triangulo };
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
  vertices_alineados
};
inline constexpr auto respuesta_names = std::to_array<std::string_view>(
    {"elemento_agregado",   "elemento_eliminado", "esfera_agregada",        "cilindro_agregado",  "cono_agregado",
     "tronco_agregado",     "plano_agregado",     "disco_agregado",         "triangulo_agregado", "esfera_eliminada",
     "cilindro_eliminado",  "cono_eliminado",     "tronco_eliminado",       "plano_eliminado",    "disco_eliminado",
     "triangulo_eliminado", "elemento_ya_existe", "elemento_no_existe",     "tipo_incorrecto",    "radio_no_positivo",
     "vector_no_unitario",  "altura_no_positiva", "proporcion_no_positiva", "vertices_alineados"});
static_assert(Respuesta{respuesta_names.size() - 1} == Respuesta::vertices_alineados);

constexpr std::string_view name(Tipo tipo) noexcept { return tipo_names[static_cast<std::size_t>(tipo)]; }
constexpr std::string_view name(Respuesta r) noexcept { return respuesta_names[static_cast<std::size_t>(r)]; }

}  // namespace durero::model
