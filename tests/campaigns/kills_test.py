"""What a long campaign meets: systems that crash, hang and answer by chance, workers and schedulers that are killed.

kills_test.py DURERO. Whatever happens, the bytes at the end are those of shards computed by hand.
"""
import json
import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile

from support import Tester, python_with_dask, write_campaign


def workers_of(pid):
    """The worker processes of a run, which Dask starts by multiprocessing."""
    for task in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            parent = int((task / "stat").read_text().rsplit(")", 1)[1].split()[1])
            if parent == pid and b"spawn_main" in (task / "cmdline").read_bytes():
                yield int(task.name)
        except OSError:
            continue  # it ended meanwhile


def verdicts(merged):
    """How many rays have each verdict."""
    names = merged["verdicts"]
    sums = dict.fromkeys(names, 0)
    for shard in merged["shards"]:
        for family in shard["families"]:
            for name, count in zip(names, family[0] if family else []):
                sums[name] += count
    return sums


def test_numbers_of_workers(test, campaign, expected):
    for workers in ("1", "2", "7"):
        output = "workers-" + workers
        test.run(0, campaign, output, "--workers", workers)
        test.expect(test.merged(output) == expected, "%s workers: the same bytes" % workers)


def test_kill_workers(test, campaign, expected):
    """A worker dies, then the process that is also the scheduler; then the run is stopped politely, and goes on."""
    run = test.start(campaign, "killed", "--workers", "2")
    test.wait_for("killed", 2)
    victims = list(workers_of(run.pid))
    test.expect(len(victims) == 2, "two workers are there")
    os.kill(victims[0], signal.SIGKILL)
    test.wait_for("killed", 4)
    run.kill()
    run.communicate()
    run = test.start(campaign, "killed", "--workers", "2")
    test.wait_for("killed", 7)
    run.send_signal(signal.SIGINT)
    said = run.communicate()[1]
    test.expect(run.returncode == 130 and "stopped" in said, "SIGINT: status %d, %s" % (run.returncode, said))
    test.expect(not list((test.folder / "killed").rglob("*.part")), "nothing is half written")
    test.run(0, campaign, "killed", "--workers", "2")
    test.expect(test.merged("killed") == expected, "after a worker and the run were killed: the same bytes")


class Cluster:
    """A scheduler and two workers, each a process of its own."""

    def __init__(self, test):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        self.address = "tcp://127.0.0.1:%d" % port
        self.scheduler = self._start(test, "dask_scheduler", "--host", "127.0.0.1", "--port", str(port))
        self.workers = [self._start(test, "dask_worker", self.address, "--nthreads", "1") for _ in range(2)]

    def _start(self, test, program, *options):
        command = [test.python, "-m", "distributed.cli." + program, "--no-dashboard", *options]
        return subprocess.Popen(command, env=test.environment, cwd=test.folder,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def end(self):
        for process in (*self.workers, self.scheduler):
            process.terminate()
            process.wait()


def test_kill_scheduler(test, campaign, expected):
    cluster = Cluster(test)
    run = test.start(campaign, "scheduled", "--scheduler", cluster.address)
    test.wait_for("scheduled", 4)
    cluster.scheduler.kill()
    said = run.communicate()[1]
    cluster.end()
    test.expect(run.returncode == 2 and "the scheduler is gone" in said and "Traceback" not in said, "status %d: %s" % (run.returncode, said))
    cluster = Cluster(test)
    test.run(0, campaign, "scheduled", "--scheduler", cluster.address)
    cluster.end()
    test.expect(test.merged("scheduled") == expected, "after the scheduler was killed: the same bytes")


def test_chance(test, folder):
    said = test.run(1, write_campaign(folder, "random"), "random", "--workers", "2", "--twice", "0.5")
    named = said.count("two runs gave different answers")
    test.expect(named == len(list((test.folder / "random" / "again").iterdir())) > 0, "what was asked twice differs: %d" % named)


def main():
    python = python_with_dask(installs=True)
    with tempfile.TemporaryDirectory() as folder:
        test = Tester(python, folder)
        campaign = write_campaign(folder, "crashes")
        expected = test.by_hand(campaign)
        counts = verdicts(json.loads(expected))
        test.expect(30 < counts["crashed"] < 120 and 0 < counts["hung"] < 20, "some rays crash it, fewer hang it: %s" % counts)
        test_numbers_of_workers(test, campaign, expected)
        test_kill_workers(test, campaign, expected)
        test_kill_scheduler(test, campaign, expected)
        test_chance(test, folder)
    sys.exit(1 if test.failures else 0)


main()
