#!/bin/sh
# front_door.sh DURERO ROOT: ./x answers at once what needs no program, works through a link, stops what it started, and
# says in one line what is missing. Here it stands in a tree of its own, among programs that only write their arguments.
set -eu
durero=$1 root=$2
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
mkdir -p "$tmp/tree/src/cli" "$tmp/bin" "$tmp/temporary"
export TMPDIR="$tmp/temporary"  # of ./x
cp "$root/x" "$tmp/tree/x"
cp "$root/src/cli/commands.hpp" "$tmp/tree/src/cli/commands.hpp"  # where it reads the commands of the program
mkdir -p "$tmp/tree/src/text"
cp "$root/src/text/spanish.cpp" "$tmp/tree/src/text"
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
  for command in demo test bench lint build package release reference site spec-pdf page; do says said "./x $command "; done
done
"$durero" --help | sed -n '/^  help /d; s/^  \([a-z][a-z]*\)  .*/\1/p' | sort >commands
[ -s commands ] || fail "the program has no commands"
tr '\n' ' ' <said | sed 's/.*a command of the built program: \([^;]*\);.*/\1/' | tr -s ', ' '\n' | sort >told
cmp -s told commands || fail "other commands than the program's: $(diff told commands)"
x 2 tset; says complaint 'expected test'; one_line
x 2 tarce scene.json; says complaint 'expected trace'; one_line
x 2 frobnicate; says complaint 'expected one of demo gallery test'; one_line
x 2 --hlep; says complaint 'expected --help'; one_line
x 2 -q; says complaint 'expected one of --help, --version'; one_line
x 2 lint --quick; says complaint './x lint takes nothing'; one_line
x 2 release --tags; says complaint 'expected --tag'; one_line
x 2 test --lnog; says complaint '--no-proofs'; one_line
[ ! -e tree/build ] || fail "something was built"
ln -s ../tree/x bin/front-door
door=./bin/front-door x 0 help
says said 'The front door'
rm bin/front-door

# Every word of its own says its help before anything is installed or built, and so does ./x help WORD.
for word in demo gallery test bench lint build package release reference site spec-pdf page; do
  x 0 $word --help; says said "./x $word "; [ "$(grep -c '^./x ' said)" = 1 ] || fail "it says other words, too"
  cp said by_option
  x 0 help $word
  cmp -s said by_option || fail "another help than ./x $word --help"
done
x 0 bench --vs -h; says said './x bench '
x 0 help test; says said '--systems'
x 2 help tset; says complaint 'expected test'; one_line
x 2 help raido; says complaint 'there is no command "raido"'; one_line
[ ! -e tree/build ] || fail "something was built"

# Programs that write their arguments. No Debian: dpkg-query is absent. A stub takes the place of a link: written through
# it, the program of the machine would be lost.
stub() { rm -f "bin/$1"; printf '#!/bin/sh\n%s\n' "$2" >"bin/$1"; chmod +x "bin/$1"; }
for program in sh wc chmod sed awk tr dirname readlink cat env grep tail head mkdir rm id nproc setsid sleep mktemp sha256sum uname cut mv; do
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
[ "$(tail -n 1 called)" = 'cmake --build --preset release --target durero_installation' ] || fail "$(cat called)"
mkdir -p tree/build/release
printf '#!/bin/sh\necho "durero $*"\n' >tree/build/release/durero
chmod +x tree/build/release/durero
for words in 'render --help' 'help render'; do
  # shellcheck disable=SC2086  # words are meant to split
  x 0 $words; says said 'durero render --help'
  [ "$(tail -n 1 called)" = 'cmake --build --preset release --target durero' ] || fail "more was built than the program"
done
x 0 help conform run; says said 'durero conform run --help'
for words in radio Sphere 't!' 'truncated cone'; do
  # shellcheck disable=SC2086  # words are meant to split
  x 0 help $words; says said "durero help $words"
done
x 2 help raido; says complaint 'there is no command "raido"'; one_line
rm -r tree/build/release

