"""Stores on a PostgreSQL server: `FILE DURERO [TEST...]`. They hold what files of SQLite hold, byte for byte, and lose
nothing that was answered, whichever of program and server is killed. Rows are read by psql, which knows nothing of the
program."""
import atexit
import contextlib
import json
import os
import random
import re
import shlex
import shutil
import signal
import socket
import sqlite3
import subprocess
import sys
import tempfile
import threading
import time
import urllib.error
import urllib.request

home = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, home)
import postgresql  # noqa: E402
from running import run_tests  # noqa: E402
from store_reliability import (PATIENCE, Killed, accepted, durero, head_operations, operation,  # noqa: E402
                               read_beside_a_writer, run)

# A scene with something of every kind that a snapshot tells apart: plain elements, and what its scene file holds.
SCENE = {"format": "durero-scene", "version": 1, "materials": {"red": {"color": [1, 0, 0]}},
         "groups": {"g": {"elementos": ["in_a_group"]}}, "elementos": [
             {"id": "s1", "tipo": "esfera", "centro": [0.1, -2, 3e300], "radio": 5e-324, "material": "red"},
             {"id": "in_a_group", "tipo": "esfera", "centro": [0, 0, 0], "radio": 1},
             {"id": "moves", "tipo": "esfera", "centro": [0, 0, 0], "radio": 1, "motion": [1, 0, 0]},
             {"id": "c1", "tipo": "cilindro", "centro": [1, 2, 3], "radio": 1, "vector": [0, 0, 1], "altura": 2}]}
AT = ["--author", "ann", "--time", "2026-01-31T12:00:00Z"]
TABLES = {"event": "number", "snapshot": "event", "name": "kind, name"}
server = None
schemas = 0


def serve():
    """The server of all tests, started once."""
    global server
    if server is None:
        server = postgresql.Server()
        atexit.register(server.end)


def new_uri():
    """A store that nobody has made."""
    global schemas
    serve()
    schemas += 1
    return server.uri(f"s{schemas}")


def sql(uri, statement):
    return server.ask(statement, uri.rsplit("%3D", 1)[1])


def kept(uri, behind=1):
    return [row[0] for row in sql(uri, f"SELECT convert_from(operation, 'UTF8') FROM event WHERE number > {behind} ORDER BY number")]


def refused(*arguments):
    """The one line that a call is refused with, without `durero: ` and the store's name."""
    said = run(*arguments, status=2).stderr
    assert said.count("\n") == 1 and said.startswith("durero: ") and "; expected " in said, said
    return said


def rows_of_file(store):
    with contextlib.closing(sqlite3.connect(store)) as database:
        return {table: [[value.hex() if isinstance(value, bytes) else str(value) for value in row] for row in
                        database.execute(f"SELECT * FROM {table} ORDER BY {order}")] for table, order in TABLES.items()}


def rows_of_server(uri):
    """The same rows; texts are of UTF-8 here, and columns without a tab."""
    def column(table, name, kind):
        is_text = kind == "bytea" and name not in ("content", "hash", "seal")
        return f"convert_from({name}, 'UTF8')" if is_text else f"encode({name}, 'hex')" if kind == "bytea" else name
    rows = {}
    for table, order in TABLES.items():
        columns = sql(uri, f"""SELECT attname, format_type(atttypid, NULL) FROM pg_attribute
            WHERE attrelid = '{table}'::regclass AND attnum > 0 ORDER BY attnum""")
        rows[table] = sql(uri, f"SELECT {', '.join(column(table, *named) for named in columns)} FROM {table} ORDER BY {order}")
    return rows


