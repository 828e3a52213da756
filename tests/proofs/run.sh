#!/bin/sh
# Builds the proofs and runs a check on them; 77, which CTest reports as skipped, where Coq is absent.
#   run.sh BUILD_DIRECTORY build | audit | kernel | drill     audit is daily; kernel is of coqchk
#   run.sh BUILD_DIRECTORY update     writes proofs/assumptions.txt and proofs/statements.md; read their difference
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
proofs=$here/../../proofs build=$1 check=$2
command -v coqc >/dev/null 2>&1 || {
  echo "skipped: coqc is absent; install coq, libcoq-flocq and libcoq-coquelicot, or run ./x test"
  exit 77
}
"$proofs/build.sh" "$build"
case $check in
  build) ;;
  audit) exec sh "$here/audit.sh" daily "$proofs" "$build" ;;
  kernel) exec sh "$here/audit.sh" kernel "$proofs" "$build" ;;
  update) exec sh "$here/audit.sh" update "$proofs" "$build" ;;
  drill) exec sh "$here/audit_drill.sh" "$proofs" "$build" ;;
  *) echo "run.sh does not know $check"; exit 2 ;;
esac
