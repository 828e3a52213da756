"""The types of the trees of zparse: given sets, power sets, products, schema types, and unknowns being inferred.

Errors are collected a paragraph at a time, so one defect hides no other.
"""
from zlex import ZError
from zparse import RELATIONS
from zunify import Types, pair, power, relation

ARITHMOS = ("given", r"\arithmos")
STROKES = "?!'"
FORMAL = "formal "  # a generic formal is a given set of this name, which no text can spell
LINKS = {r"\iff", r"\implies", r"\lor", r"\land", "chain"} | RELATIONS


class Checker(Types):
    """The types of one section's paragraphs over the global names that its parents gave."""

    def __init__(self, names):
        self.names, self.errors, self.open, self.reported = names, [], [], 0

    def error(self, line, message):
        self.errors.append((line, message))

    def same(self, line, got, wanted, what):
        if not self.unify(got, wanted):
            self.error(line, f"{what}: {self.show(got)} given, {self.show(wanted)} expected")

    # Names

    def toolkit(self, name):
        x, y = self.unknown(), self.unknown()
        return {
            r"\arithmos": power(ARITHMOS), r"\num": power(ARITHMOS), r"\nat": power(ARITHMOS),
            r"\num_1": power(ARITHMOS), r"\nat_1": power(ARITHMOS),
            r"\emptyset": power(x), r"\dom": relation(relation(x, y), power(x)),
            r"\ran": relation(relation(x, y), power(y)),
            r"\bigcup": relation(power(power(x)), power(x)), r"\bigcap": relation(power(power(x)), power(x)),
            r"\#": relation(power(x), ARITHMOS), "min": relation(power(ARITHMOS), ARITHMOS),
            "max": relation(power(ARITHMOS), ARITHMOS), "succ": relation(ARITHMOS, ARITHMOS),
            "iter": relation(ARITHMOS, relation(relation(x, x), relation(x, x))),
            "_^_": relation(pair(relation(x, x), ARITHMOS), relation(x, x)),
            **dict.fromkeys(("front", "tail"), relation(relation(ARITHMOS, x), relation(ARITHMOS, x))),
            **dict.fromkeys(("head", "last"), relation(relation(ARITHMOS, x), x)),
            "first": relation(pair(x, y), x), "second": relation(pair(x, y), y),
        }.get(name)

    def instance(self, t, actuals=None):
        """A generic type with its formals replaced, by unknowns where no actuals are given."""
        if t[0] != "forall":
            return t
        given = actuals or [self.unknown() for _ in t[1]]
        return self.replaced(t[2], {FORMAL + n: a for n, a in zip(t[1], given)})

    def replaced(self, t, by):
        t = self.prune(t)
        if t[0] == "given":
            return by.get(t[1], t)
        if t[0] == "schema":
            return ("schema", tuple((n, self.replaced(x, by)) for n, x in t[1]))
        return t if t[0] == "unknown" else (t[0],) + tuple(self.replaced(x, by) for x in t[1:])

    def component(self, scope, name, line):
        """The one type that a binding's component has in scope."""
        if name not in scope and self.names.get(name, ("",))[0] == "forall":
            self.error(line, f"the component {name} is generic")
        return self.lookup(scope, name, line)

    def later(self, node, t):
        """The type of a part of what is not known yet; solve() finds it."""
        self.open.append((node, t, self.unknown()))
        return self.open[-1][2]

    def solve(self):
        """Finds the parts of what has become known; what never does is an error, but behind other errors."""
        waiting = None
        while self.open and len(self.open) != waiting:
            waiting, tried, self.open = len(self.open), self.open, []
            for node, t, part in tried:
                if self.prune(t)[0] == "unknown":
                    self.open.append((node, t, part))
                else:
                    self.same(node.line, self.part(node, t), part, "selection")
        if len(self.errors) == self.reported:
            for node, _, _ in self.open:
                self.error(node.line, f"nothing says what .{node.kids[1]} selects from")
        self.open, self.reported = [], len(self.errors)

    def part(self, node, t):
        t, which = self.prune(t), node.kids[1]
        if t[0] == "unknown":
            return self.later(node, t)
        if t[0] == "schema" and which in dict(t[1]):
            return dict(t[1])[which]
        if t[0] == "product" and which.isdigit() and 0 < int(which) < len(t):
            return t[int(which)]
        self.error(node.line, f"{self.show(t)} has no component {which}")
        return self.unknown()

    def lookup(self, scope, name, line):
        for table in (scope, self.names):
            if name in table:
                return self.instance(table[name])
        if name[0] == "\\" and name[1:].startswith(("Delta", "Xi")):
            return self.delta(scope, name, line)
        found = self.toolkit(name)
        if found is None:
            base = name.rstrip(STROKES)
            schema = base != name and base in self.names and self.components(self.names[base]) is not None
            self.error(line, f"{name} is not declared" + (f"; the schema {base} is decorated as {base}~'" if schema else ""))
        return found or self.unknown()

    def delta(self, scope, name, line):
        base = name.replace(r"\Delta", "").replace(r"\Xi", "")
        components = self.components(self.lookup(scope, base, line))
        if components is None:
            return self.unknown()
        if any(n[-1] in STROKES for n, _ in components):
            self.error(line, f"Δ and Ξ double a state, and {base} is an operation")
        both = dict(components) | {n + "'": t for n, t in components}
        return power(("schema", tuple(sorted(both.items()))))

    def components(self, t):
        """The components of a schema (a set of bindings), or None."""
        t = self.prune(t)
        inner = self.prune(t[1]) if t[0] == "power" else t
        return inner[1] if t[0] == "power" and inner[0] == "schema" else None

    # Schema texts

    def text(self, scope, node):
        """The scope inside a schema text, and the types that its characteristic tuple has."""
        inner, tuple_types, declared = dict(scope), [], {}
        for decl in node.kids[0]:
            if decl.op == "var":
                member = self.member(scope, decl.kids[1])
                new = {n: member for n in decl.kids[0]}
                tuple_types += new.values()
            else:
                included = self.type(scope, decl.kids[0])
                components = self.components(included)
                if components is None and self.prune(included)[0] != "unknown":
                    self.error(decl.line, f"a schema is expected, not {self.show(included)}")
                new = dict(components or ())
                plain, strokes = decl.kids[0], ""  # the tuple of S ' is θ S ', which has the components of S
                while plain.op == "decorate":
                    plain, strokes = plain.kids[0], strokes + "'"
                own = {n[:len(n) - len(strokes)]: t for n, t in new.items()}
                tuple_types.append(("schema", tuple(sorted(own.items()))))
            for n, t in new.items():
                self.same(decl.line, t, declared.get(n, t), f"{n} is declared twice")
            declared.update(new)
        inner.update(declared)
        if node.kids[1] is not None:
            self.predicate(inner, node.kids[1])
        return inner, tuple_types, declared

    def member(self, scope, node):
        """The type of the members of a set."""
        t, x = self.type(scope, node), self.unknown()
        self.same(node.line, t, power(x), "a set is expected")
        return x

    # Predicates

    def predicate(self, scope, node):
        if node.op in (r"\forall", r"\exists", r"\exists_1"):
            self.predicate(self.text(scope, node.kids[0])[0], node.kids[1])
        elif node.op in (r"\iff", r"\implies", r"\lor", r"\land", r"\lnot", "chain"):
            for kid in node.kids:
                self.predicate(scope, kid)
        elif node.op in RELATIONS:
            self.related(scope, node)
        elif node.op != "truth":  # a schema used as a predicate
            t = self.type(scope, node)
            if self.components(t) is None and self.prune(t)[0] != "unknown":
                self.error(node.line, f"a predicate or a schema is expected, not {self.show(t)}")
            for n, component in self.components(t) or ():
                if n not in scope:
                    self.error(node.line, f"{n} is not declared")
                else:
                    self.same(node.line, scope[n], component, f"{n}")

    def related(self, scope, node):
        a, b = (self.type(scope, kid) for kid in node.kids)
        if node.op in (r"\in", r"\notin"):
            self.same(node.line, b, power(a), "membership")
        elif node.op in ("=", r"\neq"):
            self.same(node.line, b, a, "equality")
        elif node.op in (r"\subseteq", r"\subset"):
            self.same(node.line, a, power(self.unknown()), "inclusion")
            self.same(node.line, b, a, "inclusion")
        else:
            self.arithmetic(node, a, b)

    def arithmetic(self, node, *types):
        for t in types:
            self.same(node.line, t, ARITHMOS, f"operand of {node.op}")
        return ARITHMOS

    # Expressions

    def type(self, scope, node):
        from zexpr import RULES  # the rules, an operator each; they call back here
        if node.op in LINKS | {r"\lnot"} and node.op not in RULES:
            raise ZError(node.line, "an expression is expected, not a predicate")
        if node.op not in RULES:
            raise ZError(node.line, f"{node.op} is not read here")
        return RULES[node.op](self, scope, node)
