#!/bin/sh
# Builds the proofs with a newer Coq than the one of Debian 12, where one is found: what a proof owes to the habits of one
# version's tactics shows then. 77, which CTest reports as skipped, where none is.
#   newer.sh BUILD_DIRECTORY
# It is looked for in DURERO_COQ, a directory with coqc, and in the switches of opam; Flocq must be there too.
set -eu
proofs=$(CDPATH='' cd -- "$(dirname -- "$0")/../../proofs" && pwd) build=$1
oldest=8.17

# Whether the directory has a coqc of that version or a later one, with what the proofs are made by and import.
newer() {
  version=$("$1/coqc" --print-version 2>/dev/null) || return 1
  version=${version%% *}
  [ "$(printf '%s\n' "$oldest" "$version" | sort -V | head -n 1)" = "$oldest" ] && [ -x "$1/coq_makefile" ] || return 1
  [ -d "$("$1/coqc" -where)/user-contrib/Flocq" ]
}

for bin in "${DURERO_COQ-}" "${OPAMROOT:-${HOME-/nonexistent}/.opam}"/*/bin; do
  [ -n "$bin" ] && newer "$bin" || continue
  echo "Coq $version of $bin"
  PATH=$bin:$PATH
  export PATH
  exec "$proofs/build.sh" "$build"
done
echo "skipped: no Coq from $oldest on with Flocq, neither in DURERO_COQ nor in a switch of opam"
exit 77
