"""Stores that are killed, shared, full and read-only: `FILE DURERO [TEST...]`. What was answered is kept, and nothing that
was refused. Events are read by Python's own SQLite, which knows nothing of the program."""
import contextlib
import hashlib
import json
import os
import random
import shutil
import signal
import sqlite3
import struct
import subprocess
import sys
import time

home = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, home)
from running import run_tests  # noqa: E402

durero = sys.argv[1]
PATIENCE = 120  # seconds
EMPTY = '{"format":"durero-scene","version":1,\n"elementos":[]}\n'


def run(*arguments, status=0, **how):
    done = subprocess.run([durero, "store", *arguments], capture_output=True, text=True, timeout=PATIENCE, **how)
    assert done.returncode == status, (arguments, done.returncode, done.stdout[-500:], done.stderr)
    return done


def operation(name):
    return f"Agregar_Esfera e?={name} centro?=(0,0,0) radio?=1"


def opened(store="s.store"):
    """A database that is closed at the end of its block. One that stays open keeps the next program from looking for what
    a killed one has written and not answered, which may come to light later."""
    return contextlib.closing(sqlite3.connect(store))


def kept(store="s.store", behind=1):
    """The operations of the events behind one, in order."""
    with opened(store) as database:
        return [row[0] for row in database.execute("SELECT operation FROM event WHERE number > ? ORDER BY number", (behind,))]


def head_operations(store="s.store"):
    """The operations from HEAD back to the import, in order."""
    told = [json.loads(line) for line in run("log", store, "--json").stdout.splitlines()]
    return [event["operation"] for event in reversed(told) if "operation" in event]


def accepted(answers):
    """The lines that were answered with ok. What is no whole line was not answered."""
    return [answer["line"] for answer in map(json.loads, answers.split("\n")[:-1]) if answer["ok"]]


class Killed:
    """A store whose programs are killed again and again, with what it must hold."""
    store, new = "s.store", "new.store"

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.names = 0
        self.lasts = {}  # seconds that a command takes
        self.renew()

    def clear(self):
        for file in os.listdir("."):
            os.unlink(file)

    def kept(self, behind):
        return kept(self.store, behind)

    def is_there(self):
        """Whether the new store is there; a part of it is not."""
        assert [file for file in os.listdir(".") if file.endswith(".part")] == []
        return os.path.exists(self.new) and os.path.getsize(self.new) > 0

    def forget(self):
        if os.path.exists(self.new):
            os.unlink(self.new)

    def renew(self):
        self.clear()
        run("init", self.store)
        self.behind, self.way = 1, []  # the last event, and the operations up to HEAD

    def killed(self, *arguments, text=""):
        """What the command printed before it was killed, or ended."""
        known = arguments[0]
        with open("out", "w+") as out:
            begin = time.monotonic()
            process = subprocess.Popen([durero, "store", *arguments], stdin=subprocess.PIPE, stdout=out,
                                       stderr=subprocess.DEVNULL, text=True)
            try:
                process.stdin.write(text)
                process.stdin.close()
            except BrokenPipeError:
                pass
            if known in self.lasts:
                time.sleep(max(0, self.random.uniform(0, 1.2) * self.lasts[known] - (time.monotonic() - begin)))
                process.send_signal(signal.SIGKILL)
            process.wait(PATIENCE)
            self.lasts.setdefault(known, time.monotonic() - begin)
            out.seek(0)
            return out.read()

    def edit(self):
        """Some operations are refused; those that are accepted are kept in order, and each that was answered is."""
        group = self.random.choice([1, 3, 10])
        script, good = [], []
        for _ in range(30):
            if self.random.random() < 0.3 and self.way + good:
                script.append(self.random.choice(self.way + good))  # a name that is taken
            else:
                self.names += 1
                script.append(operation(f"n{self.names}"))
                good.append(script[-1])
        answered = [script[line - 1] for line in
                    accepted(self.killed("edit", self.store, "--group", str(group), text="\n".join(script) + "\n"))]
        new = self.kept(self.behind)
        assert answered == good[:len(answered)], "an operation was answered that is none of the accepted"
        assert new == good[:len(new)], f"kept {new} of {good}, answered {answered}, group {group}"
        assert len(new) >= len(answered), f"lost: {good[len(new):len(answered)]}"
        self.behind += len(new)
        self.way += new

    def undo(self):
        """HEAD is where it was, or a transaction before."""
        said = self.killed("undo", self.store)
        now = head_operations(self.store)
        assert now == self.way[:len(now)], "an undo goes elsewhere"
        assert not said.endswith("\n") or not self.way or len(now) < len(self.way), "an undo that was answered is lost"
        self.way = now

    def redo(self):
        said = self.killed("redo", self.store)
        now = head_operations(self.store)
        assert now[:len(self.way)] == self.way, "a redo goes elsewhere"
        assert "no undo" in said or not said.endswith("\n") or len(now) > len(self.way), "a redo that was answered is lost"
        self.way = now

    def tag(self):
        self.names += 1
        said = self.killed("tag", self.store, f"t{self.names}") is not None
        tags = dict(line.split("  ") for line in run("tag", self.store).stdout.splitlines())
        assert said and set(tags.values()) <= {str(number) for number in range(self.behind + 1)}

    def init(self):
        """The store is there whole, or not at all, and another init goes on."""
        self.forget()
        said = self.killed("init", self.new)
        is_there = self.is_there()
        assert is_there or not said, "a store that was answered is lost"
        if not is_there:
            run("init", self.new)
        run("verify", self.new)

    def go(self, kills):
        for number in range(kills):
            self.random.choices([self.edit, self.undo, self.redo, self.tag, self.init], [12, 3, 2, 1, 1])[0]()
            if number % 50 == 49:
                run("verify", self.store)
                assert head_operations(self.store) == self.way
                run("export", self.store, "-o", "exported.json")
                with open("exported.json") as file:
                    assert sorted(element["id"] for element in json.load(file)["elementos"]) == \
                        sorted(line.split("e?=")[1].split()[0] for line in self.way)
                self.renew()


