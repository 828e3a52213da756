# durero store: each command, its answers and its exit status; what is kept is what durero edit would have written.
. "$(dirname "$0")/harness.sh"
sample >scene.json
export DURERO_AUTHOR=ann
at='--time 2026-01-31T12:00:00Z'
sphere='Agregar_Esfera e?=s2 centro?=(0,0,5) radio?=1'
second='Agregar_Esfera e?=s3 centro?=(0,0,9) radio?=1'

# init: a new file, and never another's place.
run 0 store init room.store --from scene.json $at
is out 'event 1, branch main'
refused 'room.store: is there already; expected a path of no file' store init room.store
refused 'nowhere/room.store: cannot be written: No such file' store init nowhere/room.store
echo '{' >bad.json
refused 'bad.json:2:1: ' store init other.store --from bad.json
absent other.store
[ "$(ls | tr '\n' ' ')" = 'bad.json err out room.store scene.json ' ] || fail 'a file too many'

# edit: answers as those of durero edit; refused operations are answered, and not kept.
run 1 store edit room.store --op "$sphere" --op "$sphere" --op 'Eliminar_Cono e=k1' --comment 'why not' $at
cp out answers
run 1 edit scene.json --op "$sphere" --op "$sphere" --op 'Eliminar_Cono e=k1' -o edited.json
same out answers
run 0 store export room.store -o exported.json
same exported.json edited.json
run 0 store export room.store HEAD~1 -o -
cp out before.json
run 0 edit scene.json --script /dev/null -o same.json
same before.json same.json
printf '# from a script\n%s' "$second" >script
run 0 store edit room.store --script script --op 'Eliminar_Esfera e=s3' --author bob $at
is out '{"line":2,"ok":true,"r":"esfera_agregada"}
{"line":3,"ok":true,"r":"esfera_eliminada"}'
printf '%s\nMover e=s1\n' "$second" >script
refused 'script:2:1: unknown operation "Mover"' store edit room.store --script script --group 1
refused '--op:2:1: unknown operation "Mover"' store edit room.store --op "$second" --op 'Mover e=s1'
"$durero" store edit room.store $at <<TEXT >out
$second
TEXT
is out '{"line":1,"ok":true,"r":"esfera_agregada"}'

# log and show.
run 0 store log room.store
is out '6  2026-01-31T12:00:00Z  ann  Agregar_Esfera e?=s3 centro?=(0,0,9) radio?=1  [HEAD main]
5  2026-01-31T12:00:00Z  bob  Eliminar_Esfera e=s3
4  2026-01-31T12:00:00Z  bob  Agregar_Esfera e?=s3 centro?=(0,0,9) radio?=1
3  2026-01-31T12:00:00Z  ann  Eliminar_Cono e=k1  # why not
2  2026-01-31T12:00:00Z  ann  Agregar_Esfera e?=s2 centro?=(0,0,5) radio?=1  # why not
1  2026-01-31T12:00:00Z  ann  import scene.json'
run 0 store log room.store main~2 -n 1
is out '3  2026-01-31T12:00:00Z  ann  Eliminar_Cono e=k1  # why not'
run 0 store log room.store --json -n 1
lines out 1
has out '{"event":6,"parent":5,"begins":true,"author":"ann","time":"2026-01-31T12:00:00Z","comment":"","operation":"Agregar_Esfera e?=s3 centro?=(0,0,9) radio?=1","answer":"{\"line\":1,\"ok\":true,\"r\":\"esfera_agregada\"}","hash":"'
has out '"names":["HEAD","main"]}'
run 0 store show room.store 3
for line in 'event      3' 'parent     2' 'author     ann' 'comment    why not' 'operation  Eliminar_Cono e=k1' \
  'answer     {"line":3,"ok":true,"r":"cono_eliminado"}' 'elementos  3'; do has out "$line"; done
run 0 store show room.store 1 --json
has out '"import":"scene.json"'
refused 'room.store: no revision "7"; expected the number of an event, or one of HEAD, main' store show room.store 7

