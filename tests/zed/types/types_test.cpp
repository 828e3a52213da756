#include "durero/zed/types/types.hpp"

#include "support/catch.hpp"

namespace durero::zed {
namespace {

const Name x{"x", ""}, y{"y", ""}, X{"X", ""}, Y{"Y", ""};

Type A() { return Type::given({"A", ""}); }
Type B() { return Type::given({"B", ""}); }
Type pair(const Type& a, const Type& b) { return Type::product({a, b}); }

TEST_CASE("a type is of one kind, and has its parts") {
  CHECK(A().is(Type::Kind::given));
  CHECK(A().name() == Name{"A", ""});
  CHECK(Type::power(A()).parts()[0].name() == Name{"A", ""});
  CHECK(pair(A(), B()).parts()[1].name() == Name{"B", ""});
  CHECK(Type::power(Type::schema({{x, A()}})).is_schema_set());
  CHECK_FALSE(Type::power(A()).is_schema_set());
  CHECK_FALSE(Type::schema({{x, A()}}).is_schema_set());
}

TEST_CASE("the components of a schema type are found by their names, in whatever order they came") {
  const Type schema = Type::schema({{y, B()}, {x, A()}});
  CHECK(schema.fields() == std::vector<Name>{x, y});
  REQUIRE(schema.field(x));
  CHECK(schema.field(x)->name() == Name{"A", ""});
  CHECK(schema.field(y)->name() == Name{"B", ""});
  CHECK(schema.field({"x", "'"}) == nullptr);
  CHECK(unify(schema, Type::schema({{x, A()}, {y, B()}})));
}

TEST_CASE("a type is written in Z notation") {
  CHECK(Type::power(pair(A(), Type::power(B()))).text() == "ℙ (A × ℙ B)");
  CHECK(pair(pair(A(), B()), A()).text() == "(A × B) × A");
  CHECK(Type::schema({{y, B()}, {x, A()}}).text() == "[x : A; y : B]");
  CHECK(pair(Type::variable(), Type::formal(X)).text() == "? × X");
  Type large = A();
  for (int i = 0; i < 50; ++i) large = Type::power(large);
  CHECK(large.text().ends_with("ℙ …"));
}

TEST_CASE("two types are made equal by what their variables are") {
  const Type v = Type::variable(), w = Type::variable();
  CHECK(unify(pair(v, B()), pair(Type::power(A()), w)));
  CHECK(v.text() == "ℙ A");
  CHECK(w.text() == "B");
  CHECK_FALSE(unify(v, B()));
  CHECK_FALSE(unify(A(), B()));
  CHECK_FALSE(unify(A(), Type::power(A())));
  CHECK_FALSE(unify(pair(A(), B()), Type::product({A(), B(), A()})));
  CHECK_FALSE(unify(Type::schema({{x, A()}}), Type::schema({{y, A()}})));
  CHECK_FALSE(unify(Type::given(X), Type::formal(X)));
}

TEST_CASE("variables that are equal are found to be one thing, in any order") {
  const Type a = Type::variable(), b = Type::variable(), c = Type::variable();
  CHECK(unify(a, b));
  CHECK(unify(c, b));
  CHECK(unify(a, A()));
  CHECK(c.text() == "A");
  CHECK_FALSE(unify(c, B()));
}

TEST_CASE("no type is a part of itself; what is unknown is equal to every type") {
  const Type v = Type::variable();
  CHECK_FALSE(unify(v, Type::power(v)));
  CHECK(unify(v, v));
  CHECK(unify(Type::unknown(), Type::power(A())));
  CHECK(unify(A(), Type::unknown()));
}

TEST_CASE("a settled type has no variables: what is not determined is unknown") {
  const Type v = Type::variable(), w = Type::variable(), type = pair(v, Type::power(w));
  CHECK(type.has_variables());
  CHECK(unify(v, A()));
  CHECK(type.has_variables());
  const Type settled = type.settled();
  CHECK_FALSE(settled.has_variables());
  CHECK(settled.text() == "A × ℙ ?");
  CHECK(settled.parts()[1].parts()[0].is(Type::Kind::unknown));
  CHECK_FALSE(pair(A(), Type::unknown()).has_variables());
}

TEST_CASE("the size of a type saturates beyond the limit, and what is larger settles to unknown") {
  CHECK(A().size() == 1);
  CHECK(pair(A(), Type::power(B())).size() == 4);
  CHECK(pair(A(), Type::power(B())).depth() == 3);
  Type doubled = A();
  for (int i = 0; i < 64; ++i) doubled = pair(doubled, doubled);
  CHECK(doubled.size() == Type::max_size + 1);
  CHECK(doubled.depth() == 65);
  CHECK(doubled.settled().is(Type::Kind::unknown));
}

TEST_CASE("types are put for formals, and for no others") {
  const Type type = pair(Type::formal(X), Type::power(Type::formal(Y)));
  CHECK(type.substitute({X, Y}, {A(), B()}).text() == "A × ℙ B");
  CHECK(type.substitute({Y}, {A()}).text() == "X × ℙ A");
  CHECK(Type::given(X).substitute({X}, {A()}).text() == "X");
  CHECK(type.text() == "X × ℙ Y");
}

}  // namespace
}  // namespace durero::zed
