#!/bin/sh
# instructions.sh [BUILD]: instructions a checked add/remove pair takes in scenes of 10³ and of 10⁶ elements, counted by
# callgrind, and what contracts add to them. Fails where 10⁶ takes over 20 % more than 10³. BUILD: build/release.
set -eu
bench=${1:-build/release}/bench/scene_bench
pairs=20000
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
command -v valgrind >/dev/null || { echo "valgrind is not installed: not counted"; exit 77; }

count() {  # count NAME ELEMENTS: instructions a pair
  DURERO_PAIRS=$pairs valgrind --tool=callgrind --callgrind-out-file="$out/count" --collect-atstart=no \
    --toggle-collect='*edit_pair*' "$bench" --benchmark_filter="^pairs/$1/$2/" >"$out/log" 2>&1 ||
    { cat "$out/log" >&2; exit 1; }
  awk -v pairs=$pairs '/^(summary|totals):/ { total = $2 } END { if (!total) exit 1; printf "%.0f\n", total / pairs }' "$out/count"
}

for contracts in checked ignored; do
  small=$(count $contracts 1000)
  large=$(count $contracts 1000000)
  awk -v what=$contracts -v small="$small" -v large="$large" 'BEGIN {
    printf "%s: %d instructions a pair at 10^3 elements, %d at 10^6 (%+.1f %%)\n", what, small, large, 100 * (large / small - 1) }'
  [ $((large * 100)) -le $((small * 120)) ] || { echo "over 20 % more at 10^6 than at 10^3"; exit 1; }
done
