/// Free types may have no values: the least sets that satisfy their equations are empty, then.
#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "durero/zed/types/typecheck.hpp"
#include "support/catch.hpp"

namespace durero::zed {
namespace {

std::string said_of(const std::string& paragraphs, const std::string& predicate) {
  const Specification read = read_text(paragraphs, "types.tex");
  INFO(paragraphs);
  REQUIRE(read.ok());
  REQUIRE(check(read).ok());
  Steps steps(100'000);
  const Evaluator evaluator(read.sections, {}, &steps);
  try {
    const Truth truth = evaluator.holds(parse_unicode(predicate));
    return truth == Truth::open ? "open" : truth == Truth::yes ? "true" : "false";
  } catch (const EvaluationError&) {
    return "open";
  }
}

/// Says whether the type T of a text has a value.
std::string has_value(const std::string& types) {
  return said_of("\\begin{zed} " + types + " \\end{zed}\n", "∃ t : T • t = t");
}

std::string set_of(const std::string& body) { return "T ::= c \\ldata " + body + " \\rdata"; }

}  // namespace

TEST_CASE("a free type of constructors that need a value of it has none") {
  const std::string types = "\\begin{zed} L ::= node \\ldata L \\rdata \\end{zed}\n";
  CHECK(said_of(types, "∃ l : L • l = l") == "false");
  CHECK(said_of(types, "∀ l : L • l ≠ l") == "true");
  CHECK(said_of(types, "L = ∅") == "true");
  CHECK(said_of(types, "# L = 0") == "true");
  CHECK(said_of(types, "∃ s : ℙ L • s = s") == "true");
  CHECK(said_of(types, "seq L = {∅}") != "false");
}

TEST_CASE("free types that need values of each other have none, whichever is asked") {
  const std::string types =
      "\\begin{zed} A ::= a \\ldata B \\rdata & B ::= b \\ldata A \\rdata & C ::= c | d \\ldata A \\cross C \\rdata "
      "\\end{zed}\n";
  CHECK(said_of(types, "∃ x : A • x = x") == "false");
  CHECK(said_of(types, "∃ x : B • x = x") == "false");
  CHECK(said_of(types, "∃ x : C • x = x") == "true");
  CHECK(said_of(types, "C = {c}") == "true");
}

TEST_CASE("a constructor has an argument where its set has a member, by its form") {
  for (const char* body :
       {"T", "T \\cross \\nat", "\\nat \\cross (\\nat \\cross T)", "\\emptyset[\\nat]", "\\{x : T | x = x\\}",
        "\\seq_1 T", "\\power_1 T", "T \\cap \\{t : T | t = t\\}", "T \\cup T", "[x : T; y : \\nat]",
        "T \\setminus \\emptyset", "\\{x : T; n : \\nat @ n\\}"}) {
    INFO(body);
    CHECK(has_value(set_of(body)) == "false");
  }
  for (const char* body : {"\\nat", "\\power T", "\\seq T", "\\nat \\pfun T", "T \\pfun \\nat", "\\finset T",
                           "T \\fun \\nat", "\\nat \\cup \\emptyset", "1 \\upto 3", "\\nat \\cross \\power T",
                           "[x : \\num; y : \\power T]", "T \\rel T", "\\{3, 4\\}", "\\power_1 \\nat"}) {
    INFO(body);
    CHECK(has_value(set_of(body)) == "true");
  }
}

TEST_CASE("where the form of a set does not tell, nothing is supposed") {
  CHECK(has_value(set_of("\\{x : \\nat | x * x * x = 7\\}")) != "true");
  CHECK(has_value(set_of("\\{x : \\nat | x * x * x = 27\\}")) != "false");
  CHECK(has_value(set_of("\\{x : \\nat | x * x = 4\\}")) == "true");
  CHECK(has_value(set_of("\\{x : \\nat | x < 0\\}")) == "false");
  const std::string by_name =
      "\\begin{zed} [N] \\end{zed}\n\\begin{zed} T ::= c \\ldata P \\rdata & P ::= p \\ldata N \\rdata \\end{zed}\n";
  CHECK(said_of(by_name, "∃ t : T • t = t") == "true");
}

TEST_CASE("a free type with values in its values is infinite, and has no size") {
  const std::string tree = "T ::= leaf | fork \\ldata T \\cross T \\rdata";
  const auto has_no_size = [](const std::string& types) {
    return said_of("\\begin{zed} [N] \\end{zed}\n\\begin{zed} " + types + " \\end{zed}\n", "# T = # T");
  };
  for (const std::string& types :
       {tree, std::string("T ::= c \\ldata \\nat \\rdata"), std::string("T ::= c | d \\ldata \\seq T \\rdata"),
        std::string("T ::= c | d \\ldata U \\rdata & U ::= e \\ldata T \\cross N \\rdata"),
        std::string("T ::= c \\ldata \\finset \\num \\rdata"),
        std::string("T ::= c \\ldata [x : \\nat; y : N] \\rdata")}) {
    INFO(types);
    CHECK(has_no_size(types) == "false");  // what has no value equals nothing
  }
  for (const char* types : {"T ::= c \\ldata N \\rdata", "T ::= c \\ldata \\{x : \\nat | x * x * x = 7\\} \\rdata",
                            "T ::= c \\ldata N \\cross \\power N \\rdata",
                            "T ::= c | a \\ldata \\nat \\cross \\{x : \\nat | x * x * x = 7\\} \\rdata"}) {
    INFO(types);
    CHECK(has_no_size(types) == "open");
  }
  CHECK(has_no_size("T ::= c | d") == "true");
  CHECK(has_no_size("T ::= a | c \\ldata E \\cross \\nat \\rdata & E ::= e \\ldata E \\rdata") == "true");
}

}  // namespace durero::zed
