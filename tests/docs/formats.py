"""formats.py DURERO ROOT [--write]: the examples of docs/formats.md, docs/formats/, docs/spec-tool.md, docs/refinement.md,
docs/scenes.md, docs/store.md, docs/mesh-audit.md and docs/scene-differences.md are what the program takes, prints and
refuses. A comment before a block or a table says what it is:

  <!-- file NAME -->               the block is that file, for what follows on the page
  <!-- run STATUS -->              each line of the block is a command that ends so
  <!-- prints -->                  the block is what the last command printed
  <!-- refused NAME COMMAND… -->   the block is the error about the file of that name
  <!-- errors NAME COMMAND… -->    a row of the table is a text of the file, what stands there instead, the error;
                                   the file itself is none
  <!-- defects NAME COMMAND… -->   the same, where the line goes to standard output and the status is 1
  <!-- words [PREFIX.] NAME OLD NEW COMMAND… -->   the words in the first column are those that the reader knows: in the file
                                   NEW stands for OLD, with a word for its @. Where it is none of them, the error lists
                                   all of them, and no others. Several such comments may stand before one table
  <!-- call -->                    the block is a call, which web_call beside DURERO answers
  <!-- answers -->                 the block is the answer to the last call. An object with the key … has further members, an
                                   array that ends in "…" further items, and a text that ends in … goes on

--write puts what the program says into the pages."""
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

durero, root, writes = os.path.abspath(sys.argv[1]), pathlib.Path(os.path.abspath(sys.argv[2])), "--write" in sys.argv
PAGES = ["docs/formats.md", "docs/formats/scene.md", "docs/formats/edits.md", "docs/formats/rays.md",
         "docs/formats/results.md", "docs/formats/conform.md", "docs/formats/others.md", "docs/formats/call.md",
         "docs/spec-tool.md", "docs/refinement.md", "docs/scenes.md", "docs/store.md", "docs/mesh-audit.md",
         "docs/scene-differences.md"]
PART = re.compile(r"((?:<!-- words [^\n]* -->\n)*)<!-- (file|run|prints|refused|errors|defects|words|call|answers)( [^\n]*)? -->\n"
                  r"(```\w*\n(.*?)```\n|((?:\|[^\n]*\n)+))", re.S)
NO_WORD = "zqxj"
counts, bad, known_words, probes = {}, 0, set(), 0


def fail(what):
    global bad
    bad += 1
    print("FAILED:", what)


def run(command):
    words, given = shlex.split(command), None
    if words[-1].startswith("<"):
        given = pathlib.Path(words.pop()[1:]).read_text()
    return subprocess.run([durero, *words], capture_output=True, text=True, check=False, input=given or "")


def said_of(kind, command):
    """The line of an error or a defect; what is wrong with it where it is none."""
    done = run(command)
    if kind == "defects":
        return done.stdout.rstrip("\n") if done.returncode == 1 else f"status {done.returncode}: {done.stdout}"
    line = done.stderr.rstrip("\n")
    if done.returncode != 2 or not line.startswith("durero: ") or "\n" in line:
        return f"status {done.returncode}: {line}"
    return line.removeprefix("durero: ")


def cells(row):
    return [cell.strip().removeprefix("`").removesuffix("`") for cell in re.split(r" ?\| ", row.strip()[2:-2])]


def check_row(kind, row, file, command):
    """The row as it should be."""
    old, new, shown = cells(row)
    text = pathlib.Path(file).read_text()
    if old not in text:
        fail(f"{file} has no {old}")
    pathlib.Path(file).write_text(text.replace(old, new, 1))
    said = said_of(kind, command)
    pathlib.Path(file).write_text(text)
    counts[kind] = counts.get(kind, 0) + 1
    if said != shown and not writes:
        fail(f"{file} with {new} for {old}: the page shows\n  {shown}\nand durero says\n  {said}")
    return f"| `{old}` |{f' `{new}`' if new else ''} | `{said}` |\n"


def check_table(kind, table, file, command):
    done = run(command)
    if done.returncode not in (0, 1) or (kind == "defects" and done.returncode != 0):
        fail(f"{file} is refused: {done.stderr}")
    head, rows = table.splitlines(keepends=True)[:2], table.splitlines(keepends=True)[2:]
    return "".join([*head, *(check_row(kind, row, file, command) for row in rows)])


def listed(said):
    """The words that an error expects, as a set."""
    expected = said.split("; expected ", 1)[-1]
    expected = re.sub(r"^.*?\b(one|each) of ", "", expected)
    expected = re.split(r",? or \}|,? which | once$", expected)[0]
    expected = re.sub(r" \([A-Za-z_]+\)", "", expected)  # the English beside a Spanish word
    return set(re.split(r", | or ", expected))


