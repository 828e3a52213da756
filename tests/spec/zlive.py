#!/usr/bin/env python3
"""Closed predicates, decided by ZLive, the animator of CZT, and by durero spec check.

    zlive.py DURERO

CZT_JAR is CZT's jar with ZLive, which czt_build.sh builds. 400 predicates are put together at random, of numbers, sets,
relations, sequences and quantifiers; Python's own sets say which are true, and Durero is never to say otherwise. ZLive decides a
few of them wrongly, at most one in twenty, and leaves some open or undefined.

The conjectures of ZLive's own tests are asked, too, where the folder DURERO_ZLIVE has them (zlive/src/test/resources/animate_*.tex of
CZT). Either may leave one open; one that ZLive calls undefined is not true here. zlive_differences.tsv has a row for other
differences: a part of the predicate, what Durero and ZLive say, and the reason.

DURERO_SEED begins the random predicates. Exit status: 0 all is so; 1 not, a line each; 77 CZT is absent.
"""
import collections
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
PREDICATES = 400
CONJECTURE = re.compile(r"^[^ ]*:(\d+):\d+: conjecture(.*)$", re.M)


class Terms:
    """Random closed terms: each the text in ISO's LaTeX, and a function of the numbers that are declared around it, which
    gives its value by Python's sets. A relation is a set of pairs, a sequence a tuple. Python's // and % round down, as ISO's do."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.names = []

    def any_of(self, *makers):
        return self.random.choice(makers)()

    def two(self, signs, left, right):
        """A term of two operands, by a sign of `signs`, which has the values."""
        sign = self.random.choice(list(signs))
        (text, value), (other, other_value) = left(), right()
        return f"({text} {sign} {other})", lambda names: signs[sign](value(names), other_value(names))

    def one(self, before, after, operand, apply):
        text, value = operand()
        return f"({before}{text}{after})", lambda names: apply(value(names))

    def literal(self):
        value = self.random.randint(-2, 5)
        return (str(value) if value >= 0 else f"(\\negate {-value})"), lambda _: value

    def some(self, maker, opening, closing, together):
        made = [maker() for _ in range(self.random.randint(1, 3))]
        return opening + ", ".join(text for text, _ in made) + closing, lambda names: together(value(names) for _, value in made)

    def atom(self):
        if self.names and self.random.random() < 0.5:
            name = self.random.choice(self.names)
            return name, lambda names: names[name]
        return self.literal()

    def divisor(self):
        value = self.random.choice([2, 3, -2])
        return (str(value) if value > 0 else f"(\\negate {-value})"), lambda _: value

    def number(self, depth):
        if depth == 0 or self.random.random() < 0.2:
            return self.atom()
        less = depth - 1
        return self.any_of(
            lambda: self.two(SUMS, lambda: self.number(less), lambda: self.number(less)),
            lambda: self.two(QUOTIENTS, lambda: self.number(less), self.divisor),
            lambda: self.one(r"\# ", "", lambda: self.set(less), len),
            lambda: self.one(r"\# ", "", lambda: self.sequence(less), len))

    def set(self, depth):
        less = depth - 1
        if depth == 0:
            return self.some(self.atom, r"\{", r"\}", frozenset)
        return self.any_of(
            lambda: self.two(RANGE, self.literal, self.literal),
            lambda: self.two(SETS, lambda: self.set(less), lambda: self.set(less)),
            lambda: self.one(r"\dom ", "", lambda: self.relation(less), lambda r: frozenset(a for a, _ in r)),
            lambda: self.one(r"\ran ", "", lambda: self.relation(less), lambda r: frozenset(b for _, b in r)),
            lambda: self.image(less),
            lambda: self.comprehension(depth))

    def image(self, depth):
        (text, value), (under, under_value) = self.relation(depth), self.set(depth)
        return rf"({text} \limg {under} \rimg)", lambda names: frozenset(
            b for a, b in value(names) if a in under_value(names))

    def relation(self, depth):
        less = depth - 1
        if depth == 0:
            return self.some(self.pair, r"\{", r"\}", frozenset)
        return self.any_of(
            lambda: self.two(DOMAINS, lambda: self.set(less), lambda: self.relation(less)),
            lambda: self.two(RANGES, lambda: self.relation(less), lambda: self.set(less)),
            lambda: self.two(RELATIONS, lambda: self.relation(less), lambda: self.relation(less)),
            lambda: self.two(PRODUCT, lambda: self.set(0), lambda: self.set(0)),
            lambda: self.one("", r" \inv", lambda: self.relation(less), lambda r: frozenset((b, a) for a, b in r)),
            lambda: self.one(r"\id ", "", lambda: self.set(less), lambda s: frozenset((a, a) for a in s)))

    def pair(self):
        (text, value), (other, other_value) = self.atom(), self.atom()
        return rf"{text} \mapsto {other}", lambda names: (value(names), other_value(names))

    def sequence(self, depth):
        if depth == 0:
            return self.some(self.atom, r"\langle ", r" \rangle", tuple)
        return self.any_of(
            lambda: self.two(JOIN, lambda: self.sequence(depth - 1), lambda: self.sequence(depth - 1)),
            lambda: self.two(FILTER, lambda: self.sequence(0), lambda: self.set(depth - 1)),
            lambda: self.one("rev~", "", lambda: self.sequence(depth - 1), lambda q: q[::-1]),
            lambda: self.one("tail~", "", lambda: self.sequence(0), lambda q: q[1:]),
            lambda: self.one("front~", "", lambda: self.sequence(0), lambda q: q[:-1]))

    def bound(self, depth, *bodies):
        """A declared name, its set, and what is made in its scope."""
        among = self.set(max(depth - 2, 0))
        name = "xyzuvw"[len(self.names)]
        self.names.append(name)
        made = [body() for body in bodies]
        self.names.pop()
        return name, among, made

    def comprehension(self, depth):
        name, (among, members), ((such, holds), (text, value)) = self.bound(
            depth, lambda: self.predicate(depth - 1), lambda: self.number(depth - 1))
        scopes = lambda names: ({**names, name: each} for each in members(names))
        return rf"\{{~ {name} : {among} | {such} @ {text} ~\}}", lambda names: frozenset(
            value(inner) for inner in scopes(names) if holds(inner))

    def quantified(self, depth):
        sign = self.random.choice(list(QUANTIFIERS))
        name, (among, members), ((such, holds),) = self.bound(depth, lambda: self.predicate(depth - 1))
        return rf"({sign} {name} : {among} @ {such})", lambda names: QUANTIFIERS[sign](
            holds({**names, name: each}) for each in members(names))

    def predicate(self, depth):
        less = max(depth - 1, 0)
        kinds = [
            lambda: self.two(ORDERS, lambda: self.number(depth), lambda: self.number(depth)),
            lambda: self.two(MEMBERS, lambda: self.number(less), lambda: self.set(depth)),
            lambda: self.two(INCLUSIONS, lambda: self.set(depth), lambda: self.set(depth)),
            lambda: self.two(INCLUSIONS, lambda: self.relation(depth), lambda: self.relation(depth)),
            lambda: self.two(EQUAL, lambda: self.sequence(depth), lambda: self.sequence(less)),
        ]
        if depth > 0 and len(self.names) < 3:
            kinds += 2 * [
                lambda: self.one(r"\lnot ", "", lambda: self.predicate(less), lambda p: not p),
                lambda: self.two(CONNECTIVES, lambda: self.predicate(less), lambda: self.predicate(less)),
                lambda: self.quantified(depth),
            ]
        return self.random.choice(kinds)()


def overridden(left, right):
    return right | {(a, b) for a, b in left if a not in {c for c, _ in right}}


def composed(left, right):
    return frozenset((a, d) for a, b in left for c, d in right if b == c)


SUMS = {"+": lambda a, b: a + b, "-": lambda a, b: a - b, "*": lambda a, b: a * b}
QUOTIENTS = {r"\div": lambda a, b: a // b, r"\mod": lambda a, b: a % b}
RANGE = {r"\upto": lambda a, b: frozenset(range(a, b + 1))}
SETS = {r"\cup": lambda a, b: a | b, r"\cap": lambda a, b: a & b, r"\setminus": lambda a, b: a - b, r"\symdiff": lambda a, b: a ^ b}
DOMAINS = {r"\dres": lambda s, r: frozenset(p for p in r if p[0] in s), r"\ndres": lambda s, r: frozenset(p for p in r if p[0] not in s)}
RANGES = {r"\rres": lambda r, s: frozenset(p for p in r if p[1] in s), r"\nrres": lambda r, s: frozenset(p for p in r if p[1] not in s)}
RELATIONS = {r"\oplus": overridden, r"\comp": composed, r"\circ": lambda a, b: composed(b, a), r"\cup": lambda a, b: a | b}
PRODUCT = {r"\cross": lambda a, b: frozenset((x, y) for x in a for y in b)}
JOIN = {r"\cat": lambda a, b: a + b}
FILTER = {r"\filter": lambda q, s: tuple(x for x in q if x in s)}
ORDERS = {"=": lambda a, b: a == b, "<": lambda a, b: a < b, r"\leq": lambda a, b: a <= b, r"\neq": lambda a, b: a != b}
MEMBERS = {r"\in": lambda a, s: a in s, r"\notin": lambda a, s: a not in s}
INCLUSIONS = {"=": lambda a, b: a == b, r"\subseteq": lambda a, b: a <= b, r"\neq": lambda a, b: a != b}
EQUAL = {"=": lambda a, b: a == b}
CONNECTIVES = {r"\land": lambda p, q: p and q, r"\lor": lambda p, q: p or q, r"\implies": lambda p, q: not p or q,
               r"\iff": lambda p, q: p == q}
QUANTIFIERS = {r"\forall": all, r"\exists": any, r"\exists_1": lambda each: sum(each) == 1}


def random_text(seed):
    """A text of conjectures, and whether each is true."""
    made = [Terms(seed + i).predicate(3) for i in range(PREDICATES)]
    text = "\\begin{zsection} \\SECTION random \\parents standard\\_toolkit \\end{zsection}\n"
    text += "".join(f"\\begin{{zed}} \\vdash? {claim} \\end{{zed}}\n" for claim, _ in made)
    return text, ["true" if value({}) else "false" for _, value in made]


def as_paragraphs(text):
    """A text of ZLive's tests, with its theorems as ISO Z writes them."""
    text = re.sub(r"\\begin\{theorem\}\{[^}]*\}", r"\\begin{zed}", text).replace("\\end{theorem}", "\\end{zed}")
    return text.replace("..", "\\upto ")


