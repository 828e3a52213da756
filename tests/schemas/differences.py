"""What JSON Schema cannot say of files: docs/formats.md lists it, class by class, and here each class is a predicate.
It is asked of a file that the schema accepts."""
import fractions

import trees
from samples import SCENE
from schemas import parsed


def has_key_twice(tree):
    if isinstance(tree, trees.Object):
        keys = [key for key, _ in tree.pairs]
        return len(set(keys)) < len(keys) or any(has_key_twice(value) for _, value in tree.pairs)
    return isinstance(tree, list) and any(map(has_key_twice, tree))


def strings(value):
    if isinstance(value, str):
        return [value]
    parts = [*value.keys(), *value.values()] if isinstance(value, dict) else value if isinstance(value, list) else []
    return [text for part in parts for text in strings(part)]


def is_no_unicode(value):
    return any("\ud800" <= c <= "\udfff" for text in strings(value) for c in text)


def off_unit(v):
    return abs(sum(fractions.Fraction(float(x)) ** 2 for x in v) - 1) > fractions.Fraction(1, 2**50)


def on_one_line(vertices):
    a, b, c = ([fractions.Fraction(float(x)) for x in point] for point in vertices)
    u, w = [x - y for x, y in zip(b, a)], [x - y for x, y in zip(c, a)]
    return all(u[i - 2] * w[i - 1] == u[i - 1] * w[i - 2] for i in range(3))


def values(scene, key):
    return [element[key] for element in scene["elementos"] if key in element]


def spots(scene):
    return [light for light in scene.get("lights", []) if "spot" in light]


def unknown_material(value):
    return any(material not in value.get("materials", {}) for material in values(value, "material"))


def unknown_texture(value):
    known = value.get("textures", {})
    materials = value.get("materials", {}).values()
    used = [name for material in materials for name in material.get("textures", {}).values()]
    used += [material["bump"]["texture"] for material in materials if "bump" in material]
    return any(name not in known for name in used)


def no_forest(value):
    """Some member of a group is none of the scene's, or in two, or a group lies within itself."""
    groups = value.get("groups", {})
    elements = [name for group in groups.values() for name in group.get("elementos", [])]
    inner = [name for group in groups.values() for name in group.get("groups", [])]
    if set(elements) - set(values(value, "id")) or set(inner) - set(groups):
        return True
    if len(set(elements)) < len(elements) or len(set(inner)) < len(inner):
        return True
    left, before = dict(groups), -1
    while len(left) != before:
        before = len(left)
        left = {name: group for name, group in left.items() if set(group.get("groups", [])) & set(left)}
    return bool(left)


def unknown_material_of_edit(operation):
    return any(operation.get(key, "red") not in SCENE_MATERIALS for key in ("material", "material?"))


SCENE_MATERIALS = parsed(SCENE)["materials"]
SCENE_IDS = values(parsed(SCENE), "id")


def classes(claim_ids, families):
    """Of each subject, by name. `claim_ids` are the elements of the case that claims are about."""
    of = {
        "scene": {
            "id twice": lambda s: len(set(values(s, "id"))) < len(values(s, "id")),
            "no unit vector": lambda s: any(map(off_unit, values(s, "vector"))),
            "vertices on one line": lambda s: any(map(on_one_line, values(s, "vertices"))),
            "eye at look_at": lambda s: "camera" in s and s["camera"]["eye"] == s["camera"]["look_at"],
            "spot at its light": lambda s: any(l["spot"]["towards"] == l["position"] for l in spots(s)),
            "inner beyond outer": lambda s: any(
                l["spot"].get("inner", 30) > l["spot"].get("outer", 45) for l in spots(s)),
            "unknown material": unknown_material,
            "unknown texture": unknown_texture,
            "groups that are no forest": no_forest},
        "operation": {"unknown material": unknown_material_of_edit},
        "hit": {"unknown element": lambda h: not set(h["elementos"]) <= set(SCENE_IDS),
                "no such ray": lambda h: h["ray"] > 2},
        "claim": {"no such case": lambda c: c.get("case") != "generic/0000", "no such ray": lambda c: c["ray"] > 1,
                  "unknown element": lambda c: c.get("element", claim_ids[0]) not in claim_ids},
        "profile": {},
        "system": {"another name": lambda s: s["system"] != "mutant"},
        "campaign": {"unknown family": lambda c: not set(c.get("families", [])) <= set(families),
                     "too many rays": lambda c: c["rays_of_a_shard"] * c["shards"] > 2**53}}
    for subject, of_subject in of.items():
        of_subject["key twice"] = None  # what is parsed has lost it
        if subject != "hit":  # its strings are names
            of_subject["no Unicode"] = is_no_unicode
    return of


def classes_of(text, of_subject):
    """The names of those that apply."""
    if has_key_twice(trees.read(text)):
        return ["key twice"]
    value = parsed(text)
    return [name for name, applies in of_subject.items() if applies and applies(value)]
