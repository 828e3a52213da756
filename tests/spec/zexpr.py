"""The typing rules of Z's expressions, one an operator: rule(checker, scope, node) gives the type."""
from ztemplate import Node
from ztype import ARITHMOS
from zunify import pair, power, relation


def number(c, scope, node):
    return ARITHMOS


def name(c, scope, node):
    return c.lookup(scope, node.kids[0], node.line)


def operator(c, scope, node):
    return relation(pair(ARITHMOS, ARITHMOS), ARITHMOS)


def theta(c, scope, node):
    schema, strokes = node.kids
    found = components(c, scope, Node("name", (schema,), node.line))
    for n, t in found.items():
        c.same(node.line, c.component(scope, n + strokes, node.line), t, f"component {n} of θ")
    return ("schema", tuple(sorted(found.items())))


def tuple_(c, scope, node):
    return pair(*(c.type(scope, kid) for kid in node.kids))


def select(c, scope, node):
    return c.part(node, c.type(scope, node.kids[0]))


def instance(c, scope, node):
    """A generic with its actuals."""
    name, *actuals = node.kids
    t = c.names.get(name.kids[0], c.unknown())
    return c.instance(t, [c.member(scope, kid) for kid in actuals])


def sequence(c, scope, node):
    return relation(ARITHMOS, display(c, scope, node)[1])


def sequences(c, scope, node):
    return power(relation(ARITHMOS, c.member(scope, node.kids[0])))


def identity(c, scope, node):
    x = c.member(scope, node.kids[0])
    return power(pair(x, x))


def interval(c, scope, node):
    arithmetic(c, scope, node)
    return power(ARITHMOS)


def binding(c, scope, node):
    return ("schema", tuple(sorted((n, c.type(scope, kid)) for n, kid in node.kids)))


def closure(c, scope, node):
    x = c.unknown()
    t = relation(x, x)
    c.same(node.line, c.type(scope, node.kids[0]), t, "closure of a relation")
    return t


def iterate(c, scope, node):
    c.same(node.line, c.type(scope, node.kids[1]), ARITHMOS, "how often a relation is iterated")
    return closure(c, scope, node)


def composition(c, scope, node):
    x, y, z = c.unknown(), c.unknown(), c.unknown()
    c.same(node.line, c.type(scope, node.kids[0]), relation(x, y), "composition")
    c.same(node.line, c.type(scope, node.kids[1]), relation(y, z), "composition")
    return relation(x, z)


def apply(c, scope, node):
    function, argument = (c.type(scope, kid) for kid in node.kids)
    takes, gives = c.unknown(), c.unknown()
    c.same(node.line, function, relation(takes, gives), "a function is expected")
    c.same(node.line, argument, takes, "argument")
    return gives


def arithmetic(c, scope, node):
    return c.arithmetic(node, *(c.type(scope, kid) for kid in node.kids))


def negative(c, scope, node):
    return c.arithmetic(node, c.type(scope, node.kids[0]))


def power_set(c, scope, node):
    return power(power(c.member(scope, node.kids[0])))


def cross(c, scope, node):
    return power(pair(*(c.member(scope, kid) for kid in node.kids)))


def functions(c, scope, node):
    return power(relation(*(c.member(scope, kid) for kid in node.kids)))


def maplet(c, scope, node):
    return tuple_(c, scope, node)


def alike(c, scope, node):
    """Operands and result are sets of one type: ∪ ∩ \\ and ⊕."""
    first = c.type(scope, node.kids[0])
    c.same(node.line, first, power(c.unknown()), f"operand of {node.op}")
    c.same(node.line, c.type(scope, node.kids[1]), first, f"operand of {node.op}")
    return first


def catenation(c, scope, node):
    first = alike(c, scope, node)
    c.same(node.line, first, relation(ARITHMOS, c.unknown()), "a sequence is expected")
    return first


def restrict_domain(c, scope, node):
    names, r = (c.type(scope, kid) for kid in node.kids)
    x = c.unknown()
    c.same(node.line, r, relation(x, c.unknown()), f"operand of {node.op}")
    c.same(node.line, names, power(x), f"operand of {node.op}")
    return r


def restrict_range(c, scope, node):
    r, names = (c.type(scope, kid) for kid in node.kids)
    y = c.unknown()
    c.same(node.line, r, relation(c.unknown(), y), f"operand of {node.op}")
    c.same(node.line, names, power(y), f"operand of {node.op}")
    return r


def inverse(c, scope, node):
    x, y = c.unknown(), c.unknown()
    c.same(node.line, c.type(scope, node.kids[0]), relation(x, y), "inverse of a relation")
    return relation(y, x)


def image(c, scope, node):
    x, y = c.unknown(), c.unknown()
    c.same(node.line, c.type(scope, node.kids[0]), relation(x, y), "relational image")
    c.same(node.line, c.type(scope, node.kids[1]), power(x), "relational image")
    return power(y)


