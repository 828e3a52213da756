#pragma once
/// spec/operaciones.tex: the operations that edit a scene. Each schema is a struct of its inputs, without the `?`.
///
/// The model keeps both states of an operation, as a schema does: it edits a copy, evaluates the clauses over
/// (before, inputs, after, r!), and only then puts the copy in place. So a broken clause, or memory that runs out,
/// leaves the scene as it was. The price is O(n) an operation; scene::Scene is the refinement in O(1).

#include <optional>
#include <string_view>
#include <variant>

#include "durero/model/tipos.hpp"

namespace durero::model {

struct Escena;

// The operations. A length arrives as a real, so that what is not in Rmas can be refused by name. Of each, `schema` and
// `total` are the names of the partial and of the total operation in the text, and `answer` is the r! of the operation
// when it is done.

struct Agregar_Esfera {
  Elemento e;
  Punto centro;
  double radio;
  Tipo t = tipo;

  static constexpr Tipo tipo = Tipo::soy_esfera;
  static constexpr Respuesta answer = Respuesta::esfera_agregada;
  static constexpr std::string_view schema = "Agregar_Esfera", total = "Agregar_Esfera_Total";
};

struct Agregar_Cilindro {
  Elemento e;
  Punto centro;
  double radio;
  Vector vector;
  double altura;
  Tipo t = tipo;

  static constexpr Tipo tipo = Tipo::soy_cilindro;
  static constexpr Respuesta answer = Respuesta::cilindro_agregado;
  static constexpr std::string_view schema = "Agregar_Cilindro", total = "Agregar_Cilindro_Total";
};

struct Agregar_Cono {
  Elemento e;
  Punto centro;
  double proporcion;
  Vector vector;
  double altura;
  Tipo t = tipo;

  static constexpr Tipo tipo = Tipo::soy_cono;
  static constexpr Respuesta answer = Respuesta::cono_agregado;
  static constexpr std::string_view schema = "Agregar_Cono", total = "Agregar_Cono_Total";
};

struct Eliminar_Esfera {
  Elemento e;

  static constexpr Tipo tipo = Tipo::soy_esfera;
  static constexpr Respuesta answer = Respuesta::esfera_eliminada;
  static constexpr std::string_view schema = "Eliminar_Esfera", total = "Eliminar_Esfera_Total";
};

struct Eliminar_Cilindro {
  Elemento e;

  static constexpr Tipo tipo = Tipo::soy_cilindro;
  static constexpr Respuesta answer = Respuesta::cilindro_eliminado;
  static constexpr std::string_view schema = "Eliminar_Cilindro", total = "Eliminar_Cilindro_Total";
};

struct Eliminar_Cono {
  Elemento e;

  static constexpr Tipo tipo = Tipo::soy_cono;
  static constexpr Respuesta answer = Respuesta::cono_eliminado;
  static constexpr std::string_view schema = "Eliminar_Cono", total = "Eliminar_Cono_Total";
};

/// The general addition (Elemento_Agregado): the addition of the type t, with the general answer. It looks only at
/// the attributes that t has; the others may be absent. One that t has and that is absent: std::invalid_argument.
struct Agregar_Elemento {
  Elemento e;
  Tipo t;
  Punto centro;
  std::optional<double> radio{};
  std::optional<Vector> vector{};
  std::optional<double> altura{};
  std::optional<double> proporcion{};

  static constexpr Respuesta answer = Respuesta::elemento_agregado;
  static constexpr std::string_view schema = "Elemento_Agregado", total = "Agregar_Elemento_Total";
};

/// The general removal (Elemento_Eliminado): the removal of the element's type, with the general answer.
struct Eliminar_Elemento {
  Elemento e;

  static constexpr Respuesta answer = Respuesta::elemento_eliminado;
  static constexpr std::string_view schema = "Elemento_Eliminado", total = "Eliminar_Elemento_Total";
};

/// The additions and the removals of one type, in the order of Tipo. Every other list of operations follows from these.
using Addition = std::variant<Agregar_Esfera, Agregar_Cilindro, Agregar_Cono>;
using Removal = std::variant<Eliminar_Esfera, Eliminar_Cilindro, Eliminar_Cono>;

template <class Additions, class Removals>
struct Operations;
template <class... A, class... R>
struct Operations<std::variant<A...>, std::variant<R...>> {
  static_assert(sizeof...(A) == tipo_count && sizeof...(R) == tipo_count, "each type has an addition and a removal");
  using type = std::variant<A..., Agregar_Elemento, R..., Eliminar_Elemento>;
};

/// Any operation.
using Operation = Operations<Addition, Removal>::type;

/// The addition of its type that a general addition stands for. Throws std::invalid_argument where an attribute of
/// the type is absent.
Addition specific(const Agregar_Elemento& general);

/// The removal of its type that a general removal stands for. Precondition: Eliminar_Elemento.pre.1.
Removal specific(const Escena& escena, const Eliminar_Elemento& general);

/// What a total operation answers: r!, and where it is an error, the precondition of the partial operation that
/// does not hold.
struct Answer {
  Respuesta r;
  const contract::clause* violated = nullptr;
  bool ok() const noexcept { return violated == nullptr; }
  bool operator==(const Answer&) const = default;
};

/// The partial operation. Throws contract_violation where a clause does not hold; the scene is then as it was.
Respuesta apply(Escena& escena, const Operation& operation);

/// The total operation (…_Total): where a precondition does not hold it changes nothing and answers the error, the
/// first in the order of the text. t? is hidden: a specific addition looks at no t. It carries out
/// Agregar_Esfera_Total.def.1, Agregar_Cilindro_Total.def.1, Agregar_Cono_Total.def.1, Agregar_Elemento_Total.def.1,
/// Eliminar_Esfera_Total.def.1, Eliminar_Cilindro_Total.def.1, Eliminar_Cono_Total.def.1,
/// Eliminar_Elemento_Total.def.1.
Answer apply_total(Escena& escena, const Operation& operation);

}  // namespace durero::model
