"""The workers: a cluster of one's own on this machine, or one whose scheduler is running already."""

from __future__ import annotations

import logging
import shutil
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import distributed

from .campaign import CampaignError


@contextmanager
def local_workers(number: int, folder: Path) -> Iterator[distributed.Client]:
    """Worker processes on this machine, which end with this one; what they write meanwhile is in a folder of theirs."""
    shutil.rmtree(folder, ignore_errors=True)  # of a run that was killed
    try:
        with distributed.LocalCluster(
            n_workers=number, threads_per_worker=1, processes=True, memory_limit=0, dashboard_address="127.0.0.1:0",
            local_directory=str(folder), silence_logs=logging.CRITICAL,
        ) as cluster, distributed.Client(cluster) as client:
            yield client
    finally:
        shutil.rmtree(folder, ignore_errors=True)


@contextmanager
def workers_of(scheduler: str) -> Iterator[distributed.Client]:
    """The workers of a scheduler, which go on without us."""
    try:
        client = distributed.Client(scheduler, timeout="30s")
    except (OSError, ValueError) as error:
        raise CampaignError(f"{scheduler}: no scheduler answers there ({error})") from error
    with client:
        if not client.nthreads():
            print(f"{scheduler}: no worker is there yet; waiting", file=sys.stderr, flush=True)
        yield client
