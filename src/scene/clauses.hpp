#pragma once
/// The clauses of spec/operaciones.tex over the tables of a scene, at the price of what changed.
///
/// Each function hands its clauses to `visit(clause, refusal, holds)`, in the order of the text: the partial operation
/// checks them as contracts, the total one stops at the first that does not hold and gives that answer.

#include <array>
#include <numeric>
#include <optional>

#include "durero/model/operaciones.hpp"
#include "durero/model/operaciones_clauses.hpp"
#include "durero/scene/element_ref.hpp"
#include "durero/scene/shapes.hpp"

namespace durero::scene {

using contract::clause;
using model::Respuesta;
using model::Rmas;
using model::Tipo;
using model::Unitario;

/// What a total operation answers where a clause does not hold; nothing where it does not look, since it hides t?.
using Refusal = std::optional<Respuesta>;
inline constexpr Refusal hidden = std::nullopt;

/// Where the name e? lies before the operation, if anywhere.
using Place = std::optional<ElementRef>;

template <class Visit>
void preconditions(const model::Agregar_Esfera& in, const Place& place, Visit&& visit) {
  visit(model::Agregar_Elemento_pre_1, Respuesta::elemento_ya_existe, [&] { return !place; });
  visit(model::Agregar_Esfera_pre_1, hidden, [&] { return in.t == Tipo::soy_esfera; });
  visit(model::Agregar_Esfera_pre_2, Respuesta::radio_no_positivo, [&] { return Rmas::contains(in.radio); });
}

template <class Visit>
void preconditions(const model::Agregar_Cilindro& in, const Place& place, Visit&& visit) {
  visit(model::Agregar_Elemento_pre_1, Respuesta::elemento_ya_existe, [&] { return !place; });
  visit(model::Agregar_Cilindro_pre_1, hidden, [&] { return in.t == Tipo::soy_cilindro; });
  visit(model::Agregar_Cilindro_pre_2, Respuesta::radio_no_positivo, [&] { return Rmas::contains(in.radio); });
  visit(model::Agregar_Cilindro_pre_3, Respuesta::vector_no_unitario, [&] { return Unitario::contains(in.vector); });
  visit(model::Agregar_Cilindro_pre_4, Respuesta::altura_no_positiva, [&] { return Rmas::contains(in.altura); });
}

template <class Visit>
void preconditions(const model::Agregar_Cono& in, const Place& place, Visit&& visit) {
  visit(model::Agregar_Elemento_pre_1, Respuesta::elemento_ya_existe, [&] { return !place; });
  visit(model::Agregar_Cono_pre_1, hidden, [&] { return in.t == Tipo::soy_cono; });
  visit(model::Agregar_Cono_pre_2, Respuesta::proporcion_no_positiva, [&] { return Rmas::contains(in.proporcion); });
  visit(model::Agregar_Cono_pre_3, Respuesta::vector_no_unitario, [&] { return Unitario::contains(in.vector); });
  visit(model::Agregar_Cono_pre_4, Respuesta::altura_no_positiva, [&] { return Rmas::contains(in.altura); });
}

template <class Visit>
void preconditions_of_removal(const clause& is_of_type, Tipo tipo, const Place& place, Visit&& visit) {
  visit(model::Eliminar_Elemento_pre_1, Respuesta::elemento_no_existe, [&] { return place.has_value(); });
  visit(is_of_type, Respuesta::tipo_incorrecto, [&] { return place && place->tipo == tipo; });
}

template <class Visit>
void preconditions(const model::Eliminar_Esfera&, const Place& place, Visit&& visit) {
  preconditions_of_removal(model::Eliminar_Esfera_pre_1, Tipo::soy_esfera, place, visit);
}

template <class Visit>
void preconditions(const model::Eliminar_Cilindro&, const Place& place, Visit&& visit) {
  preconditions_of_removal(model::Eliminar_Cilindro_pre_1, Tipo::soy_cilindro, place, visit);
}

template <class Visit>
void preconditions(const model::Eliminar_Cono&, const Place& place, Visit&& visit) {
  preconditions_of_removal(model::Eliminar_Cono_pre_1, Tipo::soy_cono, place, visit);
}

/// How many elements there are of each shape, and so how many have each attribute.
class Sizes {
 public:
  template <class SizeOf>
  explicit Sizes(SizeOf size_of) {
    for_each_shape([&]<class Shape>(std::type_identity<Shape> shape) { of_[place_of<Shape>] = size_of(shape); });
  }

