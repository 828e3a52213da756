"""How `durero` reads and writes streams: dialogues through pipes, memory, signals, what is printed, and what a terminal sees.

streams.py DURERO [TEST...] runs the tests, or those named, each in a folder of its own. Those named long_… run only when named.
"""
import contextlib
import errno
import os
import pty
import random
import re
import select
import signal
import stat
import struct
import subprocess
import sys
import time

from running import is_sanitized, run_tests

durero = os.path.abspath(sys.argv[1])
home = os.path.dirname(os.path.abspath(__file__))
SCENE = """{"format":"durero-scene","version":1,"camera":{"eye":[0,1,-8],"look_at":[0,0,0],"up":[0,1,0],"fov_y":45},
"resolution":[8,6],"elementos":[{"id":"s1","tipo":"esfera","centro":[0,0,0],"radio":1}]}"""
PATIENCE = 120  # seconds, on a machine that does much else


def write(name, text):
    with open(name, "wb") as file:
        file.write(text if isinstance(text, bytes) else text.encode())


def start(*arguments, **how):
    return subprocess.Popen([durero, *arguments], **how)


def run(*arguments, **how):
    return subprocess.run([durero, *arguments], capture_output=True, timeout=PATIENCE, **how)


def head_of(rays, fortran=False):
    """What stands before the numbers of a .npy file of rays."""
    head = "{'descr': '<f8', 'fortran_order': %s, 'shape': (%d, 6), }" % (fortran, rays)
    head += " " * (-(11 + len(head)) % 64) + "\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head.encode()


def numbers_of(rows):
    return b"".join(struct.pack("<%dd" % len(row), *row) for row in rows)


def npy(rows, fortran=False):
    """Rays as a .npy file."""
    return head_of(len(rows), fortran) + numbers_of(zip(*rows) if fortran else rows)


def wait_for(what, true):
    end = time.monotonic() + PATIENCE
    while not true():
        assert time.monotonic() < end, f"{what} does not come"
        time.sleep(0.01)


def writes_here(process):
    """Whether the process has opened a file to write in this folder, though it may have no name."""
    with contextlib.suppress(OSError):
        for file in os.listdir(f"/proc/{process.pid}/fd"):
            link = f"/proc/{process.pid}/fd/{file}"
            if os.readlink(link).startswith(os.getcwd() + "/") and os.lstat(link).st_mode & stat.S_IWUSR:
                return True
    return False


# Dialogues.

def answer(process):
    """The next line that the process prints; it must come while its input is open."""
    ready, _, _ = select.select([process.stdout], [], [], PATIENCE)
    assert ready, "no answer"
    return process.stdout.readline()


def test_a_ray_on_an_open_pipe_is_answered_at_once():
    with start("trace", "scene.json", "-", stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0) as process:
        for number, (text, outcome) in enumerate([("0 0 -5 0 0 2\n", b'"hit","elementos":["s1"],"t":2,'),
                                                  ("0 9 0 0 1 0 # up\r\n", b'"miss"'),
                                                  ("0 0 -1 0 0 -1 @s1\r", b'"miss"'),
                                                  ("\n# nothing\n0 0 5 0 0 -1\n", b'"hit"')]):
            middle = len(text) // 2
            process.stdin.write(text[:middle].encode())
            time.sleep(0.02)
            process.stdin.write(text[middle:].encode())
            said = answer(process)
            assert said.startswith(b'{"ray":%d,"outcome":' % number) and outcome in said, said
        process.stdin.write(b"0 0 5 0 0 -1")  # a last line without an end
        process.stdin.close()
        assert answer(process).startswith(b'{"ray":4,'), "the last ray"
        assert process.wait(PATIENCE) == 0


def test_a_row_on_an_open_pipe_is_answered_at_once():
    table = npy([(0, 0, -5, 0, 0, 2), (0, 9, 0, 0, 1, 0)])
    with start("trace", "scene.json", "-", stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0) as process:
        process.stdin.write(table[:-50])
        process.stdin.write(table[-50:-48])
        assert answer(process).startswith(b'{"ray":0,"outcome":"hit"')
        process.stdin.write(table[-48:])
        assert answer(process).startswith(b'{"ray":1,"outcome":"miss"')
        process.stdin.close()
        assert process.wait(PATIENCE) == 0


def test_the_dialogue_of_the_documentation():
    with open(os.path.join(home, "../../docs/streams.md")) as file:
        program = re.search(r"```python\n(.*?)```", file.read(), re.DOTALL)[1]
    folder = os.path.dirname(durero)
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, timeout=PATIENCE,
                          env={**os.environ, "PATH": folder + ":" + os.environ["PATH"]})
    assert done.returncode == 0, done.stderr
    assert done.stdout == (b'{"ray":0,"outcome":"hit","elementos":["s1"],"t":2,"point":[0,0,-1]}\n'
                           b'{"ray":1,"outcome":"miss","elementos":[]}\n'), done.stdout


