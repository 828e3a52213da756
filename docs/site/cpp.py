"""cpp.py FOLDER: repairs the links of Doxygen's pages, which lie in the folder cpp of the site: docs/library.md and
docs/licences.md link to pages that Doxygen does not have and the site has, and Doxygen 1.9.4 links to some sections that it leaves out."""
import pathlib
import posixpath
import re
import sys

TO_PAGE = re.compile(r'(<a (?:class="el" )?href=")([\w./-]+\.md|\.\./LICENSE)((?:#[^"]*)?")')
TO_SECTION = re.compile(r'<a href="#([\w-]+)">[^<]*</a>(?: &#124;)?')


def place_of(target, site):
    """Where the site has what a page of docs/ links to, from the folder cpp."""
    path = posixpath.normpath(posixpath.join("docs", target))
    page = "index.html" if path == "README.md" else path.replace(".md", ".html")
    return "../" + (page if (site / page).is_file() else f"files/{path}.html")


def repaired(text, site):
    text = TO_PAGE.sub(lambda link: link[1] + place_of(link[2], site) + link[3], text)
    anchors = set(re.findall(r'\s(?:id|name)="([^"]*)"', text))
    return TO_SECTION.sub(lambda link: link[0] if link[1] in anchors else "", text)


def main():
    site = pathlib.Path(sys.argv[1])
    for page in sorted((site / "cpp").glob("*.html")):
        text = page.read_text(encoding="utf-8")
        if (now := repaired(text, site)) != text:
            page.write_text(now, encoding="utf-8")


if __name__ == "__main__":
    main()
