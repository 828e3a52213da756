#!/bin/sh
# The search of src/trace/search-inl.hpp and the one extracted from proofs/Search.v and proofs/Occlusion.v, on the same
# random tables of what each step answers: what both have found, what they publish, and what blocks, line by line. Then
# the same of a search in whose tables a fault is planted. The answers of the first tables of seed 1 are recorded in
# tests/trace/search_answers.txt, where tests without Coq find them: they are the model's.
#   search.sh SEARCH_TABLES BUILD_DIRECTORY
set -eu
command -v coqc >/dev/null 2>&1 || { echo "skipped: coqc is absent; install coq, or run ./x test"; exit 77; }
tables=$1 build=$2
tests=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
"$tests/../proofs/build.sh" "$build" >/dev/null
"$tests/../proofs/oracle/build.sh" "$build" >/dev/null
out=$build/oracle
seed=${SEED:-$(date +%s)} first=${FIRST:-0} count=${COUNT:-100000}
echo "replay with SEED=$seed FIRST=$first COUNT=$count"

"$tables" "$count" "$seed" "$first" "$out/tables.txt" "$out/code.txt"
"$out/tables" <"$out/tables.txt" >"$out/model.txt"
cmp -s "$out/code.txt" "$out/model.txt" || {
  line=$(cmp "$out/code.txt" "$out/model.txt" 2>&1 | sed 's/.*line *//; s/.*after byte.*/1/')
  echo "the search and its model differ at table $((first + line - 1)); replay with SEED=$seed FIRST=$((first + line - 1)) COUNT=1"
  for side in code model; do echo "$side: $(sed -n "${line}p" "$out/$side.txt")"; done
  sed -n "$((line + 1))s/^/table: /p" "$out/tables.txt"
  exit 1
}
[ "$(wc -l <"$out/model.txt")" -eq "$count" ] || { echo "not every table was answered"; exit 1; }

recorded=$tests/trace/search_answers.txt
"$tables" "$(wc -l <"$recorded")" 1 0 "$out/tables.txt" "$out/code.txt"
"$out/tables" <"$out/tables.txt" | diff "$recorded" - >"$out/recorded.txt" ||
  { echo "tests/trace/search_answers.txt does not record what the model answers:"; head "$out/recorded.txt"; exit 1; }

"$tables" 1000 "$seed" 0 "$out/tables.txt" "$out/code.txt" fault
"$out/tables" <"$out/tables.txt" >"$out/model.txt"
seen=$(paste -d '\n' "$out/code.txt" "$out/model.txt" | awk 'NR % 2 { code = $0; next } $0 != code { ++n } END { print n + 0 }')
[ "$seen" -ge 100 ] || { echo "of 1000 tables with a planted fault $seen are seen"; exit 1; }
