"""Smallest failures of other people's systems, as `durero conform bug` writes them: docs/findings/SYSTEM/NAME.md, with a
program beside it that reproduces it. Where a line of the system is the cause, docs/findings/SYSTEM/fix.patch changes it.

findings.py DURERO write [SYSTEM/NAME]…           writes pages anew, all by default, with the calls that they name
findings.py DURERO write SYSTEM NAME CASE RAY     writes a new one
findings.py DURERO check                          asks each system that is set up again, and runs the programs; asks
                                                  a copy that the patch was applied to, whose answers must be exact
"""
import contextlib
import copy
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).parents[2]
PAGES = ROOT / "docs" / "findings"
SETUPS = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / "durero" / "systems"


class System:
    """What its file says, with its places filled in."""

    def __init__(self, name):
        file = next((ROOT / "systems").glob("*/%s.json" % name))
        self.says, self.setup = json.loads(file.read_text()), SETUPS / name
        python = self.setup / "venv" / "bin" / "python" if "pypi" in self.says["install"] else "python3"
        self.places = {"here": file.parent, "setup": self.setup, "out": self.setup / "ask", "python": python}

    def is_set_up(self):
        return (self.setup / "complete").exists()

    @contextlib.contextmanager
    def patched(self, patch):
        """The system in a copy of its folder, of which the patch changed files: linked ones stay as they are."""
        with tempfile.TemporaryDirectory(dir=SETUPS) as folder:
            other = copy.copy(self)
            other.setup = pathlib.Path(folder) / self.setup.name
            subprocess.run(["cp", "-al", self.setup, other.setup], check=True)
            subprocess.run(["patch", "--quiet", "-p1", "-d", other.setup, "-i", patch], check=True)
            moved = lambda place: str(place).replace(str(self.setup), str(other.setup))
            other.places = {key: place if key == "here" else moved(place) for key, place in self.places.items()}
            yield other

    def filled_in(self, command, **places):
        places = {**self.places, **places}
        return [re.sub(r"\{(\w+)\}", lambda m: str(places[m[1]]), word) for word in command]

    def ask(self, question):
        """The version that the system says, its answer, and the end of what else it wrote."""
        ended = subprocess.run(self.filled_in(self.says["ask"]), input=question, capture_output=True, text=True,
                               cwd=self.setup, timeout=120)
        says, answer = [*ended.stdout.splitlines(), "", ""][:2]
        errors = ended.stderr.strip().splitlines()[-1:] or ["nothing on its standard error"]
        return says.removeprefix("system "), answer, "status %d, %s" % (ended.returncode, errors[0])

    def reproduce(self, program):
        """What the program writes from what it got on, run where its packages are found: beside it."""
        with tempfile.TemporaryDirectory() as folder:
            program, said = shutil.copy(program, folder), ""
            for command in self.says["reproduce"]["run"]:
                command = self.filled_in(command, program=program, built=folder + "/built")
                ended = subprocess.run(command, capture_output=True, text=True, cwd=folder, timeout=120)
                said = ended.stdout
        return said[said.find("got: "):] if "got: " in said else said + ended.stderr


def is_same(answer, other):
    """Whether two answers are the same words and numbers, in whatever digits."""
    def read(word):
        try:
            return float(word)
        except ValueError:
            return word
    return [read(word) for word in answer.split()] == [read(word) for word in other.split()]


def numbers_of(answer):
    """The element of a hit, and its t and point, as far as the answer has them."""
    words = answer.split()
    if words[:1] != ["hit"]:
        return None, None, []
    return words[1], None if words[2] == "-" else float(words[2]), [float(word) for word in words[3:6]]


