#!/usr/bin/env python3
"""Other people's Z, read by Durero, by fuzz and as CZT's own tests say: every difference has its reason in a table.

    public_corpus.py DURERO

public_corpus.tsv names public repositories, each at one commit. They are cloned into the folder DURERO_Z_CORPUS, or into
z-corpus here, and never committed. DURERO_FUZZ is the program fuzz, or else one on the path; without it the opinions of
fuzz are left out. CZT's opinion is that of its type-checker's tests: a file that ends in .error has an error, and another
none. fuzz is not asked of ISO's texts, which have a section header or are in Unicode. Durero accepts a text (yes), or
reads it and refuses its types (types), or does not read it (no). No conjecture is tried.

A text that Durero accepts is converted, too: ISO's to Spivey's Z, and Spivey's to ISO's LaTeX. What was written is accepted
again, and by fuzz where it is Spivey's; or the conversion is refused, with a place. What is otherwise has a row of "converted FILE".

public_differences.tsv has a row for differences: the files, what each says (* any, - not asked), a part of the first message
of Durero, or of fuzz where Durero accepts, and the reason. The test fails where a difference has no row, where a row is
no longer so, and where Durero reads less than 95 % of the files that fuzz or CZT accepts.

Exit status: 0 all is so; 1 not, a line each; 77 a repository cannot be had.
"""
import collections
import concurrent.futures
import fnmatch
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ENDINGS = {".tex", ".latex", ".zed", ".zed8", ".utf8", ".jaza", ".in", ".error"}
BOX = rb"^(?:\xef\xbb\xbf)?(?:\xe2\x94\x8c|\xe2\x94\x80|\xe2\x95\xb7)"
PARAGRAPH = re.compile(rb"\\begin\{(schema|zed|axdef|gendef|syntax|zsection)\}|" + BOX, re.M)
ISO = re.compile(rb"\\begin\{zsection\}|" + BOX, re.M)
CZT_TESTS = "community-z-users/czt:typechecker/typechecker-z/src/test/resources/"
LEAST_SHARE = 0.95
REFUSAL = r":\d+:\d+: .*(cannot be written|would be another|would be read as Z|as a box of Unicode)"

Judged = collections.namedtuple("Judged", "path fuzz czt durero message")


def rows(name):
    for line in (HERE / name).read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            yield line.split("\t")


def git(folder, *words):
    return subprocess.run(["git", "-C", str(folder), *words], capture_output=True, text=True, check=False)


def cloned(folder, repository, commit):
    """The clone at its commit, or None."""
    clone = folder / repository.replace("/", "+")
    if git(clone, "rev-parse", "HEAD").stdout.strip() == commit and (clone / ".git").exists():
        return clone
    clone.mkdir(parents=True, exist_ok=True)
    git(clone, "init", "-q")
    if git(clone, "fetch", "-q", "--depth", "1", f"https://github.com/{repository}", commit).returncode != 0:
        return None
    return clone if git(clone, "checkout", "-q", "FETCH_HEAD").returncode == 0 else None


def z_files(clone, repository, seen):
    """The texts with a paragraph, each once whatever its copies."""
    for name in git(clone, "ls-tree", "-r", "-z", "--name-only", "HEAD").stdout.split("\0"):
        path = clone / name
        if path.suffix not in ENDINGS or not path.is_file():
            continue
        text = path.read_bytes()
        digest = hashlib.sha256(text).digest()
        if PARAGRAPH.search(text) and digest not in seen:
            seen.add(digest)
            yield f"{repository}:{name}", path, text


def said(words, folder):
    """The exit status of a program, and what it printed."""
    try:
        done = subprocess.run(words, cwd=folder, capture_output=True, timeout=60, check=False)
    except subprocess.TimeoutExpired:
        return 124, "no answer in a minute"
    return done.returncode, (done.stdout + done.stderr).decode("utf-8", "replace")


def of_fuzz(fuzz, path, text):
    if ISO.search(text):
        return "-", ""
    if fuzz is None:
        return "?", ""
    library = pathlib.Path(fuzz).parent / "fuzzlib"
    status, told = said([fuzz, *(["-p", str(library)] if library.exists() else []), path.name], path.parent)
    return ("yes" if status == 0 and not told.strip() else "no"), " ".join(told.split())


def of_czt(name):
    if not name.startswith(CZT_TESTS):
        return "-"
    return "no" if name.endswith(".error") else "yes"


def reads(durero, path):
    """Whether the text is read: then it can be converted, or is refused by the other mark-up alone."""
    status, told = said([durero, "spec", "convert", path.name, "--to", "unicode"], path.parent)
    return status == 0 or re.search(REFUSAL, told)


