#!/usr/bin/env python3
"""The critical edition is whole: erratas.py ROOT.

- spec/erratas.md has each number of each source text once, in the form printed, defect, correction, proof; of what is ours, printed, reason, extension, proof.
- A proof names evidence, or says that nothing proves the entry yet. Each test that it names is a test case of the file
  beside it, each theorem stands in proofs/, and it claims a counterexample where there is one for its number.
- A label that an entry cites is one of the Z text.
- Numbers that docs/ and the Z text refer to have an entry.

Each of these rules then sees a fault that is planted in a copy in memory."""
import pathlib
import re
import sys
from collections import namedtuple

import contraejemplos
import contraejemplos_aceleracion
import contraejemplos_luz

Source = namedtuple("Source", "count digits module")
SOURCES = {"E": Source(35, 2, contraejemplos), "EA": Source(12, 1, contraejemplos_aceleracion),
           "ER": Source(14, 1, contraejemplos_luz), "EX": Source(4, 1, None)}  # EX: what is ours, and needs none
FORM = ["Printed", "Defect", "Correction", "Proof"]
FORM_OF_OURS = ["Printed", "Reason", "Extension", "Proof"]
UNPROVED = "nothing proves this yet"
BY_READING = {"E15", "E25"}  # names that occur once, and a change of no meaning: the printed text is what shows it

Tree = namedtuple("Tree", "text shown cases theorems labels cited")


def entries(text):
    """The entries in their order: (number, body)."""
    parts = re.split(r"^#### (E[ARX]?\d+) .*$", text, flags=re.M)
    return [(number, re.split(r"^##", body, flags=re.M)[0]) for number, body in zip(parts[1::2], parts[2::2])]


def proof(body):
    """The paragraph of the proof, its lines joined."""
    found = re.search(r"^- Proof: (.*?)(?:\n\n|\Z)", body, re.M | re.S)
    return " ".join(found.group(1).split()) if found else ""


def numbers():
    return [f"{name}{k:0{source.digits}}" for name, source in SOURCES.items() for k in range(1, source.count + 1)]


def shown_numbers():
    """The numbers that have a counterexample."""
    found = set()
    for name, source in SOURCES.items():
        tests = dir(source.module.Errata) if source.module else []
        for k in re.findall(rf"\btest_{name}(\d\d)_", " ".join(tests)):
            found.add(f"{name}{int(k):0{source.digits}}")
    return found


def test_cases(text):
    return {" ".join(name.split()) for name in re.findall(r'TEST_CASE\(\s*"([^"]*)"', text)}


def read_tree(root):
    spec = [file.read_text(encoding="utf-8") for file in sorted((root / "spec").glob("*.tex"))]
    pages = [file.read_text(encoding="utf-8") for file in sorted((root / "docs").glob("**/*.md"))]
    proved = "\n".join(file.read_text(encoding="utf-8") for file in sorted((root / "proofs").glob("*.v")))
    text = (root / "spec" / "erratas.md").read_text(encoding="utf-8")
    files = {path for path in re.findall(r"`(tests/[\w/.]+\.cpp)`", text) if (root / path).is_file()}
    return Tree(
        text=text,
        shown=shown_numbers(),
        cases={path: test_cases((root / path).read_text(encoding="utf-8")) for path in files},
        theorems=set(re.findall(r"^\s*(?:Theorem|Lemma|Corollary)\s+(\w+)", proved, re.M)),
        labels={label for source in spec for label in re.findall(r"%\s*(\w+\.[a-z]+\.\d+)\s*$", source, re.M)},
        cited={number for source in [*spec, *pages] for number in re.findall(r"\bE[ARX]\d+\b", source)},
    )


def lost_numbers(tree):
    found = [number for number, _ in entries(tree.text)]
    expected = numbers()
    yield from (f"no entry {n}" for n in expected if n not in found)
    yield from (f"{n} has {found.count(n)} entries" for n in expected if found.count(n) > 1)
    yield from (f"{n} is no number of a source" for n in found if n not in expected)
    yield from (f"{n} is cited in docs/ or spec/ and has no entry" for n in sorted(tree.cited - set(found)))


def other_forms(tree):
    for number, body in entries(tree.text):
        items = re.findall(r"^- (\w+): \S", body, re.M)
        form = FORM_OF_OURS if number.startswith("EX") else FORM
        if items != form:
            yield f"{number} has {', '.join(items) or 'nothing'}; expected {', '.join(form)}"