def by_durero(durero, file):
    """What Durero says of each conjecture: true, false or open; with its line."""
    done = subprocess.run([durero, "spec", "check", "--quiet", str(file)], capture_output=True, text=True, timeout=600, check=False)
    said = []
    for line, verdict in CONJECTURE.findall(done.stdout):
        said.append((int(line), "open" if "not tried" in verdict else "false" if "is false" in verdict else "true"))
    return said


def by_zlive(jar, files):
    """What ZLive says of each conjecture of each file."""
    words = ["java", "-Xmx1g", "-cp", jar, str(HERE / "ZliveAnswers.java"), *map(str, files)]
    done = subprocess.run(words, capture_output=True, text=True, errors="replace", timeout=1800, check=False)
    said = collections.defaultdict(list)
    for file, answer in re.findall(r"^ANSWER (\S+) (.*)$", done.stdout, re.M):
        said[file].append(answer)
    return said


def differs(mine, other):
    return {mine, other} == {"true", "false"} or (mine == "true" and other == "undefined")


def claims(text, lines):
    """The texts of conjectures that begin in these lines: to the next end of a paragraph."""
    rows = text.split("\n")
    for line in lines:
        row = line - 1
        rest = rows[row] if "\\vdash" in rows[row] or row == 0 else rows[row - 1] + " " + rows[row]
        while "\\end{" not in rest and row + 1 < len(rows):
            row += 1
            rest += " " + rows[row]
        yield " ".join(rest.split())


