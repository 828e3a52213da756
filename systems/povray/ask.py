"""Asks POV-Ray: a scene of its language a question, which traces each ray to each element and writes the points.

str() writes digits behind the point, so points are scaled by a power of two first: what is written is exact to 1e-25 of
the largest coordinate. Of several elements the one whose point is nearest is first. The argument `mesh` makes one mesh of
all triangles, of which it does not say which is met.
"""
import math
import os
import re
import signal
import subprocess
import sys
import tempfile


def vector(numbers):
    return "<" + ",".join(numbers) + ">"


def top(w):
    return vector([repr(float(w[i]) + float(w[-1]) * float(w[3 + i])) for i in range(3)])


def base_radius(tipo, w):
    k, h = float(w[-2]), float(w[-1])
    return repr(k * h if tipo == "cono" else float(w[6]) + k * h)


def capsule(w):
    radius = repr(math.hypot(*map(float, w[3:6])))
    ends = [vector([repr(float(c) + sign * float(y)) for c, y in zip(w[:3], w[6:9])]) for sign in (-1, 1)]
    return "merge{cylinder{%s,%s,%s} sphere{%s,%s} sphere{%s,%s}}" % (*ends, radius, ends[0], radius, ends[1], radius)


def object_of(tipo, w):
    """The element in the scene language; w are its numbers, as text."""
    c, d = vector(w[:3]), vector(w[3:6])
    mapped = "matrix<" + ",".join(w[3:12] + w[:3]) + ">"
    if tipo in ("caja", "copia_caja"):
        return "box{-1,1 %s}" % mapped
    if tipo in ("elipsoide", "copia_esfera"):
        return "sphere{0,1 %s}" % mapped
    if tipo == "capsula":
        return capsule(w)
    if tipo == "esfera":
        return "sphere{%s,%s}" % (c, w[3])
    if tipo == "cilindro":
        return "cylinder{%s,%s,%s open}" % (c, top(w), w[6])
    if tipo == "cono":
        return "cone{%s,%s,%s,0 open}" % (c, base_radius(tipo, w), top(w))
    if tipo == "tronco":
        return "cone{%s,%s,%s,%s open}" % (c, base_radius(tipo, w), top(w), w[6])
    if tipo == "disco":
        return "disc{%s,%s,%s}" % (c, d, w[6])
    if tipo == "triangulo":
        return "triangle{%s,%s,%s}" % (c, d, vector(w[6:9]))
    if tipo == "mesh":
        return "mesh{%s}" % " ".join(object_of("triangulo", w[i : i + 9]) for i in range(0, len(w), 9))
    distance = sum(float(w[i]) * float(w[3 + i]) for i in range(3))
    return "plane{%s,%r}" % (d, distance)


def scale_of(elements, rays):
    largest = max([abs(float(x)) for _, _, w in elements for x in w] + [abs(float(x)) for r in rays for x in r[:3]])
    return 2.0 ** -math.ceil(math.log2(largest)) if largest > 0 else 1.0


SCENE = """#version 3.7;
global_settings{assumed_gamma 1}
camera{location 0}
#declare Objects=array[%d]{%s};
#declare S=%r;
#fopen R "rays" read
#fopen W "hits" write
#while(defined(R))
  #read(R,PX,PY,PZ,VX,VY,VZ)
  #declare I=0;
  #while(I<%d)
    #declare N=<0,0,0>;
    #declare P=trace(Objects[I],<PX,PY,PZ>,<VX,VY,VZ>,N);
    #if(vlength(N)=0) #write(W,"miss\\n") #else #write(W,vstr(3,P*S," ",0,25),"\\n") #end
    #declare I=I+1;
  #end
#end
#fclose W
"""


def run(elements, rays, scale):
    """The lines that the scene writes, and what went wrong."""
    with tempfile.TemporaryDirectory() as folder:
        objects = ",\n".join(object_of(tipo, w) for tipo, _, w in elements)
        with open(folder + "/scene.pov", "w") as file:
            file.write(SCENE % (len(elements), objects, scale, len(elements)))
        with open(folder + "/rays", "w") as file:
            file.write(",\n".join(",".join(ray) for ray in rays) + "\n")
        command = ["povray", "+Iscene.pov", "+W1", "+H1", "-D", "+FN", "+Oout.png", "-GA", "+WT1"]
        ended = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, text=True)
        if ended.returncode < 0:
            os.kill(os.getpid(), -ended.returncode if -ended.returncode != signal.SIGSTOP else signal.SIGKILL)
        try:
            with open(folder + "/hits") as file:
                lines = file.read().splitlines()
        except FileNotFoundError:
            lines = []
        error = re.search(r"(?:Parse|Fatal) Error: *(.*)", ended.stderr)
        return lines, error.group(1).strip() if error else "status %d" % ended.returncode


def answer_of(lines, elements, ray, scale):
    """The nearest of what one ray met."""
    nearest, answer = math.inf, "miss"
    for (_, name, _), line in zip(elements, lines):
        if line == "miss":
            continue
        x, y, z = [float(number) / scale for number in line.split()]
        away = math.dist((x, y, z), [float(number) for number in ray[:3]])
        if away < nearest:
            nearest, answer = away, "hit %s - %r %r %r" % (name, x, y, z)
    return answer


def answer(elements, rays):
    if sys.argv[1:] == ["mesh"]:
        elements = [("mesh", "-", [number for _, _, w in elements for number in w])]
    scale = scale_of(elements, rays)
    lines, error = run(elements, rays, scale)
    count = len(elements)
    for i, ray in enumerate(rays):
        of_ray = lines[i * count:(i + 1) * count]
        print(answer_of(of_ray, elements, ray, scale) if len(of_ray) == count else "refused " + error)
    sys.stdout.flush()


def main():
    said = subprocess.run(["povray", "--version"], capture_output=True, text=True).stderr
    version = re.search(r"POV-Ray (\S+)", said)
    print("system POV-Ray", version.group(1) if version else "unknown", flush=True)
    elements = []
    for line in sys.stdin:
        words = line.split()
        if words[0] == "scene":
            elements = []
        elif words[0] == "rays":
            answer(elements, [sys.stdin.readline().split() for _ in range(int(words[1]))])
        else:
            elements.append((words[0], words[1], words[2:]))


main()
