#!/bin/sh
# tsan.sh ROOT BUILD: builds the tests of parallel code under ThreadSanitizer, in a folder of BUILD, and runs them there.
# A planted race must be seen, and the same loop without it must not. Status 77: this machine cannot make that build.
set -eu
root=$1 build=$2/tsan
export TSAN_OPTIONS="halt_on_error=1 second_deadlock_stack=1 suppressions=$root/tests/tsan/suppressions.txt"
mkdir -p "$build"
echo 'int main() {}' >"$build/empty.cpp"
c++ -fsanitize=thread "$build/empty.cpp" -o "$build/empty" 2>/dev/null && "$build/empty" ||
  { echo "skipped: no ThreadSanitizer here; install g++ with libtsan"; exit 77; }

# The tests whose sources speak of threads, loops on them, or pictures; the programs that hold them, and the program that the
# scripts run. Those of shaders draw by Mesa's threads, which were not compiled for the sanitizer: it accuses them falsely.
cd "$root"
sources=$(grep -lE 'threads|parallel_for|render\(' tests/*/*_test.cpp tests/cli/*_test.sh | grep -v '^tests/shader/')
names=$(printf '%s\n' "$sources" | sed 's|^tests/||; s|\.[a-z]*$||' | paste -sd'|')
programs=$(printf '%s\n' "$sources" | sed -n 's|^tests/\([^/]*\)/.*\.cpp$|\1_tests|p' | sort -u)
# shellcheck disable=SC2086  # each program is a word
{ cmake --preset tsan -B "$build" && cmake --build "$build" --target durero race $programs; } >"$build/log" 2>&1 ||
  { tail -n 40 "$build/log"; echo "tsan: the build failed: $build/log"; exit 1; }

"$build/tests/tsan/race" apart >"$build/said" 2>&1 || { cat "$build/said"; echo "tsan: a loop without a race is accused"; exit 1; }
if "$build/tests/tsan/race" shared >"$build/said" 2>&1 || ! grep -q 'data race' "$build/said"; then
  cat "$build/said"
  echo "tsan: the planted race is not seen"
  exit 1
fi
exec ctest --test-dir "$build" --output-on-failure --no-tests=error -R "^($names)\$"
