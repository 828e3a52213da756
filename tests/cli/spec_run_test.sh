# durero spec run: the animator through a pipe and through a terminal; spec eval and show of a text of one's own.
. "$(dirname "$0")/harness.sh"
home=$(dirname "$0")
book=$(cd "$home/../../demo" && pwd)/birthday_book.tex

# play STATUS COMMAND... : runs the commands, one a line, on the book with two people and two dates.
play() {
  status=$1
  shift
  called="durero spec run: $*"
  printf '%s\n' "$@" | "$durero" spec run "$book" --members 2 --given NAME=ann,bob >out 2>err
  got=$?
  checks=$((checks + 1))
  [ "$got" = "$status" ] || fail "$called: status $got, expected $status"
}

play 0 'AddBirthday name? = ann; date? = DATE2' show
has out 'state BirthdayBook, initial schema InitBirthdayBook, 7 operations'
has out '0. InitBirthdayBook'
has out '1. AddBirthday  date? = DATE2; name? = ann'
has out '* known    == ∅[NAME]         →  {ann}'
has out '* birthday == ∅[NAME × DATE]  →  {ann ↦ DATE2}'
has out '  invariant: 3 of 3 conjuncts hold'
has out '  may go on: AddBirthday, '
play 0 AddBirthday 4
has out '4 ways:'
has out '1. AddBirthday  date? = DATE2; name? = bob'
play 0 ops
has out '  no   FindBirthday'
has out '  yes  AddBirthday  date? = DATE1; name? = ann'
play 0 'why FindBirthday name? = ann'
has out '  false  name? ∈ known  % FindBirthday.pre.1'
has out '  open   known = dom birthday  (after)  % BirthdayBook.inv.1'
play 0 'AddBirthday name? = ann; date? = DATE1' 'Remind today? = DATE1' back trace 'save way.txt'
has out 'cards! = {ann}'
has out '0. InitBirthdayBook'
has way.txt 'durero-trace 1'
has way.txt "  known' == {ann}"
play 0 restart 'replay way.txt' 'save again.txt'
has out '2 steps, each as the text says'
same way.txt again.txt
play 1 explore
has out 'false after this way:'
has out 'birthday ∈ NAME ⤔ DATE  (here)'
has out '2. AddBirthday'
play 1 'AddBirthday name? = ann; date? = DATE1' 'AddBirthday name? = bob; date? = DATE1' try
has out '  true   '
has out '  false  '

# What cannot be done ends a script, in one line that says where.
says() {  # says LINE COLUMN TEXT COMMAND...
  text="durero: <stdin>:$1:$2: $3"
  shift 3
  play 2 "$@"
  lines err 1
  has err "$text"
}
says 1 1 'FindBirthday cannot go on here; expected an operation that may' FindBirthday
says 2 1 'no operation or command AddBirthdy; expected AddBirthday' '# nothing' AddBirthdy
says 1 1 'nome? is no input of AddBirthday; expected ' 'AddBirthday nome? = ann'
says 1 1 'name?: eve is not declared; expected ' 'AddBirthday name? = eve'
says 1 1 'no way 3 is listed; expected ' 3
says 1 1 'there is no step to take back; expected one' back
refused 'spec run: --members 0: ' spec run --members 0
refused "$book:1:1: the text has no schema Nada; expected one for --state" spec run "$book" --state Nada
refused '--given:1:1: NAME gives no members; expected ' spec run "$book" --given NAME
sed "s/known' == {ann}/known' == {bob}/" way.txt >wrong.txt
run 2 spec run "$book" --members 2 --given NAME=ann,bob --replay wrong.txt
has err 'durero: wrong.txt:8:6: AddBirthday does not allow this step; expected one that its text allows'

# The same on a terminal, where a mistake is said and one goes on.
checks=$((checks + 1))
python3 "$home/spec_run.py" "$durero" "$book" >err 2>&1 || fail spec_run.py

# The program's own text steps too, for a session of some length.
checks=$((checks + 1))
python3 "$home/spec_run_own.py" "$durero" >err 2>&1 || fail spec_run_own.py
printf 'Agregar_Esfera e? = bola; centro? = ⦉x == 0, y == 0, z == 5⦊; radio? = 1\nEliminar_Esfera\n' |
  "$durero" spec run --given Elemento=bola >out 2>err || fail "spec run of the program's own text"
has out '* mi_radio'
has out '→  {bola ↦ 1}'
has out '2. Eliminar_Esfera  '

# eval and show of a text of one's own.
run 0 spec eval '# REPORT' "$book"
is out 3
run 0 spec eval '\{ r : REPORT | r \neq ok \}' "$book"
is out '{already_known, not_known}'
refused 'EXPR:1:1: Escena is not declared' spec eval 'Escena' "$book"
refused '--scene:1:1: ' spec eval 1 "$book" --scene scene.json
run 0 spec show AddBirthday "$book"
has out "│ birthday' = birthday ∪ {name? ↦ date?}  % AddBirthday.post.1"
refused 'NAME:1:1: the text declares no AddBirthdy; expected AddBirthday' spec show AddBirthdy "$book"
printf '\\begin{zed}\n  x == 1 + \\{ 1 \\}\n\\end{zed}\n' >wrong.tex
refused 'wrong.tex:2:' spec eval x wrong.tex
refused 'wrong.tex:2:' spec run wrong.tex
refused 'wrong.tex:2:' spec show x wrong.tex
# What equations leave open is looked for among some values, and it is said which bound that has.
printf '%s\n' '\begin{schema}{S} n : \nat; m : \nat \end{schema}' "\\begin{schema}{Init} S~' \\where n' = 0 \\end{schema}" \
  "\\begin{zed} Op == [ \\Delta S | n' > n \\land m' = m ] \\end{zed}" >open.tex
printf '2\nOp\n' | "$durero" spec run open.tex >out 2>err || fail 'spec run open.tex'
has out '3 ways:'
has out "  there may be other ways: some values of m' were tried, as --numbers bounds them"
has out '  * n == 0  →  1'
has out "some values of m' were tried"
printf '1\nexplore 5\n' | "$durero" spec run open.tex >out 2>err || fail 'spec run open.tex: explore'
has out "  bounded: Op: some values of n' were tried: --numbers"
# Where none of these will do, it is said which way out there is.
sed "s/n' = 0/n' = 0 \\\\land m' > 9/" open.tex >far.tex
run 2 spec run far.tex </dev/null
has err "no initial state is found, as far as some values of m', n' were tried: --numbers"
has err 'expected an initial schema whose equations give each component a value'
run 0 spec run far.tex --numbers 10 </dev/null
has out '  m == 10'
# An operator is shown by its word too, with or without the places of its operands, and is the near word of others.
printf '%s\n' '\begin{zed} \relation (\_~divides~\_) \end{zed}' '\begin{axdef} \_~divides~\_ : \nat \rel \nat' \
  '\where \forall a, b : \nat @ a~divides~b \iff (\exists c : \nat @ a * c = b) \end{axdef}' >divides.tex
for spelled in divides _divides_ '_ divides _' '\_ divides \_'; do
  run 0 spec show "$spelled" divides.tex
  has out '_ divides _ : ℕ ↔ ℕ'
done
refused 'NAME:1:1: the text declares no divdes; expected divides' spec show divdes divides.tex
finish
