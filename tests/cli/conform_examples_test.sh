#!/bin/sh
# The examples in systems/examples answer the rays of a suite, in each language whose compiler is here.
examples=$(cd "$(dirname "$0")/../../systems/examples" && pwd)
. "$(dirname "$0")/harness.sh"
asked=0

# ask LANGUAGE PROGRAM: what it answers is right.
ask() {
  run 0 conform run "command:$2" --profile "$examples/sphere.json" --family generic --rays 128
  has out "example-$1 1"
  asked=$((asked + 1))
}

# compiled LANGUAGE PROGRAM COMMAND...: where the compiler is here.
compiled() {
  language=$1 program=$2
  shift 2
  command -v "$1" >/dev/null 2>&1 || { echo "absent: $1, so no example in $language"; return; }
  "$@" >err 2>&1 || fail "the example in $language does not compile"
  ask "$language" "$program"
}

compiled c ./c-example cc -Wall -o c-example "$examples/sphere.c" -lm
compiled c++ ./cpp-example c++ -std=c++17 -Wall -o cpp-example "$examples/sphere.cpp"
compiled rust ./rust-example rustc -O -o rust-example "$examples/sphere.rs"
if command -v python3 >/dev/null 2>&1; then ask python "python3 $examples/sphere.py"
else echo "absent: python3, so no example in Python"; fi
if command -v node >/dev/null 2>&1; then ask javascript "node $examples/sphere.mjs"
else echo "absent: node, so no example in JavaScript"; fi
[ "$asked" -gt 0 ] || fail "no example was asked"

# An example that is wrong is seen to be.
sed 's/-B - math.sqrt(D)/-B + math.sqrt(D)/' "$examples/sphere.py" >wrong.py
run 1 conform run "command:python3 $PWD/wrong.py" --profile "$examples/sphere.json" --family generic --rays 128
finish
