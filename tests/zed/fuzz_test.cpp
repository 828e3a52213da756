#include <fmt/core.h>

#include <ctime>
#include <random>

#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "zed/lines.hpp"
#include "zed/survive.hpp"

/// The everyday part of fuzzing (tests/fuzz/zed_fuzz.cpp is the rest): mutations of the Z texts at hand, the same ones
/// every time, and the inputs that once broke, or would break, a reader less careful.

using namespace durero::zed;
using namespace durero::zed::test;

namespace {

std::string repeated(const std::string& part, std::size_t times) {
  std::string text;
  for (std::size_t i = 0; i < times; ++i) text += part;
  return text;
}

std::string zed(const std::string& body) { return "\\begin{zed}\n" + body + "\n\\end{zed}\n"; }

/// One small change: bytes dropped, doubled, swapped for a piece of another text or for a byte that matters.
std::string mutated(std::string text, const std::vector<std::string>& others, std::mt19937_64& random) {
  const auto below = [&random](std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(random() % n); };
  for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
    const std::size_t at = below(text.size() + 1), length = 1 + below(20);
    static constexpr std::string_view telling = "\\{}[]()|;:,.@'?!_%~=\n\xE2";
    const std::string& other = others[below(others.size())];
    switch (below(4)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, text.substr(at, length));
        break;
      case 2:
        text.insert(at, other.substr(below(other.size()), length * 4));
        break;
      default:
        text.insert(at, 1, telling[below(telling.size())]);
    }
  }
  return text;
}

}  // namespace

TEST_CASE("mutations of the Z texts at hand are survived") {
  std::vector<std::string> texts;
  for (const char* folder : {"tests/zed/corpus/right", "tests/zed/corpus/wrong", "spec/impresa"})
    for (const std::string& file : files_in(folder)) texts.push_back(contents(file));
  std::mt19937_64 random(20200917);  // a fixed seed: what fails today fails tomorrow
  std::size_t survived = 0;
  for (int round = 0; round < 20; ++round)
    for (const std::string& text : texts) {
      const std::string now = mutated(text, texts, random);
      INFO(now);
      REQUIRE_NOTHROW(survive(now));
      ++survived;
    }
  CHECK(survived > 3000);
}

TEST_CASE("nesting up to the limit is read, and deeper nesting is an error that says so") {
  const auto nested = [](const std::string& open, const std::string& close, std::size_t times) {
    return repeated(open, times) + "x" + repeated(close, times);
  };
  const std::pair<std::string, std::string> brackets[] = {
      {"(", ")"},   {"{", "}"},         {"ℙ ", ""},
      {"¬ ", ""},   {"∀ a : A • ", ""}, {"f(", ")"},
      {"⟨", "⟩"},   {"[y : ", "]"},     {"if true then x else ", ""},
      {"θ (", ")"}, {"{y : ", "}"},     {"let y == ", " • y"},
      {"", " + x"}, {"x ⇸ ", ""},       {"", " ∼"},
      {"", "."},    {"", "'"},          {"", " ∧ x"},
      {"x ⇒ ", ""}, {"⦉y == ", "⦊"},    {"(μ y : ", ")"},
      {"x[", "]"}};
  for (const auto& [open, close] : brackets) {
    CAPTURE(open, close);
    CHECK_NOTHROW(survive_term(nested(open, close, 200)));
    for (const std::size_t times : {std::size_t{5000}, std::size_t{20000}})
      CHECK_NOTHROW(survive_term(nested(open, close, times)));
  }
  try {
    parse_unicode(nested("(", ")", max_depth + 1));
    FAIL("nesting without a limit");
  } catch (const ZError& error) {
    CHECK(error.what_is_wrong == "the text nests deeper than 500 levels");
  }
  CHECK_NOTHROW(survive_term(nested("(", ")", max_depth - 1)));
}

TEST_CASE("texts made to take long or much memory end in time, read or refused") {
  std::vector<std::pair<std::string, std::string>> texts;
  std::string doubling = "\\begin{schema}{S0} x, y : \\num \\end{schema}\n";
  for (int i = 1; i < 40; ++i)
    doubling += fmt::format("\\begin{{schema}}{{S{}}} S{}; S{}' \\end{{schema}}\n", i, i - 1, i - 1);
  texts.emplace_back("schemas that double", doubling);
  std::string chain = "\\begin{schema}{C} ";
  for (int i = 0; i < 9000; ++i) chain += fmt::format("x{} : \\emptyset;", i);
  chain += "x9000 : \\emptyset \\where ";
  for (int i = 0; i < 9000; ++i) chain += fmt::format("x{} = \\{{ x{} \\}}\\also\n", i, i + 1);
  texts.emplace_back("types that hang on one another", chain + "true \\end{schema}");
  texts.emplace_back("one set of many empty sets",
                     zed("T == \\{ " + repeated("\\emptyset, ", 50000) + "\\emptyset \\}"));
  texts.emplace_back("a long sum", zed("T == 1" + repeated(" + 1", 100000)));
  texts.emplace_back("many paragraphs", zed("[ A ]") + repeated(zed("\\vdash? \\forall a : A @ a = a"), 20000));
  texts.emplace_back("many errors", zed("T == \\{ " + repeated("z, ", 100000) + "z \\}"));
  std::string theta = doubling.substr(0, doubling.find("{S9}"));
  theta = theta.substr(0, theta.rfind("\\begin")) + zed("U == \\{ S8 @ (1" + repeated(", \\theta S8", 20000) + ") \\}");
  texts.emplace_back("many bindings of a large schema", theta);
  std::string partial = zed("[ A ]") + "\\begin{schema}{P} f : A \\pfun A; a : A \\where f(a) = a";
  texts.emplace_back("many applications of a partial function",
                     partial + repeated("\\also f(a) = a", 20000) + "\\end{schema}");
  texts.emplace_back("no line ends", repeated("\\begin{zed}", 50000));
  texts.emplace_back("open comments", repeated("%%Zchar \\a U+", 50000));
  texts.emplace_back("a file past the limit", std::string(max_bytes + 1, 'x'));
  for (const auto& [what, text] : texts) {
    CAPTURE(what);
    const std::clock_t start = std::clock();
    CHECK_NOTHROW(survive(text));
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    CHECK(seconds < (durero::test::sanitized ? 100 : 10));  // half a second in a release build
  }
}
