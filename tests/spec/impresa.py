#!/usr/bin/env python3
"""The printed specification is refused for its own defects, line by line: impresa.py SPEC_FOLDER.

Every line of SPEC_FOLDER/impresa ends in the numbers of the defects that are on it. Those that a type-checker can see
(REASONS) must be reported on exactly the lines that carry their number, for their own reason, and nothing else may be
reported. Every number is argued in erratas.md, and every entry there on the Z paper is marked in the printed text.
"""
import contextlib
import io
import pathlib
import re
import sys

import erratas
import zcheck

REASONS = {
    "E01": r".*::= introduces a new type",
    "E02": r"argument: 𝔸 given, Rmas expected",
    "E03": r"argument: 𝔸 given, Rmas expected",
    "E04": r"Δ and Ξ double a state",
    "E08": r"i\? is not declared",
    "E26": r"(operand of .*|equality): (ℝ|Rmas|𝔸) given|argument: ℙ Rmas given",
    "E27": r"expected \), found",
}
BEYOND_TEXT = {"E18", "E29", "E30", "E31", "E32"}  # what is missing from the printed Z, or wrong in the prose around it


def marks(path):
    """The numbers at the end of each line that has any: {line: [number]}."""
    found = {}
    for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
        end = re.search(r"%((?: E\d\d)+)", line)
        if end and not line.lstrip().startswith("%"):
            found[number] = end.group(1).split()
    return found


def reports(files):
    """What the checker says: {(path, line): [message]}."""
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        zcheck.main([str(f) for f in files])
    found = {}
    for line in out.getvalue().splitlines():
        path, number, message = line.split(":", 2)
        found.setdefault((path, int(number)), []).append(message.strip())
    return found


def disagreements(folder):
    files = sorted((folder / "impresa").glob("*.tex"))
    marked = {(str(f), line): numbers for f in files for line, numbers in marks(f).items()}
    reported = reports(files)
    for (path, line), messages in reported.items():
        reasons = [REASONS[n] for n in marked.get((path, line), ()) if n in REASONS]
        for message in messages:
            if not any(re.match(r, message) for r in reasons):
                yield f"{path}:{line}: reported but not marked: {message}"
    for (path, line), numbers in marked.items():
        for n in numbers:
            if n in REASONS and not any(re.match(REASONS[n], m) for m in reported.get((path, line), ())):
                yield f"{path}:{line}: marked {n} but not reported"
    yield from (f"impresa: no line is marked {n}" for n in REASONS if not any(n in m for m in marked.values()))
    yield from argument_faults(folder, {n for numbers in marked.values() for n in numbers})


def argument_faults(folder, seen):
    """Where erratas.md, the marks and the type errors do not fit together."""
    entries = erratas.entries((folder / "erratas.md").read_text(encoding="utf-8"))
    argued = {number: body for number, body in entries if re.fullmatch(r"E\d\d", number)}
    yield from (f"erratas.md: no entry {n}, which the printed text is marked with" for n in sorted(seen - set(argued)))
    for n, body in argued.items():
        if n not in seen | BEYOND_TEXT:
            yield f"impresa: nothing is marked {n}, which erratas.md argues"
        if ("type error" in erratas.proof(body)) != (n in REASONS):
            yield f"erratas.md: {n} claims or omits a type error"


if __name__ == "__main__":
    problems = list(disagreements(pathlib.Path(sys.argv[1])))
    print("\n".join(problems) or "every type defect of the printed text is reported at its line")
    sys.exit(1 if problems else 0)
