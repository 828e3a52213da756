/// Sets, functions and sequences are lists of members that they may have: scripts of small ones, and answers about
/// them.
#include "durero/zed/smt/smt.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "durero/zed/types/typecheck.hpp"
#include "support/catch.hpp"

namespace durero::zed {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

const std::string small_types =
    "\\begin{zed} Bit ::= zero | one \\end{zed}\n\\begin{zed} [NAME] \\end{zed}\n"
    "\\begin{schema}{Book} known : \\power NAME \\\\ birthday : NAME \\pfun Bit \\where known = \\dom birthday "
    "\\end{schema}\n";

/// A question about sets, with the last script that the solver was told.
struct QuestionOfSets {
  SmtFinding found;
  std::string script{};
};

QuestionOfSets asked_of_sets(const std::string& predicate, const std::string& output) {
  static const Specification read = read_text(small_types, "here.tex");
  REQUIRE(read.ok());
  REQUIRE(check(read).ok());
  const Evaluator evaluator(read.sections);
  QuestionOfSets made;
  const SmtProgram program{"z3", [&](const std::string& script) {
                             made.script = script;
                             return SmtReply{output};
                           }};
  const KnownMembers names = [](const Name& set) {
    return set.word == "NAME" ? std::optional(std::vector{Value::atom("NAME", "ann"), Value::atom("NAME", "bob")})
                              : std::nullopt;
  };
  made.found = ask_program(program, parse_unicode(predicate), read.sections, evaluator, {}, names);
  return made;
}

std::string said_of_sets(const std::string& predicate, const std::string& output) {
  return asked_of_sets(predicate, output).found.said;
}

/// The lines of a script that begin so.
std::string lines_of(const std::string& script, const std::string& begin) {
  std::string lines;
  for (std::size_t at = 0; at < script.size();) {
    const std::size_t end = script.find('\n', at);
    if (script.compare(at, begin.size(), begin) == 0) lines += script.substr(at, end - at) + "\n";
    at = end + 1;
  }
  return lines;
}

std::string facts_of_sets(const std::string& predicate) {
  const QuestionOfSets made = asked_of_sets(predicate, "unsat\n");
  INFO(predicate << ": " << made.found.said);
  return lines_of(made.script, "(declare") + lines_of(made.script, "(assert");
}

/// The last fact of the script, which is that of the body.
std::string last_fact(const std::string& predicate) {
  const std::string facts = "\n" + lines_of(asked_of_sets(predicate, "unsat\n").script, "(assert");
  const std::size_t begin = facts.rfind("\n(assert ");
  return begin == facts.npos ? "" : facts.substr(begin + 9, facts.size() - begin - 11);
}

/// s has zero where v0, one where v1; t has them where v2 and v3.
std::string of_sets(const std::string& body) { return last_fact("∃ s, t : ℙ Bit • " + body); }

/// f has zero ↦ v0 where v2, one ↦ v1 where v3; s has zero where v4, one where v5.
std::string of_functions(const std::string& body) { return last_fact("∃ f : Bit ⇸ Bit; s : ℙ Bit • " + body); }

/// q has 1 ↦ v0 where v2, 2 ↦ v1 where v3; n is v4.
std::string of_sequences(const std::string& body) { return last_fact("∃ q : iseq (1 ‥ 2); n : ℕ • " + body); }

}  // namespace

