# z3 and cvc5 find what the evaluator does not, and durero evaluates it; each is left out where it is not installed. The
# example of docs/spec-tool.md is among the questions.
. "$(dirname "$0")/../cli/harness.sh"

# finds SOLVER STATUS ANSWER TEXT PREDICATE: the answer, with a note that has the text.
finds() {
  run "$2" spec eval "$5" --solver "$1" --solver-time 60
  is out "$3"
  lines err 1
  has err "durero: note: $(basename "$1") finds the $4"
}

# finds_nothing SOLVER TEXT PREDICATE: it is not decided, and the reason has the text.
finds_nothing() {
  refused 'EXPR:1:1: this is not decided: ' spec eval "$3" --solver "$1" --solver-time 60
  has err "; $(basename "$1") finds no $2; expected"
}

cat >text.tex <<'TEX'
\begin{zed} Colour ::= red | green | blue \end{zed}
\begin{schema}{Order} pieces, price : \nat_1 \\ colour : Colour \where pieces * price > 100000 \end{schema}
\begin{axdef} total : \nat \cross \nat \fun \nat \where \forall n, p : \nat @ total(n, p) = n * p - n \div 3 \end{axdef}
\begin{zed} \vdash? \forall o : Order @ o.pieces > 317 \lor o.price > 317 \lor o.colour = blue \end{zed}
\begin{zed} \vdash? \forall n, p : \nat | n > 400 @ total(n, p) \neq 401 * 1009 - 133 \end{zed}
TEX

asked=0
for solver in z3 cvc5; do
  command -v "$solver" >/dev/null || { echo "$solver is not installed"; continue; }
  asked=$((asked + 1))
  finds $solver 0 true 'witness x == ' '∃ x, y : ℕ₁ | x > 1000 ∧ y > 1000 • 17 * x - 23 * y = 1'
  finds $solver 1 false 'counter-example x == ' '∀ x : ℕ • x < 1000000007 ∨ x mod 7 ≠ 3'
  finds $solver 1 false 'counter-example x == ' '∀ x : ℤ • x > - 1000000007 ∨ x mod (- 7) ≠ - 3'
  finds $solver 0 true 'witness x == ' '∃ x : ℤ • x div (- 7) = 123456789 ∧ x mod (- 7) = - 2'
  finds $solver 1 false 'member x == ' '{x : ℕ | x mod 100003 = 7 ∧ x mod 99991 = 5} = ∅'
  finds $solver 1 false 'two witnesses x == ' '∃₁ x : ℤ • x > 100000 ∧ x mod 3 = 1'
  finds $solver 0 true 'witness x == ' '∃ x, y : 𝔸 • x + y = 100001 ∧ x - y = 1/3 ∧ x ≠ y'
  finds_nothing $solver counter-example '∀ x, y : ℕ • x * x + y ≥ x'
  finds_nothing $solver witness '∃ x, y : ℤ • x * x - 4 * y = 2 ∧ x > y + 1000'
  run 1 spec check --quiet text.tex --solver $solver --solver-time 60
  has out 'text.tex:4:13: conjecture is false, as in this state:'
  has out '  o = ⦉colour == '
done
[ "$asked" -gt 0 ] || exit 77
if command -v z3 >/dev/null; then
  finds z3 0 true 'witness x == 199, y == 980' '∃ x, y : ℤ • x * x + y * y = 1000001 ∧ 10 < x ∧ x < y'
  finds z3 0 true 'witness x == 10100' '∃ x : ℤ • x * x * x = 1030301000000'
  is err 'durero: note: z3 finds the witness x == 10100, which holds by the text'
  finds z3 1 false 'member x == 123' '{x : ℕ | x * x * x = 1860867} = ∅'
  run 1 spec check --quiet text.tex --solver z3 --solver-time 60
  has out 'text.tex:5:13: conjecture is false, as in this state:'
fi
finish
