# durero spec: check, eval, show, confirm; durero edit --by-spec.
. "$(dirname "$0")/harness.sh"
sample >scene.json

# check: the program's own text, files, and what is wrong in them.
run 0 spec check
has out 'spec/interseccion.tex: section interseccion ok'
lines out 5
cat >good.tex <<'TEX'
\begin{zed}
  [ Cosa ]
\end{zed}
\begin{schema}{Par}
  a, b : Cosa
\where
  a \neq b
\end{schema}
TEX
run 0 spec check good.tex
has out 'good.tex: section Specification ok, 2 paragraphs'
sed 's/a \\neq b/a = 1/' good.tex >bad.tex
run 1 spec check bad.tex
has out 'bad.tex:7:3: '
refused 'nowhere.tex: ' spec check nowhere.tex
echo 'Prose alone.' >prose.tex
run 1 spec check prose.tex
has out 'prose.tex:1:1: no Z paragraph; expected '

# eval: values, truth, both mark-ups, the scene, and what is not decided.
run 0 spec eval '1 + 2 * 3'
is out 7
run 0 spec eval -- '-(2)'
is out -2
run 0 spec eval 'raizcuadrada(2)'
is out '√2'
run 0 spec eval '\{ 1, 2 \} \cup \{ 3 \}'
is out '{1, 2, 3}'
run 0 spec eval '∀ x : 1‥9 • x * x ≤ 81'
is out true
run 1 spec eval '0 ∈ Rmas'
is out false
run 1 spec eval '{1 ↦ 2}(3)'
is out undefined
run 0 spec eval 'elementos' --scene scene.json
is out '{c1, k1, s1}'
run 0 spec eval 'mi\_radio' --scene scene.json
is out '{c1 ↦ 1, s1 ↦ 1}'
run 0 spec eval '∀ e : elementos • de_que_tipo(e) = soy_cono ⇒ e = k1' --scene scene.json
is out true
run 0 spec eval 'de_que_elemento(θ Escena, ⦉x == 1, y == 0, z == 0⦊)' --scene scene.json
is out '{s1}'
run 0 spec eval '⦉x == 2, y == 0, z == 4⦊ ∈ puntos_de_rayo(⦉p == ⦉x == 0, y == 0, z == 0⦊, v == ⦉x == 1, y == 0, z == 2⦊⦊)'
is out true
run 0 spec eval '[x : 1‥2] ∨ [x : 3‥3]'
is out '{⦉x == 1⦊, ⦉x == 2⦊, ⦉x == 3⦊}'
run 1 spec eval 'let x == 3 • x = 4'
is out false
refused 'EXPR:1:1: the character # means nothing here; expected \#' spec eval '#\{1\}'
refused 'EXPR:1:1: the generic actuals of {} are not determined; expected ∅' spec eval '{}'
refused 'EXPR:1:1: this is not decided: a variable ranges over a set that is not finite' spec eval '∀ x : ℕ • x ≥ 0'
refused 'EXPR:1:4: ' spec eval '1 +'
refused 'EXPR:1:1: ' spec eval '1 ∈ 2'
refused 'EXPR:1:1: nadie is not declared' spec eval nadie
refused 'EXPR:1:1: this is not decided' spec eval '∃ x : ℝ • x * x = 2'
refused 'EXPR:1:1: this is not decided' spec eval 'puntos_esfera(⦉x == 1, y == 0, z == 0⦊, 1) = ∅'

# show: the paragraph, its labels and their places.
run 0 spec show Escena
has out '│ elementos = dom de_que_tipo  % Escena.inv.1'
has out 'clause    include/durero/model/escena.hpp:'
has out 'theorem   proofs/Escena.v:'
has out 'test      tests/model/'
run 0 spec show reduccion.def.2
has out 'reduccion.def.2'
has out 'text      spec/interseccion.tex:'
run 0 spec show 'mi\_radio'
has out '│ mi_radio : Elemento ⇸ Rmas'
run 0 spec show '\real'
has out '│ ℝ : ℙ 𝔸'
run 0 spec show ΞEscena
has out "ΞEscena == [Escena; Escena' | θ Escena = θ Escena']"
has out 'Escena.inv.1'
refused 'NAME:1:1: the text declares no nadie; expected' spec show nadie
refused 'NAME:1:1: the text declares no Δnadie; expected' spec show Δnadie

# confirm: right hits, then hits that are wrong in each way.
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
lines out 6
[ "$(grep -c '"confirmed":true' out)" = 6 ] || fail 'a right hit is not confirmed'
wrong() { # wrong RAY FROM TO WHY
  sed "$(($1 + 1))s/$2/$3/" hits >wrong
  cmp -s hits wrong && fail "nothing is wrong in ray $1"
  run 1 spec confirm scene.json rays wrong
  has out "{\"ray\":$1,\"confirmed\":false,\"predicate\":\"$4"
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

# confirm: a tie names both elements; t and each coordinate to the last bit.
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

# edit --by-spec: the text decides the same.
cat >operations <<'OPERATIONS'
Agregar_Esfera e=s2 centro=(0,0,5) radio=1
Agregar_Esfera e=s2 centro=(0,0,5) radio=1
Agregar_Elemento e=x t=soy_cono centro=(0,0,5) vector=(0,0,1) altura=1 proporcion=0
Agregar_Elemento e=x t=soy_esfera centro=(0,0,5) radio=1
Eliminar_Cono e=c1
Eliminar_Elemento e=c1
Eliminar_Elemento e=nadie
Agregar_Cilindro e=q centro=(0,0,0) radio=1 vector=(0,0,2) altura=-1
OPERATIONS
run 1 edit scene.json --script operations
cp out without
run 1 edit scene.json --script operations --by-spec
same out without
finish
