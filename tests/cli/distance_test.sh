# durero distance: distances that are known, in both formats, and what is refused.
. "$(dirname "$0")/harness.sh"
cat >scene.json <<'TEXT'
{"format":"durero-scene","version":1,"elementos":[
{"id":"left","tipo":"esfera","centro":[-5,0,0],"radio":2},
{"id":"right","tipo":"esfera","centro":[5,0,0],"radio":2}]}
TEXT
cat >points <<'TEXT'
# half-way, beside the right one, inside it
0 0 0
9 0 0
5 0 0x1p0
TEXT
run 0 distance scene.json points
is out '{"point":0,"count":"many","elementos":["left","right"],"distance":3,"nearest":[-3,0,0]}
{"point":1,"count":"one","elementos":["right"],"distance":2,"nearest":[7,0,0]}
{"point":2,"count":"one","elementos":["right"],"distance":1,"nearest":[5,0,2]}'
empty err
run 0 distance scene.json points --of right -o of.jsonl --threads 1
is of.jsonl '{"point":0,"count":"one","elementos":["right"],"distance":3,"nearest":[3,0,0],"signed":3}
{"point":1,"count":"one","elementos":["right"],"distance":2,"nearest":[7,0,0],"signed":2}
{"point":2,"count":"one","elementos":["right"],"distance":1,"nearest":[5,0,2],"signed":-1}'
empty out

# In NumPy's format: a head of 64 bytes or a multiple, and 4 + 32 + 10 bytes a point.
run 0 distance scene.json points -o found.npy
has found.npy "('elementos', 'S10')"
[ $((($(wc -c <found.npy) - 3 * 46) % 64)) = 0 ] || fail 'found.npy has another size'

# An empty scene has nothing near. A tilted cylinder is answered, too.
echo '{"format":"durero-scene","version":1,"elementos":[]}' >empty.json
run 0 distance empty.json points
has out '{"point":2,"count":"none","elementos":[]}'
cat >tilted.json <<'TEXT'
{"format":"durero-scene","version":1,"elementos":[
{"id":"c","tipo":"cilindro","centro":[0,0,0],"radio":1,"vector":[0.48,0.6,0.64],"altura":4}]}
TEXT
echo '3 0 0' >one
run 0 distance tilted.json one
has out '"count":"one","elementos":["c"],"distance":1.6318'

refused '--of "middle": no such element; expected one of scene.json' distance scene.json points --of middle
echo '1 2' >short
refused 'short:1:4: the point ends after 2 numbers; expected x y z' distance scene.json short -o new.jsonl
absent new.jsonl
refused 'new.png: ' distance scene.json points -o new.png
finish
