/// Constants of axiomatic boxes: by equations, by what is said of several together, and where that leaves a choice.

#include "zed/evaluate/constants.hpp"

#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "support/catch.hpp"

namespace durero::zed {
namespace {

using Catch::Matchers::Contains;

/// An axiomatic box, of LaTeX mark-up.
std::string axdef(const std::string& declared, const std::string& said) {
  return "\\begin{axdef} " + declared + (said.empty() ? "" : " \\where " + said) + " \\end{axdef}\n";
}

std::vector<Section> sections(const std::string& text) {
  const Specification read = read_text(text, "constants");
  REQUIRE(read.defects.empty());
  return read.sections;
}

struct Asked {
  explicit Asked(const std::string& text, const Valuation& given = {}) : evaluator(sections(text), given) {}
  std::string value(const std::string& expression) { return evaluator.value(parse_unicode(expression)).text(); }
  std::string taken() const {
    std::string all;
    for (const auto& [name, value] : evaluator.taken()) all += name.text() + " = " + value.text() + "; ";
    return all;
  }
  Evaluator evaluator;
};

TEST_CASE("an inequality between two constants defines neither") {
  Asked asked(axdef("a : \\nat \\\\ b : \\nat", "a = 3 \\\\ b = 1 \\\\ b \\leq a"));
  CHECK(asked.value("b") == "1");
  CHECK(asked.value("a") == "3");
  CHECK(asked.taken().empty());
}

TEST_CASE("equations give constants their values in any order, and together") {
  CHECK(Asked(axdef("a, b : \\nat", "a = b + 1 \\land 2 = b")).value("a") == "3");
  CHECK(Asked(axdef("a, b : \\nat", "b = a + 1 \\\\ a < b \\\\ 2 * a = 4")).value("b") == "3");
  CHECK(Asked(axdef("a : \\nat", "a * a = 16")).value("a") == "4");
  CHECK(Asked(axdef("s : \\power \\nat", "s = \\{1, 2\\} \\\\ 2 \\in s")).value("# s") == "2");
  CHECK(Asked(axdef("n : \\nat", "n = 2") + axdef("m : \\nat", "m = n + n")).value("m") == "4");
}

TEST_CASE("a constant that is declared a sequence is written as one, however its value is made") {
  CHECK(Asked(axdef("q : \\seq \\nat", "q = \\{1 \\mapsto 4, 2 \\mapsto 5\\}")).value("q") == "⟨4, 5⟩");
  CHECK(Asked(axdef("q : \\seq \\nat", "q = \\{\\}")).value("q") == "⟨⟩");
  CHECK(Asked(axdef("f : 1 \\upto 2 \\fun \\seq \\nat", "f = \\{1 \\mapsto \\{\\}, 2 \\mapsto \\{1 \\mapsto 7\\}\\}"))
            .value("f") == "{1 ↦ ⟨⟩, 2 ↦ ⟨7⟩}");
  CHECK(Asked(axdef("f : \\nat \\pfun \\nat", "f = \\{1 \\mapsto 4\\}")).value("f") == "{1 ↦ 4}");
}

TEST_CASE("a predicate that the value makes false is named") {
  const std::string less = axdef("a, b : \\nat", "a = 3 \\\\\nb = 5 \\\\\nb \\leq a");
  CHECK_THROWS_WITH(Asked(less).value("b"), Contains("makes b ≤ a (line 3) false"));
  CHECK_THROWS_AS(Asked(less).value("a"), Unsatisfied);
  CHECK_THROWS_WITH(Asked(axdef("a : \\nat", "a = \\negate 1")).value("a"), Contains("makes a ∈ ℕ false"));
  CHECK_THROWS_WITH(Asked(axdef("a : \\nat", "a > 3 \\\\ a < 2")).value("a"), Contains("no value of a makes all true"));
  CHECK_THROWS_AS(Asked(axdef("a : \\nat", "a = a + 1")).value("a"), Unsatisfied);
}

TEST_CASE("a constant that nothing gives a value takes one, and says so") {
  Asked loose(axdef("max\\_size : \\nat", ""));
  CHECK(loose.value("max_size + 1") == "4");
  CHECK(loose.taken() == "max_size = 3; ");
  Asked above(axdef("n : \\nat", "n > 3"));
  CHECK(above.value("n") == "4");
  Asked far(axdef("n : \\nat", "n > 1000"));
  CHECK(far.value("n") == "1001");
  Asked two(axdef("n, m : \\nat", "n > 3 \\\\ m > n \\\\ m < n + 2"));
  CHECK(two.value("m - n") == "1");
  CHECK(two.taken() == "m = 5; ");  // which leaves n no choice
  Asked beside(axdef("n : \\nat", "n \\neq 3") + axdef("m : \\nat", "m = n"));
  CHECK(beside.value("m") == "2");
  CHECK(beside.taken() == "n = 2; ");
  Asked of_set("\\begin{zed} C ::= red | green \\end{zed}" + axdef("p, q : C", "p \\neq q"));
  CHECK(of_set.value("{p, q}") == "{red, green}");
}

TEST_CASE("a value that is given is taken as it is, and checked where that is asked") {
  const std::string text = axdef("n : \\nat", "n > 3") + axdef("m : \\nat", "m < n");
  const Name n{"n", ""};
  Asked good(text, {{n, Real(7)}});
  CHECK(good.value("n") == "7");
  CHECK_NOTHROW(good.evaluator.check_given(n));
  Asked bad(text, {{n, Real(2)}});
  CHECK_THROWS_WITH(bad.evaluator.check_given(n), Contains("n = 2 makes n > 3 (line 1) false"));
}

TEST_CASE("where nothing that is tried will do, the constant is named") {
  const std::string open = "\\begin{zed} [NAME] \\end{zed}" + axdef("p, q : NAME", "p \\neq q");
  CHECK_THROWS_AS(Asked(open).value("p"), Undetermined);
  CHECK_THROWS_WITH(Asked(open).value("p"), "no equation gives p a value");
  const std::string one = "\\begin{zed} [NAME] \\end{zed}" + axdef("p : NAME \\\\ s : \\power NAME", "");
  CHECK_THROWS_AS(Asked(one).value("p"), Undetermined);
  CHECK(Asked(one).value("# s") == "0");
}

}  // namespace
}  // namespace durero::zed
