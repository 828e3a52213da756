"""Files of the repository on the site: a link, or a path in code, that names one leads to a page that shows it, with its
lines numbered. The names of theorems in code lead to their texts."""
import functools
import html
import pathlib
import posixpath
import re
import shutil

from docutils import nodes
from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import get_lexer_for_filename
from pygments.lexers.special import TextLexer
from pygments.util import ClassNotFound
from sphinx.util import logging

import theorems

say = logging.getLogger(__name__)

FOLDERS = r"(?:spec|include|src|tests|proofs|docs|demo|systems|schemas|campaigns|cmake|python|debian|\.ci)"
PATH = re.compile(rf"{FOLDERS}/[A-Za-z0-9_./-]+")
# The links of a map or a graph, whose HTML is made.
IN_RAW = re.compile(r'"(repository|page):([^"#]*)(#[^"]*)?"')
# A longer file, else of 200,000 letters, is handed over as it is: no browser likes to show it with its lines numbered.
LONGEST = {".json": 30_000, ".txt": 30_000, ".v": 500_000}
AS_THEY_ARE = {".png", ".svg", ".npy", ".gz", ".zip"}
PAGE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>{path} – Durero</title>
<link rel="stylesheet" href="{up}_static/pygments.css"><link rel="stylesheet" href="{up}_static/site.css">
<script src="{up}_static/theme_of_source.js"></script>
</head>
<body class="source" data-theme="auto">
<header><a href="{up}index.html">Durero</a> <span>{shown}</span></header>
<main>{body}</main>
</body>
</html>
"""


def address(app, path):
    """Where the site has a file of the repository."""
    file = app.config.durero_root / path
    whole = file.suffix in AS_THEY_ARE or file.stat().st_size > LONGEST.get(file.suffix, 200_000)
    return f"files/{path}" if whole else f"files/{path}.html"


def from_page(app, doc, target):
    """The address of the site's file target, from the page doc."""
    return posixpath.relpath(target, posixpath.dirname(app.builder.get_target_uri(doc)) or ".")


def to_file(app, doc, path, anchor=""):
    app.env.durero_files.add(path)
    return from_page(app, doc, address(app, path)) + (f"#{anchor}" if anchor else "")


def link_of_code(app, doc, text):
    """Where a word in code leads: to a page, a file or a theorem; to nothing, mostly."""
    root, docs = app.config.durero_root, app.env.found_docs
    if re.fullmatch(r"[A-Z]\w+\.v", text):
        text = f"proofs/{text}"
    if text in theorems.places(root):
        page, anchor = theorems.places(root)[text]
        return f"{app.builder.get_relative_uri(doc, page)}#{anchor}"
    if not PATH.fullmatch(text) or not (root / text).is_file():
        return None
    if text.endswith(".md") and text.removesuffix(".md") in docs:
        return app.builder.get_relative_uri(doc, text.removesuffix(".md"))
    return to_file(app, doc, text)


def address_in_raw(app, doc, scheme, path, mark):
    mark = mark or ""
    if scheme == "page":
        return app.builder.get_relative_uri(doc, path) + mark
    return to_file(app, doc, path) + mark


def link_files(app, tree, doc):
    for node in list(tree.findall(nodes.reference)):
        scheme, _, rest = node.get("refuri", "").partition(":")
        path, _, anchor = rest.partition("#")
        if scheme == "repository":
            node["refuri"] = to_file(app, doc, path, anchor)
        elif scheme == "site":
            node["refuri"] = from_page(app, doc, path) + (f"#{anchor}" if anchor else "")
        if scheme in ("repository", "site"):
            node["classes"] = [name for name in node["classes"] if name != "external"]
            node["internal"] = True
    for node in tree.findall(nodes.raw):
        node[:] = [nodes.Text(IN_RAW.sub(lambda match: f'"{address_in_raw(app, doc, *match.groups())}"', node.astext()))]
    for node in list(tree.findall(nodes.literal)):
        if not isinstance(node.parent, nodes.reference) and not inside_heading(node):
            if uri := link_of_code(app, doc, node.astext()):
                reference = nodes.reference("", "", internal=True, refuri=uri)
                node.replace_self(reference)
                reference += node


def inside_heading(node):
    return isinstance(node.parent, nodes.title)


@functools.cache
def lexer_of(suffix):
    """By the ending alone: Pygments asks every package of the machine for each file."""
    try:
        return get_lexer_for_filename(f"file{suffix}")
    except ClassNotFound:
        return TextLexer()


def shown(path, text):
    lexer = lexer_of(pathlib.PurePath(path).suffix)
    return highlight(text, lexer, HtmlFormatter(linenos="inline", lineanchors="L", anchorlinenos=True, wrapcode=True))


def write_files(app, failure):
    if failure or app.builder.name != "html":
        return
    out = pathlib.Path(app.outdir)
    for path in sorted(app.env.durero_files):
        source, target = app.config.durero_root / path, out / address(app, path)
        target.parent.mkdir(parents=True, exist_ok=True)
        if target.name == source.name:
            shutil.copyfile(source, target)
            continue
        up = "../" * (target.relative_to(out).as_posix().count("/"))
        text = source.read_text(encoding="utf-8")
        target.write_text(PAGE.format(path=path, up=up, shown=html.escape(path), body=shown(path, text)), encoding="utf-8")
    say.info("%d files of the repository", len(app.env.durero_files))


def setup(app):
    app.connect("builder-inited", lambda app: setattr(app.env, "durero_files", set()))
    app.connect("doctree-resolved", link_files)
    app.connect("build-finished", write_files)
    return {"parallel_read_safe": True, "parallel_write_safe": False}