def test_a_history_is_the_same_in_a_file_and_on_a_server():
    """Each command, right or wrong, on both: the same status, the same bytes, the same rows."""
    uri = new_uri()
    with open("scene.json", "w") as file:
        json.dump(SCENE, file)
    with open("other.json", "w") as file:
        json.dump({**SCENE, "elementos": SCENE["elementos"][:2]}, file)
    with open("script", "wb") as file:
        file.write(b"# bytes that are no UTF-8 stay what they are: a comment\n" +
                   b"".join(operation(f"n{number}").encode() + b"\n" for number in range(1100)))
    sphere = operation("b")
    commands = [
        ["init", "STORE", "--from", "scene.json", *AT], ["init", "STORE"], ["log", "STORE"], ["show", "STORE", "1", "--json"],
        ["edit", "STORE", "--op", sphere, "--op", sphere, "--op", "Eliminar_Cono e=c1", "--comment", "«why»", *AT],
        ["edit", "STORE", "--op", "Mover e=b"], ["edit", "STORE", "--all-or-nothing", "--op", operation("c"), "--op", sphere, *AT],
        ["edit", "STORE", "--script", "script", "--group", "100", *AT], ["edit", "STORE", "--op", "Eliminar_Esfera e=s1", *AT],
        ["undo", "STORE"], ["undo", "STORE"], ["redo", "STORE"], ["redo", "STORE"], ["redo", "STORE"], ["undo", "STORE"],
        ["tag", "STORE", "v1", "3"], ["tag", "STORE", "v1"], ["tag", "STORE", "12"], ["tag", "STORE"],
        ["branch", "STORE", "Night", "HEAD~2"], ["branch", "STORE", "day", "v1"], ["branch", "STORE"], ["goto", "STORE", "day"],
        ["edit", "STORE", "--op", "Cambiar_Radio_Esfera e=b radio=3", "--author", "bob", *AT[2:]], ["goto", "STORE", "2"],
        ["goto", "STORE", "nowhere"], ["branch", "STORE", "main", "--delete"], ["goto", "STORE", "main"],
        ["merge", "STORE", "day", *AT], ["import", "STORE", "other.json", *AT], ["undo", "STORE"],
        ["tag", "STORE", "v1", "--delete"], ["log", "STORE", "--all", "--json"], ["log", "STORE", "Night~1", "-n", "3"],
        ["show", "STORE", "9999"], ["blame", "STORE"], ["blame", "STORE", "day", "--json"], ["diff", "STORE", "day", "HEAD"],
        ["verify", "STORE"], ["verify", "STORE", "--by-spec", "--quiet"], ["export", "STORE"], ["export", "STORE", "day"],
        ["export", "STORE", "1"]]
    for command in commands:
        done = [subprocess.run([durero, "store", *(store if word == "STORE" else word for word in command)],
                               capture_output=True, text=True, timeout=PATIENCE) for store in ("f.store", uri)]
        file, on_server = [(one.returncode, one.stdout, one.stderr.replace(name, "STORE").replace(
            "a path of no file", "a schema without a store")) for one, name in zip(done, ("f.store", uri))]
        assert file == on_server, (command, file, on_server)
    rows = rows_of_file("f.store")
    assert rows == rows_of_server(uri)
    assert len(rows["event"]) > 1100 and len(rows["snapshot"]) == 3 and len(rows["name"]) > 4


def test_the_page_says_what_is_printed():
    """docs/store.md: its file, and the calls that stand there with their answers."""
    serve()
    with open(os.path.join(home, os.pardir, os.pardir, "docs", "store.md"), encoding="utf-8") as file:
        page = file.read()
    with open("first.json", "w") as file:
        file.write(re.search("<!-- file first.json -->\n```json\n(.*?)```", page, re.DOTALL)[1])
    calls = re.findall(r"^    \$ durero (.*)\n((?:    [^$].*\n)+)", page, re.MULTILINE)
    assert len(calls) == 2
    for call, answer in calls:
        words = shlex.split(call.replace("postgresql://ann@db.example/scenes?", server.uri() + "&"))
        done = subprocess.run([durero, *words], capture_output=True, text=True, timeout=PATIENCE)
        assert done.returncode == 0 and "".join(f"    {line}\n" for line in done.stdout.splitlines()) == answer, (call, done)


