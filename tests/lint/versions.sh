#!/bin/sh
# One version everywhere: that of CMakeLists.txt. Each place is a file and what stands before the version on its line.
version=$(sed -nE 's/^project\(durero VERSION ([0-9.]+).*/\1/p' CMakeLists.txt)
first() { # first FILE BEFORE: the version on the first line of FILE that begins so
  found=$(awk -v before="$2" 'index($0, before) == 1 { $0 = substr($0, length(before) + 1); sub(/[^0-9.].*/, ""); print FNR " " $0; exit }' "$1")
  [ "${found#* }" = "$3" ] || echo "$1:${found%% *}: the version is ${found#* }; expected $3, as in CMakeLists.txt"
}
{
  [ -n "$version" ] || echo "CMakeLists.txt:1: no version; expected project(durero VERSION …)"
  first CHANGELOG.md '## [' "$version"
  first CITATION.cff 'version: ' "$version"
  first debian/changelog 'durero (' "$version"
  first docs/library.md 'find_package(durero ' "${version%.*}"
  if [ -f pyproject.toml ] && grep -q '^version = ' pyproject.toml; then first pyproject.toml 'version = "' "$version"; fi
} | { ! grep .; }
