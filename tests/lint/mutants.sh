#!/bin/sh
# Each mutant of tests/mutants/mutants.txt still applies: its file is there, and holds the text that it changes once.
list=tests/mutants/mutants.txt
awk '
  function check(   line, rest, at, places) {
    if (name == "") return
    if ((getline line < file) < 0) { print list ":" where ": mutant " name ": no file " file; return }
    do { rest = line
         while ((at = index(rest, old)) > 0) { ++places; rest = substr(rest, at + length(old)) } } while ((getline line < file) > 0)
    close(file)
    if (places != 1) print list ":" where ": mutant " name ": its text stands " places + 0 " times in " file "; expected once" }
  FILENAME != "" { list = FILENAME }
  /^mutant / { check(); name = substr($0, 8); file = old = ""; where = FNR }
  /^file / { file = substr($0, 6) }
  /^- / { old = substr($0, 3) }
  END { check() }' "$list" | { ! grep .; }
