#include "durero/zed/hol/hol.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "durero/zed/syntax/parser.hpp"
#include "support/catch.hpp"

namespace durero::zed {
namespace {

using Catch::Matchers::Contains;

const char* const queue = R"(
\begin{zed} [ ITEM ] \end{zed}
\begin{zed} TREE ::= leaf | fork \ldata TREE \cross TREE \rdata \end{zed}
\begin{schema}{Queue}
  items : \nat \pfun ITEM \\
  front, back : \nat
\where
  front \leq back
\also
  \dom items = \{~ i : \nat | front \leq i < back ~\}
\end{schema}
\begin{schema}{Leave}
  \Delta Queue \\
  item! : ITEM
\where
  item! = items~front
\also
  items' = \{ front \} \ndres items
\also
  front' = front + 1
\also
  back' = back
\end{schema}
\begin{schema}{Look}
  \Xi Queue \\
  wanted? : ITEM
\where
  \lnot (\exists_1 i : \dom items @ items~i = wanted?)
\end{schema}
)";

struct Read {
  Specification text;
  Typing typing;
};

Read read_here(const std::string& source) {
  Read read{read_text(source, "queue.tex"), {}};
  if (!read.text.ok()) FAIL(read.text.defects.front().text());
  read.typing = check(read.text);
  if (!read.typing.ok()) FAIL(read.typing.defects.front().text());
  return read;
}

std::string written(const std::string& source, ProofAssistant prover, const std::string& claim = "∀ Queue • true") {
  const Read read = read_here(source);
  return to_hol(read.text, read.typing, {{"claim", parse_unicode(claim)}}, prover, "Queue");
}

std::string refusal(const std::string& paragraph) {
  try {
    written(std::string(queue) + paragraph, ProofAssistant::coq);
  } catch (const ExportError& error) {
    return error.what();
  }
  return "none";
}

bool is_balanced(const std::string& text) {
  long depth = 0;
  for (const char c : text) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (depth < 0) return false;
  }
  return depth == 0;
}

/// The words of a text that begin so.
std::set<std::string> words_with(const std::string& text, const std::string& beginning) {
  std::set<std::string> words;
  std::string word;
  for (const char c : text + " ") {
    if ((std::isalnum(static_cast<unsigned char>(c)) != 0) || c == '_') {
      word += c;
      continue;
    }
    if (word.starts_with(beginning)) words.insert(word);
    word.clear();
  }
  return words;
}

}  // namespace

TEST_CASE("a schema is a predicate on its components, and an application has a value in its relation") {
  const std::string coq = written(queue, ProofAssistant::coq);
  CHECK_THAT(coq, Contains("Variable ITEM : Type.\n"));
  CHECK_THAT(coq, Contains("Inductive TREE : Type := | leaf | fork (argument : (TREE * TREE)).\n"));
  CHECK_THAT(coq, Contains("Definition Queue (back : Z) (front : Z) (items : (set (Z * ITEM))) : Prop :="));
  CHECK_THAT(coq, Contains("(exists value1, ((z_app items front value1) /\\ (item_out = value1)))"));
  CHECK_THAT(coq, Contains("(items' = (z_ndres (z_insert front z_empty) items))"));
  CHECK_THAT(coq, Contains("(Queue back front items) /\\ (Queue back' front' items') /\\ ((back' = back)"));
  CHECK_THAT(coq, Contains("Definition claim : Prop :=\n  (forall (back : Z) (front : Z) (items : (set (Z * ITEM))), "
                           "((Queue back front items) -> True)).\n"));
}

TEST_CASE("a name that a text declares is its own, though the toolkit has one beyond its parents") {
  const std::string own =
      "\\begin{zsection} \\SECTION s \\parents function\\_toolkit \\end{zsection}\n"
      "\\begin{axdef} max : \\nat \\pfun \\nat \\end{axdef}\n\\begin{schema}{Queue} n : \\nat \\where n = max~1 "
      "\\end{schema}";
  CHECK_THAT(written(own, ProofAssistant::coq), Contains("(z_app max 1 value1)"));
}

