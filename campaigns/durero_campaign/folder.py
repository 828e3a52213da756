"""The folder of a run: all that it knows, so that it may be stopped anywhere and called anew.

campaign.json               the campaign
shards/shard-0000007.json   a shard
again/shard-0000007.json    the same shard, asked a second time
merged.json                 what `durero conform merge` makes of them
workers/                    what workers of this machine need meanwhile
"""

from __future__ import annotations

import fcntl
import os
import re
from pathlib import Path

from .campaign import Campaign, CampaignError, read_campaign

SHARD_FILE = re.compile(r"shard-(\d{7,})\.json")


class Folder:
    """A run's folder, which no other run works in until this process ends, however that does."""

    def __init__(self, path: Path, campaign: Campaign) -> None:
        self.path = path
        self.shards = path / "shards"
        self.again = path / "again"
        self.merged = path / "merged.json"
        self.workers = path / "workers"
        for folder in (self.shards, self.again):
            folder.mkdir(parents=True, exist_ok=True)
        self._descriptor = os.open(path, os.O_RDONLY)
        try:
            fcntl.flock(self._descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            raise CampaignError(f"{path}: another durero_campaign is at work there") from error
        kept = path / "campaign.json"
        if kept.exists() and read_campaign(kept).digest != campaign.digest:
            raise CampaignError(f"{path}: it is of another campaign; expected a folder of its own for each")
        write_whole(kept, campaign.text)


def shard_path(folder: Path, number: int) -> Path:
    """Where a shard lies; the name is the one that `durero conform shard` gives."""
    return folder / f"shard-{number:07}.json"


def shards_in(folder: Path) -> set[int]:
    """The numbers of the shards that a folder has."""
    names = (SHARD_FILE.fullmatch(entry.name) for entry in os.scandir(folder))
    return {int(name[1]) for name in names if name}


def write_whole(path: Path, text: bytes) -> None:
    """Writes a file that is there whole or not at all; what a killed run left is written over by the next."""
    part = path.with_name(path.name + ".part")
    with open(part, "wb") as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())
    part.replace(path)
