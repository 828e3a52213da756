# durero spec: the constants that a text leaves open, and names that it does not have.
. "$(dirname "$0")/harness.sh"

# Constants that the text leaves open take a value, which is said, and may be given one.
cat >buffer.tex <<'TEX'
\begin{axdef} max\_size, low : \nat \where low < max\_size \end{axdef}
\begin{schema}{Buffer} size : \nat \where size \leq max\_size \end{schema}
\begin{schema}{Init} Buffer~' \where size' = 0 \end{schema}
\begin{schema}{Put} \Delta Buffer \where size < max\_size \\ size' = size + 1 \end{schema}
\begin{zed} \vdash? \forall Buffer @ size < 8 \end{zed}
TEX
run 0 spec eval 'max_size' buffer.tex
is out 3
has err 'durero: note: max_size = 3 was taken; --let max_size=VALUE chooses another'
run 0 spec eval 'max_size' buffer.tex --let max_size=8 --let low=2
is out 8
lines err 0
refused '--let:1:1: low = -1 makes low ∈ ℕ false; expected a value that the text admits' spec eval 'max_size' --let 'low=- 1' buffer.tex
refused '--let:1:1: max_size = 2 makes low < max_size (line 1) false; expected a value that the text admits' spec eval 'max_size' --let max_size=2 --let low=5 buffer.tex
refused '--let:1:1: the text has no constant max_sise; expected max_size' spec eval 'max_size' --let max_sise=2 buffer.tex
run 0 spec check --quiet buffer.tex
has err 'durero: note: max_size = '
has out 'conjecture is true of the values taken'
run 0 spec check --quiet --let max_size=5 --let low=1 buffer.tex
lines err 0
called='durero spec run'
printf '%s\n' Put Put | "$durero" spec run buffer.tex --let max_size=2 --let low=1 >out 2>err || fail 'spec run --let'
has out '  refused:   Put: size < max_size'
printf 'ops\n' | "$durero" spec run buffer.tex >out 2>err || fail 'spec run'
has out '  max_size = 3 was taken; --let max_size=VALUE chooses another'
cat >open.tex <<'TEX'
\begin{zed} [NAME] \end{zed}
\begin{axdef} p : NAME \end{axdef}
TEX
refused 'EXPR:1:1: this is not decided: no equation gives p a value; expected one, or --let p=VALUE' spec eval 'p' open.tex
cat >broken.tex <<'TEX'
\begin{axdef} a, b : \nat \where a = 3 \\ b = 5 \\ b \leq a \end{axdef}
TEX
refused 'EXPR:1:1: the text cannot be so: a = 3 makes b ≤ a (line 1) false' spec eval 'b' broken.tex
sed 's/b = 5/b = 1/' broken.tex >mended.tex
run 0 spec eval 'b' mended.tex
is out 1

# Members are for given sets alone, and a constant has its value by --let; spec check has both in a scope.
refused '--given:1:1: max_size is a constant, and no given set; expected --let max_size=VALUE' spec run buffer.tex --given max_size=3
refused '--given:1:1: max_size is a constant, and no given set; expected --let max_size=VALUE' spec explore buffer.tex --given max_size=3
cat >pair.tex <<'TEX'
\begin{zed} [NAME] \end{zed}
\begin{zed} \vdash? \forall x, y, z : NAME @ x = y \lor y = z \lor x = z \end{zed}
TEX
run 1 spec check --quiet pair.tex
run 0 spec check --quiet pair.tex --scope NAME=2
has out 'conjecture is true within NAME = {NAME1, NAME2}'
refused '--given:1:1: the text has no given set NAMES; expected NAME' spec run pair.tex --given NAMES=2
refused '--given:1:1: dom cannot name a member of NAME; expected a new word' spec run pair.tex --given NAME=dom
refused '--scope:1:1: the text has no constant NAMES' spec check pair.tex --scope NAMES=2
refused '--numbers:1:1: 3 bounds no numbers; expected LOW..HIGH' spec check pair.tex --numbers 3
refused "--scope:1:1: the program's own text is tried on samples of its own; expected FILES" spec check --scope Elemento=2
refused "--numbers:1:1: the program's own text is tried on samples of its own; expected FILES" spec check --numbers 0..3

# A name of a state needs one, and an unknown name is answered by some that there are.
refused 'EXPR:1:3: elementos is not declared; expected --scene FILE, whose state has elementos' spec eval '# elementos'
refused 'EXPR:1:1: foo is not declared; expected a declared name, such as ' spec eval foo
finish
