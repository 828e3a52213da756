"""What the site adds to the pages as they stand in the repository: where their links lead, the sidebar, and the gallery.

Sphinx's event source-read hands each page over as it is read; no page is written anywhere."""
import posixpath

from sphinx.util import logging

import gallery
import navigation
from markdown_links import resolved, rewritten

say = logging.getLogger(__name__)

# What stands below the title of a page: where the site has a picture of it, or what is made for the site.
BESIDE = {"index": "[Questions](/questions.md) · [Findings as maps](/maps/findings.md) · [The proofs as a picture](/maps/proofs.md) · "
                   "[Gallery](/demo/gallery/README.md) · [All pages](/docs/README.md)",
          "docs/findings": "[The tables of this page as a map](/maps/findings.md): each cell leads to its failures.",
          "docs/proofs": "[The chain as a picture](/maps/proofs.md): each node leads to the text of its theorems and to their labels."}
# A folder has a page where the site has one of it.
FOLDERS = {"schemas": "/reference/schemas.md"}
# Blocks of the pages that are in no language that Pygments knows.
PLAIN = ["question", "got", "exact", "data", "reproduced"]


def file_of(doc):
    return "README.md" if doc == "index" else f"{doc}.md"


def target_of(app, doc, target):
    """Where a link of the repository leads on the site."""
    if target.startswith("/"):
        return target
    path, anchor = resolved(file_of(doc), target)
    mark = f"#{anchor}" if anchor else ""
    if path == file_of(doc):
        return mark or target
    if path == "README.md":
        return posixpath.relpath("index.md", posixpath.dirname(doc)) + mark
    if path.removesuffix(".md") in app.env.found_docs:
        return target
    if path in FOLDERS:
        return FOLDERS[path]
    if not (app.config.durero_root / path).is_file():
        say.warning("%s: %s leads to no file", file_of(doc), target)
    return f"repository:{path}{mark}"


def is_made(doc):
    return doc in ("questions", "browser") or doc.startswith(("maps/", "reference/"))


def read(app, doc, source):
    text, docs = source[0], app.env.found_docs
    if not is_made(doc):
        text = rewritten(text, lambda target: target_of(app, doc, target))
    if doc in BESIDE:
        head, title, rest = text.partition("\n\n")
        text = f"{head}{title}{BESIDE[doc]}\n\n{rest}"
    if doc == "demo/gallery/README":
        text = gallery.with_calls(text, app.config.durero_root)
    if doc == "index":
        index = (app.config.durero_root / "docs" / "README.md").read_text(encoding="utf-8")
        text += navigation.of_home(index, docs)
    else:
        text += navigation.below(doc, docs)
    source[0] = text


def setup(app):
    from pygments.lexers.special import TextLexer
    import conf
    app.add_config_value("durero_root", conf.ROOT, "env")
    for language in PLAIN:
        app.add_lexer(language, TextLexer)
    app.connect("source-read", read)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
