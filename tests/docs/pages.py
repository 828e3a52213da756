"""pages.py ROOT: every page of docs/ is found, and whatever a page names is there.

- docs/README.md links to each page of docs/, and docs/findings.md to each page below docs/findings/.
- Each link of a page to a file leads to one, and its anchor to a heading there.
- Each path of the repository that stands in backticks is there, but for placeholders such as src/LAYER; the changelog, which
  is history, may name others.
- A row of README's table of findings has the counts of a row of docs/findings.md.
- The package of Debian, whose pages lie in one folder, keeps README and not the index of its name.

Each of these rules then sees a fault that is planted in a copy of the pages in memory."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1]).resolve()
LINK = re.compile(r"\]\(([^)\s]+)\)")
PATH = re.compile(r"`((?:spec|include|src|tests|proofs|docs|demo|systems|schemas|campaigns|cmake|python)/[A-Za-z0-9_/.-]+)`")
PLACEHOLDER = re.compile(r"/(?!README)[A-Z]{4,}\b")
PACKAGED = "debian/durero.docs"
FOLDERS = ("docs/**", "proofs", "spec", "demo/**", "systems/**", "campaigns/**")


def read_pages():
    files = [*root.glob("*.md"), *(file for folder in FOLDERS for file in root.glob(f"{folder}/*.md"))]
    files.append(root / PACKAGED)
    return {file.relative_to(root).as_posix(): file.read_text(encoding="utf-8") for file in files}


def prose(text):
    """The text without what stands in fences."""
    return re.sub(r"^ *```.*?^ *```", "", text, flags=re.S | re.M)


def anchors(text):
    """The anchors of its headings, as code hosts make them."""
    headings = re.findall(r"^#+ +(.*)$", prose(text), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def links(name, text):
    """Of each link to a file of the repository its words, that file and its anchor."""
    for target in LINK.findall(prose(text)):
        if not re.match(r"[a-z]+:", target):
            path, _, anchor = target.partition("#")
            file = (root / name).parent / path if path else root / name
            yield target, pathlib.Path(*file.parts).resolve(), anchor


def linked_from(pages, name):
    return {file for _, file, _ in links(name, pages[name])} if name in pages else set()


def lost_pages(pages):
    for name in pages:
        index = "docs/findings.md" if name.startswith("docs/findings/") else "docs/README.md"
        if name.startswith("docs/") and name != "docs/README.md" and root / name not in linked_from(pages, index):
            yield f"{name}: {index} does not link to it"


def broken_links(pages):
    for name, text in pages.items():
        for target, file, anchor in links(name, text):
            if not file.exists():
                yield f"{name}: {target} leads nowhere"
                continue
            page = pages.get(file.relative_to(root).as_posix()) if file.is_relative_to(root) else None
            if anchor and (page is None or anchor not in anchors(page)):
                yield f"{name}: {target} has no such heading"


def absent_paths(pages):
    for name, text in pages.items():
        if name != "CHANGELOG.md":
            paths = [path for path in PATH.findall(prose(text)) if not PLACEHOLDER.search(path)]
            yield from (f"{name}: {path} is not there" for path in paths if not (root / path).exists())


def other_counts(pages):
    rows = re.findall(r"^\| ([^|]+) \| (\d+) \| (\d+) \|$", pages["README.md"], re.M)
    if not rows:
        yield "README.md: no table of findings"
    for system, judged, gross in rows:
        row = rf"^\| {re.escape(system.split()[0])}[^|]* \| {judged} \| (?:[^|]* \| ){{4}}{gross} \|"
        if not re.search(row, pages["docs/findings.md"], re.M):
            yield f"README.md: docs/findings.md has no {system.split()[0]} of {judged} rays with {gross} gross errors"


def hidden_readme(pages):
    for pattern in pages[PACKAGED].split():
        if any(file.name == "README.md" for file in root.glob(pattern)):
            yield f"{PACKAGED}: {pattern} puts another README.md into the place of README"


RULES = [lost_pages, broken_links, absent_paths, other_counts, hidden_readme]


def faults(pages):
    return [fault for rule in RULES for fault in rule(pages)]


def unseen(pages):
    """The planted faults that no rule sees."""
    readme = pages["docs/README.md"]
    planted = {
        "a new page": {"docs/lost.md": "# Lost\n"},
        "a new finding": {"docs/findings/ode/lost.md": "# Lost\n"},
        "an index without a page": {"docs/README.md": readme.replace("(streams.md)", "(README.md)")},
        "a link to no file": {"docs/README.md": readme + "[lost](lost.md)\n"},
        "a link to no heading": {"docs/README.md": readme + "[lost](streams.md#lost)\n"},
        "a path that is not there": {"docs/README.md": readme + "`src/lost.cpp`\n"},
        "an index in the place of README": {PACKAGED: "docs/*.md\n"},
        "another count": {"README.md": re.sub(r"^(\| \w+[^|]* \| \d+ \| )(\d+) \|$", r"\g<1>1\g<2> |", pages["README.md"], 1, re.M)},
    }
    return [what for what, changed in planted.items() if not faults({**pages, **changed})]


everything = read_pages()
wrong = faults(everything) or [f"not seen: {what}" for what in unseen(everything)]
print("\n".join(wrong) or f"{len(everything) - 1} pages, and every fault that was planted is seen")
sys.exit(bool(wrong))
