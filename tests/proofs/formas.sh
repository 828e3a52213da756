#!/bin/sh
# proofs/Formas.v is what the templates of the tracer compute now.
#   formas.sh FORMAS
set -eu
written=$(CDPATH='' cd -- "$(dirname -- "$0")/../../proofs" && pwd)/Formas.v
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
"$1" >"$tmp/Formas.v"
diff -u "$written" "$tmp/Formas.v" || {
  echo "proofs/Formas.v is not what the tracer computes; if it should compute that: $1 >proofs/Formas.v"
  exit 1
}
