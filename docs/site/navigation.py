"""The sidebar, by reader and task as docs/README.md has them."""
import posixpath
import re

from markdown_links import links_of

INDEX = "docs/README"
# What is made for the site alone, under its own headings.
MADE = {"Maps and pictures": ["browser", "maps/findings", "maps/proofs", "demo/gallery/README"],
        "Look up": ["reference/command-line", "reference/cpp", "reference/python", "reference/schemas"]}


def parent_of(doc, docs):
    """The page below which a page stands: docs/formats for docs/formats/scene, spec/README for spec/erratas."""
    if doc.startswith("maps/systems/"):  # the maps lead to them, and they are too many for a sidebar
        return "maps/findings"
    folder = posixpath.dirname(doc)
    while folder:
        for parent in (folder, f"{folder}/README"):
            if parent in docs and parent not in (doc, INDEX):
                return parent
        folder = posixpath.dirname(folder)
    return None


def sections(text):
    """Of each section of docs/README.md its heading and the pages that it names, in order; one without pages of its own
    reader belongs to the one before."""
    found = []
    for part in re.split(r"^## ", text, flags=re.M)[1:]:
        heading, _, body = part.partition("\n")
        if not heading.startswith("You ") and found:
            found[-1][1].extend(links_of(f"{INDEX}.md", body))
        else:
            found.append((heading, list(links_of(f"{INDEX}.md", body))))
    return found


def top_pages(text, docs):
    """Captions and their pages: each page once, where docs/README.md names it first; the rest with the last reader."""
    made = {doc for group in MADE.values() for doc in group}
    tops = {doc for doc in docs if not parent_of(doc, docs)} - made - {"index", INDEX, "questions"}
    groups = []
    for heading, targets in sections(text):
        named = [target.removesuffix(".md") for target in targets]
        mine = [doc for doc in dict.fromkeys(named) if doc in tops]
        tops -= set(mine)
        groups.append((heading, mine))
    groups[-1][1].extend(sorted(tops))
    return groups + [(caption, [doc for doc in group if doc in docs]) for caption, group in MADE.items()]


def toctree(entries, caption=None):
    options = ":hidden:\n" + (f":caption: {caption}\n" if caption else "")
    lines = "\n".join(f"/{entry}" for entry in entries)
    return f"\n\n```{{toctree}}\n{options}\n{lines}\n```\n"


def of_home(text, docs):
    """What the first page gets: all captions."""
    trees = toctree(["questions", INDEX])
    for caption, group in top_pages(text, docs):
        trees += toctree(group, caption) if group else ""
    return trees


def below(doc, docs):
    """What a page gets for the pages that stand below it."""
    children = sorted(child for child in docs if parent_of(child, docs) == doc and not child.startswith("maps/systems/"))
    return toctree(children) if children else ""
