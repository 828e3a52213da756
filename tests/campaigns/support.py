"""What the tests of durero_campaign share: a Python that has Dask, campaigns, and the bytes that they must end with."""
import json
import os
import pathlib
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
SOURCES = HERE.parents[1]
VENV = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache", "durero", "dask")


def has_dask(python):
    return os.access(python, os.X_OK) and subprocess.run([python, "-c", "import distributed"], capture_output=True).returncode == 0


def python_with_dask(installs=False):
    """Where there is none, the test installs one from PyPI, or is skipped, which is no pass."""
    pythons = [str(VENV / "bin" / "python"), sys.executable, "/usr/bin/python3"]
    if installs and not any(map(has_dask, pythons)):
        subprocess.run([sys.executable, "-m", "venv", str(VENV)])
        subprocess.run([pythons[0], "-m", "pip", "install", "--quiet", "distributed"])
    for python in filter(has_dask, pythons):
        return python
    print("absent: Dask distributed (python3-distributed of Debian, distributed of PyPI)")
    sys.exit(77)


def write_campaign(folder, asked, **keys):
    """A campaign's file: `asked` is durero, or the word that fragile_system.py is given."""
    campaign = {"format": "durero-campaign", "version": 1, "system": "durero", "seed": 1, "rays_of_a_shard": 512,
                "shards": 12, "families": ["generic"], "types": ["esfera"], "time": 2, **keys}
    if asked != "durero":
        campaign["system"] = "command:%s %s %s" % (sys.executable, HERE / "fragile_system.py", asked)
        campaign["profile"] = str(SOURCES / "systems" / "examples" / "sphere.json")
    path = pathlib.Path(folder, "campaign-%s.json" % asked)
    path.write_text(json.dumps(campaign))
    return path


class Tester:
    """Runs the program and the package, and counts what is not as expected."""

    def __init__(self, python, folder):
        self.durero = os.path.abspath(sys.argv[1])
        self.python = python
        self.folder = pathlib.Path(folder)
        self.environment = dict(os.environ, PYTHONPATH=str(SOURCES / "campaigns"))
        self.failures = 0

    def expect(self, holds, what):
        print("%s: %s" % ("ok" if holds else "FAILED", what), flush=True)
        self.failures += not holds

    def by_hand(self, campaign, shards=12):
        """What is merged of shards that were computed one after the other, without Dask."""
        folder = self.folder / ("by-hand-" + campaign.stem)
        folder.mkdir()
        for number in range(shards):
            subprocess.run([self.durero, "conform", "shard", campaign, str(number), "--output", folder / ("%d.json" % number)],
                           check=True, stdout=subprocess.DEVNULL)
        merged = folder.with_suffix(".json")
        subprocess.run([self.durero, "conform", "merge", campaign, folder, "--output", merged],
                       check=True, stdout=subprocess.DEVNULL)
        return merged.read_bytes()

    def start(self, campaign, output, *options):
        command = [self.python, "-m", "durero_campaign", campaign, "--output", self.folder / output, "--durero", self.durero]
        return subprocess.Popen([*command, *options], env=self.environment, cwd=self.folder,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def run(self, status, campaign, output, *options):
        """Expects the exit status; what was said on standard error."""
        process = self.start(campaign, output, *options)
        said, errors = process.communicate()
        self.expect(process.returncode == status, "durero_campaign %s %s: status %d, expected %d"
                    % (output, " ".join(options), process.returncode, status))
        if process.returncode != status:
            print(said + errors)
        return errors

    def merged(self, output):
        path = self.folder / output / "merged.json"
        return path.read_bytes() if path.exists() else None

    def shards(self, output):
        return sorted((self.folder / output / "shards").glob("shard-*.json"))

    def wait_for(self, output, shards):
        """Until so many shards are there: in mid-run."""
        end = time.monotonic() + 120
        while len(self.shards(output)) < shards and time.monotonic() < end:
            time.sleep(0.05)
        self.expect(shards <= len(self.shards(output)) < 12, "%s is in mid-run" % output)