TEST_CASE("operations on sets are computed member by member") {
  CHECK(of_sets("zero ∈ s ∪ t") == "(or v0 v2)");
  CHECK(of_sets("zero ∈ s ∩ t") == "(and v0 v2)");
  CHECK(of_sets("zero ∈ s ∖ t") == "(and v0 (not v2))");
  CHECK(of_sets("zero ∈ s ⊖ t") == "(or (and v0 (not v2)) (and v2 (not v0)))");
  CHECK(of_sets("s ∪ t = {one}") == "(and (not (or v0 v2)) (or v1 v3))");
  CHECK(of_sets("s ⊖ t = ∅") ==
        "(and (not (or (and v0 (not v2)) (and v2 (not v0)))) (not (or (and v1 (not v3)) (and v3 (not v1)))))");
  CHECK(of_sets("s ⊆ t") == "(and (or (not v0) v2) (or (not v1) v3))");
  CHECK(of_sets("s ⊂ t") ==
        "(and (and (or (not v0) v2) (or (not v1) v3)) (not (and (or (not v2) v0) (or (not v3) v1))))");
  CHECK(of_sets("# s = 1") == "(= (+ (ite v0 1 0) (ite v1 1 0)) 1)");
  CHECK(of_sets("# (s ∪ t) = 1") == "(= (+ (ite (or v0 v2) 1 0) (ite (or v1 v3) 1 0)) 1)");
  CHECK(of_sets("∀ x : s • x ∈ t") == "(and (or (not v0) v2) (or (not v1) v3))");
  CHECK(of_sets("∃₁ x : s • x ∈ t") == "(= (+ (ite (and v0 v2) 1 0) (ite (and v1 v3) 1 0)) 1)");
  CHECK(of_sets("disjoint ⟨s, t⟩") == "(not (or (and v2 v0) (and v3 v1)))");
  CHECK(of_sets("⟨s, t⟩ partition {zero}") ==
        "(and (not (or (and v2 v0) (and v3 v1))) (and (not (or v1 v3)) (or v0 v2)))");
  CHECK(of_sets("{x : s | x ∈ t} = ∅") == "(and (not (and v0 v2)) (not (and v1 v3)))");
  CHECK(of_sets("{x : s • x ↦ one} = {zero ↦ one}") == "(and (not v1) v0)");
  CHECK(of_sets("(if zero ∈ s then t else s) = {one}") ==
        "(and (not (or (and v0 v2) (and (not v0) v0))) (or (and v0 v3) (and (not v0) v1)))");
  CHECK(of_sets("⋃ {s, t} = {one}") == "(and (not (or v0 v2)) (or v1 v3))");
  CHECK(of_sets("s × t = ∅") == "(and (not (and v0 v2)) (not (and v0 v3)) (not (and v1 v2)) (not (and v1 v3)))");
  CHECK(of_sets("id s = ∅") == "(and (not v0) (not v1))");
  CHECK(of_sets("s ∈ ℙ₁ t") == "(and (and (or (not v0) v2) (or (not v1) v3)) (or v0 v1))");
}

TEST_CASE("operations on functions are computed pair by pair") {
  CHECK(of_functions("f zero = one") == "(and v2 (= v0 1))");
  CHECK(of_functions("f one = f zero") == "(and v3 v2 (= v1 v0))");
  CHECK(of_functions("dom f = s") ==
        "(and (and (or (not v2) v4) (or (not v3) v5)) (and (or (not v4) v2) (or (not v5) v3)))");
  CHECK(of_functions("ran f = {one}") ==
        "(and (and (or (not v2) (= v0 1)) (or (not v3) (= v1 1))) (or (and v2 (= 1 v0)) (and v3 (= 1 v1))))");
  CHECK(of_functions("f ⦇ s ⦈ = {one}") ==
        "(and (and (or (not (and v2 v4)) (= v0 1)) (or (not (and v3 v5)) (= v1 1))) (or (and (and v2 v4) (= 1 "
        "v0)) (and (and v3 v5) (= 1 v1))))");
  CHECK(of_functions("s ◁ f = f") ==
        "(and (and (or (not (and v2 v4)) v2) (or (not (and v3 v5)) v3)) (and (or (not v2) (and v2 v4)) (or "
        "(not v3) (and v3 v5))))");
  CHECK(of_functions("s ⩤ f = f") ==
        "(and (and (or (not (and v2 (not v4))) v2) (or (not (and v3 (not v5))) v3)) (and (or (not v2) (and v2 "
        "(not v4))) (or (not v3) (and v3 (not v5)))))");
  CHECK(of_functions("f ⊕ {zero ↦ one} = f") ==
        "(and (and (or (not v3) v3) (and v2 (= 1 v0))) (and (or (not v2) (= v0 1)) (or (not v3) v3)))");
  CHECK(of_functions("f ∈ Bit → Bit") ==
        "(and (and (or (not v2) (and (<= 0 v0) (< v0 2))) (or (not v3) (and (<= 0 v1) (< v1 2)))) (and v2 v3))");
  CHECK(of_functions("f ∈ Bit ⤔ Bit") ==
        "(and (and (or (not v2) (and (<= 0 v0) (< v0 2))) (or (not v3) (and (<= 0 v1) (< v1 2)))) (not (and v3 "
        "v2 (= v1 v0))))");
  CHECK(of_functions("f ∈ Bit ⤀ Bit") ==
        "(and (and (or (not v2) (and (<= 0 v0) (< v0 2))) (or (not v3) (and (<= 0 v1) (< v1 2)))) (and (or "
        "(and v2 (= 0 v0)) (and v3 (= 0 v1))) (or (and v2 (= 1 v0)) (and v3 (= 1 v1)))))");
}

