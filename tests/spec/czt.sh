#!/bin/sh
# czt.sh [FILE...]: type-checks the Z text (default: spec/*.tex) with CZT, an independent tool, in one JVM.
# Exit status: 0 no error; 1 errors, one a line as FILE:LINE: message; 77 CZT is absent.
# CZT has no package: czt_build.sh builds a jar of it, which CZT_JAR names.
set -eu

if [ -z "${CZT_JAR:-}" ]; then
  echo "skipped: CZT absent (set CZT_JAR to the path of czt.jar)"
  exit 77
fi
if ! command -v java >/dev/null; then
  echo "skipped: CZT absent (no java to run $CZT_JAR with)"
  exit 77
fi
[ $# -gt 0 ] || set -- "$(dirname "$0")"/../../spec/*.tex

# CZT reads a section once, so parents must come before the sections that name them.
header() { sed -n 's/\\_/_/g; s/^ *\\SECTION *\([^ ]*\) *\\parents *\(.*\)/\1 \2/p' "$1"; }
order=$(for file; do
  header "$file" | tr -d , | {
    read -r name parents
    for parent in $parents; do echo "$parent $name"; done
  }
done | tsort)
sorted=
for name in $order; do
  for file; do
    [ "$(header "$file" | cut -d' ' -f1)" != "$name" ] || sorted="$sorted $file"
  done
done

# CZT's exit status counts type errors only, not syntax errors; so its words are read: each error names its line, which
# CZT counts from 0, and each section that was checked to its end has a summary.
# shellcheck disable=SC2086  # the paths of a checkout have no spaces where CZT is to read them
output=$(java -cp "$CZT_JAR" net.sourceforge.czt.typecheck.z.TypeCheckUtils $sorted 2>&1) && failed=0 || failed=1
errors=$(printf '%s\n' "$output" |
  sed -n '/^WARNING/d; s/^\(ERROR \)\{0,1\}"\{0,1\}\([^"]*\)"\{0,1\}, line \([0-9]*\)[^:]*: /\2\t\3\t/p' |
  awk -F '\t' '{ print $1 ":" $2 + 1 ": " $3 }')
[ -z "$errors" ] || { printf '%s\n' "$errors"; failed=1; }
for file; do
  name=$(header "$file" | cut -d' ' -f1)
  case $output in
    *"Summary information for section $name"*) ;;
    *) echo "$file:1: CZT did not check section $name"; failed=1 ;;
  esac
done
[ "$failed" = 0 ] || [ -n "$errors" ] || printf '%s\n' "$output" >&2
exit "$failed"
