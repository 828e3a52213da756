#!/usr/bin/env python3
"""Small right and wrong specifications for zcheck, and CZT's words as czt.sh judges them."""
import contextlib
import io
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import zcheck

HERE = pathlib.Path(__file__).parent
CORPUS = HERE.parent / "zed" / "corpus"
HEAD = r"""\begin{zsection}
  \SECTION prueba \parents standard\_toolkit
\end{zsection}
\begin{zed} [ Cosa ] \end{zed}
\begin{schema}{Estado}
  cosas : \finset Cosa \\
  peso : Cosa \pfun \num
\where
  \dom peso = cosas
\end{schema}
"""


def checked(text):
    """The exit status and the lines of zcheck on one file."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "prueba.tex")
        path.write_text(text, encoding="utf-8")
        with contextlib.redirect_stdout(io.StringIO()) as out:
            status = zcheck.main([str(path)])
        return status, out.getvalue().replace(str(path), "prueba.tex").splitlines()


def zed(body):
    return HEAD + "\\begin{zed}\n  " + body + "\n\\end{zed}\n"


def schema(declarations, predicates):
    return HEAD + f"\\begin{{schema}}{{S}}\n  {declarations}\n\\where\n  {predicates}\n\\end{{schema}}\n"


FREE = zed(r"Forma ::= nada | bola \ldata [~ x : \num ~] \rdata | par \ldata Forma \cross Forma \rdata")

RIGHT = [
    zed(r"A == \{~ n : \num | 0 \leq n < 3 @ (n, n * n) ~\}"),
    zed(r"A == \lambda Estado; c : Cosa | c \in cosas @ peso(c) + 1"),
    zed(r"A == \lambda Estado @ \bigcup \{~ c : cosas @ \{ c, c \} ~\}"),
    zed(r"A == (\lambda Estado @ \theta Estado)"),
    zed(r"A == [~ Estado | cosas = \emptyset ~] \lor (Estado \hide (peso) \land \lnot Estado)"),
    zed(r"A == (Estado \hide (peso)) \semi (Estado \hide (cosas)) \land [~ \Delta Estado ~]"),
    zed(r"\vdash? \forall \Delta Estado @ [~ \Delta Estado ~] \semi [~ \Delta Estado ~] \iff cosas' = cosas"),
    zed(r"A == \lambda s : \seq \num | s \neq \langle \rangle @ \langle last(s) \rangle \cat front(s) \cat \langle head(s) \rangle"),
    zed(r"A ::= uno | dos"),
    schema(r"\Delta Estado \\ c? : Cosa", "cosas' = \\emptyset % x\n\\also\n" + r"peso' = \{ c? \} \ndres peso"),
    schema(r"\Xi Estado \\ n! : \num", r"\exists c : cosas @ n! = peso(c) \land peso \limg cosas \rimg = \ran peso"),
    schema(r"Estado~' ", r"\theta Estado~' = \theta Estado~' \land \dom (peso' \inv) = \{ 1 \} \implies cosas' \neq \emptyset"),
    schema(r"x, y : \num", r"x = \IF y > 0 \THEN y \ELSE -y"),
    schema(r"f : \num \fun \num \fun \num", r"\forall a, b : \num @ f~a~b = f(a)(b)"),
    schema(r"f : \num \fun \num; fa, x1 : \num", "f\na = x 1"),
    zed(r"A == (\num \cross \num) \dres (\_ + \_)"),
    zed("A == \\{~ n : \\num | \\\\\n\\t1 n > 0 ~\\}"),
    schema(r"s : \power Estado", r"\forall e : s @ e.cosas = \dom e.peso"),
    zed(r"\vdash? \forall Estado @ \pre (Estado \land [~ n! : \num; peso' : \power Cosa ~]) \iff cosas = \emptyset"),
    schema(r"Estado \\ cosas : \power Cosa", r"\exists_1 c : Cosa @ c \in cosas"),
    FREE + zed(r"A == par \limg \{~ n : \num @ nada \mapsto bola \lblot x == n \rblot ~\} \rimg \cup \{ nada \}")[len(HEAD):],
    zed(r"A == [~ e : (\exists cosas : \power Cosa @ Estado \land [~ n : \num ~]) | e.peso = \emptyset \land e.n = 1 ~]"),
]

WRONG = [  # the text, the line, what the message says
    (zed(r"A == \{~ n : \num | n \in Cosa ~\}"), 12, "membership"),
    (zed(r"A == \{ 1, Cosa \}"), 12, "member of a set"),
    (zed(r"A == cosas"), 12, "cosas is not declared"),
    (zed(r"A ::= \{~ n : \num | n > 0 ~\}"), 12, "introduces a new type"),
    (zed(r"A == \lambda Estado @ \theta Cosa"), 12, "a schema is expected"),
    (zed(r"A == Estado \hide (altura)"), 12, "not a component to hide"),
    (zed(r"A == [~ cosas' : \num ~] \semi Estado"), 12, "component cosas"),
    (zed(r"A == Estado \land Cosa"), 12, "a schema is expected"),
    (zed(r"A == \langle 1 \rangle \cat \{ 1 \}"), 12, "operand of"),
    (zed(r"A == last(1)"), 12, "argument"),
    (zed(r"A == (1, 2).x"), 12, "no component x"),
    (zed(r"\vdash? Cosa = 1"), 12, "equality"),
    (zed(r"\vdash? \forall e : \num @ \pre Estado"), 12, "is not declared"),
    (zed(r"A == 1 +"), 13, "expected an expression"),
    (zed(r"A == ((1)"), 13, "expected ), found end"),
    (zed(r"A == \{~ n : \num | n > 0 @ ~\}"), 12, "expected an expression"),
    (schema(r"\Delta Estado", "peso'' = peso"), 14, "peso'' is not declared"),
    (schema(r"Estado'", r"1 = 1"), 12, "Estado' is not declared; the schema Estado is decorated as Estado~'"),
    (schema(r"\Delta Estado", r"\theta Estado' = \theta Estado"), 14, "Estado' is not declared"),
    (schema(r"Cosa~'", r"1 = 1"), 12, "a schema is expected"),
    (schema(r"f : \num \fun \num; a : \num", r"f a = f~a"), 14, "fa is not declared"),
    (zed(r"A == (\_ \cup \_)"), 12, "as an operator"),
    (schema(r"Estado", r"peso(1) = 1"), 14, "argument"),
    (schema(r"Estado", r"cosas = peso"), 14, "equality"),
    (schema(r"Estado", r"cosas(1) = 1"), 14, "a function is expected"),
    (schema(r"Estado", r"cosas \cup \{ 1 \} = cosas"), 14, r"operand of \cup"),
    (schema(r"Estado", r"\{ 1 \} \ndres peso = peso"), 14, r"operand of \ndres"),
    (schema(r"Estado", r"cosas \leq cosas"), 14, r"operand of \leq"),
    (schema(r"Estado", r"cosas = \IF 1 = 1 \THEN cosas \ELSE 1"), 14, "branches of if"),
    (schema(r"Estado", r"\dom peso \subseteq \{ 1 \}"), 14, "inclusion"),
    (schema(r"Estado \\ cosas : \num", r"1 = 1"), 12, "declared twice"),
    (schema(r"x : 1", r"1 = 1"), 12, "a set is expected"),
    (schema(r"Cosa", r"1 = 1"), 12, "a schema is expected"),
    (zed(r"Op == [~ \Delta Estado ~]") + "\\begin{schema}{S}\n\\Delta Op\n\\end{schema}\n", 15, "Δ and Ξ"),
    (FREE + zed(r"A == bola \lblot x == nada \rblot")[len(HEAD):], 15, "argument"),
    (zed(r"A == [~ e : (\exists cosas : \power Cosa @ Estado) | e.cosas = \emptyset ~]"), 12, "no component cosas"),
    (zed(r"A == \exists cosas : \num @ Estado"), 12, "component cosas"),
    (HEAD + "\\begin{zed}\n[ Otra ]\n", 11, "never ended"),
    (HEAD.replace("standard", "otro"), 2, "there is no section"),
    (r"no section", 1, "does not begin with a section"),
]


# Right texts with notation that spec/ does without: generic schemas, compositions, LET, parts of the toolkit and the like.
NOT_READ = """
    abbreviation_generic arithmetic arrows composition_of_relations disjoint
    generic_actuals lambda_before_relation lambda_guarded let_in operator_as_set
    operator_of_a_section_without_toolkit products
    relation_by_name schema_generic schema_implication schema_piping
    schema_projection schema_quantified schema_renaming signature_found_later space_commands
    template_of_unseen_signs toolkit_name_beyond_parents toolkit_of_two_parents zword
