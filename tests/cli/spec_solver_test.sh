# durero spec --solver: what a solver finds counts where the text says so. The solvers here are scripts that answer, lie,
# talk nonsense, hang and crash.
. "$(dirname "$0")/harness.sh"

# solver NAME: makes a program of that name from the standard input.
solver() {
  { echo '#!/bin/sh'; cat; } >"$1"
  chmod +x "$1"
}

solver right <<'SH'
cat >script
echo sat
echo '((v0 1000000011))'
SH
solver wrong <<'SH'
cat >/dev/null
echo sat
echo '((v0 1000000012))'
SH
solver silent <<'SH'
cat >/dev/null
SH
solver finds-nothing <<'SH'
cat >/dev/null
echo unsat
SH
solver nonsense <<'SH'
cat >/dev/null
echo 'Hello ((('
SH
solver hangs <<'SH'
echo sat
sleep 100 & echo $! >child
wait
SH
solver crashes <<'SH'
kill -SEGV $$
SH
solver fails <<'SH'
echo 'no licence' >&2
exit 3
SH
solver floods <<'SH'
yes sat
SH

far='∀ x : ℕ • x < 1000000007 ∨ x mod 7 ≠ 3'
undecided='EXPR:1:1: this is not decided: x ranges over ℕ, of which there is no end, and no equation gives its value'
refused "$undecided; expected" spec eval "$far"

run 1 spec eval "$far" --solver ./right
is out false
is err 'durero: note: right finds the counter-example x == 1000000011, which holds by the text'
is script '(set-option :produce-models true)
(set-logic ALL)
(declare-fun v0 () Int)
(assert (>= v0 0))
(assert (not (or (< v0 1000000007) (not (= (mod v0 7) 3)))))
(check-sat)
(get-value (v0))
(exit)'
run 0 spec eval "¬ ($far)" --solver './right with arguments'
is out true

refused "$undecided; wrong's answer x == 1000000012 does not hold by the text; expected" spec eval "$far" --solver ./wrong
refused "$undecided; finds-nothing finds no counter-example; expected" spec eval "$far" --solver ./finds-nothing
refused "$undecided; silent ends without an answer, exit status 0; expected" spec eval "$far" --solver ./silent
refused "$undecided; nonsense's answer is not understood: Hello (((; expected" spec eval "$far" --solver ./nonsense
refused "$undecided; crashes ends by signal 11 (Segmentation fault); expected" spec eval "$far" --solver ./crashes
refused "$undecided; fails ends without an answer, exit status 3: no licence; expected" spec eval "$far" --solver ./fails
refused "$undecided; floods writes more than 1048576 bytes; expected" spec eval "$far" --solver ./floods
refused "$undecided; hangs gives no answer within 1 s; expected" spec eval "$far" --solver ./hangs --solver-time 1
checks=$((checks + 1))
case $(sed -n 's/^State:[^A-Z]*\([A-Z]\).*/\1/p' "/proc/$(cat child)/status" 2>/dev/null) in
  '' | Z | X) ;; # a zombie waits for whoever is process 1
  *) fail 'a process of the solver outlives the command' ;;
esac
refused '--solver:1:1: nobody-has-this: No such file or directory; expected a program' spec eval "$far" --solver nobody-has-this
refused 'EXPR:1:1: this is not decided: ' spec eval '∃ r : ℕ ↔ ℕ • # (r ⁺) = 1000' --solver ./right
has err '; right is not asked: r ⁺ is not translated; expected'
run 2 spec eval "$far" --solver ''
run 2 spec eval "$far" --solver ./right --solver-time 0
run 2 spec eval "$far" --solver ./right --explain

# The text decides before the solver does.
rm script
run 0 spec eval '∃ x : ℕ • x = 3' --solver ./right
is out true
lines err 0
checks=$((checks + 1))
[ ! -e script ] || fail 'a solver was asked of what the text decides'

cat >claims.tex <<'TEX'
\begin{zed}
  \vdash? \forall x : \nat @ x < 1000000007 \lor x \mod 7 \neq 3
\end{zed}
\begin{zed}
  \vdash? \exists x : \nat @ x > 1000000007 \land x \mod 7 = 3
\end{zed}
\begin{zed}
  \vdash? \forall r : \nat \rel \nat @ \# (r \plus) \geq 0
\end{zed}
\begin{zed}
  \vdash? \forall x : \nat @ x + 1 > 0
\end{zed}
TEX
run 1 spec check --quiet claims.tex --solver ./right
has out 'claims.tex:2:3: conjecture is false, as in this state:'
has out '  x = 1000000011'
has out 'claims.tex:5:3: conjecture is true; right finds the witness x == 1000000011, which holds by the text'
has out "right is not asked: r ⁺ is not translated"
has out 'claims.tex:11:3: conjecture is true'
run 0 spec check --quiet claims.tex --solver ./finds-nothing
has out 'claims.tex:2:3: conjecture tried on 4 states; finds-nothing finds no counter-example'
has out 'claims.tex:5:3: conjecture not tried: '
has out '; finds-nothing finds no witness'
run 0 spec check --quiet claims.tex
grep -q finds-nothing out && fail 'a solver was asked that nobody named'
finish
