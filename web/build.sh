#!/bin/sh
# Writes the page as one file, OUT/index.html: its style, its scripts, its documents, and the engine as the text of a worker.
#   sh web/build.sh OUT [ENGINE.js]
# It opens from the disk. A source is a module; here all are one script, in the order below, which is that of their imports.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
root=$(dirname -- "$here")
out=${1:?build.sh: expected the folder to write to} engine=${2-}
modules="vectors numbers dom words ask address ztext values marked shapes solids drawn window drawing stage state facts text_panel names
  exact_view decided_view inspector operations picture surface printed walk machine own exercises shader_view main"
mkdir -p "$out"

# script: every module in a scope of its own. What it exports is kept under its name, and its imports are taken from there.
script() {
  echo '"use strict";(() => {'
  documents
  echo 'const modules = {};'
  earlier=' '
  for module in $modules; do
    awk -v name="$module" -v earlier="$earlier" '
      function fail(why) { print "build.sh: " name ".js:" NR ": " why >"/dev/stderr"; failed = 1; exit 1 }
      BEGIN { print "modules." name " = (() => {" }
      /^import / { while ($0 !~ /;$/ && (getline more) > 0) { sub(/^ +/, "", more); $0 = $0 " " more } gsub(/,? +\}/, " }") }
      /^import / {
        if ($0 !~ /^import \{ [a-z0-9_, ]* \} from "\.\/[a-z_]*\.js";$/) fail("an import of another form")
        from = $0; sub(/^.*"\.\//, "", from); sub(/\.js";$/, "", from)
        if (!index(earlier, " " from " ")) fail("an import of " from ", which comes later")
        names = $0; sub(/^import /, "", names); sub(/ from .*$/, "", names)
        print "const " names " = modules." from ";"
        next
      }
      /^export / {
        sub(/^export /, "")
        if (!match($0, /^(async )?(function|const) [a-z0-9_]+/)) fail("an export of another form")
        word = substr($0, 1, RLENGTH); sub(/^.* /, "", word)
        exported = exported (exported == "" ? "" : ", ") word
      }
      { print }
      END { if (!failed) print "return { " exported " };\n})();" }' "$here/$module.js" || return 1
    earlier="$earlier$module "
  done
  echo '})();'
}

# quoted: a text as a string of JavaScript that no end of a script stands in.
quoted() {
  awk 'BEGIN { printf "\"" }
    { gsub(/\\/, "&&"); gsub(/"/, "\\\""); gsub(/\t/, "\\t"); gsub(/\r/, "\\r"); gsub(/</, "\\u003c"); printf "%s\\n", $0 }
    END { printf "\"" }' "$@"
}

# theorems: each theorem of the proofs up to its proof, by its place.
theorems() {
  echo '{'
  for file in "$root"/proofs/*.v; do
    awk -v file="proofs/${file##*/}" '
      /^ *(Theorem|Lemma|Corollary|Example) / { said = ""; line = NR; open = 1 }
      open && /^ *Proof/ { end() }
      open { text = $0; gsub(/\\/, "&&", text); gsub(/"/, "\\\"", text); gsub(/\t/, " ", text); gsub(/</, "\\u003c", text); said = said text "\\n" }
      open && /Proof\./ { end() }
      function end() { sub(/ *Proof\..*$/, "", said); printf "\"%s:%d\":\"%s\",\n", file, line, said; open = 0 }' "$file"
  done
  echo '"":""}'
}

documents() {
  printf 'const documents = {\n'
  for file in docs/refinement.md docs/proofs.md proofs/README.md proofs/assumptions.txt; do
    printf '"%s":' "$file"; quoted "$root/$file"; echo ','
  done
  for file in demo/birthday_book.tex demo/surfaces/torus demo/surfaces/ellipsoid demo/surfaces/hyperboloid demo/surfaces/cubic \
    web/examples/lift.tex web/examples/file_system.tex web/examples/first.json demo/still-life.json demo/mirrors.json demo/gallery/shader.json \
    spec/puntos.tex spec/impresa/dibujo/superficies.tex; do
    case $file in *.*) set -- "$file" ;; *) set -- "$file.tex" "$file.json" ;; esac
    for one in "$@"; do printf '"%s":' "${one##*/}"; quoted "$root/$one"; echo ','; done
  done
  printf '};\nconst theorems = '
  theorems
  echo ';'
}

script >"$out/script.part"
if command -v node >/dev/null 2>&1; then cp "$out/script.part" "$out/script.check.js"; node --check "$out/script.check.js"; rm "$out/script.check.js"; fi
if [ -n "$engine" ]; then
  ! grep -qi '</script' "$engine" || { echo "build.sh: $engine has the end of a script in it" >&2; exit 1; }
fi
awk -v style="$here/style.css" -v script="$out/script.part" -v engine="$engine" '
  function copy(file,   line) { while ((getline line <file) > 0) print line; close(file) }
  $0 == "@STYLE@" { copy(style); next }
  $0 == "@SCRIPT@" { copy(script); next }
  $0 == "@ENGINE@" { if (engine != "") copy(engine); next }
  { print }' "$here/index.html" >"$out/index.html.part"
rm "$out/script.part"
mv "$out/index.html.part" "$out/index.html"
echo "$out/index.html"
