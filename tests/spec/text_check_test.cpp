#include "durero/spec/text_check.hpp"

#include "durero/spec/constants.hpp"
#include "durero/zed/types/typecheck.hpp"
#include "support/catch.hpp"

namespace durero::spec {
namespace {

/// A text with its types, which a check refers to.
struct Read {
  zed::Specification text;
  zed::Typing typing;
};
Read read(const std::string& body) {
  Read made{zed::read_texts({{"t.tex", body}}), {}};
  made.typing = zed::check(made.text);
  return made;
}

TextCheck checked(const Read& of, const TextCheckSetup& setup = {}, const std::string& labels = "") {
  return check_text(of.text, of.typing, {"t.tex"}, setup, LabelIndex(labels));
}

TEST_CASE("a text without a defect is told by its sections and its conjectures") {
  const Read of = read("\\begin{zed}\n N == 1 \\\\\n \\vdash? N = 1 % N.conj.1\n\\end{zed}\n");
  const TextCheck check = checked(of);
  CHECK(check.is_read());
  CHECK_FALSE(check.is_refuted());
  CHECK(check.lines() == "t.tex: section Specification ok, 2 paragraphs\nt.tex:3:2: conjecture N.conj.1 is true\n");
  CHECK(checked(of, {}, "N.conj.1\ttheorem\tproofs/N.v:1\tN_is_one\n").conjectures.at(0).text() ==
        "t.tex:3:2: conjecture N.conj.1 proved as N_is_one; is true\n");
  CHECK(check.untried() == 0);
  CHECK(checked(of, {.states = 0}).untried() == 1);
  CHECK(checked(of, {.states = 0}).lines() ==
        "t.tex: section Specification ok, 2 paragraphs\nt.tex:3:2: conjecture N.conj.1 not tried: no state is asked "
        "for\n");
}

TEST_CASE("a false conjecture is refuted by a state, whatever theorem is named") {
  const Read of = read("\\begin{zed}\n \\vdash? \\forall n : 1 \\upto 2 @ n = 1 % N.conj.1\n\\end{zed}\n");
  const TextCheck check = checked(of, {}, "N.conj.1\ttheorem\tproofs/N.v:1\tN_is_one\n");
  CHECK(check.is_read());
  CHECK(check.is_refuted());
  CHECK(check.conjectures.at(0).text() == "t.tex:2:2: conjecture N.conj.1 is false, as in this state:\n  n = 2\n");
}

TEST_CASE("an error keeps conjectures from being tried, and an opinion is one where it is asked for") {
  const TextCheck wrong = checked(read("\\begin{zed}\n N == M \\\\\n \\vdash? 1 = 1\n\\end{zed}\n"));
  CHECK_FALSE(wrong.is_read());
  CHECK(wrong.conjectures.empty());
  CHECK(wrong.lines() == "t.tex:2:7: M is not declared; expected a declared name\n");
  const Read loose =
      read("\\begin{schema}{S}\n n : \\nat\n\\end{schema}\n\\begin{schema}{Op}\n \\Delta S\n\\end{schema}\n");
  CHECK(checked(loose).is_read());
  CHECK_FALSE(checked(loose, {.strict = true}).is_read());
}

TEST_CASE("a file without a paragraph was meant to hold one") {
  const TextCheck check = checked(read("Nothing.\n"));
  CHECK_FALSE(check.is_read());
  CHECK(check.lines() ==
        "t.tex:1:1: no Z paragraph; expected \\begin{zed}, axdef, schema, gendef or zsection, or a box of Unicode\n");
}

TEST_CASE("a constant has the value that the setup gives it, or the setup is wrong") {
  const Read of = read("\\begin{axdef}\n N : \\nat\n\\end{axdef}\n\\begin{zed}\n \\vdash? N = 7\n\\end{zed}\n");
  CHECK_FALSE(checked(of, {.let = {"N=7"}}).is_refuted());
  CHECK(checked(of, {.let = {"N=8"}}).is_refuted());
  CHECK_THROWS_AS(checked(of, {.let = {"M=8"}}), ConstantError);
}

}  // namespace
}  // namespace durero::spec
