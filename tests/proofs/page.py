#!/usr/bin/env python3
"""The page of statements: what the theorems of Main*.v say, and each definition that they reach, for a person to read.

    page.py BUILD_DIRECTORY <ANSWERS        the page, on standard output

The build directory holds the proofs, built. ANSWERS are Coq's own words for all that is reached (audit.sh), a block to
each name: [KIND Durero.FILE.NAME] and its lines; of a theorem also [Proof Durero.FILE.NAME]; at last [the libraries].

The page has the source as it is written: of Main*.v all but the proofs; of another file each sentence that is reached,
with what it names of its section, in the order of the file. A file stands before those that need it. With each goes a
check sum of Coq's words, which have neither sections nor notations nor scopes in them, so that another meaning of the
same text passes no one by. Of a file that a program writes the page has the names and the check sums."""
import functools
import hashlib
import itertools
import pathlib
import re
import subprocess
import sys
import textwrap

from sources import Source

WRITTEN = {"Especificacion": "`durero spec export --coq` writes it from `spec/*.tex`",
           "Formas": "`tests/proofs/formas.cpp` writes it from the headers of `src/trace`"}
AROUND = re.compile(r"(Local |Global )?(Variable|Hypothes|Context|Let\b|Notation|Implicit)")  # what is said around a sentence
TITLE = """# What is proved

`sh tests/proofs/run.sh build/proofs update` writes this page, and `tests/proofs/audit.sh` fails where it is not what the
proofs say. First stand the theorems of `MainText.v`, `MainModels.v`, `MainMeshes.v`, `MainHistory.v` and `Main.v` with the hypotheses of their sections,
then the definitions that they reach, each once, a file before those that need it, and at last the names that they reach
of generated files and of Coq's libraries. The number after a definition or a theorem is a check sum of what Coq
understands by it: where it changes and the text does not, a notation, a scope or a name in it has another meaning. After
a theorem stand the variables and hypotheses of its section that it rests on."""


def blocks(lines):
    """Of each name its block, of each theorem its proof, and the names of the libraries."""
    found = {}
    for line in lines:
        if re.match(r"\[.*\]$", line):
            kind, _, name = line[1:-2].partition(" ")
            own = found.setdefault((kind == "Proof", name.removeprefix("Durero.")), [])
        own.append(line)
    libraries = found.pop((False, "libraries"))[1:]
    says = {name: block for (proof, name), block in found.items() if not proof}
    return says, {name: "".join(block) for (proof, name), block in found.items() if proof}, libraries


def closing(text, at, end):
    """The place of `end` after the place, outside brackets and inner lets."""
    depth = 0
    for token in re.compile(r"[()]|\blet\b|\bin\b|=>").finditer(text, at):
        if depth == 0 and token[0] == end:
            return token.start()
        depth += {"(": 1, "let": 1, ")": -1, "in": -1}.get(token[0], 0)
    raise ValueError("no " + end)


def bound(proof):
    """What a proof as Coq prints it binds before all else: first what the section gives it, then its own arguments."""
    names, at, text = [], 0, re.sub(r"\s+", " ", proof.partition("=")[2]) + " "
    while head := re.compile(r" (fun|let) ").match(text, at):
        if head[1] == "let":
            names.append(re.compile(r"[\w']+").match(text, head.end())[0])
            at = closing(text, head.end(), "in") + len("in")
            continue
        end = closing(text, head.end(), "=>")
        binders = text[head.end():end]
        if not binders.startswith("("):
            binders = f"({binders})"
        at = 0
        while at < len(binders) and binders[at] == "(":
            names += binders[at + 1:].partition(":")[0].split()
            at = closing(binders, at + 1, ")") + 2
        at = end + len("=>")
    return names


def check_sum(block):
    return hashlib.sha256("".join(block).encode()).hexdigest()[:12]


def fenced(text):
    return f"```coq\n{text}\n```"


