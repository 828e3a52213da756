# durero spec: check, eval, show; durero edit --by-spec. (spec_confirm_test.sh has spec confirm.)
. "$(dirname "$0")/harness.sh"
sample >scene.json

# check: the program's own text, files, and what is wrong in them.
run 0 spec check --strict
has out 'spec/interseccion.tex: section interseccion ok'
run 0 spec check
has out 'spec/interseccion.tex: section interseccion ok'
has out 'conjecture Init.conj.1 proved as Init_exists; tried on 1 state'
has out 'conjecture alcances.conj.1 proved as printed_intersection_is_alcances; tried on 8 states'
has out 'conjecture Hay_Interseccion.conj.1 proved as printed_elements_are_the_answer; tried on '
has out 'spec/tablas.tex: section tablas ok'
has out 'conjecture Agregar_Tronco_Tablas.conj.2 proved as Agregar_Tronco_Tablas_correct; tried on '
has out 'conjecture raices.conj.3 proved as the_closed_form_of_a_cone_is_alcance; tried on '
lines out 335
run 0 spec check --states 0
has out 'conjecture alcances.conj.1 proved as printed_intersection_is_alcances; not tried: '
cat >claims.tex <<'TEX'
\begin{zed} [ Cosa ] \end{zed}
\begin{schema}{Par} a, b : Cosa \where a \neq b \end{schema}
\begin{zed}
  \vdash? \forall Par @ b \neq a  % Par.conj.1
\also
  \vdash? \forall n : \nat @ (\exists_1 m : \nat @ m * m > n)
