"""view.py DURERO SCENE: durero view as a person at a terminal has it."""
import fcntl
import json
import os
import pty
import re
import select
import struct
import subprocess
import sys
import termios
import time

PATIENCE = 120  # seconds, on a machine that does much else
COLUMNS, ROWS = 100, 22
RIGHT, LEFT, UP, DOWN = (b"\x1b[" + letter for letter in (b"C", b"D", b"A", b"B"))


def expect(holds, what):
    if not holds:
        sys.exit(f"expected {what}")


class Viewer:
    """A run of `durero view`, or of another command, that a terminal drives."""

    def __init__(self, durero, *arguments, colours="truecolor", command="view"):
        self.said = b""
        self.child, self.terminal = pty.fork()
        if self.child == 0:
            os.environ["COLORTERM"] = colours
            sys.stdin.readline()  # until the terminal has its size
            os.execv(durero, [durero, command, *arguments])
        self.resize(COLUMNS, ROWS)
        self.type(b"\n")

    def resize(self, columns, rows):
        fcntl.ioctl(self.terminal, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))

    def type(self, keys):
        os.write(self.terminal, keys)

    def frame(self):
        """The text of the next whole picture with what stands below it."""
        end = time.monotonic() + PATIENCE
        while True:
            whole = re.search(rb"\x1b\[H((?:(?!\x1b\[H).)*\x1b\[K[^\x1b]*\r\n\x1b\[K[^\x1b]*)", self.said, re.S)
            quiet = not select.select([self.terminal], [], [], 0.4)[0]
            if whole and quiet:
                last = self.said.rsplit(b"\x1b[H", 1)[1]
                self.said = b""
                return last.decode()
            expect(time.monotonic() < end, f"a picture, not {self.said[-300:]!r}")
            if not quiet:
                try:
                    self.said += os.read(self.terminal, 65536)
                except OSError:
                    sys.exit(f"ended: {self.said[-300:]!r}")

    def after(self, keys):
        self.type(keys)
        return self.frame()

    def end(self, keys=b"q"):
        """What is printed behind the screen, and the status."""
        self.type(keys)
        try:
            while some := os.read(self.terminal, 65536):
                self.said += some
        except OSError:
            pass
        status = os.waitstatus_to_exitcode(os.waitpid(self.child, 0)[1])
        return self.said.decode().rsplit("\x1b[?1049l", 1)[1].strip(), status


def pixels(frame):
    """Rows of colours, two of each line of half blocks."""
    rows = []
    for line in frame.split("\r\n")[:-2]:
        above, below, colour = [], [], {"3": None, "4": None}
        for ground, red, green, blue, block in re.findall(r"\x1b\[([34])8;2;(\d+);(\d+);(\d+)m|(▀)", line):
            if block:
                above.append(colour["3"])
                below.append(colour["4"])
            else:
                colour[ground] = (int(red), int(green), int(blue))
        rows += [above, below]
    return rows


def status(frame):
    return [line.replace("\x1b[K", "") for line in frame.split("\r\n")[-2:]]


def camera(line):
    expect(line.startswith('"camera":') and line.endswith(","), f"a camera, not {line!r}")
    return json.loads("{" + line[:-1] + "}")["camera"]


def test_it_shows_the_picture_that_render_draws(durero, scene):
    viewer = Viewer(durero, scene)
    shown = pixels(viewer.frame())
    expect(len(shown) == 2 * (ROWS - 2) and all(len(row) == COLUMNS for row in shown), "two pixels in a character")
    size = f"{COLUMNS}x{2 * (ROWS - 2)}"
    subprocess.run([durero, "render", scene, "-o", "v.png", "--size", size, "--samples", "9"], check=True)
    expect(shown == png("v.png"), "the pixels of durero render")
    line, code = viewer.end()
    expect(code == 0 and camera(line) == json.load(open(scene))["camera"], f"the scene's own camera, not {line}")


