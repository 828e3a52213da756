#!/bin/sh
# 100000 rays with the answers of oracle::exact, judged by the extracted procedure; then the same with planted faults,
# which it must see.
#   oracle.sh ORACLE_RAYS BUILD_DIRECTORY
set -eu
command -v coqc >/dev/null 2>&1 || { echo "skipped: coqc is absent; install coq, or run ./x test"; exit 77; }
rays=$1 build=$2
proofs=$(CDPATH='' cd -- "$(dirname -- "$0")/../../proofs" && pwd)
"$proofs/build.sh" "$build" >/dev/null
"$proofs/oracle/build.sh" "$build" >/dev/null
seed=${SEED:-$(date +%s)}
echo "replay with SEED=$seed"
"$rays" 100000 "$seed" >"$build/oracle/rays.txt"
"$build/oracle/oracle" <"$build/oracle/rays.txt"
"$rays" 20000 "$seed" fault >"$build/oracle/faults.txt"
status=0
"$build/oracle/oracle" <"$build/oracle/faults.txt" >"$build/oracle/seen.txt" || status=$?
[ "$status" = 1 ] || { echo "the oracle did not see the planted faults: exit status $status"; exit 1; }