\end{zed}
TEX
run 0 spec check claims.tex
has out 'claims.tex:4:3: conjecture Par.conj.1 tried on 6 states'  # three names have no more
has out 'claims.tex:6:3: conjecture not tried: '
has err 'durero: note: 1 conjecture is not tried, as said of each'
run 1 spec check --all-tried claims.tex
printf '%s\n' '\begin{zed} \vdash? \forall Par @ a = b \end{zed}' >>claims.tex
run 1 spec check claims.tex
has out 'claims.tex:8:13: conjecture is false, as in this state:'
has out '  a = Cosa_'
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
cat good.tex | "$durero" spec check /dev/stdin >out 2>err || fail 'spec check of a pipe'
has out '/dev/stdin: section Specification ok, 2 paragraphs'
sed 's/a \\neq b/a = 1/' good.tex >bad.tex
run 1 spec check bad.tex
has out 'bad.tex:7:3: '
# An operation that leaves something open is Z, and an opinion says so; --strict refuses it.
cat >loose.tex <<'TEX'
\begin{schema}{S} n : \nat \end{schema}
\begin{zed} Op == [ \Delta S | n' > n ] \end{zed}
TEX
run 0 spec check loose.tex
has out "loose.tex:2:13: opinion: Op leaves n' open; "
has out 'section Specification ok'
run 1 spec check --strict loose.tex
has out "loose.tex:2:13: Op leaves n' open; "
printf '┌ S\nn : ℕ\n|\nn > m\n└\n' >unicode.utf8
run 1 spec check unicode.utf8
has out 'unicode.utf8:4:5: m is not declared; '
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
run 0 spec eval '∀ x : ℕ • x ≥ 0'
is out true
refused 'EXPR:1:1: this is not decided: one of x, y ranges over a set that is not finite, and no equation gives its value; expected a bound for x, as x : 0‥9, and a bound for y, as y : 0‥9' spec eval '∀ x, y : ℕ • x * x + y ≥ x'
refused 'EXPR:1:4: ' spec eval '1 +'
refused 'EXPR:1:1: ' spec eval '1 ∈ 2'
refused 'EXPR:1:1: nadie is not declared' spec eval nadie
run 0 spec eval '∃ x : ℝ • x * x = 2'
is out true
refused 'EXPR:1:1: this is not decided' spec eval '∃ x : ℝ • x * x * x = 2'
refused 'EXPR:1:1: this is not decided' spec eval 'puntos_esfera(⦉x == 1, y == 0, z == 0⦊, 1) = ∅'

# eval: what is printed can be typed; decimals are exact; any element has a spelling; many elements, large numbers.
run 0 spec eval '1/3 + 0.25'
is out 7/12
run 0 spec eval '0.1 + 0.2 = 0.3'
is out true
run 0 spec eval '√(1/2) * √(1/2)'
is out 1/2
run 0 spec eval 'mi_radio ▷ {1/2}' --scene scene.json
is out '∅[Elemento × 𝔸]'
run 0 spec eval '∅[Elemento × 𝔸] = mi_radio ▷ {1/2}' --scene scene.json
is out true
run 0 spec eval '\emptyset[\real]'
is out '∅[𝔸]'
sed 's/"c1"/"c-1.a:b"/' scene.json >hyphen.json
run 0 spec eval 'elementos' --scene hyphen.json
is out '{"c-1.a:b", k1, s1}'
run 0 spec eval 'mi_radio("c-1.a:b")' --scene hyphen.json
is out 1
refused 'EXPR:1:1: c is not declared' spec eval 'c-1' --scene hyphen.json
{
  printf '{"format":"durero-scene","version":1,"elementos":['
  seq 1 7000 | sed 's/.*/{"id":"s-&","tipo":"esfera","centro":[&,0,0],"radio":1},/'
  printf '{"id":"t","tipo":"esfera","centro":[0,0,0],"radio":1}]}\n'
} >many.json
run 0 spec eval '# elementos' --scene many.json
is out 7001

# eval: what would not end is stopped, by steps or by memory, and says by which option.
squares=$(seq 1 40 | sed 's/.*/let a == a * a •/' | tr '\n' ' ')
bounded() {  # bounded OPTION WORDS ARGUMENT...
  option=$1 words=$2
  shift 2
  refused "EXPR:1:1: $words" spec eval "$@"
  has err "; expected a smaller expression, or a greater $option"
}
bounded --steps '--steps 300000 did not do: stopped after 300000 steps' --steps 300000 '∀ x, y, z : 1‥1000 • x ≤ 1000'
bounded --steps '--steps 100000 ' --steps 100000 '# {s : ℙ (1‥16) | # s > 3}'
bounded --steps '--steps 100000 ' --steps 100000 '∀ x : 1‥400 • # {s : ℙ (1‥(14 + x - x)) | # s > 0} > 1'
run 0 spec eval --steps 1000 '∀ x : 1‥100 • x ≤ 100'
run 0 spec eval '# {s : ℙ (1‥12) | # s > 3}'
is out 3797
# A set that is never listed is not for want of steps or memory.
refused 'EXPR:1:1: this is not decided: ℙ this finite set has more members than can be listed; expected a smaller set, whatever --steps and --memory' \
  spec eval '⋂ (ℙ (1‥40))'
refused 'EXPR:1:1: this is not decided: 𝔽₁ this finite set has more' spec eval '⋂ (𝔽₁ (1‥20))'
run 0 spec eval '# (ℙ (1‥40)) + # (1‥2000000)'
is out 1099513627776
if "$durero" version --json | grep -qF '"sanitizers":[]'; then  # which have memory of their own
  bounded --memory '--memory 200 MiB did not do: stopped after ' --memory 200 '# {s : ℙ (1‥19) | # s > 3}'
  bounded --memory '--memory 300 MiB did not do: stopped after ' --memory 300 '# {x, y : 1‥2000 | x < y}'
fi
export ASAN_OPTIONS=detect_leaks=0  # what numbers held when one outgrew memory is not freed
bounded --memory '--memory ' "let a == 3 • $squares a"
bounded --memory '--memory 64 MiB did not do' --memory 64 "let a == 3 • $squares a"
unset ASAN_OPTIONS
refused 'spec eval: --memory 63: no whole number from 64 to ' spec eval --memory 63 1
run 0 spec eval --help
has out '"a-b"'

# No message shows a byte that a terminal would obey.
refused 'EXPR:1:1: the character \x1b means nothing here' spec eval "$(printf '\033[2J')"
refused 'EXPR:1:5: the character \xff means nothing here' spec eval "$(printf '1 + \377')"
printf '\\begin{zed}\n  x == \033\377\n\\end{zed}\n' >raw.tex
run 1 spec check raw.tex
has out 'raw.tex:2:8: the character \x1b means nothing here'
cat >a.tex <<'TEX'
\begin{zsection}
  \SECTION a \parents b
\end{zsection}
TEX
sed 's/SECTION a/SECTION b/; s/parents b/parents a/' a.tex >b.tex
run 1 spec check a.tex b.tex
has out 'the parents go in a cycle, back to a; expected '

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
has out "ΞEscena == [Escena; Escena ' | θ Escena = θ Escena ']"
has out 'Escena.inv.1'
run 0 spec show Init
has out "│ Escena '"
refused "EXPR:1:1: Punto' is not declared; expected Punto ' (Punto~' in LaTeX) for the decoration of the schema Punto" spec eval "Punto'"
refused 'NAME:1:1: the text declares no nadie; expected' spec show nadie
refused 'NAME:1:1: the text declares no Δnadie; expected' spec show Δnadie
refused 'NAME:1:1: the text declares no Escna; expected Escena' spec show Escna
refused 'NAME:1:1: the text declares no Escena.inv.11; expected Escena.inv.1' spec show Escena.inv.11

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
