#!/usr/bin/env python3
"""The states of machines, counted by ProB and by durero spec explore: the same, operation by operation.

    prob.py DURERO

PROBCLI is the program probcli of ProB, in its folder; fuzz, which it reads Z with, and fuzzlib stand in lib beside it.
Maven Central has probcli for Linux in de.hhu.stups:de.prob2.kernel:3.2.11, as cli/probcli_linux64.zip.

Each machine is explored with two members of each given set: the birthday book, the machines of MACHINES, 24 that are put
together at random, and those of PUBLIC, where the folder DURERO_Z_CORPUS has them (public_corpus.py clones it). The text goes to
ProB in Spivey's Z, as durero spec convert writes it, with its initial schema named Init, as ProB asks. ProB takes for operations
the schemas that no other one uses, be it that they have no state. It counts the initial steps, too, and a state and a step
that set constants.

DURERO_SEED begins the random machines, whose number is printed where one differs.
Exit status: 0 the same; 1 not, a line each; 77 ProB is absent.
"""
import json
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
MEMBERS = 2
RANDOM_MACHINES = 24
MOST_STEPS = 1000  # of one operation from one state, beyond what any machine here has

MACHINES = {
    "a counter that stops": r"""
\begin{schema}{S} n : 0 \upto 3 \end{schema}
\begin{schema}{Init} S~' \where n' = 0 \end{schema}
\begin{schema}{Up} \Delta S \where n' = n + 1 \end{schema}
""",
    "a mailbox": r"""
\begin{zed} [MSG, ADDR] \end{zed}
\begin{zed} Flag ::= seen | unseen \end{zed}
\begin{schema}{Box} msgs : \power MSG \\ flag : MSG \pfun Flag \\ from : MSG \pfun ADDR \where
  \dom flag = msgs \\ \dom from = msgs \\ \# msgs \leq 1 \end{schema}
\begin{schema}{Init} Box~' \where msgs' = \emptyset \\ flag' = \emptyset \\ from' = \emptyset \end{schema}
\begin{schema}{Take} \Delta Box \\ m? : MSG \\ sender? : ADDR \where m? \notin msgs \\
  msgs' = msgs \cup \{m?\} \\ flag' = flag \cup \{m? \mapsto unseen\} \\ from' = from \cup \{m? \mapsto sender?\} \end{schema}
\begin{schema}{Read} \Delta Box \\ m? : MSG \where m? \in msgs \\ flag(m?) = unseen \\ msgs' = msgs \\ from' = from \\
  flag' = flag \oplus \{m? \mapsto seen\} \end{schema}
\begin{schema}{Drop} \Delta Box \\ m? : MSG \where m? \in msgs \\ msgs' = msgs \setminus \{m?\} \\
  flag' = \{m?\} \ndres flag \\ from' = \{m?\} \ndres from \end{schema}
\begin{schema}{Count} \Xi Box \\ count! : 0 \upto 2 \where count! = \# \{~ m : msgs | flag(m) = unseen ~\} \end{schema}
""",
    "a queue": r"""
\begin{zed} [X] \end{zed}
\begin{schema}{Q} q : \seq X \\ open : \power X \where \# q \leq 2 \end{schema}
\begin{schema}{Init} Q~' \where q' = \langle \rangle \\ open' = \emptyset \end{schema}
\begin{schema}{Push} \Delta Q \\ x? : X \where q' = q \cat \langle x? \rangle \\ open' = open \end{schema}
\begin{schema}{Pop} \Delta Q \\ x! : X \where q \neq \langle \rangle \\ x! = head~q \\ q' = tail~q \\ open' = open \end{schema}
\begin{schema}{Loose} \Delta Q \where q' = q \\ open' \subseteq \ran q \end{schema}
\begin{schema}{Turn} \Delta Q \where \exists a, b : X @ q = \langle a, b \rangle \land q' = \langle b, a \rangle \\ open' = open \end{schema}
""",
    "two items, promoted": r"""
\begin{zed} [K] \end{zed}
\begin{schema}{Item} v : 0 \upto 2 \\ on : 0 \upto 1 \end{schema}
\begin{schema}{Step} \Delta Item \where v < 2 \\ v' = v + 1 \\ on' = 1 - on \end{schema}
\begin{schema}{All} items : K \pfun Item \end{schema}
\begin{schema}{Init} All~' \where items' = \emptyset \end{schema}
\begin{schema}{New} \Delta All \\ k? : K \where k? \notin \dom items \\
  items' = items \cup \{ k? \mapsto (\mu Item | v = 0 \land on = 0) \} \end{schema}
\begin{schema}{One} \Delta All \\ \Delta Item \\ k? : K \where k? \in \dom items \\ \theta Item = items(k?) \\
  items' = items \oplus \{ k? \mapsto \theta Item~' \} \end{schema}
\begin{zed} StepOne == \exists \Delta Item @ One \land Step \end{zed}
""",
}

