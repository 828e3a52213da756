#!/bin/sh
# durero conform run and answer: systems are asked in processes, an absent one is never passed, a stopped run goes on.
. "$(dirname "$0")/harness.sh"
export XDG_CACHE_HOME="$PWD/cache"

# This program is a system, and right.
run 0 conform run durero --family generic --rays 100
has out 'durero 0.1.0 analytic'
run 0 conform run durero-exact --family generic --rays 100
has out 'durero 0.1.0 exact'

# One that is not there is absent, beside others that are.
run 2 conform run bullet durero --family generic --rays 64
has out 'bullet: absent: it is not set up; expected durero conform setup bullet'
has out 'durero 0.1.0 analytic'
refused 'no system "nothing"; expected one of ' conform run nothing
refused 'command: without --profile' conform run command:cat
refused '--profile without command:PROGRAM; expected no profile' conform run durero embree --profile durero
refused '--profile without command:PROGRAM; expected no profile' \
  conform minimise durero --case tiny/0000 --ray 0 --profile durero
refused 'conform run: --continue: it says nothing alone; expected --report with it' conform run durero --continue

# A program of one's own is asked as it is.
printf 'system liar 1\n' >liar
run 1 conform run 'command:cat liar' --profile durero --family generic --rays 64
has out crashed
! grep -q 'no scene of these types' out || fail 'a family is named that was asked'
printf '%s' '{"format":"durero-profile","version":1,"system":"balls","profile":{"format":"binary64","tipos":["esfera"],"caps":"open",
"measure":"parameter","directions":"any","inside":"exit_point","names_elements":true},"sources":[]}' >balls.json
run 1 conform run 'command:cat liar' --profile balls.json --family generic,apex,rim --rays 16
has out '2 families have no scene of these types of elements: apex, rim'
run 2 conform run 'command:cat liar' --profile durero --family generic --rays 1280
has err 'no answer to any ray of 20 scenes in a row'
printf '#!/bin/sh\necho system liar 2\nwhile read -r w n; do [ "$w" = rays ] || continue; i=0; while [ $i -lt $n ]; do read -r x; echo miss; i=$((i+1)); done; done\n' >liar.sh
run 1 conform run 'command:sh liar.sh' --profile durero --family generic --rays 64
has out 'liar 2'

# What is found of each stands in a folder of its own.
run 1 conform run 'command:sh ./liar.sh' 'command:cat liar' --profile durero --family generic --rays 64 --no-minimise \
  --report found
has found/sh-liar.sh/report.json '"title":"sh ./liar.sh"'
has found/cat-liar/report.json '"title":"cat liar"'
refused 'two systems are named sh-liar.sh; expected one of each name in a call with --report' \
  conform run 'command:sh liar.sh' 'command:sh ./liar.sh' --profile durero --report other
absent other

# Questions are answered; a malformed one is refused at its place.
printf 'scene a\nesfera e 0 0 5 1\nrays 2\n0 0 0 0 0 2\n0 0 0 0 0 -2\n' >questions
"$durero" conform answer <questions >out 2>err || fail 'conform answer'
called='conform answer'
is out 'system durero 0.1.0 fast
hit e 2 0 0 4
miss'
printf 'scene a\nesfera e 0 0 5\nrays 1\n' >questions
if "$durero" conform answer <questions >out 2>err; then fail 'a malformed question was answered'; fi
has err 'durero: question:2:15: the line ends; expected a number'

# The claims are the same whatever --jobs, and those of a run that was stopped and went on.
run 0 conform run durero --family generic --rays 2000 --report one
run 0 conform run durero --family generic --rays 2000 --jobs 3 --report three
same one/durero.claims.jsonl three/durero.claims.jsonl
mkdir two
head -n 4 one/durero.claims.jsonl >two/durero.claims.jsonl
run 0 conform run durero --family generic --rays 2000 --report two --continue
same one/durero.claims.jsonl two/durero.claims.jsonl
run 2 conform run durero --family generic --rays 2000 --report two
has err 'two/durero.claims.jsonl'
run 2 conform run durero --family generic --rays 1000 --report two --continue
has err 'two/durero.claims.jsonl:1:'

# SIGINT ends the children and keeps what was done.
printf '#!/bin/sh\necho system slow 1\nwhile read -r w n; do [ "$w" = rays ] || continue; sleep 0.2; i=0; while [ $i -lt $n ]; do read -r x; echo miss; i=$((i+1)); done; done\n' >slow.sh
"$durero" conform run 'command:exec sh ./slow.sh' --profile durero --family generic --rays 6400 --report four >out 2>err &
asked=$!
sleep 1.5
kill -INT $asked
wait $asked
got=$?
called='an interrupted run'
checks=$((checks + 1))
[ "$got" = 2 ] || fail "$called: status $got, expected 2"
has out 'exec-sh-slow.sh: stopped after'
checks=$((checks + 1))
[ "$(wc -l <four/exec-sh-slow.sh.claims.jsonl)" -ge 2 ] || fail "$called: it kept nothing"
finish
