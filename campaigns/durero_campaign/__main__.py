"""The command `durero_campaign`, which is also `python -m durero_campaign`."""

from __future__ import annotations

import logging
import shutil
import signal
import sys
from contextlib import AbstractContextManager

from distributed import Client

from .arguments import Arguments, read_arguments
from .campaign import CampaignError, read_campaign
from .cluster import local_workers, workers_of
from .folder import Folder
from .run import Run, merge
from .window import Calls


def main() -> int:
    """Runs the command; its exit status."""
    arguments = read_arguments()
    logging.disable()  # Dask tells its own story at length; what a user needs to know is said in our words
    for stop in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(stop, signal.default_int_handler)
    try:
        return run(arguments)
    except CampaignError as error:
        print(f"durero_campaign: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return 130


def run(arguments: Arguments) -> int:
    """Computes what is lacking, and merges."""
    if shutil.which(arguments.durero) is None:
        raise CampaignError(f"there is no {arguments.durero}; expected its path by --durero")
    campaign = read_campaign(arguments.campaign)
    folder = Folder(arguments.output, campaign)
    this_run = Run(campaign, folder, arguments.twice)
    if not this_run.is_over():
        try:
            with workers(arguments, folder) as client:
                this_run.compute(Calls(client, campaign, arguments.durero, arguments.retries), arguments.window)
        except (CampaignError, KeyboardInterrupt):
            print(f"durero_campaign: stopped; {this_run.there()}", file=sys.stderr)
            raise
    return merge(arguments.durero, arguments.campaign, folder) or this_run.status()


def workers(arguments: Arguments, folder: Folder) -> AbstractContextManager[Client]:
    """Who computes."""
    if arguments.scheduler is None:
        return local_workers(arguments.workers, folder.workers)
    return workers_of(arguments.scheduler)


if __name__ == "__main__":
    sys.exit(main())
