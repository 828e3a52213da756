# Solids at the command line: first points, the way out, starts on the surface, edits, POV-Ray and back, and the commands
# that know shapes alone.
. "$(dirname "$0")/harness.sh"
cat >lens.json <<'SCENE'
{"format":"durero-scene","version":1,"camera":{"eye":[0,0,-9],"look_at":[0,0,0],"up":[0,1,0],"fov_y":40},"elementos":[
{"id":"back","tipo":"plano","centro":[0,0,20],"vector":[0,0,1]},
{"id":"lens","tipo":"interseccion","de":[{"tipo":"esfera","centro":[0,0,-3],"radio":5},{"tipo":"esfera","centro":[0,0,3],"radio":5}]}]}
SCENE
cat >rays.txt <<'RAYS'
0 0 -9   0 0 1
0 0 0    0 0 1
0 0 2    0 0 1   @lens
0 0 2    0 0 -1  @lens
0 4 -9   0 0 1
0 5 -9   0 0 1
RAYS
run 0 trace lens.json rays.txt -o hits.jsonl
cat >expected.jsonl <<'HITS'
{"ray":0,"outcome":"hit","elementos":["lens"],"t":7,"point":[0,0,-2]}
{"ray":1,"outcome":"hit","elementos":["lens"],"t":2,"point":[0,0,2]}
{"ray":2,"outcome":"hit","elementos":["back"],"t":18,"point":[0,0,20]}
{"ray":3,"outcome":"hit","elementos":["lens"],"t":4,"point":[0,0,-2]}
{"ray":4,"outcome":"hit","elementos":["lens"],"t":9,"point":[0,4,0]}
{"ray":5,"outcome":"hit","elementos":["back"],"t":29,"point":[0,5,20]}
HITS
same hits.jsonl expected.jsonl
for engine in exact bvh fast; do
  run 0 trace lens.json rays.txt --engine $engine -o $engine.jsonl
  same $engine.jsonl expected.jsonl
done
run 0 check lens.json

run 0 edit lens.json --op 'Agregar_Esfera e?=b centro?=(0,0,0) radio?=1' --op 'Agregar_Diferencia e?=rest de?=lens,b' -o more.json
run 0 trace more.json rays.txt -o more.jsonl
has more.jsonl '{"ray":1,"outcome":"hit","elementos":["b","rest"],"t":1,"point":[0,0,1]}'
run 1 edit more.json --op 'Agregar_Union e?=rest de?=b,lens'
run 2 edit more.json --op 'Agregar_Union e?=u de?=b'

# POV-Ray has solids, and what comes back of them is met where they were.
grep -v @ rays.txt >plain.txt
run 0 trace more.json plain.txt -o more.jsonl
run 0 export more.json -o more.pov
has more.pov 'difference { intersection { sphere { <0, 0, -3>, 5 } sphere { <0, 0, 3>, 5 } } sphere { <0, 0, 0>, 1 } }'
run 0 import more.pov -o back.json
run 0 trace back.json plain.txt -o back.jsonl
for file in more back; do sed 's/"elementos":\[[^]]*\]//' $file.jsonl >$file.met; done
same more.met back.met

# What knows shapes alone says so.
refused 'lens.json:3:' distance lens.json rays.txt
run 0 export lens.json -o lens.nff
has err '1 instance or solid left out: NFF has none'
finish
