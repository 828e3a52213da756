#include "durero/zed/syntax/parser.hpp"

#include "durero/zed/syntax/defect.hpp"
#include "support/catch.hpp"

namespace durero::zed {
namespace {

std::string nested(unsigned depth) {
  std::string text = "x";
  for (unsigned i = 0; i < depth; ++i) text = "(" + text + ")";
  return text;
}

TEST_CASE("an expression is an application, a predicate a relation") {
  const Term sum = parse_unicode("a + 1");
  CHECK(sum->kind == Kind::application);
  CHECK(sum->children[0]->name == Name{"_+_", ""});
  CHECK(sum->children[1]->kind == Kind::tuple);
  const Term order = parse_unicode("a ≤ b' < c?");
  CHECK(order->kind == Kind::relation);
  CHECK(order->names == std::vector<Name>{{"_≤_", ""}, {"_<_", ""}});
  CHECK(order->children[1]->name == Name{"b", "'"});
  CHECK(order->children[2]->name == Name{"c", "?"});
}

TEST_CASE("what binds more tightly is deeper") {
  CHECK(parse_unicode("a + b * c") == parse_unicode("a + (b * c)"));
  CHECK_FALSE(parse_unicode("a + b * c") == parse_unicode("(a + b) * c"));
  CHECK(parse_unicode("a - b - c") == parse_unicode("(a - b) - c"));
  CHECK(parse_unicode("a = b ∧ c = d ⇒ e = f") == parse_unicode("((a = b) ∧ (c = d)) ⇒ (e = f)"));
}

TEST_CASE("both mark-ups give the same tree") {
  CHECK(parse_latex("x \\in A \\cup B") == parse_unicode("x ∈ A ∪ B"));
  CHECK(parse_latex("\\forall x : A @ x = x") == parse_unicode("∀ x : A ⦁ x = x"));
}

TEST_CASE("a paragraph is read to its end") {
  const Paragraph paragraph = parse_unicode_paragraph("[A, B]");
  CHECK(paragraph == parse_unicode_paragraph("[ A , B ]"));
  CHECK_FALSE(paragraph == parse_unicode_paragraph("[B, A]"));
  CHECK_THROWS_AS(parse_unicode_paragraph("[A, B] [C]"), ZError);
}

TEST_CASE("what cannot be read is an error at its place") {
  const auto place_of = [](const char* text) {
    try {
      parse_unicode(text);
    } catch (const ZError& error) {
      return error.place;
    }
    return Place{};
  };
  CHECK(place_of("a + )") == Place{1, 5});
  CHECK(place_of("∀ x : A ⦁ )") == Place{1, 11});  // columns count characters
  CHECK(place_of("(a,\n  ]") == Place{2, 3});
  CHECK(place_of("a b )") == Place{1, 5});
  CHECK_THROWS_AS(parse_unicode(""), ZError);
  CHECK_THROWS_AS(parse_latex("\\cup"), ZError);
}

TEST_CASE("an expression may nest to the limit, and no deeper") {
  CHECK(parse_unicode(nested(max_depth / 2)) == parse_unicode("x"));
  CHECK_THROWS_AS(parse_unicode(nested(max_depth + 1)), ZError);
}

}  // namespace
}  // namespace durero::zed
