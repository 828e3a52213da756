#include "durero/zed/value/value.hpp"

#include "support/catch.hpp"
#include "zed/value/context.hpp"

namespace durero::zed {
namespace {

const Name x{"x", ""}, y{"y", ""}, z{"z", ""};
const Type number = Type::given({"𝔸", ""}), color = Type::given({"Color", ""});

Value red() { return Value::atom("Color", "red", 0); }
Value blue() { return Value::atom("Color", "blue", 1); }
Value set_of(std::initializer_list<Value> members) { return Value::set(members); }

TEST_CASE("a set has each member once, in one order") {
  const Value set = set_of({Real(3), Real(1), Real(2), Real(1)});
  REQUIRE(set.set()->members());
  CHECK(set.text() == "{1, 2, 3}");
  CHECK(same(set, set_of({Real(1), Real(2), Real(3)})));
  CHECK_FALSE(same(set, set_of({Real(1), Real(2)})));
  CHECK(set_of({blue(), red()}).text() == "{red, blue}");  // in the order of the free type
  CHECK(set_of({Value::atom("T", "b"), Value::atom("T", "a"), Value::atom("T", "a long name")}).text() ==
        "{a, a long name, b}");
}

TEST_CASE("values of one type are ordered by their structure") {
  const auto ascend = [](const Value& a, const Value& b) {
    CAPTURE(a.text(), b.text());
    CHECK((compare(a, b) < 0));
    CHECK((compare(b, a) > 0));
    CHECK(same(a, a));
  };
  ascend(Real(-1), Real(0.5));
  ascend(red(), blue());
  ascend(Value::pair(Real(1), Real(9)), Value::pair(Real(2), Real(0)));
  ascend(Value::pair(Real(1), Real(0)), Value::pair(Real(1), Real(1)));
  ascend(set_of({}), set_of({Real(0)}));
  ascend(set_of({Real(7)}), set_of({Real(1), Real(2)}));
  const Signature names = signature({y, x});
  ascend(Value::binding(names, {Real(1), Real(2)}), Value::binding(names, {Real(1), Real(3)}));
  CHECK_THROWS_AS(
      compare(Value::binding(names, {Real(1), Real(2)}), Value::binding(signature({x, z}), {Real(1), Real(2)})),
      EvaluationError);
}

TEST_CASE("what has an undefined part is undefined, and a set of open values is open") {
  CHECK(Value().is_undefined());
  CHECK(Value::tuple({Real(1), Value()}).is_undefined());
  CHECK(Value::pair(Value(), Real(1)).is_undefined());
  CHECK(Value::binding(signature({x}), {Value()}).is_undefined());
  CHECK(Value::set({Real(1), Value()}).is_undefined());
  CHECK(Value::set({Real(1), Open{}}).is_open());
  CHECK(has_open(Value::tuple({Real(1), Open{}})));
  CHECK(has_open(Value::line(Real(1), Real(2), Unknown{0})));
  CHECK_FALSE(has_open(Value::line(Real(1), Real(0), Unknown{0})));
  CHECK_FALSE(has_open(Value::tuple({Real(1), red()})));
}

TEST_CASE("a binding gives its components by name") {
  const Value point = Value::point(signature({z, y, x}), Real(1), Real(2), Real(3));
  REQUIRE(point.binding());
  CHECK(point.binding()->component(z)->text() == "3");
  CHECK_FALSE(point.binding()->component({"x", "'"}));
  CHECK(point.text() == "⦉x == 1, y == 2, z == 3⦊");
}

TEST_CASE("a set of pairs is a function where no two pairs agree in their first parts") {
  const Value f = set_of({Value::pair(Real(1), red()), Value::pair(Real(2), blue()), Value::pair(Real(2), red())});
  CHECK(f.text() == "{1 ↦ red, 2 ↦ red, 2 ↦ blue}");
  Steps steps;
  Context context(steps);
  CHECK(f.set()->apply(Real(1), context).text() == "red");
  CHECK(f.set()->apply(Real(2), context).is_undefined());
  CHECK(f.set()->apply(Real(3), context).is_undefined());
  CHECK(f.set()->in_domain(Real(2), context) == Truth::yes);
  CHECK(f.set()->in_domain(Real(3), context) == Truth::no);
  CHECK_THROWS_AS(set_of({Real(1)}).set()->apply(Real(1), context), EvaluationError);
}

TEST_CASE("atoms are spelled as whoever prints them asks") {
  const Value::Spelling quoted = [](const AtomName& atom) { return "'" + atom.text + "'"; };
  const Type function = Type::power(Type::product({color, number}));
  CHECK(set_of({Value::pair(red(), Real(1))}).text(function, quoted) == "{'red' ↦ 1}");
}

TEST_CASE("each empty set bears the type of its members where that is known") {
  const auto text = [](const Value& value, const Type& type) {
    return value.text(type, [](const AtomName& atom) { return atom.text; });
  };
  const Value empty = set_of({});
  CHECK(empty.text() == "∅");
  CHECK(text(empty, Type::power(number)) == "∅[𝔸]");
  CHECK(text(empty, Type::power(Type::product({color, number}))) == "∅[Color × 𝔸]");
  CHECK(text(empty, Type::power(Type::schema({{x, Type::power(color)}}))) == "∅[[x : ℙ Color]]");
  CHECK(text(empty, Type::power(Type::unknown())) == "∅");
  CHECK(text(empty, Type::unknown()) == "∅");
  CHECK(text(set_of({empty, set_of({Real(1)})}), Type::power(Type::power(number))) == "{∅[𝔸], {1}}");
  CHECK(text(Value::tuple({Real(1), empty, red()}), Type::product({number, Type::power(color), color})) ==
        "(1, ∅[Color], red)");
  CHECK(text(set_of({Value::pair(empty, red())}), Type::power(Type::product({Type::power(number), color}))) ==
        "{∅[𝔸] ↦ red}");
  CHECK(text(set_of({Value::pair(red(), empty)}), Type::power(Type::product({color, Type::power(number)}))) ==
        "{red ↦ ∅[𝔸]}");
  CHECK(text(Value::binding(signature({y, x}), {empty, Real(2)}),
             Type::schema({{x, Type::power(color)}, {y, number}})) == "⦉x == ∅[Color], y == 2⦊");
  const Value built = std::make_shared<const Constructed>(Constructed{*red().get<Atom>(), empty});
  CHECK(text(built, color) == "red(∅)");
}

}  // namespace
}  // namespace durero::zed
