#!/usr/bin/env python3
"""gallery.py DURERO ROOT: demo/gallery holds what its scenes draw, and each picture shows what its page says.

Every scene is drawn anew, and has the bytes of the picture beside it. pixels.txt names pixels, x to the right and y down from
0, with the comparison that shows an effect: `SCENE X Y lighter X Y`, so much as red, green and blue add up to,
`SCENE X Y redder X Y` (bluer, greener), by the share of that colour, or `SCENE X Y same X Y`, to 12 of 255. The Standard
Procedural Databases, where they lie, are held to pixels-spd.txt; where one is absent it is said.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from png import png_pixels  # noqa: E402


def share(pixel, channel):
    return (pixel[channel] + 1) / (sum(pixel) + 3)


HOLDS = {
    "lighter": lambda a, b: sum(a) > sum(b) + 30,
    "redder": lambda a, b: share(a, 0) > share(b, 0) + 0.04,
    "greener": lambda a, b: share(a, 1) > share(b, 1) + 0.04,
    "bluer": lambda a, b: share(a, 2) > share(b, 2) + 0.04,
    "same": lambda a, b: max(abs(x - y) for x, y in zip(a, b)) <= 12,
}


DATABASES = ["balls", "jacks", "lattice", "rings", "tree"]


def drawn_databases(durero, root):
    """All of them, at 256 by 256, or none where one is absent."""
    folder = pathlib.Path(os.environ.get("DURERO_SPD") or root / ".." / "shared" / "data" / "spd")
    absent = [name for name in DATABASES if not (folder / f"{name}.nff").exists()]
    if absent:
        print(f"skipped: absent: {', '.join(absent)} of {folder}")
        return {}
    pictures = {}
    with tempfile.TemporaryDirectory() as name:
        scene, out = pathlib.Path(name) / "scene.json", pathlib.Path(name) / "out.png"
        for database in DATABASES:
            subprocess.run([durero, "import", folder / f"{database}.nff", "-o", scene], check=True, capture_output=True)
            subprocess.run([durero, "render", scene, "-o", out, "--size", "256x256"], check=True)
            pictures[database] = png_pixels(out.read_bytes())
    return pictures


def unlike(page, pictures):
    """The lines of a page that its pictures do not show, and the pictures that no line is of."""
    wrong, seen = [], set()
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        words = line.partition("#")[0].split()
        if not words:
            continue
        name, x, y, how, u, v = words
        width, _, pixels = pictures[name]
        a, b = (pixels[3 * (int(j) * width + int(i)) :][:3] for i, j in ((x, y), (u, v)))
        seen.add(name)
        if not HOLDS[how](a, b):
            wrong.append(f"{page.name}:{number}: {line}: {tuple(a)} is not so beside {tuple(b)}")
    return wrong + [f"{page.name} says nothing of {name}" for name in pictures if name not in seen]


def main():
    durero, gallery = sys.argv[1], pathlib.Path(sys.argv[2]) / "demo" / "gallery"
    page = (gallery / "README.md").read_text(encoding="utf-8")
    wrong, pictures = [], {}
    with tempfile.TemporaryDirectory() as folder:
        for scene in sorted(gallery.glob("*.json")):
            out = pathlib.Path(folder) / f"{scene.stem}.png"
            subprocess.run([durero, "render", scene, "-o", out], check=True)
            if out.read_bytes() != scene.with_suffix(".png").read_bytes():
                wrong.append(f"{scene.stem}.png is stale; ./x gallery draws it")
            if f"({scene.stem}.png)" not in page:
                wrong.append(f"README.md does not show {scene.stem}.png")
            pictures[scene.stem] = png_pixels(out.read_bytes())
    wrong += unlike(gallery / "pixels.txt", pictures)
    databases = drawn_databases(durero, pathlib.Path(sys.argv[2]))
    wrong += unlike(gallery / "pixels-spd.txt", databases) if databases else []
    print("\n".join(wrong) or f"{len(pictures)} pictures, as they lie there, and {len(databases)} databases")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
