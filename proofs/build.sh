#!/bin/sh
# Builds the proofs in a build directory, so that no compiled file lies among the sources.
#   proofs/build.sh [BUILD_DIRECTORY] [JOBS]     default: build/proofs, 2
# A file is copied only when it changed, so a second call compiles only what depends on a change. All depend on the
# options of _CoqProject.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
build=${1:-$here/../build/proofs}
jobs=${2:-2}
mkdir -p "$build"
for old in "$build"/*.v; do
  [ -e "$old" ] || continue
  [ -f "$here/${old##*/}" ] || rm -f "${old%.v}".*
done
cmp -s "$here/_CoqProject" "$build/_CoqProject" || rm -f "$build"/*.vo
for file in "$here"/*.v "$here/_CoqProject"; do
  cmp -s "$file" "$build/${file##*/}" || cp "$file" "$build/"
done
cd "$build"
coq_makefile -f _CoqProject ./*.v -o Makefile
# Little of what Coq allots lives on, and no file needs much: it is collected seldom.
export OCAMLRUNPARAM="${OCAMLRUNPARAM:-s=4M,o=1000}"
exec make --no-print-directory -j "$jobs"
