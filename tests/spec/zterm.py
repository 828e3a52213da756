"""Expressions of Z, for zparse: what stands between predicates, down to names, numbers and brackets."""
from zlex import ZError
from ztemplate import Node, Operators

# Infix expression operators: binding power (ISO Z toolkit, annex B) and whether they associate to the right.
BINARY = {
    r"\fun": (5, True), r"\pfun": (5, True), r"\ffun": (5, True), r"\rel": (5, True), r"\cross": (8, False),
    r"\mapsto": (10, False), r"\upto": (20, False),
    "+": (30, False), "-": (30, False), r"\cup": (30, False), r"\cat": (30, False), r"\setminus": (30, False),
    "*": (40, False), r"\comp": (40, False), r"\cap": (40, False), r"\oplus": (50, False),
    r"\rres": (60, False), r"\nrres": (60, False), r"\dres": (65, False), r"\ndres": (65, False),
}
ARITHMETIC = {"+", "-", "*"}
PREFIX_WORDS = {"min", "max", "succ"}  # operators of the standard's toolkit
PREFIX = {r"\negate", r"\seq", r"\id", r"\power", r"\power_1", r"\finset", r"\finset_1", "-"}
CONSTANTS = set(r"\emptyset \num \num_1 \nat \nat_1 \arithmos \real \dom \ran \bigcup \bigcap \#".split())