def test_200_kills_lose_nothing_that_was_answered_and_keep_nothing_that_was_refused():
    Killed(20260131).go(200)


def long_10000_kills():
    seed = random.SystemRandom().randrange(2**32)
    print("  seed", seed, flush=True)
    Killed(seed).go(10_000)


def test_60_programs_edit_one_store_at_a_time():
    run("init", "s.store")
    started = [subprocess.Popen([durero, "store", "edit", "s.store", "--op", operation(f"p{number}")],
                                stdout=subprocess.DEVNULL) for number in range(60)]
    assert [process.wait(PATIENCE) for process in started] == [0] * 60
    assert sorted(kept()) == sorted(operation(f"p{number}") for number in range(60))
    assert head_operations() == kept()
    run("verify", "s.store")


def test_two_programs_that_add_the_same_names_share_them():
    run("init", "s.store")
    script = "".join(operation(f"n{number}") + "\n" for number in range(100))
    started = [subprocess.Popen([durero, "store", "edit", "s.store", "--group", "1"], stdin=subprocess.PIPE,
                                stdout=subprocess.PIPE, text=True) for _ in range(2)]
    for process in started:
        process.stdin.write(script)
        process.stdin.close()
    answers = [accepted(process.stdout.read()) for process in started]
    for process in started:
        process.wait(PATIENCE)
        process.stdout.close()
    assert sorted(answers[0] + answers[1]) == list(range(1, 101)), "each name is accepted once"
    assert len(kept()) == 100
    run("verify", "s.store")


def read_beside_a_writer(store):
    """Writes 400 elements, four a transaction, and reads all the while. Precondition: the store is empty."""
    script = "".join(operation(f"n{number:04}") + "\n" for number in range(1, 401))
    with subprocess.Popen([durero, "store", "edit", store, "--group", "4"], stdin=subprocess.PIPE,
                          stdout=subprocess.DEVNULL, text=True) as writer:
        writer.stdin.write(script)
        writer.stdin.close()
        seen, last = 0, -1
        while True:
            is_done = writer.poll() is not None
            ids = [element["id"] for element in json.loads(run("export", store).stdout)["elementos"]]
            assert ids == [f"n{number:04}" for number in range(1, len(ids) + 1)], "a reader sees what never was"
            assert len(ids) % 4 == 0 and len(ids) >= last, "a reader sees a part of a transaction, or goes back"
            seen, last = seen + 1, len(ids)
            if is_done:
                break
    assert last == 400 and seen > 1


def test_readers_beside_a_writer_see_whole_transactions():
    run("init", "s.store")
    read_beside_a_writer("s.store")


def in_namespace(script):
    """Runs a script of the shell where mounts are its own; nothing where that is not allowed."""
    try:
        if subprocess.run(["unshare", "--mount", "true"], capture_output=True).returncode != 0:
            raise PermissionError
    except (FileNotFoundError, PermissionError):
        print("  skipped: no mounts of its own are allowed here")
        return None
    return subprocess.run(["unshare", "--mount", "sh", "-euc", script, "sh", durero], capture_output=True, text=True,
                          timeout=PATIENCE)


