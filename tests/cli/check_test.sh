# durero check: a good scene, summed up with every invariant.
. "$(dirname "$0")/harness.sh"
sample >scene.json
run 0 check scene.json
empty err
lines out 23
has out 'scene.json: 3 elementos: 1 esfera, 1 cilindro, 1 cono, 0 tronco, 0 plano, 0 disco, 0 triangulo'
for n in 1 2 3 4 5 6 7 8 9; do has out "Escena.inv.$n ok: "; done
for n in 1 2 3 4 5 6 7 8 9 10 11 12; do has out "Material.inv.$n ok: "; done
has out 'Fuente.inv.1 ok: '
"$durero" check - <scene.json >out || fail "check -"
has out '<stdin>: 3 elementos'

# For programs: the same as JSON and as SARIF. What is wrong with a file is printed, and is an error all the same.
run 0 check scene.json --format text
lines out 23
run 0 check scene.json --format json
empty err
has out '{"format":"durero-check","version":1,"file":"scene.json","ok":true,'
has out '"elementos":{"esfera":1,"cilindro":1,"cono":1,"tronco":0,"plano":0,"disco":0,"triangulo":0}'
has out '{"label":"Escena.inv.3","predicate":"dom mi_radio = de_que_tipo ∼ ⦇ { soy_esfera, soy_cilindro, soy_tronco, soy_disco } ⦈","holds":true}'
has out '"findings":[]}'
run 0 check scene.json --format sarif
has out '"version":"2.1.0"'
has out '"results":[]}]}'
cat >wrong.json <<'JSON'
{"format":"durero-scene","version":1,"elementos":[
{"id":"a","tipo":"esfera","centro":[0,0,0],"radio":0},
{"id":"b","tipo":"cono","centro":[0,0,0],"vector":[0,1,0],"altura":1},
{"id":"b","tipo":"esfera","centro":[0,0,0],"radio":1},
{"id":"b","tipo":"esfera","centro":[0,0,0],"radio":1}]}
JSON
error='durero: wrong.json:2:52: radio (radius) is 0; expected r > 0 (Rmas.inv.1)'
refused 'wrong.json:2:52: radio (radius) is 0; expected r > 0 (Rmas.inv.1)' check wrong.json
run 2 check wrong.json --format json
is err "$error"
is out '{"format":"durero-check","version":1,"file":"wrong.json","ok":false,
"findings":[
{"label":"Rmas.inv.1","predicate":"r > 0","message":"radio (radius) is 0; expected r > 0 (Rmas.inv.1)","pointer":"/elementos/0/radio","line":2,"column":52},
{"label":"Escena.inv.6","predicate":"dom mi_proporcion = de_que_tipo ∼ ⦇ { soy_cono, soy_tronco } ⦈","message":"key \"proporcion\" (proportion) is missing in an element of tipo cono (cone); expected it","pointer":"/elementos/1","line":3,"column":1},
{"label":"Agregar_Elemento.pre.1","predicate":"e? ∉ elementos","message":"id is \"b\": elemento_ya_existe (element_already_exists); expected e? ∉ elementos (Agregar_Elemento.pre.1)","pointer":"/elementos/3/id","line":5,"column":7}]}'
run 2 check wrong.json --format sarif
is err "$error"
has out '{"ruleId":"Escena.inv.6","level":"error","message":{"text":"key \"proporcion\" (proportion) is missing'
has out '"locations":[{"physicalLocation":{"artifactLocation":{"uri":"wrong.json"},"region":{"startLine":3,"startColumn":1}},"logicalLocations":[{"fullyQualifiedName":"/elementos/1"}]}]}'
# No JSON: a finding without a pointer. No file: an error alone.
echo '{"format":' >wrong.json
run 2 check wrong.json --format json
lines err 1
has out '"findings":['
has out '"message":"the text ends; expected a JSON value: '
grep -q pointer out && fail "a pointer into what is no JSON"
run 2 check wrong.json --format sarif
has out '"ruleId":"malformed"'
refused 'absent.json: cannot be read' check absent.json --format json
refused 'check: --format yaml: no such format; expected one of text, json, sarif' check scene.json --format yaml
finish