  std::size_t elementos() const { return std::accumulate(of_.begin(), of_.end(), std::size_t{0}); }
  std::size_t mi_radio() const { return with<&model::Escena::mi_radio>(); }
  std::size_t mi_vector() const { return with<&model::Escena::mi_vector>(); }
  std::size_t mi_altura() const { return with<&model::Escena::mi_altura>(); }
  std::size_t mi_proporcion() const { return with<&model::Escena::mi_proporcion>(); }

 private:
  template <auto component>
  std::size_t with() const {
    std::size_t sum = 0;
    for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
      if constexpr (has_attribute<Shape, component>()) sum += of_[place_of<Shape>];
    });
    return sum;
  }

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

template <class Visit>
void postconditions(const model::Agregar_Esfera& in, const Added<Sphere>& a, Visit&& visit) {
  visit(model::Agregar_Elemento_post_1, [&] { return a.elementos(); });
  visit(model::Agregar_Elemento_post_2, [&] { return a.de_que_tipo(in.t); });
  visit(model::Agregar_Esfera_post_1, [&] { return a.shape.centro == in.centro.xyz(); });
  visit(model::Agregar_Esfera_post_2, [&] { return a.shape.radio == in.radio; });
  visit(model::Agregar_Esfera_post_3, [&] { return a.after.mi_vector() == a.before.mi_vector(); });
  visit(model::Agregar_Esfera_post_4, [&] { return a.after.mi_altura() == a.before.mi_altura(); });
  visit(model::Agregar_Esfera_post_5, [&] { return a.after.mi_proporcion() == a.before.mi_proporcion(); });
  visit(model::Agregar_Esfera_post_6, [&] { return a.r == Respuesta::esfera_agregada; });
}

template <class Visit>
void postconditions(const model::Agregar_Cilindro& in, const Added<Cylinder>& a, Visit&& visit) {
  visit(model::Agregar_Elemento_post_1, [&] { return a.elementos(); });
  visit(model::Agregar_Elemento_post_2, [&] { return a.de_que_tipo(in.t); });
  visit(model::Agregar_Cilindro_post_1, [&] { return a.shape.centro == in.centro.xyz(); });
  visit(model::Agregar_Cilindro_post_2, [&] { return a.shape.radio == in.radio; });
  visit(model::Agregar_Cilindro_post_3, [&] { return a.shape.vector == in.vector.xyz(); });
  visit(model::Agregar_Cilindro_post_4, [&] { return a.shape.altura == in.altura; });
  visit(model::Agregar_Cilindro_post_5, [&] { return a.after.mi_proporcion() == a.before.mi_proporcion(); });
  visit(model::Agregar_Cilindro_post_6, [&] { return a.r == Respuesta::cilindro_agregado; });
}

template <class Visit>
void postconditions(const model::Agregar_Cono& in, const Added<Cone>& a, Visit&& visit) {
  visit(model::Agregar_Elemento_post_1, [&] { return a.elementos(); });
  visit(model::Agregar_Elemento_post_2, [&] { return a.de_que_tipo(in.t); });
  visit(model::Agregar_Cono_post_1, [&] { return a.shape.centro == in.centro.xyz(); });
  visit(model::Agregar_Cono_post_2, [&] { return a.after.mi_radio() == a.before.mi_radio(); });
  visit(model::Agregar_Cono_post_3, [&] { return a.shape.vector == in.vector.xyz(); });
  visit(model::Agregar_Cono_post_4, [&] { return a.shape.altura == in.altura; });
  visit(model::Agregar_Cono_post_5, [&] { return a.shape.proporcion == in.proporcion; });
  visit(model::Agregar_Cono_post_6, [&] { return a.r == Respuesta::cono_agregado; });
}