def test_bytes_that_are_no_text_are_kept():
    uri = new_uri()
    for store in ("f.store", uri):
        run("init", store, *AT)
        with open("script", "wb") as file:
            file.write(operation("a").encode() + b" # \xff \x00 b\n")
        run("edit", store, "--script", "script", *AT)
    file, on_server = (subprocess.run([durero, "store", "log", store, "--json"], capture_output=True, check=True).stdout
                       for store in ("f.store", uri))
    assert file == on_server and b"\xff" in file
    assert sql(uri, "SELECT encode(operation, 'hex') FROM event WHERE number = 2")[0][0].endswith("2320ff20002062")


def test_what_a_spoiled_store_has_left_goes_from_a_server_to_a_file_and_back():
    uri, other = new_uri(), new_uri()
    run("init", uri, *AT)
    run("edit", uri, "--op", operation("a"), "--op", operation("b"), "--op", operation("c"), *AT)
    before = run("export", uri, "HEAD~1").stdout
    sql(uri, "UPDATE event SET author = 'eve' WHERE number = 3")
    assert "event 3 is not as it was written; expected a store that is whole" in refused("export", uri)
    said = run("verify", uri, "--salvage", "left.store", status=1).stdout
    assert f"{uri}: event 3 is not as it was written\n" in said and "2 events are whole, 0 follow from a snapshot alone, 2 are lost" in said
    run("verify", "left.store", "--salvage", other)
    run("verify", other)
    assert run("export", "left.store", "1").stdout == before == run("export", other, "1").stdout
    assert rows_of_file("left.store") == rows_of_server(other)
    assert "is there already; expected a schema without a store" in refused("verify", "left.store", "--salvage", other)


def test_each_row_that_is_changed_is_found():
    for change, said in [
            ("UPDATE event SET operation = 'Eliminar_Esfera e=a' WHERE number = 2", "event 2 is not as it was written"),
            ("UPDATE event SET parent = 1 WHERE number = 3", "event 3 is not as it was written"),
            ("DELETE FROM event WHERE number = 2", "event 2 is missing"),
            ("UPDATE snapshot SET content = content || 'x'", "the snapshot of event 1 is not as it was written"),
            ("DELETE FROM snapshot", "the snapshot of event 1 is missing"),
            ("UPDATE name SET event = 2 WHERE name = 'main' AND kind = 0", "branch main is not as it was written"),
            ("INSERT INTO snapshot SELECT 7, seal, content FROM snapshot", "the snapshot of event 7 has no event"),
            ("DELETE FROM name WHERE kind = 2", "HEAD is missing")]:
        uri = new_uri()
        run("init", uri, *AT)
        run("edit", uri, "--op", operation("a"), "--op", operation("b"), *AT)
        sql(uri, change)
        assert f"{uri}: {said}" in run("verify", uri, status=1).stdout, change


def test_what_is_no_store_that_can_be_used_is_refused_in_one_line():
    uri = new_uri()
    run("init", uri, *AT)
    edit = ["edit", uri, "--op", operation("a")]
    for change, said in [
            ("UPDATE store SET version = 2", "is a store of version 2; expected version 1: a later program reads it"),
            ("DELETE FROM store", "is a store of version 0; expected 1"),
            ("DROP TABLE store", "has no store in schema s"),
            ("ALTER TABLE event SET UNLOGGED", "has other tables than a store; expected a store that is whole"),
            ("ALTER TABLE name ALTER seal DROP NOT NULL", "has other tables than a store"),
            ("ALTER TABLE snapshot ADD more BIGINT", "has other tables than a store"),
            ("ALTER TABLE event DROP CONSTRAINT event_pkey", "has other tables than a store"),
            ("CREATE RULE r AS ON INSERT TO event DO ALSO DELETE FROM name", "has other tables than a store"),
            ("CREATE TABLE more () INHERITS (event)", "has other tables than a store"),
            ("CREATE FUNCTION f() RETURNS trigger LANGUAGE plpgsql AS 'BEGIN RETURN NULL; END'; "
             "CREATE TRIGGER t BEFORE INSERT ON event FOR EACH ROW EXECUTE FUNCTION f()", "has other tables than a store")]:
        sql(uri, change)
        for command in (edit, ["log", uri], ["verify", uri]):
            assert f"{uri}: {said}" in refused(*command), change
        uri = new_uri()
        run("init", uri, *AT)
        edit = ["edit", uri, "--op", operation("a")]


