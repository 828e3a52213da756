"""The command line."""

from __future__ import annotations

import argparse
import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Arguments:
    """What the command line said."""

    campaign: Path
    output: Path
    workers: int
    scheduler: str | None
    durero: str
    window: int | None
    retries: int
    twice: float


def read_arguments(words: list[str] | None = None) -> Arguments:
    """Reads the command line; argparse ends the program with status 2 where it is bad."""
    parser = argparse.ArgumentParser(
        prog="durero_campaign",
        description="Computes the shards of a campaign that DIR lacks, and merges all. Stop it at will; call it again to go on.",
        epilog="Exit status: 0 done; 1 shards differ or are missing; 2 the call or its input is bad, or the scheduler is "
        "gone; 130 stopped.",
    )
    parser.add_argument("campaign", metavar="CAMPAIGN", type=Path, help="the campaign's file")
    parser.add_argument("--output", metavar="DIR", type=Path, required=True, help="where shards are kept")
    where = parser.add_mutually_exclusive_group()
    where.add_argument("--workers", metavar="N", type=at_least(1), default=os.cpu_count() or 1,
                       help="workers on this machine (default: one a core)")
    where.add_argument("--scheduler", metavar="ADDRESS", help="a Dask scheduler, as tcp://HOST:8786, whose workers are asked")
    parser.add_argument("--durero", metavar="PATH", default="durero", help="the program, here and on the workers")
    parser.add_argument("--window", metavar="N", type=at_least(1), help="shards submitted at a time (default: two a worker)")
    parser.add_argument("--retries", metavar="N", type=at_least(0), default=3, help="calls of a shard that failed (default: 3)")
    parser.add_argument("--twice", metavar="SHARE", type=share, default=0.01,
                        help="of the shards, asked twice and compared (default: 0.01)")
    return Arguments(**vars(parser.parse_args(words)))


def at_least(least: int) -> Callable[[str], int]:
    """Reads a whole number that is no smaller."""

    def whole_number(word: str) -> int:
        number = int(word)
        if number < least:
            raise argparse.ArgumentTypeError(f"{word} is less than {least}")
        return number

    return whole_number


def share(word: str) -> float:
    """A number from 0 to 1."""
    number = float(word)
    if not 0 <= number <= 1:
        raise argparse.ArgumentTypeError(f"{word} is no number from 0 to 1")
    return number