def test_what_stands_before_a_bad_line_is_answered_on_a_stream_and_no_file_appears():
    rays = b"0 0 -5 0 0 2\n0 9 0 0 1 0\n0 0 x\n0 0 -5 0 0 2\n"
    write("rays", rays)
    for done in run("trace", "scene.json", "-", input=rays), run("trace", "scene.json", "rays"):
        assert done.returncode == 2
        assert [line[:9] for line in done.stdout.splitlines()] == [b'{"ray":0,', b'{"ray":1,'], done.stdout
        assert done.stderr.endswith(b':3:5: "x" in a ray; expected a finite number\n'), done.stderr
    before = os.listdir()
    for out in "hits", "hits.npy":
        assert run("trace", "scene.json", "rays", "-o", out).returncode == 2
    assert os.listdir() == before, os.listdir()


def test_files_pipes_and_formats_give_the_same_hits():
    rows = [(0, 0, -5, 0.25 * (i % 3), 0, 2) for i in range(40000)]  # more than a block
    write("c.npy", npy(rows))
    write("fortran.npy", npy(rows, fortran=True))
    write("text", "".join("%r %r %r %r %r %r\n" % row for row in rows))
    run("trace", "scene.json", "c.npy", "-o", "hits")
    run("trace", "scene.json", "c.npy", "-o", "hits.npy")
    hits, table = open("hits", "rb").read(), open("hits.npy", "rb").read()
    assert hits.count(b"\n") == 40000 and table.startswith(b"\x93NUMPY")
    for name in "fortran.npy", "text":
        assert run("trace", "scene.json", name).stdout == hits, name
    for name in "c.npy", "fortran.npy", "text":
        with open(name, "rb") as file:
            rays = file.read()
        assert run("trace", "scene.json", "-", input=rays).stdout == hits, name
        assert run("trace", "scene.json", "-", "-o", "piped.npy", input=rays).returncode == 0
        assert open("piped.npy", "rb").read() == table, name
    cut = run("trace", "scene.json", "-", input=open("c.npy", "rb").read()[:-8])
    assert cut.returncode == 2 and cut.stdout == b"".join(hits.splitlines(True)[:39999])
    assert cut.stderr == b"durero: <stdin>:1:1: 1919992 bytes of data; expected 40000 rows of 6 float64\n", cut.stderr


# Memory.

def most_memory(count, block, arguments, head=b""):
    """The resident memory, in MiB, that a call takes at most which reads `count` blocks."""
    process = start(*arguments, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL)
    process.stdin.write(head)
    for _ in range(count):
        process.stdin.write(block)
    process.stdin.close()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    assert process.returncode == 0, process.returncode
    return usage.ru_maxrss / 1024


BLOCK = 10000
TEXT = "".join("0 0 -5 %d 0.125 2\n" % (i % 9 - 4) for i in range(BLOCK)).encode()
TABLE = numbers_of([(0, 0, -5, i % 9 - 4, 0.125, 2) for i in range(BLOCK)])