def test_a_server_that_cannot_be_asked_is_refused_in_one_line():
    serve()
    uri = new_uri()
    folder = server.folder
    for bad, said in [
            ("postgresql:///x?host=/nowhere", "cannot be opened: connection to server on socket"),
            ("postgresql://127.0.0.1:1/x", "cannot be opened: connection to server at"),
            (f"postgresql://durero@/nothing?host={folder}", 'database "nothing" does not exist; expected a server that answers'),
            (f"postgresql://nobody@/postgres?host={folder}", 'role "nobody" does not exist; expected a server that answers'),
            ("postgresql://x?nothing=1", "is no URI that libpq reads; expected postgresql://USER@HOST"),
            (uri, "has no schema s"),
            (server.uri(), "has no store in schema public; expected one that `durero store init` made")]:
        for command in (["log", bad], ["edit", bad, "--op", operation("a")]):
            assert f"durero: {bad}: " in refused(*command) and said in refused(*command), (bad, refused(*command))


def test_a_page_that_is_spoiled_is_refused_and_the_rest_is_verified():
    uri = new_uri()
    run("init", uri, *AT)
    run("edit", uri, "--group", "1", input="".join(operation(f"n{number}") + "\n" for number in range(100)))
    (page,), = sql(uri, "SELECT pg_relation_filepath('event')")
    server.stop("fast")
    with open(os.path.join(server.data, page), "r+b") as file:
        file.seek(8192 + 5000)  # the second page
        byte = file.read(1)[0]
        file.seek(8192 + 5000)
        file.write(bytes([byte ^ 1]))
    server.start()
    said = refused("log", uri, "--all")
    assert f"{uri}: is spoiled: invalid page in block 1 of relation" in said and "; expected a store that is whole" in said, said
    told = run("verify", uri, "--salvage", "left.store", status=1).stdout
    summary = next(line for line in told.splitlines() if line.startswith("events "))
    whole, lost = int(summary.split(": ")[1].split()[0]), int(summary.split(", ")[-1].split()[0])
    assert summary.startswith("events 101, snapshots 1, ") and 10 < whole < 90 and whole + lost == 101, told
    run("verify", "left.store")
    assert head_operations("left.store") == [operation(f"n{number}") for number in range(whole - 1)]


def test_a_server_that_does_not_wait_for_its_disk_is_not_written():
    uri = new_uri()
    run("init", uri, *AT)
    server.stop("fast")
    server.start("-c fsync=off")
    try:
        for command in (["edit", uri, "--op", operation("a")], ["init", new_uri()]):
            assert "cannot be written durably: its server has fsync = off; expected a server" in refused(*command)
        run("verify", uri)
    finally:
        server.stop("fast")
        server.start("-c synchronous_commit=off -c wal_writer_delay=10s")
    try:
        run("edit", uri, "--op", operation("a"))  # which is waited for all the same
        server.stop("immediate")
    finally:
        server.start()
    assert kept(uri) == [operation("a")]


