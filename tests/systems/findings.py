"""Smallest failures of other people's systems, as docs/findings/SYSTEM/NAME.md keeps them.

findings.py DURERO write SYSTEM CASE RAY NAME "CAUSE"   minimises a failure and writes its file
findings.py DURERO check                                asks each system that is set up its question again
"""
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).parents[2]
PAGES = ROOT / "docs" / "findings"
SETUPS = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / "durero" / "systems"


def files_of(system):
    return next((ROOT / "systems").glob("*/%s.json" % system))


def ask(system, question):
    """The version that the system says, its answer, and the end of what else it wrote."""
    file, setup = files_of(system), SETUPS / system
    from_pypi = "pypi" in json.loads(file.read_text())["install"]
    places = {"here": file.parent, "setup": setup, "out": setup / "ask",
              "python": setup / "venv" / "bin" / "python" if from_pypi else "python3"}
    command = [re.sub(r"\{(\w+)\}", lambda m: str(places[m[1]]), word) for word in json.loads(file.read_text())["ask"]]
    ended = subprocess.run(command, input=question, capture_output=True, text=True, cwd=setup, timeout=120)
    says, answer = [*ended.stdout.splitlines(), "", ""][:2]
    errors = ended.stderr.strip().splitlines()[-1:] or ["nothing on its standard error"]
    return says.removeprefix("system "), answer, "status %d, %s" % (ended.returncode, errors[0])


def block(kind, text):
    return "```%s\n%s\n```\n" % (kind, text.strip())


def write(durero, system, case, ray, name, cause):
    call = [durero, "conform", "minimise", system, "--case", case, "--ray", ray]
    said = subprocess.run(call, capture_output=True, text=True).stdout
    _, least, explained = said.split("\n\n", 2)
    sentence, question = least.split("\n", 1)
    hexadecimal, exact = explained.split("\n\n", 1)
    version, answer, _ = ask(system, question)
    verdict, words = sentence.split(": ", 1)
    page = PAGES / system / (name + ".md")
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text(
        "# %s: %s\n\n%s. %s\n\nFrom `%s`, made smaller.\n\n## Asked\n\n%s\nThe same %s\n\n## Got\n\n%s\n## Exact\n\n%s" % (
            version, verdict.replace("_", " "), words[0].upper() + words[1:], cause,
            " ".join(["durero", *call[1:]]), block("question", question), hexadecimal.replace(
                "in hexadecimal:\n", "in hexadecimal:\n\n```\n", 1).strip() + "\n```", block("got", answer),
            block("exact", exact.split("the exact answer: ", 1)[1])))


def why_not_asked(page, version, words):
    """A system that does not start here, or is of another version, shows nothing about its page."""
    if not version:
        return "%s does not start: %s" % (page.parent.name, words)
    title = page.read_text().splitlines()[0]
    return "" if title.startswith("# %s: " % version) else "%s is now %s" % (title[2:].rsplit(": ", 1)[0], version)


def check():
    """Status 1 where a system answers otherwise than its page says, 77 where none could be asked."""
    not_asked, wrong, asked = set(), 0, 0
    for page in sorted(PAGES.glob("*/*.md")):
        if not (SETUPS / page.parent.name / "complete").exists():
            not_asked.add("%s is not set up" % page.parent.name)
            continue
        question, got = (re.search(r"```%s\n(.*?)```" % kind, page.read_text(), re.S)[1] for kind in ("question", "got"))
        version, answer, words = ask(page.parent.name, question)
        why = why_not_asked(page, version, words)
        if why:
            not_asked.add(why)
            continue
        asked += 1
        if answer.strip() != got.strip():
            wrong += 1
            print("%s: now %s (%s)" % (page.relative_to(ROOT), answer or "no answer", words))
    print("%d asked again, %d answered otherwise; %s" % (asked, wrong, "; ".join(sorted(not_asked)) or "all were asked"))
    return 1 if wrong else 0 if asked else 77


if sys.argv[2] == "write":
    write(sys.argv[1], *sys.argv[3:])
else:
    sys.exit(check())
