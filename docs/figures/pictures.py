#!/usr/bin/env python3
"""pictures.py DURERO [PICTURE...]: how long each picture of the gallery takes to draw, written into its page.

One thread draws each picture of demo/gallery/pictures.tsv by its call, and POV-Ray 3.7 the same scene, where `durero export` leaves
nothing out that shows. POV-Ray sends as many rays through each pixel (+AM1 +A0.0 +R). The times are seconds that the processor worked
(user), on the machine and day that the page names. With names of pictures the others keep their rows. The Standard Procedural
Databases are drawn where the folder DURERO_SPD, or shared/data/spd beside the sources, has them.
"""
import datetime
import math
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
GALLERY = ROOT / "demo" / "gallery"
BEGIN, END = "<!-- times: docs/figures/pictures.py writes them -->\n", "<!-- end of times -->\n"
# What `durero export` says that it leaves out, and what does not show.
UNSEEN = ("name", "element", "parallel")


def seconds(call, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run(call, cwd=folder, check=True, capture_output=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def rows():
    for line in (GALLERY / "pictures.tsv").read_text(encoding="utf-8").splitlines():
        if not line.startswith("#"):
            picture, _, call = line.split("\t")
            yield picture, call.split(" ")


def machine():
    for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return line.partition(":")[2].strip()
    return "unknown"


def option(call, name, default):
    return call[call.index(name) + 1] if name in call else default


def by_povray(durero, call, scene, folder):
    """Nothing where the picture is not one of Whitted's rays, or some of the scene is lost."""
    if call[0] != "render" or any(word in call for word in ("--rays", "--integrator", "--min-weight")) or not shutil.which("povray"):
        return None
    text = scene.parent / f"{scene.stem}.times.pov"  # beside the pictures that it names
    try:
        said = subprocess.run([durero, "export", scene, "-o", text], check=True, capture_output=True, text=True)
        if any(not any(word in line for word in UNSEEN) for line in said.stderr.splitlines()):
            return None
        first = text.read_text(encoding="utf-8").splitlines()[0]
        width, height = option(call, "--size", "x".join(re.search(r"\+W(\d+) \+H(\d+)", first).groups())).split("x")
        side = math.isqrt(int(option(call, "--samples", "1")))
        rays = ["+AM1", "+A0.0", f"+R{side}", "-J"] if side > 1 else ["-A"]
        return seconds(["povray", f"+I{text.name}", f"+O{folder / 'there.png'}", f"+W{width}", f"+H{height}", "+WT1", "-D", *rays],
                       text.parent)
    finally:
        text.unlink(missing_ok=True)


def measured(durero, picture, call):
    """The row of one picture; nothing where its scene is absent."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        scene = GALLERY / call[1]
        if call[1].endswith(".nff"):
            source = pathlib.Path(os.environ.get("DURERO_SPD") or ROOT.parent / "shared" / "data" / "spd") / call[1]
            if not source.exists():
                return None
            scene = folder / "scene.json"
            subprocess.run([durero, "import", source, "-o", scene], check=True, capture_output=True)
            call = [call[0], str(scene), *call[2:]]
        threads = ["--threads", "1"] if call[0] in ("render", "fractal") else []
        ours = seconds([durero, *call, *threads, "-o", folder / picture], GALLERY)
        theirs = by_povray(durero, call, scene, folder)
    return f"| {picture} | {ours:.1f} | {'' if theirs is None else f'{theirs:.1f}'} |"


def main():
    durero, chosen = str(pathlib.Path(sys.argv[1]).resolve()), sys.argv[2:]
    page = (GALLERY / "README.md").read_text(encoding="utf-8")
    before, _, rest = page.partition(BEGIN)
    old, _, after = rest.partition(END)
    known = {line.split(" | ")[0][2:]: line for line in old.splitlines() if line.startswith("| ") and ".png" in line or ".svg" in line}
    for picture, call in rows():
        if not chosen or picture in chosen:
            row = measured(durero, picture, call)
            if row:
                known[picture] = row
                print(row, flush=True)
    day = datetime.date.today().isoformat()
    table = [f"Seconds of one thread of an {machine()} ({os.cpu_count()} processors), {day}, by the processor's time. POV-Ray draws what "
             "`durero export` writes, with as many rays a pixel; it has no time where the export leaves out what shows.", "",
             "| picture | Durero | POV-Ray |", "| --- | --- | --- |", *(known[picture] for picture, _ in rows() if picture in known)]
    (GALLERY / "README.md").write_text(before + BEGIN + "\n".join(table) + "\n" + END + after, encoding="utf-8")


if __name__ == "__main__":
    main()
