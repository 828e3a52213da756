"""A sliding window of calls: as many are with the scheduler as keep its workers busy, never all of a campaign."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from concurrent.futures import CancelledError
from dataclasses import dataclass
from typing import Union

import distributed

from .campaign import Campaign, CampaignError
from .shard import Shard, compute_shard


@dataclass(frozen=True)
class Task:
    """A shard to compute: for the first time, or again, on another worker than the first where there is one."""

    number: int
    again: bool = False
    other_than: str = ""


Ended = tuple[Task, Union[Shard, Exception]]


@dataclass(frozen=True)
class Calls:
    """How tasks are handed to the scheduler."""

    client: distributed.Client
    campaign: Campaign
    durero: str
    retries: int

    def submit(self, task: Task) -> distributed.Future:
        """The key is the task's own, so that the scheduler never takes one for another."""
        others = [worker for worker in self.client.nthreads() if worker != task.other_than] if task.other_than else None
        return self.client.submit(
            compute_shard, self.durero, self.campaign.path, self.campaign.text, task.number,
            key=f"shard-{task.number}-{'again' if task.again else 'first'}-{self.campaign.digest}",
            retries=self.retries, workers=others or None, allow_other_workers=bool(others),
        )

    def busy(self) -> int:
        """How many tasks keep every worker busy while ended ones are fetched."""
        return 2 * max(1, sum(map(int, self.client.nthreads().values())))


def ended_tasks(calls: Calls, tasks: Iterator[Task], urgent: deque[Task], size: int | None) -> Iterator[list[Ended]]:
    """Yields what has ended, at least once a second. `urgent` is read before `tasks`, and may grow meanwhile."""
    pending: dict[distributed.Future, Task] = {}
    try:
        while True:
            window = size or calls.busy()
            while len(pending) < window:
                task: Task | None = None
                if urgent:
                    task = urgent.popleft()
                else:
                    task = next(tasks, None)
                if task is None:
                    break
                pending[calls.submit(task)] = task
            if not pending:
                return
            yield [(pending.pop(future), outcome(future)) for future in some_done(list(pending))]
    except (CancelledError, OSError) as error:  # nobody here cancels: whoever did is the scheduler, by its end
        raise CampaignError("the scheduler is gone; call durero_campaign again to go on") from error


def some_done(futures: list[distributed.Future]) -> list[distributed.Future]:
    """Those that have ended, after a second at most."""
    try:
        distributed.wait(futures, timeout=1, return_when="FIRST_COMPLETED")
    except distributed.TimeoutError:
        pass
    return [future for future in futures if future.done()]


def outcome(future: distributed.Future) -> Shard | Exception:
    """A shard, or why there is none. Where the worker died after its answer, the scheduler has it computed again."""
    if future.status == "error":
        error = future.exception()
        return error if isinstance(error, Exception) else RuntimeError(repr(error))
    shard = future.result()
    return shard if isinstance(shard, Shard) else RuntimeError(repr(shard))