# The program of a release beside the script draws the demonstration, if it is the release of these sources.
machine=$(uname -m)
mkdir tree/demo
echo 'echo "demo.sh $*"' >tree/demo/demo.sh
echo 'project(durero VERSION 1.2.3 LANGUAGES CXX' >tree/CMakeLists.txt
program=tree/durero-1.2.3-$machine
: >called
x 0 demo
says called '--target durero_demo'
printf '#!/bin/sh\necho durero 1.2.3\n' >"$program"
x 2 demo; says complaint "durero-1.2.3-$machine has no SHA256SUMS beside it"; one_line
: >tree/SHA256SUMS
x 2 demo; says complaint "SHA256SUMS has no digest of durero-1.2.3-$machine"; one_line
(cd tree && sha256sum "durero-1.2.3-$machine" >SHA256SUMS)
x 2 demo; says complaint "cannot be run; expected chmod +x durero-1.2.3-$machine"; one_line
chmod +x "$program"
: >called
x 0 demo
says said "demo.sh $tmp/tree/durero-1.2.3-$machine $tmp/tree/demo $tmp"
says complaint "the program of a release, durero-1.2.3-$machine, draws; nothing is built"; one_line
[ ! -s called ] || fail "something was built"
echo '# changed' >>"$program"
x 2 demo; says complaint ', as in SHA256SUMS'; one_line
printf '#!/bin/sh\necho durero 1.2.2\n' >"$program"
(cd tree && sha256sum "durero-1.2.3-$machine" >SHA256SUMS)
x 2 demo; says complaint 'says that it is durero 1.2.2; expected durero 1.2.3'; one_line
mv "$program" "tree/durero-1.2.2-$machine"
x 2 demo; says complaint "durero-1.2.2-$machine lies beside the sources of version 1.2.3; expected durero-1.2.3-$machine"; one_line
rm -r "tree/durero-1.2.2-$machine" tree/SHA256SUMS tree/CMakeLists.txt tree/demo

# What a test asks of packages and of ctest.
stub ctest 'echo "ctest $*" >called'
stub cmake 'echo cmake version 3.25.1; echo "$*" >built'
stub dpkg-query 'echo "$*" >>packages; echo install ok installed'
x 0 test
says packages ' coq'
grep -q -e '-LE proofs' called && fail "proofs were left out"
rm packages
x 0 test --no-proofs
grep -q ' coq' packages && fail "Coq was asked for"
says called '-LE proofs'
says complaint 'without Coq'
rm packages
x 0 test --asan --program
grep -q ' coq' packages && fail "Coq was asked for"
says called 'build/asan --output-on-failure'
says called '-L cli|fuzz'
grep -q 'preset asan --target durero replays$' tree/built || fail "it builds $(cat tree/built)"
x 0 test --asan --readers
says called '-L fuzz'
grep -q 'preset asan --target replays$' tree/built || fail "it builds $(cat tree/built)"

# How far a build is, on a terminal; and what failed of it.
stub cmake 'echo cmake version 3.25.1; [ "$1" != --build ] || { echo "@30 300 61.0@ Building"; sleep 3; echo "@31 300 64.0@ Linking"; exit 1; }'
script=$(PATH=/usr/bin:/bin command -v script)
called='build, on a terminal'
"$script" -qec "./tree/x build" /dev/null >said 2>complaint </dev/null || :
says said 'building: 30 of 300, 9 min left'
says said 'Linking'
says said 'the build failed; the whole log is'
grep -q '^@31' said && fail "it shows how far ninja was in the words meant for x"

# What is installed, and how much that is.
stub cmake 'echo cmake version 3.25.1'
stub dpkg-query 'case "$*" in *libpng-dev*) ;; *) echo install ok installed ;; esac'
stub id 'echo 0'
stub apt-get 'echo "0 upgraded, 12 newly installed, 0 to remove and 3 not upgraded."
echo "Need to get 3456 kB of archives."
echo "After this operation, 17.2 MB of additional disk space will be used."'
x 0 build
says complaint 'installing libpng-dev (12 newly installed, 3456 kB to fetch, 17.2 MB of additional disk space will be used)'

# Packages that cannot be installed: the network is asked about where apt-get could not fetch, and only there.
stub dpkg-query 'echo'
stub apt-get 'case $1 in update) echo "W: Failed to fetch InRelease" >&2 ;; *) echo "E: Unable to locate package g++" >&2; exit 100 ;; esac'
x 2 build
says complaint 'is there a network? apt-get said: E: Unable to locate package g++'
stub apt-get 'echo "E: Failed to fetch libpng-dev: Could not resolve a name" >&2; echo "E: Unable to fetch some archives" >&2; exit 100'
x 2 build
says complaint 'is there a network? apt-get said: E: Failed to fetch libpng-dev'
stub apt-get '[ "$1" = update ] || { echo "E: dpkg was interrupted, run dpkg --configure -a" >&2; echo "E: Sub-process" >&2; exit 100; }'
x 2 build
says complaint '; apt-get said: E: dpkg was interrupted, run dpkg --configure -a'
grep -q network complaint && fail "it asks about the network"
for left in temporary/*; do [ ! -e "$left" ] || fail "it leaves $left"; done
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
