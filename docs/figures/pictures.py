#!/usr/bin/env python3
"""pictures.py DURERO [PICTURE...]: how long each picture of the gallery takes to draw, written into its page.

One thread draws each picture of demo/gallery/pictures.tsv by its call. The times are seconds that the processor worked (user), on the
machine and day that the page names. With names of pictures the others keep their rows. The Standard Procedural Databases are drawn
where the folder DURERO_SPD, or shared/data/spd beside the sources, has them. `./x bench --vs povray` compares with POV-Ray.
"""
import datetime
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
GALLERY = ROOT / "demo" / "gallery"
BEGIN, END = "<!-- times: docs/figures/pictures.py writes them -->\n", "<!-- end of times -->\n"


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


def measured(durero, picture, call):
    """The row of one picture; nothing where its scene is absent."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        if call[1].endswith(".nff"):
            source = pathlib.Path(os.environ.get("DURERO_SPD") or ROOT.parent / "shared" / "data" / "spd") / call[1]
            if not source.exists():
                return None
            scene = folder / "scene.json"
            subprocess.run([durero, "import", source, "-o", scene], check=True, capture_output=True)
            call = [call[0], str(scene), *call[2:]]
        threads = ["--threads", "1"] if call[0] in ("render", "fractal") else []
        return f"| {picture} | {seconds([durero, *call, *threads, '-o', folder / picture], GALLERY):.1f} |"


def main():
    durero, chosen = str(pathlib.Path(sys.argv[1]).resolve()), sys.argv[2:]
    new = {picture: measured(durero, picture, call) for picture, call in rows() if not chosen or picture in chosen}
    page = (GALLERY / "README.md").read_text(encoding="utf-8")
    before, _, rest = page.partition(BEGIN)
    old, _, after = rest.partition(END)
    known = {line.split(" | ")[0][2:]: line for line in old.splitlines() if ".png |" in line or ".svg |" in line}
    known.update({picture: row for picture, row in new.items() if row})
    day = datetime.date.today().isoformat()
    table = [f"Seconds that one thread of an {machine()} worked (user time, on a machine with other work), {day}. "
             "A picture without a row was not timed.", "",
             "| picture | seconds |", "| --- | --- |", *(known[picture] for picture, _ in rows() if picture in known)]
    (GALLERY / "README.md").write_text(before + BEGIN + "\n".join(table) + "\n" + END + after, encoding="utf-8")


if __name__ == "__main__":
    main()
