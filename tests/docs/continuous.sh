#!/bin/sh
# continuous.sh ROOT: what .ci/run runs, in which order, in which environment and in which tree; here ./x only writes its
# arguments. CTest's closing lines end the output, and the status is that of the tests.
set -eu
root=$1
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
mkdir -p "$tmp/tree/.ci"
cp "$root/.ci/run" "$tmp/tree/.ci/run"
cat >"$tmp/tree/x" <<'END'
#!/bin/sh
echo "$*" >>"$HOME/calls"
env | sed 's/=.*//' | sort >"$HOME/environment"
pwd >"$HOME/folder"
[ ! -e "$HOME/fails on $*" ] || { echo "$* fails"; exit 8; }
[ "$*" != "$(cat "$HOME/slow stage" 2>/dev/null)" ] || echo 3301 >"$HOME/now"
[ "$*" != test ] || { printf '100%% tests passed, 0 tests failed out of 1\nTotal Test time (real) =  9 sec\n'; exit 0; }
[ "$*" = 'test --asan --readers' ] || exit 0
[ ! -e build ] || { echo 'a build is there'; exit 1; }
mkdir -p build/asan/Testing/Temporary
printf '# ninja log v5\n0\t1500\t7\tslow.o\tff\n0\t90000\t7\tquick.o\tff\n0\t20\t7\tquick.o\tff\n' >build/asan/.ninja_log
printf 'io/quick 1 0.5\nio/slow 1 12.25\n---\nio/slow\n' >build/asan/Testing/Temporary/CTestCostData.txt
echo 'Test project'
[ ! -e "$HOME/a test fails" ] || { printf '50%% tests passed, 1 tests failed out of 2\n'; echo 'Errors while running CTest'; exit 8; }
printf '100%% tests passed, 0 tests failed out of 2\nTotal Test time (real) =  1 sec\n'
END
mkdir "$tmp/bin"
printf '#!/bin/sh\ncat "$HOME/now"\n' >"$tmp/bin/date"
chmod +x "$tmp/tree/x" "$tmp/bin/date"
cd "$tmp/tree"
git init -q .
git add -A
git -c user.name=nobody -c user.email=nobody commit -q -m 'a tree'
bad=0
fail() { echo ".ci/run: $*"; sed 's/^/  /' "$tmp/said"; bad=$((bad + 1)); }
run() { # run WANTED_STATUS
  rm -f "$tmp/calls" "$tmp/folder"
  status=0
  echo 0 >"$tmp/now"
  PATH=$tmp/bin:$PATH HOME=$tmp PYTHONUNBUFFERED=1 DURERO_SYSTEMS=/nowhere CI=yes sh .ci/run >"$tmp/said" 2>&1 || status=$?
  [ "$status" = "$1" ] || fail "status $status instead of $1"
}

run 0
printf '%s\n' lint test 'test --systems' 'test --page' 'test --asan --readers' | cmp -s - "$tmp/calls" || fail "other calls: $(cat "$tmp/calls")"
[ "$(tail -n 1 "$tmp/said")" = 'Total Test time (real) =  1 sec' ] || fail "CTest's closing lines do not end the output"
printf '%s\n' CI HOME LANG PATH >"$tmp/wanted"
grep -vE '^(PWD|DURERO_SPD|OLDPWD|SHLVL|_|[A-Z_]*(CA|CERT|SSL|CCACHE)[A-Z_]*|(http|https|no)_proxy)$' "$tmp/environment" |
  cmp -s - "$tmp/wanted" || fail "another environment: $(tr '\n' ' ' <"$tmp/environment")"
[ "$(cat "$tmp/folder")" = "$(pwd -P)" ] || fail "a tree without a build was cloned"
grep -A 2 '^the slowest steps' "$tmp/said" | tail -n 2 | tr -s ' ' >"$tmp/steps"
printf ' 1.5 s asan:slow.o\n 0.0 s asan:quick.o\n' | cmp -s - "$tmp/steps" || fail 'other steps are the slowest'
grep -A 1 '^the slowest tests' "$tmp/said" | grep -q ' 12.2 s  asan:io/slow\| 12.3 s  asan:io/slow' || fail 'another test is the slowest'

# A slow machine: the time does not do for what may be left out, and the output says so.
echo test >"$tmp/slow stage"
run 0
printf '%s\n' lint test | cmp -s - "$tmp/calls" || fail "other calls on a slow machine: $(cat "$tmp/calls")"
[ "$(grep -c 'did not run, as 55 minutes have passed' "$tmp/said")" = 3 ] || fail 'it does not say what did not run'
[ "$(tail -n 1 "$tmp/said")" = 'Total Test time (real) =  9 sec' ] || fail "CTest's closing lines do not end the output of a short run"
echo 'test --page' >"$tmp/slow stage"
run 0
printf '%s\n' lint test 'test --systems' 'test --page' | cmp -s - "$tmp/calls" || fail "other calls, slow at the end: $(cat "$tmp/calls")"
rm "$tmp/slow stage"

# A tree that has a build: a clone runs, of what is committed, and is gone afterwards.
echo a >new
run 0
folder=$(cat "$tmp/folder")
[ "$folder" != "$(pwd -P)" ] || fail "a tree with a build was not cloned"
[ ! -e "$folder" ] || fail "the clone is left"
grep -q 'what is not committed does not run' "$tmp/said" || fail "it does not say that something is not committed"

# What fails ends the run; of the last one the closing lines still end the output.
touch "$tmp/fails on test"
run 8
[ "$(tail -n 1 "$tmp/calls")" = test ] || fail "it goes on after a failure"
rm "$tmp/fails on test"
touch "$tmp/fails on test --systems"
run 8
[ "$(tail -n 1 "$tmp/said")" != 'Total Test time (real) =  9 sec' ] || fail "an earlier call's closing lines end the output of a failure"
rm "$tmp/fails on test --systems"
touch "$tmp/a test fails"
run 8
[ "$(tail -n 1 "$tmp/said")" = 'Errors while running CTest' ] || fail "CTest's closing lines do not end the output of a failure"
[ "$bad" = 0 ]
