"""Syntax trees of Z paragraphs: predicates and expressions in one grammar, as ISO Z has them.

A tree is a Node: op names it, kids are its parts, line is where it stands. Schema texts are Node("text",
[declarations, predicate or None]); a declaration is Node("var", [names, set]) or Node("include", [expression]).
"""
from ztemplate import Node
from zterm import CONSTANTS, Terms

QUANTIFIERS = {r"\forall", r"\exists", r"\exists_1", r"\lambda", r"\mu"}
LOGIC = [{r"\iff"}, {r"\implies"}, {r"\lor"}, {r"\land"}]  # loosest first
RELATIONS = {"=", "<", ">", r"\in", r"\notin", r"\neq", r"\leq", r"\geq", r"\subseteq", r"\subset"}


class Parser(Terms):
    """Schema texts and predicates, and with them whole paragraphs."""

    # Schema texts

    def declarations(self):
        if self.sees("@", "|"):
            return ()
        out = [self.declaration()]
        while not self.sees("where", "end", "|", "@", "]", ")") and (self.newline() or self.accept(";")):
            out.append(self.declaration())
        return tuple(out)

    def declaration(self):
        line, mark = self.next.line, self.at
        operator = self.operator_name()
        if operator:
            self.take(":")
            return Node("var", ((operator,), self.expression()), line)
        if self.next.kind == "name" or self.next.text in CONSTANTS:
            names = [self.name()]
            while self.accept(","):
                names.append(self.name())
            if self.accept(":"):
                return Node("var", (tuple(names), self.expression()), line)
        self.at = mark
        return Node("include", (self.expression(),), line)

    def text(self):
        line = self.next.line
        decls = self.declarations()
        return Node("text", (decls, self.predicate() if self.accept("|") else None), line)

    # Predicates (and schema expressions, which share the connectives)

    def predicates(self):
        """A list of predicates, one a line."""
        out = [self.predicate()]
        while self.newline():
            out.append(self.predicate())
        return out

    def predicate(self, level=0):
        if self.next.text in QUANTIFIERS:
            return self.quantified()
        if level == len(LOGIC):
            return self.negation()
        left = self.predicate(level + 1)
        while self.next.text in LOGIC[level]:
            op = self.take()
            left = Node(op.text, (left, self.predicate(level + 1)), op.line)
        return left

    def quantified(self):
        op = self.take()
        text = self.text()
        if op.text in (r"\lambda", r"\forall", r"\exists", r"\exists_1"):
            self.take("@")
            return Node(op.text, (text, self.predicate()), op.line)
        return Node(op.text, (text, self.predicate() if self.accept("@") else None), op.line)

    def negation(self):
        if self.sees(r"\lnot"):
            op = self.take()
            return Node(op.text, (self.negation(),), op.line)
        if self.sees(r"\pre"):
            op = self.take()
            return Node(op.text, (self.negation(),), op.line)
        left = self.hiding()
        while self.sees(r"\semi"):
            op = self.take()
            left = Node("semi", (left, self.hiding()), op.line)
        chain = []
        while self.next.text in RELATIONS or self.own_role(True) == "relation":
            op = self.next
            if op.kind == "own":
                link = self.operation([left])
                right = self.last
            else:
                self.take()
                right = self.binary()
                link = Node(op.text, (left, right), op.line)
            chain.append(link)
            left = right
        return left if not chain else chain[0] if len(chain) == 1 else Node("chain", tuple(chain), chain[0].line)

    def hiding(self):
        left = self.binary()
        while self.sees(r"\hide"):
            op = self.take()
            self.take("(")
            names = [self.name()]
            while self.accept(","):
                names.append(self.name())
            self.take(")")
            left = Node("hide", (left, tuple(names)), op.line)
        return left

    def expression(self):
        return self.quantified() if self.next.text in QUANTIFIERS else self.predicate()
