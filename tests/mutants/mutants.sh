#!/bin/sh
# Small faults, each of which a named test must see. A copy of the sources gets the fault, what depends on it is compiled
# again and linked into that test in place of the right object, and the test must fail.
#   mutants.sh BUILD --all          every mutant of the list
#   mutants.sh BUILD NUMBER         that many, chosen by MUTANT_SEED: by the commit, where that is absent, so that the same
#                                   commit is tried with the same faults everywhere
#   mutants.sh BUILD --for MINUTES  as many as so many minutes take, in the order of that choice
#   mutants.sh BUILD PATTERN...     those whose name, file or test program matches a pattern of the shell: 'ball-*',
#                                   'src/zed/*', zed_tests; only the programs that they need are built first
# It fails on a mutant that survives, that no longer applies or does not compile, and on a test that fails without any
# fault. BUILD is a build made by Ninja; MUTANTS names another list, MUTANT_JOBS how many are tried at a time.
set -u
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
root=$(CDPATH='' cd -- "$here/../.." && pwd)
build=$(CDPATH='' cd -- "$1" && pwd) || exit 2
list=${MUTANTS:-$here/mutants.txt}
work=${MUTANTS_WORK:-$build/mutants}
DURERO_SYSTEMS=$root/systems  # which a program elsewhere than in its build does not find
export DURERO_SYSTEMS
shift

# field NAME KEY: what stands behind the key in the block of that mutant.
field() {
  awk -v name="mutant $1" -v key="$2 " '$0 == name {inside = 1; next} /^mutant / {inside = 0}
    inside && index($0, key) == 1 {print substr($0, length(key) + 1)}' "$list"
}

# target PROGRAM: how the build names it.
target() { case $1 in durero) echo durero ;; *) echo "tests/$1" ;; esac; }

# runs PROGRAM SPEC LOG SECONDS: the tests of that specification but the long ones, which must match some; of durero itself,
# that script of tests/cli. A fault may make a loop endless, in which a program may print, and heed no signal that it can catch.
runs() (
  ulimit -f 1000000  # blocks of 512 bytes, of any file that is written
  case ${1##*/} in
    durero) set -- sh "$root/tests/cli/$2.sh" "$1" "$3" "$4" && (timeout -k 5 "$5" "$1" "$2" "$3"; exit $?) >"$4" 2>&1 ;;
    *) (cd "$build/tests" && timeout -k 5 "$4" "$1" --warn NoTests --filenames-as-tags "~[long]$(printf '%s' "$2" | sed 's/,/,~[long]/g')"; exit $?) >"$3" 2>&1 ;;
  esac
)

# apply OLD NEW FILE: replaces the one place of the old text; fails where there is none, or more than one.
apply() {
  OLD=$1 NEW=$2 awk 'BEGIN {old = ENVIRON["OLD"]; new = ENVIRON["NEW"]}
    {line = $0; out = ""
     while ((at = index(line, old)) > 0) {++places; out = out substr(line, 1, at - 1) new; line = substr(line, at + length(old))}
     print out line}
    END {exit places == 1 ? 0 : 1}' "$3" >"$3.mutated" && mv "$3.mutated" "$3"
}

# units FILE LINK: the objects, of the libraries and sources in the link command, that are made from the file.
units() {
  awk -v file="/$1" -v link=" $2 " '
    /^[^ ].*: #deps/ {object = $1; sub(/:$/, "", object); next}
    substr($1, length($1) - length(file) + 1) == file && !(object in seen) {
      seen[object] = 1
      library = object; sub(/CMakeFiles\//, "lib", library); sub(/\.dir\/.*/, ".a", library)
      if (index(link, " " object " ") || index(link, " " library " ")) print object}' "$work/deps"
}

# seconds_of TEST: the file that says how many seconds the test takes without a fault.
seconds_of() { echo "$work/seconds.$(printf '%s' "$1" | cksum | tr ' ' .)"; }

one() {
  name=$1 file=$(field "$1" file) test=$(field "$1" test) old=$(field "$1" -) new=$(field "$1" +)
  program=${test%% *} spec=${test#* }
  copy=$work/$name
  rm -rf "$copy" && mkdir -p "$copy" || return 2
  # Links are enough, since the fault is put in a new file that takes the place of the old.
  cp -rl "$root/include" "$root/src" "$root/tests" "$copy" 2>/dev/null ||
    cp -r "$root/include" "$root/src" "$root/tests" "$copy" || return 2
  if ! [ -f "$copy/$file" ] || ! apply "$old" "$new" "$copy/$file"; then
    echo "mutants: $name no longer applies: $file has not exactly one place with: $old"
    return 1
  fi
  link=$(ninja -C "$build" -t commands "$(target "$program")" | tail -n 1)
  objects=$(units "$file" "$link")
  [ -n "$objects" ] || { echo "mutants: $name: nothing in $program is made from $file"; return 1; }
  added=
  for object in $objects; do
    mkdir -p "$copy/$(dirname "$object")"
    command=$(ninja -C "$build" -t commands "$object" | tail -n 1 | sed -E "s#$root/(include|src|tests)#$copy/\1#g")
    united=$(printf '%s\n' "$command" | sed -n 's#.* -c \([^ ]*/Unity/[^ ]*\)$#\1#p')
    if [ -n "$united" ]; then  # several sources compiled as one, which names them where they are
      sed "s#$root/#$copy/#" "$united" >"$copy/$object.cxx"
      command=${command%"$united"}$copy/$object.cxx
    fi
    (cd "$copy" && eval "$command") >"$copy/log" 2>&1 || { echo "mutants: $name does not compile:"; cat "$copy/log"; return 1; }
    case " $link " in
      *" $object "*) link=$(printf '%s\n' "$link" | sed "s# $object # $copy/$object #") ;;
      *) added="$added $copy/$object" ;;
    esac
  done
  link=$(printf '%s\n' "$link" | sed "s# -o $(target "$program") #$added -o $copy/$program #")
  (cd "$build" && eval "$link") >"$copy/log" 2>&1 || { echo "mutants: $name does not link:"; cat "$copy/log"; return 1; }
  seconds=$(cat "$(seconds_of "$test")" 2>/dev/null) || seconds=300
  if runs "$copy/$program" "$spec" "$copy/log" $((60 + 4 * seconds)); then  # so that a slow machine alone catches nothing
    echo "mutants: $name SURVIVED $program $spec: $file: $old -> $new"
    return 1
  fi
  echo "caught: $name, by $program $spec"
  rm -rf "$copy"
}

