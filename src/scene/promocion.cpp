#include "durero/scene/promocion.hpp"

#include <type_traits>

#include "durero/model/operaciones.hpp"
#include "durero/model/operaciones_clauses.hpp"
#include "durero/scene/addition.hpp"
#include "durero/scene/attributes.hpp"

namespace durero::scene {
namespace {

using Answered = std::optional<model::Respuesta>;

/// Una_Forma.def.1 after the operation on it: the shape that the inputs make, if they are what its type asks for.
/// Nueva_Esfera.def.1, Nuevo_Cilindro.def.1, Nuevo_Cono.def.1, Nuevo_Tronco.def.1, Nuevo_Plano.def.1,
/// Nuevo_Disco.def.1, Nuevo_Triangulo.def.1.
template <model::AdditionOfType Op>
std::optional<AnyShape> new_shape(const Op& in) {
  bool admitted = true;
  model::for_each_entry(Op::requirements, [&](const auto& required) { admitted = admitted && required.holds(in); });
  if (!admitted) return std::nullopt;
  return shape_of<ShapeAddedBy<Op>>(in);
}

/// Whether the removal is of such a shape: Vieja_Esfera.def.1, Viejo_Cilindro.def.1, Viejo_Cono.def.1,
/// Viejo_Tronco.def.1, Viejo_Plano.def.1, Viejo_Disco.def.1, Viejo_Triangulo.def.1.
template <model::RemovalOfType Op>
bool is_of_type(const AnyShape& shape) {
  return std::visit([]<class Shape>(const Shape&) { return Shape::tipo == Op::tipo; }, shape);  // tipo_de.def.1
}

/// Marco_Agregar.def.1: a new shape gets a name that is not in use. So each is lifted: Agregar_Esfera_Formas.def.1,
/// Agregar_Cilindro_Formas.def.1, Agregar_Cono_Formas.def.1, Agregar_Tronco_Formas.def.1, Agregar_Plano_Formas.def.1,
/// Agregar_Disco_Formas.def.1, Agregar_Triangulo_Formas.def.1.
template <model::AdditionOfType Op>
Answered lifted(Formas& formas, const Op& in) {
  const std::optional<AnyShape> shape = new_shape(in);
  if (!shape || !formas.forma.try_emplace(in.e, *shape).second) return std::nullopt;
  return in.answer;
}

/// Marco_Eliminar.def.1: an old shape loses its name. So each is lifted: Eliminar_Esfera_Formas.def.1,
/// Eliminar_Cilindro_Formas.def.1, Eliminar_Cono_Formas.def.1, Eliminar_Tronco_Formas.def.1,
/// Eliminar_Plano_Formas.def.1, Eliminar_Disco_Formas.def.1, Eliminar_Triangulo_Formas.def.1.
template <model::RemovalOfType Op>
Answered lifted(Formas& formas, const Op& in) {
  const auto found = formas.forma.find(in.e);
  if (found == formas.forma.end() || !is_of_type<Op>(found->second)) return std::nullopt;
  formas.forma.erase(found);
  return in.answer;
}

Answered lifted(Formas& formas, const model::Agregar_Elemento& in) {
  const Answered done = std::visit([&](const auto& addition) { return lifted(formas, addition); }, specific(in));
  return done ? Answered(in.answer) : std::nullopt;
}

Answered lifted(Formas& formas, const model::Eliminar_Elemento& in) {
  return formas.forma.erase(in.e) == 0 ? std::nullopt : Answered(in.answer);
}

}  // namespace

Formas formas(const Scene& scene) {
  Formas found;
  scene.for_each_single(
      [&](ElementRef place, const auto& shape) { found.forma.emplace(scene.name(place), AnyShape(shape)); });
  return found;
}

// A shape has the attributes of its type: centro_de.def.1, radio_de.def.1, vector_de.def.1, altura_de.def.1,
// proporcion_de.def.1, vertices_de.def.1; and each is its field: centro_de.def.2, radio_de.def.2, vector_de.def.2,
// altura_de.def.2, proporcion_de.def.2, vertices_de.def.2.
model::Escena retrieve(const Formas& formas) {
  model::Escena escena;
  for (const auto& [name, any] : formas.forma) {
    const model::Elemento& e = name;
    std::visit(
        [&]<class Shape>(const Shape& shape) {
          escena.elementos.insert(e);
          escena.tipos.insert(Shape::tipo);
          escena.de_que_tipo.emplace(e, Shape::tipo);
          for_each_attribute<Shape, model::Escena>([&]<class TableRow>(const TableRow& attribute) {
            (escena.*attribute.component).emplace(e, input_of<typename TableRow::Input>(shape.*attribute.field));
          });
        },
        any);
  }
  return escena;
}

std::optional<model::Respuesta> apply_lifted(Formas& formas, const model::Operation& operation) {
  return std::visit([&](const auto& in) { return lifted(formas, in); }, operation);
}

}  // namespace durero::scene
