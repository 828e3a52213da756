"""examples.py DURERO ROOT: every JSON file of the repository and every kind that the program writes keeps to its
schema; each key of a schema has a title and a description."""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from schemas import Schemas, parsed

durero, root = os.path.abspath(sys.argv[1]), pathlib.Path(os.path.abspath(sys.argv[2]))
schemas = Schemas(root)
checked, bad = {}, 0
WRONG_SYSTEM = """import sys
print("system wrong 1", flush=True)
for line in sys.stdin:
    if line.startswith("rays"):
        print("miss\\nhit - nan\\n" * (int(line.split()[1]) // 2), end="", flush=True)
    if line.startswith("rays") and int(line.split()[1]) % 2:
        print("hit - 1e-3 0 0 1", flush=True)
"""


def fail(what):
    global bad
    bad += 1
    print("FAILED:", what)


def check(name, text, what):
    checked[name] = checked.get(name, 0) + 1
    try:
        complaint = schemas.complaint(name, parsed(text))
    except ValueError as error:
        complaint = str(error)
    if complaint:
        fail(f"{what} is no {name}: {complaint}")


def run(*arguments, status=0, given=None):
    done = subprocess.run([durero, *map(str, arguments)], capture_output=True, text=True, input=given, check=False)
    if done.returncode != status:
        fail(f"durero {' '.join(map(str, arguments))}: status {done.returncode}, expected {status}: {done.stderr}")
    return done.stdout


def check_lines(name, text, what):
    for number, line in enumerate(text.splitlines(), 1):
        check(name, line, f"{what}, line {number}")


def name_of(text):
    return json.loads(text)["format"].removeprefix("durero-")


def check_repository():
    for path in [*root.glob("demo/*.json"), *root.glob("systems/*/*.json")]:
        if '"durero-' in path.read_text():  # others are npm's
            check(name_of(path.read_text()), path.read_text(), path)
    for page in ["campaigns.md", "conformance.md"]:
        for block in re.findall(r"```json\n(.*?)```", (root / "docs" / page).read_text(), re.S):
            if '"format":"durero-' in block:
                check(name_of(block), block, page)


def check_scenes_and_hits():
    scene, rays = root / "demo/still-life.json", root / "demo/rays.txt"
    answers = run("edit", scene, "--script", root / "demo/edits.txt", "-o", "edited.json", status=1)
    check_lines("answer", answers, "an answer")
    groups = run("edit", scene, "--op", "group g=g elementos=jug", "--op", "Eliminar_Elemento e=jug")
    if '"left_group":"g"' not in groups:
        fail(f"a removal from a group says nothing of it: {groups}")
    check_lines("answer", groups, "an answer of groups")
    check("scene", pathlib.Path("edited.json").read_text(), "an edited scene")
    check_lines("difference", run("diff", scene, "edited.json", "--json", status=1), "a difference")
    pathlib.Path("wide.json").write_text(scene.read_text().replace('"fov_y":', '"aperture":0.5,"fov_y":'))
    pathlib.Path("dark.json").write_text(scene.read_text().replace('"fov_y":', '"aperture":0.25,"fov_y":'))
    check_lines("difference", run("diff", scene, "wide.json", "--json", status=1), "a difference of cameras")
    check_lines("conflict", run("merge", scene, "wide.json", "dark.json", "-o", "none.json", status=1), "a conflict")
    run("edit", scene, "--op", "Eliminar_Elemento e=jug", "-o", "bare.json")
    run("edit", scene, "--op", "group g=g elementos=jug", "-o", "grouped.json")
    check_lines("conflict", run("merge", scene, "bare.json", "grouped.json", "-o", "none.json", status=1), "a wrong merge")
    pathlib.Path("hits").write_text(run("trace", scene, rays))
    check_lines("hit", pathlib.Path("hits").read_text(), "a hit")
    near = run("distance", scene, root / "demo/points.txt") + run("distance", scene, root / "demo/points.txt", "--of", "apple")
    check_lines("distance", near, "a distance")
    check_lines("confirmation", run("spec", "confirm", scene, rays, "hits"), "a confirmation")
    check("check", run("check", scene, "--format", "json"), "a check")
    check("sarif", run("check", scene, "--format", "sarif"), "SARIF of a check")
    pathlib.Path("open.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n")
    check("mesh-check", run("check", "--mesh", "open.obj", "--format", "json", status=1), "an audit of a mesh")
    check("sarif", run("check", "--mesh", "open.obj", "--format", "sarif", status=1), "SARIF of an audit of a mesh")
    check("agreement", run("agree", scene, "--rays", 500, "--format", "json"), "an agreement")
    check("stats", run("stats", scene, "--sphere-tracing", rays, "--format", "json"), "figures")
    check("stats", run("stats", scene, "--format", "json", "--no-times", "--engine", "analytic"), "figures without times")
    check("mosaic", run("voxelise", scene, "--depth", 4), "a mosaic")
    check("mosaic", run("voxelise", scene, "--depth", 4, "--solid"), "a solid mosaic")
    sphere = '{"id":"%s","tipo":"esfera","centro":[0,0,0],"radio":%s}'
    wrong = '{"format":"durero-scene","version":1,"elementos":[%s,%s,%s,7]}' % (
        sphere % ("a", 1), sphere % ("a", 1), sphere % ("b", 0))
    for given in [wrong, "{", '{"format":"durero-scene","version":2}']:
        for form in ["json", "sarif"]:
            said = run("check", "-", "--format", form, status=2, given=given)
            check("check" if form == "json" else form, said, f"a check of {given}")


