# durero edit -i: a session from a pipe, and as a person at a terminal has it.
home=$(dirname "$0")
. "$(dirname "$0")/harness.sh"
sample >scene.json
sphere='Agregar_Esfera e?=s2 centro?=(0,0,5) radio?=1'

# session STATUS LINES ARGUMENT...: runs a session on the lines of a pipe.
session() {
  want=$1 text=$2
  shift 2
  called="durero edit -i $*"
  printf '%s\n' "$text" | "$durero" edit "$@" -i >out 2>err
  got=$?
  checks=$((checks + 1))
  [ "$got" = "$want" ] || fail "$called: status $got, expected $want"
  empty err
}

# Operations are taken back by folding the others over the first scene, with groups and all.
session 0 "group g?=pair elementos?=s1,k1
Eliminar_Esfera e?=s1
$sphere
undo
undo
show s1
redo
list
$sphere
redo
write out.json
quit" scene.json
is out "done: grouped
done: esfera_eliminada (sphere_removed), which left the group pair
done: esfera_agregada (sphere_added)
taken back: $sphere
taken back: Eliminar_Esfera e?=s1
{\"id\":\"s1\",\"tipo\":\"esfera\",\"centro\":[0,0,0],\"radio\":1,\"material\":\"red\"}  in the group pair
done again: Eliminar_Esfera e?=s1
c1
k1
2 elementos
done: esfera_agregada (sphere_added)
there is none
done: written to out.json"
# What a script makes of the same operations.
run 0 edit scene.json --op 'group g?=pair elementos?=s1,k1' --op 'Eliminar_Esfera e?=s1' --op "$sphere" -o script.json
same out.json script.json

# What is refused, why, and what is no operation; by the text too.
for by in --quiet --by-spec; do
  session 0 "Eliminar_Cono e?=s1
why-not Agregar_Esfera e?=s1 centro?=(0,0,0) radio?=-1
why-not Eliminar_Cono e?=k1
  Agregar_Esfera e?=s3 centro?=(0,0,5) radio?=uno
show nothing
# a comment

undo" scene.json $by
  is out 'refused: tipo_incorrecto (wrong_type): Eliminar_Cono.pre.1 de_que_tipo(e?) = soy_cono
refused: elemento_ya_existe (element_already_exists)
  Agregar_Elemento.pre.1  e? ∉ elementos
    e? = s1
  Agregar_Esfera.pre.2  radio? ∈ Rmas
    radio? = -1
every clause holds: cono_eliminado (cone_removed)
error: line:4:47: radio? (radius) is "uno"; expected a finite number
error: "nothing" is no element
there is none'
done

# What is not written is lost only where one knows; status 1 then.
session 1 "$sphere
quit
quit" scene.json
has out 'not all is written: write it, or quit again and lose it'
has out 'what was not written is lost'
session 1 "$sphere" scene.json
has out 'what was not written is lost'
session 0 "$sphere
undo" scene.json
session 1 "$sphere
write out.json
undo
Eliminar_Cono e?=k1" scene.json
session 0 "$sphere
quit
write out.json
quit" scene.json
# To the file of -o, and to the scene's own, which nobody else has written since.
session 0 "$sphere
write" scene.json -o named.json
has named.json '"id":"s2"'
cp scene.json own.json
session 0 "$sphere
write
Eliminar_Cono e?=k1
write" own.json
has own.json '"id":"s2"'
if grep -q '"id":"k1"' own.json; then fail 'the second write is lost'; fi
cp scene.json own.json
(echo "$sphere"; sleep 1; echo write) | "$durero" edit own.json -i >out &
sleep 0.4
"$durero" edit own.json --op 'Eliminar_Cono e?=k1' -o own.json >/dev/null
wait
called='a file that another program writes'
has out 'error: own.json: another program has written it since it was read; expected another FILE'
if grep -q '"id":"s2"' own.json; then fail 'an edit of another program is lost'; fi
session 1 "$sphere
write out.pov" scene.json
has out 'error: out.pov: '
absent out.pov

# No terminal, no view.
session 0 view scene.json
has out 'error: standard input or output is no terminal; '

# Other types, of a text.
surfaces=$(cd "$home/../../demo/surfaces" && pwd)
session 0 "Agregar_Toro e?=small centro?=(0,2,0) mayor?=1 menor?=0.25
why-not Agregar_Toro e?=fat centro?=(0,0,0) mayor?=1 menor?=2
write torus.json" "$surfaces/torus.json" --with "$surfaces/torus.tex"
has out '    mayor = 1'
has out '  perhaps others: the text tells the first alone'
has torus.json '"id":"small"'

refused 'edit: --op excludes --interactive; ' edit scene.json -i --op "$sphere"
checks=$((checks + 1))
PYTHONDONTWRITEBYTECODE=1 python3 "$home/edit_session.py" "$durero" >err 2>&1 || fail edit_session.py
finish