# Other people's machines in Spivey's Z, of punt-labs/z-spec.
PUBLIC = [
    "examples/animation-hints-bad.tex", "examples/animation-hints-good.tex", "examples/oracle-protocol.tex",
    "examples/search-panel.tex", "plugin/tutorials/intro/06-initialization.tex", "plugin/tutorials/intro/10-complete-spec.tex",
    *(f"tests/fixtures/probcli/specs/{name}-bad.tex" for name in (
        "animate-deadlock", "covered-then-deadlock", "deadlock", "unreachable-deadlock", "unreachable-operation", "xi-frame")),
]
STATELESS = {"Assignment", "Success"}  # the schemas of these without a state

# The machines that ProB does not carry out, with a part of what it says and the reason.
LIMITS = {
    "two items, promoted": ("Cannot expand custom set",
                            "ProB takes the members of a given set for no set where schemas are quantified"),
}

INVARIANTS = [r"\# s \leq 2", r"n \leq 2 \\ \dom f \subseteq s", r"\# f \leq n + 2"]
FACTS = [
    r"x? \in s", r"x? \notin s", "n < 2", r"x? \mapsto k? \in f", r"\# s = n", r"x? \in \dom f",
    r"\exists y : s @ y \neq x?", r"\forall y : s @ y \in \dom f", r"k? = 0 \implies x? \in s", r"n \mod 2 = k?",
    r"\lnot (x? \in s \land n = 0)", r"(n = 0 \iff s = \emptyset)", r"f \limg \{x?\} \rimg \subseteq \{k?\}",
    r"\exists_1 y : X @ y \in s", r"n - k? < 2", r"(x?, k?) \in f \lor n = k?",
]
AFTER_SET = [
    "s' = s", r"s' = s \cup \{x?\}", r"s' = s \lor s' = \{x?\}", r"s' = s \setminus \{x?\}", r"s' = \dom f'",
    r"s' \subseteq s", r"s' = \{~ y : X | y \notin s ~\}", r"(x? \in s \land s' = \{x?\}) \lor (x? \notin s \land s' = s)",
    r"\# s' = k?",
]
AFTER_FUNCTION = [
    "f' = f", r"f' = f \oplus \{x? \mapsto k?\}", r"f' = f \cup \{x? \mapsto k?\}", r"f' = \{x?\} \ndres f",
    r"f' = s \dres f", r"f' = (\lambda y : s @ k?)", r"f' = f \nrres \{k?\}", r"\dom f' = \dom f",
    r"f' = \{~ y : s; z : 0 \upto 1 | z = n \div 2 @ y \mapsto z ~\}",
]
AFTER_NUMBER = [
    "n' = n", "n' = n + 1", "n' + k? = n", "n' > n", r"n' \in \{0, n\}", r"n' = \# s'", "n = 2 - n'",
    r"(n' = n \land k? = 0) \lor (n' = 0 \land k? = 1)", r"k? = 1 \implies n' = n",
]
OUTPUTS = ["r! = n", r"r! = \# s", "r! = n' + k?", r"r! = (\mu y : 0 \upto 3 | y = n)", "r! < 1", r"r! = max~\{n, k?\}"]


def schema(name, declarations, predicates):
    return f"\\begin{{schema}}{{{name}}} {declarations} \\where {predicates} \\end{{schema}}\n"


def random_machine(seed):
    """A machine with a set, a function and a number."""
    chosen = random.Random(seed).choice
    text = "\\begin{zed} [X] \\end{zed}\n"
    text += schema("S", r"s : \power X \\ f : X \pfun 0 \upto 1 \\ n : 0 \upto 2", chosen(INVARIANTS))
    text += schema("Init", "S~'", r"s' = \emptyset \\ f' = \emptyset \\ n' = 0")
    for name in "ABC":
        parts = [chosen(each) for each in (FACTS, FACTS, AFTER_SET, AFTER_FUNCTION, AFTER_NUMBER, OUTPUTS)]
        text += schema(name, r"\Delta S \\ x? : X \\ k? : 0 \upto 1 \\ r! : 0 \upto 3", r" \\ ".join(parts))
    return text


def said(words, **more):
    done = subprocess.run(words, capture_output=True, text=True, errors="replace", timeout=300, check=False, **more)
    return done.returncode, done.stdout + done.stderr


def by_durero(durero, file):
    """How many states, initial states and deadlocks there are, and steps by operation."""
    status, told = said([durero, "spec", "explore", "--json", "--plain", "--members", str(MEMBERS), str(file)])
    try:
        found = json.loads(told[told.index("{"):])
    except ValueError:
        raise SystemExit(f"durero spec explore, status {status}: {told}") from None
    if found["stopped"] or found["bounded"]:
        raise SystemExit(f"durero spec explore did not end: {found['bounded']}")
    steps = {one["name"]: one["transitions"] for one in found["operations"]}
    return (found["states"], found["initial"], found["deadlocks"]), steps, found["init"]


