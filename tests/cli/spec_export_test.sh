# durero spec export --coq: the Z text as Coq.
tree=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
. "$(dirname "$0")/harness.sh"
run 0 spec export --coq -o Especificacion.v "$tree"/spec/[b-g]*.tex "$tree/spec/haces.tex" "$tree"/spec/[i-ln-o]*.tex "$tree/spec/proyeccion.tex" "$tree/spec/puntos.tex" \
  "$tree/spec/solidos.tex" "$tree/spec/tipos.tex"
empty out
empty err
same Especificacion.v "$tree/proofs/Especificacion.v"

# Parents are found beside the files; without -o, the text is printed.
run 0 spec export --coq "$tree/spec/interseccion.tex"
has out 'Record Escena_ok (s : Escena) : Prop := {'
has out '(* occluded_segment.def.1 *)'

# A second state is refused: proofs/Tablas.v, proofs/Promocion.v, proofs/Malla.v and proofs/Historia.v state those by hand.
refused "$tree/spec/tablas.tex:103:3: a second state, Tablas beside Escena" spec export --coq "$tree/spec/tablas.tex"
refused "$tree/spec/malla.tex:" spec export --coq "$tree/spec/malla.tex"
printf '\\begin{zed} S == \\{~ A : \\power \\num | \\# A = 1 ~\\}\n\\end{zed}\n' >counted.tex
refused 'counted.tex:1:40: the operation #_ has no rule of translation to Coq; expected ' spec export --coq counted.tex -o counted.v
absent counted.v
printf '\\begin{zed} S == \\{~ A : \\power B | A = A ~\\}\n\\end{zed}\n' >untyped.tex
refused 'untyped.tex:1:' spec export --coq untyped.tex
refused 'lost.tex' spec export --coq lost.tex
finish