def judged(name, text, answers, table):
    """The differences of a text of ZLive's, and the rows of the table that tell of some."""
    failures, used = [], set()
    mine, others = answers
    for (line, said), other, claim in zip(mine, others, claims(text, [line for line, _ in mine])):
        if not differs(said, other):
            continue
        row = next((i for i, (part, *pair, _) in enumerate(table) if part in claim and pair == [said, other]), None)
        used.add(row)
        if row is None:
            failures.append(f"{name}:{line}: {said} by Durero, {other} by ZLive: {claim}")
    return failures, used


def main():
    durero = str(pathlib.Path(sys.argv[1]).resolve())
    jar = os.environ.get("CZT_JAR")
    if not jar or not shutil.which("javac"):
        print("skipped: CZT absent (set CZT_JAR to the path of czt.jar), or no javac")
        return 77
    table = [line.split("\t") for line in (HERE / "zlive_differences.tsv").read_text(encoding="utf-8").splitlines()[1:]]
    seed = int(os.environ.get("DURERO_SEED", "20261129"))
    random_claims, values = random_text(seed)
    texts = {"random.tex": random_claims}
    folder = os.environ.get("DURERO_ZLIVE")
    if folder:
        texts |= {file.name: as_paragraphs(file.read_text(encoding="utf-8"))
                  for file in sorted(pathlib.Path(folder).glob("animate_*.tex"))}
    failures, counts, used = [], collections.Counter(), set()
    with tempfile.TemporaryDirectory() as there:
        files = {name: pathlib.Path(there) / name for name in texts}
        for name, text in texts.items():
            files[name].write_text(text, encoding="utf-8")
        zlive = by_zlive(jar, files.values())
        for name, text in texts.items():
            mine, others = by_durero(durero, files[name]), [each.split()[0] for each in zlive[str(files[name])]]
            if not mine or len(mine) != len(others):
                failures.append(f"{name}: {len(mine)} conjectures by Durero, {len(others)} by ZLive: {others[:1]}")
                continue
            counts += collections.Counter((said, other) for (_, said), other in zip(mine, others))
            if name == "random.tex":
                failures += [f"DURERO_SEED={seed + i}: {said} by Durero, {value} by Python, {other} by ZLive: {claim}"
                             for i, ((_, said), other, value, claim) in enumerate(
                                 zip(mine, others, values, text.splitlines()[1:])) if said not in (value, "open")]
                wrong = sum({value, other} == {"true", "false"} for value, other in zip(values, others))
                continue
            found, rows = judged(name, text, (mine, others), table)
            failures += found
            used |= rows
    if folder:
        failures += ["no longer so: " + "\t".join(row) for i, row in enumerate(table) if i not in used]
    alike = counts["true", "true"] + counts["false", "false"]
    print(f"{sum(counts.values())} predicates: {alike} are decided alike; of the random ones ZLive decides {wrong} against Python; "
          + "; ".join(f"Durero {said}, ZLive {other}: {n}" for (said, other), n in sorted(counts.items())))
    print("\n".join(failures))
    return 1 if failures or alike < PREDICATES / 2 or wrong > PREDICATES / 20 else 0


if __name__ == "__main__":
    sys.exit(main())
