"""Operator templates of a Z text: `\\relation (\\_ ~below~ \\_)`, `\\function 30
\\leftassoc (\\_ ~plus~ \\_)`, `\\generic …`; and what a parser makes of their words."""
from dataclasses import dataclass

from zlex import Token, ZError

SLOTS = ("_", ",,")


@dataclass(frozen=True)
class Node:
    op: str
    kids: tuple
    line: int


@dataclass(frozen=True)
class Template:
    role: str
    parts: tuple
    power: int
    right: bool

    @property
    def name(self):
        return " ".join(self.parts)

    @property
    def words(self):
        return tuple(part for part in self.parts if part not in SLOTS)

    @property
    def left(self):
        return self.parts[0] == "_"

    def matched(self, tokens, at):
        """How many tokens from `at` on are this operator's name, and the names for its operands; or None."""
        begin, operands = at, []
        for part in self.parts:
            token = tokens[at]
            if part == ",," and token.text != r"\listarg":
                if (token.text, tokens[at + 1].text) != (",", ","):
                    return None
                at += 1
            elif part == "_" and token.kind == "name":
                operands.append(token.text)
            elif token.text != {"_": r"\_", ",,": r"\listarg"}.get(part, part):
                return None
            at += 1
        return at - begin, operands


def read(p, known):
    """The template that stands at a parser's place."""
    line, role = p.next.line, p.take().text[1:]
    power, right = 0, False
    if p.next.kind == "number":
        power = int(p.take().text)
        right = p.take().text == r"\rightassoc"
    elif role != "relation":
        power = 99
    binds = power != 99 and role != "relation"
    p.take("(")
    parts = []
    while not p.sees(")"):
        token = p.take()
        if token.text == ",":
            p.take(",")
            parts.append(",,")
        else:
            parts.append({r"\_": "_", r"\listarg": ",,"}.get(token.text, token.text))
    p.take(")")
    if role != "relation" and binds != (len(parts) > 2 and parts[0] == parts[-1] == "_"):
        raise ZError(line, "a precedence belongs to an infix operator")
    found = Template(role, tuple(parts), power, right)
    for word in found.words:
        if word in TOOLKIT or any(word in other.words for other in known):
            raise ZError(line, f"the word {word} is of an operator already")
    return found


TOOLKIT = set(r"""= < > + - * \in \notin \neq \leq \geq \subseteq \subset \fun \pfun \rel \cross \mapsto \cup \cap
  \setminus \oplus \rres \nrres \dres \ndres \upto \power \finset \inv \plus \star""".split())


class Operators:
    """What a parser makes of the operators of templates: functions, generics, and relations, which are memberships."""

    def marked(self, tokens, templates):
        """The tokens with the words of operators marked as such."""
        self.own = {word: template for template in templates for word in template.words}
        return [Token("own", t.text, t.line) if t.text in self.own else t for t in tokens]

    def own_role(self, behind):
        """The role of the operator that begins here, with a left operand or without one; or None."""
        template = self.own.get(self.next.text) if self.next.kind == "own" else None
        if template is None or self.next.text != template.words[0] or template.left != behind:
            return None
        return template.role

    def operation(self, operands):
        template, line = self.own[self.next.text], self.next.line
        rest = template.parts[1:] if template.left else template.parts
        for i, part in enumerate(rest):
            if part == ",,":
                operands.append(self.listed())
            elif part == "_" and i + 1 < len(rest):
                operands.append(self.expression())
            elif part == "_":
                operands.append(self.binary(template.power + (not template.right) if template.left else 100))
            else:
                self.take_own(part)
        self.last = operands[-1]
        name = Node("name", (template.name,), line)
        if template.role == "generic":
            return Node("instance", (name, *operands), line)
        value = operands[0] if len(operands) == 1 else Node("tuple", tuple(operands), line)
        return Node("apply", (name, value), line) if template.role == "function" else Node(r"\in", (value, name), line)

    def take_own(self, word):
        if self.next.kind != "own" or self.next.text != word:
            line = self.tokens[self.at - 1].line if self.sees("end") else self.next.line
            raise ZError(line, f"expected {word} of an operator, found {self.next.text or 'a new line'}")
        self.at += 1

    def listed(self):
        items, line = [], self.next.line
        while self.next.kind != "own":
            items.append(self.expression())
            if self.next.kind != "own":
                self.take(",")
        return Node("sequence", tuple(items), line)

    def operator_name(self, formals=None):
        """The name of an operator as a declaration has it, or None; with `formals`, names stand for its operands."""
        ahead = self.tokens[self.at:self.at + 2]
        template = next((self.own[t.text] for t in ahead if t.kind == "own"), None)
        found = template.matched(self.tokens, self.at) if template else None
        if not found or (found[1] and formals is None):
            return None
        if formals is not None:
            formals += found[1]
        self.at += found[0]
        return template.name
