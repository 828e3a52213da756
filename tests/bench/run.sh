#!/bin/sh
# run.sh BUILD --vs embree [OPTION...]: the engine `fast` beside Embree, by versus/embree_bench, which knows the options.
# run.sh BUILD --vs povray [SCENE...]: `durero render` beside POV-Ray, by docs/figures/povray.py, which knows the scenes.
# run.sh BUILD [BENCHMARK_OPTION...]: every benchmark program, then the instructions of an edit. Figures are ratios taken
# in one run where they compare; absolute ones drift from machine to machine.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
build=$1
shift
if [ "${1-}" = --vs ]; then
  case ${2-} in
    embree)
      [ -x "$build/versus/embree_bench" ] ||
        { echo "durero: there is no Embree 3, or it came after the build was configured" >&2; exit 2; }
      shift 2
      exec "$build/versus/embree_bench" "$@" ;;
    povray)
      command -v povray >/dev/null || { echo "durero: there is no POV-Ray (Debian: povray)" >&2; exit 2; }
      shift 2
      exec python3 "$here/../../docs/figures/povray.py" "$build/durero" "$@" ;;
    *) echo "durero: --vs ${2-}: nothing to compare with; expected embree or povray" >&2; exit 2 ;;
  esac
fi
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
