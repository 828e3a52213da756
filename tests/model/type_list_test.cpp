#include "durero/model/type_list.hpp"

#include <vector>

#include "support/catch.hpp"

using namespace durero::model;

TEST_CASE("the list visits every type once, in the order of Tipo") {
  std::vector<Tipo> visited;
  for_each_type([&]<class Type>(std::type_identity<Type>) { visited.push_back(Type::tipo); });
  REQUIRE(visited.size() == tipo_count);
  for (std::size_t i = 0; i < tipo_count; ++i) CHECK(visited[i] == Tipo(i));
}

TEST_CASE("the type of an element is visited, and no other") {
  for (std::size_t i = 0; i < tipo_count; ++i)
    CHECK(with_type(Tipo(i), []<class Type>(std::type_identity<Type>) { return Type::tipo; }) == Tipo(i));
}

TEST_CASE("the names of the schemas of a type end in the name of the type") {
  for_each_type([]<class Type>(std::type_identity<Type>) {
    const std::string_view of = name(Type::tipo).substr(std::string_view("soy_").size());
    for (const std::string_view schema : {Type::Addition::schema, Type::Removal::schema}) {
      std::string lower(schema.substr(schema.rfind('_') + 1));
      lower.front() = static_cast<char>(lower.front() - 'A' + 'a');
      CHECK(lower == of);
    }
    CHECK(Type::Addition::total == std::string(Type::Addition::schema) + "_Total");
    CHECK(Type::Removal::total == std::string(Type::Removal::schema) + "_Total");
  });
}