def of_durero(durero, path):
    status, told = said([durero, "spec", "check", "--states", "0", path.name], path.parent)
    if status == 0:
        return "yes", ""
    lines = [line for line in told.splitlines() if ": warning: " not in line and ": opinion: " not in line]
    errors = [line for line in lines if re.search(r":\d+:\d+: ", line)]
    return ("types" if reads(durero, path) else "no"), (errors or lines or [""])[0]


def conversion(durero, fuzz, name, path):
    """What became of the conversion of a text that is accepted: written, refused with a place, or a difference."""
    is_spivey = "in Spivey's Z" in said([durero, "spec", "check", "--states", "0", path.name], path.parent)[1]
    to = "iso" if is_spivey else "spivey"
    with tempfile.TemporaryDirectory() as there:
        written = pathlib.Path(there) / "written.tex"
        status, told = said([durero, "spec", "convert", path.name, "--to", to, "-o", str(written)], path.parent)
        if status != 0:
            return "refused" if re.search(REFUSAL, told) else Judged(f"converted {name}", "-", "-", "no", told)
        by_durero, told = of_durero(durero, written)
        if by_durero == "yes" and to == "spivey":
            opinion, told = of_fuzz(fuzz, written, b"")
            return Judged(f"converted {name}", opinion, "-", "yes", told) if opinion == "no" else "written"
        return "written" if by_durero == "yes" else Judged(f"converted {name}", "-", "-", by_durero, told)


def judge(durero, fuzz, name, path, text):
    by_fuzz, told_by_fuzz = of_fuzz(fuzz, path, text)
    by_durero, told = of_durero(durero, path)
    return Judged(name, by_fuzz, of_czt(name), by_durero, told_by_fuzz if by_durero == "yes" else told)


def differs(one):
    """Whether others think otherwise of a text; or whether Durero refuses it, where none was asked."""
    others = {one.fuzz, one.czt} - {"-", "?"}
    accepted = "yes" if one.durero == "yes" else "no"
    return bool(others - {accepted}) if others else accepted == "no"


def is_of(row, one):
    files, fuzz, czt, durero, message, _ = row
    said_so = zip((fuzz, czt, durero), (one.fuzz, one.czt, one.durero))
    return (fnmatch.fnmatchcase(one.path, files) and all(wanted in ("*", got) for wanted, got in said_so)
            and message in one.message)


def check(all_judged, table):
    failures = []
    used = collections.Counter()
    for one in filter(differs, all_judged):
        matching = [i for i, row in enumerate(table) if is_of(row, one)]
        if matching:
            used[matching[0]] += 1
        else:
            failures.append(f"no row: {one.path}: fuzz {one.fuzz}, CZT {one.czt}, Durero {one.durero}: "
                            f"{one.message[:160]}")
    without_fuzz = any(one.fuzz == "?" for one in all_judged)
    for i, row in enumerate(table):
        if not used[i] and not (without_fuzz and row[1] in ("yes", "no")):
            failures.append("no longer so: " + "\t".join(row))
    return failures, used


def main():
    durero = str(pathlib.Path(sys.argv[1]).resolve())
    fuzz = os.environ.get("DURERO_FUZZ") or shutil.which("fuzz")
    folder = pathlib.Path(os.environ.get("DURERO_Z_CORPUS") or "z-corpus").resolve()
    texts, seen = [], set()
    for repository, commit, _ in rows("public_corpus.tsv"):
        clone = cloned(folder, repository, commit)
        if clone is None:
            print(f"skipped: {repository} cannot be had at {commit}")
            return 77
        texts += z_files(clone, repository, seen)
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        judged = list(pool.map(lambda each: judge(durero, fuzz, *each), texts))
        accepted = [each for each, one in zip(texts, judged) if one.durero == "yes"]
        became = list(pool.map(lambda each: conversion(durero, fuzz, *each[:2]), accepted))
    judged_again = [one for one in became if isinstance(one, Judged)]
    table = list(rows("public_differences.tsv"))
    failures, used = check(judged + judged_again, table)
    taken = [one for one in judged if "yes" in (one.fuzz, one.czt)]
    read = sum(one.durero != "no" for one in taken)
    print(f"{len(judged)} files; Durero reads {sum(one.durero != 'no' for one in judged)} and accepts "
          f"{sum(one.durero == 'yes' for one in judged)}; of the {len(taken)} that fuzz or CZT accepts, it reads {read} and "
          f"accepts {sum(one.durero == 'yes' for one in taken)}; {sum(used.values())} differences in {len(table)} rows; "
          f"of the {len(accepted)} that it accepts {became.count('written')} are converted, {became.count('refused')} refused")
    if read < LEAST_SHARE * len(taken):
        failures.append(f"of the files that fuzz or CZT accepts Durero reads less than {LEAST_SHARE:.0%}")
    print("\n".join(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