def png(path):
    """Rows of colours of a picture of ours: 8 bits, RGB."""
    import zlib

    data, at, packed = open(path, "rb").read(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
        packed += body if kind == b"IDAT" else b""
        at += length + 12
    expect((depth, colour) == (8, 2), "8 bits, RGB")
    raw, before, rows = zlib.decompress(packed), bytes(width * 3), []
    for y in range(height):
        line = bytearray(raw[y * (width * 3 + 1):(y + 1) * (width * 3 + 1)])
        kind = line.pop(0)
        for i in range(len(line)):
            left, above = line[i - 3] if i > 2 else 0, before[i]
            corner = before[i - 3] if i > 2 else 0
            guess = left + above - corner
            nearest = min((left, above, corner), key=lambda value: abs(guess - value))
            line[i] = (line[i] + (0, left, above, (left + above) // 2, nearest)[kind]) & 255
        before = bytes(line)
        rows.append([tuple(line[i:i + 3]) for i in range(0, len(line), 3)])
    return rows


def test_what_is_clicked_is_told_exactly(durero, scene):
    viewer = Viewer(durero, scene)
    viewer.frame()
    first, second = status(viewer.after(b"\r"))
    name, t = re.fullmatch(r"(\S+)  t = (\d+\.\d+)", first).groups()
    expect(name == "ball" and len(t.replace(".", "")) == 40, f"the ball with 40 digits, not {first}")
    # The ray of the middle character goes between its two pixels.
    column, row = COLUMNS // 2, (ROWS - 2) // 2
    clicked = status(viewer.after(b"\x1b[<0;%d;%dM" % (column + 1, row + 1)))
    expect(clicked == [first, second], f"the same by a click, not {clicked}")
    expect(status(viewer.after(b"\x1b[<0;1;1M"))[0] == "nothing is met there", "nothing in a corner")
    viewer.after(b"\x1b[<0;%d;%dM" % (column + 1, row + 1))
    viewer.after(b"c")
    line, _ = viewer.end()
    point = json.loads("[" + second[1:-1] + "]")
    expect(camera(line)["look_at"] == point, f"{point} in the middle, not {line}")


def distance(camera):
    return sum((a - b) ** 2 for a, b in zip(camera["eye"], camera["look_at"])) ** 0.5


def near(one, other):
    return all(abs(a - b) < 1e-9 for a, b in zip(one, other))


def test_keys_move_the_camera(durero, scene):
    own = json.load(open(scene))["camera"]

    def at_the_end(keys):
        viewer = Viewer(durero, scene)
        viewer.frame()
        for key in keys:
            viewer.type(key)
        return camera(viewer.end()[0])

    expect(near(at_the_end([RIGHT] * 72)["eye"], own["eye"]), "72 turns of 5 degrees to be one")
    quarter = at_the_end([RIGHT] * 18)["eye"]
    expect(near(quarter, [-5, 0, 0]), f"a quarter to the right at (-5, 0, 0), not {quarter}")
    expect(near(at_the_end([LEFT] * 18)["eye"], [5, 0, 0]), "a quarter to the left")
    top = at_the_end([UP] * 30)
    expect(4.99 < top["eye"][1] < 5 and near([distance(top)], [5]), f"the eye a degree from the pole, not {top}")
    expect(near(at_the_end([UP, DOWN])["eye"], own["eye"]), "up and down to be nothing")
    expect(near([distance(at_the_end([b"+", b"\x1b[<64;1;1M"]))], [5 * 0.81]), "nearer by key and wheel")
    expect(near([distance(at_the_end([b"-"]))], [5 / 0.9]), "farther")
    aside = at_the_end([b"d", b"w"])
    expect(near(aside["look_at"], [-0.25, 0.25, 0]) and near(aside["eye"], [-0.25, 0.25, -5]), f"a step aside, not {aside}")
    expect(at_the_end([b"d", RIGHT, b"+", b"0"]) == own, "the first camera again")


def test_it_ends_and_leaves_the_terminal_as_it_was(durero, scene):
    for keys in (b"q", b"\x1b", b"\x04", b"\x03"):
        viewer = Viewer(durero, scene)
        viewer.frame()
        line, code = viewer.end(keys)
        expect(code == 0 and camera(line), f"status 0 after {keys!r}, not {code}")


def test_it_follows_the_size_of_the_terminal(durero, scene):
    viewer = Viewer(durero, scene)
    viewer.frame()
    viewer.resize(30, 10)
    shown = pixels(viewer.frame())
    expect(len(shown) == 16 and len(shown[0]) == 30, "a picture of 30 by 16 pixels")
    expect(all(len(line) <= 30 for line in status(viewer.after(b"\r"))), "lines that are cut")
    viewer.end()


def test_a_terminal_of_216_colours_gets_those(durero, scene):
    viewer = Viewer(durero, scene, colours="")
    numbers = {int(number) for number in re.findall(r"\x1b\[[34]8;5;(\d+)m", viewer.frame())}
    expect(len(numbers) > 3 and min(numbers) >= 16 and max(numbers) <= 231, f"colours of the cube, not {numbers}")
    viewer.end()


def test_a_scene_without_a_camera_is_seen_whole(durero, scene):
    with open("bare.json", "w") as out:
        out.write('{"format":"durero-scene","version":1,"elementos":[{"id":"far","tipo":"esfera","centro":[70,0,0],'
                  '"radio":2},{"id":"floor","tipo":"plano","centro":[0,-9,0],"vector":[0,1,0]}]}')
    viewer = Viewer(durero, "bare.json")
    viewer.frame()
    expect(status(viewer.after(b"\r"))[0].startswith("far  t = "), "the sphere in the middle")
    seen = camera(viewer.end()[0])
    expect(seen["look_at"] == [70, 0, 0], f"a camera towards the sphere, not {seen}")


def test_a_copy_elsewhere_changes_no_answer(durero, scene):
    with open("copy.json", "w") as out:
        out.write('{"format":"durero-scene","version":1,"camera":{"eye":[0,0,-5],"look_at":[0,0,10],"up":[0,1,0],"fov_y":40},'
                  '"elementos":[{"id":"ball","tipo":"esfera","centro":[0,0,10],"radio":3},{"id":"copy","tipo":"instancia",'
                  '"de":{"tipo":"esfera","centro":[0,0,0],"radio":1},"mapa":[[1,0,0,50],[0,2,0,0],[0,0,1,0]]}]}')
    viewer = Viewer(durero, "copy.json")
    viewer.frame()
    first, second = status(viewer.after(b"\r"))
    t, z = float(first.split("t = ")[1]), json.loads("[" + second[1:-1] + "]")[2]
    expect(first.startswith("ball") and abs(t - (z + 5)) < 1e-3 * t, f"the t of the ball's point, not {first} {second}")
    viewer.end()


def test_it_needs_a_terminal(durero, scene):
    done = subprocess.run([durero, "view", scene], stdin=subprocess.DEVNULL, capture_output=True, text=True)
    expect(done.returncode == 2 and "is no terminal; expected one" in done.stderr and not done.stdout,
           f"one line of error, not {done}")


def main(durero):
    scene = "scene.json"
    with open(scene, "w") as out:
        out.write('{"format":"durero-scene","version":1,"camera":{"eye":[0,0,-5],"look_at":[0,0,0],"up":[0,1,0],'
                  '"fov_y":40},"lights":[{"position":[2,4,-5],"color":[1,1,1]}],"elementos":['
                  '{"id":"ball","tipo":"esfera","centro":[0,0.01,0],"radio":1}]}')
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test(durero, scene)


if __name__ == "__main__":
    main(*sys.argv[1:])
