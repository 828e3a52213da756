"""watch.py DURERO: durero watch while a file is saved in the ways in which programs save."""
import os
import queue
import re
import signal
import subprocess
import sys
import threading
import time

import view

PATIENCE = 60  # seconds, on a machine that does much else


def expect(holds, what):
    if not holds:
        sys.exit(f"expected {what}")


def scene(*radii, camera=""):
    elements = ",\n".join(f'{{"id":"s{i}","tipo":"esfera","centro":[0,0,{3 * i}],"radio":{r}}}' for i, r in enumerate(radii))
    return f'{{"format":"durero-scene","version":1,{camera}"elementos":[\n{elements}]}}\n'


def in_place(name, text):
    with open(name, "w") as out:
        out.write(text)


def by_renaming(name, text):
    in_place(name + ".new", text)
    os.rename(name + ".new", name)


class Watcher:
    """A run of `durero watch`; its lines as they come."""

    def __init__(self, durero, *arguments):
        self.run = subprocess.Popen([durero, "watch", *arguments], stdout=subprocess.PIPE, text=True)
        self.lines = queue.Queue()
        threading.Thread(target=lambda: [self.lines.put(line) for line in self.run.stdout], daemon=True).start()

    def line(self):
        """The next line without its time."""
        try:
            line = self.lines.get(timeout=PATIENCE)
        except queue.Empty:
            sys.exit("expected a line")
        expect(re.search(r" \(\d+ ms\)\n$", line), f"a time, not {line!r}")
        return line.rsplit(" (", 1)[0]

    def is_silent(self):
        time.sleep(0.6)
        return self.lines.empty()

    def end(self, number=signal.SIGINT):
        self.run.send_signal(number)
        expect(self.run.wait(PATIENCE) == 0, "status 0")


def test_each_save_is_told_once(durero):
    in_place("a.json", scene(1))
    watcher = Watcher(durero, "a.json")
    expect(watcher.line() == "a.json: ok: 1 elementos", "the state at the start")
    for save in (in_place, by_renaming, in_place):
        save("a.json", scene(1, 2))
        expect(watcher.line() == "a.json: ok: 2 elementos", f"a save by {save.__name__}")
        save("a.json", scene(1, 0))
        expect(watcher.line().startswith("a.json:3:"), "the place of a radius of 0")
    by_renaming("a.json", scene(1, 0))  # the same bytes
    in_place("b.json", scene(1))  # another file
    expect(watcher.is_silent(), "nothing of what is as it was")
    watcher.end()


def test_a_file_is_told_when_it_is_whole(durero):
    in_place("a.json", scene(1))
    watcher = Watcher(durero, "a.json")
    watcher.line()
    text = scene(1, 2, 3)
    with open("a.json", "w") as out:
        for at in range(0, len(text), 40):
            out.write(text[at:at + 40])
            out.flush()
            time.sleep(0.03)
    expect(watcher.line() == "a.json: ok: 3 elementos", "the whole file, and no half of it")
    # A text that stays half is told.
    in_place("a.json", text[:60])
    expect("the text ends" in watcher.line(), "the end of the text")
    watcher.end(signal.SIGTERM)


def test_a_file_may_go_and_come_back(durero):
    in_place("a.json", scene(1))
    watcher = Watcher(durero, "a.json")
    watcher.line()
    os.remove("a.json")
    expect(watcher.line().startswith("a.json: cannot be read"), "that it is gone")
    in_place("a.json", scene(1))
    expect(watcher.line() == "a.json: ok: 1 elementos", "that it is back")
    watcher.end()


def test_what_a_link_leads_to_is_watched(durero):
    os.makedirs("there", exist_ok=True)
    in_place("there/a.json", scene(1))
    os.symlink("there/a.json", "link.json")
    watcher = Watcher(durero, "link.json")
    watcher.line()
    by_renaming("there/a.json", scene(1, 2))
    expect(watcher.line() == "link.json: ok: 2 elementos", "a save of the file itself")
    by_renaming("link.json", scene(1, 2, 3))
    expect(watcher.line() == "link.json: ok: 3 elementos", "a file in place of the link")
    watcher.end()


def test_a_save_is_drawn_by_the_camera_as_it_stands(durero):
    camera = '"camera":{"eye":[0,0,-5],"look_at":[0,0,0],"up":[0,1,0],"fov_y":40},'
    in_place("v.json", scene(1, 0.5, camera=camera))
    viewer = view.Viewer(durero, "v.json", "--view", command="watch")
    first = viewer.frame()
    turned = viewer.after(view.RIGHT * 6)  # the ball behind comes out
    expect(view.pixels(turned) != view.pixels(first), "another side")
    by_renaming("v.json", scene(1.5, 0.5, camera=camera))
    larger = viewer.frame()
    expect(view.pixels(larger) != view.pixels(turned), "another picture")
    expect(view.status(larger)[0] == "v.json: 2 elementos", f"the save below it, not {view.status(larger)}")
    by_renaming("v.json", scene(-1, camera=camera))
    wrong = viewer.frame()
    expect(view.pixels(wrong) == view.pixels(larger), "the last picture")
    expect(view.status(wrong)[0].startswith("v.json:2:"), f"the error below it, not {view.status(wrong)}")
    by_renaming("v.json", scene(1, 0.5, camera=camera))
    expect(view.pixels(viewer.frame()) == view.pixels(turned), "the first radius, from where one looked")
    expect(view.pixels(viewer.after(b"0")) == view.pixels(first), "the first camera")
    expect(view.status(viewer.after(b"\r"))[0].startswith("s0  t = "), "the element in the middle")
    line, status = viewer.end()
    expect(status == 0 and view.camera(line), "the camera at the end")


def main(durero):
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test(durero)


if __name__ == "__main__":
    main(*sys.argv[1:])
