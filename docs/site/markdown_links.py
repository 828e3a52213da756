"""Links of a page in Markdown, without those in fences and code."""
import posixpath
import re

FENCE = re.compile(r"(^ *```.*?^ *```[^\n]*$)", re.S | re.M)
LINK = re.compile(r"(!?)\[([^\[\]]*)\]\(([^)\s]+)\)")


def is_outside(target):
    return re.match(r"[a-z]+:", target) is not None


def resolved(page, target):
    """The file of the repository that a link leads to, and its anchor."""
    path, _, anchor = target.partition("#")
    return posixpath.normpath(posixpath.join(posixpath.dirname(page), path)) if path else page, anchor


def links_of(page, text):
    """The files of the repository that the page links to."""
    for part in FENCE.split(text)[::2]:
        for is_image, _, target in LINK.findall(part):
            if not is_image and not is_outside(target):
                yield resolved(page, target)[0]


def rewritten(text, change):
    """The text with each target of a link, of no image, as change(target) has it."""
    def one(match):
        is_image, label, target = match.groups()
        return match[0] if is_image or is_outside(target) else f"[{label}]({change(target)})"
    parts = FENCE.split(text)
    parts[::2] = [LINK.sub(one, part) for part in parts[::2]]
    return "".join(parts)
