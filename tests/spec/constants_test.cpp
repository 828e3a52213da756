#include "durero/spec/constants.hpp"

#include "support/catch.hpp"

namespace durero::spec {
namespace {

zed::Specification text() {
  return zed::read_text(R"(
\begin{zed} COLOUR ::= red | green \end{zed}
\begin{axdef} max\_size, low : \nat \\ used : \power COLOUR \\ double : \nat \fun \nat
\where low < max\_size \\ \forall n : \nat @ double~n = n + n
\end{axdef})",
                        "text");
}

std::string given(const std::vector<std::string>& typed) {
  std::string all;
  for (const auto& [name, value] : given_constants(text(), typed)) all += name.text() + " = " + value.text() + "; ";
  return all;
}

/// What is wrong with a value, and its column.
std::string wrong(const std::string& typed) {
  try {
    given({typed});
  } catch (const ConstantError& error) {
    return std::to_string(error.place.column) + ": " + error.what();
  }
  return "nothing";
}

TEST_CASE("constants have the values that are typed for them") {
  CHECK(given({"max_size=8", "low=2 + 1"}) == "max_size = 8; low = 3; ");
  CHECK(given({"used={red}"}) == "used = {red}; ");
  CHECK(given({"used={c : COLOUR | c ≠ red}"}) == "used = {green}; ");
}

TEST_CASE("what cannot be a constant's value is refused at its column") {
  CHECK(wrong("max_size") == "1: max_size gives no value; expected NAME=VALUE");
  CHECK(wrong("max_sise=3") == "1: the text has no constant max_sise; expected max_size");
  CHECK(wrong("COLOUR=3") == "1: the text has no constant COLOUR; expected a name of an axiomatic box");
  CHECK(wrong("max_size=red").starts_with("10: "));
  CHECK(wrong("max_size=1 +").starts_with("1"));
  CHECK(wrong("low=1 div 0") == "5: this has no value; expected one of low");
  CHECK(wrong("max_size=- 1") == "1: max_size = -1 makes max_size ∈ ℕ false; expected a value that the text admits");
  CHECK(wrong("used={c : COLOUR | c ≠ c} ∪ {red, max_size}").starts_with("6: ") == false);
}

TEST_CASE("values that break what the text says of both are refused") {
  CHECK_THROWS_WITH(given({"max_size=2", "low=2"}), Catch::Matchers::Contains("makes low < max_size"));
}

TEST_CASE("what was taken is said with the option that chooses another") {
  const zed::Evaluator evaluator(text().sections);
  evaluator.value(zed::Name{"low", ""});
  const auto lines = taken_lines(evaluator.taken());
  REQUIRE(lines.size() == 2);
  CHECK(lines[0] == "low = 3 was taken; --let low=VALUE chooses another");
  CHECK(lines[1] == "max_size = 4 was taken; --let max_size=VALUE chooses another");
}

TEST_CASE("a calculation says what was taken for it, and nothing where all is given") {
  Calculator loose(text());
  CHECK(loose.evaluate("max_size > low").taken.size() == 2);
  Calculator fixed(text());
  fixed.let({"max_size=9", "low=1"});
  const auto result = fixed.evaluate("max_size - low");
  CHECK(result.text == "8");
  CHECK(result.taken.empty());
}

TEST_CASE("an unknown name is answered by a near one, or by some that there are") {
  CHECK_THROWS_WITH(Calculator(text()).evaluate("doubel 1"), Catch::Matchers::Contains("did you mean double?"));
  CHECK_THROWS_WITH(Calculator(text()).evaluate("foo"),
                    Catch::Matchers::Contains("expected a declared name, such as COLOUR, double, green, low"));
}

}  // namespace
}  // namespace durero::spec
