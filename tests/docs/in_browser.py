"""A site in Chromium: what its search finds, and how wide its pages are on a phone. Each answers nothing where there is no Chromium."""
import html
import json
import pathlib
import re
import shutil
import subprocess
import tempfile

BROWSER = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-component-update", "--disable-sync",
           "--no-first-run", "--allow-file-access-from-files"]


def shown(address):
    """What a page becomes in a browser; nothing where there is no Chromium."""
    browser = shutil.which("chromium")
    if not browser:
        return None
    with tempfile.TemporaryDirectory() as profile:
        return subprocess.run([browser, *BROWSER, f"--user-data-dir={profile}", "--virtual-time-budget=600000", "--dump-dom", address],
                              capture_output=True, encoding="utf-8", timeout=600, check=False).stdout


def left_by(page):
    """What a page of ours leaves in its element out, as JSON; nothing where there is no Chromium."""
    with tempfile.TemporaryDirectory() as place:
        file = pathlib.Path(place) / "page.html"
        file.write_text(page, encoding="utf-8")
        said = shown(file.as_uri())
    if said is None:
        return None
    found = re.search(r'<pre id="out">(.*?)</pre>', said, re.S)
    return json.loads(html.unescape(found[1])) if found and found[1] else []


def searched(folder, index, queries):
    """Of each query the first ten results of the search of the site in folder, of that index."""
    tools = (folder / "_static/searchtools.js").read_text(encoding="utf-8")
    shows = "_displayNextItem(results, results.length, searchTerms, highlightTerms);"
    assert tools.count(shows) == 1, "searchtools.js shows its results in another way"
    tools = tools.replace(shows, "FOUND.push(results.slice(-10).reverse().map((item) => item[0] + item[2]));")
    data = (folder / "_static/language_data.js").read_text(encoding="utf-8")
    return left_by(f"""<input name="q"><div id="search-progress"></div><pre id="out"></pre><script>
        const FOUND = [], SPHINX_HIGHLIGHT_ENABLED = false, _ = (text) => text;
        const DOCUMENTATION_OPTIONS = {{}}; const _ready = () => 0;</script>
        <script>{data}</script><script>{tools}</script><script>{index}</script><script>
        for (const words of {json.dumps(queries)}) {{
          document.querySelector("input").value = words; Search.query(words); }}
        document.getElementById("out").textContent = JSON.stringify(FOUND);</script>""")


def widths(addresses, phone):
    """Of each page how wide it is where it is shown phone wide, in pixels of its style sheet."""
    return left_by(f"""<iframe width="{phone}" height="844" style="border: 0"></iframe><pre id="out"></pre><script>
        const frame = document.querySelector("iframe"), widths = [], pages = {json.dumps(addresses)};
        frame.onload = () => {{
          if (frame.src) widths.push(frame.contentDocument.documentElement.scrollWidth);
          if (widths.length < pages.length) frame.src = pages[widths.length];
          else document.getElementById("out").textContent = JSON.stringify(widths); }};
        frame.src = pages[0];</script>""")
