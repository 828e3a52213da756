# durero check --mesh: what is found of a mesh; what mends it is carried out, and then nothing is found.
. "$(dirname "$0")/harness.sh"
cat >tent.obj <<'OBJ'
v 0 0 0
v 2 0 0
v 0 2 0
v 0 0 2
v 1 0 0
f 1 3 2
f 1 5 4
f 5 2 4
f 2 3 4
f 1 3 4
OBJ
run 1 check --mesh tent.obj
has out 'tent.obj: 5 triangles, 5 vertices, 1 piece, volume none'
has out 'discordes: '
has out 'uniones_en_t: tent.obj:1: (1,0,0) (0,0,0) (2,0,0): '
run 0 import tent.obj -o tent.json
run 1 check --mesh tent.json --format json
grep -o '"mended":\["[^]]*' out | sed 's/"mended":\["//; s/","/\n/g; s/"$//' | awk '/e\?=tent.obj:5/ && seen[$0]++ { next } 1' >mend
run 0 edit tent.json --script mend -o mended.json
run 0 check --mesh mended.json
has out 'mended.json: 6 triangles, 5 vertices, 1 piece, volume 4/3'
lines out 1
run 0 check --mesh mended.json --point 0.5,0.5,0.5
has out '(0.5,0.5,0.5): inside'
run 0 check --mesh mended.json --point 0.5,0,0.5
has out '(0.5,0,0.5): on the surface'
run 0 check --mesh mended.json --point 2,2,-1 --format json
has out '"point":{"place":[2,2,-1],"side":"outside"}'
run 1 check --mesh tent.obj --point 0.5,0.5,0.5
has out '(0.5,0.5,0.5): on no side, as the triangles bound nothing'
run 2 check --mesh tent.obj --point 1,2
has err '1,2: no point; expected X,Y,Z, three finite numbers'
run 2 check mended.json --point 1,2,3
run 1 check --mesh tent.obj --format sarif
has out '"ruleId":"uniones_en_t"'
run 2 check --mesh absent.obj
finish
