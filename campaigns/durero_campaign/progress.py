"""A line on a terminal that says how far a run is; elsewhere nothing."""

from __future__ import annotations

import sys
import time


class Progress:
    """Counts the shards that this run computed, for the rate, and those of the whole campaign, for the rest."""

    def __init__(self, there: int, wanted: int, rays_of_a_shard: int) -> None:
        self._there = there
        self._wanted = wanted
        self._rays = rays_of_a_shard
        self._computed = 0
        self._began = time.monotonic()
        self._is_shown = sys.stderr.isatty()

    def count(self) -> None:
        """One more shard is there."""
        self._there += 1
        self._computed += 1

    def show(self) -> None:
        """Writes the line over the last one."""
        if self._is_shown:
            sys.stderr.write(f"\r\x1b[K{self.line(time.monotonic() - self._began)}")
            sys.stderr.flush()

    def line(self, seconds: float) -> str:
        """The line, where the run has lasted some seconds."""
        counted = f"{self._there} of {self._wanted} shards"
        if self._computed == 0 or seconds <= 0:
            return counted
        rate = self._computed / seconds
        return f"{counted}, {rate * self._rays:.3g} rays/s, {duration((self._wanted - self._there) / rate)} left"

    def say(self, message: str) -> None:
        """Prints a message on a line of its own."""
        self.clear()
        print(message, file=sys.stderr, flush=True)

    def clear(self) -> None:
        """Takes the line away."""
        if self._is_shown:
            sys.stderr.write("\r\x1b[K")


def duration(seconds: float) -> str:
    """A time as people say it: the two largest units."""
    whole = round(seconds)
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60} s"
    if whole < 86400:
        return f"{whole // 3600} h {whole % 3600 // 60} min"
    return f"{whole // 86400} d {whole % 86400 // 3600} h"
