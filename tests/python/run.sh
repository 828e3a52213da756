#!/bin/sh
# run.sh PYTHON FILE: runs the tests of a file, or is skipped where pytest is absent.
"$1" -c 'import pytest' 2>/dev/null || { echo "absent: pytest (python3-pytest of Debian)"; exit 77; }
cd "${2%/*}" || exit 2
PYTHONDONTWRITEBYTECODE=1 exec "$1" -m pytest -q -p no:cacheprovider -c /dev/null --rootdir . "$2"
