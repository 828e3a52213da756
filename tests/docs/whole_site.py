"""whole_site.py DURERO ROOT FOLDER [built]: the site that docs/site/build.sh makes in FOLDER is whole; with `built` the one that lies there.

- Each link leads to a file of the site, and its anchor to one there. A link to another host is well formed; nothing is loaded from one.
- Each page of the repository is a page of the site, and each picture of the gallery stands above the call that draws it.
- Each share of docs/findings.md has a cell in a map, which leads to its row; each theorem of proofs/assumptions.txt has its text,
  and a node that leads there; each command of the program has its help.
- The text of each colour of a share is legible on it, in light and in dark, and the colours go one way from light to dark.
- Each question of docs/site/questions.tsv is answered by the words that it names, in the section that it names, and its search finds
  that page among the first ten results. No page is wider than a phone. These two need Chromium, and are skipped where there is none.

Each of these rules then sees a fault that is planted in a copy of the site in memory."""
import collections
import html
import json
import pathlib
import posixpath
import re
import subprocess
import sys
import urllib.parse

import in_browser

durero, root, folder = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]).resolve()
LINK = re.compile(r"<(\w+)\b[^>]*?\s(?:href|src)=\"([^\"]*)\"")
ANCHOR = re.compile(r"\s(?:id|name)=\"([^\"]*)\"")
NOWHERE = ("javascript:", "data:", "mailto:")
LEGIBLE = 4.5  # the contrast that WCAG 2 asks of text

PHONE = 390  # pixels of a style sheet, across a phone

Site = collections.namedtuple("Site", "pages files style scripts index")


def read_site():
    pages = {path.relative_to(folder).as_posix(): path.read_text(encoding="utf-8") for path in folder.rglob("*.html")}
    files = {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}
    style = "".join(path.read_text(encoding="utf-8") for path in sorted((folder / "_static").rglob("*.css")))
    scripts = {path.name: path.read_text(encoding="utf-8") for path in sorted((folder / "_static").rglob("*.js"))}
    return Site(pages, files, style, scripts, (folder / "searchindex.js").read_text(encoding="utf-8"))


def markup(text):
    """A page without its scripts."""
    return re.sub(r"<script\b[^>]*>.*?</script>", "", text, flags=re.S) if "<script" in text else text


def is_well_formed(address):
    try:
        parts = urllib.parse.urlsplit(address)
        return parts.scheme in ("http", "https") and re.fullmatch(r"[\w-]+(\.[\w-]+)+(:\d+)?", parts.netloc) is not None
    except ValueError:
        return False


def links(site):
    """Each link that leads within the site: the page, the link, the file and its anchor."""
    for page, text in site.pages.items():
        for _, target in LINK.findall(markup(text)):
            target = html.unescape(target)
            if not re.match(r"[a-z]+:", target):
                path, _, anchor = target.partition("#")
                path = urllib.parse.unquote(path.partition("?")[0])
                yield page, target, posixpath.normpath(posixpath.join(posixpath.dirname(page), path)) if path else page, urllib.parse.unquote(anchor)


def dead_links(site):
    anchors = {}
    for page, target, file, anchor in links(site):
        if file not in site.files and f"{file}/index.html" not in site.files:
            yield f"{page}: {target} leads nowhere"
        elif anchor and file in site.pages:
            if file not in anchors:
                anchors[file] = {html.unescape(name) for name in ANCHOR.findall(site.pages[file])}
            if anchor not in anchors[file]:
                yield f"{page}: {target} has no such anchor"


def scripts_of_servers(site):
    """No script may be imported by another, since a page that is read from a file may import none."""
    for name, script in site.scripts.items():
        if re.search(r"^(import|export)\b", script, re.M):
            yield f"_static/{name}: it imports another script, or is one to import"


def other_hosts(site):
    for page, text in site.pages.items():
        for element, target in LINK.findall(text):
            if re.match(r"(https?:)?//", target):
                if element != "a":
                    yield f"{page}: <{element}> is loaded from {target}"
                elif not is_well_formed(html.unescape(target)):
                    yield f"{page}: {target} is no address"
            elif re.match(r"[a-z]+:", target) and not target.startswith(NOWHERE):
                yield f"{page}: {target} has a scheme that no browser knows"
    for target in re.findall(r"@import[^;]*|url\([^)]*\)", site.style):
        if re.search(r"//|\(['\"]?/", target) and "data:" not in target:
            yield f"a style sheet loads {target}"


