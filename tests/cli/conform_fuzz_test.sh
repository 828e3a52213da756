#!/bin/sh
# durero conform fuzz: a search finds where a system is wrong, the same again by its seed and steps.
. "$(dirname "$0")/harness.sh"
export XDG_CACHE_HOME="$PWD/cache"

# A system that misses all but rays that go along z: its answers need no other program.
cat >ask.py <<'PY'
import sys
print("system Blind 1.0", flush=True)
while head := sys.stdin.readline():
    line = sys.stdin.readline()
    while not line.startswith("rays "):
        line = sys.stdin.readline()
    for _ in range(int(line.split()[1])):
        sys.stdin.readline()
        print("miss", flush=True)
PY
printf '%s' '{"format":"durero-profile","version":1,"system":"blind","profile":{"format":"binary64","tipos":["esfera"],"caps":"open",
"measure":"parameter","directions":"any","inside":"exit_point","names_elements":true},"sources":[]}' >blind.json

run 1 conform fuzz 'command:python3 ask.py' --profile blind.json --steps 400
cp out one
has out '400 questions, '
has out "the same again: durero conform fuzz 'command:python3 ask.py' --profile blind.json --seed 1 --steps 400"
has out 'The cause is not known: esfera'
has out '    missed: expected '
has out '    in hexadecimal:'
has out 'have that answer: proved.'
again=$(sed -n 's/^the same again: //p' one)
called=$again
checks=$((checks + 1))
(durero() { "$durero" "$@"; }; eval "$again") >out 2>err && fail 'it is right'
same one out
run 1 conform fuzz 'command:python3 ask.py' --profile blind.json --steps 400 --seed 2 --family rim,tiny --numbers binary64 --faces 80
has out ' --seed 2 --steps 400 --family rim,tiny --faces 80 --numbers binary64'
checks=$((checks + 1))
if cmp -s one out; then fail 'another seed found the same'; fi

# A report is a page and JSON in a folder of the system's name.
run 1 conform fuzz 'command:python3 ask.py' --profile blind.json --steps 400 --report found
same one out
has found/python3-ask.py/search.json '"system":"blind","title":"python3 ask.py","system_version":"Blind 1.0"'
has found/python3-ask.py/search.json '"call":"durero conform fuzz '
has found/python3-ask.py/search.json '"steps":400,'
has found/python3-ask.py/search.html '<h1>python3 ask.py</h1>'
has found/python3-ask.py/search.html ' --seed 1 --steps 400</pre>'
has found/python3-ask.py/search.html '<h3>The cause is not known: esfera</h3>'
: >file
refused 'file/durero: cannot be made' conform fuzz durero --steps 10 --report file
run 0 conform fuzz durero --steps 100 --report right
has right/durero/search.html ': 0 wrong. durero 0.1.0 '
has right/durero/search.json '"causes":[]'

# A right system is found right, in a number of steps or in a time.
run 0 conform fuzz durero-exact --steps 2000
has out '2000 questions, '
has out ': 0 wrong'
run 0 conform fuzz durero --minutes 0.02 --family generic
has out ': 0 wrong'
run 0 conform fuzz durero --minutes 0.01 --steps 1000000000
checks=$((checks + 1))
if grep -q 'steps 1000000000$' out; then fail 'the time did not end it'; fi

# An interrupt ends the search and keeps what was found.
"$durero" conform fuzz 'command:exec python3 ask.py' --profile blind.json --minutes 5 --report stopped >out 2>err &
asked=$!
sleep 2
kill -INT $asked
wait $asked
got=$?
called='an interrupted search'
checks=$((checks + 1))
[ "$got" = 1 ] || fail "$called: status $got, expected 1"
has out 'stopped, so that nothing is made small: '
has stopped/exec-python3-ask.py/search.json '"stopped":true'
has out 'the same again: '
has out '    missed: expected '
refused 'no family has a scene of these types of elements' conform fuzz 'command:python3 ask.py' --profile blind.json --family apex --steps 10
refused 'bullet is absent: it is not set up' conform fuzz bullet --steps 10
refused 'conform fuzz: --steps 0: ' conform fuzz durero --steps 0
finish
