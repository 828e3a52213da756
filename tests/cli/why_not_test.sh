# durero edit --why-not: every clause that does not hold, by the contracts, by the text of spec/ and by a text of --with.
surfaces=$(cd "$(dirname "$0")/../../demo/surfaces" && pwd)
. "$(dirname "$0")/harness.sh"
sample >scene.json
wrong='Agregar_Cilindro e?=s1 centro?=(0,0,0) radio?=-1 vector?=(0,2,0) altura?=1'

# All of them, in the order of the text; the exit status says whether some operation would be refused.
for by in --quiet --by-spec; do
  run 1 edit scene.json --why-not "$wrong" --why-not 'Eliminar_Cono e?=k1' $by
  is out '{"line":1,"ok":false,"r":"elemento_ya_existe","broken":[{"label":"Agregar_Elemento.pre.1","predicate":"e? ∉ elementos","values":{"e?":"s1"}},{"label":"Agregar_Cilindro.pre.2","predicate":"radio? ∈ Rmas","values":{"radio?":-1}},{"label":"Agregar_Cilindro.pre.3","predicate":"vector? ∈ Unitario","values":{"vector?":[0,2,0]}}]}
{"line":2,"ok":true,"r":"cono_eliminado","broken":[]}'
  run 0 edit scene.json --why-not 'Eliminar_Cono e?=k1' --why-not 'Eliminar_Cono e?=k1' $by
  lines out 2
done

# Of a text's own types the first predicate alone is told, and it says so; the program's clauses come before.
torus="$surfaces/torus.json" text="$surfaces/torus.tex"
run 1 edit "$torus" --with "$text" --why-not 'Agregar_Toro e?=fat centro?=(0,0,0) mayor?=1 menor?=2'
is out '{"line":1,"ok":false,"r":"not_in_domain","broken":[{"label":"puntos_toro.dom","predicate":"menor < mayor","values":{"mayor":1,"menor":2}}],"whole":false}'
run 1 edit "$torus" --with "$text" --why-not 'Agregar_Toro e?=ring centro?=(0,0,0) mayor?=1 menor?=2'
has out '"label":"Agregar_Elemento.pre.1"'
has out '"whole":false'
run 1 edit "$torus" --with "$text" --why-not 'Eliminar_Esfera e?=ring'
has out '"label":"Eliminar_Esfera.pre.1"'
run 0 edit "$torus" --with "$text" --why-not 'Eliminar_Toro e?=ring'
is out '{"line":1,"ok":true,"r":"elemento_eliminado","broken":[]}'

# Nothing is carried out, so nothing else is asked for.
refused '--why-not:1:1: unknown operation "Mover"; ' edit scene.json --why-not 'Mover e=s1'
refused 'edit: --op excludes --why-not; ' edit scene.json --why-not "$wrong" --op "$wrong"
refused 'edit: --output excludes --why-not; ' edit scene.json --why-not "$wrong" -o out.json
absent out.json
finish
