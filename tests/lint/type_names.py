#!/usr/bin/env python3
"""The name of a type stands once in the program: type_names.py FILE...

A class, structure, union or enumeration that two files of the program define at namespace scope, or two namespaces of
one file, confuses its readers: the rule names both places. Not counted are declarations without a body, specialisations,
types within a class, and what is defined again for each target of Highway, which stands in one file. The types of
`model` that the Z text names are the text's own; so another layer may have a type that is spelt alike.

And a type is named by a noun: WORDS are none, as a type or as a parameter of a template.
"""

import re
import sys
from collections import defaultdict
from pathlib import Path

from types_of import bare, of_the_text, types

WORDS = set(
    "Alike All Alone Asked Beyond Both Brought Come Drawn Each Every Followed Found Gave Given Gone Have Here Improved "
    "Its Known Made Many More Most Own Of Once Others Picked Put Said Seen Some Take Taken Tell That The There These This "
    "Those Told Took Tried What Which Whose With".split())


def main():
    text_names = of_the_text(Path("."))
    places, bad = defaultdict(list), False
    for path in sys.argv[1:]:
        text = bare(Path(path).read_text(encoding="utf-8"))
        for match in re.finditer(r"\b(?:class|struct|union|enum|typename)(?:\s+class)?\s+(\w+)\b(?!\s*::)", text):
            if match.group(1) in WORDS:
                line = text.count("\n", 0, match.start()) + 1
                print(f"{path}:{line}: {match.group(1)} names a type; expected a noun of the field")
                bad = True
        for name, line, space in types(text):
            if not (name in text_names and path.startswith(("include/durero/model/", "src/model/"))):
                places[name].append((path, line, space))
    for name, where in sorted(places.items()):
        for path, line, _ in where[1:]:
            first = where[0]
            print(f"{path}:{line}: {name} names another type in {first[0]}:{first[1]}; expected a name of its own")
            bad = True
    return bad


if __name__ == "__main__":
    sys.exit(main())
