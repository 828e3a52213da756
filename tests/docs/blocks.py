"""blocks.py DURERO ROOT [long]: every block of code of every page is run by a test, or says why none can run it.

docs/formats.py and the others run most. tests/docs/blocks.tsv has a row for each of the rest: the page, how the block begins, how it is
held, and by what. The first row that fits a block counts.

  by       the test that runs it, which names its page
  run      this test runs its lines one by one; behind it the statuses with which they may end
  prints   this test runs the call; the block is what it prints. Before the call stands its status
  element  this test checks a scene of which the block is an element
  schema   the block has the form of that schema
  in       the block stands in that file, but for blanks
  serve    this test serves a store, and sends the block's requests to it
  not      no test can run it, for this reason

Pictures are drawn small, but for `long`, which runs each line as it stands. Each of these rules then sees a fault that is planted in a copy
of the pages in memory."""
import collections
import fnmatch
import json
import os
import pathlib
import re
import shlex
import shutil
import stat
import subprocess
import sys
import tempfile
import urllib.error
import urllib.request

durero, root, is_long = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve(), "long" in sys.argv[3:]
BLOCK = re.compile(r"^( *)```(\w*)\n(.*?)^ *```$", re.S | re.M)
Block = collections.namedtuple("Block", "page line language text marked")
Row = collections.namedtuple("Row", "page begins how what")
SMALL = "96x54"
FOLDERS = ["", "docs/**/", "spec/**/", "proofs/**/", "demo/**/", "systems/**/", "campaigns/**/", "tests/**/"]


