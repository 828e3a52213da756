"""Tokens of the ISO Z LaTeX mark-up: what stands in the Z environments of a file, with its line.

Paragraph     one Z environment: its kind, its head (a schema's name), its tokens, its first line
Token         kind name | number | symbol | newline, text, line; a command's text keeps its backslash

A blank is no space in this mark-up: `f a` is the name fa, and `S '` the name S'. What separates is `~`, `\\ ` or a command:
`f~a` applies f to a, and `S~'` is the schema S decorated.
"""
import re
from dataclasses import dataclass

KINDS = ("zsection", "zed", "axdef", "gendef", "schema")
SPACES = (r"\ ", r"\,", r"\;", r"\quad") + tuple(rf"\t{n}" for n in range(10))
# A newline beside one of these is layout only (ISO Z, 7.5: a newline is soft next to an infix or a separator).
SOFT_AFTER = set("= < > + - * ( [ , ; : | @ . == ::=".split()) | {r"\{", "where"}
SOFT_BEFORE = set("= < > + - * ) ] , ; : | @ . == ::=".split()) | {r"\}", "where", "end"}
INFIX = set(r"""\land \lor \implies \iff \in \notin \subseteq \subset \neq \leq \geq \cup \cap \setminus \mapsto \cross
  \fun \pfun \ffun \rel \upto \cat \comp \dres \ndres \rres \nrres \oplus \hide \semi \THEN \ELSE""".split())


class ZError(Exception):
    """A defect of a text: its line and what is wrong."""

    def __init__(self, line, message):
        super().__init__(message)
        self.line = line


@dataclass(frozen=True)
class Token:
    kind: str
    text: str
    line: int


@dataclass(frozen=True)
class Paragraph:
    kind: str
    head: str
    tokens: tuple
    line: int


GREEK = r"\\(?:%s)(?![A-Za-z])" % "|".join("""Gamma Lambda Pi Sigma Upsilon Phi Psi Omega alpha beta gamma delta epsilon rho
  sigma tau phi omega""".split())
LETTER = rf"(?:[A-Za-z]|{GREEK})"
INDEX = r"(?:_\{(?:[A-Za-z0-9]*[A-Za-z][A-Za-z0-9]*|[0-9]{2,})\}|\^\{[A-Za-z0-9]+\})"  # one digit below is a stroke
TOKEN = re.compile(
    r"(?P<delta>\\(?:Delta|Xi)\s*(?=[A-Za-z]))"
    rf"|(?P<name>{LETTER}(?:\s*(?:{LETTER}|[0-9]|\\_|{INDEX}))*(?:\s*_[0-9])?(?:\s*[?!'])*)"
    r"|(?P<number>[0-9](?:\s*[0-9])*)"
    r"|(?P<command>\\t[0-9]|\\vdash\?|\\[A-Za-z]+(?:_1)?|\\.)"
    r"|(?P<symbol>::=|==|[=<>+\-*()\[\],;:|@.'])"
    r"|(?P<raise>\^\{)"  # behind a ~ or a bracket: an iteration r~^{~n~}
    r"|(?P<brace>[{}])"
    r"|(?P<space>[\s~]+)"
)


def paragraphs(text):
    """The Z paragraphs of a file, in order. Raises ZError for an environment that never ends or a stray character."""
    found, lines, i = [], text.split("\n"), 0
    while i < len(lines):
        start = re.match(r"\s*\\begin\{(\w+)\}(?:\{([^}]*)\})?", lines[i])
        if start and start.group(1) in KINDS:
            kind, first, body = start.group(1), i, []
            end, rest = f"\\end{{{kind}}}", lines[i][start.end():]
            while end not in rest:
                body.append((i + 1, rest))
                i += 1
                if i == len(lines):
                    raise ZError(first + 1, f"\\begin{{{kind}}} is never ended")
                rest = lines[i]
            body.append((i + 1, rest[:rest.index(end)]))
            found.append(Paragraph(kind, (start.group(2) or "").replace(r"\_", "_"), tuple(tokens(body)), first + 1))
        i += 1
    return found


def tokens(body):
    """The tokens of numbered lines that follow one another, soft newlines dropped."""
    whole = "\n".join(re.sub(r"(?<!\\)%.*", "", line) for _, line in body)
    out, at, prefix, number, braces = [], 0, "", body[0][0], []
    while at < len(whole):
        match = TOKEN.match(whole, at)
        if not match:
            raise ZError(number, f"unexpected character {whole[at]!r}")
        at, kind, text = match.end(), match.lastgroup, match.group()
        if kind == "delta":
            prefix = text.strip()
        elif kind == "name":
            out.append(Token("name", prefix + re.sub(r"\s", "", text).replace(r"\_", "_"), number))
            prefix = ""
        elif kind == "number":
            out.append(Token("number", re.sub(r"\s", "", text), number))
        elif text in ("\\\\", r"\also"):
            out.append(Token("newline", "", number))
        elif text == r"\where":
            out.append(Token("symbol", "where", number))
        elif kind == "raise" or text == "{":
            braces.append(kind == "raise")
            out += [Token("symbol", text, number)] * braces[-1]
        elif text == "}":
            out += [Token("symbol", "^}", number)] * (braces and braces.pop())
        elif kind != "space" and text not in SPACES:
            out.append(Token("symbol", text, number))
        number += text.count("\n")
    out.append(Token("symbol", "end", body[-1][0]))
    return [t for i, t in enumerate(out) if t.kind != "newline" or not soft(out, i)]


def soft(out, i):
    """Whether the newline at i is layout: beside an infix, an open bracket or another newline."""
    if i == 0 or out[i - 1].kind == "newline":
        return True
    return out[i - 1].text in SOFT_AFTER | INFIX or out[i + 1].text in SOFT_BEFORE | INFIX
