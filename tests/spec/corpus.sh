#!/bin/sh
# Has CZT judge tests/zed/corpus: it should accept each file of right/ and refuse each of wrong/, as the zed layer does
# (tests/zed/corpus_test.cpp). One JVM reads them all, by CztCorpus.java, which java compiles as it starts.
# Exit status: 0 it does; 1 it does not, one file a line; 77 CZT, or a java that compiles, is absent (see czt.sh).
set -u
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
corpus=$here/../zed/corpus
if [ -z "${CZT_JAR:-}" ]; then
  echo 'skipped: CZT absent (set CZT_JAR to the path of czt.jar)'
  exit 77
fi
if ! command -v javac >/dev/null; then
  echo "skipped: no javac to compile CztCorpus.java with"
  exit 77
fi
said=$(java -cp "$CZT_JAR" "$here/CztCorpus.java" "$corpus"/right/*.tex "$corpus"/wrong/*.tex 2>/dev/null)
judged() { printf '%s\n' "$said" | grep -c "^$corpus/$1/.* \(accepted\|refused\)"; }
# Where ISO Z is not as CZT has it: a parent may stand twice in the standard's grammar and in no rule against it, and a
# subscript of no letter, which the grammar gives, is more likely a slip than meant, and is refused.
known() { grep -v "/right/parent_twice.tex refused\|/wrong/subscript_empty.tex accepted"; }
failed=0
for side in right wrong; do
  files=$(find "$corpus/$side" -name '*.tex' | wc -l)
  [ "$(judged "$side")" = "$files" ] || { echo "$corpus/$side: CZT judged $(judged "$side") of $files files"; failed=1; }
done
printf '%s\n' "$said" | grep "^$corpus/right/.* refused" | known && failed=1
printf '%s\n' "$said" | grep "^$corpus/wrong/.* accepted" | known && failed=1
exit "$failed"
