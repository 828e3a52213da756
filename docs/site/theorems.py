"""The final theorems, as proofs/Main*.v state them: their texts, their labels, what they assume and where they are proved."""
import dataclasses
import functools
import re
import subprocess

from docutils.nodes import make_id

FILES = ["MainText.v", "MainModels.v", "MainMeshes.v", "MainHistory.v", "Main.v"]
STATED = r"(?:Theorem|Lemma|Corollary|Proposition|Fact|Remark|Example)"
PART = re.compile(r"^\(\*\* \* (.*?)(?: \*\)|\n)", re.M)
COMMENT = r"(?:\(\*\*(?:(?!\*\)).)*\*\)\n)?"
THEOREM = re.compile(rf"^({COMMENT})(Theorem (\w+).*?)^Proof\.?(.*?)(?:Qed|Defined)\.", re.S | re.M)


@dataclasses.dataclass
class Theorem:
    name: str
    file: str
    line: int
    part: str  # the part of the file that it stands in
    comment: str
    text: str
    given: str  # the variables and hypotheses of the section of Coq that it stands in
    lemmas: list  # (file, name) of what its proof refers to
    finals: list  # the final theorems that its proof refers to
    labels: dict = dataclasses.field(default_factory=dict)  # of each the lemma that discharges it
    axioms: list = dataclasses.field(default_factory=list)
    says: str = ""

    @property
    def anchor(self):
        return make_id(self.name)


def context(text):
    """What of the open sections of Coq a theorem at the end of the text rests on."""
    opened = []
    for line in text.splitlines():
        if match := re.match(r"Section (\w+)\.", line):
            opened.append((match[1], []))
        elif opened and re.match(rf"End {opened[-1][0]}\.", line):
            opened.pop()
        elif opened:
            opened[-1][1].append(line)
    lines, wanted = [line for _, part in opened for line in part], []
    is_open = False
    for line in lines:
        if re.match(r"(Variables?|Hypothes[ie]s|Let|Notation|Implicit|Context|Local Notation)\b", line):
            is_open = True
        if is_open:
            wanted.append(line)
            is_open = not line.rstrip().endswith(".")
    return "\n".join(wanted)


@functools.cache
def lemmas(root):
    """Of each name that proofs/*.v state and prove, the files that do."""
    found = {}
    for file in sorted((root / "proofs").glob("*.v")):
        for name in re.findall(rf"^ *{STATED} (\w+)", file.read_text(encoding="utf-8"), re.M):
            found.setdefault(name, []).append(file.name)
    return found


def referred(root, proof, near):
    """The lemmas of other files that a proof of Main*.v refers to."""
    known, found = lemmas(root), []
    for module, name in re.findall(r"\b(?:([A-Z]\w*)\.)?([A-Za-z_]\w*)", proof):
        files = [file for file in known.get(name, []) if not file.startswith("Main")]
        if module:
            files = [file for file in files if file == f"{module}.v"]
        else:
            files = [file for file in files if file.removesuffix(".v") in near][-1:]
        found += [(file, name) for file in files]
    return list(dict.fromkeys(found))


@functools.cache
def discharged(root):
    """Of each lemma, (file, name), the labels that its comment says it discharges."""
    index = subprocess.run(["sh", "cmake/label_index.sh"], cwd=root, check=True, capture_output=True, encoding="utf-8").stdout
    found = {}
    for row in index.splitlines():
        label, kind, place, *name = row.split("\t")
        if kind == "theorem":
            found.setdefault((place.partition(":")[0].removeprefix("proofs/"), name[0]), []).append(label)
    return found


@functools.cache
def final_names(root):
    return {match[3] for file in FILES for match in THEOREM.finditer((root / "proofs" / file).read_text(encoding="utf-8"))}


def finals_in(root, proof, name):
    return [word for word in dict.fromkeys(re.findall(r"\w+", proof)) if word in final_names(root) and word != name]


def stated(text):
    """The labels of the axioms and conjectures that a statement names."""
    return [re.sub(r"_(axiom|conj)_(\d+)$", r".\1.\2", word) for word in re.findall(r"\b\w+_(?:axiom|conj)_\d+\b", text)]


