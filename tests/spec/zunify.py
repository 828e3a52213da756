"""Z's types as values, and their unification.

A type is a tuple: ("given", name), ("power", t), ("product", t, …), ("schema", ((name, t), …)) or ("unknown", id).
"""
import itertools


def power(t):
    return ("power", t)


def generic(formals, t):
    """The type of a name for every choice of its formals."""
    return ("forall", tuple(formals), t) if formals else t


def pair(*ts):
    return ("product",) + ts


def relation(a, b):
    return power(pair(a, b))


class Types:
    """Unification, and the printing of types. All sections share the unknowns, whose types may cross sections."""

    bound, fresh = {}, itertools.count()

    def unknown(self):
        return ("unknown", next(self.fresh))

    def prune(self, t):
        while t[0] == "unknown" and t[1] in self.bound:
            t = self.bound[t[1]]
        return t

    def unify(self, a, b):
        a, b = self.prune(a), self.prune(b)
        if a == b:
            return True
        if a[0] == "unknown" or b[0] == "unknown":
            variable, other = (a, b) if a[0] == "unknown" else (b, a)
            if self.occurs(variable, other):
                return False
            self.bound[variable[1]] = other
            return True
        if a[0] != b[0] or a[0] == "given" or len(a) != len(b):
            return False
        if a[0] == "schema":
            one, two = dict(a[1]), dict(b[1])
            return one.keys() == two.keys() and all(self.unify(one[n], two[n]) for n in one)
        return all(self.unify(x, y) for x, y in zip(a[1:], b[1:]))

    def occurs(self, variable, t):
        t = self.prune(t)
        if t == variable:
            return True
        parts = [c for _, c in t[1]] if t[0] == "schema" else t[1:] if t[0] in ("power", "product") else ()
        return any(self.occurs(variable, part) for part in parts)

    def show(self, t):
        t = self.prune(t)
        if t[0] == "given":
            return {r"\arithmos": "𝔸", r"\real": "ℝ"}.get(t[1], t[1])
        if t[0] == "power":
            inner = self.show(t[1])
            return f"ℙ({inner})" if "×" in inner else f"ℙ {inner}"
        if t[0] == "product":
            return " × ".join(f"({self.show(x)})" if self.prune(x)[0] == "product" else self.show(x) for x in t[1:])
        if t[0] == "schema":
            return "[" + "; ".join(f"{n} : {self.show(x)}" for n, x in t[1]) + "]"
        return "?"
