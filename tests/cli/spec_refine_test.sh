# durero spec refine: the obligations of a data refinement, written and tried.
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
demo=$(CDPATH='' cd -- "$here/../../demo" && pwd)
. "$(dirname "$0")/harness.sh"

# The arrays refine the book, and the obligations that are written are read back.
cp "$demo"/birthday_book*.tex "$demo/coin.tex" .
run 0 spec refine BirthdayBook BirthdayBook1 --by Abs birthday_book_arrays.tex --scope 2 --quiet --write obligations.tex
has out 'BirthdayBook by BirthdayBook1, related by Abs: forward, by a retrieve function'
has out 'scope 2: 160 pairs of states reached, all that these inputs lead to, 0 states listed, all of this scope'
empty err
cp out forward
run 1 spec check birthday_book_arrays.tex obligations.tex
has out 'obligations.tex: section obligations ok, 16 paragraphs'
run 0 spec refine BirthdayBook BirthdayBook1 --by Abs birthday_book_arrays.tex --scope 2 --quiet --write obligations.zed
same out forward
run 1 spec check birthday_book_arrays.tex obligations.zed
has out 'obligations.zed: section obligations ok, 16 paragraphs'
has obligations.zed '⊢? ∀ Abs; pre AddBirthday • pre AddBirthday1  % AddBirthday1.conj.1'

# A wrong index is found at the first call, without options.
run 1 spec refine BirthdayBook BirthdayBook1 --by Abs birthday_book_wrong_index.tex
has out 'AddBirthday1.conj.1, applicability of AddBirthday, is false: AddBirthday1 may not follow: no state after satisfies it.'
has out "false is birthday' = birthday ∪ {name? ↦ date?}."

# The late coin needs a backward simulation.
run 1 spec refine Coin Coin1 --by AbsCoin coin.tex
has out 'Look1.conj.2, correctness of Look, is false: '
run 0 spec refine Coin Coin1 --by AbsCoin coin.tex --backward
has out 'the retrieve schema is total'

# An operation without a partner is a fault, unless that is asked for; --pair names one.
sed 's/{Toss1}/{Throw}/' coin.tex >throw.tex
run 1 spec refine Coin Coin1 --by AbsCoin throw.tex --backward
has out '  Toss has NO PARTNER'
has out '  Throw has NO PARTNER'
run 0 spec refine Coin Coin1 --by AbsCoin throw.tex --backward --some
run 0 spec refine Coin Coin1 --by AbsCoin throw.tex --backward --pair Toss=Throw
has out '  Toss by Throw'

# Given sets have the members that are given; bounds are said.
run 1 spec refine BirthdayBook BirthdayBook1 --by Abs birthday_book_wrong_index.tex --given NAME=ann,bob --given DATE=2 --scope 1
has out '  NAME == {ann, bob}'
run 0 spec refine BirthdayBook BirthdayBook1 --by Abs birthday_book_arrays.tex --states 5 --scope 2
has out 'scope 2: 5 pairs of states reached, '

# The obligations are written for Coq and for Isabelle; Coq takes them, refutes what is false and proves what is true.
run 0 spec refine BirthdayBook BirthdayBook1 --by Abs birthday_book_arrays.tex --scope 1 --coq arrays.v --isabelle Arrays.thy
has arrays.v 'Definition obligation_AddBirthday1_conj_2 : Prop :='
has Arrays.thy 'definition obligation_AddBirthday1_conj_2 :: "bool" where'
has Arrays.thy 'theory Arrays'
run 1 spec refine Coin Coin1 --by AbsCoin coin.tex --scope 1 --coq forward.v
run 0 spec refine Coin Coin1 --by AbsCoin coin.tex --scope 1 --coq backward.v --backward
if command -v coqc >/dev/null; then
  cp "$here"/coin_forward.v "$here"/coin_backward.v .
  for file in arrays forward backward coin_forward coin_backward; do
    checks=$((checks + 1))
    coqc -q -Q . Export "$file.v" >out 2>err || fail "coqc $file.v"
  done
else
  echo "coqc is absent: what is written for Coq is not compiled"
fi
{ cat coin.tex; printf '\\begin{zed} Pairs[X] == X \\cross X \\end{zed}\n'; } >generic.tex
refused 'generic.tex:' spec refine Coin Coin1 --by AbsCoin generic.tex --scope 1 --coq generic.v
has err 'a generic definition has no rule of translation to higher-order logic'
absent generic.v

# Errors are one line.
refused 'coin.tex:1:1: the text has no schema Coim; expected Coin' spec refine Coim Coin1 --by AbsCoin coin.tex
refused 'coin.tex:1:1: Coin and Coin share hand; expected states without a common component' spec refine Coin Coin --by AbsCoin coin.tex
refused '--pair:1:1: no pair Toss; expected AOP=COP' spec refine Coin Coin1 --by AbsCoin coin.tex --pair Toss
refused 'coin.tex:1:1: the outputs of Look1: face!; expected those of Toss: none' spec refine Coin Coin1 --by AbsCoin coin.tex --pair Toss=Look1
refused '--given:1:1: the text has no given set NAME; expected one' spec refine Coin Coin1 --by AbsCoin coin.tex --given NAME=2
sed 's/tossed = no /tossed = maybe /' coin.tex >ill.tex
refused 'ill.tex:' spec refine Coin Coin1 --by AbsCoin ill.tex --write kept.tex
absent kept.tex
finish
