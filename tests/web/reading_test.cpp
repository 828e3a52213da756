#include "support/catch.hpp"
#include "web/held.hpp"
#include "web/json_text.hpp"
#include "web/prose.hpp"

namespace durero::web {
namespace {

TEST_CASE("what was made of a text is made once, and the oldest is let go") {
  Held<int> held(2);
  int made = 0;
  const auto of = [&](const std::string& text) {
    return *held.of(text, [&] { return std::make_shared<const int>(++made); });
  };
  CHECK(of("a") == 1);
  CHECK(of("b") == 2);
  CHECK(of("a") == 1);
  CHECK(of("c") == 3);
  CHECK(of("a") == 1);  // asked for after b, which has made room for c
  CHECK(of("b") == 4);
  CHECK_THROWS_AS(held.of("d", []() -> std::shared_ptr<const int> { throw std::bad_alloc(); }), std::bad_alloc);
  CHECK(of("b") == 4);
}

TEST_CASE("prose stands between environments, in blocks that blank lines part") {
  const auto blocks = prose_of("One\nline.\n\nTwo.\n\\begin{zed}\n N == 1\n\\end{zed}\n% no prose\nThree.\n");
  REQUIRE(blocks.size() == 3);
  CHECK(blocks[0].text == "One\nline.");
  CHECK(blocks[0].line == 1);
  CHECK(blocks[1].text == "Two.");
  CHECK(blocks[1].line == 4);
  CHECK(blocks[2].text == "Three.");
  CHECK(blocks[2].line == 9);
  CHECK(prose_of("").empty());
}

TEST_CASE("a text is cut into pieces, and objects and arrays are made of parts that are JSON") {
  CHECK(pieces_of("a,,b", ',') == std::vector<std::string_view>{"a", "", "b"});
  CHECK(pieces_of("", ',').empty());
  CHECK(array_of_lines("{}\n[1]\n", false) == "[{},[1]]");
  CHECK(array_of_lines("a \"b\"\nc", true) == R"(["a \"b\"","c"])");
  CHECK(array_of_lines("", true) == "[]");
  CHECK(ObjectText().member("a", 1.5).raw("b", "[]").member("c\"", "d").text() == R"({"a":1.5,"b":[],"c\"":"d"})");
  CHECK(ObjectText().text() == "{}");
}

}  // namespace
}  // namespace durero::web
