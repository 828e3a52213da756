#!/usr/bin/env python3
"""Whose each paragraph of the Z text is: origin.py ROOT [--write].

spec/origin.md has a row for each name that spec/*.tex declares: the paper's as printed, the paper's with the numbers of
spec/erratas.md that change it, or ours. The rows follow from the text, from spec/impresa and from the entries:

- a name that the paper declares is the paper's. Its numbers are those on its printed lines, and those of the entries
  that cite the name or one of its labels;
- a paragraph of the paper that differs from the print has a number, and one that has none is as it is printed;
- an input that the print lacks, or declares otherwise, is named by an entry EX of its operation.

--write puts the page in place; without it, a page that says otherwise fails. The rules then see faults that are planted
in a copy in memory."""
import pathlib
import re
import sys
from collections import namedtuple

import erratas

STEMS = ["tipos", "escena", "operaciones", "puntos", "interseccion"]  # those of the paper
BEGIN, END = "<!-- origin:begin -->", "<!-- origin:end -->"
PAPER, OURS = "the paper's", "ours"

Paragraph = namedtuple("Paragraph", "names lines labels numbers")
Text = namedtuple("Text", "ours printed entries")


def plain(name):
    return re.sub(r"[\\~ ]", "", name)


def declared(kind, title, lines):
    """The names that a box declares."""
    if kind == "schema":
        return [plain(title)]
    head = "\n".join(lines).split("\\where")[0]
    if kind == "axdef":
        return [plain(name) for name in re.findall(r"^\s*([A-Za-z\\_]+)(?=~?[^:=\n]* : )", head, re.M)]
    given = re.match(r"\s*\[(.*)\]", head)
    if given:
        return [plain(name) for name in given[1].split(",")]
    return [plain(name) for name in re.findall(r"^\s*([A-Za-z\\_]+)(?:\[.*\])? (?:==|::=)", head, re.M)]


def paragraphs(text):
    """The boxes of a text in their order; a conjecture declares no name."""
    for found in re.finditer(r"\\begin\{(schema|axdef|zed|gendef)\}(?:\{(.*?)\})?(?:\[.*?\])?(.*?)\\end\{\1\}", text, re.S):
        kind, title, body = found.groups()
        comments = " ".join(re.findall(r"%(.*)", body))
        lines = [re.sub(r"\s*%.*", "", line) for line in body.split("\n")]
        yield Paragraph(declared(kind, title, lines), shape(lines),
                        re.findall(r"\w+\.(?:inv|pre|post|def|axiom|conj)\.\d+", comments),
                        re.findall(r"\bE\d\d\b", comments))


def shape(lines):
    """The text without the layout of its lines."""
    text = re.sub(r"\\also|\\t\d|\\\\|~", " ", "\n".join(lines))
    return [" ".join(line.split()) for line in text.split("\n") if line.strip()]


def read(root):
    spec = root / "spec"
    files = sorted(spec.glob("*.tex"), key=lambda file: (STEMS.index(file.stem) if file.stem in STEMS else 9, file.stem))
    ours = {file.stem: list(paragraphs(file.read_text(encoding="utf-8"))) for file in files}
    printed = [p for stem in STEMS for p in paragraphs((spec / "impresa" / f"{stem}.tex").read_text(encoding="utf-8"))]
    return Text(ours, printed, erratas.entries((spec / "erratas.md").read_text(encoding="utf-8")))


def of_paper(text):
    """The printed paragraph of each name that the paper declares."""
    return {name: paragraph for paragraph in text.printed for name in paragraph.names}


def numbers_of(text, name, paragraph):
    """The numbers of the entries that change a paragraph of the paper."""
    printed = of_paper(text)[name]
    owners = {label.split(".")[0] for label in paragraph.labels} | {name}
    cited = [number for number, body in text.entries if re.match(r"E(\d|X)", number)
             and any(re.search(rf"`{owner}(\.(?!conj)\w+\.\d+)?`", body) for owner in owners)]
    return sorted(set(printed.numbers) | set(cited), key=lambda number: (number.startswith("EX"), number))