def read_pages():
    files = [path for pattern in FOLDERS for path in sorted(root.glob(f"{pattern}*.md"))]
    return {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8") for path in files}


def blocks(pages):
    for page, text in pages.items():
        for match in BLOCK.finditer(text):
            before = text[: match.start()].rstrip("\n").rpartition("\n")[2]
            marked = re.match(r"<!-- (file|run|prints|refused|errors|defects|words|call|answers)\b", before) is not None
            yield Block(page, text[: match.start()].count("\n") + 1, match[2], match[3], marked)


def read_rows():
    for line in (root / "tests/docs/blocks.tsv").read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            yield Row(*line.split("\t"))


def fits(row, block):
    begins = block.text.lstrip().startswith(row.begins) or row.begins in ("*", f"```{block.language}")
    return fnmatch.fnmatchcase(block.page, row.page) and (begins or row.begins == "<!--" and block.marked)


def held(found, rows):
    """Of each block the row that holds it; the blocks without one, and the rows without one."""
    rows_of, lost = {}, []
    for block in found:
        row = next((row for row in rows if fits(row, block)), None)
        if row:
            rows_of.setdefault(row, []).append(block)
        else:
            lost.append(f"{block.page}:{block.line}: a block that no test runs: {block.text.strip().splitlines()[0] if block.text.strip() else ''}")
    lost += [f"tests/docs/blocks.tsv: no block of {row.page} begins with {row.begins}" for row in rows if row not in rows_of]
    return rows_of, lost


# ---- by, not, in, schema

def is_run(path):
    """A test is named by the list of its folder, alone or by a pattern; so is what such a script calls."""
    folder = (root / path).parent
    words = set(re.findall(r"[\w./*-]+", "".join(file.read_text(encoding="utf-8") for file in [*folder.glob("CMakeLists.txt"), *folder.glob("*.sh")])))
    name, stem = pathlib.Path(path).name, pathlib.Path(path).stem
    return any(fnmatch.fnmatchcase(name, word.rpartition("/")[2]) or word.rpartition("/")[2] == stem for word in words if word.strip("*./"))


def check_by(row, block):
    file = root / row.what
    if not file.is_file() or not is_run(row.what):
        return f"no test {row.what} is run"
    text = file.read_text(encoding="utf-8")
    names = [part for part in pathlib.PurePath(block.page).parts[-3:] if part != "docs"]
    return None if any(name in text for name in names) else f"{row.what} does not name the page"


def check_not(row, block):
    return None if len(row.what.split()) > 3 else "no reason why no test runs it"


def check_in(row, block):
    def squeezed(text):
        return re.sub(r"\s+", "", text)
    return None if squeezed(block.text) in squeezed((root / row.what).read_text(encoding="utf-8")) else f"it does not stand in {row.what}"


def check_schema(row, block):
    import jsonschema
    schema = json.loads((root / "schemas" / f"{row.what}.schema.json").read_text(encoding="utf-8"))
    errors = [error.message for error in jsonschema.Draft202012Validator(schema).iter_errors(json.loads(block.text))]
    return errors[0] if errors else None


# ---- what is run

def call(words, **more):
    return subprocess.run([durero, *words], capture_output=True, text=True, check=False, timeout=3600, **more)


def small(words):
    """A call whose picture is small."""
    if is_long or words[0] not in ("render", "fractal") or "--size" in words:
        return words
    return [*words, "--size", SMALL]


def rays_of_readers():
    """Rays of the reader's, which start on nothing."""
    lines = (root / "demo/rays.txt").read_text().splitlines(keepends=True)
    pathlib.Path("rays.txt").write_text("".join(line for line in lines if "@" not in line))


def tracer():
    """A tracer of one's own: that of the examples, which knows spheres alone and says that it knows cylinders, too."""
    pathlib.Path("my-tracer").write_text(f"#!/bin/sh\nexec python3 {root}/systems/examples/sphere.py\n")
    pathlib.Path("my-tracer").chmod(stat.S_IRWXU)
    says = json.loads((root / "systems/examples/sphere.json").read_text())
    says["profile"]["tipos"] = ["esfera", "cilindro"]
    pathlib.Path("my-profile.json").write_text(json.dumps(says))


def hits_of_suite():
    """The suite's own answers, as somebody would hand them in."""
    lines = []
    for file in sorted(pathlib.Path("suite").glob("*/*.hits.jsonl")):
        case = f"{file.parent.name}/{file.name.partition('.')[0]}"
        for hit in map(json.loads, file.read_text().splitlines()):
            element = {"element": hit["elementos"][0]} if hit["outcome"] == "hit" else {}
            hit.pop("elementos")
            if hit["outcome"] != "no_minimum":
                lines.append(json.dumps({"case": case, **hit, **element}))
    pathlib.Path("hits.jsonl").write_text("\n".join(lines) + "\n")


def hits_of_scene():
    shutil.copyfile(root / "demo/still-life.json", "scene.json")
    rays_of_readers()
    done = call(["trace", "scene.json", "rays.txt"])
    lines = [line for line in done.stdout.splitlines(keepends=True) if "no_minimum" not in line]
    text = re.sub(r'"elementos":\["([^"]*)"[^\]]*\]', r'"element":"\1"', "".join(lines)).replace(',"elementos":[]', "")
    pathlib.Path("hits.jsonl").write_text(text)


def nested_balls():
    scene = {"format": "durero-scene", "version": 1, "elementos": [
        {"id": "outer", "tipo": "esfera", "centro": [0, 0, 0], "radio": 2}, {"id": "inner", "tipo": "esfera", "centro": [0, 1, 0], "radio": 2}]}
    pathlib.Path("scene.json").write_text(json.dumps(scene))
    rays_of_readers()


# What a line of a page needs that the reader has, by its beginning.
NEEDS = {"docs/conformance.md durero conform run": tracer, "docs/conformance.md durero conform judge suite": hits_of_suite,
         "docs/conformance.md durero conform judge --scene": hits_of_scene, "docs/solids.md ./x render": nested_balls}


def run_line(page, line, statuses):
    for begins, prepare in NEEDS.items():
        if f"{page} {line}".startswith(begins):
            prepare()
    words = shlex.split(line, comments=True)
    if words[0] not in ("durero", "./x"):
        return f"{line}: no call of durero"
    done = call(small(words[1:]))
    if str(done.returncode) not in statuses:
        return f"{line}: status {done.returncode}, expected {' or '.join(statuses)}: {done.stderr}{done.stdout[-300:]}"
    return None


def check_run(row, block):
    lines = [line.strip() for line in block.text.replace("\\\n", "").splitlines() if line.strip() and not line.strip().startswith("#")]
    return next(filter(None, (run_line(block.page, line, row.what.split()) for line in lines)), None)


def check_prints(row, block):
    status, command = row.what.split(" ", 1)
    done = call(shlex.split(command))
    said = done.stdout + done.stderr
    return None if str(done.returncode) == status and said.strip() == block.text.strip() else f"{command}: status {done.returncode}: {said}"


def check_element(row, block):
    scene = {"format": "durero-scene", "version": 1, "materials": {"glass": {"color": [1, 1, 1]}}, "elementos": [json.loads(block.text)]}
    pathlib.Path("element.json").write_text(json.dumps(scene))
    done = call(["check", "element.json"])
    return None if done.returncode == 0 else done.stderr + done.stdout


def ask(address, request):
    """The status of a request as the page has it: a method, a path and a body."""
    method, path, body = re.match(r"(\w+) (\S+)\s+(\{.*\})$", request).groups()
    made = urllib.request.Request(address + path, body.encode(), {"Content-Type": "application/json"}, method=method)
    try:
        with urllib.request.urlopen(made, timeout=60) as answer:
            return answer.status, json.load(answer)
    except urllib.error.HTTPError as refused:
        return refused.code, refused.read().decode()


def check_serve(row, block):
    """The store is served as the page's first block has it, at any port; the requests of the second get what they ask for."""
    if block.text.startswith("$"):
        lines = [line[2:] for line in block.text.splitlines() if line.startswith("$ ")]
        return None if [shlex.split(line)[:3] for line in lines] == [["durero", "store", "init"], ["durero", "serve", "room.store"]] and \
            call(shlex.split(lines[0])[1:]).returncode == 0 else "it makes and serves no store"
    with subprocess.Popen([durero, "serve", "room.store", "--port", "0"], stdout=subprocess.PIPE, text=True) as server:
        try:
            address = server.stdout.readline().strip()
            answers = [ask(address, request) for request in block.text.splitlines()]
        finally:
            server.terminate()
    if [status for status, _ in answers] != [200, 200]:
        return f"it answers {answers}"
    right = all(answer["ok"] for answer in answers[0][1]["answers"]) and len(answers[1][1]["hits"]) == 2
    return None if right else f"it answers {answers}"


CHECKS = {"by": check_by, "not": check_not, "in": check_in, "schema": check_schema, "run": check_run, "prints": check_prints,
          "element": check_element, "serve": check_serve}


def folder_of_reader(parent):
    """A folder in which a page is followed, with what a clone has there."""
    folder = tempfile.mkdtemp(dir=parent)
    for name in ("demo", "spec", "systems"):
        os.symlink(root / name, f"{folder}/{name}")
    return folder


def faults(pages, rows):
    rows_of, wrong = held(list(blocks(pages)), rows)
    order = {page: place for place, page in enumerate(pages)}
    todo = sorted(((block, row) for row, mine in rows_of.items() for block in mine), key=lambda pair: (order[pair[0].page], pair[0].line))
    home = os.getcwd()
    folders = {}
    for block, row in todo:
        if block.page not in folders:
            folders[block.page] = folder_of_reader(home)
        os.chdir(folders[block.page])
        fault = CHECKS[row.how](row, block)
        wrong += [f"{block.page}:{block.line}: {fault}"] if fault else []
    os.chdir(home)
    return wrong


def unseen(pages, rows):
    """The planted faults of which no rule says the words beside them."""
    def of(*names):
        """Some pages, and their rows alone."""
        return {name: pages[name] for name in names}, [row for row in rows if row.page in names]

    def with_text(name, old, new):
        assert old in pages[name], f"{name} has no {old}"
        some, table = of(name)
        return {**some, name: pages[name].replace(old, new, 1)}, table

    def with_row(name, how, **changed):
        some, table = of(name)
        return some, [row._replace(**changed) if row.how == how else row for row in table]
    serve, streams = "docs/serve.md", "docs/streams.md"
    planted = {
        "a new block": (*with_text(streams, "## Figures", "```sh\ndurero lost\n```\n\n## Figures"), "a block that no test runs: durero lost"),
        "a row of no block": (of(streams)[0], [*of(streams)[1], Row(streams, "lost", "not", "")], "no block of docs/streams.md begins with lost"),
        "a test that is not there": (*with_row(streams, "by", what="tests/cli/lost.py"), "no test tests/cli/lost.py is run"),
        "a test that nobody runs": (*with_row(streams, "by", what="tests/support/png.py"), "no test tests/support/png.py is run"),
        "a test of another page": (*with_row(streams, "by", what="tests/docs/wire_order.py"), "does not name the page"),
        "no reason": (*with_row("docs/proofs.md", "not", what="never"), "no reason why"),
        "text that is not there": (*with_text("docs/adding-a-system.md", '"variant"', '"lost"'), "it does not stand in"),
        "another form": (*with_text("docs/campaigns.md", '"digest":"00112233445566ff"', '"lost":1'), "'digest' is a required property"),
        "a command that is none": (*with_text("docs/solids.md", "./x trace", "./x tarce"), "./x tarce demo/gallery/solids.json rays.txt: status 2"),
        "another output": (*with_text("docs/raster.md", "51 polygons", "52 polygons"), "-o blocks.png: status 0: shadows: 51"),
        "an element that is none": (*with_text("docs/solids.md", '"radio":3}', '"radio":-3}'), "radio (radius) is -3"),
        "a request that is none": (*with_text(serve, "e?=apple radio?=2", "e?=lost radio?=2"), "elemento_no_existe"),
    }
    said = {what: faults(some, table) for what, (some, table, _) in planted.items()}
    return [f"{what}: {said[what]}" for what, (*_, words) in planted.items() if not any(words in fault for fault in said[what])]


def main():
    pages, rows = read_pages(), list(read_rows())
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        wrong = faults(pages, rows) or [f"not seen: {what}" for what in unseen(pages, rows)]
        os.chdir(root)
    found = list(blocks(pages))
    count = collections.Counter(next(row for row in rows if fits(row, block)).how for block in found) if not wrong else {}
    print("\n".join(wrong) or f"{len(found)} blocks: " + ", ".join(f"{number} {how}" for how, number in count.items()) + "; every planted fault is seen")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
