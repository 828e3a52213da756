#include "durero/zed/coq/coq.hpp"

#include <fmt/core.h>

#include "support/catch.hpp"
#include "support/tree.hpp"
#include "zed/lines.hpp"

using namespace durero::zed;
using namespace durero::zed::test;
using Catch::Matchers::Contains;

namespace {

std::string exported(const Specification& read) {
  const Typing typing = check(read);
  REQUIRE(read.ok());
  REQUIRE(typing.ok());
  return to_coq(read, typing);
}

/// What is written of paragraphs behind the head.
std::string body(const std::string& paragraphs) {
  const std::string all = exported(read_text(paragraphs, "here"));
  const std::string begin = "(** * here *)\n\n", end = "\nEnd Especificacion.";
  const std::size_t at = all.find(begin) + begin.size();
  return all.substr(at, all.find(end) - at);
}

const std::string state =
    "\\begin{axdef} \\real : \\power \\arithmos \\where \\num \\subseteq \\real % real.axiom.1\n\\end{axdef}\n"
    "\\begin{zed} [E] \\end{zed}\n"
    "\\begin{schema}{S} es : \\power E \\\\ f : E \\pfun \\real \\\\ g : E \\pfun \\real \\where es = \\dom f % "
    "S.inv.1\n"
    "\\end{schema}\n"
    "\\begin{schema}{I} S~' \\where es' = \\emptyset % I.post.1\n\\end{schema}\n";

/// What is written of one more paragraph.
std::string more(const std::string& paragraph) {
  const std::string before = body("%%Zchar \\real U+211D\n" + state);
  return body("%%Zchar \\real U+211D\n" + state + paragraph).substr(before.size() + 1);
}

std::string definition(const std::string& of) { return more("\\begin{zed} " + of + "\n\\end{zed}\n"); }

}  // namespace

TEST_CASE(
    "proofs/Especificacion.v is what the Z text is in Coq: where it is stale, durero spec export --coq writes it") {
  std::vector<std::string> files = files_in("spec");
  std::erase_if(files, [](const std::string& file) {  // these have a second state, or speak of one
    return file.ends_with("/tablas.tex") || file.ends_with("/promocion.tex") || file.ends_with("/malla.tex") ||
           file.ends_with("/auditoria.tex") || file.ends_with("/historia.tex");
  });
  const std::string now = exported(read_files(files));
  const std::string committed = contents(durero::test::source_dir() + "/proofs/Especificacion.v");
  CHECK(now == committed);
}

TEST_CASE("every change of the text's mathematics changes the export") {
  std::string all;
  for (const char* stem : {"tipos", "escena", "operaciones", "puntos", "interseccion"})
    all += contents(fmt::format("{}/spec/{}.tex", durero::test::source_dir(), stem));
  const std::string before = exported(read_text(all, "spec"));
  const auto with = [&](const std::string& old, const std::string& now) {
    std::string changed = all;
    const std::size_t at = changed.find(old);
    REQUIRE(at != changed.npos);
    changed.replace(at, old.size(), now);
    return exported(read_text(changed, "spec"));
  };
  CHECK(with("r : \\real | r > 0", "r : \\real | r \\geq 0") != before);
  CHECK(with("cuadrado(r) = r * r", "cuadrado(r) = r + r") != before);
  CHECK(with("mi\\_altura' = mi\\_altura  %", "mi\\_altura' = \\emptyset  %") != before);
  CHECK(with("e? \\notin elementos", "e? \\in elementos") != before);
  CHECK(with("exists_1 temp", "exists temp") != before);
  CHECK(with("mi\\_radio : Elemento \\pfun Rmas", "mi\\_radio : Elemento \\pfun \\real") != before);
  CHECK(with("Elemento\\_Ya\\_Existe \\lor \\\\\n", "") != before);
  CHECK(with("(\\_ + \\_)", "(\\_ - \\_)") != before);
  CHECK(with("(a < b \\iff", "(a > b \\iff") != before);
  CHECK(with("The real numbers are", "Real numbers are") == before);
}

