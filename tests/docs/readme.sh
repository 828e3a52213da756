#!/bin/sh
# readme.sh DURERO ROOT: runs every command of README. `./x COMMAND` stands for the built program, as ./x passes it on;
# `./x demo` is docs/demo, `./x test` is the run that this belongs to, and the lines of plain CMake are those that ./x
# itself runs. The lines of the wheel, in a block of a console, run whole in a fresh root (package/release); here its program
# is the built one, and its folder of systems that of the tree. A block of commands followed by a block of text is refused
# (status 1) and prints that text; the tracer of systems/examples is found wrong.
set -eu
durero=$1 root=$2
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
awk '/^```/ { if (inside) { inside = 0; print "" } else { inside = 1; print "#" substr($0, 4) } next } inside' \
  "$root/README.md" >"$tmp/blocks"
cp -R "$root/demo" "$tmp/demo"
mkdir "$tmp/systems" && cp -R "$root/systems/examples" "$tmp/systems/examples"
cd "$tmp"
ran=0 bad=0
fail() { echo "README.md: $1"; bad=$((bad + 1)); }

run() {  # run COMMAND WANTED_STATUS
  ran=$((ran + 1))
  status=0
  (eval "\"$durero\" ${1#./x }") >said 2>complaint || status=$?
  [ "$status" = "$2" ] || fail "$1: status $status instead of $2: $(cat complaint)"
}

kind='' last=''
while IFS= read -r line; do
  case $line in
    '#sh') kind='sh'; continue ;;
    '#console') kind=console; continue ;;
    '#') kind=text; : >wanted; continue ;;
    '') if [ "$kind" = text ]; then
          run "$last" 1
          cmp -s said wanted || fail "$last prints: $(cat said)"
        fi
        kind=''; continue ;;
  esac
  if [ "$kind" = text ]; then printf '%s\n' "$line" >>wanted; continue; fi
  if [ "$kind" = console ]; then
    case $line in
      'durero conform run '*) run "./x ${line#durero }" 1 ;;
      'cp venv/share/durero/systems/'*) eval "cp $root/${line#cp venv/share/durero/}" ;;
      'python3 -m venv venv' | '. venv/bin/activate' | 'pip install ./durero-*.whl') ;;
      *) fail "a line of the wheel that nothing runs: $line" ;;
    esac
    continue
  fi
  command=$(printf '%s' "$line" | sed 's/  *#.*//')
  case $command in
    './x demo') grep -q '^ *demo) ' "$root/x" || fail './x has no demo' ;;
    './x test') grep -q '^ *test) ' "$root/x" || fail './x has no test' ;;
    'cmake --preset release') grep -q 'cmake --preset "$preset"' "$root/x" || fail "$command is not run" ;;
    'cmake --build --preset release') grep -q 'cmake --build --preset "$preset"' "$root/x" || fail "$command is not run" ;;
    './x '*) last=$command
      case $command in
        *'e?=apple'*) ;;
        *systems/examples/sphere.py*) run "$command" 1 ;;  # some of its hits are wrong
        *) run "$command" 0 ;;
      esac ;;
    *) fail "a command that nothing runs: $command" ;;
  esac
done <blocks
echo "README.md: $ran commands run, $bad wrong"
[ "$bad" = 0 ] && [ "$ran" -ge 9 ]
