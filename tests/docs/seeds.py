"""seeds.py DURERO ROOT: docs/seeds.md shows each row of the three source texts, and the tree has what it names.
seeds.py --write ROOT: writes docs/seeds.md from docs/seeds.tsv.

A line of docs/seeds.tsv is a row: its name, its place in the source text, what that says, the call of the program that shows
it, the tests, parted by " | ", the section of a page, and what is otherwise here. A test is a file, behind ": " the name of a
test case in it. `open` in the place of the call is a row that nothing shows.

- The rows are A1 to A63, R1 to R49 and Z1 to Z10, in this order, each once.
- A row has a call, a test and a section, or is open and names none. Where no call shows it, "-", the row says so.
- Each call is one that the program takes: its command, its options and their words, and the files that it reads.
- Each test is in the tree and is run: the file, and the test case in it.
- Each section is there.
- docs/seeds.md is what the lines make of it.

Each of these rules then sees a fault that is planted in a copy of the lines in memory."""
import fnmatch
import functools
import pathlib
import re
import shlex
import subprocess
import sys

TABLE, PAGE = "docs/seeds.tsv", "docs/seeds.md"
COLUMNS = ["row", "place", "says", "call", "tests", "section", "but"]
TEXTS = {"A": (63, "Ramos, *Técnicas de aceleración de ray tracing* (Tema VI)", "A §1.2 is a section."),
         "R": (49, "Ureña, *Realismo y ray-tracing* (2025)", "R 37 is a slide."),
         "Z": (10, "Rivera-Alvarado, Sánchez-Herrera and Trejos-Zelaya, the specification in Z (2020)",
               "Z §II-C is a section. [The specification](../spec/README.md) has a row of each schema and function; "
               "these are of its prose.")}
ROWS = [f"{text}{number}" for text, (count, _, _) in TEXTS.items() for number in range(1, count + 1)]
# Options behind which a call names what it writes.
WRITTEN = {"-o", "--output", "--tree"}
# Options behind which a call has one of a few words.
CHOSEN = {"--engine", "--hierarchy", "--rays", "--sampling", "--tone", "--as", "--format", "--bias", "--order"}

durero, root = sys.argv[1], pathlib.Path(sys.argv[2])


def read_rows(text):
    for line in text.splitlines()[1:]:
        cells = line.split("\t")
        yield dict(zip(COLUMNS, cells + [""] * (len(COLUMNS) - len(cells))))


def tests_of(row):
    """Of each test its file and the name of its case, which may be empty."""
    return [test.partition(": ")[::2] for test in row["tests"].split(" | ") if test]


def is_open(row):
    return row["call"] == "open"


def counted(rows):
    """What is shown and what is not, in words."""
    shown = [row for row in rows if not is_open(row)]
    different = sum(bool(row["but"]) for row in shown)
    return (f"{len(shown)} of {len(rows)} rows are shown, {different} of these with a difference; "
            f"{len(rows) - len(shown)} are open")


def test_cell(row):
    return "; ".join(f"`{file}`" + (f": \"{name}\"{cases(file).get(name, '')}" if name else "")
                     for file, name in tests_of(row))


def section_cell(row):
    path, _, anchor = row["section"].partition("#")
    target = path.removeprefix("docs/") if path.startswith("docs/") else f"../{path}"
    return f"[{heading(path, anchor)}]({target}#{anchor})"


def says_cell(row):
    return row["says"] + (f" **But:** {row['but']}" if row["but"] else "")


def line_of(row):
    start = f"| {row['row']} | {row['place']} | {says_cell(row)} |"
    if is_open(row):
        return f"{start} *open* | | |"
    call = "–" if row["call"] == "-" else f"`{row['call']}`"
    return f"{start} {call} | {test_cell(row)} | {section_cell(row)} |"


def written(rows):
    lines = ["# The three source texts, row by row", "",
             "Look up here what a source text says, and which call, which tests and which section show it. **But** is what is otherwise here,",
             "or is not there; an *open* row is not done at all. A *long* test runs with `./x test --long` alone. `tests/docs/seeds.py` writes this",
             "page from `docs/seeds.tsv`, and fails if a row has no call, test or section, or if the tree lacks one that is named.", "",
             f"{counted(rows)}.", ""]
    for text, (_, title, places) in TEXTS.items():
        lines += [f"## {text}: {title}", "", places, "", "| | place | what the text says | call | tests | section |",
                  "| --- | --- | --- | --- | --- | --- |"]
        lines += [line_of(row) for row in rows if row["row"].startswith(text)] + [""]
    return "\n".join(lines).rstrip("\n") + "\n"


