#!/usr/bin/env python3
"""gallery.py DURERO ROOT [long]: demo/gallery holds what its calls draw, and each picture shows what its page says.

Every picture that pictures.tsv names is drawn anew by its call, and has the bytes of the picture that lies there; of a rendered
one that is named long only the pixels in its middle, unless the third argument says long. A scene that a script beside it
writes has the text that the script writes. pixels.txt names pixels, x to the right and y down from 0, with the
comparison that shows an effect: `PICTURE X Y lighter X Y`, so much as red, green and blue add up to, `PICTURE X Y redder X Y`
(bluer, greener), by the share of that colour, or `PICTURE X Y same X Y`, to 12 of 255. The Standard Procedural Databases,
where they lie, are held to pixels-spd.txt; where one is absent it is said. An SVG has no pixels.
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
    folder = folder_of_databases(root)
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


def rows_of(table):
    """The rows of pictures.tsv: a picture, whether it is long, and the words of its call. A row of a database is long."""
    for line in table.read_text(encoding="utf-8").splitlines():
        if not line.startswith("#"):
            picture, when, call = line.split("\t")
            yield picture, {"long": True, "short": False, "spd": True}[when], call.split(" ")


def folder_of_databases(root):
    return pathlib.Path(os.environ.get("DURERO_SPD") or root / ".." / "shared" / "data" / "spd")


def imported(durero, root, call, folder):
    """The call with a scene in place of the database that it names; nothing where that is absent."""
    if not call[1].endswith(".nff"):
        return call
    source, scene = folder_of_databases(root) / call[1], folder / call[1].replace(".nff", ".json")  # a picture names it
    if not source.exists():
        return None
    subprocess.run([durero, "import", source, "-o", scene], check=True, capture_output=True)
    return [call[0], str(scene), *call[2:]]


def has_other_middle(durero, gallery, picture, call):
    """Whether the call draws other pixels in the middle of the picture than lie there."""
    width, height, pixels = png_pixels((gallery / picture).read_bytes())
    across, down = 48, 32
    x, y = (width - across) // 2, (height - down) // 2
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / picture
        crop = ["--crop", f"{x},{y},{across},{down}"]
        subprocess.run([durero, *call, *crop, "-o", out], check=True, cwd=gallery, stdout=subprocess.DEVNULL)
        rows = (pixels[3 * ((y + i) * width + x) :][: 3 * across] for i in range(down))
        return png_pixels(out.read_bytes())[2] != b"".join(rows)


def unwritten(gallery):
    """The scenes that are not what the script beside them writes."""
    for script in sorted(p for p in gallery.glob("*.py") if p.name != "scene_text.py"):
        text = subprocess.run([sys.executable, script], check=True, capture_output=True).stdout
        if text != script.with_suffix(".json").read_bytes():
            yield f"{script.stem}.json is stale; python3 demo/gallery/{script.name} writes it"


def is_stale(durero, gallery, picture, call):
    """Whether the call draws another picture than the one that lies there."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / picture
        subprocess.run([durero, *call, "-o", out], check=True, cwd=gallery, stdout=subprocess.DEVNULL)
        return out.read_bytes() != (gallery / picture).read_bytes()


def main():
    durero, gallery = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve() / "demo" / "gallery"
    page = (gallery / "README.md").read_text(encoding="utf-8")
    wrong, drawn, pictures, rows = [], 0, {}, list(rows_of(gallery / "pictures.tsv"))
    for picture, is_long, named_call in rows:
        with tempfile.TemporaryDirectory() as folder:
            call = imported(durero, pathlib.Path(sys.argv[2]).resolve(), named_call, pathlib.Path(folder))
            if call is None:
                print(f"skipped: absent: {named_call[1]}")
                stale = False
            elif not is_long or "long" in sys.argv[3:]:
                drawn += 1
                stale = is_stale(durero, gallery, picture, call)
            else:
                stale = call[0] == "render" and picture.endswith(".png") and has_other_middle(durero, gallery, picture, call)
        if stale:
            wrong.append(f"{picture} is stale; ./x gallery draws it")
        if f"({picture})" not in page:
            wrong.append(f"README.md does not show {picture}")
        if picture.endswith(".png"):
            pictures[picture.removesuffix(".png")] = png_pixels((gallery / picture).read_bytes())
    named = {picture for picture, _, _ in rows}
    wrong += [f"{p.name} has no row in pictures.tsv" for p in sorted(gallery.glob("*.png")) if p.name not in named]
    wrong += unwritten(gallery)
    wrong += unlike(gallery / "pixels.txt", {name: pixels for name, pixels in pictures.items() if not name.startswith("spd-")})
    databases = drawn_databases(durero, pathlib.Path(sys.argv[2]))
    wrong += unlike(gallery / "pixels-spd.txt", databases) if databases else []
    print("\n".join(wrong) or f"{drawn} of {len(pictures)} pictures, as they lie there, and {len(databases)} databases")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
