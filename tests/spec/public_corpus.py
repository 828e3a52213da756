#!/usr/bin/env python3
"""Other people's Z, read by Durero, by fuzz and by CZT: every difference has its reason in a table.

    public_corpus.py DURERO

public_corpus.tsv names public repositories, each at one commit. They are cloned into the folder DURERO_Z_CORPUS, or into
z-corpus here, and never committed. DURERO_FUZZ is the program fuzz, or else one on the path; CZT_JAR is CZT's jar, which
czt_build.sh builds. Without either its opinions are left out. fuzz is not asked of ISO's texts, which have a section header
or are in Unicode. CZT is asked of every text once, as Z: its answers are kept beside the clones. Durero accepts a text
(yes), or reads it and refuses its types (types), or does not read it (no). No conjecture is tried.

A text that Durero accepts is converted, too: ISO's to Spivey's Z, and Spivey's to ISO's LaTeX. What was written is accepted
again, and by fuzz where it is Spivey's; or the conversion is refused, with a place. What is otherwise has a row of "converted FILE".

public_differences.tsv has a row for differences: the files, what each says (* any, - not asked), a part of the first message
of Durero, or of fuzz and then CZT where Durero accepts, and the reason. The test fails where a difference has no row, where a row is
no longer so, and where Durero reads less than 95 % of the files that fuzz or CZT accepts. Files of rows whose reason
begins with "no Z to read:" are not counted there.

Exit status: 0 all is so; 1 not, a line each; 77 a repository cannot be had.
"""
import collections
import concurrent.futures
import fnmatch
import hashlib
import json
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
CZT = "community-z-users/czt"
CZT_MEMORY = "-Xmx512m"  # a message of CZT's about parents of parents doubles with each, and may end in no text
LEAST_SHARE = 0.95
NO_Z = "no Z to read: "
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


def asked_of_czt(jar, paths):
    """What CZT says of each file: its lines, one a file, among those that it prints of its own accord."""
    words = ["java", CZT_MEMORY, "-cp", jar, str(HERE / "CztCorpus.java"), *map(str, paths)]
    done = subprocess.run(words, capture_output=True, check=False)
    answers = dict(re.findall(r"^(/.*?) (accepted|refused .*)$", done.stdout.decode("utf-8", "replace"), re.M))
    left = [str(path) for path in paths if str(path) not in answers]
    if left:
        sys.exit(f"CZT said nothing of {left[0]}: {done.stderr.decode('utf-8', 'replace')[-300:]}")
    return answers


def of_czt(folder, texts):
    """What CZT says of each text, kept for this CZT, these commits and this way to ask; or that it is absent."""
    jar = os.environ.get("CZT_JAR")
    if not jar:
        return {name: ("?", "") for name, _, _ in texts}
    sources = [*map(pathlib.Path, jar.split(":")), HERE / "CztCorpus.java", HERE / "public_corpus.tsv"]
    key = hashlib.sha256(b"".join(source.read_bytes() for source in sources)).hexdigest()
    kept = folder / f"czt-{key[:16]}.json"
    if kept.exists():
        return json.loads(kept.read_text(encoding="utf-8"))
    answers = asked_of_czt(jar, [path for _, path, _ in texts])
    said_of = {name: ("yes", "") if answers[str(path)] == "accepted" else ("no", answers[str(path)][:400])
               for name, path, _ in texts}
    kept.write_text(json.dumps(said_of, indent=0), encoding="utf-8")
    return said_of


def libraries(clone, repository):
    """The sections that CZT brings along for Z, by name, and finds wherever a text is."""
    folder = clone / "parser/parser-z/src/main/resources/lib"
    return {file.stem: file for file in sorted(folder.glob("*.tex"))} if repository == CZT else {}


def placed(durero, path, sections, there):
    """The text, where its parents are found: where it is, or in a folder with its neighbours and CZT's sections."""
    status, told = said([durero, "spec", "check", "--states", "0", path.name], path.parent)
    missing = re.search(r"unknown parent (\S+);", told)
    if status == 0 or not missing or missing[1] not in sections:
        return path
    folder = pathlib.Path(tempfile.mkdtemp(dir=there))
    for file in [*path.parent.iterdir(), *sections.values()]:
        link = folder / file.name
        if file.suffix in ENDINGS and not link.exists():
            link.symlink_to(file)
    return folder / path.name


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


