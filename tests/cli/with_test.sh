# durero trace, render, check, edit and agree --with: what a Z text says of the elements, the bytes of the program's own
# formulas where it has them, and the refusals.
support=$(cd "$(dirname "$0")/../support" && pwd)
surfaces=$(cd "$(dirname "$0")/../../demo/surfaces" && pwd) spec=$(cd "$(dirname "$0")/../../spec" && pwd)
. "$(dirname "$0")/harness.sh"
sample >scene.json
cat >rays.txt <<'RAYS'
0 0 -5   0 0 1
3 1 -5   0 0 1
-3 0.5 -5   0.01 0 1
0 0 -1   0 0 1   @s1
9 9 9   1 1 1
3 0 -1   0 1 0   @c1
RAYS

# The text of spec/ gives the same bytes, of hits and of a picture.
run 0 trace scene.json rays.txt -o own.jsonl
run 0 trace scene.json rays.txt --with "$spec/puntos.tex" -o text.jsonl
same own.jsonl text.jsonl
lines text.jsonl 6
run 0 render scene.json -o own.png
run 0 render scene.json -o text.png --with "$spec/puntos.tex" --threads 3
# The files differ in the call that they hold; the pixels are the same.
for picture in own text; do
  PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$support python3 -c \
    'import png, sys; print(png.png_pixels(open(sys.argv[1], "rb").read()))' $picture.png >$picture.pixels
done
same own.pixels text.pixels

# A torus of the radii 2 and 0.75.
run 0 trace "$surfaces/torus.json" "$surfaces/rays.txt" --with "$surfaces/torus.tex"
has out '{"ray":0,"outcome":"hit","elementos":["ring"],"t":2.25,"point":[-2.75,0,0]}'
lines out 5
echo '-2.75 0 0 1 0 0 @ring' >start.txt
run 0 trace "$surfaces/torus.json" start.txt --with "$surfaces/torus.tex"
has out '"elementos":["ring"],"t":1.5,"point":[-1.25,0,0]}'
run 0 render "$surfaces/torus.json" -o torus.png --with "$surfaces/torus.tex" --size 24x15
for threads in 1 3; do
  run 0 render "$surfaces/torus.json" -o again.png --with "$surfaces/torus.tex" --size 24x15 --threads $threads
  same torus.png again.png
done

# Without the text there is no such type, and with it an element has the attributes of its type, which satisfy it.
refused "$surfaces/torus.json:9:21: tipo (type) is \"toro\"; expected one of esfera (sphere)," trace "$surfaces/torus.json" rays.txt
toro() { printf '{"format":"durero-scene","version":1,"elementos":[\n{"id":"t","tipo":"toro",%s}]}\n' "$1" >bad.json; }
bad() {
  toro "$1"
  refused "bad.json:$2" trace bad.json rays.txt --with "$surfaces/torus.tex"
  refused "bad.json:$2" render bad.json -o bad.png --with "$surfaces/torus.tex"
  refused "bad.json:$2" check bad.json --with "$surfaces/torus.tex"
  absent bad.png
}
bad '"centro":[0,0,0],"mayor":2' '2:1: key "menor" is missing in an element of tipo toro; '
bad '"centro":[0,0,0],"mayor":2,"menor":1,"radio":1' '2:62: unknown key "radio" in an element of tipo toro; '
bad '"centro":[0,0],"mayor":2,"menor":1' '2:34: centro (center) has 2 items; '
bad '"centro":[0,0,0],"mayor":2,"menor":-1' '2:60: t is not in the domain of puntos_toro; expected menor ∈ Rmas'
bad '"centro":[0,0,0],"mayor":2,"menor":3' '2:1: t is not in the domain of puntos_toro; expected menor < mayor'