@functools.cache
def headings(path):
    """The headings of a page by their anchors, as code hosts make them."""
    text = (root / path).read_text(encoding="utf-8") if (root / path).is_file() else ""
    prose = re.sub(r"^ *```.*?^ *```", "", text, flags=re.S | re.M)
    lines = re.findall(r"^#+ +(.*)$", prose, re.M)
    return {re.sub(r"[^\w\- ]", "", line.lower()).replace(" ", "-"): line for line in lines}


def heading(path, anchor):
    return re.sub(r":? `.*", "", headings(path).get(anchor, "absent"))


@functools.cache
def cases(file):
    """Of each test case of a file of C++ its name, and whether it is one of the long ones."""
    text = (root / file).read_text(encoding="utf-8") if (root / file).is_file() else ""
    found = re.findall(r"TEST_CASE\(\s*((?:\"(?:[^\"\\]|\\.)*\"\s*)+)(,\s*\"[^\"]*\[long\])?", text)
    return {"".join(re.findall(r"\"((?:[^\"\\]|\\.)*)\"", name)): " (*long*)" if tag else "" for name, tag in found}


@functools.cache
def is_run(file):
    """A script of the tests is named by the list of its folder, alone or by a pattern."""
    path = root / file
    of_folder = path.parent / "CMakeLists.txt"
    words = re.findall(r"[\w*.]+", of_folder.read_text(encoding="utf-8")) if of_folder.is_file() else []
    return any(fnmatch.fnmatch(name, word) for name in (path.name, path.stem) for word in words if word.strip("*."))


@functools.cache
def help_of(command):
    """Nothing where there is no such command: the program then prints the help of the one above."""
    said = subprocess.run([durero, *command, "--help"], capture_output=True, text=True)
    return said.stdout if f"Usage: durero {' '.join(command)} " in said.stdout else ""


@functools.cache
def paragraph(name):
    return subprocess.run([durero, "spec", "show", name], capture_output=True).returncode == 0


def wrong_names(rows):
    names = [row["row"] for row in rows]
    yield from (f"{name}: no such row in {TABLE}" for name in ROWS if name not in names)
    yield from (f"{name}: no row of the texts" for name in names if name not in ROWS)
    if sorted(names) == sorted(ROWS) and names != ROWS:
        yield f"{TABLE}: the rows are not in order"
    yield from (f"{name}: more than one row" for name in dict.fromkeys(names) if names.count(name) > 1)


def missing_cells(rows):
    for row in rows:
        wanted = ["place", "says"] + ([] if is_open(row) else ["call", "tests", "section"])
        yield from (f"{row['row']}: no {cell}, and not said to be open" for cell in wanted if not row[cell])
        if row["call"] == "-" and not row["but"]:
            yield f"{row['row']}: no call, and nothing said of that"
        if is_open(row) and (row["tests"] or row["section"] or row["but"]):
            yield f"{row['row']}: open, and yet something is claimed"


def choices(text, option):
    """The words that the help of a command has behind an option, in parentheses."""
    own = " ".join(text.partition("Options:")[2].split()).partition(f" {option} ")[2].partition(" --")[0]
    return re.findall(r"[\w-]+", "".join(re.findall(r"\(([^()]*, [^()]*)\)", own)).partition(";")[0])


def wrong_call(call):
    words = shlex.split(call)
    if words[:1] != ["durero"] or len(words) < 2:
        return "no call of durero"
    nested = 2 if words[1] in ("spec", "conform", "raster") else 1
    command = tuple(words[1 : 1 + nested])
    text = help_of(command)
    if not text:
        return f"no command {' '.join(command)}"
    before = ""
    for word in words[1 + nested :]:
        if word.startswith("-") and not re.search(rf"^ +(-\w, +)?{re.escape(word)}(,| |$)", text, re.M):
            return f"no option {word}"
        if before in CHOSEN and word not in choices(text, before):
            return f"no word {word} of {before}"
        if "/" in word and before not in WRITTEN and not (root / word).is_file():
            return f"no file {word}"
        before = word if word.startswith("-") else ""
    if command == ("spec", "show") and not paragraph(words[-1]):
        return f"no paragraph {words[-1]}"
    return ""


def wrong_calls(rows):
    for row in rows:
        if row["call"] not in ("", "-", "open"):
            if fault := wrong_call(row["call"]):
                yield f"{row['row']}: {row['call']}: {fault}"


