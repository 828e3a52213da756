# Every kind of malformed scene, given to every command: one line with its place, status 2, no output file.
. "$(dirname "$0")/harness.sh"
echo '0 0 0 0 0 1' >rays
echo kept >old

# malformed PLACE-AND-TEXT: bad.json is refused so, by every command. (Not through a pipe: that would count in a subshell.)
malformed() {
  refused "bad.json:$1" check bad.json
  for out in new.json old; do
    refused "bad.json:$1" edit bad.json --op 'Eliminar_Elemento e=a' -o $out
    refused "bad.json:$1" trace bad.json rays -o $out
  done
  refused "bad.json:$1" render bad.json -o new.png
  refused "bad.json:$1" export bad.json -o new.nff
  absent new.json
  absent new.png
  absent new.nff
  [ "$(cat old)" = kept ] || fail "$1: the old file was changed"
  case $(ls -A | tr '\n' ' ') in 'bad.json err old out rays ') ;; *) fail "$1: a file was left: $(ls -A)" ;; esac
}
head='{"format":"durero-scene","version":1,'
sphere='{"id":"a","tipo":"esfera","centro":[0,0,0],"radio":1}'

: >bad.json
malformed '1:1: the text is empty'
printf '%s\n"elementos":[\n%s' "$head" "$sphere" >bad.json
malformed '3:54: the text ends'
printf '%s\n"elementos":[{"id":"a","tipo":"esfera","centro":[0,0,0],"radio":"1"}]}' "$head" >bad.json
malformed '2:65: radio (radius) is a string; expected a number'
printf '%s\n"elementos":[{"id":"a","tipo":"esfera","centro":[0,0,0]}]}' "$head" >bad.json
malformed '2:14: key "radio" (radius) is missing in an element of tipo esfera (sphere)'
printf '%s\n"elementos":[{"id":"a","tipo":"esfera","centro":[0,0,0],"radius":1}]}' "$head" >bad.json
malformed '2:57: unknown key "radius" in an element'
printf '%s\n"elementos":[\n%s,\n%s]}' "$head" "$sphere" "$sphere" >bad.json
malformed '4:7: id is "a": elemento_ya_existe (element_already_exists); expected e? ∉ elementos (Agregar_Elemento.pre.1)'
printf '%s\n"elementos":[{"id":"a","tipo":"esfera","centro":[0,NaN,0],"radio":1}]}' "$head" >bad.json
malformed '2:52: "N" stands here; expected a JSON value'
printf '%s\n"elementos":[{"id":"a","tipo":"esfera","centro":[0,1e999,0],"radio":1}]}' "$head" >bad.json
malformed '2:52: centro (center) is "1e999", beyond binary64; expected a finite number'
printf '%s\n"elementos":[{"id":"a","tipo":"cono","centro":[0,0,0],"proporcion":1,"vector":[0,1,1],"altura":1}]}' "$head" >bad.json
malformed '2:79: vector is (0, 1, 1); expected a unit vector, 1 − tolerancia_unidad ≤ '
printf '%s\n"elementos":[{"id":"a","tipo":"esfera","centro":[0,0,0],"radio":0}]}' "$head" >bad.json
malformed '2:65: radio (radius) is 0; expected r > 0 (Rmas.inv.1)'
printf '%s\n"elementos":[{"id":"ñ","tipo":"esfera","centro":[0,0,0],"radio":-1}]}' "$head" >bad.json
malformed '2:20: id is "ñ"; expected 1 to 128 of A-Z a-z 0-9 _ . : -'
printf '%s\n"materials":{"ñ\377":{"color":[0,0,0]}},"elementos":[]}' "$head" >bad.json
malformed '2:16: "\xff" stands here inside a string; expected UTF-8'
printf '\357\273\277%s\n"elementos":[]}' "$head" >bad.json
malformed '1:1: a byte order mark'
printf '%s"elementos":[]}\n]' "$head" >bad.json
malformed '2:1: "]" stands here after the value'
{ printf '%s\n"elementos":' "$head"; head -c 1000000 /dev/zero | tr '\000' '['; } >bad.json
malformed '2:1000013: the text ends'
{
  printf '%s\n"elementos":' "$head"
  head -c 1000000 /dev/zero | tr '\000' '['
  head -c 1000000 /dev/zero | tr '\000' ']'
  echo '}'
} >bad.json
malformed '2:14: an element is an array; expected an object'
finish
