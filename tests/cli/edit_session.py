"""edit_session.py DURERO: durero edit -i as a person at a terminal has it: completion, history, colours, interrupts."""
import os
import pty
import select
import signal
import sys
import time

PATIENCE = 60  # seconds, on a machine that does much else
TAB, UP, CTRL_C, CTRL_D = b"\t", b"\x1b[A", b"\x03", b"\x04"


def expect(holds, what):
    if not holds:
        sys.exit(f"expected {what}")


class Typist:
    """A run of `durero edit -i` that a terminal drives."""

    def __init__(self, durero, *arguments):
        self.said = ""
        self.child, self.terminal = pty.fork()
        if self.child == 0:
            os.environ["TERM"] = "xterm"
            os.environ.pop("NO_COLOR", None)
            os.execv(durero, [durero, "edit", *arguments, "-i"])
        self.until("durero> ")

    def read(self):
        if select.select([self.terminal], [], [], 0.05)[0]:
            self.said += os.read(self.terminal, 65536).decode(errors="replace")

    def until(self, text):
        """What is said up to that text, and with it."""
        end = time.monotonic() + PATIENCE
        while text not in self.said:
            expect(time.monotonic() < end, f"{text!r}, not {self.said!r}")
            try:
                self.read()
            except OSError:
                sys.exit(f"expected {text!r} before the end, not {self.said!r}")
        at = self.said.index(text) + len(text)
        said, self.said = self.said[:at], self.said[at:]
        return said

    def type(self, keys):
        os.write(self.terminal, keys)

    def answer(self, keys):
        """What stands between the end of the typed line and the next prompt."""
        self.type(keys + b"\n")
        self.until("\n")
        return self.until("durero> ")

    def end(self):
        try:
            while True:
                self.read()
        except OSError:
            pass
        return os.waitstatus_to_exitcode(os.waitpid(self.child, 0)[1])


def test_tab_completes_operations_inputs_and_names(durero):
    typist = Typist(durero, "scene.json")
    typist.type(b"Agregar_Esf" + TAB)
    typist.until("era ")
    typist.type(b"e" + TAB)  # the only input that starts so
    typist.until("?=")
    typist.type(b"new ce" + TAB)
    typist.until("ntro?=")
    said = typist.answer(b"(0,0,9) ra" + TAB + b"1 mat" + TAB + b"r" + TAB)
    expect("esfera_agregada" in said, f"the sphere, not {said!r}")
    said = typist.answer(b"sho" + TAB + b"ne" + TAB)
    expect('"radio":1,"material":"red"' in said, f"its radius and material, not {said!r}")
    # Where words differ they are listed, and the line stands again.
    typist.type(b"Eliminar_Esfera e?=" + TAB)
    listed = typist.until("durero> ")
    expect(listed.replace("\r", "").split("\n")[1:-1] == ["c1", "k1", "new", "s1"], f"the elements, not {listed!r}")
    said = typist.answer(b"n" + TAB)
    expect("esfera_eliminada" in said, f"it to be removed, not {said!r}")
    typist.type(b"group g?=pair elementos?=s1,k" + TAB)
    typist.until("1")
    expect("grouped" in typist.answer(b""), "a list of names")
    typist.answer(b"ungroup g?=pa" + TAB)
    typist.answer(b"why-not Agregar_Elemento t?=soy_tri" + TAB)
    said = typist.answer(b"Eliminar_Cono e?=k1 " + TAB)
    expect("cono_eliminado" in said, f"no input to be offered again, not {said!r}")
    typist.type(b"xyz" + TAB)
    said = typist.answer(b"")
    expect("error" in said, "nothing to complete")
    typist.answer(b"undo")
    typist.answer(b"undo")
    typist.answer(b"undo")
    typist.answer(b"undo")
    typist.answer(b"undo")
    typist.type(b"quit\n")
    expect(typist.end() == 0, "status 0")


def test_colours_history_and_interrupts(durero):
    typist = Typist(durero, "scene.json")
    said = typist.answer(b"Agregar_Esfera e?=new centro?=(0,0,9) radio?=1")
    expect("\x1b[1;32mdone\x1b[0m: esfera_agregada" in said, f"green, not {said!r}")
    said = typist.answer(UP)
    expect("\x1b[1;31mrefused\x1b[0m: elemento_ya_existe" in said, f"the same line again, and red, not {said!r}")
    typist.type(b"no such thing" + CTRL_C)
    said = typist.answer(b"list")
    expect("4 elementos" in said and "error" not in said, f"an empty line after an interrupt, not {said!r}")
    os.kill(typist.child, signal.SIGINT)  # as an interrupt while no line is read
    said = typist.answer(b"list")
    expect("4 elementos" in said, f"the session to go on, not {said!r}")
    typist.type(CTRL_D)
    typist.until("quit again and lose it")
    typist.until("durero> ")
    typist.answer(b"list")  # not asked again at once
    typist.type(CTRL_D)
    typist.until("quit again and lose it")
    typist.until("durero> ")
    typist.type(CTRL_D)
    typist.until("what was not written is lost")
    expect(typist.end() == 1, "status 1")


def test_the_scene_as_it_stands_is_shown(durero):
    typist = Typist(durero, "scene.json")
    typist.answer(b"Agregar_Esfera e?=big centro?=(0,0,0) radio?=3")
    typist.type(b"view\n")
    typist.until("click picks")
    typist.type(b"\r")  # the middle
    typist.until("big  t = ")
    typist.type(b"q")
    typist.until("durero> ")
    typist.answer(b"undo")
    typist.type(b"view\n")
    typist.until("click picks")
    typist.type(b"\r")
    typist.until("s1  t = ")
    typist.type(b"q")
    typist.until("durero> ")
    expect("3 elementos" in typist.answer(b"list"), "lines as before")
    typist.type(b"quit\n")
    expect(typist.end() == 0, "status 0")


def main(durero):
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test(durero)


if __name__ == "__main__":
    main(*sys.argv[1:])