/// A removal, done: whether the index still knows e?, and whether the element that was moved into the gap is known at
/// its new place. c' = { e? } ⩤ c lessens the size of c by one where e? was in its domain; c' = c changes no size.
struct Removed {
  Sizes before, after;
  bool known;
  bool moved_is_known;
  Respuesta r;
};

template <class Visit>
void postconditions(const model::Eliminar_Esfera&, const Removed& d, Visit&& visit) {
  visit(model::Eliminar_Elemento_post_1, [&] { return !d.known && d.after.elementos() + 1 == d.before.elementos(); });
  visit(model::Eliminar_Elemento_post_2, [&] { return !d.known && d.moved_is_known; });
  visit(model::Eliminar_Esfera_post_1, [&] { return d.after.elementos() + 1 == d.before.elementos(); });
  visit(model::Eliminar_Esfera_post_2, [&] { return d.after.mi_radio() + 1 == d.before.mi_radio(); });
  visit(model::Eliminar_Esfera_post_3, [&] { return d.after.mi_vector() == d.before.mi_vector(); });
  visit(model::Eliminar_Esfera_post_4, [&] { return d.after.mi_altura() == d.before.mi_altura(); });
  visit(model::Eliminar_Esfera_post_5, [&] { return d.after.mi_proporcion() == d.before.mi_proporcion(); });
  visit(model::Eliminar_Esfera_post_6, [&] { return d.r == Respuesta::esfera_eliminada; });
}

template <class Visit>
void postconditions(const model::Eliminar_Cilindro&, const Removed& d, Visit&& visit) {
  visit(model::Eliminar_Elemento_post_1, [&] { return !d.known && d.after.elementos() + 1 == d.before.elementos(); });
  visit(model::Eliminar_Elemento_post_2, [&] { return !d.known && d.moved_is_known; });
  visit(model::Eliminar_Cilindro_post_1, [&] { return d.after.elementos() + 1 == d.before.elementos(); });
  visit(model::Eliminar_Cilindro_post_2, [&] { return d.after.mi_radio() + 1 == d.before.mi_radio(); });
  visit(model::Eliminar_Cilindro_post_3, [&] { return d.after.mi_vector() + 1 == d.before.mi_vector(); });
  visit(model::Eliminar_Cilindro_post_4, [&] { return d.after.mi_altura() + 1 == d.before.mi_altura(); });
  visit(model::Eliminar_Cilindro_post_5, [&] { return d.after.mi_proporcion() == d.before.mi_proporcion(); });
  visit(model::Eliminar_Cilindro_post_6, [&] { return d.r == Respuesta::cilindro_eliminado; });
}

template <class Visit>
void postconditions(const model::Eliminar_Cono&, const Removed& d, Visit&& visit) {
  visit(model::Eliminar_Elemento_post_1, [&] { return !d.known && d.after.elementos() + 1 == d.before.elementos(); });
  visit(model::Eliminar_Elemento_post_2, [&] { return !d.known && d.moved_is_known; });
  visit(model::Eliminar_Cono_post_1, [&] { return d.after.elementos() + 1 == d.before.elementos(); });
  visit(model::Eliminar_Cono_post_2, [&] { return d.after.mi_radio() == d.before.mi_radio(); });
  visit(model::Eliminar_Cono_post_3, [&] { return d.after.mi_vector() + 1 == d.before.mi_vector(); });
  visit(model::Eliminar_Cono_post_4, [&] { return d.after.mi_altura() + 1 == d.before.mi_altura(); });
  visit(model::Eliminar_Cono_post_5, [&] { return d.after.mi_proporcion() + 1 == d.before.mi_proporcion(); });
  visit(model::Eliminar_Cono_post_6, [&] { return d.r == Respuesta::cono_eliminado; });
}

}  // namespace durero::scene