TEST_CASE("the same terms are written in Isabelle's words") {
  const std::string isabelle = written(queue, ProofAssistant::isabelle);
  CHECK_THAT(isabelle, Contains("theory Queue\n  imports Main\nbegin\n"));
  CHECK_THAT(isabelle, Contains("typedecl ITEM\n"));
  CHECK_THAT(isabelle, Contains("datatype TREE = leaf | fork \"(TREE \\<times> TREE)\"\n"));
  CHECK_THAT(isabelle,
             Contains("definition Queue :: \"int \\<Rightarrow> int \\<Rightarrow> ((int \\<times> ITEM) set) "
                      "\\<Rightarrow> bool\" where\n  \"Queue back front items = "));
  CHECK_THAT(isabelle, Contains("(\\<exists>value1. ((z_app items front value1) \\<and> (item_out = value1)))"));
  CHECK_THAT(isabelle, Contains("definition claim :: \"bool\" where"));
  CHECK(isabelle.ends_with("\nend\n"));
}

TEST_CASE("what is written is balanced, and uses what it defines") {
  for (const ProofAssistant prover : {ProofAssistant::coq, ProofAssistant::isabelle}) {
    const std::string text = written(queue, prover);
    CHECK(is_balanced(text));
    const std::string keyword = prover == ProofAssistant::coq ? "Definition " : "definition ";
    for (const std::string& word : words_with(text, "z_")) {
      CAPTURE(word);
      CHECK(text.find(keyword + word + " ") != text.npos);
    }
  }
  CHECK_FALSE(is_balanced("(()"));
  CHECK_FALSE(is_balanced(")("));
}

TEST_CASE("both languages have the same toolkit") {
  const auto defined = [](ProofAssistant prover) {
    auto words = words_with(written("\\begin{zed} [ A ] \\end{zed}\n", prover, "true"), "z_");
    for (const char* word : {"z_all", "z_finite", "z_functional"}) words.erase(word);  // Isabelle has its own
    return words;
  };
  CHECK(defined(ProofAssistant::coq) == defined(ProofAssistant::isabelle));
  CHECK(defined(ProofAssistant::coq).size() > 40);
}

TEST_CASE("names that the languages keep, or that hide others, are changed") {
  const std::string text = written(R"(
\begin{zed} [ Type ] \end{zed}
\begin{schema}{S} end : Type \\ S1, leaf : \nat \where \exists leaf : \nat @ leaf = S1 \end{schema}
)",
                                   ProofAssistant::coq, "∀ S • true");
  CHECK_THAT(text, Contains("Variable Type_z : Type."));
  CHECK_THAT(text, Contains("(end_z : Type_z)"));
}

TEST_CASE("a form that higher-order logic has no rule for is refused at its place") {
  CHECK_THAT(
      refusal("\\begin{zed} P[X] == \\power X \\end{zed}\n"),
      Contains("queue.tex:") && Contains("a generic definition has no rule of translation to higher-order logic; "));
  CHECK_THAT(refusal("\\begin{zed} T == [~ x : \\nat \\cross \\nat \\cross \\nat ~] \\end{zed}\n"),
             Contains("the type 𝔸 × 𝔸 × 𝔸 has no rule"));
  CHECK_THAT(refusal("\\begin{zed} N ::= none | some \\ldata \\nat \\rdata \\end{zed}\n"),
             Contains("a constructor for members of a smaller set has no rule"));
  CHECK_THAT(refusal("\\begin{zed} R == Leave \\semi Leave \\end{zed}\n"),
             Contains("this schema expression has no rule"));
  CHECK_THAT(refusal("\\begin{zed} D == 7 \\div 2 \\end{zed}\n"), Contains("has no rule"));
}

}  // namespace durero::zed