def wrong_tests(rows):
    for row in rows:
        for file, name in tests_of(row):
            if not file.startswith("tests/") or not (root / file).is_file():
                yield f"{row['row']}: {file} is not there"
            elif file.endswith(".cpp") and name not in cases(file):
                yield f"{row['row']}: {file} has no test case \"{name}\""
            elif not file.endswith(".cpp") and (name or not is_run(file)):
                yield f"{row['row']}: {file}{name and ': ' + name} is run by no test"


def wrong_sections(rows):
    for row in rows:
        path, _, anchor = row["section"].partition("#")
        if path and not (root / path).is_file():
            yield f"{row['row']}: {path} is not there"
        elif path and anchor not in headings(path):
            yield f"{row['row']}: {path} has no section {anchor}"


def stale(rows, page):
    if written(rows) != page:
        yield f"{PAGE} is stale; python3 tests/docs/seeds.py --write . writes it"


def faults(rows, page=None):
    rules = (wrong_names, missing_cells, wrong_calls, wrong_tests, wrong_sections)
    found = [fault for rule in rules for fault in rule(rows)]
    return found + list(stale(rows, page)) if page is not None else found


def unseen(rows, page):
    """The planted faults that no rule sees."""
    def with_cell(name, cell, value):
        return [{**row, cell: value} if row["row"] == name else row for row in rows]

    def opened(**cells):
        return [{**row, "call": "open", "tests": "", "section": "", "but": "", **cells} if row["row"] == "A5" else row
                for row in rows]
    planted = {
        "a row that is missing": [row for row in rows if row["row"] != "R49"],
        "a row that stands twice": rows + rows[-1:],
        "a row of no text": with_cell("Z10", "row", "Z11"),
        "rows in another order": [rows[1], rows[0], *rows[2:]],
        "a row that says nothing": with_cell("A5", "says", ""),
        "a row without a place": with_cell("A61", "place", ""),
        "a row without a call": with_cell("A5", "call", ""),
        "no call, and nothing said": with_cell("A5", "call", "-"),
        "a row without a test": with_cell("A5", "tests", ""),
        "a row without a section": with_cell("A5", "section", ""),
        "an open row with a test": opened(tests="tests/docs/gallery.py"),
        "an open row with a section": opened(section="docs/acceleration.md#the-techniques"),
        "another program": with_cell("A5", "call", "povray --help"),
        "a command that is none": with_cell("A5", "call", "durero benchmark"),
        "a command of spec that is none": with_cell("A5", "call", "durero spec lost"),
        "an option that is none": with_cell("A5", "call", "durero engines --lost"),
        "the beginning of an option": with_cell("A5", "call", "durero stats demo/rays.txt --eng fast"),
        "an engine that is none": with_cell("A5", "call", "durero stats demo/groups.json --engine exact"),
        "a scene that is not there": with_cell("A5", "call", "durero stats demo/lost.json"),
        "a paragraph that is none": with_cell("A5", "call", "durero spec show lost"),
        "a test that is not there": with_cell("A5", "tests", "tests/accel/lost_test.cpp: lost"),
        "a test case that is not there": with_cell("A5", "tests", "tests/accel/bvh_test.cpp: lost"),
        "a file of test cases without a name": with_cell("A5", "tests", "tests/accel/bvh_test.cpp"),
        "a script that nobody runs": with_cell("A5", "tests", "tests/docs/install_lines.sh"),
        "a page that is not there": with_cell("A5", "section", "docs/lost.md#lost"),
        "a section that is not there": with_cell("A5", "section", "docs/acceleration.md#lost"),
        "a page without a section": with_cell("A5", "section", "docs/acceleration.md"),
    }
    missed = [what for what, changed in planted.items() if not faults(changed)]
    return missed + ([] if list(stale(with_cell("A5", "says", "Lost."), page)) else ["a page that is stale"])


table = list(read_rows((root / TABLE).read_text(encoding="utf-8")))
if durero == "--write":
    (root / PAGE).write_text(written(table), encoding="utf-8")
    print(counted(table))
    sys.exit(0)
shown = (root / PAGE).read_text(encoding="utf-8") if (root / PAGE).is_file() else ""
wrong = faults(table, shown) or [f"not seen: {what}" for what in unseen(table, shown)]
print("\n".join(wrong) or f"{counted(table)}, and every fault that was planted is seen")
sys.exit(bool(wrong))