def choice(c, scope, node):
    test, yes, no = node.kids
    c.predicate(scope, test)
    t = c.type(scope, yes)
    c.same(node.line, c.type(scope, no), t, "the branches of if")
    return t


def display(c, scope, node):
    x = c.unknown()
    for kid in node.kids:
        c.same(kid.line, c.type(scope, kid), x, "member of a set")
    return power(x)


def characteristic(types):
    if not types:
        return ("schema", ())
    return types[0] if len(types) == 1 else pair(*types)


def comprehension(c, scope, node):
    text, value = node.kids
    inner, types, _ = c.text(scope, text)
    return power(characteristic(types) if value is None else c.type(inner, value))


def function(c, scope, node):
    inner, types, _ = c.text(scope, node.kids[0])
    return relation(characteristic(types), c.type(inner, node.kids[1]))


def description(c, scope, node):
    inner, types, _ = c.text(scope, node.kids[0])
    return characteristic(types) if node.kids[1] is None else c.type(inner, node.kids[1])


def schema(c, scope, node):
    return power(("schema", tuple(sorted(c.text(scope, node.kids[0])[2].items()))))


def components(c, scope, node):
    t = c.type(scope, node)
    found = c.components(t)
    if found is None and c.prune(t)[0] != "unknown":
        c.error(node.line, f"a schema is expected, not {c.show(t)}")
    return dict(found or ())


def decorate(c, scope, node):
    return power(("schema", tuple(sorted((n + "'", t) for n, t in components(c, scope, node.kids[0]).items()))))


def connective(c, scope, node):
    """∧ ∨ ⇒ ⇔ ¬ of schemas: the signatures joined."""
    joined = {}
    for kid in node.kids:
        for n, t in components(c, scope, kid).items():
            c.same(node.line, t, joined.setdefault(n, t), f"component {n}")
    return power(("schema", tuple(sorted(joined.items()))))


def quantified(c, scope, node):
    """∀ ∃ ∃₁ of schemas: the signature without the names that the text declares."""
    inner, _, declared = c.text(scope, node.kids[0])
    found = components(c, inner, node.kids[1])
    for n in declared.keys() & found.keys():
        c.same(node.line, found.pop(n), declared[n], f"component {n}")
    return power(("schema", tuple(sorted(found.items()))))


def precondition(c, scope, node):
    """pre S: the state before and the inputs."""
    kept = {n: t for n, t in components(c, scope, node.kids[0]).items() if n[-1] not in "'!"}
    return power(("schema", tuple(sorted(kept.items()))))


def hiding(c, scope, node):
    found = components(c, scope, node.kids[0])
    for n in node.kids[1]:
        if found.pop(n, None) is None:
            c.error(node.line, f"{n} is not a component to hide")
    return power(("schema", tuple(sorted(found.items()))))


def composed(c, scope, node):
    """S ⨟ T: the state after S is that before T, and neither is a component."""
    first, second = (components(c, scope, kid) for kid in node.kids)
    middle = [n for n in second if n[-1] not in "?!'" and n + "'" in first]
    for n in middle:
        c.same(node.line, second.pop(n), first.pop(n + "'"), f"component {n}")
    for n, t in second.items():
        c.same(node.line, t, first.setdefault(n, t), f"component {n}")
    return power(("schema", tuple(sorted(first.items()))))


RULES = {
    "number": number, "name": name, "theta": theta, "tuple": tuple_, "select": select, "apply": apply,
    "operator": operator, "decorate": decorate, r"\pre": precondition,
    "+": arithmetic, "-": arithmetic, "*": arithmetic, "prefix-": negative,
    r"prefix\power": power_set, r"prefix\power_1": power_set,
    r"prefix\finset": power_set, r"prefix\finset_1": power_set,
    r"\cross": cross, r"\fun": functions, r"\pfun": functions, r"\ffun": functions, r"\rel": functions,
    r"\mapsto": maplet, r"\upto": interval, r"prefix\id": identity,
    r"\cup": alike, r"\cap": alike, r"\setminus": alike, r"\oplus": alike, r"\cat": catenation,
    r"\dres": restrict_domain, r"\ndres": restrict_domain, r"\rres": restrict_range, r"\nrres": restrict_range,
    "instance": instance, "sequence": sequence, r"prefix\seq": sequences, "binding": binding, "closure": closure,
    "iterate": iterate, r"prefix\negate": negative,
    r"\comp": composition, "inverse": inverse, "image": image, "if": choice, "display": display, "set": comprehension,
    r"\lambda": function, r"\mu": description, "schema": schema, "hide": hiding, "semi": composed,
    r"\land": connective, r"\lor": connective, r"\implies": connective, r"\iff": connective, r"\lnot": connective,
    r"\forall": quantified, r"\exists": quantified, r"\exists_1": quantified,
}
