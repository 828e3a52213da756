#pragma once
/// The clauses of spec/operaciones.tex, and of the changes of spec/historia.tex, over the tables of a scene, at the
/// price of what changed.
///
/// Each function hands its clauses to `visit(clause, refusal, holds)`, in the order of the text: the partial operation
/// checks them as contracts, the total one stops at the first that does not hold and gives that answer.

#include <array>
#include <numeric>
#include <optional>

#include "durero/model/cambio.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/model/operaciones_clauses.hpp"
#include "durero/scene/addition.hpp"
#include "durero/scene/element_ref.hpp"
#include "durero/scene/shapes.hpp"

namespace durero::scene {

using contract::clause;
using model::Respuesta;
using model::Tipo;

/// What a total operation answers where a clause does not hold; nothing where it does not look, since it hides t?.
using Refusal = std::optional<Respuesta>;
inline constexpr Refusal hidden = std::nullopt;

/// Where the name e? lies before the operation, if anywhere.
using Place = std::optional<ElementRef>;

/// The index knows the name (Elemento_Ya_Existe_Tablas.def.1), or an input is not what the type asks for:
/// Radio_No_Positivo_Tablas.def.1, Vector_No_Unitario_Tablas.def.1, Altura_No_Positiva_Tablas.def.1,
/// Proporcion_No_Positiva_Tablas.def.1, Vertices_Alineados_Tablas.def.1.
template <model::AdditionOfType Op, class Visit>
void preconditions(const Op& in, const Place& place, Visit&& visit) {
  visit(model::Agregar_Elemento_pre_1, Respuesta::elemento_ya_existe, [&] { return !place; });
  visit(*Op::is_of_type, hidden, [&] { return in.t == Op::tipo; });
  model::for_each_entry(Op::requirements, [&]<class Entry>(const Entry& required) {
    visit(*required.what, Entry::Denial::answer, [&] { return required.holds(in); });
  });
}

/// The index does not know the name (Elemento_No_Existe_Tablas.def.1), or its row lies in the table of another type
/// (De_Otra_Tabla.def.1).
template <model::RemovalOfType Op, class Visit>
void preconditions(const Op&, const Place& place, Visit&& visit) {
  visit(model::Eliminar_Elemento_pre_1, Respuesta::elemento_no_existe, [&] { return place.has_value(); });
  visit(*Op::is_of_type, Respuesta::tipo_incorrecto, [&] { return place && place->tipo == Op::tipo; });
}

/// A change of an attribute.
template <class Op>
concept ChangeOfAttribute = requires { Op::has_attribute; };

/// Of a change. A body has no attributes, though it stands as a sphere.
template <ChangeOfAttribute Op, class Visit>
void preconditions(const Op& in, const Place& place, bool is_body, Visit&& visit) {
  visit(model::Cambiar_Elemento_pre_1, Respuesta::elemento_no_existe, [&] { return place.has_value(); });
  if (in.of_type)
    visit(model::of_type_clause(*in.of_type), Respuesta::tipo_incorrecto,
          [&] { return place && !is_body && place->tipo == *in.of_type; });
  visit(*Op::has_attribute, Respuesta::tipo_incorrecto,
        [&] { return place && !is_body && model::attribute_of<Op::component>().types.contains(place->tipo); });
  model::for_each_entry(Op::requirements, [&]<class Entry>(const Entry& required) {
    visit(*required.what, Entry::Denial::answer, [&] { return required.holds(in); });
  });
}

/// How many elements there are of each shape, and so how many have each attribute.
class Sizes {
 public:
  template <class SizeOf>
  explicit Sizes(SizeOf size_of) {
    for_each_shape([&]<class Shape>(std::type_identity<Shape> shape) { of_[place_of<Shape>] = size_of(shape); });
  }

