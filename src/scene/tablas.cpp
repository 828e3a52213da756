#include "durero/scene/tablas.hpp"

#include <type_traits>

#include "durero/scene/attributes.hpp"

namespace durero::scene {

Tablas tablas(const Scene& scene) {
  Tablas tables;
  for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    tables.cuantos.emplace(Shape::tipo, static_cast<std::uint32_t>(scene.singles<Shape>().size()));
  });
  scene.for_each_single([&]<class Shape>(ElementRef place, const Shape& shape) {
    const model::Elemento e = scene.name(place);
    tables.nombres.emplace(place, e);
    if (const auto known = scene.find(e.name())) tables.lugar.emplace(e, *known);
    for_each_attribute<Shape, model::Escena>([&]<class TableRow>(const TableRow& attribute) {
      for_each_column([&](const auto& column) {
        if constexpr (std::is_same_v<decltype(column.component), decltype(attribute.component)>)
          if (column.component == attribute.component)
            (tables.*column.values).emplace(place, input_of<typename TableRow::Input>(shape.*attribute.field));
      });
    });
  });
  return tables;
}

}  // namespace durero::scene