"""
# Wrong ones that it takes: a product in parentheses is to it the product without, an actual may stay open, and it compares
# no associativities.
NOT_SEEN = "product_nesting undetermined operators_of_two_sides operator_beside_the_toolkit"


class Zcheck(unittest.TestCase):
    def test_right(self):
        for text in RIGHT:
            self.assertEqual((0, []), checked(text), text)

    def test_wrong(self):
        for text, line, message in WRONG:
            status, lines = checked(text)
            self.assertEqual(1, status, text)
            self.assertTrue(any(f"prueba.tex:{line}:" in out and message in out for out in lines), (text, lines))

    def test_the_differences_from_other_checkers(self):
        """Files of the corpus that begin with a difference's number: this reader judges them as the program does."""
        files = [f for f in sorted(CORPUS.glob("*/*.tex")) if re.match(r"% D\d+:", f.read_text(encoding="utf-8"))]
        self.assertGreater(len(files), 40)
        for path in files:
            lines = path.read_text(encoding="utf-8").split("\n")
            marked = {n for n, line in enumerate(lines, 1) if line.endswith("% here")}
            with contextlib.redirect_stdout(io.StringIO()) as out:
                zcheck.main([str(path)])
            said = [line for line in out.getvalue().splitlines() if "Δ and Ξ double a state" not in line]  # an opinion
            self.assertEqual(marked, {int(line[len(str(path)) + 1:].split(":")[0]) for line in said}, (path.name, said))

    def test_the_rest_of_the_corpus(self):
        """It is judged as the program judges it, but for what this reader does not read, or does not see."""
        for folder, status, others in (("right", 0, NOT_READ), ("wrong", 1, NOT_SEEN)):
            differing = set()
            for path in sorted((CORPUS / folder).glob("*.tex")):
                with contextlib.redirect_stdout(io.StringIO()) as out:
                    answer = zcheck.main([str(path)])
                opinion = all("Δ and Ξ double a state" in line for line in out.getvalue().splitlines())
                if (0 if opinion else answer) != status:
                    differing.add(path.stem)
            self.assertEqual(set(others.split()), differing, folder)

    def test_one_defect_hides_no_other(self):
        lines = checked(zed(r"A == 1 +") + zed("B == nada")[len(HEAD):])[1]
        self.assertEqual(2, len(lines), lines)


