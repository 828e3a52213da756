"""A system that crashes on one ray of a hundred, and hangs on one of a thousand; it misses all others. Which those are
the ray alone says, so that it does so again. With an argument it is another version of itself."""
import os
import signal
import sys
import time
import zlib

sys.stdout.write("system flaky %s\n" % (sys.argv[1] if len(sys.argv) > 1 else "1"))
sys.stdout.flush()
for line in sys.stdin:
    if not line.startswith("rays "):
        continue
    for ray in [sys.stdin.readline() for _ in range(int(line.split()[1]))]:
        lot = zlib.crc32(ray.encode()) % 1000
        if lot < 10:
            os.kill(os.getpid(), signal.SIGSEGV)
        if lot == 10:
            time.sleep(60)
        sys.stdout.write("miss\n")
        sys.stdout.flush()