class Terms(Operators):
    """Recursive descent over the tokens of one paragraph. Predicates and schema texts are its heir's."""

    def __init__(self, tokens, templates=()):
        self.at, self.tokens = 0, self.marked(tokens, templates)

    @property
    def next(self):
        return self.tokens[self.at]

    def take(self, text=None):
        token = self.next
        if text is not None and (token.text != text or token.kind == "name"):
            raise ZError(token.line, f"expected {text}, found {token.text or 'a new line'}")
        self.at += 1
        return token

    def sees(self, *texts):
        return self.next.kind != "name" and self.next.text in texts

    def accept(self, *texts):
        return self.take() if self.sees(*texts) else None

    def newline(self):
        if self.next.kind == "newline":
            self.at += 1
            return True
        return False

    def name(self):
        token = self.take()
        if token.kind != "name" and token.text not in CONSTANTS:
            raise ZError(token.line, f"expected a name, found {token.text or 'a new line'}")
        return token.text

    def binary(self, power=0):
        left = self.prefix()
        while True:
            if self.own_role(True) in ("function", "generic") and self.own[self.next.text].power >= power:
                left = self.operation([left])
                continue
            if self.next.kind != "symbol" or BINARY.get(self.next.text, (-1,))[0] < power:
                return left
            op = self.take()
            bind, right_first = BINARY[op.text]
            right = self.binary(bind if right_first else bind + 1)
            flat = left.kids if op.text == left.op == r"\cross" else (left,)
            left = Node(op.text, flat + (right,), op.line)

    def prefix(self):
        if self.own_role(False):
            return self.operation([])
        if self.next.text == r"\IF":
            line = self.take().line
            test = self.predicate()
            self.take(r"\THEN")
            yes = self.binary()
            self.take(r"\ELSE")
            return Node("if", (test, yes, self.binary()), line)
        if self.next.text in PREFIX:
            op = self.take()
            return Node("prefix" + op.text, (self.prefix(),), op.line)
        if self.next.kind == "name" and self.next.text in PREFIX_WORDS and self.begins(self.tokens[self.at + 1]):
            word = self.take()
            return Node("apply", (Node("name", (word.text,), word.line), self.prefix()), word.line)
        return self.application()

    @staticmethod
    def begins(token):
        """Whether an operand of an application begins with it."""
        return token.kind in ("name", "number") or token.text in CONSTANTS | {"(", r"\{", r"\lblot", r"\theta"}

    def application(self):
        """f a \inv: applications go on to the left, and bind tighter than what stands behind them."""
        left = self.selection()
        while self.begins(self.next):
            left = Node("apply", (left, self.selection()), left.line)
        while op := self.accept(r"\inv", r"\limg", r"\plus", r"\star", "^{"):
            if op.text == r"\inv":
                left = Node("inverse", (left,), op.line)
            elif op.text == r"\limg":
                left = Node("image", (left, self.expression()), op.line)
                self.take(r"\rimg")
            elif op.text == "^{":
                left = Node("iterate", (left, self.expression()), op.line)
                self.take("^}")
            else:
                left = Node("closure", (left,), op.line)
        return left

    def selection(self):
        """What binds tighter still: b.x and S~'."""
        left = self.atom()
        while op := self.accept(".", "'"):
            if op.text == "'":
                left = Node("decorate", (left,), op.line)
            else:
                left = Node("select", (left, self.take().text if self.next.kind == "number" else self.name()), op.line)
        return left

    def atom(self):
        token = self.take()
        if token.kind == "name" and token.text in ("true", "false"):
            return Node("truth", (token.text,), token.line)
        if token.kind == "name" or token.text in CONSTANTS:
            return Node("name", (token.text,), token.line)
        if token.kind == "number":
            return Node("number", (token.text,), token.line)
        if token.text == r"\theta":
            name, strokes = self.name(), ""
            while self.accept("'"):
                strokes += "'"
            return Node("theta", (name, strokes), token.line)
        if token.text == "(":
            own = self.operator_name()
            word = self.next.text
            if own or word in PREFIX_WORDS and self.tokens[self.at + 1].text == r"\_":
                self.at += 0 if own else 2
                self.take(")")
                return Node("name", (own or word,), token.line)
        if token.text == "(" and self.sees(r"\_"):
            return self.operator(token)
        if token.text == r"\lblot":
            return self.binding(token)
        if token.text == r"\langle":
            parts = self.display(token, r"\rangle")
            return Node("sequence", parts.kids, token.line)
        if token.text == "(":
            parts = [self.expression()]
            while self.newline():
                parts[0] = Node(r"\land", (parts[0], self.predicate()), token.line)
            while self.accept(","):
                parts.append(self.expression())
            self.take(")")
            return parts[0] if len(parts) == 1 else Node("tuple", tuple(parts), token.line)
        if token.text == "[":
            text = self.text()
            self.take("]")
            return Node("schema", (text,), token.line)
        if token.text == r"\{":
            return self.braces(token)
        raise ZError(token.line, f"expected an expression, found {token.text or 'a new line'}")

    def operator(self, opening):
        """(\_ + \_): the function that an infix operator is."""
        self.take(r"\_")
        op = self.take()
        if op.text not in ARITHMETIC | {"^{"}:
            raise ZError(op.line, f"expected one of {' '.join(sorted(ARITHMETIC))} as an operator, found {op.text}")
        self.take(r"\_")
        if op.text == "^{":
            self.take("^}")
            self.take(")")
            return Node("name", ("_^_",), opening.line)
        self.take(")")
        return Node("operator", (op.text,), opening.line)

    def braces(self, opening):
        """A set by comprehension if a schema text opens it, else a set of its members."""
        mark = self.at
        try:
            text = self.text()
            decls, predicate = text.kids
            if decls and predicate is None and not self.sees("@") and all(d.op == "include" for d in decls):
                raise ZError(opening.line, "a display")
        except ZError as comprehension:
            reached, self.at = self.at, mark
            try:
                return self.display(opening)
            except ZError as display:  # the reading that went further tells what is wrong
                raise comprehension if reached > self.at else display
        value = self.expression() if self.accept("@") else None
        self.take(r"\}")
        return Node("set", (text, value), opening.line)

    def binding(self, opening):
        parts = []
        while not self.sees(r"\rblot"):
            name = self.name()
            self.take("==")
            parts.append((name, self.expression()))
            self.accept(",")
        self.take()
        return Node("binding", tuple(parts), opening.line)

    def display(self, opening, closing=r"\}"):
        parts = [] if self.sees(closing) else [self.expression()]
        while self.accept(","):
            parts.append(self.expression())
        self.take(closing)
        return Node("display", tuple(parts), opening.line)
