#!/bin/sh
# A system that is written in Python flushes each line of its answer (`system NAME`, `hit …`, `miss`, `refused …`), in the
# call that prints the line or in the line after it. Else the line waits in a buffer, and only an environment that sets
# PYTHONUNBUFFERED hides the fault; no environment hides it of a system in another language. A system that is to be wrong so
# says `unflushed` in the line before.
git ls-files -z -- '*.py' '*.sh' '*.md' '*.py.in' | xargs -0 awk '
  function end_of_call() { if (waits) print waiting; waits = 0 }
  FNR == 1 { end_of_call(); before = "" }
  waits { if (/flush/) waits = 0; else end_of_call() }
  /(print|stdout[.]write)\(["\047](system |hit |miss|refused )/ && !/flush/ && before !~ /unflushed/ && FILENAME !~ /lint\/(flush|drill)[.]sh$/ {
    waits = 1
    waiting = FILENAME ":" FNR ": a line of an answer may wait in a buffer; expected flush=True, or a flush in the next line"
  }
  { before = $0 }
  END { end_of_call() }' | { ! grep .; }
