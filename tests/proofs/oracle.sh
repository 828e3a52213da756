#!/bin/sh
# The answers of surface::exact and of the certified tracer, judged by the extracted procedure; then claims among which
# faults are planted, of which it must see each and nothing else.
#   oracle.sh ORACLE_RAYS BUILD_DIRECTORY
set -eu
command -v coqc >/dev/null 2>&1 || { echo "skipped: coqc is absent; install coq, or run ./x test"; exit 77; }
rays=$1 build=$2
proofs=$(CDPATH='' cd -- "$(dirname -- "$0")/../../proofs" && pwd)
"$proofs/build.sh" "$build" >/dev/null
"$proofs/oracle/build.sh" "$build" >/dev/null
out=$build/oracle
seed=${SEED:-$(date +%s)}
echo "replay with SEED=$seed"
"$rays" 100000 "$seed" exact >"$out/exact.txt"
"$out/oracle" <"$out/exact.txt"
"$rays" 4000 "$seed" trace >"$out/trace.txt"
"$out/oracle" <"$out/trace.txt"

"$rays" 20000 "$seed" exact >"$out/right.txt"
"$rays" 20000 "$seed" exact fault >"$out/faults.txt"
awk 'NR == FNR { right[FNR] = $0; next } right[FNR] != $0 { print FNR }' "$out/right.txt" "$out/faults.txt" >"$out/planted.txt"
[ "$(wc -l <"$out/planted.txt")" -ge 400 ] || { echo 'too few faults are planted'; exit 1; }
status=0
"$out/oracle" <"$out/faults.txt" >"$out/said.txt" || status=$?
[ "$status" = 1 ] || { echo "the oracle did not see the planted faults: exit status $status"; exit 1; }
sed -n 's/^line \([0-9]*\): wrong: .*/\1/p' "$out/said.txt" >"$out/seen.txt"
diff "$out/planted.txt" "$out/seen.txt" || { echo "the oracle saw other faults than were planted: < planted, > seen"; exit 1; }