def test_a_full_disk_keeps_what_was_answered():
    with open("script", "w") as file:
        file.writelines(operation(f"n{number}") + "\n" for number in range(20_000))
    done = in_namespace("""
        mkdir full && mount -t tmpfs -o size=400k none full
        "$1" store init full/s.store >/dev/null
        "$1" store edit full/s.store --script script --group 50 >answers 2>said && status=0 || status=$?
        [ "$status" = 2 ]
        "$1" store verify full/s.store >verified || { cat verified; exit 1; }
        "$1" store export full/s.store >exported.json
        dd if=/dev/zero of=full/more bs=1k 2>/dev/null || :
        "$1" store edit full/s.store --script script --group 50 >>answers 2>>said && status=0 || status=$?
        [ "$status" = 2 ]
        "$1" store show full/s.store >/dev/null
        ! "$1" store init full/other.store 2>>said
        [ ! -e full/other.store ]
        rm full/more
        "$1" store verify full/s.store >/dev/null
        cp full/s.store* .
        """)
    if done is None:
        return
    assert done.returncode == 0, (done.stdout, done.stderr)
    with open("said") as file:
        lines = file.read().splitlines()
    assert len(lines) == 3 and all("cannot be written: No space left on device; expected" in line for line in lines), lines
    with open("answers") as file:
        answered = accepted(file.read())
    assert answered and len(answered) % 50 == 0
    assert kept()[:len(answered)] == [operation(f"n{line - 1}") for line in answered]
    run("edit", "s.store", "--op", operation("more"))  # with room again
    run("verify", "s.store")


def test_a_store_that_cannot_be_written_is_read():
    run("init", "s.store")
    run("edit", "s.store", "--op", operation("a"))
    done = in_namespace("""
        mkdir read && cp s.store read && mount -t tmpfs none "$(mktemp -d)" && mount --bind read read
        mount -o remount,ro,bind read
        for command in log show export verify blame branch; do "$1" store $command read/s.store >$command; done
        "$1" store edit read/s.store --op 'Eliminar_Esfera e=a' 2>said && status=0 || status=$?
        [ "$status" = 2 ]
        "$1" store undo read/s.store 2>>said && status=0 || status=$?
        [ "$status" = 2 ]
        """)
    if done is None:
        return
    assert done.returncode == 0, (done.stdout, done.stderr)
    with open("said") as file:
        lines = file.read().splitlines()
    assert len(lines) == 2 and all(line.startswith("durero: read/s.store: cannot be ") for line in lines), lines
    with open("export") as file:
        assert '"id":"a"' in file.read()


def test_a_journal_that_is_spoiled_leaves_an_earlier_transaction():
    """What a killed program has left beside the store: a part of it that is not whole is as if it had not come."""
    run("init", "s.store")
    script = "".join(operation(f"n{number}") + "\n" for number in range(40))
    with opened() as holding:  # another program has it open, so that its journal stays
        holding.execute("SELECT count(*) FROM event").fetchall()
        run("edit", "s.store", "--group", "4", input=script)
        shutil.copy("s.store", "base"), shutil.copy("s.store-wal", "journal")
    with open("journal", "rb") as file:
        journal = file.read()
    chance, lengths = random.Random(7), set()
    for number in range(60):
        spoiled = bytearray(journal)
        if number % 2:
            spoiled[chance.randrange(len(spoiled))] ^= 1 << chance.randrange(8)
        else:
            spoiled = spoiled[:chance.randrange(len(spoiled))]
        for file in ("t.store", "t.store-wal", "t.store-shm"):
            if os.path.exists(file):
                os.unlink(file)
        shutil.copy("base", "t.store")
        with open("t.store-wal", "wb") as file:
            file.write(spoiled)
        run("verify", "t.store")
        told = head_operations("t.store")
        assert len(told) % 4 == 0 and told == [operation(f"n{number}") for number in range(len(told))]
        lengths.add(len(told))
    assert len(lengths) > 3


def digest(*fields):
    """A digest of fields, as docs/formats/store.md has it."""
    fields = [field if isinstance(field, bytes) else str(field).encode() for field in fields]
    return hashlib.sha256(b"".join(b"%d:%s," % (len(field), field) for field in fields)).digest()


ATTRIBUTES = [("esfera", "centro radio"), ("cilindro", "centro radio vector altura"), ("cono", "centro proporcion vector altura"),
              ("tronco", "centro radio proporcion vector altura"), ("plano", "centro vector"), ("disco", "centro radio vector"),
              ("triangulo", "vertices")]
LENGTHS = {"centro": 3, "vector": 3, "vertices": 9}


