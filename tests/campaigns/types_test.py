"""durero_campaign is typed throughout: mypy --strict finds nothing, where there is a mypy."""
import pathlib
import shutil
import subprocess
import sys

if shutil.which("mypy") is None:
    print("absent: mypy")
    sys.exit(77)
package = pathlib.Path(__file__).resolve().parents[2] / "campaigns"
sys.exit(subprocess.run(["mypy", "--cache-dir", "/dev/null"], cwd=package).returncode)
