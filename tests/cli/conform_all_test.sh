#!/bin/sh
# durero conform run --question all and count: every hit of a ray in order, and how many these are.
. "$(dirname "$0")/harness.sh"
export XDG_CACHE_HOME="$PWD/cache"

for question in all count; do
  run 0 conform run durero --question "$question" --rays 64
  run 0 conform fuzz durero --steps 300 --question "$question"
  refused "bullet does not claim the question $question; expected one of " conform run 'command:cat questions' --profile bullet --question "$question"
done

# Durero answers them as a system does. A stretch in a surface has two ends, but from the start no first one.
scene='scene a\nesfera e 0 0 5 1\nplano f 0 0 9 0 0 1\ndisco g 0 20 5 0 1 0 1\nesfera h 0 20 5.5 0.25\n'
rays='4\n0 0 0 0 0 2\n0 0 9 1 0 0\n0 3 0 0 0 -1\n0 20 0 0 0 1\n'
printf "${scene}crossings $rays${scene}counts $rays" >questions
"$durero" conform answer <questions >out 2>err || fail 'conform answer'
called='conform answer'
is out 'system durero 0.1.0 fast
hit e 2 0 0 4 ; hit e 3 0 0 6 ; hit f 4.5 0 0 9
refused no point of the elements is the nearest
miss
hit g 4 0 20 4 ; hit h 5.25 0 20 5.25 ; hit h 5.75 0 20 5.75 ; hit g 6 0 20 6 ; hit f 9 0 20 9
count 3
refused no point of the elements is the nearest
count 0
count 5'

# Nearest points: Durero, and a question of points alone.
run 0 conform run durero durero-exact --question closest --rays 32
run 0 conform fuzz durero --steps 200 --question closest
run 0 conform show --case generic/0000 --ray 3 --question closest
grep -A1 '^points 1' out | tail -n 1 | awk 'NF != 3 {exit 1}' || fail 'a point has three numbers'
printf 'scene a\nesfera e 0 0 5 1\npoints 2\n0 0 0\n0 0 5\n' | "$durero" conform answer --besides >out 2>err || fail 'conform answer'
is out 'system durero 0.1.0 fast
hit e 4 0 0 4
hit e 1 -1 0 5'

# Balls: Durero, and a question with a radius behind each ray.
run 0 conform run durero durero-exact --question cast --rays 32
run 0 conform fuzz durero --steps 200 --question cast
run 0 conform show --case generic/0000 --ray 3 --question cast
grep -A1 '^casts 1' out | tail -n 1 | awk 'NF != 7 {exit 1}' || fail 'a cast has seven numbers'
printf 'scene a\nesfera e 0 0 5 1\ncasts 3\n0 0 0 0 0 2 1\n0 0 0 0 0 1 7\n9 0 0 0 0 1 1\n' | "$durero" conform answer --besides >out 2>err || fail 'conform answer'
is out 'system durero 0.1.0 fast
hit e 1.5 0 0 4
hit e 0 0 0 4
miss'

# A torus: this program's own answers, of every question about crossings.
printf 'scene a\ntoro o 0 0 5 2 0 0 0 1 0 0 0 2 0.5\n' >torus
{ cat torus && printf 'rays 3\n0 0 0 0 0 1\n0 0.5 0 0 0 1\n0 0.6 0 0 0 1\n' && cat torus && printf 'crossings 1\n0 0 0 0 0 2\n' &&
  cat torus && printf 'counts 2\n0 0 0 0 0 1\n0 0 3 0 0 1\n' && cat torus && printf 'ranges 1\n0 0 0 0 0 1 3 5\n' &&
  cat torus && printf 'shadows 2\n0 0 0 0 0 1 2\n0 0 0 0 0 1 2.5\n'; } | "$durero" conform answer >out 2>err || fail 'conform answer of a torus'
is out 'system durero 0.1.0 fast
hit o 2.5 0 0 2.5
hit o 3 0 0.5 3
miss
hit o 1.25 0 0 2.5 ; hit o 1.75 0 0 3.5 ; hit o 3.25 0 0 6.5 ; hit o 3.75 0 0 7.5
count 4
count 3
hit o 3.5 0 0 3.5
miss
hit - -'

# A system that leaves out the last hit is caught, and the calls of its report show it again.
cat >short.py <<'PY'
import subprocess, sys
right = subprocess.Popen(sys.argv[1:], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
right.stdout.readline()
print("system Short 1.0", flush=True)
while head := sys.stdin.readline():
    lines = [head]
    while not lines[-1].startswith(("rays ", "crossings ", "counts ")):
        lines.append(sys.stdin.readline())
    count = int(lines[-1].split()[1])
    lines += [sys.stdin.readline() for _ in range(count)]
    right.stdin.write("".join(lines))
    right.stdin.flush()
    for _ in range(count):
        hits = right.stdout.readline().rstrip("\n").split(" ; ")
        if hits[0].startswith("count ") and int(hits[0][6:]) > 1:
            hits[0] = "count %d" % (int(hits[0][6:]) - 1)
        print(" ; ".join(hits[: max(1, len(hits) - 1)]), flush=True)
PY
printf '%s' '{"format":"durero-profile","version":1,"system":"short","profile":{"format":"binary64","tipos":["esfera"],"caps":"open",
"measure":"parameter","directions":"any","inside":"exit_point","names_elements":true,"questions":["first","all","count"]},"sources":[]}' >short.json
asked="command:python3 short.py $durero conform answer"
run 0 conform run "$asked" --profile short.json --family generic --rays 64
for question in all count; do
  run 1 conform run "$asked" --profile short.json --family generic --rays 64 --question "$question" --report "found-$question"
  case $question in
    all) has out 'missed: expected e'; has out '; e' ;;
    count) has out 'wrong_count: expected 2 hits: e'; has out '; got 1 hit' ;;
  esac
  has "found-$question/python3-short.py-durero-conform-answer/report.json" "\"question\":\"$question\""
  has "found-$question/python3-short.py-durero-conform-answer/report.json" '"excluded":'
  show=$(sed -n 's/^  \(durero conform show .*\)/\1/p' out | head -n 1)
  bug=$(sed -n 's/^ *\(durero conform bug .*\)/\1/p' out | head -n 1)
  called=$bug
  checks=$((checks + 2))
  (durero() { "$durero" "$@"; }; eval "$bug") >report.md 2>err && fail 'it is right'
  has report.md " --question $question"
  called=$show
  (durero() { "$durero" "$@"; }; eval "$show") >out 2>err || fail 'it is not shown'
done
has out 'counts 1'
finish
