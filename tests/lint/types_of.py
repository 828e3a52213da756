"""The types that a text of C++ defines at namespace scope, and the names that the Z text defines."""

import re

BLANK = re.compile(
    r"//(?:\\\n|[^\n])*|/\*.*?\*/|^[ \t]*#(?:\\\n|[^\n])*"
    r'|R"([^(\s]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\'', re.S | re.M)
ATTRIBUTE = re.compile(r"\[\[.*?\]\]", re.S)
TOKEN = re.compile(r"[A-Za-z_]\w*|::|[{}();<>=,:]")
KEYS = ("class", "struct", "union", "enum")


def bare(text):
    """The text without comments, literals, directives and attributes; its lines stay where they are."""
    def spaces(match):
        return "\n" * match.group().count("\n") or " "
    return ATTRIBUTE.sub(spaces, BLANK.sub(spaces, text))


def defined(statement):
    """The name of the type whose body follows the statement; "" where none does."""
    words, depth = [], 0
    for i, word in enumerate(statement):  # without the parameters of a template
        if word == "<" and i > 0 and (depth or statement[i - 1] == "template"):
            depth += 1
        elif word == ">" and depth:
            depth -= 1
        elif not depth and word not in ("template", "export", "inline", "static", "const", "constexpr", "typedef"):
            words.append(word)
    if not words or words[0] not in KEYS or "(" in words:
        return ""
    words = words[2:] if words[1:2] in (["class"], ["struct"]) else words[1:]
    if not words or not re.match(r"[A-Za-z_]", words[0]) or words[1:2] in (["<"], ["::"]):
        return ""  # without a name, a specialisation, or a nested type that is defined outside of its class
    return words[0]


def types(text):
    """(name, line, namespace) of each type that the text, which is bare, defines at namespace scope."""
    braces, statement, at_key = [], [], 0  # braces: of each that is open the namespace, or None
    for match in TOKEN.finditer(text):
        word = match.group()
        if word == "{":
            space = "namespace" in statement[:2]
            name = "" if space else defined(statement)
            if name and None not in braces:
                yield name, text.count("\n", 0, at_key) + 1, "::".join(braces)
            braces.append("".join(statement[statement.index("namespace") + 1 :]) if space else None)
            statement = []
        elif word in "};":
            if word == "}" and braces:
                braces.pop()
            statement = []
        else:
            if word in KEYS and "template" not in statement[-1:]:
                at_key = match.start() if not any(key in statement for key in KEYS) or ">" in statement else at_key
            statement.append(word)


def of_the_text(root):
    """The names that the Z text defines."""
    names = set()
    for path in sorted(root.glob("spec/*.tex")):
        text = path.read_text(encoding="utf-8").replace("\\_", "_")
        names.update(re.findall(r"\\begin\{schema\}\{(\w+)\}", text))
        names.update(re.findall(r"^\s*\[?\s*([A-Z]\w*)\s*(?:::=|==|\\defs|\\sdef|\])", text, re.M))
    return names
