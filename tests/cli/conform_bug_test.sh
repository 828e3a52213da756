#!/bin/sh
# durero conform run --report and bug: failures made small, explained, and reproduced by a program that stands alone.
. "$(dirname "$0")/harness.sh"
export XDG_CACHE_HOME="$PWD/cache"

# A system that is right, but for rays whose v is long: those miss.
mkdir -p systems/tracer
cat >systems/tracer/ask.py <<'PY'
import subprocess, sys
right = subprocess.Popen(sys.argv[1:], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
right.stdout.readline()
print("system Tracer 1.0", flush=True)
while head := sys.stdin.readline():
    lines = [head]
    while not lines[-1].startswith("rays "):
        lines.append(sys.stdin.readline())
    rays = [sys.stdin.readline() for _ in range(int(lines[-1].split()[1]))]
    right.stdin.write("".join(lines + rays))
    right.stdin.flush()
    for ray in rays:
        answer = right.stdout.readline()
        print("miss\n" if max(abs(float(x)) for x in ray.split()[3:]) >= 2 else answer, end="", flush=True)
PY
cat >systems/tracer/reproduce.py.in <<'PY'
# @(about)
# python3 @(file)
@esfera print("a sphere of radius @(radio)")
print("got: miss" if max(map(abs, (@(v)))) >= 2 else "got: hit")
print("expected: @(expected)")
PY
cat >systems/tracer/tracer.json <<'JSON'
{"format":"durero-system","version":1,"system":"tracer","title":"Tracer (trace)",
 "ask":["python3","{here}/ask.py","{durero}","conform","answer","--engine","exact"],
 "profile":{"format":"binary64","tipos":["esfera"],"caps":"open","measure":"parameter","directions":"any",
  "inside":"exit_point","names_elements":true},
 "reproduce":{"program":"reproduce.py.in","run":[["python3","{program}"]]},
 "known":[{"verdicts":["missed"],"types":["esfera"],"cause":"A long v is taken for none."}]}
JSON

# A report shows failures small; the same answers give the same bytes.
run 1 conform run tracer --systems systems --family generic --rays 64 --report one
ray=$(sed -n 's/.*durero conform minimise tracer --case \(generic\/[0-9]*\) --ray \([0-9]*\).*/\1 --ray \2/p' out | head -n 1)
has out '    in hexadecimal:'
has out 'ε·M'
has one/tracer/report.json '"least":{"question":"scene generic/'
has one/tracer/report.json '"hexadecimal":'
has one/tracer/report.html 'As small as it fails:'
has one/tracer/report.sarif '"least":"missed: expected'
# Its failures have one cause, with how likely it is and what writes it up.
has out '1 cause, by what makes '
has out '  The direction is not of length 1'
has out '    right: with v/|v| for v'
has out '    ordinary rays: '
has out '    severity: the worst is the answer of no data off by 2^'
has out '    durero conform bug tracer generic/'
has one/tracer/report.html '<h3>The direction is not of length 1</h3>'
has one/tracer/report.json '"causes":{"asked":true,'
run 1 conform run tracer --systems systems --family generic --rays 64 --report two --jobs 3
same one/tracer/report.json two/tracer/report.json
same one/tracer/report.html two/tracer/report.html
run 1 conform run tracer --systems systems --family generic --rays 64 --report three --no-minimise
checks=$((checks + 1))
if grep -q '"least"' three/tracer/report.json; then fail 'it was minimised'; fi
has three/tracer/report.json '"causes":{"asked":false,'
has out 'have in common: no system was asked again'
refused 'conform run: --no-minimise: it says nothing alone; expected --report with it' conform run tracer --systems systems --no-minimise

# Minimised, a command of its own says the same.
run 1 conform minimise tracer --systems systems --case $ray
has out 'missed: expected e'
has out 'in hexadecimal:'

run 1 conform minimise tracer --systems systems --case $ray --write least.txt
has least.txt 'rays 1'
"$durero" conform answer <least.txt >out || fail 'the smallest question is none'
has out 'hit e'

# The report that one would file, with the program in it, or beside it.
run 1 conform bug tracer --systems systems $ray
has out '# Tracer 1.0: missed'
has out '; got a miss. A long v is taken for none.'
has out 'With v/|v| for v it is right.'
has out 'Tracer (trace), asked by durero 0.1.0: `durero conform bug tracer generic/'
has out '```question'
has out '```got'
has out '    = '
has out 'have that answer: proved.'
has out 'It was run, and wrote:'
has out 'got: miss'
has out 'print("a sphere of radius '
run 1 conform bug tracer --systems systems $ray --output bug.md --reproducer it.py
has bug.md '[it.py](it.py) stands alone'
has it.py '# Tracer 1.0: missed'
checks=$((checks + 1))
python3 it.py | grep -q '^got: miss$' || fail 'the reproducer does not run'
# Without a ray it is a failure of the case; a case without one is right; a program that shows nothing is said.
run 1 conform bug tracer --systems systems "${ray%% *}"
has out '# Tracer 1.0: missed'
run 0 conform bug durero tiny/0000
has out 'durero is right about tiny/0000'
sed -i 's/got: miss/got: hit - 1/' systems/tracer/reproduce.py.in
run 1 conform bug tracer --systems systems $ray
has out 'It was run and does not show the failure'
printf '@(nothing)\n' >systems/tracer/reproduce.py.in
run 2 conform bug tracer --systems systems $ray
has err 'reproduce.py.in:1: nothing is called "nothing"; expected one of about, '
# A program that has no file of a system is asked by the words that a report names it by, and so is a file.
program="python3 systems/tracer/ask.py $durero conform answer --engine exact"
case_of="${ray%% *}"
run 1 conform run "command:$program" --profile systems/tracer/tracer.json --family generic --rays 64 --report four
minimise=$(sed -n 's/^  \(durero conform minimise .*\)/\1/p' out | head -n 1)
has four/python3-ask.py-durero-conform-answer-engine-exact/report.json "\"minimise\":\"durero conform minimise 'command:python3 "
has four/python3-ask.py-durero-conform-answer-engine-exact/report.html "durero conform minimise 'command:python3 "
called=$minimise
checks=$((checks + 1))
(durero() { "$durero" "$@"; }; eval "$minimise") >out 2>err && fail 'it is right'
has out 'missed: expected e'
run 1 conform bug "command:$program" --profile systems/tracer/tracer.json $ray
has out "\`durero conform bug 'command:$program' --profile systems/tracer/tracer.json $case_of --ray "
run 1 conform minimise systems/tracer/tracer.json --case $ray
has out 'missed: expected e'
refused 'command: without --profile' conform bug command:cat generic/0000
refused 'command: without --profile' conform minimise command:cat --case generic/0000 --ray 0
refused 'bullet is absent: it is not set up' conform bug bullet generic/0000
refused 'durero has no template of a reproducer' conform bug durero tiny/0000 --reproducer x
refused 'no case "generic/x"; expected FAMILY/NUMBER, such as generic/0000' conform bug durero generic/x
finish
