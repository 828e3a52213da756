# A system that knows spheres: it reads the rays of `durero conform run` and writes its hits.
import math, sys

def roots(p, v, c, r):  # t of |p + t·v - c| = r
    q = [a - b for a, b in zip(p, c)]
    A, B, C = (sum(a * b for a, b in zip(x, y)) for x, y in ((v, v), (q, v), (q, q)))
    D = B * B - A * (C - r * r)
    return [] if D < 0 else [(-B - math.sqrt(D)) / A, (-B + math.sqrt(D)) / A]

print("system example-python 1", flush=True)
for line in sys.stdin:
    word, name, *numbers = line.split()
    if word == "scene": spheres = []
    if word == "esfera": spheres.append((name, *map(float, numbers)))
    for _ in range(int(name) if word == "rays" else 0):
        x = [float(number) for number in next(sys.stdin).split()]
        hits = [(t, e) for e, *c, r in spheres for t in roots(x[:3], x[3:], c, r) if t > 0]
        print("hit %s %r" % min(hits)[::-1] if hits else "miss", flush=True)
