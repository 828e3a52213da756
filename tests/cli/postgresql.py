"""A PostgreSQL server of a test: in a folder of its own, reached by a Unix socket alone."""
import glob
import os
import pwd
import shutil
import subprocess
import tempfile
import time

PATIENCE = 60  # seconds


def programs():
    """The folder of the newest server's programs, as Debian and others install them; None where there is none."""
    folders = glob.glob("/usr/lib/postgresql/*/bin") + glob.glob("/usr/pgsql-*/bin")
    folders = [folder for folder in folders if os.path.exists(os.path.join(folder, "initdb"))]
    if folders:
        return max(folders, key=lambda folder: float("".join(c for c in folder if c.isdigit() or c == ".")))
    found = shutil.which("initdb")
    return found and os.path.dirname(os.path.realpath(found))


def unprivileged():
    """What is called before a program so that it does not run as root, as which no server runs."""
    return ["setpriv", "--reuid=nobody", "--regid=nogroup", "--clear-groups"] if os.getuid() == 0 else []


class Server:
    """A server whose user durero needs no password. `primary` is the server that it copies, and follows."""

    def __init__(self, primary=None):
        self.folder = tempfile.mkdtemp(prefix="pg")
        self.data = os.path.join(self.folder, "data")
        if os.getuid() == 0:
            os.chown(self.folder, pwd.getpwnam("nobody").pw_uid, -1)
        if primary is None:
            self.call("initdb", "--pgdata", self.data, "--username=durero", "--auth=trust", "--encoding=UTF8",
                      "--no-locale", "--no-instructions", "--data-checksums")
        else:
            self.call("pg_basebackup", "--pgdata", self.data, "--dbname", primary.uri(), "--write-recovery-conf",
                      "--checkpoint=fast")
        self.start()

    def call(self, program, *arguments):
        done = subprocess.run([*unprivileged(), os.path.join(programs(), program), *arguments], cwd=self.folder,
                              capture_output=True, text=True, timeout=PATIENCE)
        assert done.returncode == 0, (program, arguments, done.stdout, done.stderr)
        return done.stdout

    def start(self, settings=""):
        options = f"-c listen_addresses= -c unix_socket_directories={self.folder} -c max_connections=100 {settings}"
        self.call("pg_ctl", "start", "--wait", "--pgdata", self.data, "--log", os.path.join(self.folder, "log"),
                  "--options", options)

    def stop(self, how="immediate"):
        self.call("pg_ctl", "stop", "--wait", "--mode", how, "--pgdata", self.data)

    def end(self):
        try:
            self.stop()
        except AssertionError:  # it is not there
            pass
        shutil.rmtree(self.folder, ignore_errors=True)

    def uri(self, schema=None, user="durero"):
        return f"postgresql://{user}@/postgres?host={self.folder}" + (f"&options=-csearch_path%3D{schema}" if schema else "")

    def ask(self, sql, schema=None):
        """The rows of a statement by psql, which knows nothing of the program: a list of columns a row."""
        out = self.call("psql", "--no-psqlrc", "--quiet", "--tuples-only", "--no-align", "--field-separator=\t", "--set",
                        "ON_ERROR_STOP=1", "--dbname", self.uri(schema), "--command", sql)
        return [line.split("\t") for line in out.splitlines()]

    def follows(self, primary):
        """Waits until it has all that the primary has."""
        (at,), = primary.ask("SELECT pg_current_wal_lsn()")
        end = time.monotonic() + PATIENCE
        while self.ask(f"SELECT pg_last_wal_replay_lsn() >= '{at}'") != [["t"]]:
            assert time.monotonic() < end, "the replica does not follow"
            time.sleep(0.01)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end()