# undo and redo, a transaction each.
run 0 store undo room.store
is out 'event 5, branch main'
run 0 store undo room.store
is out 'event 3, branch main'
run 0 store export room.store -o exported.json
same exported.json edited.json
run 0 store undo room.store
run 1 store undo room.store
is out 'event 1, branch main: no transaction is before it'
run 0 store redo room.store
is out 'event 3, branch main'
run 0 store redo room.store
run 0 store redo room.store
run 1 store redo room.store
is out 'event 6, branch main: no undo has left behind it'

# --all-or-nothing, --group.
run 1 store edit room.store --all-or-nothing --op 'Eliminar_Esfera e=s3' --op 'Eliminar_Esfera e=s3' --op "$second"
lines out 2
run 0 store show room.store
has out 'event      6'
run 1 store edit room.store --group 2 --op 'Eliminar_Esfera e=s3' --op 'Eliminar_Esfera e=s3' --op "$second" $at
lines out 3
run 0 store undo room.store
is out 'event 7, branch main'
run 0 store undo room.store
is out 'event 6, branch main'
refused 'store edit: ' store edit room.store --group 2 --all-or-nothing --op "$second"
run 1 store edit room.store --by-spec --audit --op 'Eliminar_Esfera e=s3' --op 'Eliminar_Esfera e=s3'
run 0 store undo room.store

# import: another scene, one step.
sed 's/"radio":1,"material"/"radio":3,"material"/' scene.json >other.json
run 0 store import room.store other.json --comment larger $at
is out 'event 10, branch main'
run 0 store export room.store -o exported.json
has exported.json '"radio":3'
run 0 store undo room.store

# Branches, tags, goto.
run 0 store branch room.store night HEAD~1
run 0 store tag room.store v1
run 0 store branch room.store
is out 'main  6
night  5'
run 0 store tag room.store
is out 'v1  6'
run 0 store goto room.store night
is out 'event 5, branch night'
run 0 store edit room.store --op 'Eliminar_Cilindro e=c1' $at
run 0 store goto room.store v1
is out 'event 6, no branch'
run 0 store log room.store --all -n 3
has out '11  2026-01-31T12:00:00Z  ann  Eliminar_Cilindro e=c1  [night]'
run 0 store goto room.store main
refused 'room.store: there is a branch night; expected a new name' store tag room.store night
refused 'room.store: HEAD is on branch main; expected' store branch room.store main --delete
refused 'room.store: there is no tag "v2"; expected a tag' store tag room.store v2 --delete
refused 'room.store: "12" is no name; expected' store tag room.store 12
run 0 store tag room.store v1 --delete
run 0 store tag room.store
empty out
refused 'store branch: --delete: it says nothing alone' store branch room.store --delete

# blame.
run 0 store blame room.store
is out 'c1  1  2026-01-31T12:00:00Z  ann
s1  1  2026-01-31T12:00:00Z  ann
s2  2  2026-01-31T12:00:00Z  ann
s3  6  2026-01-31T12:00:00Z  ann'
run 0 store blame room.store 2 --json
has out '{"e":"k1","event":1,"author":"ann","time":"2026-01-31T12:00:00Z"}'

# verify: whole, by the text too; an event that is changed is named, and what is left is salvaged.
for by in --quiet --by-spec --audit; do
  run 0 store verify room.store $by
  is out 'events 11, snapshots 2, names 2: whole'
done
cp room.store broken.store
python3 - <<'PYTHON'
import sqlite3
store = sqlite3.connect("broken.store")
store.execute("UPDATE event SET author = 'eve' WHERE number = 4")
store.commit()
PYTHON
run 1 store verify broken.store --salvage left.store
is out 'broken.store: event 4 is not as it was written
events 11, snapshots 2, names 2: 3 events are whole, 1 follow from a snapshot alone, 7 are lost
left.store: branch main stood for event 6, which is lost; it stands for event 3 of the new store
left.store: branch night stood for event 11, which is lost; it stands for event 3 of the new store'
refused 'broken.store: event 4 is not as it was written; expected a store that is whole' store export broken.store -o x.json
absent x.json
run 0 store verify left.store
run 0 store export left.store -o exported.json
same exported.json edited.json
refused 'left.store: is there already' store verify broken.store --salvage left.store