def test_a_wrong_password_is_refused_and_no_password_is_shown():
    uri = new_uri()
    run("init", uri, *AT)
    schema = uri.rsplit("%3D", 1)[1]
    sql(uri, f"CREATE ROLE ann LOGIN PASSWORD 'secret'; GRANT USAGE ON SCHEMA {schema} TO ann; "
             f"GRANT SELECT ON ALL TABLES IN SCHEMA {schema} TO ann")
    rules = os.path.join(server.data, "pg_hba.conf")
    with open(rules) as file:
        was = file.read()
    try:
        with open(rules, "w") as file:
            file.write("local all ann scram-sha-256\n" + was)
        server.ask("SELECT pg_reload_conf()")
        time.sleep(0.2)
        rest = uri.split("@", 1)[1]
        for wrong in (f"postgresql://ann:s3same@{rest}", f"postgresql://ann@{rest}&password=s3same", f"postgresql://ann@{rest}"):
            said = refused("log", wrong)
            assert f"postgresql://ann@{rest}: cannot be opened: " in said and "s3same" not in said, said
        right = f"postgresql://ann:secret@{rest}"
        assert "1  2026-01-31T12:00:00Z  ann  import nothing" in run("log", right).stdout
        said = refused("edit", right, "--op", operation("a"))
        assert f"postgresql://ann@{rest}: may not be used: permission denied for table store; expected a user that may" in said, said
        sql(uri, "GRANT INSERT ON event, snapshot TO ann; GRANT INSERT, UPDATE, DELETE ON name TO ann; GRANT UPDATE ON store TO ann")
        run("edit", right, "--group", "500", input="".join(operation(f"n{number}") + "\n" for number in range(1001)))
        run("undo", right), run("tag", right, "v1"), run("tag", right, "v1", "--delete"), run("goto", right, "3")
        said = refused("show", right, "9999")
        assert said.startswith(f"durero: postgresql://ann@{rest}: no revision"), said
        said = refused("init", right.replace(schema, "elsewhere"))
        assert f"postgresql://ann@{rest.replace(schema, 'elsewhere')}: may not be used: permission denied for database" in said, said
        with open("verified", "w") as out:
            subprocess.run([durero, "store", "verify", right, "--quiet"], stdout=out, check=True, timeout=PATIENCE)
    finally:
        with open(rules, "w") as file:
            file.write(was)
        server.ask("SELECT pg_reload_conf()")


class Holding:
    """A program that has begun to write, and waits."""

    def __init__(self, uri, change="LOCK TABLE store IN SHARE ROW EXCLUSIVE MODE"):
        self.psql = subprocess.Popen(
            [*postgresql.unprivileged(), os.path.join(postgresql.programs(), "psql"), "--no-psqlrc", "--quiet", "--dbname", uri],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, cwd=server.folder)
        self.psql.stdin.write(f"BEGIN; {change};\n\\echo held\n")
        self.psql.stdin.flush()
        assert self.psql.stdout.readline() == "held\n"

    def kill(self):
        self.psql.kill()
        self.psql.communicate()

    def commit(self):
        self.psql.communicate("COMMIT;\n", timeout=PATIENCE)


