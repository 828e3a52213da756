"""The pages of the chain: a picture of all parts, and a page a part with its picture and the text of each theorem."""
import functools
import re
import subprocess

import theorems
from graph import Graph

HEAD = """# The chain as a picture

From left to right: the stems of the Z text, the parts of the final theorems (`proofs/MainText.v`, `MainModels.v`,
`MainMeshes.v`, `MainHistory.v` and `Main.v`), and the folders of the program that [the chain](/docs/proofs.md) holds by them. A line
from a stem leads to a part whose theorems discharge labels of that stem; a line to a folder stands for a row of the chain that
names a theorem of the part and a file of the folder. Choose a part: its page has a picture of its theorems, and the text of each, its labels
and its assumptions. This page is made from `proofs/`, `spec/` and `docs/proofs.md`.

{picture}

## The same in words

| part | theorems | discharges labels of | the program |
| --- | --- | --- | --- |
{rows}

All theorems together assume {count} axioms, those of Coq's classical reals:

{axioms}
"""
PART = """# {title}

{count} of [the final theorems](/maps/proofs.md), stated in `proofs/{file}`. From left to right: the stems of the Z text whose labels are
discharged, the files of `proofs/` in which the work is done, the theorems, and the files of the program that
[the chain](/docs/proofs.md) holds by them. The labels of a theorem are those that the lemmas in its proof discharge; of a lemma that discharges
none, those of the lemmas that its own proof rests on.

{picture}

{texts}
"""
CODE = re.compile(r"`((?:src|include)/[\w./-]+)`")


@functools.cache
def arrows(root):
    """Of each theorem the rows of docs/proofs.md that name it: (from, to, by, assumes)."""
    found = {}
    for line in (root / "docs" / "proofs.md").read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip("|").split(" | ")] if line.startswith("| ") else []
        if len(cells) in (3, 4):
            for name in re.findall(r"`(\w+)`", cells[2]):
                found.setdefault(name, []).append([*cells, ""][:4])
    return found


@functools.cache
def stems(root):
    """Of each label where the text has it: file and line."""
    index = subprocess.run(["sh", "cmake/label_index.sh"], cwd=root, check=True, capture_output=True, encoding="utf-8").stdout
    rows = (row.split("\t") for row in index.splitlines())
    found = {row[0]: row[2].split(":") for row in rows if row[1] == "text"}
    for file in sorted((root / "spec").glob("*.tex")):
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            if match := re.search(r"% (\w+\.axiom\.\d+)$", line):
                found[match[1]] = [f"spec/{file.name}", str(number)]
    return found


def stem_of(root, label):
    return stems(root)[label][0]


def code_of(root, theorem):
    """The files of the program in the rows of the chain that name the theorem."""
    cells = " ".join(" ".join(row) for row in arrows(root).get(theorem.name, []))
    return [path for path in dict.fromkeys(CODE.findall(cells)) if (root / path).exists()]


def parts(root):
    found = {}
    for theorem in theorems.all_of(root):
        found.setdefault(theorem.part, []).append(theorem)
    return found


def short(part):
    """A part's name before its colon, comma or bracket."""
    return re.split(r": |, | \(| is so of ", part)[0]


def folder(path):
    return "/".join(path.split("/")[-3:-1] if path.startswith("include") else path.split("/")[:2])


def overview(root):
    graph = Graph("chain", "The chain, from the stems of the Z text through the parts of the theorems to the folders of the program")
    for part, members in parts(root).items():
        key = f"part {theorems.slug(part)}"
        graph.node(key, f"{short(part)} ({len(members)})", "part", f"page:{theorems.doc_of(members[0])}", part)
        for theorem in members:
            for label in theorem.labels:
                file = stem_of(root, label)
                graph.node(file, file, "stem", f"repository:{file}")
                graph.edge(file, key)
            for path in code_of(root, theorem):
                name = "src/" + folder(path).split("/")[-1]
                graph.node(name, name, "code", "page:docs/proofs")
                graph.edge(key, name)
    kinds = {kind: [key for key, node in graph.nodes.items() if node[1] == kind] for kind in ("stem", "part", "code")}
    for kind in ("stem", "part", "code"):
        graph.column(kinds[kind])
    return graph