run 2 check bad.json --with "$surfaces/torus.tex" --format json
has out '"message":"t is not in the domain of puntos_toro; expected menor < mayor","pointer":"/elementos/0","line":2'
run 0 check "$surfaces/torus.json" --with "$surfaces/torus.tex"
has out 'torus.json: 3 elementos: 1 esfera, 0 cilindro, 0 cono, 0 tronco, 1 plano, 0 disco, 0 triangulo, 1 toro'
has out 'Escena.inv.1 ok'
run 0 check "$surfaces/torus.json" --with "$surfaces/torus.tex" --format json
has out '"triangulo":0,"toro":1}'
refused "$surfaces/torus.json:9:21: tipo (type) is \"toro\"; " check "$surfaces/torus.json"

# Edits: the text has the last word, and what is written is read again.
small='Agregar_Toro e?=small centro?=(0,2,0) mayor?=1 menor?=0.25'
run 0 edit "$surfaces/torus.json" --with "$surfaces/torus.tex" --op "$small" -o edited.json
is out '{"line":1,"ok":true,"r":"elemento_agregado"}'
has edited.json '{"id":"small","tipo":"toro","centro":[0,2,0],"mayor":1,"menor":0.25}'
run 0 check edited.json --with "$surfaces/torus.tex"
has out ' 2 toro'
echo '0 2 0 1 0 0' >inside.txt
run 0 trace edited.json inside.txt --with "$surfaces/torus.tex"
has out '"elementos":["small"],"t":0.75,'
run 1 edit edited.json --with "$surfaces/torus.tex" --op 'Agregar_Toro e?=fat centro?=(0,0,0) mayor?=1 menor?=2' \
  --op 'Eliminar_Esfera e?=small' --op 'Eliminar_Toro e?=small' -o again.json
is out '{"line":1,"ok":false,"r":"not_in_domain","violated":"puntos_toro.dom","predicate":"menor < mayor"}
{"line":2,"ok":false,"r":"tipo_incorrecto","violated":"Eliminar_Esfera.pre.1","predicate":"de_que_tipo(e?) = soy_esfera"}
{"line":3,"ok":true,"r":"elemento_eliminado"}'
grep -q small again.json && fail 'small is still there'
refused '--op:1:1: unknown operation "Agregar_Toro"; ' edit scene.json --op "$small"
refused '--op:1:1: Agregar_Toro lacks menor?; ' edit "$surfaces/torus.json" --with "$surfaces/torus.tex" \
  --op 'Agregar_Toro e?=a centro?=(0,0,0) mayor?=1' -o unfinished.json
absent unfinished.json
refused 'edit: --by-spec excludes --with; ' edit scene.json --with "$spec/puntos.tex" --by-spec --op 'Eliminar_Elemento e=s1'

# The text of spec/ agrees with points that know no equation; the printed one, whose cylinder has the radius √radio, not.
run 0 agree scene.json --rays 300 --with "$spec/puntos.tex"
has out 'unexplained: 0'
run 1 agree "$spec/impresa/dibujo/E10.json" --rays 300 --with "$spec/impresa/dibujo/superficies.tex" --format json
has out 'superficies.tex","seed":1,'
refused "$surfaces/torus.json:9:1: ring is of the type toro; expected one that the program has samples of" \
  agree "$surfaces/torus.json" --with "$surfaces/torus.tex"
refused 'agree: --engine excludes --with; ' agree scene.json --with "$spec/puntos.tex" --engine exact

# A union: a can with its lids, from within and from its own lid.
cat >can.tex <<'TEX'
\begin{zsection}
  \SECTION lata \parents puntos
\end{zsection}
\begin{axdef}
  puntos\_lata : Punto \cross Rmas \cross Unitario \cross Rmas \fun \power Punto
\where
  \forall centro : Punto; radio : Rmas; vector : Unitario; altura : Rmas @ \\
  \t1 puntos\_lata(centro, radio, vector, altura) = \\
  \t1 (\LET cima == \lblot x == centro.x + altura * vector.x, y == centro.y + altura * vector.y, \\
  \t2 z == centro.z + altura * vector.z \rblot @ \\
  \t1 puntos\_cilindro(centro, radio, vector, altura) \cup \\
  \t2 puntos\_disco(centro, radio, vector) \cup puntos\_disco(cima, radio, vector))