TEST_CASE("operations on sequences are computed item by item") {
  CHECK(of_sequences("q 1 = n") == "(and v2 (= v0 v4))");
  CHECK(of_sequences("# q = n") == "(= (+ (ite v2 1 0) (ite v3 1 0)) v4)");
  CHECK(of_sequences("head q = n") == "(and v2 (= v0 v4))");
  CHECK(of_sequences("last q = n") ==
        "(and (or (and v2 (= (+ (ite v2 1 0) (ite v3 1 0)) 1)) (and v3 (= (+ (ite v2 1 0) (ite v3 1 0)) 2))) "
        "(= (ite (and v2 (= (+ (ite v2 1 0) (ite v3 1 0)) 1)) v0 v1) v4))");
  CHECK(of_sequences("rev q = ⟨n⟩") ==
        "(and (and (or (not v2) (and (= (- (+ (+ (ite v2 1 0) (ite v3 1 0)) 1) 1) 1) (= v0 v4))) (or (not v3) "
        "(and (= (- (+ (+ (ite v2 1 0) (ite v3 1 0)) 1) 2) 1) (= v1 v4)))) (or (and v2 (and (= 1 (- (+ (+ (ite "
        "v2 1 0) (ite v3 1 0)) 1) 1)) (= v4 v0))) (and v3 (and (= 1 (- (+ (+ (ite v2 1 0) (ite v3 1 0)) 1) 2)) "
        "(= v4 v1)))))");
  CHECK(of_sequences("tail q = ⟨n⟩") == "(and (or v2 v3) (and (or (not v3) (= v1 v4)) (and v3 (= v4 v1))))");
  CHECK(of_sequences("front q = ⟨n⟩") ==
        "(and (or v2 v3) (and (and (or (not (and v2 (< 1 (+ (ite v2 1 0) (ite v3 1 0))))) (= v0 v4)) (not (and "
        "v3 (< 2 (+ (ite v2 1 0) (ite v3 1 0)))))) (and (and v2 (< 1 (+ (ite v2 1 0) (ite v3 1 0)))) (= v4 "
        "v0))))");
  CHECK(of_sequences("q prefix ⟨1, n⟩") == "(and (or (not v2) (= v0 1)) (or (not v3) (= v1 v4)))");
  CHECK(of_sequences("q ↾ {n} = ⟨n⟩") ==
        "(and (and (or (not (and v2 (= v0 v4))) (= v0 v4)) (or (not (and v3 (= v1 v4))) (and (= (+ (ite (and "
        "v2 (= v0 v4)) 1 0) 1) 1) (= v1 v4)))) (or (and (and v2 (= v0 v4)) (= v4 v0)) (and (and v3 (= v1 v4)) "
        "(and (= 1 (+ (ite (and v2 (= v0 v4)) 1 0) 1)) (= v4 v1)))))");
  CHECK(of_sequences("{2} ↿ q = ⟨n⟩") == "(and (or (not v3) (= v1 v4)) (and v3 (= v4 v1)))");
  CHECK(of_sequences("squash (q ▷ {n}) = ⟨n⟩") ==
        "(and (and (or (not (and v2 (= v0 v4))) (= v0 v4)) (or (not (and v3 (= v1 v4))) (and (= (+ (ite (and "
        "v2 (= v0 v4)) 1 0) 1) 1) (= v1 v4)))) (or (and (and v2 (= v0 v4)) (= v4 v0)) (and (and v3 (= v1 v4)) "
        "(and (= 1 (+ (ite (and v2 (= v0 v4)) 1 0) 1)) (= v4 v1)))))");
}