def judge(durero, fuzz, czt, name, path, text, place):
    by_fuzz, told_by_fuzz = of_fuzz(fuzz, path, text)
    by_czt, told_by_czt = czt[name]
    by_durero, told = of_durero(durero, place)
    if by_durero == "yes":
        told = f"{told_by_fuzz if by_fuzz == 'no' else ''} {told_by_czt}".strip()
    return Judged(name, by_fuzz, by_czt, by_durero, told)


def differs(one):
    """Whether others think otherwise of a text; or whether Durero refuses it, where no other could be asked."""
    others = {one.fuzz, one.czt} - {"-", "?"}
    accepted = "yes" if one.durero == "yes" else "no"
    return bool(others - {accepted}) if others else accepted == "no" and "?" not in (one.fuzz, one.czt)


def is_of(row, one):
    files, fuzz, czt, durero, message, _ = row
    said_so = zip((fuzz, czt, durero), (one.fuzz, one.czt, one.durero))
    return (fnmatch.fnmatchcase(one.path, files) and all(wanted in ("*", got) or got == "?" for wanted, got in said_so)
            and message in one.message)


def row_of(one, table):
    """The number of the first row of a difference, or None."""
    return next((i for i, row in enumerate(table) if is_of(row, one)), None)


def has_no_z(one, table):
    """Whether the table says that there is no Z to read in a text that others take."""
    row = row_of(one, table) if differs(one) else None
    return row is not None and table[row][-1].startswith(NO_Z)


def check(all_judged, table):
    failures = []
    used = collections.Counter()
    for one in filter(differs, all_judged):
        row = row_of(one, table)
        if row is not None:
            used[row] += 1
        else:
            failures.append(f"no row: {one.path}: fuzz {one.fuzz}, CZT {one.czt}, Durero {one.durero}: "
                            f"{one.message[:160]}")
    absent = [getattr(all_judged[0], one) == "?" for one in ("fuzz", "czt")]
    for i, row in enumerate(table):
        if not used[i] and not any(gone and wanted != "-" for gone, wanted in zip(absent, row[1:3])):
            failures.append("no longer so: " + "\t".join(row))
    return failures, used


def main():
    durero = str(pathlib.Path(sys.argv[1]).resolve())
    fuzz = os.environ.get("DURERO_FUZZ") or shutil.which("fuzz")
    folder = pathlib.Path(os.environ.get("DURERO_Z_CORPUS") or "z-corpus").resolve()
    texts, seen, sections = [], set(), {}
    for repository, commit, _ in rows("public_corpus.tsv"):
        clone = cloned(folder, repository, commit)
        if clone is None:
            print(f"skipped: {repository} cannot be had at {commit}")
            return 77
        texts += z_files(clone, repository, seen)
        sections |= libraries(clone, repository)
    czt = of_czt(folder, texts)
    with concurrent.futures.ThreadPoolExecutor(2) as pool, tempfile.TemporaryDirectory() as there:
        places = list(pool.map(lambda each: placed(durero, each[1], sections, there), texts))
        judged = list(pool.map(lambda each, place: judge(durero, fuzz, czt, *each, place), texts, places))
        accepted = [(one.path, place) for one, place in zip(judged, places) if one.durero == "yes"]
        became = list(pool.map(lambda each: conversion(durero, fuzz, *each), accepted))
    judged_again = [one for one in became if isinstance(one, Judged)]
    table = list(rows("public_differences.tsv"))
    failures, used = check(judged + judged_again, table)
    taken = [one for one in judged if "yes" in (one.fuzz, one.czt) and not has_no_z(one, table)]
    read = sum(one.durero != "no" for one in taken)
    print(f"{len(judged)} files; Durero reads {sum(one.durero != 'no' for one in judged)} and accepts "
          f"{sum(one.durero == 'yes' for one in judged)}; of the {len(taken)} with Z that fuzz or CZT accepts, it reads {read} and "
          f"accepts {sum(one.durero == 'yes' for one in taken)}; {sum(used.values())} differences in {len(table)} rows; "
          f"of the {len(accepted)} that it accepts {became.count('written')} are converted, {became.count('refused')} refused")
    if read < LEAST_SHARE * len(taken):
        failures.append(f"of the files with Z that fuzz or CZT accepts Durero reads less than {LEAST_SHARE:.0%}")
    print("\n".join(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
