"""tree.py DURERO ROOT TREE: a folder of what Sphinx reads: links to the pages of the repository, none of which is copied, and
the pages that are made for the site."""
import pathlib
import shutil
import sys

import findings_map
import proofs_map
import questions
import reference

# README is the first page of the site.
LINKED = {"index.md": "README.md", "CONTRIBUTING.md": "CONTRIBUTING.md", "CHANGELOG.md": "CHANGELOG.md", "docs": "docs",
          "spec": "spec", "proofs": "proofs", "demo": "demo"}
BROWSER = """# Durero in a browser

[The page](site:page/index.html) runs Durero in your browser: nothing is installed, and nothing that you type leaves it.
"""


def browser_pages(root):
    """Of the page that runs in a browser, where it is built."""
    if (root / "build" / "page" / "index.html").is_file():
        yield "browser", BROWSER


def main():
    durero, root, tree = (pathlib.Path(word).resolve() for word in sys.argv[1:])
    shutil.rmtree(tree, ignore_errors=True)
    tree.mkdir(parents=True)
    for name, target in LINKED.items():
        (tree / name).symlink_to(root / target)
    for pages in (reference.pages(durero, root), findings_map.pages(root), proofs_map.pages(root), questions.pages(root), browser_pages(root)):
        for name, text in pages:
            file = tree / f"{name}.md"
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
