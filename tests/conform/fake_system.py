"""A system that keeps to the protocol, or breaks it as its argument says: what the runner is tested by.

It answers `miss` to a ray with px < 0 and `hit - PX` to others, so that each answer tells which ray it is of.
The x of a ray also says what the system does there: 1000 + n crashes, 2000 + n hangs.
"""
import fcntl
import os
import signal
import sys
import time

how = sys.argv[1] if len(sys.argv) > 1 else "right"


def answer(ray):
    if how == "garbage" and 300 <= ray < 310:
        return "Segmentation fault? no, \x1b[31mgarbage"
    if how == "long" and ray in (70, 85):  # one of them is the last of a scene
        return "refused " + "x" * 100000
    if ray < 0:
        return "miss"
    return "hit - %r" % ray


def say(lines):
    sys.stdout.write("".join(line + "\n" for line in lines))
    sys.stdout.flush()


if how == "silent":
    sys.exit(3)
if how == "unflushed":
    sys.stdout.write("system fake 1.0\n")
    time.sleep(60)
if how == "complains":
    sys.exit("no licence found")
if how == "preamble":
    say(["loaded in 3 ms", "", "systemic warning"])
if how == "endless":  # in one write, so that its reader finds more behind the line whenever it looks
    os.write(1, b"system fake 1.0 endless\n" + b"x" * 32768)
    while True:
        os.write(1, b"x" * 65536)
say(["system fake 1.0 %s" % (os.getcwd() if how == "where" else how)])
if how == "long":  # a pipe has room for the whole line, so that its rest is there when its beginning is read
    fcntl.fcntl(1, 1031, 1 << 20)  # F_SETPIPE_SZ
if how == "closes":
    os.close(1)
    time.sleep(60)
if how == "deaf":
    time.sleep(60)

while True:
    head = sys.stdin.readline()
    if not head:
        break
    line = sys.stdin.readline()
    while not line.startswith("rays "):
        line = sys.stdin.readline()
    rays = [float(sys.stdin.readline().split()[0]) for _ in range(int(line.split()[1]))]
    if how == "scene" and head.split()[1].endswith("1"):
        os.kill(os.getpid(), signal.SIGABRT)
    lines = []
    for ray in rays:
        if 1000 <= ray < 2000:
            if how == "noisy":
                print("assertion failed", file=sys.stderr, flush=True)
            os.kill(os.getpid(), signal.SIGSEGV)
        if 2000 <= ray < 3000:
            if how == "forks" and os.fork() == 0:
                time.sleep(60)
            time.sleep(60)
        if how == "greedy" and ray > 500:
            hoard = bytearray(1 << 29)
        if how == "less" and ray == 70:
            continue
        while how == "drones" and ray == 70:
            os.write(1, b"x" * 65536)
        lines.append(answer(ray))
        if how != "buffered":
            say(lines)
            lines = []
    if how == "more":
        lines.append("miss")
    say(lines)
if how == "farewell":
    say(["miss"])
