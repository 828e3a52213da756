"""Asks Radiance by oconv and rtrace, as they lie in the pyradiance wheel."""

import os
import struct
import subprocess
import sys
import tempfile

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
import pyradiance

PACKAGE = os.path.dirname(pyradiance.__file__)


def run(program, *arguments, given=b""):
    command = [os.path.join(PACKAGE, "bin", program), *arguments]
    environment = {**os.environ, "RAYPATH": os.path.join(PACKAGE, "lib")}
    done = subprocess.run(command, input=given, capture_output=True, env=environment)
    if done.returncode:
        raise RuntimeError(done.stderr.decode())
    return done.stdout


def primitive(element):
    def shown(word, *numbers):
        return f"void {word} {element.name} 0 0 {len(numbers)} {' '.join(map(repr, numbers))}\n"

    if element.tipo == "esfera":
        return shown("sphere", *element.centro, element.radio)
    if element.tipo == "triangulo":
        return shown("polygon", *(x for vertex in element.vertices for x in vertex))
    if element.tipo == "disco":
        return shown("ring", *element.centro, *element.vector, 0.0, element.radio)
    ends = (*element.centro, *element.along(element.altura))
    if element.tipo == "cilindro":
        return shown("cylinder", *ends, element.radio)
    return shown("cone", *ends, *element.radii())


def load(elements):
    scene = "".join(map(primitive, elements))

    def ask(rays):
        with tempfile.TemporaryDirectory() as folder:
            description, octree = os.path.join(folder, "scene.rad"), os.path.join(folder, "octree")
            with open(description, "w") as file:
                file.write(scene)
            with open(octree, "wb") as file:
                file.write(run("oconv", "-w", description))
            given = b"".join(struct.pack("6d", *p, *v) for p, v in rays)
            answers = run("rtrace", "-h", "-w", "-ab", "0", "-lr", "0", "-fdd", "-oLs", octree, given=given)
        claims = []
        while answers:
            (length,) = struct.unpack("d", answers[:8])
            name, _, answers = answers[8:].partition(b"\t")
            claims.append(None if name == b"*" else (name.decode(), length))
        return claims

    return ask


protocol.serve("Radiance", run("rtrace", "-version").split()[1].decode(), load)
