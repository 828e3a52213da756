"""Asks systems for real: ask.py DURERO present|all.

Their faults are theirs; what is tested is that they are asked, and asked rightly. A question in the wrong frame, unit or
format makes nearly every ray wrong, so of the generic family the share of rays that are right has a floor for each.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

FLOORS = {
    "povray": 0.9,
    "embree": 0.15,  # of its curves, those of rays whose v is no unit vector are wrong
    "embree-user": 0.95,
    "bullet": 0.6,
    "ode": 0.95,
    "glm-f64": 0.95,
    "occt": 0.9,
    "mujoco": 0.95,
    "mitsuba": 0.95,
    "trimesh": 0.95,
    "three-mesh-bvh": 0.95,
    "cgal-epick": 0.95,
}


def share_right(report):
    """Of the generic family, among the rays that are judged: a hit that is right, whatever normal it has."""
    family = next(f for f in json.loads(report.read_text())["families"] if f["family"] == "generic")
    verdicts = family["verdicts"]
    judged = sum(verdicts.values()) - verdicts["skipped"]
    right = sum(verdicts[name] for name in ("exact", "right", "wrong_normal", "wrong_uv"))
    return right / judged if judged else 0


def ask(durero, name, amount):
    """None where the system is absent; otherwise whether it was asked rightly."""
    with tempfile.TemporaryDirectory() as folder:
        call = [durero, "conform", "run", name, "--report", folder, "--no-minimise", "--jobs", "2", *amount]
        ended = subprocess.run(call, capture_output=True, text=True)
        if "absent:" in ended.stdout:
            print(ended.stdout.strip())
            return None
        if ended.returncode not in (0, 1):
            print("%s: status %d\n%s%s" % (name, ended.returncode, ended.stdout, ended.stderr))
            return False
        share = share_right(pathlib.Path(folder, name, "report.json"))
        print("%s: %.1f %% of the generic rays are right, expected %.0f %% at least" % (name, 100 * share, 100 * FLOORS[name]))
        return share >= FLOORS[name]


def set_up(durero, name):
    """False where our own program for the system does not compile; None where what it needs could not be had."""
    ended = subprocess.run([durero, "conform", "setup", name], stdout=sys.stdout, stderr=subprocess.PIPE, text=True)
    print(ended.stderr, end="")
    return False if "durero: c++ failed" in ended.stderr else None


def main():
    """Status 77, which is no pass, where a system could not be asked: none of it is set up, or what it needs is not to be had.

    A program of systems/ that does not compile, or a system that is asked wrongly, is a failure."""
    durero, which = sys.argv[1:]
    amount = ["--rays", "128"] if which == "all" else ["--family", "generic", "--rays", "128"]
    asked = {}
    for name in FLOORS:
        asked[name] = ask(durero, name, amount)
        if asked[name] is None and which == "all":
            asked[name] = set_up(durero, name) is not False and ask(durero, name, amount)
    absent = [name for name, answer in asked.items() if answer is None]
    if absent:
        print("not asked: " + ", ".join(absent))
    if False in asked.values():
        sys.exit(1)
    sys.exit(77 if len(absent) == len(asked) or (absent and which == "all") else 0)


main()
