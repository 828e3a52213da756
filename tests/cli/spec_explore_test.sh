# durero spec explore: all states of a text's machine, what never happens, deadlocks, claims, and the graph.
. "$(dirname "$0")/harness.sh"
book=$(cd "$(dirname "$0")/../../demo" && pwd)/birthday_book.tex

# explores STATUS OPTION... : explores with these options.
explores() {
  status=$1
  shift
  called="durero spec explore $*"
  "$durero" spec explore "$@" >out 2>err
  got=$?
  checks=$((checks + 1))
  [ "$got" = "$status" ] || fail "$called: status $got, expected $status"
}

explores 1 "$book" --members 2
has out 'BirthdayBook: 9 states, 138 transitions, 2 steps deep'
has out '  4 of these states differ by more than an exchange of members of DATE, NAME'
has out '  AddBirthday    12 transitions, in 5 states'
has out 'no deadlock'
has out 'claims: 3 tried, 1 false, 0 not decided'
has out 'birthday ∈ NAME ⤔ DATE'
has out '2. AddBirthday  '

# A way that it finds is one that spec run reads back.
explores 1 "$book" --members 2 --plain --trace way.txt
printf 'replay way.txt\n' | "$durero" spec run "$book" --members 2 >out 2>err || fail 'replay way.txt'
has out '3 steps, each as the text says'

cat >probe.tex <<'EOF'
\begin{schema}{Probe} count : \nat \where count \leq 2 \end{schema}
\begin{schema}{InitProbe} Probe~' \where count' = 0 \end{schema}
\begin{schema}{Step} \Delta Probe \where count' = count + 1 \end{schema}
\begin{schema}{Never} \Delta Probe \where count > 5 \\ count' = count \end{schema}
EOF
explores 0 probe.tex
has out 'Probe: 3 states, 2 transitions, 2 steps deep'
has out '  Never  never happened'
has out '  never true   Never: count > 5  (line 4)'
has out 'deadlock: in 1 state no operation can happen; the first after this way:'
has out '2. Step'
explores 1 probe.tex --fail deadlock
explores 1 probe.tex --fail never
explores 0 probe.tex --fail bounded
explores 1 probe.tex --fail bounded --states 2
has out '  bounded: states: --states'
explores 1 probe.tex --always 'count < 2'
has out 'false  --always: always count < 2'
explores 0 probe.tex --eventually 'count = 2' --leads-to 'count = 0' 'count = 1'
has out 'claims: 2 tried, 0 false, 0 not decided'
explores 1 probe.tex --eventually 'count = 3'
has out 'false  --eventually: eventually count = 3'

# One line says what is wrong with a call.
refused() {
  text=$1
  shift
  explores 2 "$@"
  lines err 1
  has err "$text"
}
refused 'durero: --numbers:1:1: 3 bounds no numbers; expected LOW..HIGH, such as 0..3' probe.tex --numbers 3
refused 'durero: PREDICATE:1:1: ' probe.tex --always 'cuont < 2'
refused 'expected a predicate' probe.tex --always 'count + 2'
sed "s/count' = 0/count' = 9/" probe.tex >none.tex
refused 'none.tex:1:1: no initial state is found; expected an initial schema that admits a state' none.tex

# The memory bounds it.
cat >many.tex <<'EOF'
\begin{schema}{Many} s : \power \nat \end{schema}
\begin{schema}{InitMany} Many~' \where s' = \emptyset \end{schema}
\begin{schema}{Add} \Delta Many \\ n? : 1 \upto 24 \where s' = s \cup \{n?\} \end{schema}
EOF
explores 2 many.tex --states 100000000 --memory 64
has err 'durero: --memory:1:1: the memory did not do; expected fewer --states, or a greater --memory'

# The report as JSON, and the graph as JSON, as a drawing and for Graphviz.
explores 1 "$book" --members 2 --json --graph --dot states.dot --svg states.svg
python3 - out states.svg states.dot >err 2>&1 <<'EOF' || fail 'the JSON, the drawing or the graph'
import json, re, sys
import xml.etree.ElementTree as xml
report = json.load(open(sys.argv[1]))
assert report["format"] == "durero-explore" and report["version"] == 1
assert report["states"] == 9 and report["transitions"] == 138 and report["deadlocks"] == 0
assert report["classes"] == 9 and report["exchanged"] == [], "a graph has every state"
assert sum(each["transitions"] for each in report["operations"]) == 138
assert len(report["refuted"]) == 1 and len(report["refuted"][0]["way"]) == 3
graph = report["graph"]
assert len(graph["states"]) == 9 and len(graph["steps"]) == 138 and graph["initial"] == 1
assert all(0 <= step["from"] < 9 and 0 <= step["to"] < 9 for step in graph["steps"])
drawing = xml.parse(sys.argv[2]).getroot()
space = "{http://www.w3.org/2000/svg}"
assert len(drawing.findall(space + "rect")) == 9
arrows = {(step["from"], step["to"]) for step in graph["steps"]}
assert len(drawing.findall(space + "path")) == len(arrows)
dot = open(sys.argv[3]).read()
assert len(re.findall(r"^  s\d+ \[", dot, re.M)) == 9
assert len(re.findall(r"^  s\d+ -> s\d+ \[", dot, re.M)) == len(arrows)
EOF
if command -v dot >/dev/null; then
  dot -Tsvg states.dot >drawn.svg 2>err || fail 'dot reads states.dot'
fi

# An interrupt ends it with what it found.
cat >long.tex <<'EOF'
\begin{schema}{Long} n : \nat \end{schema}
\begin{schema}{InitLong} Long~' \where n' = 0 \end{schema}
\begin{schema}{Up} \Delta Long \where n' = n + 1 \end{schema}
EOF
for signal in INT TERM; do
  "$durero" spec explore long.tex --states 100000000 >out 2>err &
  running=$!
  sleep 1
  kill -"$signal" "$running" 2>/dev/null
  wait "$running"
  got=$?
  checks=$((checks + 1))
  called="durero spec explore, after SIG$signal"
  [ "$got" = 0 ] || fail "$called: status $got, expected 0"
  has out '  stopped: not all states were gone on from'
  has out 'no deadlock was found'
done

# So does the end of its time, within a state too; the answer names it as a bound.
explores 0 long.tex --states 100000000 --time 0.2
has out '  bounded: states: --time'
has out 'no deadlock was found'
cat >slow.tex <<'EOF'
\begin{schema}{Slow} n : \nat \end{schema}
\begin{schema}{InitSlow} Slow~' \where n' = 0 \end{schema}
\begin{schema}{Up} \Delta Slow \\ a?, b? : 1 \upto 30000 \where a? * a? = 2 * b? * b? \\ n' = n + 1 \end{schema}
EOF
explores 1 slow.tex --time 2 --fail bounded
has out 'Slow: 1 state, 0 transitions, 0 steps deep'
has out '  bounded: states: --time'

# The time runs from the beginning of the command: that of the program's own text is over while it is planned.
explores 1 --time 0.001 --fail bounded
has out 'Escena: 0 states, 0 transitions, 0 steps deep'
has out '  bounded: states: --time'
has out '  the time was over while operations were planned: no state was looked for'
has out '  Agregar_Esfera                    not looked for'
! grep -q never out || fail 'of what was not looked for nothing is said'
explores 0 --time 0.001 --json
has out '"planned":false,"stopped":false,"bounded":["states: --time"]'
explores 0 probe.tex --json
has out '"planned":true,"stopped":false,"bounded":[]'
refused 'durero: spec explore: --time 0: no number from 0.001 to 1000000000; expected one' long.tex --time 0
finish