TEST_CASE("a partial application asks for its value in the relation that it stands in") {
  CHECK(definition("P == \\lambda S @ \\{~ e : E | \\lnot f(e) = 0 ~\\}") ==
        "Definition P (s : S) : set E := fun e => ~ (exists v1, (e, v1) ∈ f s /\\ v1 = 0).\n");
  CHECK(definition("P == \\lambda S @ \\{~ e : E | 0 \\leq f(e) \\leq g(e) ~\\}") ==
        "Definition P (s : S) : set E := fun e => exists v1 v2, (e, v1) ∈ f s /\\ (e, v2) ∈ g s /\\ 0 <= v1 <= v2.\n");
}

TEST_CASE("a conditional: what its condition asks for is known in both branches") {
  CHECK(definition("P == \\lambda S; e : E | e \\in es @ \\IF f(e) = 0 \\THEN g(e) \\ELSE f(e) + 1") ==
        "Definition P (s : S) (e : E) : set R :=\n"
        "  fun y1 => e ∈ es s /\\ exists v1, (e, v1) ∈ f s /\\ "
        "((v1 = 0 /\\ (e, y1) ∈ g s) \\/ (v1 <> 0 /\\ y1 = v1 + 1)).\n");
}

TEST_CASE("the integers are reals") {
  CHECK(body("%%Zchar \\real U+211D\n" + state).find("Definition real_axiom_1 : Prop := integers ⊆ univ.") !=
        std::string::npos);
  CHECK(definition("P == \\{~ n : \\num | n + 1 > 2 ~\\}") ==
        "Definition P : set R := fun n => n ∈ integers /\\ n + 1 > 2.\n");
}

TEST_CASE("within a sum a conditional on an order is Coq's own decision") {
  CHECK(definition("P == \\{~ r : \\real | r = 1 + (\\IF r \\leq 2 \\THEN r \\ELSE 3) ~\\}") ==
        "Definition P : set R := fun r => r = 1 + (if Rle_dec r 2 then r else 3).\n");
  CHECK_THROWS_WITH(definition("P == \\{~ r : \\real | r = 1 + (\\IF r = 2 \\THEN r \\ELSE 3) ~\\}"),
                    Contains("a conditional inside a term on more than how two numbers compare"));
  CHECK_THROWS_WITH(definition("P == \\{~ e : E | (\\IF 1 < 2 \\THEN e \\ELSE e) = e ~\\}"),
                    Contains("a conditional inside a term that is no number"));
}

TEST_CASE("a box of laws about a function of two arguments is a statement of each, and the function") {
  const std::string box =
      "\\begin{axdef} elevado : \\real \\cross \\num \\fun \\num \\where \\forall r : \\real @ elevado(r, 0) = 1 % "
      "elevado.def.1\n\\end{axdef}\n";
  CHECK(
      more(box) ==
      "Definition elevado_decl (elevado : R -> R -> R) : Prop := forall x1 x2 : R, x2 ∈ integers -> elevado x1 x2 ∈ "
      "integers.\n"
      "Definition elevado_def_1 (elevado : R -> R -> R) : Prop := forall r : R, elevado r 0 = 1. (* elevado.def.1 *)\n"
      "Definition elevado : R -> R -> R := power_of.\n");
}

TEST_CASE("sets: a whole type says nothing, a variable in scope is not hidden") {
  CHECK(definition("P == \\lambda S; e : E @ \\{~ d : es | \\exists e : \\dom f @ e = d ~\\}") ==
        "Definition P (s : S) (e : E) : set E := fun d => d ∈ es s /\\ exists e1 : E, e1 ∈ dom (f s) /\\ e1 = d.\n");
  CHECK(definition("P == \\{~ r : \\real | r > 0 ~\\}") == "Definition P : set R := fun r => r > 0.\n");
  CHECK(definition("P == \\{~ A : \\power E | \\exists B : \\power A @ B \\neq A ~\\}") ==
        "Definition P : set (set E) := fun A => exists B : set E, B ∈ ℙ A /\\ ~ (B ≡ A).\n");
}

TEST_CASE("a set of tuples is a predicate: a tuple is its member where it holds of the parts") {
  CHECK(more("\\begin{zed} P == \\{~ x, y : \\real | x > y ~\\}\n\\also\n"
             "Q == \\{~ x : \\real | (x + 1, 2) \\in P \\land (x, 3) \\notin P ~\\} \\end{zed}\n") ==
        "Definition P (x y : R) : Prop := x > y.\n\n"
        "Definition Q : set R := fun x => P (x + 1) 2 /\\ ~ P x 3.\n");
}

