"""The gallery on the site: each picture with the call that draws it, from demo/gallery/pictures.tsv."""
import re

ROW = re.compile(r"^\| !\[([^\]]*)\]\(([^)]+)\) \| (.*) \|$", re.M)
TABLE_HEAD = re.compile(r"^\| \| \|\n\| --- \| --- \|\n", re.M)


def calls(root):
    """Of each picture the call that draws it, in demo/gallery."""
    rows = (root / "demo" / "gallery" / "pictures.tsv").read_text(encoding="utf-8").splitlines()
    return {picture: call for picture, _, call in (row.split("\t") for row in rows if not row.startswith("#"))}


def commands(picture, call):
    """The lines that draw a picture; a database of other people is imported first."""
    words = call.split(" ")
    if words[1].endswith(".nff"):
        scene = words[1].replace(".nff", ".json")
        return [f"durero import {words[1]} -o {scene}", " ".join(["durero", words[0], scene, *words[2:], "-o", picture])]
    return [f"durero {call} -o {picture}"]


def with_calls(text, root):
    """The page with a block for each picture in the place of its row: a phone is narrower than a table of pictures."""
    call_of = calls(root)

    def block(match):
        alternative, picture, says = match.groups()
        lines = "\n".join(commands(picture, call_of[picture]))
        return f'<div class="picture">\n\n![{alternative}]({picture})\n\n<div>\n\n{says}\n\n```sh\n{lines}\n```\n\n</div>\n</div>\n'
    return ROW.sub(block, TABLE_HEAD.sub("", text))
