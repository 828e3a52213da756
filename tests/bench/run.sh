#!/bin/sh
# run.sh BUILD [BENCHMARK_OPTION...]: every benchmark program, then the instructions of an edit. Figures are ratios taken
# in one run where they compare; absolute ones drift from machine to machine.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
build=$1
shift
for bench in "$build"/bench/*_bench; do
  [ -x "$bench" ] || continue
  echo "== ${bench##*/}"
  "$bench" "$@"
done
if ninja -C "$build" -t query python_bench >/dev/null 2>&1; then
  echo "== a million rays by Python and by C++"
  ninja -C "$build" --quiet python_bench
fi
echo "== instructions a checked add/remove pair takes"
sh "$here/instructions.sh" "$build"
