"""The findings as maps of systems by families, and a page a system with its failures by family.

All comes of docs/findings.md, docs/families.md, systems/*/*.json and the pages of small failures below docs/findings/."""
import dataclasses
import functools
import html
import json
import re

from docutils.nodes import make_id

PAGE, LAST = "docs/findings.md", "families with gross failures"
# The tables of most systems first.
ORDER = ["All systems", "Triangles", "Bodies"]
# From each of these shares on, in per cent, a cell has the colour of its place here; site.css has the colours.
STEPS = [0, 1, 5, 20, 40, 60, 80]
EMPTY = "<td></td>"
HEAD = """# Findings as maps

A row is a system, a column a family of hard rays. The number in a cell is the share of the judged rays of the family that the
system answered with a *gross* error, in per cent. A cell without a number has no gross error, or the system has no element of the family's
kind and was not asked. A cell leads to what the system does in that family: its rays, its small failures and the command that
asks them again. A dot marks a family of which a small failure is filed. [What was found](/docs/findings.md) has the counts and says when and how each
table was asked; [the families](/docs/families.md) says why each is hard.

{legend}

{maps}
"""
SYSTEM = """---
orphan: true
---

# {title}: failures by family

{about}

{tables}{small}
"""


@dataclasses.dataclass
class Row:
    system: str  # its title on the page
    name: str  # its adapter's name, or one made of the title
    adapter: str  # the file of the adapter, or nothing
    question: str
    counts: dict
    shares: dict  # of each family with gross failures the share as it is printed


@dataclasses.dataclass
class Table:
    heading: str
    rows: list


@functools.cache
def adapters(root):
    """Of each title the names of its adapters, their files and the questions that they answer."""
    found = []
    for file in sorted((root / "systems").glob("*/*.json")):
        says = json.loads(file.read_text(encoding="utf-8"))
        if "title" in says:
            title = says["title"].replace("Jolt Physics, npm jolt-physics", "Jolt")
            questions = says["profile"].get("questions", ["first"])
            found.append((title, says["system"], file.relative_to(root).as_posix(), questions))
    return found


def adapter_of(root, title, question, function):
    """The adapter whose title is the row's, before the version that it said of itself in parentheses; or begins so, answers
    the question and, where there are several, names the function."""
    title = title.replace("Jolt Physics, npm jolt-physics", "Jolt").split(", 64 rays")[0]
    whole = re.sub(r" \([^()]*\)$", "", title)
    known = adapters(root)
    exact = [row for row in known if row[0] in (title, whole)]
    begins = [row for row in known if row[0].split(" (")[0] == title and question in row[3]]
    return (exact or sorted(begins, key=lambda row: function not in row[0]) or [None])[0]


def cells_of(line):
    return [cell.strip() for cell in re.split(r" \| ", line.strip()[2:-2])]


def shares_of(cell):
    return {} if cell == "none" else dict(part.rsplit(" ", 2)[:2] for part in cell.split(", "))


def row_of(root, head, cells):
    of = dict(zip(head, cells))
    question = of.get("question", "`first`").strip("`")
    adapter = adapter_of(root, of["system"], question, of.get("function", ""))
    title = of["system"] + (f", {of['question'].strip('`')}" if "question" in of else "")
    if "question" not in of:
        title = re.sub(r" \([^()]*\)$", "", title)
    name = adapter[1] if adapter else make_id(of["system"])
    counts = {key: of[key] for key in ("judged", "exact", "right", "off", "gross")}
    return Row(title, name, adapter[2] if adapter else "", question.strip("`"), counts, shares_of(of[LAST]))


@functools.cache
def tables(root):
    found, heading, head = [], "", None
    for line in (root / PAGE).read_text(encoding="utf-8").splitlines():
        if line.startswith("#"):
            heading, head = line.lstrip("# "), None
        elif line.startswith("| ") and line.rstrip(" |").endswith(LAST):
            head = cells_of(line)
            found.append(Table(heading, []))
        elif head and line.startswith("| ") and not line.startswith("| ---"):
            found[-1].rows.append(row_of(root, head, cells_of(line)))
    return sorted(found, key=lambda table: ORDER.index(table.heading) if table.heading in ORDER else len(ORDER))


@functools.cache
def families(root):
    """Of each family what its rays are and why they are asked, in the order of docs/families.md."""
    page = (root / "docs" / "families.md").read_text(encoding="utf-8")
    return {name: (rays, why) for name, rays, *_, why in
            (cells_of(line.replace("|  |", "| – |")) for line in page.splitlines() if line.startswith("| `"))
            for name in [name.strip("`")]}


@functools.cache
def small_failures(root):
    """Of each adapter's name and family the pages of the failures that were made small, and their titles."""
    found = {}
    for page in sorted((root / "docs" / "findings").glob("*/*.md")):
        text = page.read_text(encoding="utf-8")
        call = re.search(r"`durero conform bug ([\w-]+) (\w+)/\d+ --ray \d+", text)
        found.setdefault((call[1], call[2]), []).append((page.relative_to(root).as_posix(), text.partition("\n")[0].lstrip("# ")))
    return found


