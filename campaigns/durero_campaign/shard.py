"""What a worker does: it calls `durero conform shard`, as anyone may by hand, and hands back the bytes of its file."""

from __future__ import annotations

import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from distributed import get_worker


class ShardFailed(Exception):
    """A call that gave no shard; its `status` is the program's, below 0 where a signal ended it."""

    def __init__(self, message: str, status: int) -> None:
        super().__init__(message, status)
        self.message = message
        self.status = status

    def __str__(self) -> str:
        return self.message


@dataclass(frozen=True)
class Shard:
    """The bytes of a shard's file, and the address of the worker that they are from."""

    text: bytes
    worker: str


def compute_shard(durero: str, path: Path, campaign: bytes, number: int) -> Shard:
    """Asks the system the rays of one shard, in a folder of its own that is gone afterwards. A campaign may name files
    beside it: it is read where it lies, if this machine has the same at its path."""
    worker = get_worker()
    with tempfile.TemporaryDirectory(dir=worker.local_directory) as folder:
        if not (path.is_file() and path.read_bytes() == campaign):
            path = Path(folder, "campaign.json")
            path.write_bytes(campaign)
        written = Path(folder, "shard.json")
        arguments = ["conform", "shard", str(path), str(number), "--jobs", "1", "--output", str(written)]
        call(durero, arguments, worker.address)
        return Shard(written.read_bytes(), worker.address)


def call(durero: str, arguments: list[str], worker: str) -> None:
    """Calls the program; where it fails, its last line says why, and ours says where."""
    if shutil.which(durero) is None:
        raise ShardFailed(f"{worker}: there is no {durero}; expected its path by --durero", 2)
    ended = subprocess.run(
        [*dies_with_its_worker(), durero, *arguments],
        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
    )
    if ended.returncode != 0:
        said = ended.stderr.decode(errors="replace").strip().splitlines()
        why = said[-1] if said else "it said nothing"
        raise ShardFailed(f"{worker}: status {ended.returncode}: {why}", ended.returncode)


def dies_with_its_worker() -> list[str]:
    """Before a command: where Linux can, a worker that is killed takes the program with it."""
    return ["setpriv", "--pdeathsig", "KILL"] if shutil.which("setpriv") else []
