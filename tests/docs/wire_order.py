"""wire_order.py DURERO ROOT: the order of an element's numbers in a question, as docs/formats/conform.md has it.

Each row of its table is read by systems/protocol.py, which adapters of systems go by, and answered by the program: a ray
that meets the element where its numbers are in this order, and not there where two of its lengths are taken for one
another.
"""
import pathlib
import re
import subprocess
import sys

durero, root = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path.insert(0, str(root / "systems"))
import protocol  # noqa: E402

# A value of each name; the ends of an axis, and the radii there, differ.
VALUES = {"centro": [1, 2, 3], "vector": [0, 0, 1], "radio": [4], "proporcion": [0.5], "altura": [16],
          "vertices": [0, 0, 3, 8, 0, 3, 0, 8, 3]}
# A ray to each, and what is met: towards the axis at half its length, or down to the plane of what is flat.
ACROSS, DOWN = "101 2 11 -1 0 0", "2 3 10 0 0 -1"
MET = {"esfera": ("101 2 3 -1 0 0", 96), "cilindro": (ACROSS, 96), "cono": (ACROSS, 96), "tronco": (ACROSS, 92),
       "plano": (DOWN, 7), "disco": (DOWN, 7), "triangulo": (DOWN, 7)}


def table():
    page = (root / "docs" / "formats" / "conform.md").read_text()
    section = page[page.index("## Questions"):page.index("## Claims")]
    rows = re.findall(r"^\| `(\w+)` \| (`.*) \|$", section, re.M)
    return {tipo: re.findall(r"`(\w+)`", numbers) for tipo, numbers in rows if tipo in MET}


def line_of(tipo, names):
    return " ".join([tipo, "e0", *(str(x) for name in names for x in VALUES[name])])


def read(element, name):
    value = getattr(element, name)
    if name == "vertices":
        return [x for vertex in value for x in vertex]
    return list(value) if isinstance(value, tuple) else [value]


wrong = ["no row of " + tipo for tipo in sorted(MET.keys() - table().keys())]
for tipo, names in table().items():
    line = line_of(tipo, names)
    element = protocol.Element(line)
    wrong += ["%s: protocol.py reads %s as %s" % (line, name, read(element, name))
              for name in names if read(element, name) != VALUES[name]]
    ray, t = MET[tipo]
    question = "scene a\n%s\nrays 1\n%s\n" % (line, ray)
    said = subprocess.run([durero, "conform", "answer"], input=question, capture_output=True, text=True)
    answer = said.stdout.splitlines()[-1:] or [said.stderr.strip()]
    if not answer[0].startswith("hit e0 %d " % t):
        wrong.append("%s: %s answers %s, expected t = %d" % (line, ray, answer[0], t))
print("\n".join(wrong) or "%d types of elements" % len(MET))
sys.exit(bool(wrong))
