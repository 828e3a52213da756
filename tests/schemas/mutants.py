"""mutants.py DURERO ROOT [--seed N] [--count N] [--only SUBJECT:NUMBER]: files that are changed, some on purpose and
most at random, are judged by their schema and by the program's reader. Both must say the same, but for what JSON Schema
cannot say (differences.py): a file that the schema accepts is accepted by the program if and only if no class of
differences applies to it. Each class must be met, and docs/formats.md must list it."""
import argparse
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile

import differences
import samples
import trees
from schemas import Schemas, parsed


class Reader:
    """How a subject is given to the program, and what share of all mutants are its."""

    def __init__(self, good, share, file, *arguments):
        self.good, self.share, self.file, self.arguments = good, share, file, [*arguments]

    def complaint(self, text):
        """The program's error about the text; empty where it accepts it."""
        pathlib.Path(self.file).write_text(text, encoding="utf-8", errors="surrogatepass")
        done = subprocess.run([durero, *self.arguments], capture_output=True, text=True, check=False,
                              stdin=subprocess.DEVNULL)
        if done.returncode not in (0, 1, 2):
            sys.exit(f"durero {' '.join(self.arguments)}: status {done.returncode}: {done.stderr}\n{text}")
        return done.stderr if done.stderr.startswith(f"durero: {self.file}:") else ""


JUDGE = ["conform", "judge", "none", "none", "--profile", "mutant.json"]  # a profile is read before the suite
READERS = {
    "scene": Reader([samples.SCENE], 0.36, "mutant.json", "check", "mutant.json"),
    "operation": Reader(samples.OPERATIONS, 0.2, "mutant.ops", "edit", "scene.json", "--script", "mutant.ops"),
    "hit": Reader(samples.HITS, 0.1, "mutant.hits", "spec", "confirm", "scene.json", "rays", "mutant.hits"),
    "claim": Reader(samples.CLAIMS, 0.1, "mutant.jsonl", "conform", "judge", "suite", "mutant.jsonl", "--profile",
                    "durero"),
    "profile": Reader(samples.PROFILES, 0.08, "mutant.json", *JUDGE),
    "system": Reader(samples.SYSTEMS, 0.08, "mutant.json", *JUDGE),
    "campaign": Reader(samples.CAMPAIGNS, 0.08, "mutant.json", "conform", "merge", "mutant.json", "none")}


def planted(subject):
    """The first sample with each of its changes alone, and with its first key once more at its end."""
    good = READERS[subject].good[0]
    key, value = trees.read(good).pairs[0]
    mutants = [f'{good[:-1]},"{key}":{trees.write(value)}}}']
    for row in samples.CHANGES[subject].strip().splitlines():
        old, *others = row.strip().split(" | ")
        if old not in good:
            sys.exit(f"no {old} in {good}")
        mutants += [good.replace(old, new) for new in others]
    return mutants


def drawn(subject, number):
    stream = random.Random(f"{call.seed}:{subject}:{number}")
    return trees.mutant(stream, stream.choice(READERS[subject].good))


def judge(subject, number, text, how):
    """Answers the classes that applied, whether schema and program said what they should, and whether the schema
    accepts it."""
    accepted = schemas.accepts(subject, text)
    classes = differences.classes_of(text, CLASSES[subject]) if accepted else []
    complaint = READERS[subject].complaint(text)
    right = (complaint == "") == (accepted and not classes)
    if not right or call.only:
        print(f"{'agreed' if right else 'DIFFERENCE'}: {subject}:{number} ({how}): the schema "
              f"{'accepts' if accepted else 'refuses'}, the program {'refuses' if complaint else 'accepts'}; "
              f"classes {classes}; {complaint.strip()}\n  {text}\n"
              f"  replay: python3 tests/schemas/mutants.py DURERO ROOT --seed {call.seed} --only {subject}:{number}")
    return classes, right, accepted


def listed_classes():
    """Of docs/formats.md: subject and class of each row."""
    page = pathlib.Path(call.root, "docs/formats.md").read_text(encoding="utf-8")
    table = page.split("<!-- differences:begin -->")[1].split("<!-- differences:end -->")[0]
    return {(subject, name) for subjects, name in re.findall(r"^\| ([a-z, ]+) \| ([^|]+) \|", table, re.M)
            for subject in subjects.split(", ") if subject != "format"}


def output_of(*arguments):
    return subprocess.run([durero, *arguments], check=True, capture_output=True, text=True).stdout


parser = argparse.ArgumentParser()
parser.add_argument("durero", type=os.path.abspath)
parser.add_argument("root", type=os.path.abspath)
parser.add_argument("--seed", type=int, default=1)
parser.add_argument("--count", type=int, default=600)
parser.add_argument("--only")
call = parser.parse_args()
durero, schemas = call.durero, Schemas(call.root)
bad, refused, met, asked = 0, 0, set(), 0
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    pathlib.Path("scene.json").write_text(samples.SCENE, encoding="utf-8")
    pathlib.Path("rays").write_text(samples.RAYS)
    output_of("conform", "make", "suite", "--family", "generic", "--rays", "2")
    claimed_on = parsed(pathlib.Path("suite/generic/0000.scene.json").read_text())
    CLASSES = differences.classes(differences.values(claimed_on, "id"),
                                  re.findall(r"^(\w+) ", output_of("conform", "list"), re.M))
    for subject, reader in READERS.items():
        for good in reader.good:
            if not schemas.accepts(subject, good) or reader.complaint(good):
                sys.exit(f"a sample of {subject} is refused: {reader.complaint(good)}\n{good}")
        mutants = [(text, "planted") for text in planted(subject)]
        mutants += [drawn(subject, number) for number in range(len(mutants), round(call.count * reader.share))]
        for number, (text, how) in enumerate(mutants):
            if call.only in (None, f"{subject}:{number}"):
                classes, right, accepted = judge(subject, number, text, how)
                met |= {(subject, name) for name in classes}
                asked, bad, refused = asked + 1, bad + (not right), refused + (not accepted)
print(f"--seed {call.seed}: {asked} mutants, {refused} refused by their schema, {bad} differences that are not listed")
known = {(subject, name) for subject, of_subject in CLASSES.items() for name in of_subject}
for what, classes in [("docs/formats.md does not list", known - listed_classes()),
                      ("docs/formats.md lists what nothing tests:", listed_classes() - known),
                      ("no mutant met", set() if call.only else known - met)]:
    for subject, name in sorted(classes):
        bad += 1
        print(f"FAILED: {what} {subject}: {name}")
sys.exit(bad > 0 or (not call.only and asked < 500))
