#!/bin/sh
# Each name of the Z text stands in the table of src/text/spanish.cpp with its English, and docs/spanish.md shows the table:
# spanish.py tells what is missing or stale, and with --write writes the page.
PYTHONDONTWRITEBYTECODE=1 python3 "$(dirname "$0")/spanish.py" "$@"
