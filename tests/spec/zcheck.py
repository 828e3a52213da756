#!/usr/bin/env python3
"""Type-checks Z specifications in ISO Z LaTeX mark-up: zcheck.py FILE...

A section finds its parents among the files given, in any order. One line an error: FILE:LINE: message.
Exit status: 0 no error, 1 errors, 2 a file that cannot be read. It knows the notation that spec/ uses and shares
nothing with the program's own reader, so the two can be held against each other.
"""
import sys

import zlex
import ztemplate
from zlex import ZError
from ztemplate import Node
from zparse import Parser
from ztype import FORMAL, Checker
from zunify import generic, power, relation


def section(path):
    """The name, the parents and the paragraphs of a file with one section."""
    with open(path, encoding="utf-8") as file:
        found = zlex.paragraphs(file.read())
    if not found or found[0].kind != "zsection":
        raise ZError(1, "the file does not begin with a section")
    words = [t.text for t in found[0].tokens if t.kind == "name"]
    return words[0], words[1:], found[1:]


def listed(p):
    """The names of [A, B], behind the bracket."""
    names = [p.name()]
    while p.accept(","):
        names.append(p.name())
    p.take("]")
    return names


def formals(c, names, line):
    """The scope of generic formals: each is a given set of its own there."""
    if len(set(names)) < len(names):
        c.error(line, "the generic formals are not distinct")
    return {n: power(("given", FORMAL + n)) for n in names}


def declare(c, line, types):
    """Names that a paragraph declares; a section declares each once."""
    for name in sorted(c.own & set(types)):
        c.error(line, f"{name} is declared already")
    c.own |= set(types)
    c.names.update(types)


def free_type(c, p, name, line):
    own = ("given", name)
    declare(c, line, {name: power(own)})
    while True:
        if p.next.kind != "name":
            raise ZError(p.next.line, f"{name} ::= introduces a new type by naming its values; found {p.next.text}")
        at, branch, t = p.next.line, p.name(), own
        if p.accept(r"\ldata"):  # a branch with an argument is an injection
            t = relation(c.member({}, p.expression()), own)
            p.take(r"\rdata")
        declare(c, at, {branch: t})
        if not p.accept("|"):
            break


def zed(c, p):
    line = p.next.line
    if p.sees(r"\relation", r"\function", r"\generic"):
        return c.templates.append(ztemplate.read(p, c.templates))
    names = listed(p) if p.accept("[") else []
    if p.accept(r"\vdash?"):
        return c.predicate(formals(c, names, line), p.predicate())
    if names:
        return declare(c, line, {name: power(("given", name)) for name in names})
    name = p.operator_name(names) or p.name()
    if p.accept("::="):
        return free_type(c, p, name, line)
    if p.accept("["):
        names = listed(p)
    p.take("==")
    declare(c, line, {name: c.unknown()})  # if the right side fails, uses of the name add no further errors
    scope = formals(c, names, line)
    c.names[name] = generic(names, c.type(scope, p.predicate()))


def box(c, p, paragraph):
    schema, names = paragraph.kind == "schema", []
    if schema and not paragraph.head:
        raise ZError(paragraph.line, "a box of a schema has its name")
    if paragraph.kind == "gendef" and not p.sees("["):
        raise ZError(p.next.line, "a generic box has formals")
    if p.sees("[") and paragraph.kind in ("schema", "gendef"):
        line = p.take().line
        names = listed(p)
        p.newline()
    scope = formals(c, names, line if names else 0)
    if schema:
        declare(c, paragraph.line, {paragraph.head: c.unknown()})
    decls = Node("text", (p.declarations(), None), paragraph.line)
    inner, _, declared = c.text(scope, decls)
    if schema:
        c.names[paragraph.head] = generic(names, power(("schema", tuple(sorted(declared.items())))))
    else:
        declare(c, paragraph.line, {n: generic(names, t) for n, t in declared.items()})
    if p.accept("where"):
        for predicate in p.predicates():
            c.predicate(inner, predicate)


def check(names, templates, paragraphs):
    """The errors of a section's paragraphs, (line, message); names and templates gain what they declare."""
    c = Checker(names)
    c.templates, c.own = templates, set()
    for paragraph in paragraphs:
        p = Parser(paragraph.tokens, templates)
        try:
            zed(c, p) if paragraph.kind == "zed" else box(c, p, paragraph)
            p.take("end")
        except ZError as error:
            c.error(error.line, str(error))
        c.solve()
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
    done = {"standard_toolkit": ({}, [])}
    while sections:
        ready = [n for n, (_, parents, _) in sections.items() if all(p not in sections for p in parents)]
        for name in ready or list(sections):
            path, parents, found = sections.pop(name)
            names, templates = {}, []
            for parent in parents:
                if parent not in done:
                    errors.append((path, 2, f"there is no section {parent}"))
                above = done.get(parent, ({}, []))
                names.update(above[0])
                templates += [t for t in above[1] if t not in templates]
            errors += [(path, line, message) for line, message in check(names, templates, found)]
            done[name] = (names, templates)
    for path, line, message in errors:
        print(f"{path}:{line}: {message}")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
