#!/bin/sh
# durero conform run --question shadow: whether anything is hit up to an end, asked of systems that claim to answer it.
. "$(dirname "$0")/harness.sh"
export XDG_CACHE_HOME="$PWD/cache"

run 0 conform run durero --question shadow --rays 64
has out 'durero 0.1.0 analytic'
run 0 conform run durero-exact --question shadow --family rim,tiny --rays 512
refused 'bullet does not claim the question shadow; expected one of ' conform run 'command:cat questions' --profile bullet --question shadow
refused 'conform run: --question second: ' conform run durero --question second

# A system that hits whatever the end is caught; one that refuses is skipped.
cat >endless.py <<'PY'
import subprocess, sys
right = subprocess.Popen(sys.argv[1:], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
right.stdout.readline()
print("system Endless 1.0", flush=True)
while head := sys.stdin.readline():
    lines = [head]
    while not lines[-1].startswith(("rays ", "shadows ")):
        lines.append(sys.stdin.readline())
    for _ in range(int(lines[-1].split()[1])):
        ray = sys.stdin.readline().split()
        lines.append(" ".join(ray[:6] + ["1e300"] * (len(ray) - 6)) + "\n")
    right.stdin.write("".join(lines))
    right.stdin.flush()
    for _ in lines[[line.split()[0] in ("rays", "shadows") for line in lines].index(True) + 1 :]:
        print(right.stdout.readline(), end="", flush=True)
PY
printf '%s' '{"format":"durero-profile","version":1,"system":"endless","profile":{"format":"binary64","tipos":["esfera"],"caps":"open",
"measure":"parameter","directions":"any","inside":"exit_point","names_elements":true,"questions":["first","shadow"]},"sources":[]}' >endless.json
asked="command:python3 endless.py $durero conform answer"
run 0 conform run "$asked" --profile endless.json --family generic --rays 64
run 1 conform run "$asked" --profile endless.json --family generic --rays 128 --question shadow --report found
has out 'phantom: expected no hit up to t = '
has out '; got a hit'
has out 'shadows 1'
has found/python3-endless.py-durero-conform-answer/report.json '"question":"shadow"'
bug=$(sed -n 's/^ *\(durero conform bug .*\)/\1/p' out | head -n 1)
minimise=$(sed -n 's/^  \(durero conform minimise .*\)/\1/p' out | head -n 1)
show=$(sed -n 's/^  \(durero conform show .*\)/\1/p' out | head -n 1)
called=$bug
checks=$((checks + 1))
(durero() { "$durero" "$@"; }; eval "$bug") >report.md 2>err && fail 'it is right'
has report.md 'shadows 1'
has report.md ' --question shadow'
refused 'a reproducer of the question shadow; expected a call without --reproducer' conform bug durero rim/0000 --question shadow --reproducer r.cpp
called=$minimise
checks=$((checks + 2))
(durero() { "$durero" "$@"; }; eval "$minimise") >out 2>err && fail 'it is right'
has out 'phantom: expected no hit up to t = '
(durero() { "$durero" "$@"; }; eval "$show") >out 2>err || fail 'it is not shown'
has out 'shadows 1'

# A search asks them too.
run 1 conform fuzz "$asked" --profile endless.json --steps 300 --question shadow
has out ' --seed 1 --steps 300 --question shadow'
has out 'shadows 1'
run 0 conform fuzz durero --steps 500 --question shadow

# Ranges too are asked of who claims them; one that forgets where they begin is caught, and the calls show it again.
run 0 conform run durero durero-exact --question range --rays 64
refused 'mitsuba does not claim the question range; expected one of ' conform run 'command:cat questions' --profile mitsuba --question range
sed 's/"shadows "/"ranges "/;s/"shadows"/"ranges"/;s/ray\[:6\] + .*$/ray[:6] + ["0"] * (len(ray) > 6) + ray[7:]) + "\\n")/' endless.py >beginless.py
sed 's/"shadow"/"range"/' endless.json >beginless.json
asked="command:python3 beginless.py $durero conform answer"
run 0 conform run "$asked" --profile beginless.json --family generic --rays 64
run 1 conform run "$asked" --profile beginless.json --family generic --rays 128 --question range --report found
has out 'out_of_range: expected '
has out ' within t = '
has out 'ranges 1'
has found/python3-beginless.py-durero-conform-answer/report.json '"question":"range"'
show=$(sed -n 's/^  \(durero conform show .*\)/\1/p' out | head -n 1)
checks=$((checks + 1))
(durero() { "$durero" "$@"; }; eval "$show") >out 2>err || fail 'it is not shown'
has out 'ranges 1'
run 1 conform fuzz "$asked" --profile beginless.json --steps 300 --question range
run 0 conform fuzz durero --steps 500 --question range

# Durero answers them as a system does.
printf 'scene a\nesfera e 0 0 5 1\nshadows 3\n0 0 0 0 0 2 2\n0 0 0 0 0 2 1.99\n0 0 0 0 0 -2 9\n' >questions
"$durero" conform answer <questions >out 2>err || fail 'conform answer'
called='conform answer'
is out 'system durero 0.1.0 fast
hit - -
miss
miss'
finish
