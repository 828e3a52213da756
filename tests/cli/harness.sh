# What every test of the program needs. Source it with the program's path as $1; end with `finish`, without which a test
# that comes to its end fails: what it found would be lost.
durero=$1
directory=$(mktemp -d) || exit 1
is_finished=
trap 'status=$?; rm -rf "$directory"; [ "$status" != 0 ] || [ -n "$is_finished" ] || { echo "FAILED: no finish"; exit 1; }' EXIT
cd "$directory" || exit 1
checks=0 failures=0

fail() {
  failures=$((failures + 1))
  printf 'FAILED: %s\n' "$*"
  [ ! -s err ] || sed 's/^/  stderr: /' err
}

# run STATUS ARGUMENT...: runs durero, expects its exit status; leaves its output in the files out and err.
run() {
  want=$1
  shift
  called="durero $*"
  "$durero" "$@" >out 2>err </dev/null
  got=$?
  checks=$((checks + 1))
  [ "$got" = "$want" ] || fail "$called: status $got, expected $want"
}

# is FILE TEXT: the file holds exactly that text and a line end.
is() {
  checks=$((checks + 1))
  [ "$(cat "$1"; echo .)" = "$2
." ] || { fail "$called: $1 is not as expected"; printf '%s\n' "$2" | diff - "$1" | sed 's/^/  /'; }
}

# has FILE TEXT: some line of the file contains the text.
has() {
  checks=$((checks + 1))
  grep -qF -e "$2" "$1" || fail "$called: $1 lacks: $2"
}

# lines FILE N
lines() {
  checks=$((checks + 1))
  [ "$(wc -l <"$1")" -eq "$2" ] || fail "$called: $1 has $(wc -l <"$1") lines, expected $2"
}

empty() {
  checks=$((checks + 1))
  [ ! -s "$1" ] || fail "$called: $1 is not empty"
}

absent() {
  checks=$((checks + 1))
  [ ! -e "$1" ] || fail "$called: $1 is there"
}

# same FILE FILE
same() {
  checks=$((checks + 1))
  cmp -s "$1" "$2" || fail "$called: $1 and $2 differ"
}

# refused TEXT ARGUMENT...: status 2, nothing on stdout, and one line on stderr, `durero: ` and a text that starts so.
refused() {
  start=$1
  shift
  run 2 "$@"
  empty out
  lines err 1
  checks=$((checks + 1))
  case $(cat err) in "durero: $start"*) ;; *) fail "$called: expected durero: $start" ;; esac
  has err '; expected '
}

finish() {
  [ "$checks" -gt 0 ] || fail "nothing was checked"
  echo "$checks checks, $failures failures"
  is_finished=yes
  [ "$failures" = 0 ]
  exit
}

# A scene with one element of each type.
sample() {
  cat <<'JSON'
{"format":"durero-scene","version":1,
"camera":{"eye":[0,1,-8],"look_at":[0,0,0],"up":[0,1,0],"fov_y":45},
"resolution":[8,6],
"lights":[
{"position":[5,5,-5],"color":[1,1,1]}],
"materials":{
"red":{"color":[1,0,0]}},
"elementos":[
{"id":"c1","tipo":"cilindro","centro":[3,0,0],"radio":1,"vector":[0,1,0],"altura":2},
{"id":"k1","tipo":"cono","centro":[-3,0,0],"proporcion":0.5,"vector":[0,1,0],"altura":2},
{"id":"s1","tipo":"esfera","centro":[0,0,0],"radio":1,"material":"red"}
]}
JSON
}
