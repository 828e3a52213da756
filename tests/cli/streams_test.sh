# Streams: rays through pipes, memory, signals, what is printed, and what a terminal sees; and that every command that
# writes a file finds out whether it can before it reads anything.
. "$(dirname "$0")/harness.sh"
sample >scene.json
checks=$((checks + 1))
python3 "$(dirname "$0")/streams.py" "$durero" || fail streams.py

# at_once OUT ARGUMENT...: the output is refused, though the input is not there either.
at_once() {
  out=/nowhere/$1
  shift
  refused "$out: cannot be written: No such file or directory" "$@" -o "$out"
}
at_once out.jsonl trace nowhere.json rays
at_once out.png render nowhere.json
at_once out.json edit nowhere.json --op 'Eliminar_Elemento e=a'
at_once out.v spec export --coq nowhere.tex
refused '/nowhere/s.json: cannot be written: ' import nowhere.obj -o /nowhere/s.json
refused '/nowhere/s.nff: cannot be written: ' export nowhere.json -o /nowhere/s.nff
refused '/nowhere/suite: cannot be written: ' conform make /nowhere/suite
touch file
refused 'file/found: cannot be made: ' conform judge nowhere hits --profile durero --report file/found
finish
