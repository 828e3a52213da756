# durero spec confirm: right hits are confirmed, and every way in which a file of hits can be wrong is seen.
. "$(dirname "$0")/harness.sh"
sample >scene.json

# Right hits, then hits that are wrong in each way.
cat >rays <<'RAYS'
0 0 -5 0 0 1
0 0.25 -5 0.125 0.0625 1
4 1 0 0 1 0
9 9 9 1 0 0
1 0 0 -1 0 0 @s1
4 -1 0 0 1 0
RAYS
run 0 trace scene.json rays -o hits
run 0 spec confirm scene.json rays hits
is out '{"ray":0,"confirmed":true}
{"ray":1,"confirmed":true}
{"ray":2,"confirmed":true}
{"ray":3,"confirmed":true}
{"ray":4,"confirmed":true}
{"ray":5,"confirmed":true}
{"rays":6,"confirmed":6,"refused":0,"missing":0}'
wrong() { # wrong RAY FROM TO WHY
  sed "$(($1 + 1))s/$2/$3/" hits >wrong
  cmp -s hits wrong && fail "nothing is wrong in ray $1"
  run 1 spec confirm scene.json rays wrong
  has out "{\"ray\":$1,\"confirmed\":false,\"predicate\":\"$4"
  has out '{"rays":6,"confirmed":5,"refused":1,"missing":0}'
}
wrong 0 '"t":4' '"t":4.000000000000001' 'no intersection has t and point'
wrong 0 '"t":4,"point":\[0,0,-1\]' '"t":6,"point":[0,0,1]' 'Hay_Interseccion.post.1'
wrong 0 's1' 'c1' 'Hay_Interseccion.post.3'
wrong 1 '"s1"' '"k1","s1"' 'Hay_Interseccion.post.3'
wrong 2 'c1' 'k1' 'No_Hay_Minimo.post.1'
wrong 3 'miss","elementos":\[\]' 'no_minimum","elementos":["c1"]' 'No_Hay_Minimo.pre.1'
wrong 3 'miss","elementos":\[\]' 'hit","elementos":["s1"],"t":1,"point":[10,9,9]' 'Hay_Interseccion.pre.1'
wrong 0 'hit","elementos":\["s1"\],"t":4,"point":\[0,0,-1\]' 'no_minimum","elementos":["s1"]' 'No_Hay_Minimo.pre.2'
sed '1s/.*/{"ray":0,"outcome":"miss","elementos":[]}/' hits >wrong
run 1 spec confirm scene.json rays wrong
has out '{"ray":0,"confirmed":false,"predicate":"No_Hay_Interseccion.pre.1: a point of the ray lies on s1"}'
sed '3s/.*/{"ray":2,"outcome":"miss","elementos":[]}/' hits >wrong  # a stretch without a nearest point
run 1 spec confirm scene.json rays wrong
has out '{"ray":2,"confirmed":false,"predicate":"No_Hay_Interseccion.pre.1: a point of the ray lies on c1"}'
sed '3s/.*/{"ray":2,"outcome":"hit","elementos":["c1"],"t":1,"point":[4,2,0]}/' hits >wrong
run 1 spec confirm scene.json rays wrong
has out '{"ray":2,"confirmed":false,"predicate":"Hay_Interseccion.pre.1'

# A tie names both elements; t and each coordinate to the last bit.
cat >tie.json <<'SCENE'
{"format":"durero-scene","version":1,"elementos":[{"id":"a","tipo":"esfera","centro":[0,0,0],"radio":1},
{"id":"b","tipo":"esfera","centro":[0,0,1],"radio":2}]}
SCENE
echo '0.25 0.125 -5 0 0 1
0 0 -5 0 0 3' >tie
run 0 trace tie.json tie -o hits
run 0 spec confirm tie.json tie hits
wrong_tie() { # wrong_tie RAY FROM TO WHY
  sed "$(($1 + 1))s/$2/$3/" hits >wrong
  cmp -s hits wrong && fail "nothing is wrong in ray $1"
  run 1 spec confirm tie.json tie wrong
  has out "{\"ray\":$1,\"confirmed\":false,\"predicate\":\"$4"
}
wrong_tie 1 '"a","b"' '"a"' 'Hay_Interseccion.post.3'
wrong_tie 1 '"a","b"' '"b"' 'Hay_Interseccion.post.3'
wrong_tie 1 '"t":1.3333333333333333' '"t":1.3333333333333335' 'no intersection has t and point'
wrong_tie 0 '4.019627560280642' '4.019627560280643' 'no intersection has t and point'
wrong_tie 1 '-1\]' '-0.9999999999999999]' 'no intersection has t and point'

# A farther point of another element may round to the numbers of the first one; the first one is the reduction.
cat >alike.json <<'SCENE'
{"format":"durero-scene","version":1,"elementos":[{"id":"a","tipo":"esfera","centro":[0,1e-9,5],"radio":1},
{"id":"b","tipo":"esfera","centro":[0,0,5],"radio":1}]}
SCENE
echo '0 0 0 0 0 1' >alike
run 0 trace alike.json alike -o hits
is hits '{"ray":0,"outcome":"hit","elementos":["b"],"t":4,"point":[0,0,4]}'
run 0 spec confirm alike.json alike hits
sed 's/"b"/"a"/' hits >wrong
run 1 spec confirm alike.json alike wrong
has out '{"ray":0,"confirmed":false,"predicate":"Hay_Interseccion.post.3'
sed 's/"b"/"a","b"/' hits >wrong
run 1 spec confirm alike.json alike wrong
has out '{"ray":0,"confirmed":false,"predicate":"Hay_Interseccion.post.3'

# Every bit counts: −0 is not the rounding of 0.
sed 's/\[0,0,4\]/[0,-0,4]/' hits >wrong
run 1 spec confirm alike.json alike wrong
has out '{"ray":0,"confirmed":false,"predicate":"no intersection has t and point'

# Each ray is answered once: a ray without a line is missing, in an empty file every ray; the order is free.
run 0 trace scene.json rays -o hits
: >none
run 1 spec confirm scene.json rays none
lines out 7
has out '{"ray":0,"confirmed":false,"predicate":"the ray has no hit in the file"}'
has out '{"rays":6,"confirmed":0,"refused":0,"missing":6}'
sed 4d hits >short
run 1 spec confirm scene.json rays short
has out '{"ray":3,"confirmed":false,"predicate":"the ray has no hit in the file"}'
has out '{"rays":6,"confirmed":5,"refused":0,"missing":1}'
sort -r hits >reversed
run 0 spec confirm scene.json rays reversed
has out '{"rays":6,"confirmed":6,"refused":0,"missing":0}'
{ cat hits; sed -n 2p hits; } >doubled
refused 'doubled:7:8: ray 1 has a hit already; expected one a ray' spec confirm scene.json rays doubled
sed '$s/"ray":5/"ray":6/' hits >beyond
refused 'beyond:6:8: ray 6 of 6; expected a ray of the ray file, from 0' spec confirm scene.json rays beyond

# No rays, no hits: nothing is wrong.
echo '# no ray' >no_rays
run 0 spec confirm scene.json no_rays none
is out '{"rays":0,"confirmed":0,"refused":0,"missing":0}'
finish
