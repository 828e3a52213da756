#!/bin/sh
# run.sh TEST.mjs SOURCES OUT [WEB_CALL]: runs a test of the page under node, and says so where node or Chromium is absent.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
command -v node >/dev/null 2>&1 || { echo "no node: $1 is not run"; exit 77; }
chromium=$(command -v chromium || command -v chromium-browser) || chromium=
if [ "$1" = page_test.mjs ] && [ -z "$chromium" ]; then echo "no chromium: $1 is not run"; exit 77; fi
engine=$2/build/wasm/durero.js  # where ./x page has built it
[ -f "$engine" ] || engine=
mkdir -p "$3/${1%.mjs}"
DURERO_ROOT=$2 DURERO_OUT=$3/${1%.mjs} DURERO_CALL=${4-} DURERO_CHROMIUM=$chromium DURERO_ENGINE=$engine exec node --test --test-reporter=spec "$here/$1"