def rows(text):
    """(stem, name, whose, numbers) of each name, in the order of the text."""
    printed = of_paper(text)
    for stem, boxes in text.ours.items():
        for paragraph in boxes:
            for name in paragraph.names:
                if name not in printed:
                    yield stem, name, OURS, []
                elif paragraph.lines == printed[name].lines:
                    yield stem, name, PAPER, []
                else:
                    yield stem, name, PAPER, numbers_of(text, name, paragraph)


def inputs(paragraph):
    """The declarations of inputs."""
    return {line for line in paragraph.lines if re.match(r"[a-z]+\? : ", line)}


def faults(text):
    printed = of_paper(text)
    boxes = {name: box for boxes in text.ours.values() for box in boxes for name in box.names}
    for _, name, whose, numbers in rows(text):
        if whose == PAPER and boxes[name].lines != printed[name].lines and not numbers:
            yield f"{name} is not as printed, and no entry says why"
        extended = inputs(boxes[name]) - inputs(printed[name]) if whose == PAPER else set()
        extensions = " ".join(body for number, body in text.entries if number.startswith("EX") and number in numbers)
        yield from (f"{name} declares {line} otherwise than the paper, and no entry EX says why"
                    for line in sorted(extended) if f"`{line.split(' ')[0]}`" not in extensions)
    dropped = {name for name in printed if name not in boxes}
    explained = " ".join(number for paragraph in text.printed for number in paragraph.numbers)
    yield from (f"{name} of the paper is gone, and no entry says why" for name in sorted(dropped)
                if not printed[name].numbers or printed[name].numbers[0] not in explained)
    known = {name for box in text.printed for name in box.names} | set(boxes)
    for number, body in text.entries:
        if number.startswith("EX") and not any(re.search(rf"`{name}(\.\w+\.\d+)?`", body) for name in known & set(printed)):
            yield f"{number} extends no paragraph of the paper"


def page(text):
    lines = ["| in the text | stem | whose | entries |", "| --- | --- | --- | --- |"]
    for stem, name, whose, numbers in rows(text):
        changed = ", ".join(numbers) if numbers else "as printed" if whose == PAPER else ""
        lines.append(f"| `{name}` | `{stem}` | {whose} | {changed} |")
    return "\n".join(lines)


def unseen(text):
    """The planted faults that no rule sees."""
    def without(number):
        return text._replace(entries=[(n, body) for n, body in text.entries if n != number])

    def changed(name, old, new):
        def other(box):
            return box._replace(lines=[line.replace(old, new) for line in box.lines]) if name in box.names else box
        return text._replace(ours={stem: [other(box) for box in boxes] for stem, boxes in text.ours.items()})
    planted = {"no entry of an extension": without("EX2"),
               "an attribute more": changed("Punto", "x, y, z", "w, x, y, z"),
               "an input widened": changed("Agregar_Elemento", "t? : Tipo", "t? : \\power Tipo"),
               "an extension of nothing": text._replace(entries=[*text.entries, ("EX9", "`Agregar_Tronco.pre.1`")])}
    return [what for what, other in planted.items() if other == text or not list(faults(other))]


if __name__ == "__main__":
    root = pathlib.Path(sys.argv[1])
    text = read(root)
    file = root / "spec" / "origin.md"
    now = file.read_text(encoding="utf-8")
    due = re.sub(rf"(?s)(?<={BEGIN}\n).*(?={END})", lambda _: page(text) + "\n", now)
    if "--write" in sys.argv:
        file.write_text(due, encoding="utf-8")
    wrong = [f"spec/origin.md: {fault}" for fault in faults(text)]
    if due != now and "--write" not in sys.argv:
        wrong.append("spec/origin.md is stale; python3 tests/spec/origin.py . --write puts it right")
    wrong += [f"not seen: {what}" for what in unseen(text)] if not wrong else []
    print("\n".join(wrong) or f"{len(list(rows(text)))} names, each with its origin")
    sys.exit(bool(wrong))
