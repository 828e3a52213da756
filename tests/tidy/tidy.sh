#!/bin/sh
# tidy.sh ROOT BUILD: clang-tidy over every source, as the preset tidy runs it, in a folder of BUILD. Planted findings
# must be seen. Status 77: clang-tidy or Clang is absent.
set -eu
root=$1 build=$2/tidy
for tool in clang++-16 clang-tidy-16; do
  command -v "$tool" >/dev/null || { echo "skipped: $tool is absent; install clang-16 and clang-tidy-16, or run ./x test --long"; exit 77; }
done
mkdir -p "$build/planted"
cp "$root/.clang-tidy" "$build/planted"
printf 'int f(const int* p) {\n  int unchanged = 2;\n  return p == nullptr ? *p : unchanged;\n}\n' >"$build/planted/finding.cpp"
for finding in 'clang-analyzer-core.NullDereference' 'misc-const-correctness'; do
  if clang-tidy-16 "$build/planted/finding.cpp" -- -std=c++20 >"$build/said" 2>&1 || ! grep -q "$finding" "$build/said"; then
    cat "$build/said"
    echo "tidy: the planted finding is not seen: $finding"
    exit 1
  fi
done

cd "$root"
cmake --preset tidy -B "$build" -DDURERO_TESTS=ON >"$build/log" 2>&1 || { cat "$build/log"; exit 1; }
cmake --build "$build" --target all -- -k 0 >>"$build/log" 2>&1 || {
  grep -E '(error|warning): ' "$build/log" | sort -u || tail -n 40 "$build/log"
  echo "tidy: the whole log is $build/log"
  exit 1
}