case ${1-} in
  --one) one "$2"; exit ;;
  --baseline)
    mkdir -p "$work"
    log=$(mktemp "$work/log.XXXXXX")
    begun=$(date +%s)
    if runs "$build/$(target "${2%% *}")" "${2#* }" "$log" 300; then
      echo $(($(date +%s) - begun)) >"$(seconds_of "$2")"
      rm -f "$log"
      exit 0
    fi
    echo "mutants: without any fault $2 fails, or matches no test: $log"
    exit 1 ;;
esac

# The commit as a number; without Git, the list itself.
commit() {
  hash=$(git -C "$root" rev-parse HEAD 2>/dev/null) || hash=$(cksum <"$list" | awk '{printf "%08x", $1}')
  printf '%d\n' "0x$(printf '%.7s' "$hash")"
}

# matching PATTERN...: the names of the mutants that match one of them; each must match some.
matching() {
  for pattern in "$@"; do
    before=$found
    while read -r key value rest; do
      # shellcheck disable=SC2254  # it is meant as a pattern
      case $key in
        mutant) name=$value taken=false ;;
        file | test) : ;;
        *) continue ;;
      esac
      # shellcheck disable=SC2254
      case $value in
        $pattern) "$taken" || found="$found$name
" taken=true ;;
      esac
    done <"$list"
    [ "$found" != "$before" ] || { echo "mutants: no name, file or test matches $pattern" >&2; return 1; }
  done
}

# shuffled NUMBER: the names of that many mutants, in an order that the seed says.
shuffled() {
  sed -n 's/^mutant //p' "$list" | awk -v seed="$seed" -v wanted="$1" '{name[NR] = $0}
    END {x = seed % 2147483647; if (x < 1) x = 1
      for (left = NR; wanted > 0 && left > 0; --wanted) {
        for (i = 0; i < 3; ++i) x = (x * 16807) % 2147483647
        i = 1 + x % left; print name[i]; name[i] = name[left--]}}'
}

seed=${MUTANT_SEED:-$(commit)}
end=
case ${1-} in
  --all) chosen=$(sed -n 's/^mutant //p' "$list") ;;
  [0-9]*)
    echo "mutants: $1 of the list; replay with MUTANT_SEED=$seed sh tests/mutants/mutants.sh $build $1"
    chosen=$(shuffled "$1") ;;
  --for)
    case ${2-} in '' | 0* | *[!0-9]*) echo "mutants: --for takes a number of minutes" >&2; exit 2 ;; esac
    echo "mutants: for $2 minutes; replay with MUTANT_SEED=$seed sh tests/mutants/mutants.sh $build --for $2"
    end=$(($(date +%s) + 60 * $2))
    chosen=$(shuffled "$(grep -c '^mutant ' "$list")") ;;
  *)
    found=
    matching "$@" || exit 2
    chosen=$(printf '%s' "$found" | sort -u)
    # shellcheck disable=SC2046  # each program is a word
    ninja -C "$build" $(for name in $chosen; do field "$name" test; done | sed 's| .*||' | sort -u | while read -r program; do target "$program"; done) >"$build/mutants.log" ||
      { tail -n 40 "$build/mutants.log"; exit 2; } ;;
esac

mkdir -p "$work" && ninja -C "$build" -t deps >"$work/deps" || exit 2
export MUTANTS="$list" MUTANTS_WORK="$work"
jobs=${MUTANT_JOBS:-$(nproc 2>/dev/null || echo 1)}
# tries NAMES: each of these faults, after their tests without any.
tries() {
  printf '%s\n' "$1" | while read -r name; do field "$name" test; done | sort -u |
    xargs -d '\n' -P "$jobs" -n 1 sh "$0" "$build" --baseline
  baseline=$?
  printf '%s\n' "$1" | xargs -P "$jobs" -n 1 sh "$0" "$build" --one
  [ $? = 0 ] && [ "$baseline" = 0 ]
}

# Where the time ends, the faults are tried in parts of a few.
all=$(printf '%s\n' "$chosen" | wc -l | tr -d ' ') tried=0 part=$((4 * jobs)) status=0
[ -n "$end" ] || part=$all
while [ "$tried" -lt "$all" ] && { [ -z "$end" ] || [ "$(date +%s)" -lt "$end" ]; }; do
  tries "$(printf '%s\n' "$chosen" | tail -n +$((tried + 1)) | head -n "$part")" || status=1
  tried=$((tried + part < all ? tried + part : all))
done
[ "$status" = 0 ] || { echo "mutants: not every fault is caught"; exit 1; }
echo "mutants: $tried faults${end:+ of $all}, all caught"