# Provenance: one line of text, a time that there is; without --author the environment's.
refused 'store edit: --comment "a\x0ab": no line of text' store edit room.store --op "$sphere" --comment 'a
b'
refused 'store edit: --time 2026-02-30T00:00:00Z: no time' store edit room.store --op "$sphere" --time 2026-02-30T00:00:00Z
unset DURERO_AUTHOR
LOGNAME=logan "$durero" store edit room.store --op 'Eliminar_Esfera e=s2' >out || fail 'an edit without an author'
run 0 store show room.store
has out 'author     logan'
grep -qE '^time       20[0-9][0-9]-[01][0-9]-[0-3][0-9]T[0-2][0-9]:[0-5][0-9]:[0-5][0-9]Z$' out || fail 'no time of now'

# Pictures that a scene names are named from the store's folder, and again from that of the exported file.
mkdir -p scenes stores away
cat >scenes/textured.json <<'JSON'
{"format":"durero-scene","version":1,
"textures":{
"wood":{"image":"wood.png"}},
"materials":{
"oak":{"color":[1,1,1],"textures":{"color":"wood"}}},
"elementos":[
{"id":"s","tipo":"esfera","centro":[0,0,0],"radio":1,"material":"oak"}
]}
JSON
run 0 store init stores/t.store --from scenes/textured.json
run 0 store export stores/t.store -o away/t.json
run 0 edit scenes/textured.json --script /dev/null -o away/edited.json
same away/t.json away/edited.json

# No store, another database, a later version.
refused 'scene.json: is no store; expected' store log scene.json
refused 'nothing.store: cannot be read: No such file' store edit nothing.store --op "$sphere"
absent nothing.store
python3 - <<'PYTHON'
import shutil, sqlite3
sqlite3.connect("foreign.store").executescript("CREATE TABLE event (number INTEGER PRIMARY KEY)")
shutil.copy("room.store", "later.store")
sqlite3.connect("later.store").executescript("PRAGMA user_version = 2")
shutil.copy("room.store", "tricky.store")
sqlite3.connect("tricky.store").executescript(
    "CREATE TRIGGER t AFTER INSERT ON event BEGIN DELETE FROM name; END")
PYTHON
refused 'foreign.store: is a database, and no store; expected' store log foreign.store
refused 'tricky.store: has other tables than a store; expected' store edit tricky.store --op "$sphere"
for command in log 'edit --op x' verify undo 'export -o x.json' blame; do
  # shellcheck disable=SC2086  # words
  set -- $command
  first=$1
  shift
  refused 'later.store: is a store of version 2; expected version 1: a later program reads it' store "$first" later.store "$@"
done
# diff and merge: two branches that changed different elements; then one that changed the same.
sample >scene.json
run 0 store init forked.store --from scene.json $at
run 0 store branch forked.store spring
run 0 store edit forked.store --op 'Cambiar_Radio_Esfera e=s1 radio=3' $at
run 0 store goto forked.store spring
run 0 store edit forked.store --op 'Eliminar_Elemento e=k1' --op "$second" $at
run 1 store diff forked.store main HEAD
is out 'Eliminar_Cono e?=k1
Cambiar_Radio_Esfera e?=s1 radio?=1
Agregar_Esfera e?=s3 centro?=(0,0,9) radio?=1'
run 0 store diff forked.store spring
empty out
run 0 store goto forked.store main
run 0 store merge forked.store spring $at
has out 'branch main'
run 0 store export forked.store -o merged.json
has merged.json '"radio":3'
has merged.json '"id":"s3"'
run 0 store log forked.store
has out 'merge spring'
run 0 store merge forked.store spring $at
run 0 store verify forked.store --by-spec
run 0 store goto forked.store spring
run 0 store edit forked.store --op 'Cambiar_Radio_Esfera e=s1 radio=5' $at
run 0 store goto forked.store main
run 1 store merge forked.store spring $at
has out '"part":"/elementos/s1","violated":"merge.pre.1"'

finish
