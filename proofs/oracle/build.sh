#!/bin/sh
# Extracts Exacto.v to OCaml and compiles the oracle program.
#   proofs/oracle/build.sh [BUILD_DIRECTORY]     default: build/proofs, where proofs/build.sh compiled the proofs
# The program is BUILD_DIRECTORY/oracle/oracle. It needs ocamlfind, ocamlopt and Zarith's development files
# (Debian: ocaml-nox, ocaml-findlib, libzarith-ocaml-dev).
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
proofs=${1:-$here/../../build/proofs}
mkdir -p "$proofs/oracle"
proofs=$(CDPATH='' cd -- "$proofs" && pwd)
cp "$here/Extract.v" "$here/main.ml" "$proofs/oracle/"
cd "$proofs/oracle"
coqc -q -Q .. Durero Extract.v
ocamlfind ocamlopt -O3 -w +a-4-9-33-39-40-42-44-45-70 -package zarith -linkpkg exacto.mli exacto.ml main.ml -o oracle
