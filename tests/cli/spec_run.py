"""spec_run.py DURERO BOOK: durero spec run as a terminal sees it."""
import os
import pty
import select
import sys
import time

durero, book = sys.argv[1:3]
PATIENCE = 120  # seconds, on a machine that does much else


def expect(terminal, text, said=b""):
    """Reads until the text has come, and returns what came with it."""
    end = time.monotonic() + PATIENCE
    while text.encode() not in said:
        ready, _, _ = select.select([terminal], [], [], max(0, end - time.monotonic()))
        if not ready:
            sys.exit(f"never came: {text}\nbut: {said.decode()}")
        try:
            said += os.read(terminal, 4096)
        except OSError:  # the other side has ended
            sys.exit(f"ended before: {text}\nbut: {said.decode()}")
    return said.split(text.encode(), 1)[1]


child, terminal = pty.fork()
if child == 0:
    os.execv(durero, [durero, "spec", "run", book, "--members", "2", "--given", "NAME=ann,bob"])
rest = expect(terminal, "0. InitBirthdayBook")
rest = expect(terminal, "> ", rest)
for command, answers in [
        ("FindBirthday", ["FindBirthday cannot go on here"]),
        ("AddBirthday name? = ann", ["2 ways:", "2. AddBirthday"]),
        ("2", ["1. AddBirthday", "→  {ann ↦ DATE2}", "invariant: 3 of 3"]),
        ("FindBirthday", ["date! = DATE2"]),
        ("back", ["1. AddBirthday"]),
        ("explore 50", ["false after this way:", "NAME ⤔ DATE"]),
]:
    os.write(terminal, command.encode() + b"\n")
    for answer in answers:
        rest = expect(terminal, answer, rest)
    rest = expect(terminal, "\n> ", rest)
os.write(terminal, b"quit\n")
try:
    while os.read(terminal, 4096):
        pass
except OSError:
    pass
status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
if status != 1:
    sys.exit(f"status {status}, expected 1: a conjecture is false")
