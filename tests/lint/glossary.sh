#!/bin/sh
# docs/glossary.md says of each public type the first sentence of its comment: glossary.py tells where it is stale, and
# with --write writes it.
git ls-files 'include/durero/*.hpp' | xargs python3 "$(dirname "$0")/glossary.py" "$@"
