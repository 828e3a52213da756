#!/bin/sh
# surfaces.sh DURERO ROOT: the pictures of docs/surfaces.md and spec/erratas.md are what `durero render --with` draws of
# the scenes beside them, and the commands of the page run.
set -eu
durero=$1 root=$2
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
status=0

# drawn PICTURE SCENE TEXT: the picture, whole.
drawn() {
  "$durero" render "$root/$2" -o "$tmp/picture.png" --with "$root/$3"
  cmp "$tmp/picture.png" "$root/$1" || { echo "$1 is stale: ./x render $2 -o $1 --with $3"; status=1; }
}

for name in torus ellipsoid hyperboloid cubic instances; do
  drawn "docs/surfaces/$name.png" "demo/surfaces/$name.json" "demo/surfaces/$name.tex"
done
for name in E10 E11; do
  drawn "spec/impresa/dibujo/$name.png" "spec/impresa/dibujo/$name.json" spec/impresa/dibujo/superficies.tex
done

# The commands of the page: `./x COMMAND` stands for the built program.
cd "$root"
awk '/^```/ { inside = !inside; next } inside && /^\.\/x /' docs/surfaces.md >"$tmp/commands"
[ -s "$tmp/commands" ] || { echo "docs/surfaces.md has no command"; status=1; }
while IFS= read -r command; do
  (cd "$tmp" && ln -sfn "$root/demo" demo && ln -sfn "$root/spec" spec && eval "\"$durero\" ${command#./x }") \
    >"$tmp/said" 2>&1 </dev/null || { echo "$command: $(cat "$tmp/said")"; status=1; }
done <"$tmp/commands"

# The page's example of a text is the file.
awk '/^```latex/ { inside = 1; next } /^```/ { inside = 0 } inside' docs/surfaces.md >"$tmp/example"
cmp "$tmp/example" demo/surfaces/torus.tex || { echo "docs/surfaces.md has another torus"; status=1; }
exit $status
