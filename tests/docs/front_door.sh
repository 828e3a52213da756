#!/bin/sh
# front_door.sh DURERO ROOT: ./x answers at once what needs no program, works through a link, stops what it started, and
# says in one line what is missing. Here it stands in a tree of its own, among programs that only write their arguments.
set -eu
durero=$1 root=$2
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
mkdir "$tmp/tree" "$tmp/bin"
cp "$root/x" "$tmp/tree/x"
cd "$tmp"
bad=0 checks=0
fail() { echo "./x $called: $1"; sed 's/^/  /' said complaint; bad=$((bad + 1)); }
x() {  # x WANTED_STATUS ARGUMENT...
  wanted=$1
  shift
  called=$*
  status=0
  "${door:-./tree/x}" "$@" >said 2>complaint || status=$?
  checks=$((checks + 1))
  [ "$status" = "$wanted" ] || fail "status $status instead of $wanted"
}
says() { grep -qF -e "$2" "$1" || fail "it does not say: $2"; }
one_line() { [ "$(wc -l <complaint)" = 1 ] || fail "not one line"; }

# Help, at once: nothing is built. Its commands are those of the program.
for word in help --help -h ''; do
  # shellcheck disable=SC2086  # without a word there is no argument
  x 0 $word
  for command in demo test bench lint build; do says said "./x $command "; done
done
"$durero" --help | sed -n '/^Subcommands:/,$s/^  \([a-z]*\) .*/\1/p' >commands
[ -s commands ] || fail "the program has no commands"
while read -r command; do says said "$command"; done <commands
x 2 tset; says complaint 'expected test'; one_line
x 2 tarce scene.json; says complaint 'expected trace'; one_line
x 2 frobnicate; says complaint 'expected one of demo test'; one_line
x 2 test --lnog; says complaint '--no-proofs'; one_line
[ ! -e tree/build ] || fail "something was built"
ln -s ../tree/x bin/front-door
door=./bin/front-door x 0 help
says said 'The front door'
rm bin/front-door

# Programs that write their arguments. No Debian: dpkg-query is absent.
stub() { printf '#!/bin/sh\n%s\n' "$2" >"bin/$1"; chmod +x "bin/$1"; }
for program in sh wc chmod sed awk dirname readlink cat grep tail head mkdir rm id nproc setsid sleep mktemp; do
  ln -sf "$(command -v $program)" "bin/$program"
done
PATH=$tmp/bin
export PATH
x 2 build; says complaint 'there is no C++ compiler'; one_line
stub c++ ''
x 2 build; says complaint 'there is no cmake'; one_line
stub cmake 'echo cmake version 3.18.4'
x 2 build; says complaint 'cmake version 3.18.4 is too old; install CMake 3.25'; one_line
stub cmake 'echo cmake version 3.25.1; [ "$1" = --version ] || echo "cmake $*" >>../called'
x 2 build; says complaint 'there is no ninja'; one_line
stub ninja ''
x 0 build
says called '--target durero'

# What a test asks of packages and of ctest.
stub ctest 'echo "ctest $*" >called'
stub dpkg-query 'echo "$*" >>packages; echo install ok installed'
x 0 test
says packages ' coq'
grep -q -e '-LE proofs' called && fail "proofs were left out"
rm packages
x 0 test --no-proofs
grep -q ' coq' packages && fail "Coq was asked for"
says called '-LE proofs'
says complaint 'without Coq'

# Packages that cannot be installed.
stub dpkg-query 'echo'
stub apt-get 'echo "E: Could not resolve host" >&2; exit 100'
stub id 'echo 0'
x 2 build
says complaint 'is there a network? apt-get said: E: Could not resolve host'
stub id 'echo 1000'
x 2 build; says complaint 'neither root nor sudo: run, as root, apt-get install'; one_line

# Who is stopped takes along what was started.
stub dpkg-query 'echo install ok installed'
stub cmake 'echo cmake version 3.25.1; [ "$1" != --build ] || { echo $$ >child; sleep 60; }'
called='build, stopped'
./tree/x build >said 2>complaint &
door=$!
for _ in 1 2 3 4 5 6 7 8 9 10; do [ -s tree/child ] || sleep 1; done
kill -TERM "$door"
wait "$door" || status=$?
[ "$status" = 130 ] || fail "status $status"
sleep 1
kill -0 "$(cat tree/child)" 2>/dev/null && fail "what it started goes on"
echo "$checks calls, $bad failures"
[ "$bad" = 0 ]
