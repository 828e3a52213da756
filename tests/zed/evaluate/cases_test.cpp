/// Functions, sets and relations that an axiomatic box defines by cases.

#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "support/catch.hpp"

namespace durero::zed {
namespace {

const Specification& text() {
  static const Specification read = read_text(R"(
\begin{zed} TREE ::= leaf | fork \ldata \nat \cross TREE \cross TREE \rdata \end{zed}
\begin{axdef}
  fact, late : \nat \fun \nat \\
  some : \nat \pfun \nat
\where
  fact(0) = 1 \\
  \forall n : \nat @ fact(n + 1) = (n + 1) * fact(n)
\also
  \forall n : \nat | n > 2 @ late(n) = n
\also
  some(0) = 7 \land (\forall n : \nat @ n > 2 \implies some(n) = n \land some(n) > 2)
\end{axdef}
\begin{axdef}
  fib : \nat \fun \nat
\where
  fib = (\lambda n : \nat @ \IF n < 2 \THEN n \ELSE fib(n - 1) + fib(n - 2))
\end{axdef}
\begin{axdef}
  size : TREE \fun \nat \\
  odd : \power TREE
\where
  size(leaf) = 0 \\
  \forall n : \nat; l, r : TREE @ size(fork(n, l, r)) = 1 + size(l) + size(r)
\also
  leaf \notin odd \\
  \forall n : \nat; l, r : TREE @ fork(n, l, r) \in odd \iff (l \in odd \iff r \in odd)
\end{axdef}
\begin{axdef}
  sum : \seq \nat \fun \nat \\
  swap : \seq \nat \pfun \seq \nat
\where
  sum~\langle \rangle = 0 \\
  \forall x : \nat; s : \seq \nat @ sum(\langle x \rangle \cat s) = x + sum~s
\also
  \forall x, y : \nat @ swap~\langle x, y \rangle = \langle y, x \rangle
\end{axdef}
\begin{gendef}[X]
  back : \seq X \fun \seq X
\where
  back~\langle \rangle = \langle \rangle \\
  \forall x : X; s : \seq X @ back(s \cat \langle x \rangle) = \langle x \rangle \cat back~s
\end{gendef}
\begin{zed} \relation (\_~divides~\_) \end{zed}
\begin{axdef}
  \_~divides~\_ : \nat \rel \nat \\
  low : \power \nat
\where
  \forall a, b : \nat @ a~divides~b \iff (\exists k : \nat @ b = k * a)
\also
  0 \in low \\
  \lnot 3 \in low
\end{axdef})",
                                              "cases");
  return read;
}

std::string value(const std::string& expression) {
  REQUIRE(text().defects.empty());
  return Evaluator(text().sections).value(parse_unicode(expression)).text();
}

bool holds(const std::string& predicate) {
  const Truth truth = Evaluator(text().sections).holds(parse_unicode(predicate));
  REQUIRE(truth != Truth::open);
  return truth == Truth::yes;
}

TEST_CASE("a function is what its cases say of each form of its argument") {
  CHECK(value("fact(0)") == "1");
  CHECK(value("fact(6)") == "720");
  CHECK(value("fib(12)") == "144");
  CHECK(value("some(5)") == "5");
  CHECK(value("some(0)") == "7");
  CHECK(value("size(leaf)") == "0");
  CHECK(value("size(fork(1, fork(2, leaf, leaf), leaf))") == "2");
  CHECK(value("sum ⟨⟩") == "0");
  CHECK(value("sum ⟨4, 5, 6⟩") == "15");
  CHECK(value("swap ⟨1, 2⟩") == "⟨2, 1⟩");
  CHECK(value("back ⟨1, 2, 3⟩") == "⟨3, 2, 1⟩");
}

TEST_CASE("a set, or a relation, is what its cases say of membership") {
  CHECK_FALSE(holds("leaf ∈ odd"));
  CHECK(holds("fork(1, leaf, leaf) ∈ odd"));
  CHECK_FALSE(holds("fork(1, fork(2, leaf, leaf), leaf) ∈ odd"));
  CHECK(holds("0 ∈ low ∪ {2}"));
  CHECK_FALSE(holds("3 ∈ low"));
}

TEST_CASE("where no case gives a value of a total function, it is not said to have none") {
  CHECK(value("fact(- 1)") == "undefined");
  CHECK_THROWS_WITH(value("late(1)"), "no equation gives late a value at 1");
  CHECK_THROWS_WITH(value("some(1)"), "no equation gives some a value at 1");  // more is said of n than what some is
  CHECK(value("swap ⟨1⟩") == "undefined");
  CHECK_THROWS_WITH(holds("1 ∈ low"), "no equation gives low a value at 1");
}

}  // namespace
}  // namespace durero::zed
