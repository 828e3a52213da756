#include "durero/zed/syntax/paragraphs.hpp"

#include "durero/zed/syntax/parser.hpp"
#include "support/catch.hpp"

namespace durero::zed {
namespace {

TEST_CASE("each form of paragraph declares its names") {
  const auto declares = [](const char* text, const std::vector<Name>& names) {
    CAPTURE(text);
    CHECK(names_of(parse_unicode_paragraph(text)) == names);
  };
  declares("[A, B]", {{"A", ""}, {"B", ""}});
  declares("T ::= a | b⟪ℕ⟫", {{"T", ""}, {"a", ""}, {"b", ""}});
  declares("N == 1", {{"N", ""}});
  declares("⊢? true", {});
  declares("┌─ S\n│ x, y : ℕ\n├─\n│ x = y\n└─\n", {{"S", ""}});
  declares("┌─\n│ c, d : ℕ\n├─\n│ c = d\n└─\n", {{"c", ""}, {"d", ""}});
}

TEST_CASE("a paragraph is found by its names, labels and components") {
  const Paragraph schema = parse_unicode_paragraph("┌─ S\n│ x, y : ℕ\n├─\n│ x = y  % S.inv.1\n│ x > 0\n└─\n");
  CHECK(labels_of(schema) == std::vector<std::string>{"S.inv.1"});
  CHECK(is_named(schema, "S"));
  CHECK(is_named(schema, "S.inv.1"));
  CHECK_FALSE(is_named(schema, "x"));
  CHECK(has_component(schema, "x"));
  CHECK_FALSE(has_component(schema, "S"));
  CHECK_FALSE(has_component(parse_unicode_paragraph("x == 1"), "x"));
}

}  // namespace
}  // namespace durero::zed