  std::size_t elementos() const { return std::accumulate(of_.begin(), of_.end(), std::size_t{0}); }
  /// The size of a component, such as &Escena::mi_radio.
  template <auto component>
  std::size_t with() const {
    std::size_t sum = 0;
    for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
      if constexpr (has_attribute<Shape, component>()) sum += of_[place_of<Shape>];
    });
    return sum;
  }

 private:
  std::array<std::size_t, shape_count> of_{};
};

/// An addition, done: the sizes of before and after, the place that e? was given and the one the index now tells, and
/// the row that lies there. c' = c ∪ { e? ↦ x } changes the size of c by one and maps e? to x; c' = c no size.
template <class Shape>
struct Added {
  Sizes before, after;
  ElementRef row;
  Place place;
  const Shape& shape;
  Respuesta r;

  bool elementos() const { return place == row && after.elementos() == before.elementos() + 1; }
  bool de_que_tipo(Tipo t) const { return place && place->tipo == t; }
};

template <auto component, auto input>
bool has_effect(const model::Joined<component, input>&, const auto& in, const auto& done) {
  return attribute_value<component>(done.shape) == stored(in.*input);
}
template <auto component>
bool has_effect(const model::Kept<component>&, const auto&, const auto& done) {
  return done.after.template with<component>() == done.before.template with<component>();
}
template <auto component>
bool has_effect(const model::Dropped<component>&, const auto&, const auto& done) {
  return done.after.template with<component>() + 1 == done.before.template with<component>();
}

template <class Op, class Shape, class Visit>
void postconditions(const Op& in, const Added<Shape>& a, Visit&& visit) {
  visit(model::Agregar_Elemento_post_1, [&] { return a.elementos(); });
  visit(model::Agregar_Elemento_post_2, [&] { return a.de_que_tipo(in.t); });
  model::postconditions_of_type(in, a, a.r, visit);
}

/// A removal, done: whether the index still knows e?, and whether the element that was moved into the gap is known at
/// its new place. c' = { e? } ⩤ c lessens the size of c by one where e? was in its domain; c' = c changes no size.
struct Removed {
  Sizes before, after;
  bool known;
  bool moved_is_known;
  Respuesta r;
};

template <class Op, class Visit>
void postconditions(const Op& in, const Removed& d, Visit&& visit) {
  visit(model::Eliminar_Elemento_post_1, [&] { return !d.known && d.after.elementos() + 1 == d.before.elementos(); });
  visit(model::Eliminar_Elemento_post_2, [&] { return !d.known && d.moved_is_known; });
  model::postconditions_of_type(in, d, d.r, visit);
}

/// A change, done: the sizes of before and after, the place that e? had and the one the index now tells, and the row of
/// before and after. c' = c changes neither the size of c nor the value of the row.
template <class Shape>
struct Changed {
  Sizes before, after;
  ElementRef row;
  Place place;
  const Shape &old, &shape;
};

template <auto component, auto input, class Shape>
bool has_effect(const model::Replaced<component, input>&, const auto& in, const Changed<Shape>& done) {
  if constexpr (has_attribute<Shape, component>())
    return attribute_value<component>(done.shape) == stored(in.*input);
  else
    return false;
}
template <auto component, class Shape>
bool has_effect(const model::Kept<component>&, const auto&, const Changed<Shape>& done) {
  if (done.after.template with<component>() != done.before.template with<component>()) return false;
  if constexpr (has_attribute<Shape, component>())
    return attribute_value<component>(done.shape) == attribute_value<component>(done.old);
  else
    return true;
}

template <class Op, class Shape, class Visit>
void postconditions(const Op& in, const Changed<Shape>& c, Respuesta r, Visit&& visit) {
  visit(model::Cambiar_Elemento_post_1, [&] { return c.place && c.after.elementos() == c.before.elementos(); });
  visit(model::Cambiar_Elemento_post_2, [&] { return c.place == c.row; });
  model::for_each_entry(Op::effects,
                        [&](const auto& effect) { visit(*effect.what, [&] { return has_effect(effect, in, c); }); });
  visit(model::Cambiar_Elemento_post_3, [&] { return r == model::change_answer; });
}

}  // namespace durero::scene
