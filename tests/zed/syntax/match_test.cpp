#include "zed/syntax/match.hpp"

#include "durero/zed/syntax/parser.hpp"
#include "support/catch.hpp"

namespace durero::zed {
namespace {

TEST_CASE("an equation has two sides and one relation") {
  CHECK(match::is_equation(parse_unicode("a = b")));
  CHECK_FALSE(match::is_equation(parse_unicode("a = b = c")));
  CHECK_FALSE(match::is_equation(parse_unicode("a ∈ b")));
  CHECK(match::is_relation(parse_unicode("a ∈ b"), "_∈_"));
  CHECK_FALSE(match::is_relation(parse_unicode("disjoint a"), "disjoint_"));
}

TEST_CASE("operands are those of one operator on a pair") {
  const Term sum = parse_unicode("a ∪ b");
  REQUIRE(match::operands(sum, "_∪_"));
  CHECK(match::operands(sum, "_∪_")->children[1] == parse_unicode("b"));
  CHECK_FALSE(match::operands(sum, "_∩_"));
  CHECK_FALSE(match::operands(parse_unicode("(_∪_) p"), "_∪_"));
  CHECK(*match::argument_of(parse_unicode("dom f"), "dom") == parse_unicode("f"));
  CHECK_FALSE(match::argument_of(parse_unicode("ran f"), "dom"));
  CHECK(match::application_of_name(parse_unicode("f x")));
  CHECK_FALSE(match::application_of_name(parse_unicode("(f x) y")));
}

TEST_CASE("a term mentions the names that it refers to") {
  CHECK(match::mentions(parse_unicode("{ x : S | x > c • x + 1 }"), {{"c", ""}}));
  CHECK(match::mentions(parse_unicode("{ x : S | true • 1 }"), {{"S", ""}}));
  CHECK_FALSE(match::mentions(parse_unicode("{ x : S | true • 1 }"), {{"x", ""}}));
  CHECK_FALSE(match::mentions(parse_unicode("x'"), {{"x", ""}}));
}

}  // namespace
}  // namespace durero::zed
