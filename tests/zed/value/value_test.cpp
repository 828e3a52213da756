#include "durero/zed/value/value.hpp"

#include "support/catch.hpp"

namespace durero::zed {
namespace {

Value atom(const char* text, std::uint32_t order = 0) { return Value::atom("T", text, order); }

const Name x{"x", ""}, y{"y", ""}, z{"z", ""};

TEST_CASE("a value that says nothing is undefined, and so is what is made of it") {
  const Value undefined;
  CHECK(undefined.is_undefined());
  CHECK(Value::pair(undefined, Real(1)).is_undefined());
  CHECK(Value::tuple({Real(1), Real(2), undefined}).is_undefined());
  CHECK(Value::binding(signature({x}), {undefined}).is_undefined());
  CHECK(Value::set({Real(1), undefined}).is_undefined());
  CHECK_FALSE(Value::pair(Real(1), Real(2)).is_undefined());
}

TEST_CASE("a set has its members sorted, each once") {
  const Value set = Value::set({Real(3), Real(1), Real(2), Real(1)});
  REQUIRE(set.set());
  const std::vector<Value>* members = set.set()->members();
  REQUIRE(members);
  REQUIRE(members->size() == 3);
  CHECK(same((*members)[0], Real(1)));
  CHECK(same((*members)[2], Real(3)));
  CHECK(same(set, Value::set({Real(1), Real(2), Real(3)})));
  CHECK_FALSE(same(set, Value::set({Real(1), Real(2)})));
}

TEST_CASE("a set of what is not given is itself not given") {
  CHECK(Value::set({Real(1), Open{}}).is_open());
  CHECK(Value::set({Value::pair(Real(1), Unknown{7})}).is_open());
  CHECK(has_open(Value::pair(Real(1), Open{})));
  CHECK(has_open(Value::line(Real(1), Real(2), Unknown{7})));
  CHECK_FALSE(has_open(Value::pair(Real(1), Value::set({}))));
}

TEST_CASE("constants are in the order of their places, members of a given set in that of their names") {
  CHECK((compare(atom("b", 0), atom("a", 1)) < 0));
  CHECK((compare(atom("a"), atom("b")) < 0));
  CHECK((compare(atom("a"), atom("ab")) < 0));
  CHECK((compare(atom("abcdefgh"), atom("abcdefghi")) < 0));
  CHECK((compare(atom("abcdefghj"), atom("abcdefghi")) > 0));
  CHECK(same(atom("abcdefghi"), atom("abcdefghi")));
}

TEST_CASE("numbers, tuples and bindings are compared part by part") {
  CHECK((compare(Real(1), Real(2)) < 0));
  CHECK((compare(Value::pair(Real(1), Real(9)), Value::pair(Real(2), Real(0))) < 0));
  CHECK((compare(Value::pair(Real(2), Real(1)), Value::pair(Real(2), Real(0))) > 0));
  const Signature names = signature({x, y});
  const auto binding = [&](int a, int b) { return Value::binding(names, {Real(a), Real(b)}); };
  CHECK((compare(binding(1, 9), binding(2, 0)) < 0));
  CHECK(same(binding(1, 9), Value::binding(signature({x, y}), {Real(1), Real(9)})));
  CHECK_THROWS_AS(compare(binding(1, 9), Value::binding(signature({x, z}), {Real(1), Real(9)})), EvaluationError);
}

TEST_CASE("a binding has its components by name") {
  const Value point = Value::point(signature({z, x, y}), Real(1), Real(2), Real(3));
  REQUIRE(point.binding());
  CHECK(*point.binding()->names == std::vector<Name>{x, y, z});
  CHECK(same(*point.binding()->component(x), Real(1)));
  CHECK(same(*point.binding()->component(z), Real(3)));
  CHECK(point.binding()->component({"x", "'"}) == nullptr);
}

TEST_CASE("a line without slope is its constant") {
  CHECK(same(Value::line(Real(5), Real(0), Unknown{1}), Real(5)));
  const Value line = Value::line(Real(5), Real(2), Unknown{1});
  REQUIRE(line.get<PolynomialPtr>());
  CHECK((*line.get<PolynomialPtr>())->unknown == 1);
  CHECK((*line.get<PolynomialPtr>())->slope == Real(2));
}

TEST_CASE("a value is of one form") {
  const Value pair = Value::pair(Real(1), Real(2));
  CHECK(pair.tuple()->parts.size() == 2);
  CHECK(pair.real() == nullptr);
  CHECK(pair.set() == nullptr);
  CHECK(pair.binding() == nullptr);
  CHECK(*Value(Real(3)).real() == Real(3));
  CHECK(Value(Open{}).is_open());
}

TEST_CASE("a value is written in Z notation, a set of pairs as a function") {
  CHECK(Value::set({}).text() == "∅");
  CHECK(Value::set({atom("b"), atom("a")}).text() == "{a, b}");
  CHECK(Value::set({Value::pair(atom("a"), Real(1))}).text() == "{a ↦ 1}");
  CHECK(Value::tuple({Real(1), Real(2), Real(3)}).text() == "(1, 2, 3)");
  CHECK(Value::binding(signature({x, y}), {Real(1), atom("a")}).text() == "⦉x == 1, y == a⦊");
  CHECK(Value::set({atom("a")}).text([](const AtomName& name) { return name.type + "." + name.text; }) == "{T.a}");
}

}  // namespace
}  // namespace durero::zed
