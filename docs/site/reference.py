"""What is looked up: every command's help, the Python package by its sources, and the schemas."""
import ast
import json
import re
import subprocess

COMMANDS = """# The command line

The help of `durero` and of each of its commands, as `durero COMMAND --help` prints it. `durero man COMMAND` has the same as a page of
the manual.

{commands}
"""
CPP = """# The library in C++ and C

[The reference of all public names](site:cpp/index.html), by Doxygen: [all headers](site:cpp/files.html), [all classes](site:cpp/annotated.html),
[all concepts](site:cpp/concepts.html). [Durero as a library](/docs/library.md) has programs that build against it.

| layer | headers |
| --- | --- |
{layers}

The names of a layer stand in the namespace of its name: `durero::scene` is of `durero/scene/`. C has one header,
[`durero/c/durero.h`](site:cpp/durero_8h.html).
"""
PYTHON = """# The Python package

Every public name, from the sources of the package. [Durero in Python](/docs/python.md) shows how they are used; their types are those of the
stubs beside them, `python/durero/*.pyi`.

{modules}
"""
SCHEMAS = """# The schemas

`schemas/` has a JSON Schema of each format. [The formats](/docs/formats.md) say what a schema cannot. The keys below are those of the outermost object.

{schemas}
"""


def help_of(durero, words):
    return subprocess.run([durero, *words, "--help"], check=True, capture_output=True, encoding="utf-8").stdout


def commands_in(text):
    """The commands that a help lists: indented by two, before its options."""
    before = text.partition("\nOptions:")[0]
    return re.findall(r"^  ([a-z][a-z-]*) {2,}\S", before.partition("Arguments:")[0], re.M) if " COMMAND" in text else []


def commands(durero, words=()):
    """The section of a command, and of those below it."""
    text = help_of(durero, words)
    level = "#" * min(2 + len(words) - (len(words) > 0), 4)
    yield f"{level} {' '.join(['durero', *words])}\n\n```text\n{text.rstrip()}\n```\n"
    for name in commands_in(text):
        yield from commands(durero, (*words, name))


def cpp(root):
    layers = sorted(path for path in (root / "include" / "durero").iterdir() if path.is_dir())
    rows = (f"| `{layer.name}` | {', '.join(linked(root, header) for header in sorted(layer.rglob('*.h*')))} |" for layer in layers)
    return CPP.format(layers="\n".join(rows))


def linked(root, header):
    path = header.relative_to(root).as_posix()
    return f"[{header.stem}](repository:{path})"


def is_public(name):
    return not name.startswith("_") or name == "__init__"


def fenced(docstring):
    """A docstring as Markdown: its examples are blocks, as is what is indented or in columns."""
    lines, out, block = docstring.splitlines(), [], []
    for line in [*lines, ""]:
        is_block = line.startswith((">>>", "    ")) or (block and line.strip()) or re.match(r"\S.{0,14}\S? {2,}\S", line)
        if is_block:
            block.append(line)
            continue
        if block:
            out += ["```pycon" if block[0].startswith(">>>") else "```text", *block, "```"]
            block = []
        out.append(re.sub(r"([*_\\<|])", r"\\\1", line))
    return "\n".join(out)


def signature(node):
    if isinstance(node, ast.ClassDef):
        bases = ", ".join(ast.unparse(base) for base in node.bases)
        return f"class {node.name}({bases})" if bases else f"class {node.name}"
    returns = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    marks = "".join(f"@{ast.unparse(mark)}\n" for mark in node.decorator_list if ast.unparse(mark) in ("property", "classmethod", "staticmethod"))
    return f"{marks}def {node.name}({ast.unparse(node.args)}){returns}"


def is_overload(node):
    return any(ast.unparse(mark).endswith("overload") for mark in getattr(node, "decorator_list", []))


def members(node, owner, level):
    for child in node.body:
        if isinstance(child, (ast.FunctionDef, ast.ClassDef)) and is_public(child.name) and not is_overload(child):
            if says := ast.get_docstring(child):
                yield f"{'#' * level} {owner}.{child.name}\n\n```python\n{signature(child)}\n```\n\n{fenced(says)}\n"
                if isinstance(child, ast.ClassDef):
                    yield from members(child, f"{owner}.{child.name}", level + 1)


def python(root):
    text = []
    for file in sorted((root / "python" / "durero").glob("*.py")):
        tree = ast.parse(file.read_text(encoding="utf-8"))
        module = "durero" if file.stem == "__init__" else f"durero.{file.stem}"
        if not file.stem.startswith("_") or file.stem == "__init__":
            path = file.relative_to(root).as_posix()
            says = fenced(ast.get_docstring(tree) or "")
            text += [f"## {module}\n\n{says}\n\nSource: [`{path}`](repository:{path}).\n", *members(tree, module, 3)]
    return PYTHON.format(modules="\n".join(text))


def kind_of(value):
    if "const" in value:
        return f"`{json.dumps(value['const'])}`"
    if "enum" in value:
        return ", ".join(f"`{json.dumps(word, ensure_ascii=False)}`" for word in value["enum"])
    return value.get("type", value.get("$ref", "").split("/")[-1]) if isinstance(value.get("type", ""), str) else ", ".join(value["type"])


def schema(root, file):
    says = json.loads(file.read_text(encoding="utf-8"))
    needed, path = says.get("required", []), file.relative_to(root).as_posix()
    rows = [f"| `{key}` | {kind_of(value)} | {'required' if key in needed else ''} | {escaped(value.get('description', ''))} |"
            for key, value in says.get("properties", {}).items() if isinstance(value, dict)]
    table = "| key | type | | meaning |\n| --- | --- | --- | --- |\n" + "\n".join(rows) + "\n" if rows else ""
    return f"## {says.get('title', file.stem)}\n\n{escaped(says.get('description', ''))} [`{path}`](repository:{path}).\n\n{table}"


def escaped(text):
    return re.sub(r"([*_<|\\])", r"\\\1", text)


def pages(durero, root):
    """Each page to look up in: its name without an ending, and its text."""
    yield "reference/command-line", COMMANDS.format(commands="\n".join(commands(durero)))
    yield "reference/cpp", cpp(root)
    yield "reference/python", python(root)
    yield "reference/schemas", SCHEMAS.format(schemas="\n".join(schema(root, file) for file in sorted((root / "schemas").glob("*.json"))))
