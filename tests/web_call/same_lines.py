"""same_lines.py DURERO WEB_CALL ROOT: an answer of web_call has the lines of the command line, on the scenes and texts of the
demonstration: check, edit, why-not, trace, eval, spec check, spec run and shader, what is right and what is refused."""
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile

durero, web_call, root = (os.path.abspath(name) for name in sys.argv[1:4])
root = pathlib.Path(root)
checks = bad = 0


class Caller:
    """web_call, asked a line at a time."""

    def __init__(self):
        self.process = subprocess.Popen([web_call], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, encoding="utf-8")

    def __call__(self, name, **keys):
        self.process.stdin.write(json.dumps({"call": name, **keys}, ensure_ascii=False) + "\n")
        self.process.stdin.flush()
        self.line = self.process.stdout.readline()
        return json.loads(self.line)

    def end(self):
        self.process.stdin.close()
        if self.process.wait(60) != 0:
            fail(f"web_call ends with status {self.process.returncode}")


def fail(what):
    global bad
    bad += 1
    print("FAILED:", what)


def same(what, said, answered):
    global checks
    checks += 1
    if said != answered:
        fail(f"{what}\n  durero:   {said!r:.700}\n  web_call: {answered!r:.700}")


def run(*words, status=(0, 1), given=""):
    done = subprocess.run([durero, *words], capture_output=True, text=True, encoding="utf-8", input=given, check=False)
    if done.returncode not in status:
        fail(f"durero {' '.join(words)}: status {done.returncode}: {done.stderr}")
    return done


def write(name, text):
    pathlib.Path(name).write_text(text, encoding="utf-8")
    return text


def compact(line):
    return json.dumps(json.loads(line), ensure_ascii=False, separators=(",", ":"))


def lines_of(answers):
    return [json.dumps(each, ensure_ascii=False, separators=(",", ":")) for each in answers]


def some_rays(draw, count):
    """Rays from about the scene into it."""
    return "".join(" ".join(repr(draw.uniform(-6, 6)) for _ in range(3)) + " " + " ".join(repr(draw.uniform(-1, 1)) for _ in range(3)) + "\n"
                   for _ in range(count))


def compare_scene(scene, rays, with_text):
    more, key = ([], {}) if with_text is None else (["--with", "with"], {"with": with_text})
    if with_text is not None:
        write("with", with_text)
    write("scene", scene)
    write("rays", rays)
    same("check", run("check", "scene", *more).stdout.splitlines(), call("check", scene=scene, **key)["lines"])
    same("check --format json", compact(run("check", "scene", "--format", "json", *more).stdout),
         json.dumps(call("check", scene=scene, **key)["check"], ensure_ascii=False, separators=(",", ":")))
    said = [compact(line) for line in run("trace", "scene", "rays", *more).stdout.splitlines()]
    same("trace", said, lines_of(call("trace", scene=scene, rays=rays, **key)["hits"]))
    compare_edits(scene, more, key)


OPERATIONS = ["Agregar_Esfera e?=zz centro?=(0,4,0) radio?=0.5", "Agregar_Esfera e?=zz centro?=(0,4,0) radio?=-1",
              "Cambiar_Radio e?=zz radio?=3", "Agregar_Cono e?=k centro?=(0,0,0) proporcion?=0 vector?=(1,1,0) altura?=-2",
              '{"op":"Eliminar_Esfera","e":"nobody"}', "close e?=zz", "Eliminar_Elemento e?=zz"]


def compare_edits(scene, more, key):
    write("script", "\n".join(OPERATIONS) + "\n")
    done = run("edit", "scene", "--script", "script", "-o", "after.json", *more)
    answer = call("edit", scene=scene, operations=[json.loads(op) if op[0] == "{" else op for op in OPERATIONS], **key)
    same("edit", [compact(line) for line in done.stdout.splitlines()], lines_of(answer["answers"]))
    same("edit -o", pathlib.Path("after.json").read_text(encoding="utf-8"), answer["scenes"][-1])
    before = call("edit", scene=scene, operations=OPERATIONS[3:4], **key)["refusals"]
    same("edit --why-not", compact(run("edit", "scene", "--why-not", OPERATIONS[3], *more).stdout), lines_of(before)[0])


