#include "durero/zed/evaluate/unfold.hpp"

#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/print/print.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "support/catch.hpp"

namespace durero::zed {
namespace {

const char* const counter = R"(
\begin{schema}{Counter}
  n, most : \nat
\where
  n \leq most
\end{schema}
\begin{schema}{Inc}
  \Delta Counter \\
  by? : \nat \\
  r! : \nat
\where
  n' = n + by?
\also
  most' = most
\also
  r! = n'
\end{schema}
\begin{schema}{Some}
  \Delta Counter
\where
  n' > n
\also
  most' = most
\end{schema}
\begin{zed}
  Full == [~ \Xi Counter; by? : \nat; r! : \nat | n = most \land r! = n ~]
\end{zed}
\begin{zed}
  TInc == Inc \lor Full
\end{zed}
\begin{schema}{Half}
  \Xi Counter \\
  r? : \nat
\where
  r? + r? = n
\end{schema}
\begin{schema}{Pair}[X]
  n, most : X
\where
  n \neq most
\end{schema}
\begin{zed}
  Both[X] == [~ Pair[X]; by? : X ~]
\end{zed}
)";

const std::vector<Section>& sections() {
  static const Specification read = read_text(counter, "counter.tex");
  REQUIRE(read.ok());
  return read.sections;
}

std::string unfolded_text(const std::string& typed) {
  const auto term = unfolded(parse_unicode(typed), sections(), [](const Name&) { return reference({"𝔸", ""}); });
  return term ? to_unicode(*term) : "nothing";
}

TEST_CASE("a precondition is calculated: what equations give is put in its place") {
  CHECK(unfolded_text("pre Inc") == "[n, most, by? : ℕ | n ≤ most; n + by? ≤ most; n + by? ∈ ℕ; most ∈ ℕ]");
  CHECK(unfolded_text("pre Some") == "[n, most : ℕ | n ≤ most; most ∈ ℕ; ∃ n' : ℕ • n' ≤ most ∧ n' > n]");
  CHECK(unfolded_text("pre [ΔCounter; by? : ℕ | n' = by? ∧ θ (Counter ⧹ (n)) = θ (Counter ⧹ (n)) ']") ==
        "[n, most, by? : ℕ | n ≤ most; by? ≤ most; by? ∈ ℕ; most ∈ ℕ]");
  CHECK(unfolded_text("pre [ΔCounter | θ Counter ' = θ Counter]") == "[n, most : ℕ | n ≤ most; most ∈ ℕ; n ∈ ℕ]");
  CHECK(unfolded_text("Counter '") == "[n', most' : ℕ | n' ≤ most']");
  CHECK(unfolded_text("ΞCounter") == "[n, most, n', most' : ℕ | n ≤ most; n' ≤ most'; n' = n; most' = most]");
  CHECK(unfolded_text("Counter[m/n] ⧹ (m)") == "[most : ℕ | ∃ m : ℕ • m ≤ most]");
  CHECK(unfolded_text("¬ Counter") == "[n, most : 𝔸 | ¬ (n ∈ ℕ ∧ most ∈ ℕ ∧ n ≤ most)]");
}

TEST_CASE("schemas quantified by ∀ and ∃₁ are written out") {
  CHECK(unfolded_text("∀ k : ℕ | k < 3 • [n : ℕ; k : ℤ | n ≠ k]") ==
        "[n : 𝔸 | ∀ k : ℕ | k < 3 • n ∈ ℕ ∧ k ∈ ℤ ∧ n ≠ k]");
  CHECK(unfolded_text("∃₁ k : ℕ • [n, k : ℕ | n = k * k]") == "[n : ℕ | ∃₁ k : ℕ • n = k * k]");
  CHECK(unfolded_text("∃₁ Counter | most = 3 • Pair[ℤ] ∧ [k : ℕ | k < n]") ==
        "[k : ℕ | ∃₁ n, most : ℕ | n ≤ most ∧ most = 3 • n ∈ ℤ ∧ most ∈ ℤ ∧ n ≠ most ∧ k < n]");
  // what is bound would be captured by a component, or would capture what a component's set names
  CHECK(unfolded_text("∀ k : {n} • Counter") == "nothing");
  CHECK(unfolded_text("∃ k : 1 ‥ n • Counter") == "nothing");
  CHECK(unfolded_text("∃₁ k : ℕ | k = n • [n : ℕ]") == "nothing");
  CHECK(unfolded_text("∀ k : ℕ • [n : {k}]") == "nothing");
}

TEST_CASE("a generic schema without actuals is written out where they are known") {
  const auto text = [](const char* typed) {
    const auto term = unfolded(
        parse_unicode(typed), sections(),
        [](const Name&) {
          return reference({"𝔸", ""});
        },
        [](const Term& generic) -> std::optional<std::vector<Term>> {
          if (generic->name.text() == "Pair") return std::vector{reference({"ℤ", ""})};
          return std::nullopt;
        });
    return term ? to_unicode(*term) : "nothing";
  };
  CHECK(text("Pair") == "[n, most : ℤ | n ≠ most]");
  CHECK(text("Pair ∧ [k : ℕ | k = n]") == "[n, most : ℤ; k : ℕ | n ≠ most; k = n]");
  CHECK(text("Both") == "nothing");
}

TEST_CASE("compositions, pipings and generic schemas are written out") {
  CHECK(unfolded_text("Inc ⨟ Inc") ==
        "[n, most, by?, r!, n', most' : ℕ | n ≤ most; n + by? ≤ most; n + by? ∈ ℕ; most ∈ ℕ; r! = n + by?; "
        "n' ≤ most'; n' = n + by? + by?; most' = most; r! = n']");
  CHECK(unfolded_text("Pair[ℕ]") == "[n, most : ℕ | n ≠ most]");
  CHECK(unfolded_text("Both[ℤ]") == "[n, most, by? : ℤ | n ≠ most]");
  CHECK(unfolded_text("Pair") == "nothing");
  CHECK(unfolded_text("Inc ⨡ Counter") ==
        "[n, most : ℕ | n ≤ most; most ∈ ℕ; ∃ by? : ℕ • n + by? ≤ most ∧ n + by? ∈ ℕ]");
  CHECK(unfolded_text("∃ by? : ℕ • Pair[ℕ]") == "[n, most : ℕ | n ≠ most; ∃ by? : ℕ • true]");
  CHECK(
      unfolded_text("Inc ⨠ Half") ==
      "[n, most, n', most', by? : ℕ | n ≤ most; n' ≤ most'; n' = n + by?; most' = most; n' ∈ ℕ; n' = n; n' + n' = n]");
  // the name between is none that is there already
  CHECK(unfolded_text("[n, n', n'' : ℕ | n' = n''] ⨟ [n, n' : ℕ | n' = 2 * n]") ==
        "[n : ℕ | ∃ n'''' : ℕ • n'''' ∈ ℕ ∧ n'''' = 2 * n'''']");
}

TEST_CASE("what is written out has the bindings of the schema") {
  const Evaluator evaluator(sections());
  for (const char* typed : {"pre Inc",
                            "pre Some",
                            "TInc",
                            "pre TInc",
                            "[ΔCounter | θ Counter ' = θ Counter]",
                            "[ΔCounter | n' = 1 ∧ θ (Counter ⧹ (n)) = θ (Counter ⧹ (n)) ']",
                            "¬ Counter",
                            "Inc ⇒ Full",
                            "Inc ⧹ (by?)",
                            "Inc ⨟ Inc",
                            "TInc ⨟ Some",
                            "Some ⨟ Inc",
                            "Inc ⨠ Half",
                            "Inc ⨡ Counter",
                            "Pair[ℕ]",
                            "Both[1 ‥ 2]",
                            "∃ by? : 1 ‥ 2 • Inc",
                            "pre (Inc ⨟ Inc)",
                            "∀ by? : 0 ‥ 1 • TInc",
                            "∀ by? : 2 ‥ 1 • Inc",
                            "∃₁ by? : 0 ‥ 2 • TInc",
                            "∀ n' : 1 ‥ 2 | n' ≤ by? • [n, n' : ℕ | n ≤ n']"}) {
    CAPTURE(typed);
    const Term schema = parse_unicode(typed);
    const auto text = unfolded(schema, sections(), [](const Name&) { return reference({"𝔸", ""}); });
    REQUIRE(text);
    int compared = 0;
    for (int n = -1; n <= 2; ++n)
      for (int after = 0; after <= 2; ++after)
        for (int by = 0; by <= 2; ++by) {
          const auto value = [](int number) { return Value(Real(number)); };
          const Valuation locals{{{"n", ""}, value(n)},     {{"most", ""}, value(2)}, {{"n", "'"}, value(after)},
                                 {{"most", "'"}, value(2)}, {{"by", "?"}, value(by)}, {{"r", "!"}, value(after)}};
          CAPTURE(n, after, by);
          const Truth written = evaluator.holds(*text, locals), meant = evaluator.holds(schema, locals);
          if (written == Truth::open || meant == Truth::open) continue;  // one of them asks for more than can be found
          CHECK(written == meant);
          ++compared;
        }
    CHECK(compared > 0);
  }
}

}  // namespace
}  // namespace durero::zed
