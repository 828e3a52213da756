#pragma once
/// spec/escena.tex: a scene is a finite set of elements, each of one type, with the attributes of its type.

#include <initializer_list>
#include <map>
#include <set>
#include <tuple>
#include <type_traits>

#include "durero/model/judgement.hpp"
#include "durero/model/tipos.hpp"

namespace durero::model {

inline constexpr contract::clause Escena_inv_1{"Escena.inv.1", "elementos = dom de_que_tipo"};
inline constexpr contract::clause Escena_inv_2{
    "Escena.inv.2",
    "dom mi_centro = de_que_tipo ∼ ⦇ { soy_esfera, soy_cilindro, soy_cono, soy_tronco, soy_plano, soy_disco } ⦈"};
inline constexpr contract::clause Escena_inv_3{
    "Escena.inv.3", "dom mi_radio = de_que_tipo ∼ ⦇ { soy_esfera, soy_cilindro, soy_tronco, soy_disco } ⦈"};
inline constexpr contract::clause Escena_inv_4{
    "Escena.inv.4", "dom mi_vector = de_que_tipo ∼ ⦇ { soy_cilindro, soy_cono, soy_tronco, soy_plano, soy_disco } ⦈"};
inline constexpr contract::clause Escena_inv_5{
    "Escena.inv.5", "dom mi_altura = de_que_tipo ∼ ⦇ { soy_cilindro, soy_cono, soy_tronco } ⦈"};
inline constexpr contract::clause Escena_inv_6{"Escena.inv.6",
                                               "dom mi_proporcion = de_que_tipo ∼ ⦇ { soy_cono, soy_tronco } ⦈"};
inline constexpr contract::clause Escena_inv_7{"Escena.inv.7", "tipos = ran de_que_tipo"};
inline constexpr contract::clause Escena_inv_8{"Escena.inv.8", "ran mi_vector ⊆ Unitario"};
inline constexpr contract::clause Escena_inv_9{"Escena.inv.9", "dom mi_vertices = de_que_tipo ∼ ⦇ { soy_triangulo } ⦈"};
inline constexpr contract::clause Con_Radio_pre_1{"Con_Radio.pre.1",
                                                  "t? ∈ { soy_esfera, soy_cilindro, soy_tronco, soy_disco }"};
inline constexpr contract::clause Con_Vector_pre_1{"Con_Vector.pre.1",
                                                   "t? ∈ { soy_cilindro, soy_cono, soy_tronco, soy_plano, soy_disco }"};
inline constexpr contract::clause Con_Altura_pre_1{"Con_Altura.pre.1", "t? ∈ { soy_cilindro, soy_cono, soy_tronco }"};
inline constexpr contract::clause Con_Proporcion_pre_1{"Con_Proporcion.pre.1", "t? ∈ { soy_cono, soy_tronco }"};
inline constexpr contract::clause Con_Vertices_pre_1{"Con_Vertices.pre.1", "t? ∈ { soy_triangulo }"};
inline constexpr contract::clause Init_post_1{"Init.post.1", "elementos' = ∅"};

/// Escena, component for component. A plain value: its invariants are evaluated by what is declared below.
struct Escena {
  /// @{ The component of that name in the text.
  std::set<Elemento> elementos;
  std::set<Tipo> tipos;
  std::map<Elemento, Tipo> de_que_tipo;
  std::map<Elemento, Punto> mi_centro;
  std::map<Elemento, Rmas> mi_radio;
  std::map<Elemento, Vector> mi_vector;
  std::map<Elemento, Rmas> mi_altura;
  std::map<Elemento, Rmas> mi_proporcion;
  std::map<Elemento, Vertices> mi_vertices;
  /// @}

  bool operator==(const Escena&) const = default;
};

/// A set of types that is known at compile time, such as { soy_cilindro, soy_cono, soy_tronco }.
class Tipos {
 public:
  /// Of those types.
  constexpr Tipos(std::initializer_list<Tipo> types) {
    for (const Tipo t : types) bits_ |= bit(t);
  }
  /// t ∈ this set.
  constexpr bool contains(Tipo t) const { return (bits_ & bit(t)) != 0; }

