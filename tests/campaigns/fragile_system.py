"""A system as campaigns must bear it: of its rays 1 % crash it and 0.1 % let it hang, or it answers as chance has it.

fragile_system.py crashes|random
"""
import os
import random
import signal
import sys
import time
import zlib


def answer(ray):
    """Which rays it fails on depends on their numbers alone, so that every run sees the same."""
    if sys.argv[1] == "random":
        return "hit - %r" % random.random()
    lot = zlib.crc32(ray.encode()) % 1000
    if lot < 10:
        os.kill(os.getpid(), signal.SIGSEGV)
    if lot == 10:
        time.sleep(3600)
    return "miss"


print("system fragile 1", flush=True)
for line in sys.stdin:
    words = line.split()
    for _ in range(int(words[1]) if words[0] == "rays" else 0):
        print(answer(sys.stdin.readline()), flush=True)
