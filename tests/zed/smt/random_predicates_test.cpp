/// Random predicates of small ranges are translated, and z3 is asked: what it says is the evaluator's enumeration.
#include <cstdlib>

#include "durero/zed/smt/smt.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "support/catch.hpp"
#include "zed/evaluate/random_cases.hpp"
#include "zed/smt/z3.hpp"

namespace durero::zed::test {
namespace {

constexpr const char* the_text =
    "\\begin{axdef} f : \\num \\fun \\num \\where f = \\lambda n : \\num @ n * n - 2 \\end{axdef}\n"
    "\\begin{axdef} g : \\nat \\cross \\num \\pfun \\num \\where \\forall n : \\nat; m : \\num @ g(n, m) = n - m "
    "\\end{axdef}\n"
    "\\begin{zed} Color ::= red | green | blue \\end{zed}\n";

/// Writes predicates of the fragment that is translated, with x and y in scope first.
class Writer {
 public:
  explicit Writer(Random& random) : random_(random) {}

  std::string predicate(int depth) {
    const auto sub = [&] { return predicate(depth - 1); };
    if (depth == 0) return comparison(1);
    switch (random_.below(8)) {
      case 0:
        return "(¬ " + sub() + ")";
      case 1:
      case 2:
        return "(" + sub() + random_.one_of<std::string>({" ∧ ", " ∨ ", " ⇒ ", " ⇔ "}) + sub() + ")";
      case 3:
        return bound(random_.one_of<std::string>({"∃", "∀", "∃₁"}), depth);
      case 4:
        return "(let " + fresh() + " == " + number(depth - 1) + " • " + scoped(depth) + ")";
      case 5:
        return membership(depth);
      default:
        return comparison(depth);
    }
  }

 private:
  std::string fresh() { return std::string(1, static_cast<char>('a' + names_.size())); }

  std::string scoped(int depth) {
    names_.push_back(fresh());
    const std::string inside = predicate(depth - 1);
    names_.pop_back();
    return inside;
  }

  std::string bound(const std::string& by, int depth) {
    const std::string set = random_.one_of<std::string>({"- 2 ‥ 2", "0 ‥ 3", "{- 1, 2, 3}", "{1, 2} ∪ {4}"});
    return "(" + by + " " + fresh() + " : " + set + " • " + scoped(depth) + ")";
  }

  std::string comparison(int depth) {
    const std::string by = random_.one_of<std::string>({" = ", " ≠ ", " < ", " ≤ ", " > ", " ≥ "});
    std::string chain = number(depth) + by + number(depth);
    if (random_.below(4) == 0) chain += " ≤ " + number(depth - 1);
    return "(" + chain + ")";
  }

  std::string membership(int depth) {
    const std::string n = number(depth - 1), pairs = "{1 ↦ 2, 2 ↦ 2}";
    const std::string set =
        random_.one_of<std::string>({"ℕ", "ℕ₁", "ℤ", "ℤ₁", "1 ‥ " + n, n + " ‥ 3", "{" + n + ", 1}", "ℕ ∖ {" + n + "}",
                                     "ℕ ∩ (" + n + " ‥ 2)", "{k : ℤ | k > " + n + "}", "{k : 0 ‥ 2 • k * k}", pairs});
    if (set == pairs) return "((" + n + " ↦ " + number(0) + ") ∈ " + set + ")";
    return "(" + number(depth - 1) + random_.one_of<std::string>({" ∈ ", " ∉ "}) + set + ")";
  }

  std::string number(int depth) {
    if (depth <= 0) {
      if (random_.below(3) == 0) return random_.one_of<std::string>({"0", "1", "2", "3", "(- 1)", "(- 3)"});
      return random_.one_of(names_);
    }
    const auto sub = [&] { return number(depth - 1); };
    switch (random_.below(10)) {
      case 0:
        return "(" + sub() + " div " + sub() + ")";
      case 1:
        return "(" + sub() + " mod " + sub() + ")";
      case 2:
        return "(if " + comparison(0) + " then " + sub() + " else " + sub() + ")";
      case 3:
        return "f(" + sub() + ")";
      case 4:
        return "g(" + sub() + ", " + sub() + ")";
      case 5:
        return "{0 ↦ 2, 1 ↦ 3, 2 ↦ 0}(" + sub() + ")";
      case 6:
        return "(- " + sub() + ")";
      case 7:
        return "(succ " + sub() + ")";
      default:
        return "(" + sub() + random_.one_of<std::string>({" + ", " - ", " * "}) + sub() + ")";
    }
  }

  Random& random_;
  std::vector<std::string> names_ = {"x", "y"};
};

/// What came of so many predicates.
struct Agreement {
  std::size_t yes = 0, no = 0, open = 0;
};

void ask_one(const std::string& predicate, const Specification& read, const Z3& z3, Agreement& counts) {
  INFO(predicate);
  const Evaluator evaluator(read.sections);
  const Truth right = evaluator.holds(parse_unicode(predicate));
  REQUIRE(right != Truth::open);
  std::string script;
  const SmtProgram program{"z3", [&](const std::string& asked) { return z3.ask(script = asked); }};
  const SmtFinding found = ask_program(program, parse_unicode(predicate), read.sections, evaluator);
  INFO(script);
  INFO(found.said);
  CHECK(found.said.find("does not hold") == std::string::npos);
  CHECK(found.said.find("not understood") == std::string::npos);
  CHECK(found.said.find("not asked") == std::string::npos);
  if (found.truth == Truth::open && found.said != "z3 finds no witness") {
    ++counts.open;
    return;
  }
  CHECK(found.truth == (right == Truth::yes ? Truth::yes : Truth::open));  // it is an ∃
  ++(right == Truth::yes ? counts.yes : counts.no);
}

}  // namespace

TEST_CASE("z3 says of random predicates of small ranges as enumeration says") {
  if (!Z3::is_installed()) {
    WARN("z3 is not installed: its answers are not compared");
    return;
  }
  const Specification read = read_text(the_text, "random");
  REQUIRE(read.ok());
  const char* const given = std::getenv("DURERO_SEED");
  const std::uint64_t seed = given ? std::strtoull(given, nullptr, 10) : 20261129;
  INFO("DURERO_SEED=" << seed);
  Random random(seed);
  const Z3 z3;
  Agreement counts;
  constexpr int predicates = 200;
  for (int i = 0; i < predicates; ++i)
    ask_one("∃ x : - 3 ‥ 3; y : 0 ‥ 4 • " + Writer(random).predicate(3), read, z3, counts);
  CAPTURE(counts.yes, counts.no, counts.open);
  CHECK(counts.yes > 20);
  CHECK(counts.no > 20);
  CHECK(counts.open < predicates / 10);
}

}  // namespace durero::zed::test
