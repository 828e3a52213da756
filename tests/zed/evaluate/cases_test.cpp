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

const Specification& looked_for() {
  static const Specification read = read_text(R"(
\begin{zed} TREE ::= leaf | fork \ldata TREE \cross TREE \rdata \end{zed}
\begin{axdef} f, fact, fib, v : \nat \fun \nat \\ p : \nat \cross \nat \fun \nat \\ even : \power \nat \where
  f~0 = 5 \\ \forall n : \nat @ f(n+1) = 7 \\
  fact~0 = 1 \\ \forall n : \nat @ fact(n+1) = (n+1) * fact(n) \\
  fib~0 = 0 \\ fib~1 = 1 \\ \forall n : \nat @ fib(n+2) = fib(n+1) + fib(n) \\
  \forall n : \nat @ (n = 0 \implies v~n = 5) \land (n > 0 \implies v~n = 7) \\
  \forall n : \nat @ p(0,n) = 5 \\ \forall m, n : \nat @ p(m+1,n) = 7 \\
  0 \in even \\ 1 \notin even \\ \forall n : \nat @ n + 2 \in even \iff n \in even
\end{axdef}
\begin{axdef} s : \seq \nat \fun \nat \\ size : TREE \fun \nat \where
  s \langle \rangle = 0 \\ \forall x : \nat; t : \seq \nat @ s(\langle x \rangle \cat t) = x + s~t \\
  size~leaf = 0 \\ \forall l, r : TREE @ size(fork(l,r)) = 1 + size~l + size~r
\end{axdef}
\begin{schema}{S} x : \nat \end{schema}
\begin{schema}{Pay} \Delta S; p? : \nat \where f~p? = 7 \\ x' = p? \end{schema}
\begin{schema}{Pick} \Delta S; p! : \nat \where f~p! = 7 \\ x' = x + 1 \end{schema})",
                                              "looked for");
  return read;
}

/// What is so, or `open` where that is not decided.
std::string asked(const std::string& typed) {
  REQUIRE(looked_for().defects.empty());
  const Evaluator evaluator(looked_for().sections);
  const Term term = parse_unicode(typed);
  try {
    const bool is_value = typed.starts_with("{") || typed.starts_with("(μ");
    if (is_value) {
      const Value value = evaluator.value(term);
      return value.is_open() || (value.set() && !value.set()->members()) ? "open" : value.text();
    }
    const Truth truth = evaluator.holds(term);
    return truth == Truth::open ? "open" : truth == Truth::yes ? "true" : "false";
  } catch (const EvaluationError&) {
    return "open";
  }
}

TEST_CASE("what is looked for is not the first form of an argument that a function has a case for") {
  CHECK(asked("∃ x : ℕ • f x = 7") == "true");
  CHECK(asked("{x : ℕ | f x = 7}") == "open");
  CHECK(asked("∀ x : ℕ | f x = 7 • x = 99") == "false");
  CHECK(asked("∃ x : ℕ • x < 5 ∧ f x = 7") == "true");
  CHECK(asked("∃ x : 0 ‥ 5 • f x = 7") == "true");
  CHECK(asked("{x : ℕ | x ∈ even ∧ x < 9}") == "{0, 2, 4, 6, 8}");
  CHECK(asked("¬ {x : ℕ | x ∈ even ∧ x < 9} = {0}") == "true");
  CHECK(asked("∃ x : ℕ • fact x = 6") == "true");
  CHECK(asked("{x : ℕ | fact x = 6}") == "open");
  CHECK(asked("{x : ℕ | x ≤ 9 ∧ fact x = 6}") == "{3}");
  CHECK(asked("(μ x : ℕ | x < 9 ∧ fact x = 24)") == "4");
  CHECK(asked("(μ x : ℕ | fact x = 24)") == "open");
  CHECK(asked("∃₁ x : ℕ • fact x = 1") == "open");
  CHECK(asked("∃₁ x : ℕ • x < 9 ∧ fact x = 1") == "false");
  CHECK(asked("∃ x : ℕ • fib x = 1") == "true");
  CHECK(asked("∃ t : TREE • size t = 2") == "true");
  CHECK(asked("∀ t : TREE | size t = 1 • false") == "false");
  CHECK(asked("∃ q : seq ℕ • s q = 3") == "true");
  CHECK(asked("∃ x : ℕ • v x = 7") == "true");
  CHECK(asked("∃ x : ℕ • p(x,1) = 7") == "true");
  CHECK(asked("∃ x : ℕ • (x, 7) ∈ f") == "true");
  CHECK(asked("∃ x : ℕ • x ∈ dom f ∧ x = 3") == "true");
}

// A value that an application may not have is none that anything can be said of.
TEST_CASE("of what may be undefined nothing is known") {
  CHECK(asked("{x : ℕ | ∃ y : ℕ • y = first (4, {0 ↦ 4, 2 ↦ 2} x)} ∩ (0 ‥ 4)") == "{0, 2}");
  CHECK(asked("{x : ℕ | (4, {0 ↦ 4, 2 ↦ 2} x) ∈ {a, b : 𝔸 | a = 4}} ∩ (0 ‥ 4)") == "{0, 2}");
  CHECK(asked("{x : ℕ | {0 ↦ 4, 2 ↦ 2} x ∉ ∅} ∩ (0 ‥ 4)") == "{0, 2}");
  CHECK(asked("{x : ℕ | (1, {0 ↦ 4, 2 ↦ 2} x) ≠ (2, 3)} ∩ (0 ‥ 4)") == "{0, 2}");
  CHECK(asked("{x : ℕ | ⦉a == 4, b == {0 ↦ 4, 2 ↦ 2} x⦊.a = 4} ∩ (0 ‥ 4)") == "{0, 2}");
}

TEST_CASE("what is found with one member of a set is not so with the next") {
  CHECK(asked("∃ x : ℕ; y : {1, 2} • x + 1 = y + y ∧ y > 1") == "true");
  CHECK(asked("{x : ℕ; y : {1, 2} | x + 1 = y + y}") == "{1 ↦ 1, 3 ↦ 2}");
}

TEST_CASE("the value at a set that nobody can list is not said to be none") {
  CHECK(asked("¬ {ℕ ↦ 1} ℕ = 1") == "open");
  CHECK(asked("¬ {ℕ ↦ 1, ℤ ↦ 2} ∈ ℙ ℤ ⇸ ℕ") == "open");
  CHECK(asked("¬ {1 ↦ ℕ} ⨾ {ℕ ↦ 2} = ∅") == "open");
  CHECK(asked("5 ∈ {1 ↦ ℕ} 1") == "true");
}

TEST_CASE("an operation whose input a function has cases for may go on") {
  const Evaluator evaluator(looked_for().sections);
  const Value three = Real(3), zero = Real(0);
  for (const auto& [input, truth] : {std::pair{three, Truth::yes}, std::pair{zero, Truth::no}}) {
    const Valuation locals = {{{"x", ""}, zero}, {{"p", "?"}, input}};
    CHECK(evaluator.holds(parse_unicode("pre Pay"), locals) == truth);
  }
  const Value here[] = {zero};
  const Truth all = evaluator.completion({"Pick", ""}, {{"x", ""}}).each(here, [](auto) { return true; });
  CHECK(all == Truth::open);  // any p! of 1, 2, 3, … does, and nothing lists them
}

}  // namespace
}  // namespace durero::zed
