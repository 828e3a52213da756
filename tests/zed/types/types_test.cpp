#include "durero/zed/types/types.hpp"

#include "support/catch.hpp"

namespace durero::zed {
namespace {

const Type a = Type::given({"A", ""}), b = Type::given({"B", ""});
const Name x{"x", ""}, y{"y", ""}, z{"z", ""};

TEST_CASE("a type is written in Z notation, in parentheses where they are needed") {
  CHECK(a.text() == "A");
  CHECK(Type::power(Type::product({a, Type::power(b)})).text() == "ℙ (A × ℙ B)");
  CHECK(Type::product({Type::product({a, b}), a}).text() == "(A × B) × A");
  CHECK(Type::power(Type::schema({{y, b}, {x, a}})).text() == "ℙ [x : A; y : B]");
  CHECK(Type::power(Type::variable()).text() == "ℙ ?");
}

TEST_CASE("a long type is cut where it is asked for, and written in full where that is") {
  Type chain = a;
  for (int i = 0; i < 60; ++i) chain = Type::power(chain);
  CHECK(chain.text().ends_with("…"));
  const std::string full = chain.text(Type::max_size);
  CHECK(full.ends_with("ℙ A"));
  CHECK(full.size() == 60 * std::string("ℙ ").size() + 1);
  CHECK(Type::product({a, b}).text(2) == "A × …");
}

TEST_CASE("the components of a schema type are found by their names, in any order of declaration") {
  const Type schema = Type::schema({{z, b}, {x, a}, {y, Type::power(a)}});
  CHECK(schema.fields() == std::vector<Name>{x, y, z});
  REQUIRE(schema.field(z));
  CHECK(schema.field(z)->text() == "B");
  CHECK_FALSE(schema.field({"x", "'"}));
  CHECK(Type::power(schema).is_schema_set());
  CHECK_FALSE(schema.is_schema_set());
  CHECK_FALSE(Type::power(a).is_schema_set());
}

TEST_CASE("types that can be made equal are, by determining their variables") {
  const Type left = Type::variable(), right = Type::variable();
  CHECK(unify(Type::product({left, Type::power(right)}), Type::product({Type::power(right), Type::power(b)})));
  CHECK(left.text() == "ℙ B");
  CHECK(right.text() == "B");
  CHECK(unify(Type::unknown(), a));
  CHECK(unify(Type::schema({{x, a}, {y, b}}), Type::schema({{y, b}, {x, a}})));
}

TEST_CASE("types that cannot be made equal are not") {
  CHECK_FALSE(unify(a, b));
  CHECK_FALSE(unify(Type::power(a), Type::product({a, b})));
  CHECK_FALSE(unify(Type::product({a, b}), Type::product({a, b, a})));
  CHECK_FALSE(unify(Type::schema({{x, a}}), Type::schema({{y, a}})));
  const Type variable = Type::variable();
  CHECK_FALSE(unify(variable, Type::power(variable)));
  CHECK(unify(variable, a));
  CHECK_FALSE(unify(variable, b));
}

TEST_CASE("what is not determined, and what is not known, are told apart") {
  const Type variable = Type::variable();
  const Type set = Type::power(Type::product({a, variable}));
  CHECK(set.has_variables());
  CHECK_FALSE(set.is_known());
  CHECK(set.settled().text() == "ℙ (A × ?)");
  CHECK_FALSE(set.settled().has_variables());
  CHECK_FALSE(set.settled().is_known());
  REQUIRE(unify(variable, b));
  CHECK_FALSE(set.has_variables());
  CHECK(set.is_known());
  CHECK(set.settled().text() == "ℙ (A × B)");
  CHECK_FALSE(Type::power(Type::formal(x)).is_known());
}

TEST_CASE("actuals are put for formals, and for nothing else") {
  const Type generic = Type::power(Type::product({Type::formal(x), Type::power(Type::formal(y)), a}));
  CHECK(generic.substitute({x, y}, {b, Type::power(a)}).text() == "ℙ (B × ℙ ℙ A × A)");
  CHECK(generic.substitute({x}, {b}).text() == "ℙ (B × ℙ y × A)");
  CHECK(Type::power(a).substitute({{"A", ""}}, {b}).text() == "ℙ A");
}

TEST_CASE("a type knows its size and its depth, and one that is too large written out is unknown") {
  const Type type = Type::product({a, Type::power(Type::product({a, b}))});
  CHECK(type.size() == 6);
  CHECK(type.depth() == 4);
  const Type variable = Type::variable();
  Type doubled = variable;
  for (int i = 0; i < 20; ++i) doubled = Type::product({doubled, doubled});
  CHECK(doubled.size() == Type::max_size + 1);
  CHECK(doubled.settled().is(Type::Kind::unknown));
}

}  // namespace
}  // namespace durero::zed
