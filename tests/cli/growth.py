"""How what `durero` takes grows with its input: by counts that it tells, by memory, and by ratios of two sizes.

growth.py DURERO [TEST...] runs the tests, or those named, each in a folder of its own.
"""
import json
import math
import os
import random
import subprocess
import sys

from running import is_sanitized, run_tests

durero = os.path.abspath(sys.argv[1])
PATIENCE = 300  # seconds, on a machine that does much else
LONGEST_LINE = 1 << 24
HEAD = '{"format":"durero-scene","version":1,"elementos":[\n'


def write(name, text):
    with open(name, "w") as file:
        file.write(text)


def spheres(name, count):
    """So many, of which about as many as elsewhere stand in a cube of side 2."""
    rng, reach = random.Random(1), count ** (1 / 3)
    at = lambda: [rng.uniform(-reach, reach) for _ in range(3)]
    write(name, HEAD + ",\n".join('{"id":"s%d","tipo":"esfera","centro":%s,"radio":0.3}' % (i, at())
                                  for i in range(count)) + "]}\n")


def fan(name, count):
    """Triangles that share a corner, all of one disc."""
    corner = lambda i: [math.cos(2 * math.pi * i / count), math.sin(2 * math.pi * i / count), 0]
    write(name, HEAD + ",\n".join('{"id":"t%d","tipo":"triangulo","vertices":[[0,0,0],%s,%s]}'
                                  % (i, corner(i), corner(i + 1)) for i in range(count)) + "]}\n")


def usage(status, *arguments):
    """What a call has used when it ends with that status."""
    process = subprocess.Popen([durero, *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, ended, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(ended)
    assert process.returncode == status, (arguments, process.returncode)
    return used


# Points that the sampled oracle holds.

def test_agree_holds_no_more_points_of_twice_as_many_elements():
    if is_sanitized(durero):
        return
    sizes = 4000, 8000  # of 360 and 720 MB of points
    memory = []
    for size in sizes:
        spheres("scene.json", size)
        memory.append(usage(0, "agree", "scene.json", "--rays", "2000").ru_maxrss * 1024)
    for_each = (memory[1] - memory[0]) / (sizes[1] - sizes[0])
    print(f"  {memory[0] >> 20} and {memory[1] >> 20} MiB: {for_each:.0f} bytes an element")
    assert for_each < 6000, "the points of an element take 90 kB"
    assert memory[1] < 450 << 20, "256 MiB of points, and what is not points"


# Lines that do not end.

def bytes_read(arguments, before, status=2):
    """How many blanks a call reads from a pipe that does not end, and the line that it ends with."""
    reads, writes = os.pipe()
    process = subprocess.Popen([durero, *arguments], stdin=reads, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    os.close(reads)
    blanks, count = b" " * (1 << 16), 0
    os.write(writes, before)
    try:
        while count < 1 << 28:
            count += os.write(writes, blanks)
    except BrokenPipeError:
        pass
    os.close(writes)
    said = process.stderr.read().decode()
    _, ended, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(ended)
    process.stderr.close()
    assert process.returncode == status, (arguments, process.returncode, said)
    return count, said, used.ru_maxrss * 1024


def test_a_line_that_does_not_end_is_refused():
    spheres("scene.json", 1)
    write("empty", "")
    subprocess.run([durero, "conform", "make", "suite", "--rays", "100"], check=True, stdout=subprocess.DEVNULL)
    calls = [(["trace", "scene.json", "-"], b"0 0 -9 0 0 1\n"),
             (["stats", "scene.json", "/dev/stdin"], b""),
             (["edit", "scene.json", "--script", "-"], b"# a comment\n"),
             (["edit", "scene.json"], b""),
             (["spec", "confirm", "scene.json", "empty", "/dev/stdin"], b""),
             (["conform", "judge", "suite", "/dev/stdin", "--profile", "durero"], b""),
             (["conform", "answer"], b"scene a\n")]
    for name in "blank.nff", "blank.obj":
        os.symlink("/dev/stdin", name)
        calls.append((["import", name, "-o", "out.json"], b"# a comment\n"))
    for arguments, before in calls:
        count, said, memory = bytes_read(arguments, before)
        print(f"  {' '.join(arguments)}: {count} bytes, {memory >> 20} MiB")
        assert f"{LONGEST_LINE + 1}: a line of more than {LONGEST_LINE} bytes; expected a shorter one" in said, said
        assert said.count("\n") == 1, said
        assert count < LONGEST_LINE + (1 << 22), (arguments, count)
        assert is_sanitized(durero) or memory < 100 << 20, (arguments, memory)
    assert not os.path.exists("out.json")


# Structures over elements that share a corner.

def work_of(size):
    """All that the structures count, over all engines and rays, and the bytes that they take."""
    fan("fan.json", size)
    text = subprocess.run([durero, "stats", "fan.json", "--format", "json", "--no-times"], check=True,
                          stdout=subprocess.PIPE, timeout=PATIENCE).stdout
    engines = json.loads(text)["engines"]
    assert len(engines) > 10
    counted = ("volumes", "nodes", "cells", "candidates")
    return (sum(engine["work"][key] for engine in engines for key in counted),
            sum(engine["size"][key] for engine in engines for key in ("nodes", "cells", "references")))


def test_structures_of_twice_as_many_triangles_of_a_fan_are_twice_as_much():
    work, size = zip(*(work_of(count) for count in (500, 1000, 2000)))
    print(f"  work {work}, size {size}")
    for counts in work, size:
        for once, twice in zip(counts, counts[1:]):
            assert twice < 2.6 * once, counts


# What is told of many errors.

def seconds(*arguments):
    return min(usage(2, *arguments).ru_utime for _ in range(2))


def test_ten_times_as_many_errors_take_about_ten_times_as_long():
    times = []
    for count in 2000, 20000:
        write("scene.json", HEAD + ",\n".join('{"id":"s%d","tipo":"esfera","centro":[0,0,0],"radio":0}' % i
                                              for i in range(count)) + "]}\n")
        times.append(seconds("check", "scene.json", "--format", "json"))
    print(f"  {times[0]:.3f} and {times[1]:.3f} s")
    assert times[1] < 30 * times[0], times


sys.exit(run_tests(globals()))