 private:
  static constexpr unsigned bit(Tipo t) { return 1U << static_cast<unsigned>(t); }
  unsigned bits_ = 0;
};

/// An attribute that some types have and others lack: what the text says of it, once for all who walk the attributes.
template <class Value, class Input>
struct AttributeSpecification {
  const contract::clause* domain;  ///< the invariant that says which elements have it
  const contract::clause* given;   ///< Con_…: what the general addition asks of the type before it refuses the input;
                                   ///< null where no input is refused
  Tipos types;                     ///< the types that both name
  std::map<Elemento, Value> Escena::*component;  ///< mi_radio and its like
  std::string_view word;                         ///< radio of mi_radio and of radio?
  Input input;                                   ///< input(in) is that input of an addition; no call for one without it
};

/// As the standard deduces them of an aggregate; Clang 16 does not.
template <class Value, class Input>
AttributeSpecification(const contract::clause*, const contract::clause*, Tipos, std::map<Elemento, Value> Escena::*,
                       std::string_view, Input) -> AttributeSpecification<Value, Input>;

/// The attributes of Escena.inv.2 to Escena.inv.6 and Escena.inv.9, in that order.
inline constexpr std::tuple attributes{
    AttributeSpecification{
        &Escena_inv_2, nullptr,
        Tipos{Tipo::soy_esfera, Tipo::soy_cilindro, Tipo::soy_cono, Tipo::soy_tronco, Tipo::soy_plano, Tipo::soy_disco},
        &Escena::mi_centro, "centro", [](auto& in) -> decltype((in.centro)) { return in.centro; }},
    AttributeSpecification{&Escena_inv_3, &Con_Radio_pre_1,
                           Tipos{Tipo::soy_esfera, Tipo::soy_cilindro, Tipo::soy_tronco, Tipo::soy_disco},
                           &Escena::mi_radio, "radio", [](auto& in) -> decltype((in.radio)) { return in.radio; }},
    AttributeSpecification{
        &Escena_inv_4, &Con_Vector_pre_1,
        Tipos{Tipo::soy_cilindro, Tipo::soy_cono, Tipo::soy_tronco, Tipo::soy_plano, Tipo::soy_disco},
        &Escena::mi_vector, "vector", [](auto& in) -> decltype((in.vector)) { return in.vector; }},
    AttributeSpecification{&Escena_inv_5, &Con_Altura_pre_1,
                           Tipos{Tipo::soy_cilindro, Tipo::soy_cono, Tipo::soy_tronco}, &Escena::mi_altura, "altura",
                           [](auto& in) -> decltype((in.altura)) { return in.altura; }},
    AttributeSpecification{&Escena_inv_6, &Con_Proporcion_pre_1, Tipos{Tipo::soy_cono, Tipo::soy_tronco},
                           &Escena::mi_proporcion, "proporcion",
                           [](auto& in) -> decltype((in.proporcion)) { return in.proporcion; }},
    AttributeSpecification{&Escena_inv_9, &Con_Vertices_pre_1, Tipos{Tipo::soy_triangulo}, &Escena::mi_vertices,
                           "vertices", [](auto& in) -> decltype((in.vertices)) { return in.vertices; }}};

/// visit(attribute) for each of them.
template <class Visit>
constexpr void for_each_attribute(Visit&& visit) {
  std::apply([&](const auto&... attribute) { (visit(attribute), ...); }, attributes);
}

/// The attribute that a component holds, such as &Escena::mi_radio.
template <auto component>
constexpr const auto& attribute_of() {
  constexpr std::size_t place = [] {
    std::size_t at = 0, found = std::tuple_size_v<decltype(attributes)>;
    for_each_attribute([&](const auto& attribute) {
      if constexpr (std::is_same_v<decltype(attribute.component), std::remove_const_t<decltype(component)>>)
        if (attribute.component == component) found = at;
      ++at;
    });
    return found;
  }();
  return std::get<place>(attributes);
}

/// Con_Radio and its like: whether the type has the attribute of a component.
template <auto component>
Judgements given(Tipo t) {
  const auto& attribute = attribute_of<component>();
  return {{attribute.given, attribute.types.contains(t)}};
}

/// The empty scene (Init). Its postcondition is checked.
Escena Init();
/// The clauses of Init over its after-state.
Judgements Init_post(const Escena& after);

/// de_que_tipo(e) = t; false where e ∉ dom de_que_tipo. O(log n).
bool is_of_type(const Escena& escena, const Elemento& e, Tipo t);

/// Escena.inv.1 to Escena.inv.9, the domains of all attributes before Escena.inv.7: the whole predicates. O(n) for n
/// elements, and no copy of them.
Judgements inv(const Escena& escena);
/// What Escena.inv.1 to Escena.inv.9 say of one element: e lies on both sides of each equation or on neither, its type
/// is among the types, its vector is an axis. Where e is the only element that changed since the invariant held, and
/// no type was lost, this is the invariant. O(log n).
Judgements inv_at(const Escena& escena, const Elemento& e);

}  // namespace durero::model
