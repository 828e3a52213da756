#!/bin/sh
# exports.sh MODULE: the module shows how Python begins with it, and no name of the layers or of what they use.
set -eu
shown=$(nm -D --defined-only "$1" | sed 's/^[0-9a-f]* //')
[ "$shown" = 'T PyInit__durero' ] || { printf '%s\n' "$shown" | head -n 20; echo "exports: expected PyInit__durero alone"; exit 1; }
