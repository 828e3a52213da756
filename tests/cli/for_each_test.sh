# durero edit --for-each, --all-or-nothing and --dry-run: transactions.
. "$(dirname "$0")/harness.sh"
sample >scene.json
sphere='Agregar_Esfera e?=s2 centro?=(0,0,5) radio?=1'

# The first refusal ends the script, and nothing is written: to a new file, or over the scene itself.
cp scene.json own.json
for file in new.json own.json; do
  run 1 edit own.json --all-or-nothing --op "$sphere" --op 'Eliminar_Cono e?=s1' --op 'Eliminar_Esfera e?=s1' -o $file
  is out '{"line":1,"ok":true,"r":"esfera_agregada"}
{"line":2,"ok":false,"r":"tipo_incorrecto","violated":"Eliminar_Cono.pre.1","predicate":"de_que_tipo(e?) = soy_cono"}'
done
absent new.json
same own.json scene.json
run 0 edit own.json --all-or-nothing --op "$sphere" --op 'Eliminar_Esfera e?=s1' -o own.json
has own.json '"id":"s2"'
cp scene.json own.json

# A dry run answers the same and writes nothing, where something is refused too.
run 0 edit own.json --dry-run --op "$sphere" -o own.json
is out '{"line":1,"ok":true,"r":"esfera_agregada"}'
same own.json scene.json
run 1 edit own.json --dry-run --op "$sphere" --op "$sphere" -o new.json
lines out 2
absent new.json
refused 'new.pov: ' edit own.json --dry-run --op "$sphere" -o new.pov
[ "$(ls | tr '\n' ' ')" = 'err out own.json scene.json ' ] || fail 'a file too many'

# Each operation for each element of the set, ascending by name, in one transaction.
run 0 edit scene.json --for-each '{ e : elementos | e ∈ dom mi_radio ∧ mi_radio e > 0.5 }' \
  --op 'Agregar_Esfera e?={}:ball centro?={centro} radio?={radio}' --op 'Eliminar_Elemento e?={}' -o new.json
is out '{"line":1,"for":"c1","ok":true,"r":"esfera_agregada"}
{"line":2,"for":"c1","ok":true,"r":"elemento_eliminado"}
{"line":3,"for":"s1","ok":true,"r":"esfera_agregada"}
{"line":4,"for":"s1","ok":true,"r":"elemento_eliminado"}'
has new.json '{"id":"c1:ball","tipo":"esfera","centro":[3,0,0],"radio":1},'
has new.json '{"id":"s1:ball","tipo":"esfera","centro":[0,0,0],"radio":1}'
has new.json '{"id":"k1","tipo":"cono",'
lines new.json 12
rm new.json
run 0 edit scene.json --for-each 'de_que_tipo∼⦇{soy_cono}⦈' --by-spec \
  --op '{"op":"Agregar_Esfera","e":"{}:tip","centro":[0,9,0],"radio":1}' -o new.json
is out '{"line":1,"for":"k1","ok":true,"r":"esfera_agregada"}'
has new.json '"id":"k1:tip"'
rm new.json
# In LaTeX, of no element, of a name between quotation marks.
run 0 edit scene.json --for-each '\{ e : \dom mi\_vector | mi\_altura~e > 9 \}' --op 'Eliminar_Elemento e?={}' -o new.json
empty out
same new.json scene.json
rm new.json
run 0 edit scene.json --for-each '{ "k1", s1 }' --op 'Eliminar_Elemento e?={}'
lines out 2
# One refusal, and nothing is done: the second sphere has a name that the first has taken.
run 1 edit scene.json --for-each 'dom mi_radio' --op 'Agregar_Esfera e?=twice centro?={centro} radio?=1' -o new.json
lines out 2
has out '{"line":2,"for":"s1","ok":false,"r":"elemento_ya_existe",'
absent new.json

# The set and the places in braces are refused with their place.
refused '--for-each:1:20: the text ends too early; ' edit scene.json --for-each '{ e : elementos | e' --op "$sphere"
refused '--for-each:1:1: the term is of type ' edit scene.json --for-each 'mi_radio' --op "$sphere"
refused '--for-each:1:1: the term is of type a predicate; ' edit scene.json --for-each '1 = 1' --op "$sphere"
refused '--for-each:1:1: this is not decided: ' edit scene.json --for-each 'Elemento' --op "$sphere"
refused '--op:2:48: k1 has no "radio"; ' edit scene.json --for-each '{ k1 }' --op "$sphere" \
  --op 'Agregar_Esfera e?={}:q centro?={centro} radio?={radio}'
refused '--op:1:1: unknown operation "Mover"' edit scene.json --for-each '{ k1 }' --op 'Mover e={}'
refused 'edit: --for-each: it says nothing alone; ' edit scene.json --for-each 'elementos'
refused 'edit: --for-each excludes --with; ' edit scene.json --for-each 'elementos' --op "$sphere" --with x.tex
finish
