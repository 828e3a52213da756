#!/bin/sh
# The mutants' script must be able to fail: on a fault that no test sees, on one that no longer applies, on one that does
# not compile, and on a test that is none. Each list here holds one such mutant.
set -u
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT
missed=0 drills=0

# says BUILD BLOCK WORDS [CALL]: on the list made of that block the script fails, with these words; it is called by --all,
# or as CALL says.
says() {
  drills=$((drills + 1))
  printf '%s\n' "$2" >"$work/list"
  # shellcheck disable=SC2086  # a call has several words
  if MUTANTS=$work/list MUTANTS_WORK=$work/copy sh "$here/mutants.sh" "$1" ${4:---all} >"$work/said" 2>&1; then
    echo "drill: the script passes where it should say: $3"
  elif ! grep -q "$3" "$work/said"; then
    echo "drill: the script does not say: $3"
    cat "$work/said"
  else
    return
  fi
  missed=$((missed + 1))
}

says "$1" 'mutant harmless
file src/number/integers.cpp
test number_tests [#dyadic_test]
-   Integer result;
+   Integer result = 0;' 'harmless SURVIVED'
says "$1" 'mutant harmless
file src/number/integers.cpp
test number_tests [#dyadic_test]
-   Integer result;
+   Integer result = 0;' 'harmless SURVIVED' '--for 1'
says "$1" '' 'takes a number of minutes' '--for 0'
says "$1" 'mutant outdated
file src/number/integers.cpp
test number_tests [#dyadic_test]
- no such text stands there
+ nor this' 'outdated no longer applies'
says "$1" 'mutant ambiguous
file src/number/integers.cpp
test number_tests [#dyadic_test]
- result
+ another' 'ambiguous no longer applies'
says "$1" 'mutant broken
file src/number/integers.cpp
test number_tests [#dyadic_test]
-   Integer result;
+   Integer result' 'broken does not compile'
says "$1" 'mutant unseen
file src/number/integers.cpp
test number_tests [#no_such_test]
-   Integer result;
+   Integer result = 1;' 'fails, or matches no test'
says "$1" 'mutant long
file src/number/integers.cpp
test distance_tests [#distances_test][long]
-   Integer result;
+   Integer result = 1;' 'fails, or matches no test'
echo "drill: $((drills - missed)) of $drills failures seen"
[ "$missed" = 0 ]
