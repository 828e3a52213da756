#!/usr/bin/env python3
"""docs/spanish.md: the table of src/text/spanish.cpp, each name with the paragraph of the Z text that first has it.

spanish.py [--write]: names each name of the text that the table lacks, each name of the table that the text lacks, and
says where the page is stale, or writes it. A letter alone, without ? or !, is a variable and needs no English.
"""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "spec"))
import zlex  # noqa: E402

TABLE, PAGE = Path("src/text/spanish.cpp"), Path("docs/spanish.md")
TOOLKIT = {"front", "head", "last", "tail"}  # names of the standard's toolkit, which are English
ROW = re.compile(r'\{("[^"]*"),\s*("[^"]*"),\s*((?:"[^"]*"\s*)+)\}')
HEAD = """# The Spanish names

The names of the Z text are Spanish, and the program, its files and its Python package keep them. This page gives the English of
each. `durero help radio` and `durero help radius` say the same, and where the name stands. Python takes both languages:
`durero.Sphere` is `durero.Esfera`, and `center=` is `centro=`. Scene files and scripts take the Spanish names alone.

The page is made of the one table in the program, `src/text/spanish.cpp`: `sh tests/lint/spanish.sh --write` writes it, and the
lint fails where it is stale. A `?` ends the name of an input, a `!` that of an output.
"""


def table():
    """(name, english, meaning, line) of each row."""
    text = TABLE.read_text(encoding="utf-8")
    for match in ROW.finditer(text):
        strings = ["".join(re.findall(r'"([^"]*)"', part)) for part in match.groups()]
        yield (*strings, text.count("\n", 0, match.start()) + 1)


def stems():
    """The stems of the text, parents first."""
    parents = {}
    for path in sorted(Path("spec").glob("*.tex")):
        section = re.search(r"\\SECTION (\w+)(?: \\parents ([\w, ]+))?", path.read_text(encoding="utf-8").replace("\\_", "_"))
        parents[path.stem] = re.findall(r"\w+", section.group(2) or "")
    order = []

    def add(stem):
        if stem in parents and stem not in order:
            for parent in parents[stem]:
                add(parent)
            order.append(stem)

    for stem in parents:
        add(stem)
    return order


def owner(paragraph):
    """The first name that the paragraph declares; empty for a conjecture."""
    if paragraph.head:
        return paragraph.head
    names = [token.text for token in paragraph.tokens if token.kind == "name"]
    return "" if any(token.text == r"\vdash?" for token in paragraph.tokens) else names[0] if names else ""


def names_of_the_text():
    """{name: (stem, line, paragraph)} of each name, where it first stands; marks of a state after and of Δ and Ξ are off."""
    found = {}
    for stem in stems():
        for paragraph in zlex.paragraphs(Path(f"spec/{stem}.tex").read_text(encoding="utf-8")):
            if paragraph.kind == "zsection":
                continue
            heads = [(paragraph.head, paragraph.line)] if paragraph.head else []
            tokens = [(token.text, token.line) for token in paragraph.tokens if token.kind == "name"]
            for name, line in heads + tokens:
                name = re.sub(r"^\\(Delta|Xi)", "", name).rstrip("'")
                if name in TOOLKIT:
                    continue
                found.setdefault(name, (stem, line, owner(paragraph)))
    return found


def faults(rows, text):
    """Each name that one of the two has and the other lacks."""
    known = {row[0] for row in rows}
    parts = {part.lower() for name in text for part in name.split("_")}
    for name, (stem, line, _) in text.items():
        if name not in known and len(name) > 1:
            yield f"spec/{stem}.tex:{line}: {name} has no English; expected a row of it in {TABLE}"
    for i, (name, _, _, line) in enumerate(rows):
        if name not in text and name not in parts:
            yield f"{TABLE}:{line}: the text has no {name}; expected a name of it, or a word of one"
        if name in {row[0] for row in rows[:i]}:
            yield f"{TABLE}:{line}: {name} stands twice; expected it once"


def page(rows, text):
    sections = {"": "Words of names, files and scripts"}
    sections.update({stem: f"`spec/{stem}.tex`" for stem in stems()})
    said = HEAD
    for stem, title in sections.items():
        of_stem = [row for row in rows if text.get(row[0], ("",))[0] == stem]
        if not of_stem:
            continue
        place = " in |" if stem else ""
        said += f"\n## {title}\n\n| name | English | meaning |{place}\n| --- | --- | --- |{place and ' --- |'}\n"
        for name, english, meaning, _ in sorted(of_stem, key=lambda row: text.get(row[0], ("", row[3]))[1]):
            paragraph = text[name][2] if stem else ""
            of = f" `{paragraph}` |" if paragraph and paragraph != name else " |" if stem else ""
            said += f"| `{name}` | {'the same' if english == name else english.replace('_', ' ')} | {meaning} |{of}\n"
    return said


def main():
    rows, text = list(table()), names_of_the_text()
    wrong = list(faults(rows, text))
    made = page(rows, text)
    if "--write" in sys.argv[1:]:
        PAGE.write_text(made, encoding="utf-8")
    elif not PAGE.exists() or PAGE.read_text(encoding="utf-8") != made:
        wrong.append(f"{PAGE}:1: it is stale; sh tests/lint/spanish.sh --write puts it right")
    print("".join(line + "\n" for line in wrong), end="")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
