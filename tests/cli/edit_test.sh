# durero edit: answers, exit status, and the file that it writes.
. "$(dirname "$0")/harness.sh"
sample >scene.json
sphere='Agregar_Esfera e?=s2 centro?=(0,0,5) radio?=1'
added='{"line":1,"ok":true,"r":"esfera_agregada"}'
refusal='"ok":false,"r":"elemento_ya_existe","violated":"Agregar_Elemento.pre.1","predicate":"e? ∉ elementos"}'

# Accepted: status 0; the file holds the element; without -o nothing is written.
run 0 edit scene.json --op "$sphere" -o out.json
is out "$added"
empty err
has out.json '{"id":"s2","tipo":"esfera","centro":[0,0,5],"radio":1}'
run 0 edit scene.json --op "$sphere"
is out "$added"
[ "$(ls | tr '\n' ' ')" = 'err out out.json scene.json ' ] || fail 'a file too many'

# Without operations the file is the canonical text.
: >none
run 0 edit scene.json --script none -o same.json
same scene.json same.json
empty out

# Refused: status 1, and what was accepted is kept.
cat >script <<'TEXT'
# three operations
Agregar_Esfera e?=s2 centro?=(0,0,5) radio?=1 material?=red

{"op":"Agregar_Esfera","e":"s1","centro":[0,0,5],"radio":1}
Eliminar_Cono e=k1
TEXT
run 1 edit scene.json --script script -o out.json
is out '{"line":2,"ok":true,"r":"esfera_agregada"}
{"line":4,'"$refusal"'
{"line":5,"ok":true,"r":"cono_eliminado"}'
has out.json '"radio":1,"material":"red"}'
run 0 check out.json
has out '3 elementos: 2 esfera, 1 cilindro, 0 cono, 0 tronco, 0 plano, 0 disco, 0 triangulo'

# Whoever removes an element from a group and adds it again is told so in both answers, and by the Z text too.
for by in --quiet --by-spec; do
  run 0 edit scene.json --op 'group g=pair elementos=s1,k1' --op 'Eliminar_Esfera e=s1' \
    --op 'Agregar_Esfera e=s1 centro=(0,0,5) radio=1' --op 'Eliminar_Cono e=k1' $by
  is out '{"line":1,"ok":true,"r":"grouped"}
{"line":2,"ok":true,"r":"esfera_eliminada","left_group":"pair"}
{"line":3,"ok":true,"r":"esfera_agregada","left_group":"pair"}
{"line":4,"ok":true,"r":"cono_eliminado","left_group":"pair"}'
done

# A change of an attribute, of looks and of a group, by the Z text too.
for by in --quiet --by-spec; do
  run 1 edit scene.json --op 'group g=pair elementos=s1' --op 'Cambiar_Radio_Esfera e=s1 radio=3' \
    --op 'Cambiar_Radio_Esfera e=k1 radio=3' --op 'Cambiar_Altura e=k1 altura=0' --op 'Cambiar_Material e=s1 material=none' \
    --op 'Cambiar_Grupo e=k1 g=pair' --op 'Quitar_Grupo e=s1' $by -o changed.json
  is out '{"line":1,"ok":true,"r":"grouped"}
{"line":2,"ok":true,"r":"elemento_cambiado"}
{"line":3,"ok":false,"r":"tipo_incorrecto","violated":"Es_Esfera.pre.1","predicate":"e? ↦ soy_esfera ∈ de_que_tipo"}
{"line":4,"ok":false,"r":"altura_no_positiva","violated":"Cambiar_Altura.pre.2","predicate":"altura? ∈ Rmas"}
{"line":5,"ok":false,"r":"material_no_existe","violated":"Cambiar_Material.pre.2","predicate":"material? ∈ materiales"}
{"line":6,"ok":true,"r":"elemento_cambiado"}
{"line":7,"ok":true,"r":"elemento_cambiado"}'
  has changed.json '"radio":3'
  has changed.json '"pair":{"elementos":["k1"]}}'
done
# A face of a mesh is not edited alone, and the text knows that it is one.
echo '{"format":"durero-scene","version":1,"elementos":[],"mallas":[{"id":"m","puntos":[[0,0,0],[1,0,0],[0,1,0]],"caras":[[0,1,2]]}]}' >mesh.json
run 1 edit mesh.json --by-spec --op 'Eliminar_Triangulo e=m:0' --op 'Cambiar_Vertices e=m:0 vertices=((0,0,0),(1,0,0),(0,2,0))'
is out '{"line":1,"ok":false,"r":"es_de_malla","violated":"Fuera_De_Malla.pre.1","predicate":"e? ∉ de_malla(θMallas)"}
{"line":2,"ok":false,"r":"es_de_malla","violated":"Fuera_De_Malla.pre.1","predicate":"e? ∉ de_malla(θMallas)"}'

# The operations of --op follow the script's lines; each may check whole predicates.
run 1 edit scene.json --audit --script script --op 'Eliminar_Elemento e=c1' --op 'Eliminar_Elemento e=c1'
has out '{"line":6,"ok":true,"r":"elemento_eliminado"}'
has out '{"line":7,"ok":false,"r":"elemento_no_existe","violated":"Eliminar_Elemento.pre.1"'

tr '\n' '\r' <script >carriage
run 1 edit scene.json --script carriage --op 'Eliminar_Elemento e=c1'
has out '{"line":5,"ok":true,"r":"cono_eliminado"}'
has out '{"line":6,"ok":true,"r":"elemento_eliminado"}'

# The standard input, and a scene written over itself.
"$durero" edit scene.json <script >out
[ $? = 1 ] || fail 'edit from stdin'
lines out 3
cp scene.json own.json
run 0 edit own.json --op "$sphere" -o own.json
has own.json s2

# Malformed: one line with the place, no answer, and the file as it was.
cp own.json before.json
printf '%s\nAgregar_Esfera e?=s3 centro?=(0,0,5) radio?=uno\n' "$sphere" >bad
refused 'bad:2:45: radio? (radius) is "uno"' edit scene.json --script bad -o own.json
same own.json before.json
refused '--op:2:1: unknown operation "Mover"' edit scene.json --op "$sphere" --op 'Mover e=s1' -o new.json
absent new.json
refused 'nowhere/out.json: cannot be written: No such file or directory' edit scene.json --op "$sphere" -o nowhere/out.json
refused '/dev/full: cannot be written: No space left on device' edit scene.json --op "$sphere" -o /dev/full

# Both on the standard output, which may be a file.
run 0 edit scene.json --op "$sphere" -o /dev/stdout
has out '"id":"s2"'
has out "$added"
# Groups: made of what is there, kept in the file, left by what is removed; each refusal names its clause.
cat >script <<'TEXT'
group g?=pair elementos?=s1,k1
group g?=all groups?=pair
group g?=pair
group g?=more elementos?=s1
ungroup g?=none
Eliminar_Elemento e?=k1
TEXT
run 1 edit scene.json --script script -o grouped.json
has out '{"line":1,"ok":true,"r":"grouped"}'
has out '{"line":3,"ok":false,"r":"group_exists","violated":"group.pre.1","predicate":"g? ∉ dom groups"}'
has out '{"line":4,"ok":false,"r":"element_in_a_group","violated":"group.pre.4",'
has out '{"line":5,"ok":false,"r":"no_such_group","violated":"ungroup.pre.1",'
has grouped.json '"all":{"groups":["pair"]},'
has grouped.json '"pair":{"elementos":["s1"]}},'
run 0 edit grouped.json --by-spec --op 'ungroup g?=all' --op 'Eliminar_Elemento e?=s1' -o ungrouped.json
has ungrouped.json '"pair":{}},'
run 0 import grouped.json -o same.json
same grouped.json same.json
run 0 export grouped.json -o same.json
same grouped.json same.json
run 0 export grouped.json -o grouped.nff
has err '2 groups left out'
# A solid: both of its discs or none, by the text too.
run 1 edit scene.json --by-spec --op 'close e?=k1' --op 'close e?=k1' --op 'close e?=s1' -o closed.json
has out '{"line":1,"ok":true,"r":"closed"}'
has out '{"line":2,"ok":false,"r":"elemento_ya_existe","violated":"Agregar_Elemento.pre.1",'
has out '{"line":3,"ok":false,"r":"not_closed","violated":"close.pre.2",'
has closed.json '"id":"k1:base"'
# Many that edit one file at a time wait for each other: no edit is lost, also by a link.
sample >one.json
ln -s one.json link.json
for number in $(seq 24); do
  file=one.json
  [ $((number % 3)) != 0 ] || file=link.json
  "$durero" edit $file --op "Agregar_Esfera e?=m$number centro?=(0,0,$number) radio?=1" -o $file >/dev/null 2>&1 </dev/null &
done
wait
run 0 check one.json
checks=$((checks + 1))
[ "$(grep -c '"id":"m[0-9]*"' one.json)" = 24 ] || fail 'an accepted edit is lost'
finish
