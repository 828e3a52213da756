# durero import: small scenes in other formats, each with its elements and what is left out of it (tests/corpus).
. "$(dirname "$0")/harness.sh"
corpus=$(CDPATH='' cd -- "$(dirname "$0")/../corpus" && pwd)
cp "$corpus"/*.* .
for scene in *.*; do
  case $scene in *_part.* | expected.txt | README.md) continue ;; esac
  run 0 import "$scene" -o scene.json
  sed 's/^durero: //' err >lost
  run 0 check scene.json
  { sed -n "1s/^scene.json/$scene/p" out && cat lost; } >>found.txt
done
same found.txt expected.txt
cp "$corpus"/*.* .
run 0 import . --survey  # those that belong to others, too
has out ' files are read'
finish
