#!/usr/bin/env python3
"""docs/glossary.md: the types of the public headers, each with the first sentence of its comment and where it stands.

glossary.py [--write] HEADER...: says where the page is stale, or writes it; and names each type that has no sentence.
A schema of the text that has no comment is the schema of that name.
"""

import re
import sys
from collections import defaultdict
from pathlib import Path

from types_of import bare, of_the_text, types

PAGE = Path("docs/glossary.md")
HEAD = """# Glossary

The terms of the program: its public types, in the order of the layers. A name that stands in the Z text keeps the text's
letters; every other name is the field's. This page is made of the headers' own first sentences: `sh tests/lint/glossary.sh --write`
writes it, and the lint fails where it is stale.
"""
# The words of answers and verdicts, which are no types.
WORDS = """
## Words

| word | meaning | more |
| --- | --- | --- |
| exact | An answer that is right to the bit, in the system's format. | [verdicts](conformance.md#verdicts) |
| family | A kind of rays that some program was seen to get wrong. | [the families](families.md) |
| gross | A verdict that changes the picture: a hit for a miss or a miss for a hit, another element, a point far off, no number or no answer. | [verdicts](conformance.md#verdicts) |
| no_minimum | The outcome of a ray that starts in a stretch of the surface: no point of it is nearest. | [results](formats/results.md) |
| off | A verdict on a hit of the right element whose point is that of no data within the declared error, and near the right one. | [verdicts](conformance.md#verdicts) |
| profile | What a system claims to answer: shapes, limits, number format. | [formats of conform](formats/conform.md) |
| right | A verdict on the answer of some data within the declared error of those given. | [verdicts](conformance.md#verdicts) |
| tie | A first point that lies on two elements or more: the answer names them all. | [results](formats/results.md) |
"""
COMMENT = re.compile(r"^\s*///(?!<)\s?(.*)$")


def layers():
    """The layers in their order, from CMakeLists.txt."""
    return re.findall(r"^durero_layer\((\w+)", Path("CMakeLists.txt").read_text(encoding="utf-8"), re.M)


def first_sentence(words):
    """The first sentence of a comment, in one line."""
    text = re.sub(r"\s+", " ", " ".join(words)).strip()
    text = re.sub(r"^@[{}]\s*", "", text)
    text = re.sub(r"\\(?:brief|c|p|a)\s+", "", text)
    end = re.search(r"(?<!\be\.g)(?<!\bi\.e)\.(?=\s+[^a-z]|$)", text)
    return text[: end.start() + 1] if end else text


def comment_above(lines, at):
    """The lines of the comment that stands above line `at` (from 0), past the heads of templates."""
    at -= 1
    while at >= 0 and not COMMENT.match(lines[at]) and re.match(r"\s*(template\b|requires\b|\S.*[^;{}]\s*$)", lines[at]):
        at -= 1
    words = []
    while at >= 0 and COMMENT.match(lines[at]):
        words.insert(0, COMMENT.match(lines[at]).group(1))
        at -= 1
    for i in range(len(words) - 1, 0, -1):  # what belongs to a group before it
        if words[i - 1].strip() == "@}":
            return words[i:]
    return words


def terms(paths, text_names):
    """(layer, name, sentence, header) of each type, and the places of those without a sentence."""
    found, missing = [], []
    for path in paths:
        text = Path(path).read_text(encoding="utf-8")
        lines = text.split("\n")
        for name, line, space in types(bare(text)):
            if "{" in space or not space.startswith("durero"):
                continue
            sentence = first_sentence(comment_above(lines, line - 1))
            if not sentence and name in text_names:
                sentence = "The schema of that name in the text."
            if not sentence:
                missing.append(f"{path}:{line}: {name} has no sentence; expected a comment that says what it is")
            found.append((path.split("/")[2], name, sentence, path[len("include/") :]))
    return found, missing


def page(found):
    by_layer = defaultdict(list)
    for layer, name, sentence, header in found:
        by_layer[layer].append((name, sentence.replace("|", "\\|"), header))
    order = layers()
    assert set(by_layer) <= set(order), set(by_layer) - set(order)
    text = HEAD + WORDS
    for layer in order:
        if layer in by_layer:
            text += f"\n## {layer}\n\n| term | meaning | header |\n| --- | --- | --- |\n"
            for name, sentence, header in sorted(by_layer[layer], key=lambda row: (row[0].lower(), row)):
                text += f"| `{name}` | {sentence} | `{header}` |\n"
    return text


def main():
    write, paths = "--write" in sys.argv[1:], [path for path in sys.argv[1:] if path != "--write"]
    found, missing = terms(paths, of_the_text(Path(".")))
    print("".join(line + "\n" for line in missing), end="")
    made = page(found)
    if write:
        PAGE.write_text(made, encoding="utf-8")
    elif not PAGE.exists() or PAGE.read_text(encoding="utf-8") != made:
        print(f"{PAGE}:1: it is stale; sh tests/lint/glossary.sh --write puts it right")
        return 1
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