TEST_CASE("operations: components in their order, what is hidden behind exists") {
  CHECK(more("\\begin{schema}{O} \\Delta S \\\\ e? : E \\\\ r! : \\real \\where f(e?) = r! % O.pre.1\n\\end{schema}\n"
             "\\begin{zed} H == O \\hide (r!) \\lor [~ e? : E | e? = e? ~] \\end{zed}\n") ==
        "Record O (s s' : S) (e_in : E) (r_out : R) : Prop := {\n  O_Delta : Delta_S s s';\n"
        "  O_pre_1 : exists v1, (e_in, v1) ∈ f s /\\ v1 = r_out (* O.pre.1 *)\n}.\n\n"
        "Definition H (s s' : S) (e_in : E) : Prop := (exists r_out : R, O s s' e_in r_out) \\/ e_in = e_in.\n");
}

TEST_CASE("an operator as a set is its graph, and a product of whole types is all") {
  CHECK(definition("P == (\\real \\cross \\real) \\dres (\\_ * \\_)") ==
        "Definition P : rel (R * R) R := dres univ (graph Rmult).\n");
  CHECK(definition("P == \\{~ e : E | (\\real \\cross \\real) \\dres (\\_ + \\_) \\in \\real \\cross \\real \\fun "
                   "\\real ~\\}") == "Definition P : set E := fun e => dres univ (graph Rplus) ∈ univ ⟶ univ.\n");
  CHECK(definition("P == \\lambda S @ \\{~ e : E | (e, 1) \\in es \\cross \\num ~\\}") ==
        "Definition P (s : S) : set E := fun e => (e, 1) ∈ cartesian (es s) integers.\n");
  CHECK_THROWS_WITH(definition("P == \\lambda S @ \\{~ e : E | es \\cross es \\cross es = \\emptyset ~\\}"),
                    Contains("a product of several parts of types"));
}

TEST_CASE("a conjecture is a statement: what it includes is asked first, and pre asks for an after-state and outputs") {
  CHECK(more("\\begin{schema}{O} \\Delta S \\\\ e? : E \\\\ r! : \\real \\where f(e?) = r! % O.pre.1\n\\end{schema}\n"
             "\\begin{zed} \\vdash? \\forall S; e? : E | e? \\in es @ \\pre O % O.conj.1\n\\also\n"
             "\\vdash? \\forall O | e? \\in es' @ \\exists S~' @ I % O.conj.2\n\\end{zed}\n") ==
        "Record O (s s' : S) (e_in : E) (r_out : R) : Prop := {\n  O_Delta : Delta_S s s';\n"
        "  O_pre_1 : exists v1, (e_in, v1) ∈ f s /\\ v1 = r_out (* O.pre.1 *)\n}.\n\n"
        "Definition O_conj_1 : Prop :=\n  forall (s : S) (e_in : E), S_ok s -> e_in ∈ es s "
        "-> exists (s' : S) (r_out : R), O s s' e_in r_out. (* O.conj.1 *)\n\n"
        "Definition O_conj_2 : Prop :=\n  forall (s s' : S) (e_in : E) (r_out : R), O s s' e_in r_out -> e_in ∈ es s' "
        "-> exists s' : S, S_ok s'\n  /\\ I s'. (* O.conj.2 *)\n");
  CHECK_THROWS_WITH(definition("\\vdash? \\forall S @ es = es"), Contains("a conjecture without a label"));
}

TEST_CASE("a form without a rule is refused at its place") {
  CHECK_THROWS_WITH(definition("P == \\{~ A : \\power E | \\# A = 1 ~\\}"),
                    Contains("here:") && Contains("has no rule of translation to Coq"));
  CHECK_THROWS_AS(more("\\begin{axdef} c : \\real \\where c > 0 % c.def.1\n\\end{axdef}\n"), ExportError);
  CHECK_THROWS_WITH(exported(read_text("\\begin{zsection} \\SECTION own \\parents prelude \\end{zsection}\n"
                                       "\\begin{zed} \\emptyset == \\{ 1 \\} \\end{zed}\n",
                                       "here")),
                    Contains("here:2:") && Contains("∅, which the toolkit declares too"));
}