def step_of(share):
    return sum(float(share) >= start for start in STEPS)


def anchor_of(table, row, family):
    return make_id(f"{table.heading} {row.question} {family}")


def filed(root, row, family):
    """The pages of the small failures of a row: each is of a first hit."""
    return small_failures(root).get((row.name, family), []) if row.question == "first" else []


def cell(root, table, row, family):
    dot = "•" if filed(root, row, family) else ""
    if family not in row.shares:
        dot = "" if any(family in other.shares for table in tables(root) for other in table.rows if other.name == row.name) else dot
        link = f'<a href="page:{doc_of(row)}#small-failures" title="{row.system}, {family}: a small failure"><span class="filed">•</span></a>'
        return f"<td>{link}</td>" if dot else EMPTY
    share = row.shares[family]
    shown = "&lt;1" if float(share) < 1 else f"{float(share):.0f}"
    says = html.escape(f"{row.system}, {family}: {share} % of the judged rays gross" + (", with a small failure" if dot else ""))
    return (f'<td class="share{step_of(share)}"><a href="page:{doc_of(row)}#{anchor_of(table, row, family)}" title="{says}">'
            f'{shown}<span class="filed">{dot}</span></a></td>')


def heat_map(root, table):
    mine = [family for family in families(root) if any(cell(root, table, row, family) != EMPTY for row in table.rows)]
    heads = "".join(f'<th scope="col"><a href="page:docs/families"><span>{family}</span></a></th>' for family in mine)
    lines = "".join(f'<tr><th scope="row"><a href="page:{doc_of(row)}">{html.escape(row.system)}</a></th>'
                    f'<td class="sum">{row.counts["gross"]}</td>' + "".join(cell(root, table, row, family) for family in mine) + "</tr>\n"
                    for row in table.rows)
    return (f'<div class="heat-frame" tabindex="0"><table class="heat"><caption>Gross errors in per cent of the judged rays: {html.escape(table.heading)}'
            f'</caption>\n<thead><tr><th scope="col">system</th><th scope="col"><span>all, rays</span></th>{heads}</tr></thead>\n'
            f"<tbody>\n{lines}</tbody></table></div>")


def legend():
    ends = STEPS[1:] + [100]
    keys = "".join(f'<span class="share{i}">{start or "&gt;0"}–{end}</span>' for i, (start, end) in enumerate(zip(STEPS, ends), 1))
    return f'<p class="heat-legend">per cent: {keys}</p>'


def doc_of(row):
    return f"maps/systems/{row.name}"


def family_rows(root, table, row):
    for family, share in row.shares.items():
        rays, why = families(root)[family]
        small = "; ".join(f"[{title}](/{page})" for page, title in filed(root, row, family)) or "–"
        anchor = f'<span id="{anchor_of(table, row, family)}"></span>'
        yield f"| {anchor}`{family}` | {share} % | {rays} | {why} | {small} |"


def asked(row):
    """The command that asks the failures of a row again."""
    words = f" --question {row.question}" if row.question != "first" else ""
    names = ",".join(row.shares)
    return (f"```sh\ndurero conform setup {row.name}\ndurero conform run {row.name}{words} --family {names} --rays 256 --report found\n```\n\n"
            f"`found/{row.name}/` then has a report, whose failures are made small one by one.\n")


def section(root, table, row):
    counts = ", ".join(f"{number} {key}" for key, number in row.counts.items())
    text = f"## {table.heading}{'' if row.question == 'first' else ': ' + row.question}\n\n{row.system}: {counts}.\n\n"
    if not row.shares:
        return text + "No gross error.\n"
    lines = "\n".join(family_rows(root, table, row))
    text += f"| family | gross | its rays | why they are asked | small failures |\n| --- | --: | --- | --- | --- |\n{lines}\n\n"
    return text + (asked(row) if row.adapter else "")


def system_page(root, name, places):
    table, row = places[0]
    about = "[The findings as maps](/maps/findings.md) has all systems; [what was found](/docs/findings.md) says how they were asked."
    if row.adapter:
        about += f" The adapter is [`{row.adapter}`](repository:{row.adapter})."
    mine = [f"- [{title}](/{page}), of the family `{family}`" for (system, family), pages in small_failures(root).items()
            if system == name for page, title in pages]
    small = "## Small failures\n\n" + "\n".join(mine) + "\n" if mine else ""
    return SYSTEM.format(title=row.system.removesuffix(f", {row.question}").split(" (")[0], about=about, small=small,
                         tables="\n".join(section(root, *place) for place in places))


def pages(root):
    """Each page of the findings: its name without an ending, and its text."""
    by_system = {}
    for table in tables(root):
        for row in table.rows:
            by_system.setdefault(row.name, []).append((table, row))
    maps = "\n\n".join(f"## {table.heading}\n\n```{{raw}} html\n{heat_map(root, table)}\n```" for table in tables(root))
    yield "maps/findings", HEAD.format(legend=f"```{{raw}} html\n{legend()}\n```", maps=maps)
    for name, places in by_system.items():
        yield f"maps/systems/{name}", system_page(root, name, places)
