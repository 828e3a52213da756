# durero diff: the script between two scenes, which edit makes the other by; patches, parts and counts; for git.
. "$(dirname "$0")/harness.sh"
sample >a.json
run 1 edit a.json --op 'Eliminar_Esfera e=s1' --op 'Agregar_Esfera e=s1 centro=(0,0,0) radio=2 material=red' \
  --op 'Agregar_Disco e=d1 centro=(0,2,0) radio=1 vector=(0,1,0)' --op 'Eliminar_Cono e=k1' --op 'group g=pair elementos=s1,d1' \
  --op 'Eliminar_Cono e=k1' -o b.json

run 1 diff a.json b.json
is out 'Eliminar_Cono e?=k1
Cambiar_Radio_Esfera e?=s1 radio?=2
Agregar_Disco e?=d1 centro?=(0,2,0) radio?=1 vector?=(0,1,0)
group g?=pair elementos?=d1,s1'
empty err
cp out script
run 0 edit a.json --script script -o made.json
same made.json b.json

run 1 diff b.json a.json
cp out script
run 0 edit b.json --script script -o made.json
run 0 edit a.json --script /dev/null -o canonical.json
same made.json canonical.json

# The same scene in other bytes.
tr -d '\n' <a.json >one-line.json
run 0 diff a.json one-line.json
empty out
for way in --json --summary; do
  run 0 diff a.json one-line.json $way
  empty out
done
run 0 diff a.json one-line.json --json-patch
is out '[]'

run 1 diff a.json b.json --summary
is out 'groups: 1 added, 0 removed, 0 changed
elementos: 1 added, 1 removed, 1 changed'
run 1 diff a.json b.json --json
is out '{"part":"/groups/pair","change":"added","to":{"elementos":["d1","s1"]}}
{"part":"/elementos/d1","change":"added","to":{"id":"d1","tipo":"disco","centro":[0,2,0],"radio":1,"vector":[0,1,0]}}
{"part":"/elementos/k1","change":"removed","from":{"id":"k1","tipo":"cono","centro":[-3,0,0],"proporcion":0.5,"vector":[0,1,0],"altura":2}}
{"part":"/elementos/s1","change":"changed","from":{"id":"s1","tipo":"esfera","centro":[0,0,0],"radio":1,"material":"red"},"to":{"id":"s1","tipo":"esfera","centro":[0,0,0],"radio":2,"material":"red"}}'

# A JSON Patch says what no operation does.
sed 's/"fov_y":45/"fov_y":50/; s/"radio":1,"vector"/"radio":2,"vector"/' a.json >wide.json
refused 'wide.json: no operation makes /camera/fov_y so; expected --json-patch, --json or --summary, which say every' \
  diff a.json wide.json
run 1 diff a.json wide.json --json-patch
is out '[
{"op":"replace","path":"/camera/fov_y","value":50},
{"op":"test","path":"/elementos/0/id","value":"c1"},
{"op":"replace","path":"/elementos/0/radio","value":2}
]'
cp out wide.patch
run 0 edit a.json --json-patch wide.patch -o made.json
empty out
run 0 diff made.json wide.json
run 0 edit a.json --json-patch wide.patch

# All of a patch, or none; the scene that it would make is checked.
run 0 edit a.json --op 'Eliminar_Cilindro e=c1' -o c.json
refused 'wide.patch:3:21: "/elementos/0/id" has another value; expected that of the test' \
  edit c.json --json-patch wide.patch -o none.json
absent none.json
echo '[{"op":"replace","path":"/elementos/2/radio","value":-1}]' >bad.patch
refused 'bad.patch:1:1: the scene is then wrong at /elementos/2/radio: radio (radius) is -1; expected r > 0 (Rmas.inv.1)' \
  edit a.json --json-patch bad.patch -o none.json
absent none.json
refused 'none.patch: ' edit a.json --json-patch none.patch
refused 'edit: ' edit a.json --json-patch wide.patch --op 'ungroup g=g'
refused 'none.stl: ' edit a.json --json-patch wide.patch -o none.stl

# A scene over itself, and pictures that stay the same files.
cp a.json own.json
run 0 edit own.json --json-patch wide.patch -o own.json
run 0 diff own.json wide.json
mkdir deeper
sed 's/"materials"/"textures":{"t":{"image":"t.png"}},"materials"/' a.json >dressed.json
echo '[]' >nothing.patch
run 0 edit dressed.json --json-patch nothing.patch -o deeper/dressed.json
has deeper/dressed.json '"image":"../t.png"'

# What git asks.
run 0 diff --git a.json a.json 0000 100644 b.json 1111 100644
has out 'diff --durero a/a.json b/a.json'
has out 'Eliminar_Cono e?=k1'
lines out 5
run 0 diff --git 'x y.json' /dev/null . . a.json 1111 100644
has out '"part":"/camera/eye","change":"added"'
run 0 diff --git a.json a.json 0 0 wide.json 0 0 new.json 'similarity index 90%'
has out '{"part":"/camera/fov_y","change":"changed","from":45,"to":50}'
run 0 diff --text one-line.json
same out canonical.json

refused 'diff: 1 arguments; expected two scenes' diff a.json
refused 'diff: 3 arguments; expected two scenes' diff a.json a.json a.json
refused 'diff: 2 arguments; expected what git passes' diff --git a.json a.json
refused 'diff: 2 arguments; expected one scene' diff --text a.json a.json
refused 'diff: ' diff a.json b.json --json --summary
: >empty.json
refused 'empty.json:1:1: ' diff empty.json a.json

finish
