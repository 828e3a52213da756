"""A run: the shards that its folder lacks are computed, those asked twice compared, and all merged at the end."""

from __future__ import annotations

import subprocess
from collections import deque
from collections.abc import Iterator
from pathlib import Path

from .campaign import Campaign, CampaignError
from .folder import Folder, shard_path, shards_in, write_whole
from .progress import Progress
from .shard import Shard, ShardFailed
from .window import Calls, Task, ended_tasks


class Run:
    """What is there, and what is still to be done."""

    def __init__(self, campaign: Campaign, folder: Folder, twice: float) -> None:
        self._campaign = campaign
        self._folder = folder
        self._twice = twice
        self._first = shards_in(folder.shards)
        self._second = shards_in(folder.again)
        self._urgent: deque[Task] = deque()
        wanted = campaign.shards + sum(map(self._is_asked_twice, range(campaign.shards)))
        self._progress = Progress(len(self._first) + len(self._second), wanted, campaign.rays_of_a_shard)
        self._failed = 0
        self._differing = 0

    def compute(self, calls: Calls, window: int | None) -> None:
        """Computes what is lacking; a shard that fails is named and left out, a call that can never succeed ends all."""
        try:
            for ended in ended_tasks(calls, self._lacking(), self._urgent, window):
                for task, came in ended:
                    self._keep(task, came) if isinstance(came, Shard) else self._fail(task, came)
                self._progress.show()
        finally:
            self._progress.clear()

    def is_over(self) -> bool:
        """Whether nothing is lacking."""
        return next(self._lacking(), None) is None

    def status(self) -> int:
        """1 where shards differ or are lacking."""
        return 1 if self._differing or self._failed else 0

    def there(self) -> str:
        """How far the run has come."""
        return f"{len(self._first)} of {self._campaign.shards} shards are there"

    def _is_asked_twice(self, number: int) -> bool:
        return self._campaign.is_asked_twice(number, self._twice)

    def _lacking(self) -> Iterator[Task]:
        for number in range(self._campaign.shards):
            if number not in self._first:
                yield Task(number)
            elif number not in self._second and self._is_asked_twice(number):
                yield Task(number, again=True)

    def _keep(self, task: Task, shard: Shard) -> None:
        write_whole(shard_path(self._folder.again if task.again else self._folder.shards, task.number), shard.text)
        (self._second if task.again else self._first).add(task.number)
        self._progress.count()
        if task.again:
            self._compare(task, shard)
        elif self._is_asked_twice(task.number):
            self._urgent.append(Task(task.number, again=True, other_than=shard.worker))

    def _compare(self, task: Task, shard: Shard) -> None:
        if shard_path(self._folder.shards, task.number).read_bytes() != shard.text:
            self._differing += 1
            self._progress.say(f"shard {task.number}: two runs gave different answers; the second ran on {shard.worker}")

    def _fail(self, task: Task, error: Exception) -> None:
        if isinstance(error, ShardFailed) and error.status == 2:
            raise CampaignError(f"shard {task.number}: {error}")
        self._failed += 1
        self._progress.say(f"shard {task.number}: {error}")


def merge(durero: str, campaign: Path, folder: Folder) -> int:
    """Calls `durero conform merge`, whose words and exit status are those of the run."""
    command = [durero, "conform", "merge", str(campaign), str(folder.shards), str(folder.again)]
    return subprocess.run([*command, "--output", str(folder.merged)], check=False).returncode