TEST_CASE("a set variable has a member for each that its set lists, or eight in an order") {
  const std::string two = "(declare-fun v0 () Bool)\n(declare-fun v1 () Bool)\n";
  CHECK(facts_of_sets("∃ s : ℙ Bit • # s = 1") == two + "(assert (= (+ (ite v0 1 0) (ite v1 1 0)) 1))\n");
  CHECK(facts_of_sets("∃ s : 𝔽₁ NAME • # s = 1") ==
        two + "(assert (or v0 v1))\n(assert (= (+ (ite v0 1 0) (ite v1 1 0)) 1))\n");
  const std::string total = "(declare-fun v0 () Int)\n(declare-fun v1 () Int)\n";
  CHECK(facts_of_sets("∃ f : Bit → 1 ‥ 2 • f zero > f one") ==
        total +
            "(assert (and (<= 1 v0) (<= v0 2)))\n(assert (and (<= 1 v1) (<= v1 2)))\n"
            "(assert (and (and (<= 1 v0) (<= v0 2)) (and (<= 1 v1) (<= v1 2))))\n(assert (> v0 v1))\n");
  const std::string wide = facts_of_sets("∃ s : 𝔽 ℕ • s = s");
  CHECK_THAT(wide, Contains("(declare-fun v7 () Int)\n(declare-fun v8 () Bool)\n"));
  CHECK_THAT(wide, Contains("(declare-fun v15 () Bool)\n(assert (or (not v9) (and v8 (< v0 v1))))\n"));
  CHECK_THAT(facts_of_sets("∃ s : seq ℕ • s = s"), Contains("(declare-fun v15 () Bool)\n(assert (or (not v9) v8))\n"));
  CHECK_THAT(facts_of_sets("∃ f : ℤ ⤔ Bit • f = f"), Contains("(and v16 (< v0 v2))"));
  CHECK_THAT(facts_of_sets("∃ f : ℤ × ℤ ⇸ Bit • f = f"), Contains("(and v24 (<= v0 v3))"));
  CHECK_THAT(facts_of_sets("∃ s : {{1, 2}, {3}} • s = s"), Contains("(and v2 (< v0 v1))"));
  CHECK_THAT(facts_of_sets("∃ u : ℙ (ℙ Bit) • u = u"), Contains("(declare-fun v3 () Bool)\n") && !Contains("v4"));
}

TEST_CASE("a member has a value, and a value is one") {
  CHECK(of_functions("{b : s • f b} = {one}") ==
        "(and (and (or (not v4) v2) (or (not v5) v3)) (and (and (or (not (and v4 v2)) (= v0 1)) "
        "(or (not (and v5 v3)) (= v1 1))) (or (and (and v4 v2) (= 1 v0)) (and (and v5 v3) (= 1 v1)))))");
  CHECK(of_functions("(λ b : s • f b) = f") ==
        "(and (and (or (not (and v4 v2)) v2) (or (not (and v5 v3)) v3)) (and (or (not v2) "
        "(and v4 v2)) (or (not v3) (and v5 v3))))");
  CHECK(last_fact("∃ r : Bit ↔ Bit • r zero = one") == "(and (and (or v0 v1) (not (and v1 v0))) (= (ite v0 0 1) 1))");
  CHECK(last_fact("∃ n : ℕ; s : ℙ Bit • # {n, 2} = # s") ==
        "(= (+ (ite (not (= 2 v0)) 1 0) 1) (+ (ite v1 1 0) (ite v2 1 0)))");
  CHECK(last_fact("∃ n : ℕ; s : ℙ Bit • # {6 div n} = # s") ==
        "(and (not (= v0 0)) (= (ite (not (= v0 0)) 1 0) (+ (ite v1 1 0) (ite v2 1 0))))");
  CHECK(last_fact("∃ n : ℕ • n ∈ 3 ‥ n") == "(and (<= 3 v0) (<= v0 v0))");
  CHECK(last_fact("∃ n : ℕ • max {n, 4} = n") == "(= (ite (<= 4 v0) v0 4) v0)");
  CHECK(of_sequences("max (ran q) = n") == "(and (or v2 v3) (= (ite (and v2 (or (not v3) (<= v1 v0))) v0 v1) v4))");
  CHECK(of_functions("zero ↦ one ∈ f ∼") == "(and v3 (= 0 v1))");
  CHECK(of_sequences("n ∈ dom (⟨7⟩ ⁀ q)") == "(or (= v4 1) (and v2 (= v4 2)) (and v3 (= v4 3)))");
  CHECK(of_sequences("n = last (q ⁀ ⟨7⟩)") == "(and d0 (= v4 d1))");
  CHECK(of_sequences("{n, 7} = {7, 8}") == "(and (or (= v4 7) (= v4 8)) (= 8 v4))");
  CHECK(of_functions("f ⨾ {one ↦ zero} = ∅") == "(and (not (and v2 (= v0 1))) (not (and v3 (= v1 1))))");
  CHECK(of_functions("f ∘ {one ↦ zero} = ∅") == "(not v2)");
  CHECK_THAT(last_fact("∃ n : ℕ • 4 ∈ dom (id (n ‥ 3))"),
             StartsWith("(and (< 3 (+ v0 8)) (or (and (<= v0 3) (= 4 v0))"));
  CHECK(last_fact("∃ n : ℕ • min {n, 4} = n") == "(= (ite (<= v0 4) v0 4) v0)");
  CHECK(last_fact("∃ u : ℙ (ℙ Bit) • ⋃ u = {one}") == "(and (not (or v1 v3)) (or v2 v3))");
  CHECK(facts_of_sets("∃ f : ℕ ⇸ Bit; g : ℕ ⇸ (5 ‥ 3) • f = g").find("(assert false)") == std::string::npos);
}

