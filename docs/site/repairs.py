"""repairs.py FOLDER: what Doxygen's pages and the theme of Debian lack in a site that is read from files.

- docs/library.md and docs/licences.md, in the folder cpp, link to pages that Doxygen does not have and the site has. Doxygen 1.9.4 links to
  some sections that it leaves out.
- Furo asks a server for its first style sheet by an absolute path, imports a script as no page from a file may, and lacks the colours
  for readers who prefer the dark."""
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


NORMAL = pathlib.Path("/usr/share/javascript/normalize.css/normalize.css")
DARK = re.compile(r'@media not print \{\s*body\[data-theme="dark"\] \{(.*?)\}', re.S)


def repair_style(static):
    file = static / "styles" / "furo.css"
    style = file.read_text(encoding="utf-8")
    if "url(/javascript/normalize.css/normalize.css)" in style:
        style = style.replace("url(/javascript/normalize.css/normalize.css)", "url(../normalize.css)")
        (static / "normalize.css").write_bytes(NORMAL.read_bytes())
    if "prefers-color-scheme" not in style:
        colours = DARK.search(style)[1]
        style += f'@media not print {{ @media (prefers-color-scheme: dark) {{ body:not([data-theme="light"]) {{{colours}}} }} }}\n'
    file.write_text(style, encoding="utf-8")


def repair_script(static):
    file = static / "scripts" / "furo.js"
    script, imports = file.read_text(encoding="utf-8"), 'import Gumshoe from "./gumshoe-patched.js";\n'
    if imports in script:
        gumshoe = (static / "scripts" / "gumshoe-patched.js").read_text(encoding="utf-8")
        file.write_text(gumshoe + script.replace(imports, ""), encoding="utf-8")


def main():
    site = pathlib.Path(sys.argv[1])
    repair_style(site / "_static")
    repair_script(site / "_static")
    for page in sorted((site / "cpp").glob("*.html")):
        text = page.read_text(encoding="utf-8")
        if (now := repaired(text, site)) != text:
            page.write_text(now, encoding="utf-8")


if __name__ == "__main__":
    main()
