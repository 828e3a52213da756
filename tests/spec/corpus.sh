#!/bin/sh
# Has CZT judge tests/zed/corpus: it should accept each file of right/ and refuse each of wrong/, as the zed layer does
# (tests/zed/corpus_test.cpp). Exit status: 0 it does; 1 it does not, one file a line; 77 CZT is absent (see czt.sh).
set -u
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
said=$("$here/czt.sh" 2>&1)
[ $? -ne 77 ] || { echo "$said"; exit 77; }
failed=0
for file in "$here"/../zed/corpus/right/*.tex; do
  said=$("$here/czt.sh" "$file" 2>&1) || { echo "$file: CZT refuses it: $said"; failed=1; }
done
for file in "$here"/../zed/corpus/wrong/*.tex; do
  "$here/czt.sh" "$file" >/dev/null 2>&1 && { echo "$file: CZT accepts it"; failed=1; }
done
exit "$failed"