def memory_is_constant(rays, most):
    """Text and .npy, to text and to .npy."""
    if is_sanitized(durero):
        print("  a sanitizer's memory is not measured")
        return
    for head, block in (b"", TEXT), (head_of(rays), TABLE):
        for out in [], ["-o", "hits.npy"]:
            begin = time.monotonic()
            memory = most_memory(rays // BLOCK, block, ["trace", "scene.json", "-", *out], head)
            rate = rays / (time.monotonic() - begin)
            print(f"  {'.npy' if head else 'text'} to {'.npy' if out else 'text'}: {memory:.0f} MiB, {rate:.0f} rays/s")
            assert memory < most, f"{memory} MiB for {rays} rays"


def test_memory_does_not_grow_with_the_rays():
    memory_is_constant(1_000_000, 90)


def long_memory_of_a_hundred_million_rays():
    memory_is_constant(100_000_000, 300)


# Signals.

def test_a_signal_leaves_no_file_and_its_own_status():
    for number in signal.SIGINT, signal.SIGTERM, signal.SIGHUP:
        for out in "hits", "hits.npy":
            before = sorted(os.listdir())
            # Python starts with SIGINT as it is; a shell ignores it for what it starts in the background.
            process = start("trace", "scene.json", "-", "-o", out, stdin=subprocess.PIPE,
                            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
            wait_for("the temporary file", lambda: writes_here(process))
            process.stdin.write(TEXT)
            process.send_signal(number)
            assert process.wait(PATIENCE) == -number, process.returncode
            with contextlib.suppress(BrokenPipeError):
                process.stdin.close()
            assert sorted(os.listdir()) == before, os.listdir()


def kills(number):
    """Kills `edit` at any instant: the scene is whole, and after the next run nothing else is there."""
    rng = random.Random(7)
    write("old.json", SCENE)
    ops = "".join("Agregar_Esfera e=n%d centro=(%d,0,0) radio=1\n" % (i, i) for i in range(300))
    write("ops", ops)
    edit = ["edit", "old.json", "--script", "ops", "-o", "out.json"]
    longest = 0
    for _ in range(3):
        begin = time.monotonic()
        assert run(*edit).returncode == 0
        longest = max(longest, time.monotonic() - begin)
    whole = open("out.json", "rb").read()
    write("out.json", SCENE)
    old, before = open("out.json", "rb").read(), sorted(os.listdir())
    found = set()
    for kill in range(number):
        process = start(*edit, stdout=subprocess.DEVNULL)
        time.sleep(rng.uniform(0, 2 * longest))
        process.kill()
        process.wait(PATIENCE)
        text = open("out.json", "rb").read()
        assert text in (old, whole), f"kill {kill}: {len(text)} bytes"
        found.add(text)
        assert run("edit", "old.json", "--op", "Eliminar_Esfera e=s1", "-o", "out.json").returncode == 0
        assert sorted(os.listdir()) == before, f"kill {kill}: {os.listdir()}"
        write("out.json", old)
    assert len(found) == 2, "it was always killed before it wrote, or never"


def test_a_kill_leaves_the_old_or_the_new_and_nothing_else():
    kills(60)


def long_kills():
    kills(2000)


def test_a_hangup_that_is_ignored_stays_ignored():
    process = start("trace", "scene.json", "-", "-o", "hits", stdin=subprocess.PIPE,
                    preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
    wait_for("the temporary file", lambda: writes_here(process))
    process.send_signal(signal.SIGHUP)
    process.stdin.write(b"0 0 -5 0 0 2\n")
    process.stdin.close()
    assert process.wait(PATIENCE) == 0
    assert open("hits").read().count("\n") == 1


def test_a_suite_that_is_interrupted_leaves_nothing():
    for number in signal.SIGINT, signal.SIGTERM, signal.SIGHUP:
        process = start("conform", "make", "suite", "--rays", "1000000", stderr=subprocess.PIPE,
                        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        wait_for("the folder", lambda: os.path.exists("suite.new0/" + "generic"))
        process.send_signal(number)
        assert process.wait(PATIENCE) == 2, process.returncode
        assert process.stderr.read().startswith(b"durero: stopped; expected "), "what it says"
        process.stderr.close()
        assert not [name for name in os.listdir() if name.startswith("suite")], os.listdir()


# The standard output.

def commands():
    """Every command that the help lists."""
    text = run("--help").stdout.decode()
    names = re.findall(r"^  ([a-z][a-z-]*)  ", text, re.MULTILINE)
    assert {"check", "edit", "trace", "render", "engines", "agree", "conform", "import", "export", "spec"} <= set(names)
    return [[name] for name in names] + [["--help"], ["--version"], ["trace", "--help"]]


def is_refused(done, why):
    assert done.returncode == 2, (done.args, done.returncode)
    expected = f"durero: <stdout>: cannot be written: {why}; expected a standard output that takes what is printed\n"
    assert done.stderr.decode() == expected, (done.args, done.stderr)


def test_a_standard_output_that_is_closed_or_full_is_refused_by_every_command():
    for command in commands():
        call = " ".join(["exec", '"$0"', *command])
        is_refused(subprocess.run(["sh", "-c", call + " >&-", durero], stderr=subprocess.PIPE), "Bad file descriptor")
        is_refused(subprocess.run(["sh", "-c", call + " >/dev/full", durero], stderr=subprocess.PIPE),
                   "No space left on device")


def test_an_error_that_nobody_can_hear_is_an_error():
    for where in "2>&-", "2>/dev/full":
        assert subprocess.run(["sh", "-c", f'exec "$0" check nowhere {where}', durero]).returncode == 2, where
    # Nothing that is written goes into the place of what is closed.
    done = subprocess.run(["sh", "-c", 'exec "$0" trace scene.json /dev/null -o hits 0<&- 2>&-', durero])
    assert done.returncode == 0 and open("hits").read() == ""


PRINTING = [["--help"], ["--version"], ["check", "scene.json"], ["edit", "scene.json", "--op", "Eliminar_Elemento e=a"],
            ["trace", "scene.json", "rays"], ["engines"], ["agree", "scene.json", "--rays", "10"], ["conform", "list"],
            ["conform", "answer"], ["conform", "show", "--case", "generic/0000", "--ray", "0"],
            ["conform", "make", "suite", "--family", "generic", "--rays", "1"], ["spec", "check"],
            ["spec", "eval", "1 + 1"], ["spec", "show", "Escena"], ["spec", "confirm", "scene.json", "rays", "hits"]]


def test_a_pipe_that_nobody_reads_is_refused_by_what_prints():
    write("rays", "0 0 -5 0 0 2\n")
    run("trace", "scene.json", "rays", "-o", "hits")
    for command in PRINTING:
        out, into = os.pipe()
        os.close(out)
        is_refused(subprocess.run([durero, *command], stdin=subprocess.DEVNULL, stdout=into, stderr=subprocess.PIPE,
                                  timeout=PATIENCE), "Broken pipe")
        os.close(into)


def test_a_reader_that_goes_ends_a_long_trace():
    process = start("trace", "scene.json", "-", stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    process.stdin.write(b"0 0 -5 0 0 2\n")
    process.stdin.flush()
    assert answer(process)
    process.stdout.close()
    with contextlib.suppress(BrokenPipeError):
        for _ in range(100):
            process.stdin.write(TEXT)
        process.stdin.close()
    assert process.wait(PATIENCE) == 2
    assert process.stderr.read().startswith(b"durero: <stdout>: cannot be written: Broken pipe; "), "what it says"
    process.stderr.close()


# What a terminal sees.

def seen(arguments, seconds=0.0, environment=(), out=subprocess.DEVNULL):
    """What a call prints on a terminal that its standard error is, its input held open so long; and its exit status."""
    controller, terminal = pty.openpty()
    ours = {"PATH": os.environ["PATH"], "TERM": "xterm", **dict(environment)}
    process = start(*arguments, stdin=subprocess.PIPE, stdout=terminal if out == "terminal" else out, stderr=terminal,
                    env=ours)
    os.close(terminal)
    with contextlib.suppress(BrokenPipeError):
        process.stdin.write(b"0 0 -5 0 0 2\n")
        process.stdin.flush()
    time.sleep(seconds)
    with contextlib.suppress(BrokenPipeError):
        process.stdin.close()
    text = b""
    try:
        while some := os.read(controller, 4096):
            text += some
    except OSError as error:
        assert error.errno == errno.EIO, error  # the terminal is closed
    os.close(controller)
    return text.decode(), process.wait(PATIENCE)


def test_progress_is_shown_on_a_terminal_from_two_seconds_on_and_is_gone_at_the_end():
    text, status = seen(["trace", "scene.json", "-"], 3)
    assert status == 0
    assert re.search(r"\r\x1b\[Ktrace: 1 rays, 0\.\d rays/s, \d s", text), repr(text)
    assert text.endswith("\r\x1b[K"), repr(text)
    assert seen(["trace", "scene.json", "-"], 0.1) == ("", 0)
    assert seen(["trace", "scene.json", "-", "--quiet"], 3) == ("", 0)
    # It does not stand between the hits of a terminal.
    text, status = seen(["trace", "scene.json", "-"], 3, out="terminal")
    assert status == 0 and "rays/s" not in text and '"outcome":"hit"' in text, repr(text)


def tells(pattern, call, amounts):
    """Whether one of the works, which are longer and longer, tells its progress: a fast machine is done with the first."""
    for amount in amounts:
        text, status = seen(call(amount))
        assert status == 0
        if re.search(pattern, text):
            return True
    return False


def test_progress_tells_the_share_and_the_time_left():
    assert tells(r"render: \d+ %, \d+ (s|min) left",
                 lambda side: ["render", "scene.json", "--threads", "1", "--size", f"{side}x{side}", "-o", "p.png"],
                 (2000, 4000, 8000, 16000))
    assert tells(r"agree: \d+ of \d+ rays, \d+ rays/s, \d+ (s|min) left",
                 lambda rays: ["agree", "scene.json", "--threads", "1", "--rays", str(rays)],
                 (200_000, 1_000_000, 5_000_000, 25_000_000))


def test_nothing_of_progress_is_shown_elsewhere():
    process = start("trace", "scene.json", "-", stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    time.sleep(3)
    process.stdin.close()
    assert process.wait(PATIENCE) == 0
    assert process.stderr.read() == b""
    process.stderr.close()


def test_errors_are_red_on_a_terminal_unless_no_color_is_set():
    plain = "durero: nowhere: cannot be read: No such file or directory; expected a readable file\r\n"
    red = plain.replace("durero:", "\x1b[1;31mdurero:\x1b[0m")
    assert seen(["check", "nowhere"]) == (red, 2)
    assert seen(["check", "nowhere"], environment={"NO_COLOR": ""}) == (red, 2)
    assert seen(["check", "nowhere"], environment={"NO_COLOR": "1"}) == (plain, 2)
    assert seen(["check", "nowhere"], environment={"TERM": "dumb"}) == (plain, 2)
    assert run("check", "nowhere").stderr.decode() == plain.replace("\r", "")


sys.exit(run_tests(globals(), lambda: write("scene.json", SCENE)))