def repository_pages():
    return [path.relative_to(root).as_posix() for folder in ("", "docs/**/", "spec/**/", "proofs/**/", "demo/**/")
            for path in root.glob(f"{folder}*.md")]


def lost_pages(site):
    for path in repository_pages():
        page = "index.html" if path == "README.md" else path.replace(".md", ".html")
        if page not in site.pages:
            yield f"{path} is no page of the site"


def gallery(site):
    page = html.unescape(re.sub(r"<[^>]+>", "", site.pages.get("demo/gallery/README.html", "")))
    shown = re.findall(r'<img[^>]*src="[^"]*?([\w-]+\.(?:png|svg))"', site.pages.get("demo/gallery/README.html", ""))
    readme = (root / "demo/gallery/README.md").read_text(encoding="utf-8")
    rows = (root / "demo/gallery/pictures.tsv").read_text(encoding="utf-8").splitlines()
    for picture, when, call in (row.split("\t") for row in rows if not row.startswith("#")):
        if f"![" in readme and re.search(rf"!\[[^\]]*\]\({picture}\)", readme):
            words = call.split(" ", 2)
            wanted = call if when != "spd" else f"{words[0]} {words[1].replace('.nff', '.json')} {words[2]}"
            if picture not in shown or f"durero {wanted} -o {picture}" not in page:
                yield f"demo/gallery/README.html: {picture} does not stand above its call"


def told_shares():
    """Of each row of a table of docs/findings.md its shares, as they stand there."""
    for line in (root / "docs/findings.md").read_text(encoding="utf-8").splitlines():
        if re.match(r"\|.*\| \d+ \| \d+ \|", line):
            yield from re.findall(r"(\w+) ([\d.]+) %", line.rsplit(" | ", 1)[1] if line.endswith("|") else line)


def lost_shares(site):
    page = site.pages.get("maps/findings.html", "")
    cells = re.findall(r'<td class="share(\d)"><a href="([^"]*)" title="[^"]*, (\w+): ([\d.]+) % of', page)
    told, shown = collections.Counter(told_shares()), collections.Counter((family, share) for _, _, family, share in cells)
    for (family, share), count in ((told - shown) + (shown - told)).items():
        yield f"maps/findings.html: {count} cells too many or too few of {family} {share} %"
    for step, target, family, share in cells:
        row = re.search(rf'id="{target.partition("#")[2]}".*?</tr>', site.pages.get(posixpath.normpath(f"maps/{target.partition('#')[0]}"), ""), re.S)
        if not row or family not in row[0] or f"{share} %" not in row[0]:
            yield f"maps/findings.html: the cell {family} {share} % does not lead to its row"
        if int(step) != sum(float(share) >= start for start in (0, 1, 5, 20, 40, 60, 80)):
            yield f"maps/findings.html: {family} {share} % has the colour of another share"


def lost_theorems(site):
    pages = {page: text for page, text in site.pages.items() if page.startswith("maps/proofs/")}
    nodes = {target for text in pages.values() for target in re.findall(r'<g class="node theorem"[^>]*>\s*<g[^>]*><a href="([^"]*)"', text)}
    for name in re.findall(r"^(\w+):", (root / "proofs/assumptions.txt").read_text(encoding="utf-8"), re.M):
        anchor = re.sub(r"_+", "-", name.lower())
        own = [page for page, text in pages.items() if f'id="{anchor}"' in text]
        text = re.sub(r"<[^>]+>", "", pages[own[0]]) if own else ""
        if not own or f"Theorem {name}" not in text:
            yield f"maps/proofs: no text of {name}"
        elif f"{own[0].rpartition('/')[2]}#{anchor}" not in nodes and f"#{anchor}" not in nodes:
            yield f"maps/proofs: no node leads to {name}"
    for page, text in site.pages.items():
        if text.count('<g class="node ') != len(re.findall(r'<g class="node [^>]*>\s*<g[^>]*><a href="[^"]', text)):
            yield f"{page}: a node leads nowhere"


def lost_commands(site):
    page = site.pages.get("reference/command-line.html", "")
    said = subprocess.run([durero, "--help"], check=True, capture_output=True, encoding="utf-8").stdout
    for command in re.findall(r"^  ([a-z]+) {2,}", said.partition("\nOptions:")[0], re.M):
        if f'id="durero-{command}"' not in page:
            yield f"reference/command-line.html: no help of {command}"


