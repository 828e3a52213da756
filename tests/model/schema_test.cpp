#include "durero/model/schema.hpp"

#include <type_traits>

#include "durero/model/type_list.hpp"
#include "support/catch.hpp"

// That the labels of the tables are those of the text, in its order, operations_clauses_test says; what the entries
// mean is violated clause by clause in operaciones_test. Here: that no table forgets a component of Escena.

using namespace durero::model;

namespace {

/// How many entries of a schema's effects are about a component.
template <auto component, class Op>
int effects_on() {
  int count = 0;
  for_each_entry(Op::effects, [&]<class Effect>(const Effect&) {
    if constexpr (std::is_same_v<decltype(Effect::component), const decltype(component)>)
      count += Effect::component == component;
  });
  return count;
}

template <class Op>
void effects_on_every_attribute() {
  INFO(Op::schema);
  CHECK(effects_on<&Escena::mi_centro, Op>() == 1);
  CHECK(effects_on<&Escena::mi_radio, Op>() == 1);
  CHECK(effects_on<&Escena::mi_vector, Op>() == 1);
  CHECK(effects_on<&Escena::mi_altura, Op>() == 1);
  CHECK(effects_on<&Escena::mi_proporcion, Op>() == 1);
}

struct Inputs {
  double radio;
};

}  // namespace

TEST_CASE("each schema says once what becomes of each attribute") {
  for_each_type([]<class Type>(std::type_identity<Type>) {
    effects_on_every_attribute<typename Type::Addition>();
    effects_on_every_attribute<typename Type::Removal>();
  });
}

TEST_CASE("what is required of an input is that it is a member of the set") {
  using Radius = Required<Rmas, Radio_No_Positivo>;
  CHECK(Radius::holds(Inputs{2}));
  CHECK_FALSE(Radius::holds(Inputs{0}));
  CHECK(Radius::input(Inputs{3}) == 3);
}

TEST_CASE("the entries of a table are visited in its order") {
  std::string labels;
  for_each_entry(Agregar_Cono::requirements, [&](const auto& entry) { labels += entry.what->label; });
  CHECK(labels == "Agregar_Cono.pre.2Agregar_Cono.pre.3Agregar_Cono.pre.4");
}
