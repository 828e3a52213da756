"""Runs the tests of a file, `FILE DURERO [TEST...]`: all, or those named, each in a folder of its own."""
import os
import sys
import tempfile
import traceback


def is_sanitized(durero):
    """What a sanitizer adds to a program is no memory of the program."""
    with open(durero, "rb") as file:
        text = file.read()
    return b"__asan_init" in text or b"__tsan_init" in text


def run_tests(named, prepare=lambda: None):
    """Runs the functions test_… among those names, after `prepare` in each folder. Whether one has failed."""
    tests = sys.argv[2:] or [name for name in named if name.startswith("test_")]
    failures = 0
    for name in tests:
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            prepare()
            print(name.replace("_", " "), flush=True)
            try:
                named[name]()
            except Exception:  # whatever it is, the others are tried
                failures += 1
                traceback.print_exc(limit=-3, file=sys.stdout)
            os.chdir("/")
    print(f"{len(tests)} tests, {failures} failures")
    return failures > 0