def luminance(colour):
    parts = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [part / 12.92 if part <= 0.03928 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def illegible(site):
    schemes = [dict(re.findall(r"--(share\d(?:-text)?): (#\w{6})", block)) for block in site.style.split("}")]
    schemes = [scheme for scheme in schemes if scheme]
    if site.style.count("prefers-color-scheme: dark") < 3:
        yield "the theme, the site or the code lacks its colours for readers who prefer the dark"
    if len(schemes) != 3:
        yield f"the shares have {len(schemes)} schemes of colours; expected light, dark and dark by choice"
    for scheme in schemes:
        grounds = [luminance(scheme[f"share{i}"]) for i in range(1, 8)]
        if grounds not in (sorted(grounds), sorted(grounds, reverse=True)):
            yield "the colours of the shares do not go one way from light to dark"
        for i, ground in enumerate(grounds, 1):
            light, dark = sorted((ground, luminance(scheme[f"share{i}-text"])), reverse=True)
            if (light + 0.05) / (dark + 0.05) < LEGIBLE:
                yield f"the text of share {i} is hard to read on its colour"


def questions():
    for line in (root / "docs/site/questions.tsv").read_text(encoding="utf-8").splitlines()[1:]:
        question, place, answer, search = line.split("\t")
        page, _, anchor = place.partition("#")
        yield question, ("index" if page == "README" else page), anchor, answer, search


def words_of(text):
    """What a reader sees, in one line of plain letters."""
    text = html.unescape(re.sub(r"<[^>]+>", "", text))
    return re.sub(r"\s+", " ", text).replace("’", "'").replace("“", '"').replace("”", '"')


def section_of(page, anchor):
    """The part of a page from an anchor on, up to the next heading of any level."""
    start = page.find(f'id="{anchor}"') if anchor else page.find("<article")
    if start < 0:
        return ""
    heading = page.find("</h", start)
    end = re.compile(r"<h[1-6]\b|</article>").search(page, heading)
    return page[start : end.start() if end else None]


def unanswered(site):
    for question, page, anchor, answer, _ in questions():
        if words_of(answer.replace("`", "")) not in words_of(section_of(site.pages.get(f"{page}.html", ""), anchor)):
            yield f"docs/site/questions.tsv: {question} is not answered by {page}#{anchor}: {answer}"
        if f"{page}.html" not in site.pages.get("questions.html", ""):
            yield f"questions.html does not lead to {page}"


def unindexed(site):
    index = json.loads(site.index[len("Search.setIndex(") : site.index.rindex(")")])
    known = index["terms"].keys() | index["titleterms"].keys()
    for question, page, _, _, search in questions():
        if page not in index["docnames"]:
            yield f"the search does not know {page}"
        for word in re.findall(r"\w{3,}", search.lower()):
            if not any(term.startswith(word[:4]) for term in known):
                yield f"docs/site/questions.tsv: {question}: the search knows no {word}"


RULES = [dead_links, scripts_of_servers, other_hosts, lost_pages, gallery, lost_shares, lost_theorems, lost_commands, illegible, unanswered, unindexed]


def too_wide(site):
    """Pages of each kind that one would have to push aside on a phone."""
    pages = [page for page in sorted(site.pages) if not page.startswith(("cpp/", "files/", "maps/systems/", "page/"))]
    pages += sorted(page for page in site.pages if page.startswith("maps/systems/"))[:6]
    wide = folder.with_suffix(".wide.html")  # a planted fault
    wide.write_text(f'<!doctype html><body style="margin: 0"><p style="width: {PHONE + 1}px">wide</p>', encoding="utf-8")
    found = in_browser.widths([path.as_uri() for path in [wide, *(folder / page for page in pages)]], PHONE)
    wide.unlink()
    if found is None:
        print("skipped: no chromium: no page is looked at on a phone")
        return
    if len(found) != len(pages) + 1 or found[0] != PHONE + 1:
        yield f"a phone shows {len(found)} of {len(pages) + 1} pages, the first of them {found[:1]} pixels wide, and not {PHONE + 1}"
    for page, width in zip(pages, found[1:]):
        if width > PHONE:
            yield f"{page}: {width} pixels wide, where a phone has {PHONE}"


def unfound(site):
    found = in_browser.searched(folder, site.index, [row[4] for row in questions()])
    if found is None:
        print("skipped: no chromium: nothing is searched for")
        return
    if len(found) != len(list(questions())):
        yield "the search does not end"
    results = re.search(r'<ul class="search">.*?</ul>', in_browser.shown((folder / "search.html").as_uri() + "?q=verdicts") or "", re.S)
    if not results or 'href="docs/conformance.html#verdicts"' not in results[0]:
        yield f"search.html, read from a file, finds no verdicts: {results and results[0]}"
    for (question, page, _, _, search), results in zip(questions(), found):
        if page not in [result.partition("#")[0] for result in results]:
            yield f"docs/site/questions.tsv: {question}: {search!r} finds {results}, and not {page}"


def faults(site):
    return [fault for rule in RULES for fault in rule(site)]


def without(site, page, old, new=""):
    assert re.search(old, site.pages[page], re.S), f"{page} has no {old}"
    return site._replace(pages={**site.pages, page: re.sub(old, new, site.pages[page], count=1, flags=re.S)})


def unseen(site):
    """The planted faults that their rules do not see."""
    planted = {
        "a link to no file": (dead_links, without(site, "index.html", r'href="docs/conformance.html"', 'href="docs/lost.html"')),
        "a link to no anchor": (dead_links, without(site, "index.html", r'href="#start"', 'href="#lost"')),
        "a script of another host": (other_hosts, without(site, "index.html", r"</head>", '<script src="https://example.org/x.js"></script></head>')),
        "an address that is none": (other_hosts, without(site, "index.html", r"</article>", '<a href="https://nowhere">x</a></article>')),
        "a style sheet of another host": (other_hosts, site._replace(style=site.style + "@import url(//example.org/x.css);")),
        "a style sheet of a server": (other_hosts, site._replace(style=site.style + "@import url(/x.css);")),
        "a script that imports another": (scripts_of_servers, site._replace(scripts={"x.js": 'import x from "./y.js";\n'})),
        "a page that is lost": (lost_pages, site._replace(pages={page: text for page, text in site.pages.items() if page != "docs/seeds.html"})),
        "a picture without its call": (gallery, without(site, "demo/gallery/README.html", r"whitted\.json(?=<span class=\"w\">)")),
        "a cell that is lost": (lost_shares, without(site, "maps/findings.html", r'<td class="share\d">', "<td>")),
        "a cell that leads elsewhere": (lost_shares, without(site, "maps/findings.html", r'(<td class="share\d"><a href="[^"]*?)-tiny"', r'\1-generic"')),
        "a cell of another colour": (lost_shares, without(site, "maps/findings.html", r'<td class="share7">', '<td class="share1">')),
        "a theorem without a text": (lost_theorems, without(site, "maps/proofs/the-closed-forms.html", 'id="stable-discriminants"', 'id="lost"')),
        "a node that leads nowhere": (lost_theorems, without(site, "maps/proofs.html", r'(<g class="node [^>]*>\s*<g[^>]*>)<a href="[^"]*"', r"\1<a")),
        "a command without help": (lost_commands, without(site, "reference/command-line.html", 'id="durero-trace"')),
        "a colour that is hard to read": (illegible, site._replace(style=site.style.replace("--share7-text: #ffffff", "--share7-text: #333333"))),
        "colours out of order": (illegible, site._replace(style=site.style.replace("--share2: #d8e7f5", "--share2: #000000"))),
        "a question without its answer": (unanswered, without(site, "docs/conformance.html", "16 units of rounding")),
        "a page that the search does not know": (unindexed, site._replace(index=site.index.replace('"docs/conformance", ', '"docs/lost", '))),
    }
    return [what for what, (rule, changed) in planted.items() if not any(True for _ in rule(changed))]


def main():
    if sys.argv[4:] != ["built"]:
        subprocess.run(["sh", root / "docs/site/build.sh", durero, root, folder], check=True)
    site = read_site()
    wrong = [*faults(site), *unfound(site), *too_wide(site)] or [f"not seen: {what}" for what in unseen(site)]
    outside = {target for text in site.pages.values() for target in re.findall(r'<a\b[^>]*href="(https?:[^"]*)"', text)}
    print("\n".join(wrong[:60]) or f"{len(site.pages)} pages, {sum(1 for _ in links(site))} links, none dead, {len(outside)} addresses "
          f"of other hosts, {len(list(questions()))} questions, and every fault that was planted is seen")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
