#!/bin/sh
# The module of the page answers what the native program answers, byte by byte: 100,000 rays and more, every family of
# them, texts, expressions and errors.
#   sh same_answers_test.sh DUREROROOT PROGRAM WEB_CALL ENGINE.js
root=$1 durero=$2 web_call=$3 engine=$4
skip() { echo "skipped: $*"; exit 77; }
command -v node >/dev/null 2>&1 || skip "there is no node"
[ -f "$engine" ] || skip "there is no $engine; ./x page builds it"
folder=$(mktemp -d) && trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
"$durero" conform make suite --rays 1824 --numbers binary64 --quiet || exit 1
node "$root/tests/wasm/calls.js" "$root" suite >calls || exit 1
rays=$(cat suite/*/*.rays.txt | grep -c '^[-0-9]')
[ "$rays" -ge 100000 ] || { echo "FAILED: $rays rays, fewer than 100000"; exit 1; }
"$web_call" <calls >native || { echo "FAILED: $web_call ends with status $?"; exit 1; }
node "$root/tests/wasm/ask.js" "$engine" <calls >module || { echo "FAILED: the module ends with status $?"; exit 1; }
cmp native module || {
  echo "FAILED: the answers differ"
  diff native module | cut -c 1-400 | head -n 40
  exit 1
}
answers=$(wc -l <native)
[ "$answers" -eq "$(wc -l <calls)" ] || { echo "FAILED: $answers answers to $(wc -l <calls) calls"; exit 1; }
echo "$answers answers, of $rays rays and more: the same"