def picture_of(root, part, members):
    graph = Graph("part", f"{part}: stems of the text, files of proofs, theorems, and files of the program")
    for theorem in members:
        graph.node(theorem.name, theorem.name, "theorem", f"page:{theorems.doc_of(theorem)}#{theorem.anchor}", theorem.says or theorem.name)
        for file, _ in theorem.lemmas:
            graph.node(file, file, "file", f"repository:proofs/{file}")
            graph.edge(file, theorem.name)
        for name in theorem.finals:
            graph.edge(name, theorem.name)
        for label, (file, _) in theorem.labels.items():
            stem = stem_of(root, label)
            graph.node(stem, stem, "stem", f"repository:{stem}")
            direct = file in {lemma[0] for lemma in theorem.lemmas}
            graph.edge(stem, file if direct else theorem.name)
        for path in code_of(root, theorem):
            graph.node(path, path.removeprefix("include/durero/"), "code", f"repository:{path}" if (root / path).is_file() else "page:docs/proofs")
            graph.edge(theorem.name, path)
    for kind in ("stem", "file", "theorem", "code"):
        graph.column([key for key, node in graph.nodes.items() if node[1] == kind])
    return graph


def place_of(root, label):
    file, line = stems(root)[label]
    return f"[`{label}`](repository:{file}#L-{line})"


def names_in(root, theorem):
    """The names of the text that stand in the statement, each with its first label."""
    owners = {}
    for label in stems(root):
        owners.setdefault(label.split(".")[0], label)
    words = dict.fromkeys(re.findall(r"\w+", theorem.text))
    return [(word, owners[word]) for word in words if word in owners]


def items(root, theorem):
    if theorem.labels:
        yield "**Labels:** " + ", ".join(place_of(root, label) for label in theorem.labels) + "."
    elif names := names_in(root, theorem):
        yield "**Labels:** it discharges none. It speaks of " + ", ".join(
            f"[`{name}`](repository:{stems(root)[label][0]}#L-{stems(root)[label][1]})" for name, label in names) + "."
    else:
        yield "**Labels:** none; it speaks of the program and of numbers."
    if theorem.lemmas:
        yield "**Proved by:** " + ", ".join(f"`{name}` of [{file}](repository:proofs/{file}#L-{line_of(root, file, name)})"
                                            for file, name in theorem.lemmas) + "."
    if theorem.finals:
        yield "**Rests on:** " + ", ".join(f"`{name}`" for name in theorem.finals) + "."
    yield "**Assumes:** its hypotheses above, and the axioms " + ", ".join(f"`{axiom.split('.')[-1]}`" for axiom in theorem.axioms) + "."
    for start, end, _, assumes in arrows(root).get(theorem.name, []):
        yield f"**Holds in [the chain](/docs/proofs.md):** from {start} to {end}" + (f"; assuming {assumes}" if assumes else "") + "."


@functools.cache
def lines(root, file):
    text = (root / "proofs" / file).read_text(encoding="utf-8").splitlines()
    pattern = re.compile(rf"^ *{theorems.STATED} (\w+)")
    return {match[1]: number for number, line in enumerate(text, 1) if (match := pattern.match(line))}


def line_of(root, file, name):
    return lines(root, file)[name]


def text_of(root, theorem):
    given = f"{theorem.given}\n\n" if theorem.given else ""
    comment = f"{theorem.comment}\n" if theorem.comment else ""
    says = f"{theorem.says}\n\n" if theorem.says else ""
    bullets = "\n".join(f"- {item}" for item in items(root, theorem))
    return (f"## `{theorem.name}`\n\n{says}```coq\n{given}{comment}{theorem.text}\n```\n\n"
            f"[`proofs/{theorem.file}`](repository:proofs/{theorem.file}#L-{theorem.line})\n\n{bullets}\n")


def raw(svg):
    return f"```{{raw}} html\n{svg}\n```"


def row_of(root, part, members):
    labels = dict.fromkeys(stem_of(root, label) for theorem in members for label in theorem.labels)
    code = dict.fromkeys(path for theorem in members for path in code_of(root, theorem))
    shown = (", ".join(f"`{path}`" for path in group) or "–" for group in (labels, code))
    return f"| [{part}](/{theorems.doc_of(members[0])}.md) | {len(members)} | " + " | ".join(shown) + " |"


def pages(root):
    """Each page of the chain: its name without an ending, and its text."""
    rows = "\n".join(row_of(root, part, members) for part, members in parts(root).items())
    axioms = sorted({axiom for theorem in theorems.all_of(root) for axiom in theorem.axioms})
    yield "maps/proofs", HEAD.format(picture=raw(overview(root).svg()), rows=rows, count=len(axioms),
                                     axioms="\n".join(f"- `{axiom}`" for axiom in axioms))
    for part, members in parts(root).items():
        yield theorems.doc_of(members[0]), PART.format(
            title=part, count=len(members), file=members[0].file, picture=raw(picture_of(root, part, members).svg()),
            texts="\n".join(text_of(root, theorem) for theorem in members))
