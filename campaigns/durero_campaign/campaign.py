"""What this package reads of a campaign: how many shards there are, and how many rays one has."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path


class CampaignError(Exception):
    """The call or its input is bad, or the cluster is gone: the run ends with this one line."""


@dataclass(frozen=True)
class Campaign:
    """A campaign's file, its bytes and its two sizes; `durero` itself reads and refuses the rest."""

    path: Path
    text: bytes
    shards: int
    rays_of_a_shard: int

    @cached_property
    def digest(self) -> str:
        """What tells one campaign from another; a longer one is the same, and so is one whose keys are in other order."""
        keys = {key: value for key, value in json.loads(self.text).items() if key != "shards"}
        return hashlib.sha256(json.dumps(keys, sort_keys=True).encode()).hexdigest()

    def is_asked_twice(self, number: int, share: float) -> bool:
        """Whether a shard is among the share of those that are asked twice: the same ones on every machine and day."""
        hashed = hashlib.sha256(f"{self.digest}/{number}".encode()).digest()
        return int.from_bytes(hashed[:8], "big") < share * 2**64


def read_campaign(path: Path) -> Campaign:
    """Reads a campaign's sizes, and refuses a file that has none."""
    try:
        text = path.read_bytes()
        keys = json.loads(text)
        sizes = [keys[key] for key in ("shards", "rays_of_a_shard")]
    except OSError as error:
        raise CampaignError(f"{path}: {error.strerror}") from error
    except (ValueError, KeyError, TypeError) as error:
        raise CampaignError(f"{path}: no campaign ({error!r}); expected a JSON object with shards, rays_of_a_shard") from error
    if not all(type(size) is int and size >= 0 for size in sizes):
        raise CampaignError(f"{path}: no campaign; expected whole numbers as shards and rays_of_a_shard")
    return Campaign(path.absolute(), text, *sizes)
