#!/usr/bin/env python3
"""The stubs of the package's modules that take English names: made of their sources and of the table of the program.

stubs.py [--write]: names each stub that is stale, or writes it. To type checkers a class or a function of both languages is
one of two signatures, and an English property is a property.
"""
from __future__ import annotations

import ast
import copy
import pathlib
import sys
from collections.abc import Iterable, Iterator
from typing import Union

from durero.english import english

PACKAGE = pathlib.Path(__file__).resolve().parents[2] / "python" / "durero"
HEAD = "# Made of {} by tests/python/stubs.py --write: the same, with the English names beside the Spanish ones.\n"
DECORATORS = {"in_both_languages", "takes_english"}
Function = ast.FunctionDef


def stale() -> list[str]:
    """The modules whose stub is not what it would be."""
    return [path.name for path, text in stubs() if not path.exists() or path.read_text(encoding="utf-8") != text]


def stubs() -> Iterator[tuple[pathlib.Path, str]]:
    """The path and the text of each stub."""
    for source in sorted(PACKAGE.glob("*.py")):
        module = ast.parse(source.read_text(encoding="utf-8"))
        if any(decorators_of(node) & DECORATORS for node in ast.walk(module)):
            yield source.with_suffix(".pyi"), HEAD.format(source.name) + stub(module)


def stub(module: ast.Module) -> str:
    body: list[ast.stmt] = []
    for node in module.body:
        if isinstance(node, ast.Import) or (isinstance(node, ast.ImportFrom) and node.module not in ("english", "__future__")):
            body.append(node)
        elif isinstance(node, ast.ClassDef):
            body.append(class_stub(node))
            if "in_both_languages" in decorators_of(node) and english(node.name) != node.name:
                body += ast.parse(f"{english(node.name)} = {node.name}").body
        elif not isinstance(node, ast.FunctionDef) or not node.name.startswith("_"):
            body += member(node)
    text = ast.unparse(ast.fix_missing_locations(ast.Module([*ast.parse("from typing import overload").body, *body], [])))
    text = text.replace("__hash__ = None", "__hash__ = None  # type: ignore[assignment]")
    return text.replace("\n    ...", " ...").replace("\n        ...", " ...") + "\n"


def decorators_of(node: ast.AST) -> set[str]:
    return {name.id for name in getattr(node, "decorator_list", ()) if isinstance(name, ast.Name)}


def member(node: ast.stmt) -> list[ast.stmt]:
    """A name of a module or a class, without its value and its body."""
    if isinstance(node, ast.AnnAssign):
        bare = copy.copy(node)
        bare.value = None
        return [bare]
    if isinstance(node, ast.Assign):
        is_type = isinstance(node.value, (ast.Name, ast.Subscript, ast.Constant))
        return [node] if is_type else []
    if isinstance(node, ast.FunctionDef) and node.name != "__post_init__":
        return [signature(node)]
    return []


def signature(node: Function) -> Function:
    bare = copy.deepcopy(node)
    bare.body = [ast.Expr(ast.Constant(...))]
    bare.decorator_list = [name for name in bare.decorator_list if not decorators_of(with_one(name)) & DECORATORS]
    bare.args.defaults = [ast.Constant(...) for _ in bare.args.defaults]
    bare.args.kw_defaults = [default and ast.Constant(...) for default in bare.args.kw_defaults]
    return bare


def with_one(decorator: ast.expr) -> ast.ClassDef:
    return ast.ClassDef("", [], [], [], [decorator])


def overload_of(node: Function) -> Function:
    if "overload" not in decorators_of(node):
        node.decorator_list.insert(0, ast.Name("overload"))
    return node


