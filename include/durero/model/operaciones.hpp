#pragma once
/// spec/operaciones.tex: the operations that edit a scene. Each schema is a struct of its inputs, without the `?`.
///
/// The model keeps both states of an operation, as a schema does: it edits a copy, evaluates the clauses over
/// (before, inputs, after, r!), and only then puts the copy in place. So a broken clause, or memory that runs out,
/// leaves the scene as it was. The price is O(n) an operation; scene::Scene is the refinement in O(1).

#include <optional>
#include <string_view>
#include <variant>

#include "durero/model/operation.hpp"
#include "durero/model/type_list.hpp"

namespace durero::model {

// The operations of each type stand in model/tipo/. A length arrives as a real, so that what is not in Rmas can be
// refused by name. Of each, `schema` and `total` are the names of the partial and of the total operation in the text,
// and `answer` is the r! of the operation when it is done.

/// The general addition (Elemento_Agregado): the addition of the type t, with the general answer. It looks only at
/// the attributes that t has; the others may be absent. One that t has and that is absent: std::invalid_argument.
struct Agregar_Elemento {
  Elemento e;
  Tipo t;
  std::optional<Punto> centro{};
  std::optional<double> radio{};
  std::optional<Vector> vector{};
  std::optional<double> altura{};
  std::optional<double> proporcion{};
  std::optional<Terna> vertices{};

  static constexpr Respuesta answer = Respuesta::elemento_agregado;
  static constexpr std::string_view schema = "Elemento_Agregado";
  static constexpr std::string_view total = "Agregar_Elemento_Total";
};

/// The general removal (Elemento_Eliminado): the removal of the element's type, with the general answer.
struct Eliminar_Elemento {
  Elemento e;

  static constexpr Respuesta answer = Respuesta::elemento_eliminado;
  static constexpr std::string_view schema = "Elemento_Eliminado";
  static constexpr std::string_view total = "Eliminar_Elemento_Total";
};

/// The operations of the types of a list.
template <class List>
struct Operations;
/// The only list that there is: a tuple.
template <class... Type>
struct Operations<std::tuple<Type...>> {
  using Addition = std::variant<typename Type::Addition...>;  ///< the addition of some type
  using Removal = std::variant<typename Type::Removal...>;    ///< the removal of some type
  /// These, and the general ones.
  using Any = std::variant<typename Type::Addition..., Agregar_Elemento, typename Type::Removal..., Eliminar_Elemento>;
};

/// @{ The additions and the removals of one type, in the order of Tipo.
using Addition = Operations<Types>::Addition;
using Removal = Operations<Types>::Removal;
/// @}

// The operations that operation.hpp names are those of the types, in order.
static_assert(std::is_same_v<Operation, Operations<Types>::Any>);

/// The addition of its type that a general addition stands for. Throws std::invalid_argument where an attribute of
/// the type is absent.
Addition specific(const Agregar_Elemento& general);

/// The removal of its type that a general removal stands for. Precondition: Eliminar_Elemento.pre.1.
Removal specific(const Escena& escena, const Eliminar_Elemento& general);

/// The partial operation. Throws contract_violation where a clause does not hold; the scene is then as it was.
Respuesta apply(Escena& escena, const Operation& operation);

/// The total operation (…_Total): where a precondition does not hold it changes nothing and answers the error, the
/// first in the order of the text. t? is hidden: a specific addition looks at no t. It carries out the …_Total of each
/// type, Agregar_Elemento_Total.def.1 and Eliminar_Elemento_Total.def.1.
Answer apply_total(Escena& escena, const Operation& operation);

}  // namespace durero::model
