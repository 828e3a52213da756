#pragma once
/// What the table of a shape's attributes says, and what an addition of the shape makes of it.

#include <string>
#include <string_view>
#include <vector>

#include "durero/model/operaciones.hpp"
#include "durero/scene/addition.hpp"
#include "durero/scene/shape/attribute.hpp"

namespace durero::test {

/// The words of the attributes, in order.
template <class Shape>
std::vector<std::string_view> words() {
  std::vector<std::string_view> all;
  scene::for_each_attribute<Shape>([&](const auto& attribute) { all.push_back(attribute.word); });
  return all;
}

/// Whether the scene of the specification, once the shape is added to it, holds what each attribute stores, in the
/// component of its row; and whether the geometry of the addition is the shape.
template <class Shape>
bool is_what_its_addition_adds(const Shape& shape) {
  const model::Elemento e("e");
  const typename Shape::Addition in = scene::addition(e, shape);
  model::Escena escena = model::Init();
  model::apply(escena, in);
  const Shape again = scene::shape_of<Shape>(in);
  bool is = in.e == e && escena.de_que_tipo.at(e) == Shape::tipo;
  scene::for_each_attribute<Shape, model::Escena>([&]<class TableRow>(const TableRow& attribute) {
    const auto& value = (escena.*attribute.component).at(e);
    using Value = std::remove_cvref_t<decltype(value)>;
    is = is && value == Value(scene::input_of<typename TableRow::Input>(shape.*attribute.field)) &&
         again.*attribute.field == shape.*attribute.field;
  });
  return is;
}

}  // namespace durero::test
