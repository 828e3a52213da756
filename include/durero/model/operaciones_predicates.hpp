#pragma once
/// The predicates of the operation schemas in spec/operaciones.tex, clause for clause, in its order.

#include "durero/model/escena.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/model/operaciones_clauses.hpp"

namespace durero::model {

/// Whether e has the type t: de_que_tipo(e) = t; false where e has none.
bool is_of_type(const Escena& escena, const Elemento& e, Tipo t);

/// The preconditions over the before-state and the inputs. O(log n).
Judgements pre(const Escena& before, const Agregar_Esfera& in);
Judgements pre(const Escena& before, const Agregar_Cilindro& in);
Judgements pre(const Escena& before, const Agregar_Cono& in);
Judgements pre(const Escena& before, const Agregar_Elemento& in);
Judgements pre(const Escena& before, const Eliminar_Esfera& in);
Judgements pre(const Escena& before, const Eliminar_Cilindro& in);
Judgements pre(const Escena& before, const Eliminar_Cono& in);
Judgements pre(const Escena& before, const Eliminar_Elemento& in);
Judgements pre(const Escena& before, const Operation& operation);

/// The postconditions over both states, the inputs and r!: at `audit` price the whole predicates; at `normal` price
/// what changed of them, in O(log n): the size of each component, and its value at e?.
Judgements post(const Escena& before, const Agregar_Esfera& in, const Escena& after, Respuesta r, contract::cost price);
Judgements post(const Escena& before, const Agregar_Cilindro& in, const Escena& after, Respuesta r,
                contract::cost price);
Judgements post(const Escena& before, const Agregar_Cono& in, const Escena& after, Respuesta r, contract::cost price);
Judgements post(const Escena& before, const Agregar_Elemento& in, const Escena& after, Respuesta r,
                contract::cost price);
Judgements post(const Escena& before, const Eliminar_Esfera& in, const Escena& after, Respuesta r,
                contract::cost price);
Judgements post(const Escena& before, const Eliminar_Cilindro& in, const Escena& after, Respuesta r,
                contract::cost price);
Judgements post(const Escena& before, const Eliminar_Cono& in, const Escena& after, Respuesta r, contract::cost price);
Judgements post(const Escena& before, const Eliminar_Elemento& in, const Escena& after, Respuesta r,
                contract::cost price);
Judgements post(const Escena& before, const Operation& operation, const Escena& after, Respuesta r,
                contract::cost price);

}  // namespace durero::model