class Czt(unittest.TestCase):
    """czt.sh with a java that says what CZT would."""

    def judged(self, says, status=0, jar="czt.jar"):
        with tempfile.TemporaryDirectory() as folder:
            java, spec = pathlib.Path(folder, "java"), pathlib.Path(folder, "prueba.tex")
            java.write_text(f"#!/bin/sh\ncat <<'END'\n{says}\nEND\nexit {status}\n")
            java.chmod(0o755)
            spec.write_text(HEAD, encoding="utf-8")
            env = dict(os.environ, CZT_JAR=jar, PATH=folder + ":" + os.environ["PATH"])
            run = subprocess.run([HERE / "czt.sh", spec], env=env, capture_output=True, text=True)
            return run.returncode, run.stdout.replace(folder + "/", "")

    def test_absent(self):
        status, out = self.judged("", jar="")
        self.assertEqual(77, status)
        self.assertIn("skipped: CZT absent", out)

    def test_accepted(self):
        self.assertEqual((0, ""), self.judged("Summary information for section prueba"))

    def test_refused(self):
        said = 'ERROR "prueba.tex", line 7, column 3: Undeclared identifier\n\nSummary information for section prueba'
        self.assertEqual((1, "prueba.tex:8: Undeclared identifier\n"), self.judged(said, 1))  # CZT counts from 0

    def test_syntax_error_leaves_the_section_unchecked(self):
        self.assertEqual((1, "prueba.tex:1: CZT did not check section prueba\n"), self.judged("it broke", 0))


if __name__ == "__main__":
    unittest.main()
