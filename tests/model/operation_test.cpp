#include "durero/model/operation.hpp"

#include <string>
#include <vector>

#include "durero/model/operaciones.hpp"
#include "support/catch.hpp"

using namespace durero::model;

TEST_CASE("an operation is the addition or the removal of some type, in order, or the general one of either kind") {
  const auto schemas = []<class... Op>(std::type_identity<std::variant<Op...>>) {
    return std::vector<std::string>{std::string(Op::schema)...};
  }(std::type_identity<Operation>());
  std::vector<std::string> expected;
  for_each_type([&]<class Type>(std::type_identity<Type>) { expected.emplace_back(Type::Addition::schema); });
  expected.emplace_back("Elemento_Agregado");
  for_each_type([&]<class Type>(std::type_identity<Type>) { expected.emplace_back(Type::Removal::schema); });
  expected.emplace_back("Elemento_Eliminado");
  CHECK(schemas == expected);
}