\end{axdef}
TEX
echo '{"format":"durero-scene","version":1,"elementos":[
{"id":"can","tipo":"lata","centro":[0,0,0],"radio":1,"vector":[0,0,1],"altura":2}]}' >can.json
printf '0 0 1 0 0 1\n0 0 -3 0 0 1\n0 0 0 0 0 1 @can\n0 0 0 1 0 1 @can\n1 0 1 1 0 0 @can\n' >can.txt
run 0 trace can.json can.txt --with can.tex
has out '{"ray":0,"outcome":"hit","elementos":["can"],"t":1,"point":[0,0,2]}'
has out '{"ray":1,"outcome":"hit","elementos":["can"],"t":3,"point":[0,0,0]}'
has out '{"ray":2,"outcome":"hit","elementos":["can"],"t":2,"point":[0,0,2]}'
has out '{"ray":3,"outcome":"hit","elementos":["can"],"t":1,"point":[1,0,1]}'
has out '{"ray":4,"outcome":"miss"'

# What is wrong with the text has a place in it.
refused 'none.tex: cannot be read' trace scene.json rays.txt --with none.tex
printf '\\begin{zed}\n  uno == 1\n\\end{zed}\n' >none.tex
refused 'none.tex:1:1: no section of it declares points' trace scene.json rays.txt --with none.tex
printf '\\begin{zed}\n  uno == dos\n\\end{zed}\n' >none.tex
refused 'none.tex:2:10: dos is not declared; ' render scene.json -o bad.png --with none.tex
cat >root.tex <<'TEX'
\begin{zsection}
  \SECTION raiz \parents puntos
\end{zsection}
\begin{axdef}
  puntos\_bola : Punto \fun \power Punto
\where
  \forall c : Punto @ puntos\_bola(c) =
    \{~ w : Punto | raizcuadrada(w.x) = 1 ~\}
\end{axdef}
TEX
echo '{"format":"durero-scene","version":1,"elementos":[{"id":"b","tipo":"bola","c":[0,0,0]}]}' >bola.json
refused 'root.tex:8:21: raizcuadrada is defined by no equation that gives its value; ' \
  trace bola.json rays.txt --with root.tex
refused 'trace: --engine excludes --with; ' trace scene.json rays.txt --with "$spec/puntos.tex" --engine fast
refused 'render: --hierarchy excludes --with; ' render scene.json -o bad.png --with "$spec/puntos.tex" --hierarchy hand
absent bad.png
# POV-Ray's tori and polynomials come in with a text that declares them.
run 0 import "$surfaces/rings.pov" -o rings.json --with "$surfaces/algebraic.tex"
empty err
run 0 check rings.json --with "$surfaces/algebraic.tex"
has out ' 1 cuartica, 1 interseccion, 6 toro_oblicuo'
printf '0 0.9 -9 0 0 1\n-2.4 0.3 -9 0 0 1\n0 0.1 -9 0 0 1\n0 9 0 0 -1 0\n' >rings.txt
run 0 trace rings.json rings.txt --with "$surfaces/algebraic.tex"
has out '"elementos":["a6"]'
has out '"elementos":["s1"]'
has out '"elementos":["b1"]'
run 0 render rings.json -o rings.png --size 16x10 --shadows coloured --with "$surfaces/algebraic.tex"
refused "$surfaces/torus.tex declares no toro_oblicuo as POV-Ray's surfaces need it; expected a text such as" \
  import "$surfaces/rings.pov" -o none.json --with "$surfaces/torus.tex"
absent none.json
printf 'torus { 1, 0 }\n#version 3.7;' >thin.pov
refused 'thin.pov: a1 is not in the domain of puntos_toro_oblicuo; expected menor ∈ Rmas' \
  import thin.pov -o none.json --with "$surfaces/algebraic.tex"
printf 'poly { 1.5, <1,2> }\n#version 3.7;' >thin.pov
refused 'thin.pov:1:8: a poly of degree 1.5; expected a whole number from 2 to 35' import thin.pov -o none.json
absent none.json
run 0 import "$surfaces/rings.pov" -o without.json
has err 'rings.pov: 7 surfaces left out: a scene has such by a Z text alone (--with)'

finish