def of_file(root, file):
    text = (root / "proofs" / file).read_text(encoding="utf-8")
    for match in THEOREM.finditer(text):
        comment, statement, name, proof = match.groups()
        before = text[:match.start()]
        parts = PART.findall(before)
        part = re.sub(r"^\d+\. ", "", parts[-1]) if parts else file
        yield Theorem(name, file, before.count("\n") + comment.count("\n") + 1, part, comment.rstrip(), statement.rstrip(),
                      context(before), referred(root, proof, imported(text)), finals_in(root, proof, name))


def shared_end(a, b):
    """How many letters two names end with alike."""
    return next((i for i, (x, y) in enumerate(zip(reversed(a), reversed(b))) if x != y), min(len(a), len(b)))


def sentences(root, names):
    """Of each theorem the sentence of proofs/README.md. A row may be of several; `octrees_…` stands for the one that goes on
    as the first of its row does."""
    page, says = (root / "proofs" / "README.md").read_text(encoding="utf-8"), {}
    for cell, sentence in re.findall(r"^\| ((?:`\w+…?`(?:, )?)+) \| (.*) \|$", page, re.M):
        first, *others = re.findall(r"`(\w+…?)`", cell)
        for word in [first, *others]:
            if word.endswith("…"):
                word = max((name for name in names if name.startswith(word[:-1])), key=lambda name: shared_end(name, first))
            says[word] = sentence
    return says


def imported(text):
    """The modules whose names a file uses without a prefix."""
    return set(re.findall(r"\w+", " ".join(re.findall(r"^(?:From \w+ )?(?:Require )?(?:Import|Export) (.*?)\.$", text, re.S | re.M))))


@functools.cache
def references(root):
    """Of each lemma, (file, name), the lemmas of these files that its proof refers to."""
    known, found = lemmas(root), {}
    for file in sorted((root / "proofs").glob("*.v")):
        text = file.read_text(encoding="utf-8")
        near = {f"{module}.v" for module in imported(text)}
        for name, body in re.findall(rf"^ *{STATED} (\w+)(.*?)(?:Qed|Defined)\.", text, re.S | re.M):
            of = found.setdefault((file.name, name), [])
            for module, word in re.findall(r"\b(?:([A-Z]\w*)\.)?([A-Za-z_]\w*)", body):
                files = known.get(word, [])
                mine = [f"{module}.v"] if module else [file.name] if file.name in files else [other for other in files if other in near][-1:]
                of += [(other, word) for other in mine if other in files and (other, word) != (file.name, name)]
    return found


def nearest_labels(root, starts):
    """The labels that lemmas discharge; of a lemma without any, those of the lemmas that its proof rests on."""
    found, seen, waiting = [], set(), list(starts)
    while waiting:
        lemma = waiting.pop(0)
        if lemma in seen:
            continue
        seen.add(lemma)
        if labels := discharged(root).get(lemma):
            found += [(label, lemma) for label in labels]
        else:
            waiting += references(root).get(lemma, [])
    return found


@functools.cache
def all_of(root):
    rows = (root / "proofs" / "assumptions.txt").read_text(encoding="utf-8").splitlines()
    axioms = {name: rest.split() for name, _, rest in (row.partition(":") for row in rows)}
    found = [theorem for file in FILES for theorem in of_file(root, file)]
    says = sentences(root, [theorem.name for theorem in found])
    for theorem in found:
        own = [(label, (theorem.file, theorem.name)) for label in stated(theorem.text)]
        own += nearest_labels(root, [(theorem.file, theorem.name), *theorem.lemmas])
        for label, lemma in own:
            theorem.labels.setdefault(label, lemma)
        theorem.axioms, theorem.says = axioms.get(theorem.name, []), says.get(theorem.name, "")
    return found


def slug(part):
    return "-".join(make_id(part).split("-")[:6])


def doc_of(theorem):
    return f"maps/proofs/{slug(theorem.part)}"


@functools.cache
def places(root):
    """Of each final theorem the page of the site, and its anchor there."""
    return {theorem.name: (doc_of(theorem), theorem.anchor) for theorem in all_of(root)}