def check_conform():
    run("conform", "make", "suite", "--family", "rim,inside", "--rays", 70, "--solids")
    check("suite", pathlib.Path("suite/suite.json").read_text(), "a suite")
    for path in pathlib.Path("suite").glob("*/*.json"):
        check("scene" if ".scene." in path.name else "case", path.read_text(), path)
    for path in pathlib.Path("suite").glob("*/*.jsonl"):
        check_lines("hit", path.read_text(), path)
    run("conform", "run", "durero", "--family", "generic,inside", "--rays", 70, "--report", "found")
    # A system that is wrong in two ways, and hits that are, so that reports have findings and what would explain them.
    pathlib.Path("wrong.py").write_text(WRONG_SYSTEM)
    run("conform", "run", f"command:{sys.executable} wrong.py", "--profile", "durero", "--family", "generic", "--rays", 20,
        "--report", "found", status=1)
    hits = {"case": "rim/0000", "ray": 0, "outcome": "hit", "t": 1e-30, "point": ["nan", 0, 1]}
    pathlib.Path("mine.jsonl").write_text(json.dumps(hits) + "\n")
    check_lines("claim", pathlib.Path("mine.jsonl").read_text(), "a claim")
    profile = root / "systems/durero/durero.json"
    run("conform", "judge", "suite", "mine.jsonl", "--profile", profile, "--report", "judged", status=1)
    for path in [*pathlib.Path(".").glob("found/*/report.*"), *pathlib.Path("judged").glob("report.*")]:
        if path.suffix in (".json", ".sarif"):
            check("report" if path.suffix == ".json" else "sarif", path.read_text(), path)
    run("conform", "fuzz", f"command:{sys.executable} wrong.py", "--profile", "durero", "--family", "generic", "--steps", 200,
        "--report", "searched", status=1)
    run("conform", "fuzz", "durero", "--family", "generic", "--steps", 20, "--report", "searched")
    for path in pathlib.Path("searched").glob("*/search.json"):
        check("search", path.read_text(), path)
    campaign = {"format": "durero-campaign", "version": 1, "system": "durero", "seed": 1, "rays_of_a_shard": 128,
                "shards": 2, "families": ["inside", "rim"], "types": ["esfera"], "time": 5, "numbers": "binary64"}
    pathlib.Path("campaign.json").write_text(json.dumps(campaign))
    check("campaign", pathlib.Path("campaign.json").read_text(), "a campaign")
    run("conform", "shard", "campaign.json", 0, "--output", "shard.json")
    run("conform", "merge", "campaign.json", "shard.json", "--output", "merged.json")
    for path in ["shard.json", "merged.json"]:
        check("shards", pathlib.Path(path).read_text(), path)


def check_words(name, schema, path="", is_key=False):
    """Each property says what it is, itself or by what it refers to."""
    if is_key and isinstance(schema, dict) and not {"title", "description"} <= schema.keys():
        fail(f"{name}.schema.json: {path} has no title and description")
    if isinstance(schema, dict):
        for key, value in schema.items():
            in_conditions = re.search(r"/(if|then|else|not|oneOf|anyOf|allOf)\b", path)
            if key in ("properties", "patternProperties") and isinstance(value, dict) and not in_conditions:
                for member, part in value.items():
                    check_words(name, part, f"{path}/{member}", True)
            elif isinstance(value, (dict, list)) and key != "enum":
                check_words(name, value, f"{path}/{key}")
    elif isinstance(schema, list):
        for i, part in enumerate(schema):
            check_words(name, part, f"{path}/{i}")


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    check_repository()
    check_scenes_and_hits()
    check_conform()
for name, schema in schemas.of.items():
    check_words(name, schema)
    if schema["$id"] != f"{name}.schema.json":
        fail(f"{name}.schema.json has $id {schema['$id']}")
    if name not in checked and name != "operation":  # nothing writes that one; mutants.py has some
        fail(f"nothing was checked against {name}.schema.json")
print(f"{sum(checked.values())} files and lines against {len(schemas.of)} schemas, {bad} failures: {checked}")
sys.exit(bad > 0 or sum(checked.values()) < 100)
