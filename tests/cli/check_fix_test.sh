# durero check --fix: what it proposes, carried out by edit --script, makes a scene that check accepts.
. "$(dirname "$0")/harness.sh"
sample >scene.json

# Nothing to mend.
run 0 check scene.json --fix
empty out
empty err

# A scene: operations. The file stays as it is.
sed 's/^{"id":"c1",.*/&\n{"id":"c2","tipo":"cilindro","centro":[3,0,0],"radio":1,"vector":[0,1,0],"altura":2},/' scene.json >twice.json
cp twice.json before.json
run 1 check twice.json --fix
is out '# c2 is the same as c1.
Eliminar_Elemento e?=c2'
same twice.json before.json
cp out fix
run 0 edit twice.json --script fix -o mended.json
same mended.json scene.json

# No scene: a JSON Patch, with a reason for each operation.
sed 's/"vector":\[0,1,0\],"altura":2},/"vector":[0,3,4],"altura":2},/; s/"radio":1,"material"/"radio":1.50,"material"/' scene.json >crooked.json
run 2 check crooked.json
run 1 check crooked.json --fix
is out '[
{"op":"replace","path":"/elementos/0/vector","reason":"its length is 5","value":[0,0.6,0.8]},
{"op":"replace","path":"/elementos/1/vector","reason":"its length is 5","value":[0,0.6,0.8]}
]'
empty err
cp out fix
run 0 edit crooked.json --script fix --op 'Eliminar_Cono e?=k1' -o mended.json
is out '{"line":2,"ok":true,"r":"patched"}
{"line":3,"ok":true,"r":"patched"}
{"line":5,"ok":true,"r":"cono_eliminado"}'
has mended.json '{"id":"c1","tipo":"cilindro","centro":[3,0,0],"radio":1,"vector":[0,0.6,0.8],"altura":2},'
run 0 check mended.json
run 0 check mended.json --fix

# A fault that nothing is proposed for is the error, at its place; the rest is proposed all the same.
sed 's/"radio":1.50/"radio":-1/' crooked.json >worse.json
run 2 check worse.json --fix
lines out 4
has err 'durero: worse.json:11:53: radio (radius) is -1; expected r > 0 (Rmas.inv.1)'
cp out fix
refused 'worse.json as patched:' edit worse.json --script fix -o none.json
absent none.json
# A patch of another file.
echo '[{"op":"remove","path":"/elementos/9"}]' >other
refused 'other:1:24: "/elementos/9" is not there; expected a pointer to what the document has' \
  edit scene.json --script other -o none.json
echo '[{"op":"drop","path":"/elementos/0"}]' >other
refused 'other:1:8: op is "drop"; expected one of add, remove, replace, move, copy, test' edit scene.json --script other
# The other operations of RFC 6902, and a patch of none.
echo '[{"op":"move","path":"/elementos/0","from":"/elementos/2"},
{"op":"move","path":"/elementos/-","from":"/elementos/0"}]' >other
run 0 edit scene.json --script other -o moved.json
is out '{"line":1,"ok":true,"r":"patched"}
{"line":2,"ok":true,"r":"patched"}'
same moved.json scene.json
echo '[]' >other
run 0 edit scene.json --script other -o moved.json
empty out
same moved.json scene.json
refused 'check: --mesh excludes --fix; ' check scene.json --fix --mesh
refused 'check: --format excludes --fix; ' check scene.json --fix --format json
finish
