#include "durero/scene/addition.hpp"

#include <vector>

#include "durero/scene/shapes.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::scene;

TEST_CASE("the inputs of a shape's addition are its attributes, each of the type that stands for it without one") {
  for_each_shape([]<class Shape>(std::type_identity<Shape>) {
    std::vector<std::string_view> words, of_inputs;
    for_each_attribute<Shape>([&](const auto& attribute) { words.push_back(attribute.word); });
    for_each_input<Shape>([&](const auto& attribute) { of_inputs.push_back(attribute.word); });
    CHECK(words == of_inputs);
    const auto alike = []<class... TableRow, class... Input>(const std::tuple<TableRow...>&,
                                                             const std::tuple<Input...>&) {
      return (std::is_same_v<typename TableRow::Input, typename Input::Input> && ...);
    };
    CHECK(alike(attributes_of<Shape>, inputs_of<Shape>));
  });
}

TEST_CASE("an addition holds the geometry in its own inputs, and gives it back") {
  const Disc disc{{1, 2, 3}, 4, {0, 0, 1}};
  const model::Agregar_Disco in = addition(model::Elemento("d"), disc);
  CHECK(in.e.name() == "d");
  CHECK(in.centro.xyz() == disc.centro);
  CHECK(in.radio == 4);
  CHECK(in.vector.xyz() == disc.vector);
  const Disc again = shape_of<Disc>(in);
  CHECK(again.centro == disc.centro);
  CHECK(again.radio == disc.radio);
  CHECK(again.vector == disc.vector);
}
