#!/bin/sh
# The table in spec/README.md: one row a schema, set or function of the Z text, with how many of its predicates have a
# clause (or, for a definition, a function), a test and a theorem. `--write` puts it in place; without it, a table that
# says otherwise fails.
set -u
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
sh cmake/label_index.sh | awk -F '\t' '$1 !~ /\.conj\./' >"$tmp/index"  # a conjecture is carried out by nobody
table() {
  echo '| in the text | predicates | carried out | tested | proved by |'
  echo '| --- | --- | --- | --- | --- |'
  awk -F '\t' '
    function count(kind, owner,   n, label) { n = 0; for (label in of) if (of[label] == owner && (label, kind) in seen) ++n; return n }
    { split($1, part, "."); owner = part[1]; seen[$1, $2] = 1
      if ($2 == "text") { of[$1] = owner; if (!(owner in file)) { split($3, at, ":"); file[owner] = at[1]; line[owner] = at[2] + 0 }
                          split($3, at, ":"); if (at[2] + 0 < line[owner]) line[owner] = at[2] + 0 }
      if ($2 == "theorem" && !((owner, $4) in named)) { named[owner, $4] = 1
        theorems[owner] = theorems[owner] (theorems[owner] == "" ? "" : ", ") "`" $4 "`" } }
    END { for (owner in file)
        printf "%s %05d\t| `%s` | %d | %d | %d | %s |\n", file[owner], line[owner], owner, count("text", owner),
          count("clause", owner) + count("function", owner), count("test", owner),
          theorems[owner] == "" ? "–" : theorems[owner] }' "$tmp/index" |
    awk '{ stem = $1; sub(/^spec\//, "", stem); sub(/\.tex$/, "", stem); print order(stem) "\t" $0 }
         function order(stem) { return index("tipos escena operaciones puntos interseccion promocion tablas malla iluminacion luz distribuida haces proyeccion distancias instancias solidos auditoria historia", stem) + 100 }' |
    LC_ALL=C sort | cut -f3
}
table >"$tmp/table"
{
  sed '/<!-- specified:begin -->/q' spec/README.md
  cat "$tmp/table"
  sed -n '/<!-- specified:end -->/,$p' spec/README.md
} >"$tmp/README.md"
if [ "${1-}" = --write ]; then
  cp "$tmp/README.md" spec/README.md
elif ! cmp -s "$tmp/README.md" spec/README.md; then
  echo 'spec/README.md: its table of what is specified is stale; sh tests/lint/specified.sh --write puts it right'
  exit 1
fi
