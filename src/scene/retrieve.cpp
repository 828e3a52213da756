#include "durero/scene/retrieve.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "durero/model/escena.hpp"
#include "durero/scene/attributes.hpp"

namespace durero::scene {

// The type of a row is that of its table (Retrieve.inv.1), and an attribute what the column has at the row
// (Retrieve.inv.2, Retrieve.inv.3, Retrieve.inv.4, Retrieve.inv.5, Retrieve.inv.6, Retrieve.inv.7).
model::Escena retrieve(const Scene& scene) {
  // In the order of the names, each component grows at its end, which takes no search.
  std::vector<std::pair<model::Elemento, ElementRef>> rows;
  rows.reserve(scene.size());
  scene.for_each([&](ElementRef element, const auto&) { rows.emplace_back(scene.name(element), element); });
  std::ranges::sort(rows, {}, &std::pair<model::Elemento, ElementRef>::first);

  model::Escena escena;
  for (const auto& row : rows) {
    const model::Elemento& e = row.first;
    scene.visit(row.second, [&]<class Shape>(const Shape& shape) {
      escena.elementos.insert(escena.elementos.end(), e);
      escena.tipos.insert(Shape::tipo);
      escena.de_que_tipo.emplace_hint(escena.de_que_tipo.end(), e, Shape::tipo);
      for_each_attribute<Shape, model::Escena>([&]<class TableRow>(const TableRow& attribute) {
        auto& component = escena.*attribute.component;
        component.emplace_hint(component.end(), e, input_of<typename TableRow::Input>(shape.*attribute.field));
      });
    });
  }
  return escena;
}

model::Red red_of(const Mesh& mesh) {
  std::vector<model::Punto> puntos;
  puntos.reserve(mesh.puntos.size());
  for (const glm::dvec3 p : mesh.puntos) puntos.emplace_back(p);
  return model::Red::of(puntos, mesh.caras);
}

model::Mallas retrieve_mallas(const Scene& scene) {
  model::Mallas all{retrieve(scene), {}};
  for (std::size_t i = 0; i < scene.meshes().size(); ++i) {
    const Mesh& mesh = scene.meshes()[i];
    all.mallas.emplace(mesh.m, model::Malla(red_of(mesh)));
  }
  return all;
}

}  // namespace durero::scene
