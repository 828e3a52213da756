#!/bin/sh
# Extracts Exacto.v, and Search.v with Occlusion.v, to OCaml and compiles a program of each.
#   proofs/oracle/build.sh [BUILD_DIRECTORY]     default: build/proofs, where proofs/build.sh compiled the proofs
# The programs are BUILD_DIRECTORY/oracle/oracle and BUILD_DIRECTORY/oracle/tables. They need ocamlfind, ocamlopt and
# Zarith's development files (Debian: ocaml-nox, ocaml-findlib, libzarith-ocaml-dev).
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
proofs=${1:-$here/../../build/proofs}
mkdir -p "$proofs/oracle"
proofs=$(CDPATH='' cd -- "$proofs" && pwd)
cp "$here"/*.v "$here"/*.ml "$proofs/oracle/"
cd "$proofs/oracle"

# program NAME EXTRACTION MODULE MAIN
program() {
  coqc -q -Q .. Durero "$2.v"
  ocamlfind ocamlopt -O3 -w +a-4-9-33-39-40-42-44-45-70 -package zarith -linkpkg "$3.mli" "$3.ml" "$4.ml" -o "$1"
}
program oracle Extract exacto main
program tables ExtractSearch search tables