class Page:
    def __init__(self, build, answers):
        self.build = build
        self.blocks, self.proofs, self.libraries = blocks(answers)
        self.wanted = {}  # of each sentence that is reached, the names that it was reached by
        for name in self.blocks:
            stem, _, rest = name.partition(".")
            if stem not in WRITTEN:
                self.wanted.setdefault(self.source(stem).defining(rest), []).append(name)
        self.around = set()
        self.main = sorted((file.stem for file in build.glob("Main*.v")), reverse=True)  # MainText.v first, Main.v last
        for sentence in [s for stem in self.main for s in self.source(stem).sentences] + list(self.wanted):
            self.surround(sentence)

    @functools.cache
    def source(self, stem):
        return Source(self.build, stem)

    def surround(self, sentence):
        """Adds what the sentence names of its surroundings, and what these name."""
        if sentence.proof:
            return
        near = [self.source(stem).around(name, sentence) for stem, name in sentence.refers if stem not in WRITTEN]
        silent = ("Context", "Implicit", "Hypothes") if sentence.states() else ("Context", "Implicit")  # none names them
        near += [s for s in sentence.source.sentences if s.start < sentence.start and s.kind.startswith(silent)]
        for other in near:
            if other is None or other in self.around or not AROUND.match(other.text):
                continue
            if other.kind == "Notation" or set(other.inside) <= set(sentence.inside):
                self.around.add(other)
                self.surround(other)

    def stems(self):
        """The files that are reached, each after those that it needs: by how many stand below it, one on the other. So what
        is added moves little."""
        told = subprocess.run(["coqdep", "-Q", ".", "Durero", *(file.name for file in self.build.glob("*.v"))],
                              cwd=self.build, capture_output=True, text=True, check=True).stdout
        needs = {}
        for line in told.splitlines():
            target, _, needed = line.partition(": ")
            if re.match(r"(\./)?\w+\.vo\b", target):
                needs[pathlib.Path(target.split()[0]).stem] = re.findall(r"(?:^| )(?:\./)?(\w+)\.vo\b", needed)
        height = functools.cache(lambda stem: 1 + max((height(need) for need in needs[stem]), default=0))
        files = {s.source.stem for s in [*self.wanted, *self.around]} - {*self.main, *WRITTEN}
        return sorted(files, key=lambda stem: (height(stem), stem))

    def rests_on(self, sentence, name):
        """The variables and hypotheses of its section that a theorem rests on."""
        given = sentence.source.given(sentence)
        names = bound(self.proofs[name]) if name in self.proofs else []
        lets = {s.text.split()[1] for s in sentence.source.sentences if s.kind == "Let"}
        mine = itertools.takewhile(lambda v: v in given or v in lets, names)
        return [v for v in mine if v not in lets]

    def mark(self, sentence):
        """The check sum of a sentence that is reached, and what it rests on, as a comment."""
        names = self.wanted.get(sentence)
        if not names:
            return ""
        types = [name for name in names if self.blocks[name][0].startswith("[Inductive")]  # they have their fields in them
        total = check_sum([line for name in sorted(types or names) for line in self.blocks[name]])
        under = self.rests_on(sentence, names[0])
        if not under:
            return f"  (* {total} *)"
        return "\n" + textwrap.fill(f"(* {total} rests on {' '.join(under)} *)", 120, subsequent_indent="   ")

    def statements(self, stem):
        """A file of statements without its proofs, and without what it imports."""
        text = ""
        for sentence in self.source(stem).sentences:
            if sentence.proof:
                continue
            left_out = sentence.kind in ("From", "Import") or "Open Scope" in sentence.text
            text += sentence.before + ("" if left_out else sentence.text + self.mark(sentence))
        return fenced(re.sub(r"\n\s*\n", "\n\n", text.strip("\n")))

    def definitions(self, stem):
        """What is reached of a file, in its order, within its sections."""
        source, lines, last = self.source(stem), [], None
        kept = [s for s in source.sentences if s in self.wanted or s in self.around]
        frame = {opening for s in kept for opening in s.inside}
        for sentence in source.sentences:
            ends = sentence.kind == "End" and sentence.ends in frame
            if sentence not in frame and not ends and sentence not in self.wanted and sentence not in self.around:
                continue
            if last is not None and (last.index + 1 != sentence.index or sentence.comment()) and not ends:
                lines.append("")
            lines.append(sentence.comment() + sentence.shown() + self.mark(sentence))
            last = sentence
        return fenced("\n".join(lines))

    def names(self, stem):
        """The names that are reached of a file that a program writes, in its order."""
        mine = [name for name in self.blocks if name.startswith(stem + ".")]
        mine.sort(key=lambda name: self.source(stem).defining(name.partition(".")[2]).start)
        return "```\n" + "\n".join(f"{name}  {check_sum(self.blocks[name])}" for name in mine) + "\n```"

    def text(self):
        parts = [TITLE]
        parts += [f"## {stem}.v\n\n{self.statements(stem)}" for stem in self.main]
        parts += [f"## {stem}.v\n\n{self.definitions(stem)}" for stem in self.stems()]
        parts += [f"## {stem}.v\n\n{says}:\n\n{self.names(stem)}" for stem, says in WRITTEN.items()
                  if (self.build / f"{stem}.v").exists()]
        return "\n\n".join([*parts, f"## Coq's libraries\n\n```\n{''.join(self.libraries)}```"])


if __name__ == "__main__":
    print(Page(pathlib.Path(sys.argv[1]), sys.stdin).text())
