"""families.py DURERO ROOT: docs/families.md has a line for each family of rays, as `durero conform list` tells it.
families.py --write DURERO ROOT: writes docs/families.md."""
import json
import pathlib
import subprocess
import sys

PAGE = "docs/families.md"
HEAD = """# The families of rays

`durero conform` asks a system rays of each of these families. A family has one parameter, which each of its scenes draws from the
range beside it. Numbers of binary32 have a range of their own where the other would be too wide. *Why* names the reports of
programs that got such rays wrong, by project and number. [What is asked](conformance.md#what-is-asked) tells how a suite is made of
families, and [a failure](conformance.md#a-failure-as-one-would-file-it) how one ray is filed.

This page is written by `python3 tests/docs/families.py --write build/release/durero .`, and a test fails where it is stale.

| family | its rays | parameter | range | in binary32 | why |
| --- | --- | --- | --- | --- | --- |
"""


def span(ends):
    return f"{ends['least']:g} … {ends['greatest']:g}".replace("-", "−")


def line(family):
    parameter = family["parameter"]
    whole, single = span(parameter), span(parameter["binary32"])
    cells = [f"`{family['family']}`", family["kind"], parameter["name"], whole, "" if single == whole else single, family["reason"]]
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |\n"


def made(durero):
    said = subprocess.run([durero, "conform", "list", "--json"], check=True, capture_output=True, encoding="utf-8").stdout
    return HEAD + "".join(map(line, json.loads(said)))


def main():
    *writes, durero, root = sys.argv[1:]
    page = pathlib.Path(root) / PAGE
    text = made(durero)
    if writes == ["--write"]:
        page.write_text(text, encoding="utf-8")
    elif writes or not page.exists() or page.read_text(encoding="utf-8") != text:
        sys.exit(f"{PAGE}:1: it is stale; python3 tests/docs/families.py --write build/release/durero . puts it right")


main()
