#!/usr/bin/env python3
"""A source includes what it names: includes.py <NAMES

Of each type and function that a header of the program defines at namespace scope, a source that names it includes that
header, or one that includes it. The include of another file holds for it where sources are compiled as one
(DURERO_UNITY), and nowhere else. A declaration of the type is enough for a header, and for a pointer or a reference.

A bare name is one of the file's own layer, `io::Name` one of io. A name that the file itself, or a header that it
includes, gives to something else is let be.
"""

import re
import sys
from pathlib import Path

from types_of import bare, types

INCLUDE = re.compile(r'^#include ["<]([^">]+)', re.M)
DECLARED = re.compile(r"\b(?:class|struct|union|enum(?:\s+class)?|using|typename(?:\.\.\.)?|concept)\s+(?:\w+::)*(\w+)\b(\s*;)?")
TOKEN = re.compile(r"[A-Za-z_]\w*|[{}();=]|::")
FOLDERS = "include", "src", "tests", "tests/bench"
NO_FUNCTIONS = {"noexcept", "decltype", "requires", "alignas", "explicit"}


def layer(path):
    parts = path.split("/")
    return parts[2] if parts[0] == "include" else parts[1]


def functions(text):
    """The names of the functions that the text, which is bare, declares at namespace scope."""
    spaces, statement, depth = [], [], 0  # spaces: of each brace that is open whether a namespace has it
    for match in TOKEN.finditer(text):
        word = match.group()
        if word == "(":
            name = statement[-1] if len(statement) > 1 else ""
            if depth == 0 and all(spaces) and re.match(r"[a-z_]", name) and name not in NO_FUNCTIONS:
                if statement[-2] != "::" and "=" not in statement:
                    yield name
            depth += 1
        elif word == ")":
            depth -= 1
        elif word in "{};":
            if word == "{":
                spaces.append("namespace" in statement[:2])
            elif word == "}" and spaces:
                spaces.pop()
            statement, depth = [], 0
            continue
        statement.append(word)


class Source:
    def __init__(self, path):
        text = Path(path).read_text(encoding="utf-8")
        self.layer, self.text, self.included = layer(path), bare(text), INCLUDE.findall(text)
        self.folders = path.rpartition("/")[0], *FOLDERS
        self.types, self.declarations = set(), set()
        for name, is_declaration in DECLARED.findall(self.text):
            (self.declarations if is_declaration else self.types).add(name)
        self.words = set(re.findall(r"[A-Za-z_]\w*", self.text))
        self.calls = set(re.findall(r"([A-Za-z_]\w*)\s*\(", self.text))

    def has_its_own(self, function):
        """Says whether a function, a variable or a parameter of this name is declared in the source."""
        own = rf"(?<!return)(?<!throw)(?<!else)[\w>&*]\s+{function}\s*[({{=;,)]|[(,]\s*{function}\s*[,;=)]|[&*]{function}\b"
        return re.search(own, self.text) is not None

    def uses(self, name):
        """(line, namespace, what stands behind) of each place where the source names this: the namespace is "" for none."""
        for match in re.finditer(rf"((?:\b\w+\s*::\s*)+)?(?<!\.)(?<!->)(?<!~)\b{name}\b(?!\s*::)\s*([(*&])?", self.text):
            space = re.sub(r"\s|::\s*$|^durero::", "", match.group(1) or "").rpartition("::")[2]
            yield self.text.count("\n", 0, match.start()) + 1, space, match.group(2)


def closure(path, sources):
    """The source, and each header that it includes by whatever way."""
    seen, todo = {}, [path]
    while todo:
        path = todo.pop()
        if path not in seen:
            seen[path] = sources[path]
            todo += sources[path].headers
    return seen


def headers_of(sources, names_in):
    """The headers that define a name: {name: {layer: paths}}."""
    found = {}
    for path, source in sources.items():
        if not path.endswith(".cpp"):
            for name in names_in(source.text):
                found.setdefault(name, {}).setdefault(source.layer, set()).add(path)
    return found


def missing(path, sources, types_in, functions_in):
    """(line, name, header) of each name that the source has by the include of another file."""
    source, seen = sources[path], closure(path, sources)
    known = set().union(*(each.types for each in seen.values()))
    declared = set().union(*(each.declarations for each in seen.values()))
    words = set().union(*(each.words for at, each in seen.items() if at != path))
    for homes_of, are_types in (types_in, True), (functions_in, False):
        for name in sorted((source.words if are_types else source.calls - words) & homes_of.keys()):
            homes_by_layer = {layer: homes for layer, homes in homes_of[name].items() if not homes & seen.keys()}
            if not homes_by_layer.keys() & (source.words | {source.layer}) or not are_types and source.has_its_own(name):
                continue
            for line, space, behind in source.uses(name):
                homes = homes_by_layer.get(space or source.layer)
                if not homes or are_types and space in ("", source.layer) and name in known:
                    continue
                if (name in declared and (path.endswith(".hpp") or behind in ("*", "&"))) if are_types else behind != "(":
                    continue
                yield line, name, re.sub("^(include|src|tests)/", "", min(homes))
                break


def main():
    sources = {path: Source(path) for path in sys.stdin.read().splitlines()}
    for source in sources.values():
        paths = [f"{folder}/{header}" for header in source.included for folder in source.folders]
        source.headers = [path for path in paths if path in sources]
    types_in = headers_of(sources, lambda text: [name for name, _, _ in types(text)])
    functions_in = headers_of(sources, functions)
    bad = False
    for path in sources:
        if path.endswith(".h"):
            continue  # of C, whose types have no definition
        for line, name, header in missing(path, sources, types_in, functions_in):
            print(f'{path}:{line}: names {name} by the include of another file; expected #include "{header}"')
            bad = True
    return bad


if __name__ == "__main__":
    sys.exit(main())