def in_english(node: Function) -> Function:
    """The signature with English names. From the last of them on arguments have to be named, so that it is another."""
    named = copy.deepcopy(node)
    parameters = [*named.args.args, *named.args.kwonlyargs]
    for parameter in parameters:
        if len(parameter.arg) > 1:
            parameter.arg = english(parameter.arg)
    last = max(i for i, of in enumerate([*node.args.args, *node.args.kwonlyargs]) if of.arg != parameters[i].arg)
    moved = named.args.args[last:]
    defaults: list[Union[ast.expr, None]] = [*[None] * len(named.args.args), *named.args.defaults][-len(named.args.args) :]
    named.args.kwonlyargs = [*moved, *named.args.kwonlyargs]
    named.args.kw_defaults = [*(defaults[last:] if moved else []), *named.args.kw_defaults]
    named.args.args = named.args.args[: len(named.args.args) - len(moved)]
    named.args.defaults = [default for default in defaults[: len(named.args.args)] if default is not None]
    return named


def has_english(node: Function) -> bool:
    parameters = [of.arg for of in [*node.args.args, *node.args.kwonlyargs]]
    return any(len(name) > 1 and english(name) != name for name in parameters)


def both(nodes: Iterable[Function]) -> list[ast.stmt]:
    """Each signature in both languages; one alone where they are the same."""
    made: list[ast.stmt] = []
    for node in nodes:
        twins = [signature(node), in_english(signature(node))] if has_english(node) else []
        made += [overload_of(of) for of in twins] or [signature(node)]
    return made


def class_stub(node: ast.ClassDef) -> ast.ClassDef:
    is_both = "in_both_languages" in decorators_of(node)
    is_data = is_both and any(isinstance(name, ast.Call) for name in node.decorator_list)
    body: list[ast.stmt] = [each for of in node.body if not isinstance(of, ast.FunctionDef) for each in member(of)]
    if is_data:
        body += both([initialiser(node)])
    if is_both:
        body += [each for of in node.body if isinstance(of, ast.AnnAssign) for each in english_field(of)]
    functions = [of for of in node.body if isinstance(of, ast.FunctionDef)]
    twins = {of.name for of in functions if "takes_english" in decorators_of(of)}
    for name in dict.fromkeys(of.name for of in functions):
        same = [of for of in functions if of.name == name]
        overloads = [of for of in same if "overload" in decorators_of(of)]
        if name in twins:
            body += both(overloads or same)
        else:
            body += [each for of in overloads or same for each in member(of)]
    made = copy.copy(node)
    made.body = body or [ast.Expr(ast.Constant(...))]
    made.decorator_list = [data_decorator(name, is_data) for name in node.decorator_list if isinstance(name, ast.Call)]
    return made


def data_decorator(name: ast.expr, has_own_init: bool) -> ast.expr:
    """dataclass(…), whose __init__ the stub says where it has two signatures."""
    made = copy.deepcopy(name)
    if has_own_init and isinstance(made, ast.Call):
        made.keywords.append(ast.keyword("init", ast.Constant(False)))
    return made


def is_of_class(field: ast.AnnAssign) -> bool:
    return ast.unparse(field.annotation).startswith("ClassVar")


def initialiser(node: ast.ClassDef) -> Function:
    """The __init__ of a dataclass."""
    fields = [of for of in node.body if isinstance(of, ast.AnnAssign) and not is_of_class(of)]
    parameters = [f"{ast.unparse(of.target)}: {ast.unparse(of.annotation)}{'' if of.value is None else ' = ...'}" for of in fields]
    made = ast.parse(f"def __init__(self, {', '.join(parameters)}) -> None: ...").body[0]
    assert isinstance(made, ast.FunctionDef)
    return made


def english_field(field: ast.AnnAssign) -> list[ast.stmt]:
    """The English property of a field, where it has one."""
    spanish, annotation = ast.unparse(field.target), ast.unparse(field.annotation)
    word = english(spanish)
    if word == spanish or len(spanish) == 1:
        return []
    if is_of_class(field):
        return ast.parse(f"{word}: {annotation}").body
    return ast.parse(f"@property\ndef {word}(self) -> {annotation}: ...").body


if __name__ == "__main__":
    if "--write" in sys.argv[1:]:
        for path, text in stubs():
            path.write_text(text, encoding="utf-8")
    else:
        print("".join(f"python/durero/{name}: it is stale; python3 tests/python/stubs.py --write puts it right\n" for name in stale()))
        sys.exit(bool(stale()))
