"""spec_run.py DURERO BOOK: durero spec run as a terminal sees it."""
import os
import pty
import select
import sys
import time

PATIENCE = 120  # seconds, on a machine that does much else


class Terminal:
    """A run of `durero spec run` that a terminal drives."""

    def __init__(self, durero, *arguments):
        self.said = b""
        self.child, self.terminal = pty.fork()
        if self.child == 0:
            os.execv(durero, [durero, "spec", "run", *arguments])

    def expect(self, text):
        """Reads until the text has come; what came behind it is read next."""
        end = time.monotonic() + PATIENCE
        while text.encode() not in self.said:
            ready, _, _ = select.select([self.terminal], [], [], max(0, end - time.monotonic()))
            if not ready:
                sys.exit(f"never came: {text}\nbut: {self.said.decode()}")
            try:
                self.said += os.read(self.terminal, 4096)
            except OSError:  # the other side has ended
                sys.exit(f"ended before: {text}\nbut: {self.said.decode()}")
        self.said = self.said.split(text.encode(), 1)[1]

    def type(self, command, answers):
        """Types a command, and expects the answers in their order, and that the next may be typed."""
        os.write(self.terminal, command.encode() + b"\n")
        for answer in answers:
            self.expect(answer)
        self.expect("\n> ")

    def quit(self, status):
        """Ends the run, which is to end with that status."""
        os.write(self.terminal, b"quit\n")
        try:
            while os.read(self.terminal, 4096):
                pass
        except OSError:
            pass
        got = os.waitstatus_to_exitcode(os.waitpid(self.child, 0)[1])
        if got != status:
            sys.exit(f"status {got}, expected {status}")


def steps_through_the_book(durero, book):
    terminal = Terminal(durero, book, "--members", "2", "--given", "NAME=ann,bob")
    terminal.expect("0. InitBirthdayBook")
    terminal.expect("> ")
    for command, answers in [
            ("FindBirthday", ["FindBirthday cannot go on here"]),
            ("AddBirthday name? = ann", ["2 ways:", "2. AddBirthday"]),
            ("FindBirthday", ["FindBirthday cannot go on here"]),  # what is listed may still be chosen
            ("2", ["1. AddBirthday", "→  {ann ↦ DATE2}", "invariant: 3 of 3"]),
            ("FindBirthday", ["date! = DATE2"]),
            ("back", ["1. AddBirthday"]),
            ("explore 50", ["false after this way:", "NAME ⤔ DATE"]),
    ]:
        terminal.type(command, answers)
    terminal.quit(1)  # a conjecture is false


if __name__ == "__main__":
    steps_through_the_book(*sys.argv[1:3])
