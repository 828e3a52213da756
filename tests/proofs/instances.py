"""What proofs/Instances.v states of its scene is what durero trace prints: the elements, and the bits of t and of the point.

The scene and the questions are read from the statements, so that each stands once.

    instances.py DURERO PROOFS
"""

import json
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

KEYS = {
    "Sphere": ("esfera", ["centro", "radio"]),
    "Cylinder": ("cilindro", ["centro", "radio", "vector", "altura"]),
    "Cone": ("cono", ["centro", "proporcion", "vector", "altura"]),
    "TruncatedCone": ("tronco", ["centro", "radio", "proporcion", "vector", "altura"]),
    "Plane": ("plano", ["centro", "vector"]),
    "Disc": ("disco", ["centro", "radio", "vector"]),
    "Triangle": ("triangulo", None),
}
RAY = r"\(v3 ([^v]*)\) \(v3 ([^v]*)\) (\w+)"


def integers(text):
    return [int(number) for number in re.findall(r"-?\d+", text)]


class Statements:
    """The scene and the questions of the files of proofs, as what the program reads."""

    def __init__(self, proofs):
        self.scene_text = (proofs / "InstanceScene.v").read_text(encoding="utf-8")
        self.text = re.sub(r"\s+", " ", (proofs / "Instances.v").read_text(encoding="utf-8"))
        self.denominator = int(re.search(r"scene_of (\d+) seven", self.scene_text).group(1))
        self.axes = {
            name: self.numbers(value) for name, value in re.findall(r"Definition (along_\w+) := v3 ([^.]*)\.", self.scene_text)
        }
        self.starts = dict(re.findall(r"Definition (\w+) \(e : nat\) : bool := Nat\.eqb e (\d+)\.", self.text))

    def numbers(self, text):
        return [number / self.denominator for number in integers(text)]

    def values(self, arguments):
        """The numbers and vectors of a shape, in their order."""
        for vector, axis, number in re.findall(r"\(v3 (\S+ \S+ \S+?)\)(?= |$)|(along_\w+)|(-?\d+)", arguments):
            yield self.numbers(vector) if vector else self.axes[axis] if axis else int(number) / self.denominator

    def scene(self):
        listed = re.search(r"Definition seven .*?:= \[\n(.*?) \]\.", self.scene_text, re.S).group(1)
        elements = []
        for name, shape, arguments in re.findall(r"\((\d+)%nat, (\w+) (.*)\)(?:;|$)", listed, re.M):
            tipo, keys = KEYS[shape]
            values = list(self.values(arguments))
            attributes = {"vertices": values} if keys is None else dict(zip(keys, values, strict=True))
            elements.append({"id": name, "tipo": tipo, **attributes})
        assert len(elements) == len(KEYS), "one of each shape"
        return {"format": "durero-scene", "version": 1, "elementos": elements}

    def ray(self, origin, direction, start):
        words = [repr(number) for number in self.numbers(origin) + self.numbers(direction)]
        return " ".join(words + (["@" + self.starts[start]] if start in self.starts else []))

    def hits(self):
        """Each ray with the elements and the bits of its hit."""
        form = rf"publishes {RAY} \(Search\.Published_hit _ _ \(Some out\) \[([^\]]*)\]\) /\\ bits_of out = \[([^\]]*)\]"
        for *ray, elements, bits in re.findall(form, self.text):
            yield self.ray(*ray), [str(e) for e in integers(elements)], integers(bits)

    def shadows(self):
        """Each shadow ray with its answers, without an end and as a segment."""
        for *ray, endless, segment in re.findall(rf"blocked {RAY} (true|false) (true|false)", self.text):
            yield self.ray(*ray), endless == "true", segment == "true"


def bits(number):
    return struct.unpack("<Q", struct.pack("<d", number))[0]


def main(durero, proofs):
    statements = Statements(pathlib.Path(proofs))
    hits, shadows = list(statements.hits()), list(statements.shadows())
    assert len(hits) >= 2 and len(shadows) >= 2, "Instances.v states no answers that this test reads"
    with tempfile.TemporaryDirectory() as folder:
        scene, rays = pathlib.Path(folder, "scene.json"), pathlib.Path(folder, "rays")
        scene.write_text(json.dumps(statements.scene()), encoding="utf-8")
        rays.write_text("".join(ray + "\n" for ray, *_ in hits + shadows), encoding="utf-8")
        out = subprocess.run([durero, "trace", scene, rays], check=True, capture_output=True, text=True).stdout
    answers = [json.loads(line) for line in out.splitlines()]
    wrong = []
    for (ray, elements, expected), answer in zip(hits, answers):
        found = [bits(number) for number in [answer["t"], *answer["point"]]] if answer["outcome"] == "hit" else []
        if answer["elementos"] != elements or found != expected:
            wrong.append(f"{ray}: Instances.v states {elements} {expected}, durero trace prints {answer}")
    for (ray, endless, segment), answer in zip(shadows, answers[len(hits) :], strict=True):
        hit = answer["outcome"] == "hit"
        if (hit, hit and answer["t"] < 1) != (endless, segment):
            wrong.append(f"{ray}: Instances.v states {endless}, {segment}, durero trace prints {answer}")
    print(*wrong, f"{len(hits)} rays and {len(shadows)} shadow rays compared", sep="\n")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
