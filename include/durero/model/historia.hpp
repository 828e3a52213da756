#pragma once
/// Inverses and histories (spec/historia.tex; model/cambio.hpp has its changes): the operation that undoes each
/// operation, and histories of a scene with transactions.

#include <optional>
#include <variant>
#include <vector>

#include "durero/model/cambio.hpp"
#include "durero/model/malla.hpp"

namespace durero::model {

inline constexpr clause Historia_inv_1{"Historia.inv.1", "(inicial, θEscena) ∈ pliegue(hechas)"};
inline constexpr clause Historia_inv_2{"Historia.inv.2", "θEscena ∈ dom (pliegue(deshechas))"};
inline constexpr clause Init_Historia_post_1{"Init_Historia.post.1", "inicial' = θEscena'"};
inline constexpr clause Init_Historia_post_2{"Init_Historia.post.2", "hechas' = ⟨⟩"};
inline constexpr clause Init_Historia_post_3{"Init_Historia.post.3", "deshechas' = ⟨⟩"};
inline constexpr clause Seguir_post_1{"Seguir.post.1", "inicial' = inicial"};
inline constexpr clause Seguir_post_2{"Seguir.post.2", "θEscena' = pliegue(hechas')(inicial)"};
inline constexpr clause Transaccion_pre_1{"Transaccion.pre.1", "θEscena ∈ dom (pliegue(ops?))"};
inline constexpr clause Transaccion_post_1{"Transaccion.post.1", "hechas' = hechas ⌢ ⟨pliegue(ops?)⟩"};
inline constexpr clause Transaccion_post_2{"Transaccion.post.2", "deshechas' = ⟨⟩"};
inline constexpr clause Transaccion_post_3{"Transaccion.post.3", "r! = hecho"};
inline constexpr clause Deshacer_pre_1{"Deshacer.pre.1", "hechas ≠ ⟨⟩"};
inline constexpr clause Deshacer_post_1{"Deshacer.post.1", "hechas' = front(hechas)"};
inline constexpr clause Deshacer_post_2{"Deshacer.post.2", "deshechas' = ⟨last(hechas)⟩ ⌢ deshechas"};
inline constexpr clause Deshacer_post_3{"Deshacer.post.3", "r! = deshecho"};
inline constexpr clause Rehacer_pre_1{"Rehacer.pre.1", "deshechas ≠ ⟨⟩"};
inline constexpr clause Rehacer_post_1{"Rehacer.post.1", "hechas' = hechas ⌢ ⟨head(deshechas)⟩"};
inline constexpr clause Rehacer_post_2{"Rehacer.post.2", "deshechas' = tail(deshechas)"};
inline constexpr clause Rehacer_post_3{"Rehacer.post.3", "r! = rehecho"};
inline constexpr clause Transaccion_Rechazada_pre_1{"Transaccion_Rechazada.pre.1", "θEscena ∉ dom (pliegue(ops?))"};
inline constexpr clause Transaccion_Rechazada_post_1{"Transaccion_Rechazada.post.1", "r! = transaccion_rechazada"};
inline constexpr clause Nada_Que_Deshacer_pre_1{"Nada_Que_Deshacer.pre.1", "hechas = ⟨⟩"};
inline constexpr clause Nada_Que_Deshacer_post_1{"Nada_Que_Deshacer.post.1", "r! = nada_que_deshacer"};
inline constexpr clause Nada_Que_Rehacer_pre_1{"Nada_Que_Rehacer.pre.1", "deshechas = ⟨⟩"};
inline constexpr clause Nada_Que_Rehacer_post_1{"Nada_Que_Rehacer.post.1", "r! = nada_que_rehacer"};

/// The total change in a scene with meshes, which leaves each mesh as it is: a triangle of a mesh is not changed alone
/// (Cambio_Mallas.def.1).
Answer apply_total(Mallas& s, const AttributeChange& change);

// Inverses: the operations that undo others.

/// The operation that undoes this one, whose preconditions hold of the scene before it.
ElementOperation inverse(const Escena& before, const ElementOperation& operation);
/// The same of an operation on meshes.
MeshOperation inverse(const Mallas& before, const MeshOperation& operation);

/// An operation that leads from one scene to another; nothing where no single one does ((from, to) ∉ transiciones,
/// transiciones.def.1). Where it changes an attribute to the value that it has, the scenes are the same. O(n).
std::optional<ElementOperation> transition(const Escena& from, const Escena& to);

// Histories

/// A step of a history: what these operations, one after the other, make of a scene (Operacion.def.1).
using Operacion = std::vector<ElementOperation>;

/// What the steps make of a scene, one after the other (pliegue.def.1, pliegue.def.2): their fold. Nothing where a
/// precondition of some operation does not hold: the scene is then not in its domain.
std::optional<Escena> pliegue(const std::vector<Operacion>& ops, Escena escena);

/// A scene with its past (Historia). A plain value: its invariants are evaluated by what is declared below.
struct Historia {
  Escena escena;  ///< the components of Escena
  /// @{ The component of that name in the text.
  Escena inicial;
  std::vector<Operacion> hechas;
  std::vector<Operacion> deshechas;
  /// @}
};

/// The invariants of Escena, Historia.inv.1 and Historia.inv.2: the whole predicates, that is the fold.
Judgements inv(const Historia& s);
/// A history that begins with a scene (Init_Historia). Its postcondition is checked.
Historia Init_Historia(const Escena& escena);
/// The clauses of Init_Historia over its after-state.
Judgements Init_Historia_post(const Historia& after);

/// Does all of the steps, which are then one step, or none (Transaccion).
struct Transaccion {
  std::vector<Operacion> ops;

  static constexpr Respuesta answer = Respuesta::hecho;
  static constexpr std::string_view total = "Transaccion_Total";  ///< Transaccion_Total.def.1
};

/// Undoes the last step (Deshacer).
struct Deshacer {
  static constexpr Respuesta answer = Respuesta::deshecho;
  static constexpr std::string_view total = "Deshacer_Total";  ///< Deshacer_Total.def.1
};

/// Does the step again that was undone last (Rehacer).
struct Rehacer {
  static constexpr Respuesta answer = Respuesta::rehecho;
  static constexpr std::string_view total = "Rehacer_Total";  ///< Rehacer_Total.def.1
};

/// Any operation on a history.
using HistoryOperation = std::variant<Transaccion, Deshacer, Rehacer>;

/// @{ The clauses over the before-state and the inputs, and over both states, the inputs and r!, judged. A step is
/// compared by what it makes of the scenes of these histories.
Judgements pre(const Historia& before, const HistoryOperation& operation);
Judgements post(const Historia& before, const HistoryOperation& operation, const Historia& after, Respuesta r);
/// @}
/// The partial operation. Throws contract_violation where a clause does not hold; the history is then as it was.
Respuesta apply(Historia& s, const HistoryOperation& operation);
/// The total operation (…_Total): where the precondition does not hold it changes nothing and answers the error.
Answer apply_total(Historia& s, const HistoryOperation& operation);

}  // namespace durero::model