def is_exact(answer, page, measure):
    """Whether the answer is the exact one of the page, to some digits: its element, and t or else the point."""
    element, t = re.match(r"(\S+) at t = (\S+)", block(page, "exact")).groups()
    if measure == "length":
        t = float(t) * math.hypot(*map(float, block(page, "question").split()[-3:]))
    point = re.search(r"Expected .*?point \((.*?)\)", page.read_text())[1].split(", ")
    of, at, where = numbers_of(answer)
    got, expected = ([at], [t]) if at is not None else (where, point)
    near = lambda a, b: math.isclose(a, float(b), rel_tol=2 ** -20)
    return of == element and len(got) == len(expected) and all(map(near, got, expected))


def block(page, kind):
    found = re.search(r"```%s\n(.*?)```" % kind, page.read_text(), re.S)
    return found and found[1].strip()


def write(durero, system, name, case, ray):
    page = PAGES / system / (name + ".md")
    page.parent.mkdir(parents=True, exist_ok=True)
    call = [durero, "conform", "bug", system, case, "--ray", ray, "--output", str(page)]
    reproducer = System(system).says.get("reproduce")
    if reproducer:
        call += ["--reproducer", str(page.with_suffix(pathlib.Path(reproducer["program"]).with_suffix("").suffix))]
    ended = subprocess.run(call)
    if ended.returncode != 1:
        print("%s/%s: status %d, expected a failure" % (system, name, ended.returncode))


def write_again(durero, names):
    for page in sorted(PAGES.glob("*/*.md")):
        name = "%s/%s" % (page.parent.name, page.stem)
        call = re.search(r"`durero conform bug \S+ (\S+) --ray (\d+)`", page.read_text())
        if not names or name in names:
            write(durero, page.parent.name, page.stem, *call.groups())


def why_not_asked(page, version, words):
    """A system that does not start here, or is of another version, shows nothing about its page."""
    if not version:
        return "%s does not start: %s" % (page.parent.name, words)
    title = page.read_text().splitlines()[0]
    return "" if title.startswith("# %s: " % version) else "%s is now %s" % (title[2:].rsplit(": ", 1)[0], version)


def wrong_in(page, system, answer, words):
    """What is otherwise than the page says."""
    wrong = []
    if not is_same(answer, block(page, "got")):
        wrong.append("now %s (%s)" % (answer or "no answer", words))
    programs = [file for file in page.parent.glob(page.stem + ".*") if file != page]
    if len(programs) != (block(page, "reproduced") is not None):
        wrong.append("%d programs beside it" % len(programs))
    for program in programs:
        said = system.reproduce(program).strip()
        if not is_same(said, block(page, "reproduced")):
            wrong.append("%s wrote %s" % (program.name, said))
    return wrong


def wrong_with_patch(page, system):
    """What a patched system answers to the question of the page, where that is not exact."""
    patch = page.parent / "fix.patch"
    if not patch.exists():
        return []
    with system.patched(patch) as mended:
        version, answer, words = mended.ask(block(page, "question") + "\n")
    measure = system.says["profile"]["measure"]
    return [] if is_exact(answer, page, measure) else ["with %s %s (%s)" % (patch.name, answer or "no answer", words)]


def check():
    """Status 1 where a system answers otherwise than its page says, 77 where none could be asked."""
    not_asked, wrong, asked = set(), 0, 0
    for page in sorted(PAGES.glob("*/*.md")):
        system = System(page.parent.name)
        if not system.is_set_up():
            not_asked.add("%s is not set up" % page.parent.name)
            continue
        version, answer, words = system.ask(block(page, "question") + "\n")
        why = why_not_asked(page, version, words)
        if why:
            not_asked.add(why)
            continue
        asked += 1
        for what in wrong_in(page, system, answer, words) + wrong_with_patch(page, system):
            wrong += 1
            print("%s: %s" % (page.relative_to(ROOT), what))
    print("%d asked again, %d answered otherwise; %s" % (asked, wrong, "; ".join(sorted(not_asked)) or "all were asked"))
    return 1 if wrong else 0 if asked else 77


if sys.argv[2] == "check":
    sys.exit(check())
elif len(sys.argv) == 7:
    write(sys.argv[1], *sys.argv[3:])
else:
    write_again(sys.argv[1], sys.argv[3:])
