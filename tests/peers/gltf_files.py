#!/usr/bin/env python3
"""gltf_files.py DURERO: what `durero export` writes as glTF, as a text and as bytes, is what trimesh and pygltflib read.

A random scene of triangles and a mesh, in groups, with materials, a camera and lights: both find the triangles of the scene,
each coordinate the nearest binary32; pygltflib also the camera, the lights and the bounds of accessors. Exit status 77 (skipped)
where one of them is absent (pip: trimesh, pygltflib).
"""
import json
import pathlib
import random
import struct
import subprocess
import sys
import tempfile

try:
    import numpy
    import pygltflib
    import trimesh
except ImportError:
    print("no trimesh or no pygltflib here: skipped")
    sys.exit(77)

SEED, TRIANGLES, SIDE = 1, 300, 20


def nearest(x):
    return struct.unpack("<f", struct.pack("<f", x))[0]


def scene(rng):
    """A scene, and the triangles that it has, of binary32."""
    def point():
        return [rng.uniform(-9, 9) for _ in range(3)]
    singles = [[point() for _ in range(3)] for _ in range(TRIANGLES)]
    points = [[x / 7, y / 3, rng.uniform(-1, 1)] for x in range(SIDE) for y in range(SIDE)]
    faces = []
    for x in range(SIDE - 1):
        for y in range(SIDE - 1):
            a = x * SIDE + y
            faces += [[a, a + 1, a + SIDE], [a + 1, a + SIDE + 1, a + SIDE]]
    uv = [[rng.random(), rng.random()] for _ in points]
    elements = [{"id": f"t{i}", "tipo": "triangulo", "vertices": v, "material": rng.choice(["red", "glass"])} for i, v in enumerate(singles)]
    made = {"format": "durero-scene", "version": 1, "resolution": [64, 48],
            "camera": {"eye": [0, 0, 9], "look_at": [0, 0, 0], "up": [0, 1, 0], "fov_y": 40},
            "lights": [{"position": [1, 2, 3], "color": [2, 2, 1]}], "directional_lights": [{"direction": [0, -1, 0], "color": [1, 1, 1]}],
            "materials": {"red": {"color": [1, 0, 0]}, "glass": {"color": [0, 0, 0], "k_d": 0, "k_t": 1, "index": 1.5}},
            "elementos": elements, "mallas": [{"id": "sheet", "puntos": points, "caras": faces, "uv": uv}],
            "groups": {"some": {"elementos": [f"t{i}" for i in range(0, TRIANGLES, 3)]}, "all": {"groups": ["some"]}}}
    triangles = singles + [[points[k] for k in face] for face in faces]
    return made, sorted(tuple(nearest(x) for vertex in triangle for x in vertex) for triangle in triangles)


def by_trimesh(path):
    loaded = trimesh.load(path, process=False)
    found = []
    for triangle in loaded.to_geometry().triangles if hasattr(loaded, "to_geometry") else loaded.dump(concatenate=True).triangles:
        found.append(tuple(nearest(float(x)) for x in triangle.reshape(-1)))
    return sorted(found)


def accessor(file, number, blob):
    one = file.accessors[number]
    view = file.bufferViews[one.bufferView]
    kind = numpy.dtype("<f4" if one.componentType == pygltflib.FLOAT else "<u4")
    width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[one.type]
    values = numpy.frombuffer(blob, kind, one.count * width, view.byteOffset).reshape(-1, width)
    if one.min:
        assert one.min == values.min(axis=0).tolist() and one.max == values.max(axis=0).tolist(), "bounds of an accessor"
    return values


def by_pygltflib(path):
    file = pygltflib.GLTF2().load(str(path))
    blob = file.binary_blob() or file.get_data_from_buffer_uri(file.buffers[0].uri)
    assert len(file.cameras) == 1 and file.cameras[0].perspective.aspectRatio == 64 / 48
    assert len(file.extensions["KHR_lights_punctual"]["lights"]) == 2
    assert {node.name for node in file.nodes} >= {"some", "all"} and len(file.materials) == 2
    found = []
    for mesh in file.meshes:
        for primitive in mesh.primitives:
            points, corners = accessor(file, primitive.attributes.POSITION, blob), accessor(file, primitive.indices, blob)
            assert (primitive.attributes.TEXCOORD_0 is not None) == (mesh.name == "sheet")
            found += [tuple(float(x) for x in triangle.reshape(-1)) for triangle in points[corners.reshape(-1, 3)]]
    return sorted(found)


def main():
    durero = str(pathlib.Path(sys.argv[1]).resolve())
    made, meant = scene(random.Random(SEED))
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "scene.json").write_text(json.dumps(made))
        for ending in ("gltf", "glb"):
            path = folder / f"scene.{ending}"
            subprocess.run([durero, "export", str(folder / "scene.json"), "-o", str(path)], check=True, capture_output=True)
            for read in (by_trimesh, by_pygltflib):
                found = read(path)
                assert found == meant, f"{ending}, {read.__name__}: {len(found)} triangles, {len(set(found) & set(meant))} as they should be"
                print(f"{ending}, {read.__name__}: {len(found)} triangles, all as they should be")


if __name__ == "__main__":
    main()
