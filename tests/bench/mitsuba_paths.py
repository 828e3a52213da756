#!/usr/bin/env python3
"""mitsuba_paths.py DURERO SCENE [VARIANT]: path tracing beside Mitsuba 3's, whose package is to be installed.

The scene has triangles of diffuse materials, such as demo/gallery/cornell.json, and is drawn small. First both draw it with
many samples: the two pictures must agree. Then each draws it with some samples, and the call prints how long that took on
one processor, and the RMS error beside the mean of the two long runs.
"""
import json
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

import mitsuba
import numpy

SIDE, LONG = 48, 4096


def material(look):
    """A material, seen from both sides."""
    diffuse = {"type": "diffuse", "reflectance": {"type": "rgb", "value": look["color"]}}
    return {"type": "twosided", "bsdf": diffuse}


def triangle(element, look):
    """One triangle; an emitter shines from the side that its vertices turn to the left on, ours from both."""
    mesh = mitsuba.Mesh(element["id"], 3, 1, props=properties(look))
    parameters = mitsuba.traverse(mesh)
    parameters["vertex_positions"] = [x for vertex in element["vertices"] for x in vertex]
    parameters["faces"] = [0, 1, 2]
    parameters.update()
    return mesh


def properties(look):
    props = mitsuba.Properties()
    props["bsdf"] = mitsuba.load_dict(material(look))
    if "emission" in look:
        props["emitter"] = mitsuba.load_dict({"type": "area", "radiance": {"type": "rgb", "value": look["emission"]}})
    return props


def mitsuba_scene(scene):
    camera = scene["camera"]
    to_world = mitsuba.ScalarTransform4f().look_at(origin=camera["eye"], target=camera["look_at"], up=camera["up"])
    described = {
        "type": "scene",
        "integrator": {"type": "path", "max_depth": -1},
        "sensor": {"type": "perspective", "fov": camera["fov_y"], "fov_axis": "y", "to_world": to_world,
                   "film": {"type": "hdrfilm", "width": SIDE, "height": SIDE, "rfilter": {"type": "box"},
                            "pixel_format": "rgb", "component_format": "float32"},
                   "sampler": {"type": "multijitter"}},
    }
    for element in scene["elementos"]:
        described[element["id"].replace(".", "_")] = triangle(element, scene["materials"][element["material"]])
    return mitsuba.load_dict(described)


def by_mitsuba(scene, samples, seed=0):
    """The picture, and the seconds of a processor."""
    begin = time.process_time()
    picture = numpy.array(mitsuba.render(scene, spp=samples, seed=seed))
    return picture, time.process_time() - begin


def by_durero(durero, file, samples, seed=0):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out.exr"
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        subprocess.run([durero, "render", file, "-o", out, "--size", f"{SIDE}x{SIDE}", "--integrator", "path", "--samples",
                        str(samples), "--seed", str(seed), "--quiet", "--threads", "1"], check=True)
        seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        return numpy.array(mitsuba.Bitmap(str(out)))[:, :, :3], seconds


def rms(difference):
    return float(numpy.sqrt((difference.astype(numpy.float64) ** 2).mean()))


def main():
    durero, file = sys.argv[1:3]
    mitsuba.set_variant(sys.argv[3] if len(sys.argv) > 3 else "scalar_rgb")
    scene = mitsuba_scene(json.loads(pathlib.Path(file).read_text(encoding="utf-8")))
    by_mitsuba(scene, 1)  # what a first call prepares is not measured
    ours, _ = by_durero(durero, file, LONG, seed=1)
    theirs, _ = by_mitsuba(scene, LONG, seed=1)
    truth = (ours + theirs) / 2
    print(f"{LONG} samples: mean {ours.mean():.5f} and {theirs.mean():.5f}, RMS difference {rms(ours - theirs):.5f}")
    for name, draw in [("Durero", lambda n: by_durero(durero, file, n)), ("Mitsuba", lambda n: by_mitsuba(scene, n))]:
        for samples in (64, 128, 256, 512):
            picture, seconds = draw(samples)
            print(f"{name}: {samples} samples, {seconds:.2f} s of a processor, RMS error {rms(picture - truth):.5f}")


if __name__ == "__main__":
    main()