def check_words(table, arguments):
    """The table, the list of the error and what the reader takes are the same words."""
    global probes
    prefix, (name, old, new, *command) = "", arguments
    if name.endswith("."):
        prefix, name, old, new, *command = arguments
    first = " ".join(row[2:].split(" | ", 1)[0] for row in table.splitlines()[2:])
    on_page = {word.removeprefix(prefix) for word in re.findall(r"`([^`]+)`", first)
               if word.startswith(prefix) and "." not in word.removeprefix(prefix)}
    text = pathlib.Path(name).read_text()
    if old not in text:
        return fail(f"{name} has no {old}")

    def said(word):
        nonlocal text
        pathlib.Path(name).write_text(text.replace(old, new.replace("@", word), 1))
        done = run(" ".join(map(shlex.quote, command)))
        return done.stderr.removeprefix("durero: ") if done.returncode == 2 else ""

    unknown = said(NO_WORD)
    by_reader = listed(unknown.rstrip("\n"))
    for what, more in (("the page does not list", by_reader - on_page), ("the reader does not name", on_page - by_reader)):
        if more:
            fail(f"{name} with {new}: {what} {sorted(more)}: {unknown}")
    known_words.update(by_reader)
    wrong = unknown.split("; ", 1)[0]
    if NO_WORD not in wrong:
        fail(f"{name} with {new}: {unknown}")
    directives = {word.lstrip("#") for word in known_words if word.startswith("#")}  # they stand anywhere
    # Of tables above: some of them, each in its turn.
    others = sorted(word for word in known_words - on_page if word.lstrip("#") not in directives)
    for word in [*sorted(on_page), *others[probes % 4 :: 4]]:
        probes += 1
        is_refused = said(word).split("; ", 1)[0] == wrong.replace(NO_WORD, word)
        if is_refused == (word in on_page):
            fail(f"{name} with {new} and {word}: {'refused, and listed' if is_refused else 'not refused, and not listed'}")
    pathlib.Path(name).write_text(text)


def is_answer(shown, said):
    """Whether the answer of a page, which may leave out parts, is what was said."""
    if isinstance(shown, dict) and isinstance(said, dict):
        keys = shown.keys() - {"…"}
        return (keys < said.keys() if "…" in shown else keys == said.keys()) and all(
            is_answer(shown[key], said[key]) for key in keys)
    if isinstance(shown, list) and isinstance(said, list):
        goes_on = shown[-1:] == ["…"]
        items = shown[:-1] if goes_on else shown
        return (len(items) < len(said) if goes_on else len(items) == len(said)) and all(map(is_answer, items, said))
    if isinstance(shown, str) and isinstance(said, str) and shown.endswith("…") and shown != said:
        return said.startswith(shown[:-1]) and len(said) > len(shown)
    return type(shown) is type(said) and shown == said


def check_call(kind, block):
    global answer
    counts[kind] = counts.get(kind, 0) + 1
    if kind == "call":
        line = json.dumps(json.loads(block), ensure_ascii=False, separators=(",", ":")) + "\n"
        done = subprocess.run([pathlib.Path(durero).parent / "web_call"], capture_output=True, text=True, check=True, input=line)
        answer = json.loads(done.stdout)
    elif not is_answer(json.loads(block), answer):
        fail(f"the page shows\n{block}and web_call answers\n{json.dumps(answer, ensure_ascii=False)}")


def check_part(match):
    global last
    more, kind, words, part, block, table = match.groups()
    words = (words or "").strip()
    text = match.group(0)
    if kind in ("call", "answers"):
        check_call(kind, block)
        return text
    if kind == "words":
        for arguments in [*re.findall(r"<!-- words ([^\n]*) -->", more), words]:
            check_words(table, shlex.split(arguments))
            counts["words"] = counts.get("words", 0) + 1
        return text
    if kind == "file":
        pathlib.Path(words).write_text(block)
    elif kind == "run":
        for command in block.splitlines():
            last = run(command.removeprefix("durero "))
            if last.returncode != int(words) or not command.startswith("durero "):
                fail(f"{command}: status {last.returncode}, expected {words}: {last.stderr}")
    elif kind in ("errors", "defects"):
        return text.replace(table, check_table(kind, table, *words.split(" ", 1)))
    else:
        said = last.stdout if kind == "prints" else said_of(kind, words.split(" ", 1)[1]) + "\n"
        if said != block and not writes:
            fail(f"{words or 'the last command'}: the page shows\n{block}and durero says\n{said}")
        text = text.removesuffix(f"{block}```\n") + f"{said}```\n"
    counts[kind] = counts.get(kind, 0) + 1
    return text


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    os.symlink(root / "demo", "demo")
    for name in PAGES:
        page = (root / name).read_text(encoding="utf-8")
        checked = PART.sub(check_part, page)
        stacked = sum(more.count("<!-- ") for more, *_ in PART.findall(page))
        if page.count("<!-- ") - page.count("<!-- differences") - stacked != len(PART.findall(page)):
            fail(f"{name}: a comment stands before no block and no table, or says what nobody knows")
        for block in re.findall(r"(.*)\n```\w+\n", page):
            if not block.startswith("<!-- "):
                fail(f"{name}: a block that nothing runs, behind {block!r}")
        if writes:
            (root / name).write_text(checked, encoding="utf-8")
print(f"docs/formats: {counts}, {probes} words tried, {bad} failures")
sys.exit(bad > 0 or counts.get("errors", 0) < 80 or counts.get("file", 0) < 15 or counts.get("prints", 0) < 6 or counts.get("words", 0) < 12
         or counts.get("answers", 0) < 16)
