#pragma once
/// spec/escena.tex: a scene is a finite set of elements, each of one type, with the attributes of its type.

#include <map>
#include <set>
#include <vector>

#include "durero/model/tipos.hpp"

namespace durero::model {

inline constexpr contract::clause Escena_inv_1{"Escena.inv.1", "elementos = dom de_que_tipo"};
inline constexpr contract::clause Escena_inv_2{"Escena.inv.2", "elementos = dom mi_centro"};
inline constexpr contract::clause Escena_inv_3{"Escena.inv.3",
                                               "dom mi_radio = de_que_tipo ∼ ⦇ { soy_esfera, soy_cilindro } ⦈"};
inline constexpr contract::clause Escena_inv_4{"Escena.inv.4",
                                               "dom mi_vector = de_que_tipo ∼ ⦇ { soy_cilindro, soy_cono } ⦈"};
inline constexpr contract::clause Escena_inv_5{"Escena.inv.5",
                                               "dom mi_altura = de_que_tipo ∼ ⦇ { soy_cilindro, soy_cono } ⦈"};
inline constexpr contract::clause Escena_inv_6{"Escena.inv.6", "dom mi_proporcion = de_que_tipo ∼ ⦇ { soy_cono } ⦈"};
inline constexpr contract::clause Escena_inv_7{"Escena.inv.7", "tipos = ran de_que_tipo"};
inline constexpr contract::clause Escena_inv_8{"Escena.inv.8", "ran mi_vector ⊆ Unitario"};
inline constexpr contract::clause Init_post_1{"Init.post.1", "elementos' = ∅"};

/// Escena, component for component. A plain value: its invariants are evaluated by what is declared below.
struct Escena {
  std::set<Elemento> elementos;
  std::set<Tipo> tipos;
  std::map<Elemento, Tipo> de_que_tipo;
  std::map<Elemento, Punto> mi_centro;
  std::map<Elemento, Rmas> mi_radio;
  std::map<Elemento, Vector> mi_vector;
  std::map<Elemento, Rmas> mi_altura;
  std::map<Elemento, Rmas> mi_proporcion;

  bool operator==(const Escena&) const = default;
};

/// A clause and whether it holds.
struct Judgement {
  const contract::clause* what;
  bool holds;
};
using Judgements = std::vector<Judgement>;

/// The empty scene (Init). Its postcondition is checked.
Escena Init();
/// The clauses of Init over its after-state.
Judgements Init_post(const Escena& after);

/// Escena.inv.1 to Escena.inv.8, in that order: the whole predicates. O(n log n).
Judgements inv(const Escena& escena);
/// What Escena.inv.1 to Escena.inv.8 say of one element: e lies on both sides of each equation or on neither, its type
/// is among the types, its vector is an axis. Where e is the only element that changed since the invariant held, and
/// no type was lost, this is the invariant. O(log n).
Judgements inv_at(const Escena& escena, const Elemento& e);

/// Checks every judgement as a contract at this price; `about` says on what values.
void check(const Judgements& judgements, contract::cost price, const std::string& about = {});
/// True when every judgement holds.
bool all_hold(const Judgements& judgements) noexcept;

}  // namespace durero::model
