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
run 0 import tent.obj -o tent.json --triangles single
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

# No more findings of a kind than --most, and the others counted; the exit status and the picture are as without it.
run 1 check --mesh tent.obj
findings=$(grep -c '^abiertas: ' out)
[ "$findings" -gt 2 ] || fail "tent.obj has $findings open edges, expected more than 2"
run 1 check --mesh tent.obj --most 2
[ "$(grep -c '^abiertas: tent' out)" = 2 ] || fail 'expected two open edges of tent.obj'
has out "abiertas: $((findings - 2)) more"
run 1 check --mesh tent.obj --most 2 --format json
has out '"unlisted":{"abiertas":'
run 2 check --mesh tent.obj --most 0
run 2 check mended.json --most 1
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3\nf 4 5 6\n' >apart.obj
run 1 check --mesh apart.obj
has out 'piece of apart.obj:2: 1 triangle, volume none'
run 1 check --mesh apart.obj --most 1
has out 'pieces: 1 more'

# The picture of the findings: white, grey, red and yellow are in it, and of a mesh without findings neither of the last.
run 1 check --mesh tent.obj --picture tent.png
has out 'uniones_en_t: '
run 0 check --mesh mended.json --picture mended.png
[ "$(wc -c <tent.png)" -gt "$(wc -c <mended.png)" ] || fail 'tent.png is no larger than mended.png, expected marks in it'
for name in tent mended; do
  [ "$(head -c 24 $name.png | od -An -tx1 -j16 -N8 | tr -d ' ')" = 0000064000000320 ] || fail "$name.png is not of 1600 x 800"
done
refused 'findings.jpg: ".jpg" is no ending of a picture; expected a name that ends in .png' check --mesh tent.obj --picture findings.jpg
absent findings.jpg
printf '{"format":"durero-scene","version":1,"elementos":[]}' >empty.json
refused 'empty.json: there is no triangle; expected some to draw' check --mesh empty.json --picture empty.png
absent empty.png
printf 'v 0 0 0\nv 1e300 0 0\nv 0 1e300 0\nf 1 2 3\n' >large.obj
refused 'large.obj: half of the diagonal of its box is 7.07' check --mesh large.obj --picture large.png
absent large.png
run 2 check mended.json --picture mended.png
finish
