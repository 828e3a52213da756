#!/usr/bin/env python3
"""Type-checks Z specifications in ISO Z LaTeX mark-up: zcheck.py FILE...

A section finds its parents among the files given, in any order. One line an error: FILE:LINE: message.
Exit status: 0 no error, 1 errors, 2 a file that cannot be read. It knows the notation that spec/ uses and shares
nothing with the program's own reader, so the two can be held against each other.
"""
import sys

import zlex
from zlex import ZError
from zparse import Node, Parser
from ztype import Checker, power


def section(path):
    """The name, the parents and the paragraphs of a file with one section."""
    with open(path, encoding="utf-8") as file:
        found = zlex.paragraphs(file.read())
    if not found or found[0].kind != "zsection":
        raise ZError(1, "the file does not begin with a section")
    words = [t.text for t in found[0].tokens if t.kind == "name"]
    return words[0], words[1:], found[1:]


def given(c, p):
    while True:
        name = p.name()
        c.names[name] = power(("given", name))
        if not p.accept(","):
            break
    p.take("]")


def free_type(c, p, name, line):
    own = ("given", name)
    c.names[name] = power(own)
    while True:
        if p.next.kind != "name":
            raise ZError(p.next.line, f"{name} ::= introduces a new type by naming its values; found {p.next.text}")
        c.names[p.name()] = own
        if not p.accept("|"):
            break


def zed(c, p):
    if p.accept("["):
        return given(c, p)
    if p.accept(r"\vdash?"):
        return c.predicate({}, p.predicate())
    line, name = p.next.line, p.name()
    if p.accept("::="):
        return free_type(c, p, name, line)
    p.take("==")
    c.names[name] = c.unknown()  # if the right side fails, uses of the name add no further errors
    tree = p.predicate()
    c.names[name] = c.type({}, tree)


def box(c, p, paragraph):
    schema = paragraph.kind == "schema"
    if schema:
        c.names[paragraph.head] = c.unknown()
    decls = Node("text", (p.declarations(), None), paragraph.line)
    inner, _, declared = c.text({}, decls)
    if schema:
        c.names[paragraph.head] = power(("schema", tuple(sorted(declared.items()))))
    else:
        c.names.update(declared)
    if p.accept("where"):
        for predicate in p.predicates():
            c.predicate(inner, predicate)


def check(names, paragraphs):
    """The errors of a section's paragraphs, (line, message); names gains what they declare."""
    c = Checker(names)
    for paragraph in paragraphs:
        p = Parser(paragraph.tokens)
        try:
            zed(c, p) if paragraph.kind == "zed" else box(c, p, paragraph)
            p.take("end")
        except ZError as error:
            c.error(error.line, str(error))
    return sorted(set(c.errors))


def main(paths):
    sections, errors = {}, []
    for path in paths:
        try:
            name, parents, found = section(path)
            sections[name] = (path, parents, found)
        except ZError as error:
            errors.append((path, error.line, str(error)))
        except (OSError, UnicodeDecodeError) as error:
            print(f"{path}: {error}", file=sys.stderr)
            return 2
    done = {"standard_toolkit": {}}
    while sections:
        ready = [n for n, (_, parents, _) in sections.items() if all(p not in sections for p in parents)]
        for name in ready or list(sections):
            path, parents, found = sections.pop(name)
            names = {}
            for parent in parents:
                if parent not in done:
                    errors.append((path, 2, f"there is no section {parent}"))
                names.update(done.get(parent, {}))
            errors += [(path, line, message) for line, message in check(names, found)]
            done[name] = names
    for path, line, message in errors:
        print(f"{path}:{line}: {message}")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
