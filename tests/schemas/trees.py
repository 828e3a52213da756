"""JSON as trees that can be wrong, and are made so: an object is a list of pairs, so that a key may stand twice, and a
text may stand for a value as it is, so that it may be no JSON."""
import json


class Object:
    def __init__(self, pairs):
        self.pairs = [list(pair) for pair in pairs]


class Raw(str):
    """Stands in the text as it is."""


def read(text):
    return json.loads(text, object_pairs_hook=Object)


def write(tree):
    if isinstance(tree, Raw):
        return str(tree)
    if isinstance(tree, Object):
        return "{" + ",".join(f"{write(key)}:{write(value)}" for key, value in tree.pairs) + "}"
    if isinstance(tree, list):
        return "[" + ",".join(map(write, tree)) + "]"
    return json.dumps(tree, ensure_ascii=False)


def slots(tree, found=None, way=""):
    """Every place of a value in the tree, as (container, index, way): container[index] of a list, pairs[index] of an
    object; the way there is of keys, without numbers of items."""
    found = [] if found is None else found
    keys = [str(key) for key, _ in tree.pairs] if isinstance(tree, Object) else []
    if isinstance(tree, list):
        keys = [""] * len(tree)
    for i, key in enumerate(keys):
        found.append((tree, i, f"{way}/{key}"))
        slots(get(found[-1]), found, f"{way}/{key}")
    return found


def any_of(random, places):
    """One of the places: each way is as likely as another, however many places it leads to."""
    way = random.choice(sorted({way for _, _, way in places}))
    return random.choice([place for place in places if place[2] == way])


def get(slot):
    container, i, _ = slot
    return container.pairs[i][1] if isinstance(container, Object) else container[i]


def put(slot, value):
    container, i, _ = slot
    if isinstance(container, Object):
        container.pairs[i][1] = value
    else:
        container[i] = value


def items(container):
    return container.pairs if isinstance(container, Object) else container


WORDS = ["", "a", "A_b.c:d-9", "a b", "ñ", "esfera", "Esfera", "hit", "nan", "inf", "NaN", "1", "red", "x" * 128,
         "x" * 129, "soy_cono", "binary16", "open", "e0", Raw('"\\ud800"'), Raw('"\\u0061"'), Raw('"\t"')]
NUMBERS = [0, -1, 1, 0.5, 1.5, 2, 7.0, 180, 65535, 65536, -5e-324, 5e-324, 1e-999, 1e308, 2**53, 2**53 + 2, Raw("-0"),
           Raw("1e999"), Raw("-1e999"), Raw("1e400"), Raw("1.0"), Raw("NaN"), Raw("Infinity"), Raw("01"), Raw("+1"),
           Raw("0x1"), Raw(".5"), Raw("1" + "0" * 400)]
OTHERS = [None, True, False, [], Object([]), [1, 2], [1, 2, 3, 4], [[0, 0, 0]], Object([("x", 1)]), Raw(""), Raw("nul")]


def drop(random, tree):
    container, i, _ = any_of(random, slots(tree))
    del items(container)[i]


def add_key(random, tree):
    objects = [part for part in [tree, *map(get, slots(tree))] if isinstance(part, Object)]
    into = random.choice(objects)
    key = random.choice(["color", "version2", "", "Radio", "material", "why", "t", "radio?", "altura", "watertight"])
    into.pairs.insert(random.randint(0, len(into.pairs)), [key, random.choice([1, "red", None, True])])


def double(random, tree):
    """A key or an item a second time."""
    container, i, _ = any_of(random, slots(tree))
    part = items(container)[i]
    again = list(part) if isinstance(container, Object) else part
    items(container).insert(random.randint(0, len(items(container))), again)


def retype(random, tree):
    put(any_of(random, slots(tree)), random.choice(OTHERS))


def renumber(random, tree):
    numbers = [slot for slot in slots(tree) if isinstance(get(slot), (int, float)) and not isinstance(get(slot), bool)]
    put(any_of(random, numbers or slots(tree)), random.choice(NUMBERS))


def reword(random, tree):
    words = [slot for slot in slots(tree) if isinstance(get(slot), str)]
    slot = any_of(random, words or slots(tree))
    other = get(any_of(random, words or slots(tree)))
    put(slot, random.choice([*WORDS, other]))


def rename(random, tree):
    objects = [part for part in [tree, *map(get, slots(tree))] if isinstance(part, Object) and part.pairs]
    pair = random.choice(random.choice(objects).pairs)
    pair[0] = random.choice([pair[0].upper(), pair[0] + "?", pair[0] + " ", ""])


def swap(random, tree):
    one, other = any_of(random, slots(tree)), any_of(random, slots(tree))
    held = get(one)
    if not any(part is get(other) for part in [held, *map(get, slots(held))]) and \
            not any(part is held for part in map(get, slots(get(other)))):
        put(one, get(other))
        put(other, held)


def wrap(random, tree):
    slot = any_of(random, slots(tree))
    put(slot, [get(slot)])


def shuffle(random, tree):
    """This changes no meaning of an object."""
    objects = [part for part in [tree, *map(get, slots(tree))] if isinstance(part, Object)]
    random.shuffle(random.choice(objects).pairs)


CHANGES = [drop, add_key, double, retype, renumber, renumber, reword, reword, rename, swap, wrap, shuffle]


def mutant(random, text):
    """A text changed in one place, or in two, and how."""
    tree = read(text)
    changes = [random.choice(CHANGES) for _ in range(random.choice([1, 1, 2]))]
    for change in changes:
        if slots(tree):
            change(random, tree)
    return write(tree), "+".join(change.__name__ for change in changes)