def elements_of(snapshot):
    """The elements of a snapshot by their names, with their numbers in a list, and how many are plain."""
    def take(form):
        nonlocal at
        at += struct.calcsize(form)
        return struct.unpack_from(form, snapshot, at - struct.calcsize(form))
    at = 0
    (size,) = take("<Q")
    scene, at = json.loads(snapshot[at:at + size]), at + size
    materials = sorted(scene.get("materials", {}))
    elements, plain = {element["id"]: element for element in scene["elementos"]}, 0
    for tipo, attributes in ATTRIBUTES:
        (count,) = take("<Q")
        plain += count
        for _ in range(count):
            (length,) = take("<B")
            name = take(f"<{length}s")[0].decode()
            (material,) = take("<I")
            element = {"id": name, "tipo": tipo}
            for word in attributes.split():
                numbers = list(take(f"<{LENGTHS.get(word, 1)}d"))
                element[word] = numbers if len(numbers) == 3 else numbers[0] if len(numbers) == 1 else \
                    [numbers[0:3], numbers[3:6], numbers[6:9]]
            if material != 2**32 - 1:
                element["material"] = materials[material]
            elements[name] = element
    assert at == len(snapshot)
    return elements, plain


def test_hashes_seals_and_snapshots_are_as_documented():
    scene = {"format": "durero-scene", "version": 1, "materials": {"blue": {"color": [0, 0, 1]}, "red": {"color": [1, 0, 0]}},
             "groups": {"g": {"elementos": ["in_a_group"]}}, "elementos": [
                 {"id": "s", "tipo": "esfera", "centro": [0.1, -2, 3e300], "radio": 5e-324, "material": "red"},
                 {"id": "a", "tipo": "esfera", "centro": [0, 0, 0], "radio": 1, "material": "blue"},
                 {"id": "in_a_group", "tipo": "esfera", "centro": [0, 0, 0], "radio": 1},
                 {"id": "moves", "tipo": "esfera", "centro": [0, 0, 0], "radio": 1, "motion": [1, 0, 0]},
                 {"id": "c", "tipo": "cilindro", "centro": [1, 2, 3], "radio": 1, "vector": [0, 0, 1], "altura": 2},
                 {"id": "k", "tipo": "cono", "centro": [1, 2, 3], "proporcion": 0.5, "vector": [0, 1, 0], "altura": 2},
                 {"id": "t", "tipo": "tronco", "centro": [1, 2, 3], "radio": 1, "proporcion": 0.5, "vector": [0, 0.6, 0.8],
                  "altura": 2},
                 {"id": "p", "tipo": "plano", "centro": [1, 2, 3], "vector": [1, 0, 0]},
                 {"id": "d", "tipo": "disco", "centro": [1, 2, 3], "radio": 4, "vector": [1, 0, 0]},
                 {"id": "v", "tipo": "triangulo", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]}]}
    with open("scene.json", "w") as file:
        json.dump(scene, file)
    run("init", "s.store", "--from", "scene.json")
    run("edit", "s.store", "--group", "100", input="".join(operation(f"n{number}") + "\n" for number in range(1200)))
    run("undo", "s.store")
    run("tag", "s.store", "v1", "7")
    run("goto", "s.store", "v1")
    with opened() as database:
        database.row_factory = sqlite3.Row
        assert database.execute("PRAGMA application_id").fetchone()[0] == int.from_bytes(b"Dure", "big")
        assert database.execute("PRAGMA user_version").fetchone()[0] == 1
        snapshots = {row["event"]: row for row in database.execute("SELECT * FROM snapshot")}
        hashes = {0: bytes(32)}
        for row in database.execute("SELECT * FROM event ORDER BY number"):
            content = hashlib.sha256(snapshots[row["number"]]["content"]).digest() if row["kind"] == 0 else b""
            assert row["content"] == content
            hashes[row["number"]] = digest(
                hashes[row["parent"]], ["import", "edit"][row["kind"]], "begins" if row["begins"] else "goes on", row["line"],
                row["operation"], row["answer"], row["author"], row["time"], row["comment"], content)
            assert row["hash"] == hashes[row["number"]]
        assert len(hashes) == 1202 and sorted(snapshots) == [1, 1001]
        for number, row in snapshots.items():
            assert row["seal"] == digest("snapshot", hashes[number], hashlib.sha256(row["content"]).digest())
            elements, plain = elements_of(row["content"])
            exported = json.loads(run("export", "s.store", str(number)).stdout)
            assert elements == {element["id"]: element for element in exported["elementos"]}
            assert plain == 8 + (number - 1)
        kinds = set()
        for row in database.execute("SELECT * FROM name"):
            kinds.add(row["kind"])
            assert row["seal"] == digest("name", row["kind"], row["name"], hashes[row["event"]])
        assert kinds == {0, 1, 2, 3}


if __name__ == "__main__":
    sys.exit(run_tests(globals()))