def compare_damaged(scene, draw):
    """Texts of a scene with a piece replaced: the same error, at the same place."""
    for _ in range(60):
        at = draw.randrange(len(scene))
        damaged = scene[:at] + draw.choice(["", "7", '"', "}", "-", "x", "null", "\n"]) + scene[at + draw.randrange(1, 4):]
        write("scene", damaged)
        done = run("trace", "scene", "/dev/null", status=(0, 2))
        answer = call("trace", scene=damaged, rays="")
        same("an error", done.stderr.removeprefix("durero: ").rstrip("\n"), answer.get("error", ""))


def compare_expressions(scene):
    write("scene", scene)
    for expression in ("# elementos", "1/3 + 0.25 * √2", "{ e : elementos | mi_radio e < 1 }", "∀ e : dom mi_radio • mi_radio e > 1/4",
                       "nadie + 1", "1 +", "# ℕ", "θ Escena", "mi_radio nadie"):
        done = run("spec", "eval", "--scene", "scene", "--explain", expression, status=(0, 1, 2))
        answer = call("eval", scene=scene, expression=expression, explain=True)
        if done.returncode == 2:
            same(expression, done.stderr.removeprefix("durero: EXPR").rstrip("\n"), answer.get("error", "").removeprefix("expression"))
        else:
            same(expression, done.stdout.splitlines(), answer["lines"])
            same(expression, run("spec", "eval", "--scene", "scene", expression).stdout.rstrip("\n"), answer["value"])
            same(expression, done.returncode == 0, answer["yes"])


def compare_texts():
    for path in [*sorted((root / "tests/zed/corpus").rglob("*.tex")), root / "demo/birthday_book.tex"]:
        text = path.read_text(encoding="utf-8", errors="surrogateescape")
        if "\\parents" in text or any("\ud800" <= c <= "\udfff" for c in text):
            continue
        write("text", text)
        done = run("spec", "check", "text")
        same(path.name, done.stdout.splitlines(), call("zed.check", text=text)["lines"])


def compare_machine():
    text = write("text", (root / "demo/birthday_book.tex").read_text(encoding="utf-8"))
    run("spec", "run", "text", "--given", "NAME=ann,bob", "--given", "DATE=1", given="AddBirthday name? = ann\nRemind today? = DATE1\nsave way\n")
    setup = {"given": {"NAME": ["ann", "bob"], "DATE": 1}}
    way = call("zed.run", text=text, setup=setup)["way"]
    way = call("zed.run", text=text, setup=setup, way=way, step={"operation": "AddBirthday", "inputs": {"name?": "ann"}})["way"]
    way = call("zed.run", text=text, setup=setup, way=way, step={"operation": "Remind", "inputs": {"today?": "DATE1"}})["way"]
    same("spec run", pathlib.Path("way").read_text(encoding="utf-8"), way)


def compare_shader(scene):
    write("scene.json", scene)
    for writes in ("color", "answer", "doubts"):
        run("shader", "scene.json", "-o", "scene.frag", "--writes", writes)
        same(f"shader --writes {writes}", pathlib.Path("scene.frag").read_text(encoding="utf-8"),
             call("render_shader", scene=scene, writes=writes)["fragment"])


call = Caller()
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    draw = random.Random(41)
    read = lambda name: (root / name).read_text(encoding="utf-8")
    for name in ("demo/still-life.json", "demo/groups.json", "demo/mirrors.json", "demo/gallery/solids.json", "demo/gallery/instances.json",
                 "demo/gallery/everything.json"):
        compare_scene(read(name), read("demo/rays.txt").replace("@", "#") + some_rays(draw, 300), None)
    for name in ("torus", "cubic", "ellipsoid", "hyperboloid"):
        compare_scene(read(f"demo/surfaces/{name}.json"), some_rays(draw, 60), read(f"demo/surfaces/{name}.tex"))
    compare_damaged(read("demo/still-life.json"), draw)
    compare_expressions(read("demo/still-life.json"))
    compare_texts()
    compare_machine()
    compare_shader(read("demo/gallery/shader.json"))
    call.end()
    os.chdir("/")
print(f"web_call: {checks} comparisons, {bad} failures")
sys.exit(bad > 0 or checks < 140)
