"""The questions that a stranger asks, each with the sentence that answers it: from questions.tsv.

A line has the question, the page and section that answers, words that stand there, and what one would search for."""

HEAD = """# Questions

Each answer is a passage of the page that the link leads to.

{questions}
"""


def rows(root):
    """(question, page, anchor, words of the answer, words to search for)"""
    for line in (root / "docs" / "site" / "questions.tsv").read_text(encoding="utf-8").splitlines()[1:]:
        question, place, answer, search = line.split("\t")
        page, _, anchor = place.partition("#")
        yield question, page, anchor, answer, search


def item(question, page, anchor, answer):
    page = {"README": "index"}.get(page, page)
    answer = f"… {answer}" if answer[0].islower() else answer
    answer = answer if answer.endswith((".", "!", "?")) else f"{answer} …"
    return f"**{question}**\n: {answer} [More](site:{page}.html{'#' + anchor if anchor else ''})\n"


def pages(root):
    yield "questions", HEAD.format(questions="\n".join(item(*row[:4]) for row in rows(root)))
