#!/usr/bin/env python3
"""What is drawn of the printed specification is what was printed: dibujo.py SPEC_FOLDER.

Each box of SPEC_FOLDER/impresa/dibujo/superficies.tex has the words of the box of SPEC_FOLDER/impresa/puntos.tex that
declares the same function, one by one, but on the lines that a comment `% mended:` names. There it may have other words,
and on the lines of E27 nothing but one parenthesis more.
"""
import pathlib
import re
import sys

BOX = re.compile(r"\\begin\{axdef\}(.*?)\\end\{axdef\}", re.DOTALL)


def boxes(path):
    """Each box by the function that it declares: its lines, without comments and with their mending."""
    found = {}
    for body in BOX.findall(path.read_text(encoding="utf-8")):
        lines = []
        for line in body.strip("\n").split("\n"):
            mended = re.search(r"% mended: (.*)$", line)
            lines.append((line.split("%")[0].split(), mended.group(1) if mended else None))
        found[lines[0][0][0] if lines[0][0] else lines[1][0][0]] = [each for each in lines if each[0]]
    return found


def disagreements(folder):
    printed, drawn = (boxes(folder / "impresa" / name) for name in ("puntos.tex", "dibujo/superficies.tex"))
    if len(drawn) < 4:
        yield "fewer than four boxes are drawn"
    for name, lines in drawn.items():
        of = printed.get(name, [])
        if len(lines) != len(of):
            yield f"{name}: {len(lines)} lines, and {len(of)} in print"
        for (words, mended), (original, _) in zip(lines, of):
            said = f"{name}: {' '.join(words)}: in print {' '.join(original)}"
            if mended is None and words != original:
                yield said
            elif mended is not None and words == original:
                yield f"{name}: {' '.join(words)}: nothing is mended"
            elif mended == "E27" and " ".join(words).replace("))", ")", 1) != " ".join(original):
                yield said


def main():
    found = list(disagreements(pathlib.Path(sys.argv[1])))
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
