"""Sphinx's configuration of the site. build.sh calls it on a tree of links to the pages, which tree.py makes."""
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(HERE))

project = "Durero"
author = "the authors of Durero"
copyright = "the authors of Durero. MIT licence"  # noqa: A001  Sphinx asks for this name
release = re.search(r"^project\(\w+ VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"), re.M)[1]

extensions = ["myst_parser", "pages", "sources"]
source_suffix = {".md": "markdown"}
root_doc = "index"
nitpicky = True
# A file without an ending, LICENSE, is shown as it stands; blocks without a language are no code.
highlight_language = "none"

myst_heading_anchors = 6
# repository: leads to a file of the repository, shown by sources.py; site: to a file that the site has beside its pages.
myst_url_schemes = ["http", "https", "mailto", "repository", "site"]

html_theme = "furo"
html_title = "Durero"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_js_files = ["site.js"]
html_search_scorer = str(HERE / "score.js")
html_copy_source = False
html_show_sourcelink = False
html_show_sphinx = False
html_last_updated_fmt = None
html_theme_options = {"navigation_with_keys": False}
pygments_style = "xcode"
pygments_dark_style = "github-dark"
myst_enable_extensions = ["deflist"]
