#!/usr/bin/env python3
"""povray.py DURERO: POV-Ray, which shares no line with this program, meets the same elements at the same parameters.

Generic rays on a generic scene, where binary64 without care is right as well: an element, or none, must be the same for
every ray, and t the same to ten digits. Exit status 77 (skipped) where POV-Ray is absent (Debian: povray).
"""
import json
import math
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

ELEMENTS, RAYS, SEED = 60, 20000, 1
RELATIVE = 1e-10  # of POV-Ray's own rounding, which the comparison must forgive; nothing here decides a meaning


def unit_axis(rng):
    """A direction whose binary64 components have a square within 2^-50 of 1, as adding an element asks."""
    while True:
        w = [rng.gauss(0, 1) for _ in range(3)]
        length = math.hypot(*w)
        d = [c / length for c in w]
        if abs(math.fsum(c * c for c in d) - 1) < 2.0**-51:
            return d


def scene(rng):
    made = []
    for i in range(ELEMENTS):
        centro = [rng.random() for _ in range(3)]
        radio, altura = rng.uniform(0.03, 0.08), rng.uniform(0.1, 0.25)
        tipo = ("esfera", "cilindro", "cono", "tronco", "disco", "triangulo")[i % 6]
        element = {"id": f"e{i:02}", "tipo": tipo, "centro": centro}
        if tipo == "cono":
            element |= {"proporcion": radio / altura, "vector": unit_axis(rng), "altura": altura}
        elif tipo == "tronco":
            element |= {"radio": radio / 3, "proporcion": radio / altura, "vector": unit_axis(rng), "altura": altura}
        elif tipo == "disco":
            element |= {"radio": 2 * radio, "vector": unit_axis(rng)}
        elif tipo == "triangulo":
            corners = [[c + rng.uniform(-0.2, 0.2) for c in centro] for _ in range(3)]
            element = {"id": element["id"], "tipo": tipo, "vertices": corners}
        elif tipo == "cilindro":
            element |= {"radio": radio, "vector": unit_axis(rng), "altura": altura}
        else:
            element["radio"] = radio
        made.append(element)
    made.append({"id": "p", "tipo": "plano", "centro": [0.5, 0.5, 0.5], "vector": unit_axis(rng)})
    return made


def vector(c):
    return "<" + ",".join(repr(x) for x in c) + ">"


def pov_object(e):
    tipo = e["tipo"]
    if tipo == "triangulo":
        return f"triangle {{ {', '.join(vector(v) for v in e['vertices'])} }}"
    centro = vector(e["centro"])
    if tipo == "esfera":
        return f"sphere {{ {centro}, {e['radio']!r} }}"
    if tipo == "plano":
        return f"plane {{ {vector(e['vector'])}, vdot({centro}, {vector(e['vector'])}) }}"
    if tipo == "disco":
        return f"disc {{ {centro}, {vector(e['vector'])}, {e['radio']!r} }}"
    end = f"{centro} + {e['altura']!r}*{vector(e['vector'])}"
    if tipo == "cilindro":
        return f"cylinder {{ {centro}, {end}, {e['radio']!r} open }}"
    top = e.get("radio", 0.0)
    return f"cone {{ {centro}, {top + e['proporcion'] * e['altura']!r}, {end}, {top!r} open }}"


def pov_program(elements):
    """Traces every ray on each element by itself and writes the nearest: its number and the point."""
    objects = "\n".join(f"#declare Element[{i}] = {pov_object(e)};" for i, e in enumerate(elements))
    return f"""#version 3.7;
#declare Element = array[{len(elements)}];
{objects}
#fopen Rays "rays.txt" read
#fopen Hits "pov-hits.txt" write
#while (defined(Rays))
  #read (Rays, A, B, C, D, E, F)
  #declare P = <A, B, C>;
  #declare Best = -1;
  #declare Nearest = 0;
  #declare I = 0;
  #while (I < {len(elements)})
    #declare N = <0, 0, 0>;
    #declare Q = trace(Element[I], P, <D, E, F>, N);
    #if (vlength(N) != 0)
      #if (Best < 0 | vlength(Q - P) < Nearest)
        #declare Best = I;
        #declare Nearest = vlength(Q - P);
      #end
    #end
    #declare I = I + 1;
  #end
  #write (Hits, str(Best, 0, 0), " ", str(Nearest, 0, 17), "\\n")
#end
#fclose Rays
#fclose Hits
"""


def by_povray(folder, elements, rays):
    numbers = ",\n".join(",".join(repr(x) for x in ray) for ray in rays)
    (folder / "rays.txt").write_text(numbers + "\n")
    (folder / "trace.pov").write_text(pov_program(elements))
    done = subprocess.run(["povray", "+Itrace.pov", "+Oout.png", "+W8", "+H8", "-D"], cwd=folder, capture_output=True, text=True)
    answers = folder / "pov-hits.txt"
    if not answers.exists():
        sys.exit(f"povray wrote no answers:\n{done.stderr[-2000:]}")
    for line in answers.read_text().splitlines():
        number, distance = line.split()
        yield (elements[int(number)]["id"], float(distance)) if int(number) >= 0 else (None, 0.0)


def by_durero(durero, folder, elements, rays):
    (folder / "scene.json").write_text(json.dumps({"format": "durero-scene", "version": 1, "elementos": elements}))
    (folder / "rays").write_text("".join(" ".join(x.hex() for x in ray) + "\n" for ray in rays))
    said = subprocess.run([durero, "trace", folder / "scene.json", folder / "rays"], check=True, capture_output=True, text=True)
    for line, ray in zip(said.stdout.splitlines(), rays, strict=True):
        hit = json.loads(line)
        if hit["outcome"] == "miss":
            yield None, 0.0
        else:
            yield hit["elementos"][0], hit["t"] * math.hypot(*ray[3:])


def main():
    if shutil.which("povray") is None:
        print("skipped: POV-Ray is absent (Debian: povray)")
        sys.exit(77)
    rng = random.Random(SEED)
    elements, rays = scene(rng), []
    for _ in range(RAYS):
        p = [rng.uniform(-2, 3) for _ in range(3)]
        rays.append([*p, *(rng.random() - c for c in p)])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        ours = list(by_durero(sys.argv[1], folder, elements, rays))
        theirs = list(by_povray(folder, elements, rays))
    if len(theirs) != len(rays):
        sys.exit(f"povray answered {len(theirs)} of {len(rays)} rays")
    wrong = [i for i, (a, b) in enumerate(zip(ours, theirs)) if a[0] != b[0] or abs(a[1] - b[1]) > RELATIVE * a[1]]
    for i in wrong[:5]:
        print(f"ray {i}: {' '.join(x.hex() for x in rays[i])}\n  here {ours[i]}, POV-Ray {theirs[i]}")
    hits = sum(a[0] is not None for a in ours)
    print(f"{len(rays)} rays, {hits} hits, {len(wrong)} differ from POV-Ray (seed {SEED})")
    sys.exit(1 if wrong or hits < len(rays) // 10 else 0)


if __name__ == "__main__":
    main()