def by_prob(probcli, file):
    """The same by ProB, which has one state more, before the initial ones; or what it says instead."""
    words = [str(probcli), "-mc", "1000000", "-nodead", "-c", "-p", "DEFAULT_SETSIZE", str(MEMBERS), "-p", "MAX_OPERATIONS",
             str(MOST_STEPS), "-p", "MAX_INITIALISATIONS", str(MOST_STEPS), "-p", "MAXINT", "3", "-p", "MININT", "0", str(file)]
    told = said(words, cwd=probcli.parent, env=dict(os.environ, LD_LIBRARY_PATH="lib"))[1]
    whole = "ALL nodes visited" in told
    counted = re.search(r"\[STATES,(.*),TOTAL_OPERATIONS,.*,COVERED_OPERATIONS,(.*),UNCOVERED_OPERATIONS(.*)\]", told)
    if not whole or not counted:
        return None, told
    states, covered = (dict(re.findall(r"(\w+):(\d+)", part)) for part in counted.groups()[:2])
    steps = {name: int(count) for name, count in covered.items()} | dict.fromkeys(re.findall(r"\w+", counted[3]), 0)
    more = 1 + steps.pop("SETUP_CONSTANTS", 0)
    return ((int(states["total"]) - more, steps.pop("INITIALISATION"), int(states["deadlocked"])), steps), told


def differences(durero, probcli, text, in_spivey):
    """What ProB counts otherwise, a line each; and the number of states."""
    with tempfile.TemporaryDirectory() as there:
        file, spivey = pathlib.Path(there) / "machine.tex", pathlib.Path(there) / "spivey.tex"
        file.write_text(text, encoding="utf-8")
        counts, steps, init = by_durero(durero, file)
        status, told = 0, ""
        if in_spivey:
            spivey.write_text(text, encoding="utf-8")
        else:
            status, told = said([durero, "spec", "convert", str(file), "--to", "spivey", "-o", str(spivey)])
        if status != 0:
            return [told], 0
        spivey.write_text(re.sub(rf"\b{init}\b", "Init", spivey.read_text(encoding="utf-8")), encoding="utf-8")
        answer, told = by_prob(probcli, spivey)
        if answer is None:
            return ["ProB: " + " ".join(line for line in told.splitlines() if "! " in line)], counts[0]
    found = []
    if counts != answer[0]:
        found.append(f"(states, initial, deadlocks): {counts} by Durero, {answer[0]} by ProB")
    for name, count in answer[1].items():
        if steps.get(name) != count and not (name in STATELESS and name not in steps):
            found.append(f"steps of {name}: {steps.get(name)} by Durero, {count} by ProB")
    return found, counts[0]


def public_machines():
    """The texts of PUBLIC by name; none where no corpus is named; None where one is, and lacks a text."""
    corpus = os.environ.get("DURERO_Z_CORPUS")
    if not corpus:
        return {}
    folder = pathlib.Path(corpus) / "punt-labs+z-spec"
    lacking = [name for name in PUBLIC if not (folder / name).exists()]
    if lacking:
        print(f"{folder} lacks {lacking[0]}")
        return None
    return {name: (folder / name).read_text(encoding="utf-8") for name in PUBLIC}


def main():
    durero = str(pathlib.Path(sys.argv[1]).resolve())
    if not os.environ.get("PROBCLI"):
        print("skipped: ProB absent (set PROBCLI to the path of probcli)")
        return 77
    probcli = pathlib.Path(os.environ["PROBCLI"]).resolve()
    first = int(os.environ.get("DURERO_SEED", "20261129"))
    machines = {"the birthday book": (ROOT / "demo/birthday_book.tex").read_text(encoding="utf-8"), **MACHINES}
    machines |= {f"DURERO_SEED={seed}": random_machine(seed) for seed in range(first, first + RANDOM_MACHINES)}
    public = public_machines()
    if public is None:
        return 1
    failures, states = 0, 0
    for name, text in (machines | public).items():
        found, size = differences(durero, probcli, text, name in public)
        states += size
        if name in LIMITS:
            part, reason = LIMITS[name]
            found = [] if found and part in found[0] else [f"no longer so: {reason}", *found]
        failures += bool(found)
        for line in found:
            print(f"{name}: {line}")
    count = len(machines) + len(public)
    alike = count - len(LIMITS) - failures
    print(f"{count} machines, {states} states: {alike} are counted alike by ProB, {len(LIMITS)} are beyond it")
    return 1 if failures or states <= count else 0


if __name__ == "__main__":
    sys.exit(main())