def lost_evidence(tree):
    for number, body in entries(tree.text):
        said = proof(body)
        tests = re.findall(r'"([^"]+)" of `([^`]+)`', said)
        quoted = re.findall(r'"([^"]+)"', said)
        theorems = re.findall(r"`(\w+)`", said)
        yield from (f"{number} names no file of the test \"{name}\"" for name in quoted if name not in dict(tests))
        for name, path in tests:
            if path not in tree.cases:
                yield f"{number} names {path}, which is not there"
            elif name not in tree.cases[path]:
                yield f"{number} names the test \"{name}\", which {path} lacks"
        yield from (f"{number} names the theorem {name}, which proofs/ lacks" for name in theorems
                    if name not in tree.theorems)
        has_counterexample = "counterexample" in said
        if has_counterexample != (number in tree.shown):
            yield f"{number} claims or omits a counterexample"
        has_evidence = bool(tests or theorems or has_counterexample or "type error" in said or number in BY_READING)
        if has_evidence == (UNPROVED in said):
            yield f"{number} has no evidence; expected some, or \"{UNPROVED}\"" if not has_evidence else \
                f"{number} has evidence, and says \"{UNPROVED}\""


def lost_labels(tree):
    for number, body in entries(tree.text):
        cited = set(re.findall(r"`(\w+\.(?:inv|pre|post|def|axiom)\.\d+)`", body))
        yield from (f"{number} cites {label}, which the Z text lacks" for label in sorted(cited - tree.labels))


RULES = [lost_numbers, other_forms, lost_evidence, lost_labels]


def faults(tree):
    return [fault for rule in RULES for fault in rule(tree)]


def unseen(tree):
    """The planted faults that no rule sees, and how many are planted."""
    def without(number):
        return re.sub(rf"^#### {number} .*?(?=^##)", "", tree.text + "##", flags=re.M | re.S)[:-2]

    def changed(number, old, new):
        body = dict(entries(tree.text))[number]
        return tree._replace(text=tree.text.replace(body, body.replace(old, new, 1)))
    planted = {f"no entry {n}": tree._replace(text=without(n)) for n in numbers()}
    for number in ("EA6", "ER4"):
        planted[f"{number} under another number"] = tree._replace(
            text=tree.text.replace(f"#### {number} ", f"#### {number}7 "))
    planted |= {
        "EA7 names another test": changed("EA7", "outside the current cell", "outside the cell"),
        "ER4 names another file": changed("ER4", "whitted_test", "mirrored_test"),
        "ER3 names another theorem": changed("ER3", "_no_back", "_no_front"),
        "E11 names another theorem": changed("E11", "E11_plane", "E11_cone"),
        "EA3 names no file": changed("EA3", " of `tests/accel/bvh_test.cpp`", ""),
        "EA8 twice": tree._replace(text=tree.text + "\n#### EA8 Again\n" + dict(entries(tree.text))["EA8"]),
        "EA9 without a defect": changed("EA9", "- Defect: ", "- Fault: "),
        "EX1 without a reason": changed("EX1", "- Reason: ", "- Defect: "),
        "ER13 omits its counterexample": changed("ER13", "counterexample; ", ""),
        "EA12 has no counterexample": tree._replace(shown=tree.shown - {"EA12"}),
        "EA12 without evidence": changed("EA12", "counterexample, which counts the volumes", "none")._replace(
            shown=tree.shown - {"EA12"}),
        "EA1 with evidence, called unproved": changed("EA1", "- Proof: ", f"- Proof: {UNPROVED}; "),
        "ER8 cites another label": changed("ER8", "`puntos_disco.def.1`", "`puntos_disco.def.9`"),
        "ER15 is cited": tree._replace(cited=tree.cited | {"ER15"}),
    }
    for path in sorted(tree.cases):
        planted[f"{path} lost its tests"] = tree._replace(cases={**tree.cases, path: set()})
    return [what for what, other in planted.items() if other == tree or not faults(other)], len(planted)


if __name__ == "__main__":
    edition = read_tree(pathlib.Path(sys.argv[1]))
    wrong, count = [f"spec/erratas.md: {fault}" for fault in faults(edition)], 0
    if not wrong:  # faults are planted in an edition that has none
        not_seen, count = unseen(edition)
        wrong = [f"not seen: {what}" for what in not_seen]
    print("\n".join(wrong) or f"{len(entries(edition.text))} entries, and each of {count} planted faults is seen")
    sys.exit(bool(wrong))
