# durero spec convert: Z text between LaTeX and Unicode.
tree=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
. "$(dirname "$0")/harness.sh"
cp "$tree"/spec/*.tex .
run 0 spec convert puntos.tex -o puntos.utf8
empty out
empty err
run 0 spec convert puntos.utf8
same out "$tree/spec/puntos.tex"
has puntos.utf8 '─ section puntos parents escena'

# It is read as the LaTeX is, and what is in the wanted mark-up already stays as it is.
mkdir there
for stem in tipos escena operaciones puntos interseccion; do
  run 0 spec convert "$stem.tex" --to unicode -o "there/$stem.utf8"
done
run 0 spec check there/interseccion.utf8 there/operaciones.utf8 --states 0
has out 'section interseccion ok'
run 0 spec convert there/tipos.utf8 --to unicode
same out there/tipos.utf8

printf '─\nx == "a-b"\n└\n' >quoted.utf8
refused 'quoted.utf8:2:6: "a-b" cannot be written in LaTeX mark-up; expected ' spec convert quoted.utf8 -o quoted.tex
absent quoted.tex
printf '\\begin{zed} x == \\end{zed}\n' >early.tex
refused 'early.tex:1:' spec convert early.tex
printf 'prose\n' >none.tex
refused 'none.tex:1:1: no Z paragraph; expected ' spec convert none.tex
refused 'lost.tex' spec convert lost.tex
refused 'spec convert: --to: word not in ' spec convert puntos.tex --to word

# Spivey's Z: from ISO's LaTeX and Unicode, and back; a section of one's own among the parents is refused.
cat >counter.tex <<'END'
\begin{schema}{S} n : \nat \end{schema}
\begin{zed} I == [ S~' | n' = 0 ] \end{zed}
END
run 0 spec convert counter.tex -o counter.utf8
run 0 spec convert counter.tex --to spivey -o counter.fuzz.tex
has counter.fuzz.tex "defs [ S' | n' = 0 ]"
run 0 spec convert counter.utf8 --to spivey
has out "defs [ S' | n' = 0 ]"
run 0 spec check counter.fuzz.tex
has out "in Spivey's Z as"
run 0 spec convert counter.fuzz.tex --to iso
has out "I == [ S~' | n' = 0 ]"
refused 'puntos.tex:' spec convert puntos.tex --to spivey
finish