def waiting_to_write(*arguments):
    """A program that waits for the one that holds."""
    waiting = subprocess.Popen([durero, "store", *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    end = time.monotonic() + PATIENCE
    while not server.ask("SELECT 1 FROM pg_locks WHERE NOT granted"):
        assert time.monotonic() < end and waiting.poll() is None, "it does not wait"
        time.sleep(0.01)
    return waiting


def test_a_writer_waits_for_another_and_a_reader_does_not():
    uri, other = new_uri(), new_uri()
    run("init", uri, *AT), run("init", other, *AT)
    holding = Holding(uri)
    waiting = waiting_to_write("edit", uri, "--op", operation("a"))
    run("edit", other, "--op", operation("a"))  # of another scene
    assert head_operations(uri) == []
    run("verify", uri)
    assert waiting.poll() is None
    holding.kill()  # what a killed program holds is free
    assert '"ok":true' in waiting.communicate(timeout=PATIENCE)[0] and waiting.returncode == 0
    assert head_operations(uri) == [operation("a")]


def test_what_another_program_writes_without_waiting_is_not_written_over():
    for change, back, why in [
            ("UPDATE name SET seal = seal", "SELECT", "could not serialize access due to concurrent update"),
            ("INSERT INTO event SELECT 3, 2, kind, begins, line, operation, answer, author, time, comment, content, hash FROM event "
             "WHERE number = 1", "DELETE FROM event WHERE number = 3", "duplicate key value violates unique constraint")]:
        uri = new_uri()
        run("init", uri, *AT)
        run("edit", uri, "--op", operation("z"))
        holding = Holding(uri, change)
        waiting = waiting_to_write("edit", uri, "--op", operation("a"), "--op", operation("b"))
        holding.commit()
        out, said = waiting.communicate(timeout=PATIENCE)
        assert (waiting.returncode, out) == (2, "") and said.count("\n") == 1, (out, said)
        assert f"was changed while it was used: {why}" in said and "; expected that it is asked again" in said, said
        sql(uri, back)
        assert kept(uri) == [operation("z")]
        run("edit", uri, "--op", operation("a"))
        run("verify", uri)


def test_40_programs_edit_one_store_at_a_time():
    uri = new_uri()
    run("init", uri)
    started = [subprocess.Popen([durero, "store", "edit", uri, "--op", operation(f"p{number}")], stdout=subprocess.DEVNULL)
               for number in range(40)]
    assert [process.wait(PATIENCE) for process in started] == [0] * 40
    assert sorted(kept(uri)) == sorted(operation(f"p{number}") for number in range(40))
    assert head_operations(uri) == kept(uri)
    run("verify", uri)


def test_readers_beside_a_writer_see_whole_transactions():
    uri = new_uri()
    run("init", uri)
    read_beside_a_writer(uri)


class KilledOnServer(Killed):
    """The same programs, killed, on a server. It may have been told to keep a transaction when its program is killed, and
    does so then: what it has kept is looked at when it has seen that the program is gone."""

    def killed(self, *arguments, text=""):
        said = super().killed(*arguments, text=text)
        end = time.monotonic() + PATIENCE
        while server.ask("SELECT 1 FROM pg_stat_activity WHERE application_name = 'durero'"):
            assert time.monotonic() < end, "what a killed program held is not free"
            time.sleep(0.005)
        return said

    def clear(self):
        self.store = new_uri()

    def kept(self, behind):
        return kept(self.store, behind)

    def forget(self):
        self.new = new_uri()

    def is_there(self):
        return sql(self.new, "SELECT to_regclass('store')") != [[""]]


def test_60_kills_lose_nothing_that_was_answered_and_keep_nothing_that_was_refused():
    KilledOnServer(20260131).go(60)


class StoppedServer:
    """A server that is stopped at once, as if the machine had, while a program edits."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.uri = new_uri()
        run("init", self.uri)
        self.names, self.way = 0, []

    def script(self, count):
        """Operations, some of which are refused, since their names are taken."""
        lines, good = [], []
        for _ in range(count):
            if self.random.random() < 0.2 and self.way + good:
                lines.append(self.random.choice(self.way + good))
            else:
                self.names += 1
                good.append(operation(f"n{self.names}"))
                lines.append(good[-1])
        return lines, good

    def stop_once(self):
        group = self.random.choice([1, 3, 10])
        lines, good = self.script(20_000)
        with open("script", "w") as file:
            file.writelines(line + "\n" for line in lines)
        with open("out", "w") as out, open("err", "w") as err:
            process = subprocess.Popen([durero, "store", "edit", self.uri, "--quiet", "--script", "script", "--group", str(group)],
                                       stdout=out, stderr=err)
            time.sleep(self.random.uniform(0.1, 0.6))
            server.stop("immediate")
            status = process.wait(PATIENCE)
        server.start()
        with open("out") as out, open("err") as err:
            answers, said = out.read(), err.read()
        assert status == 2 and said.count("\n") == 1 and "; expected a server that " in said, (status, said)
        answered = [lines[line - 1] for line in accepted(answers)]
        new = kept(self.uri, 1 + len(self.way))
        assert answered == good[:len(answered)], "an operation was answered that is none of the accepted"
        assert new == good[:len(new)], "an operation was kept that is none of the accepted"
        assert len(answered) <= len(new) <= len(answered) + group, f"answered {len(answered)}, kept {len(new)}, group {group}"
        self.way += new
        assert head_operations(self.uri) == self.way
        run("verify", self.uri)
        return len(new)


def test_a_server_that_stops_loses_nothing_that_was_answered():
    stopped = StoppedServer(20260131)
    assert sum(stopped.stop_once() for _ in range(4)) > 0, "no edit was under way"


class CutServer:
    """A server that goes away behind its N-th answer, with more notices under way than a client reads at a time: the
    client's next words are not taken, and it learns why late."""

    def __init__(self, answers):
        self.left, self.folder = answers, tempfile.mkdtemp(prefix="cut")
        self.listening = socket.socket(socket.AF_UNIX)
        self.listening.bind(os.path.join(self.folder, ".s.PGSQL.5432"))
        self.listening.listen()
        threading.Thread(target=self.carry, daemon=True).start()

    def uri(self, schema):
        return f"postgresql://durero@/postgres?host={self.folder}&options=-csearch_path%3D{schema}"

    def carry(self):
        client = self.listening.accept()[0]
        behind = socket.socket(socket.AF_UNIX)
        behind.connect(os.path.join(server.folder, ".s.PGSQL.5432"))
        threading.Thread(target=self.forward, args=(client, behind), daemon=True).start()
        answers = behind.makefile("rb")
        while self.left > 0 and (head := answers.read(5)):
            client.sendall(head + answers.read(int.from_bytes(head[1:], "big") - 4))
            self.left -= head[:1] == b"Z"
        if self.left == 0:
            text = b"SWARNING\0C57P02\0M" + b"x" * 60_000 + b"\0\0"
            client.sendall(b"N" + (len(text) + 4).to_bytes(4, "big") + text)
        for end in (client, behind):
            with contextlib.suppress(OSError):
                end.shutdown(socket.SHUT_RDWR)
            end.close()

    @staticmethod
    def forward(client, behind):
        with contextlib.suppress(OSError):
            while words := client.recv(65_536):
                behind.sendall(words)

    def end(self):
        self.listening.close()
        shutil.rmtree(self.folder)


def test_a_server_that_goes_away_behind_any_answer_ends_the_program():
    names = [operation(f"n{number}") for number in range(300)]
    with open("script", "w") as file:
        file.writelines(name + "\n" for name in names)
    for cut in range(1, 100):
        uri = new_uri()
        run("init", uri, *AT)
        going_away = CutServer(cut)
        done = subprocess.run([durero, "store", "edit", going_away.uri(uri.rsplit("%3D", 1)[1]), "--quiet", "--script", "script",
                               "--group", "100"], capture_output=True, text=True, timeout=PATIENCE)
        going_away.end()
        if done.returncode == 0:
            break
        assert done.returncode == 2 and done.stderr.count("\n") == 1 and "; expected a server that " in done.stderr, (cut, done)
        answered, there = len(accepted(done.stdout)), kept(uri)
        assert there == names[:len(there)] and answered <= len(there) <= answered + 100, (cut, answered, len(there))
        run("verify", uri)
    assert cut > 10 and kept(uri) == names, cut


class Serving:
    """durero serve, as a program of another language asks it."""

    def __init__(self, *arguments):
        self.process = subprocess.Popen([durero, "serve", *arguments, "--port", "0"], stdout=subprocess.PIPE, text=True)
        self.address = self.process.stdout.readline().strip()

    def ask(self, path, body=None):
        """Status and answer."""
        request = urllib.request.Request(self.address + path, None if body is None else json.dumps(body).encode(),
                                         {"Content-Type": "application/json"})
        try:
            with urllib.request.urlopen(request, timeout=PATIENCE) as answer:
                return answer.status, json.load(answer)
        except urllib.error.HTTPError as error:
            return error.code, json.load(error)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.send_signal(signal.SIGINT)
        assert self.process.wait(PATIENCE) == 0
        self.process.stdout.close()


def test_a_store_is_served_and_its_server_found_again():
    uri = new_uri()
    run("init", uri, *AT)
    with Serving(uri) as serving:
        assert serving.ask("/edits", {"operations": [operation("a")]})[0] == 200
        server.stop("immediate")
        status, said = serving.ask("/edits", {"operations": [operation("b")]})
        assert status == 500 and ("is out of reach" in said["error"] or "cannot be opened" in said["error"]), said
        server.start()
        assert serving.ask("/edits", {"operations": [operation("c")]}) == \
            (200, {"event": 3, "answers": [{"line": 1, "ok": True, "r": "esfera_agregada"}]})
        assert serving.ask("/hits", {"rays": [[0, 0, -5, 0, 0, 1]]})[1]["hits"][0]["elementos"] == ["a", "c"]
    assert head_operations(uri) == [operation("a"), operation("c")]


def long_a_writer_that_waits_in_vain_says_so():
    uri = new_uri()
    run("init", uri, *AT)
    holding = Holding(uri)
    waiting = waiting_to_write("edit", uri, "--op", operation("a"))
    said = waiting.communicate(timeout=2 * PATIENCE)[1]
    holding.kill()
    assert said == f"durero: {uri}: is being written by another program; expected that it ends within 120 s\n", said
    assert kept(uri) == []


def long_2000_kills():
    seed = random.SystemRandom().randrange(2**32)
    print("  seed", seed, flush=True)
    KilledOnServer(seed).go(2_000)


def long_100_stops_of_the_server():
    seed = random.SystemRandom().randrange(2**32)
    print("  seed", seed, flush=True)
    stopped = StoppedServer(seed)
    assert sum(stopped.stop_once() for _ in range(100)) > 0


def long_a_replica_answers_reads_and_rays_at_a_consistent_state():
    uri = new_uri()
    run("init", uri, *AT)
    schema = uri.rsplit("%3D", 1)[1]
    with postgresql.Server(primary=server) as replica:
        copy = replica.uri(schema)
        with Serving(copy, "--read-only") as serving:
            script = "".join(operation(f"n{number:04}") + "\n" for number in range(1, 2001))
            with subprocess.Popen([durero, "store", "edit", uri, "--group", "4", *AT], stdin=subprocess.PIPE,
                                  stdout=subprocess.DEVNULL, text=True) as writer:
                writer.stdin.write(script)
                writer.stdin.close()
                seen, last = set(), 0
                while writer.poll() is None:
                    status, scene = serving.ask("/scene")
                    assert status == 200, scene
                    ids = [element["id"] for element in scene["elementos"]]
                    assert ids == [f"n{number:04}" for number in range(1, len(ids) + 1)], "a reader sees what never was"
                    assert len(ids) % 4 == 0 and len(ids) >= last, "a reader sees a part of a transaction, or goes back"
                    status, hits = serving.ask("/hits", {"rays": [[0, 0, -5, 0, 0, 1]]})
                    count = len(hits["hits"][0]["elementos"])
                    assert status == 200 and count == hits["event"] - 1 and count >= len(ids), "rays see another scene"
                    seen.add(len(ids))
                    last = len(ids)
            assert len(seen) > 2, "the replica does not follow"
            replica.follows(server)
            assert serving.ask("/")[1]["event"] == 2001
            for path in ("/edits", "/undo", "/redo"):
                assert serving.ask(path, {"operations": [operation("x")]}) == \
                    (403, {"error": "the store is only read here; expected the server that writes it"})
        for command in (["log", "--json"], ["export"], ["blame"], ["verify"], ["show", "--json"]):
            assert run(command[0], copy, *command[1:]).stdout == run(command[0], uri, *command[1:]).stdout
        for command in (["edit", copy, "--op", operation("x")], ["undo", copy], ["init", replica.uri("another")]):
            assert "cannot be written: its server only reads; expected the primary server" in refused(*command)
        said = subprocess.run([durero, "serve", copy, "--port", "0"], capture_output=True, text=True, timeout=PATIENCE)
        assert said.returncode == 2 and said.stderr.count("\n") == 1 and "its server only reads" in said.stderr
        run("verify", copy)


def is_possible():
    """Whether there is a server, and the program reaches it."""
    said = subprocess.run([durero, "store", "log", "postgresql:///x?host=/nowhere"], capture_output=True, text=True)
    assert said.returncode == 2 and said.stderr.count("\n") == 1, said.stderr
    if "this build has no PostgreSQL; expected a file" in said.stderr:
        print("  skipped: the program was built without libpq")
        return False
    if postgresql.programs() is None:
        print("  skipped: there is no PostgreSQL server (Debian: postgresql)")
        return False
    return True


if __name__ == "__main__":
    sys.exit(is_possible() and run_tests(globals()))