TEST_CASE("quantifiers over members of a variable, and over few numbers, are written out") {
  CHECK(facts_of_sets("∃ f : Bit → ℕ • ∀ b : Bit • f b > 7") ==
        "(declare-fun v0 () Int)\n(declare-fun v1 () Int)\n"
        "(assert (and (>= v0 0) (>= v1 0)))\n(assert (and (> v0 7) (> v1 7)))\n");
  CHECK_THAT(facts_of_sets("∃ n : ℕ • ∀ i : 1 ‥ 16 • n mod 32 ≠ i"), !Contains("forall"));
  CHECK_THAT(facts_of_sets("∃ n : ℕ • ∀ i : 1 ‥ 17 • n mod 32 ≠ i"), Contains("forall"));
  CHECK_THAT(facts_of_sets("∃ n : ℕ • ∀ i, j : 1 ‥ 16 • ∀ k : 1 ‥ 8 • n mod 32 ≠ i + j + k"), Contains("forall"));
  CHECK(last_fact("∃ n : ℕ • ∃ i, j : 1 ‥ 3 | i + 1 < j • n = i") == "(= v0 1)");
}

TEST_CASE("a long text is written once, and one too long is not asked") {
  const QuestionOfSets made = asked_of_sets("∃ s : seq ℕ • s (# s) = # s", "unsat\n");
  CHECK_THAT(lines_of(made.script, "(define-fun"), StartsWith("(define-fun d0 () Int (+ (ite v8 1 0) "));
  CHECK_THAT(lines_of(made.script, "(assert"), Contains("(assert (and d1 (= d2 d0)))"));
  std::string deep = "s 1";
  for (int i = 0; i < 40; ++i) deep = "s (" + deep + ")";
  CHECK(asked_of_sets("∃ s : seq ℕ • " + deep + " = 7", "unsat\n").script.size() < 200'000);
  CHECK(said_of_sets("∃ s : ℙ (1 ‥ 32) • ∃ r : ℤ • # {a, b, c, d : s | a + b + c + d = r} = 7", "unsat\n") ==
        "z3 is not asked: { a, b, c, d : s | a + b + c + d = r } has no few members that are known");
}

TEST_CASE("sets that the solver finds are a witness where the text says so") {
  CHECK(said_of_sets("∃ s : seq (1 ‥ 9) • # s = 2 ∧ s 1 + s 2 = 12",
                     "sat\n((v0 3) (v1 9) (v2 1) (v3 1) (v4 1) (v5 1) (v6 1) (v7 1) (v8 true) (v9 true) (v10 false) "
                     "(v11 false) (v12 false) (v13 false) (v14 false) (v15 false))\n") ==
        "z3 finds the witness s == ⟨3, 9⟩, which holds by the text");
  const std::string book = "sat\n((v0 1) (v1 0) (v2 true) (v3 false) (v4 1) (v5 0) (v6 true) (v7 false))\n";
  CHECK(said_of_sets("∃ f, g : NAME ⇸ Bit • f = g ∧ f ≠ ∅", book) ==
        "z3 finds the witness f == {ann ↦ one}, g == {ann ↦ one}, which holds by the text");
  CHECK(said_of_sets("∀ Book • # known = 2 ∨ birthday = ∅",
                     "sat\n((v0 true) (v1 false) (v2 1) (v3 0) (v4 true) (v5 false))\n")
            .starts_with("z3"));
  CHECK(said_of_sets("∃₁ s : ℙ Bit • # s = 1", "sat\n((v0 true) (v1 false) (v2 false) (v3 true))\n") ==
        "z3 finds the two witnesses s == {zero} and s == {one}, which hold by the text");
}

TEST_CASE("an answer about sets that does not hold by the text is not told as true") {
  const std::string one = "∃ s : ℙ Bit; f : Bit → ℕ • # s = 1 ∧ f zero > f one";
  CHECK(said_of_sets(one, "sat\n((v0 true) (v1 true) (v2 7) (v3 3))\n") ==
        "z3's answer s == {zero, one}, f == {zero ↦ 7, one ↦ 3} does not hold by the text");
  CHECK(said_of_sets(one, "sat\n((v0 true) (v1 false) (v2 3) (v3 7))\n") ==
        "z3's answer s == {zero}, f == {zero ↦ 3, one ↦ 7} does not hold by the text");
  for (const char* output : {"sat\n((v0 true) (v1 maybe) (v2 7) (v3 3))\n", "sat\n((v0 true) (v2 7) (v3 3))\n",
                             "sat\n((v0 true) (v1 false) (v2 7))\n", "sat\n((v0 (true)) (v1 false) (v2 7) (v3 3))\n",
                             "sat\n((v0 true) (v1 false) (v2 7.5) (v3 3))\n"}) {
    INFO(output);
    const QuestionOfSets made = asked_of_sets(one, output);
    CHECK(made.found.truth == Truth::open);
    CHECK(made.found.said == "z3's answer has no values that are understood");
  }
  const std::string gap =
      "sat\n((v0 3) (v1 9) (v2 1) (v3 1) (v4 1) (v5 1) (v6 1) (v7 1) (v8 false) (v9 true) (v10 false) "
      "(v11 false) (v12 false) (v13 false) (v14 false) (v15 false))\n";
  CHECK(said_of_sets("∃ s : seq (1 ‥ 9) • # s = 1", gap) == "z3's answer s == {2 ↦ 9} does not hold by the text");
}

TEST_CASE("where sets have bounds, the reason says so") {
  const std::string bounded = "z3 finds no witness whose sets have at most 8 members";
  CHECK(said_of_sets("∃ s : seq Bit • # s = 9", "unsat\n") == bounded);
  CHECK(said_of_sets("∃ s : 𝔽 ℕ • # s = 9", "unsat\n") == bounded);
  CHECK(said_of_sets("∃ f : ℕ ⇸ Bit • # f = 9", "unsat\n") == bounded);
  CHECK(said_of_sets("∃ n : ℕ • # (1 ‥ n) = 9", "unsat\n") == bounded);
  CHECK(said_of_sets("∃ s : ℙ (1 ‥ 32) • # s = 33", "unsat\n") == "z3 finds no witness");
  CHECK(said_of_sets("∃ s : ℙ (1 ‥ 33) • # s = 34", "unsat\n") == bounded);
  CHECK(said_of_sets("∃ f : 1 ‥ 128 → ℕ • f 1 < 0", "unsat\n") == "z3 finds no witness");
  CHECK(said_of_sets("∃ s : iseq Bit • # s = 3", "unsat\n") == "z3 finds no witness");
}

}  // namespace durero::zed
