#include "durero/zed/value/undecided.hpp"

#include <optional>

#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "support/catch.hpp"

namespace durero::zed {
namespace {

/// The lack that the evaluation of a term ends with, in a text of definitions that lack something.
std::optional<Lack> lack_of(const std::string& term) {
  static const Specification read = read_text(R"(
\begin{axdef}
  few : \nat \fun \nat \\
  endless : \num \fun \num
\where
  few(0) = 1
\also
  \forall n : \num @ endless(n) = endless(n + 1)
\end{axdef}
\begin{axdef}
  self : \power \nat
\where
  self = \{ n : \nat | n \notin self \}
\end{axdef}
\begin{gendef}[X]
  some : \power X
\where
  some \neq \emptyset
\end{gendef}
)",
                                              "lacks.tex");
  REQUIRE(read.ok());
  static const Evaluator evaluator(read.sections);
  try {
    evaluator.value(parse_unicode(term));
  } catch (const LackingEvaluation& error) {
    return error.lack();
  }
  return std::nullopt;
}

TEST_CASE("an evaluation that ends says what it lacks") {
  CHECK(lack_of("# {x : ℤ | x mod 2 = 0}") == Lack::members);
  CHECK(lack_of("⋂ {s : ℙ ℕ | s = s ∪ {1}}") == Lack::members);
  CHECK(lack_of("few 1") == Lack::equation);
  CHECK(lack_of("endless 0") == Lack::end);
  CHECK(lack_of("some[ℕ]") == Lack::instance);
  CHECK(lack_of("few 0") == std::nullopt);
}

}  // namespace
}  // namespace durero::zed
