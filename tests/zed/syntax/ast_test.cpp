#include "durero/zed/syntax/ast.hpp"

#include "support/catch.hpp"

using namespace durero::zed;

TEST_CASE("equality of terms ignores places and nothing else") {
  const Term x = reference({"x", "'"}, {}, {1, 2});
  CHECK(x == reference({"x", "'"}, {}, {7, 8}));
  CHECK_FALSE(x == reference({"x", "!"}));
  CHECK_FALSE(x == reference({"x", "'"}, {number("1")}));
  CHECK_FALSE(number("1") == reference({"1", ""}));
  CHECK(operation("_+_", {x, number("1")}) == operation("_+_", {x, number("1")}, {3, 3}));
  CHECK_FALSE(operation("_+_", {x, number("1")}) == operation("_-_", {x, number("1")}));

  SchemaText text{{{Declaration::Form::typed, {{"y", ""}}, {{}}, x, {}}}, {}};
  const Term all = quantified(Kind::comprehension, text, {});
  CHECK(all == quantified(Kind::comprehension, text, {}, {9, 9}));
  text.predicates.push_back({node(Kind::truth, {}), "", {}});
  CHECK_FALSE(all == quantified(Kind::comprehension, text, {}));
}

TEST_CASE("a node knows its depth, schema texts included") {
  Term deep = number("1");
  for (int i = 0; i < 5; ++i) deep = node(Kind::power, {deep});
  CHECK(deep->depth == 6);
  const SchemaText text{{}, {{deep, "", {}}}};
  CHECK(quantified(Kind::forall, text, {number("2")})->depth == 7);
}
