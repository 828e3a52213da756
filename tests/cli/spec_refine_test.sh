# durero spec refine: the obligations of a data refinement, written and tried.
demo=$(CDPATH='' cd -- "$(dirname -- "$0")/../../demo" && pwd)
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

# Errors are one line.
refused 'coin.tex:1:1: the text has no schema Coim; expected Coin' spec refine Coim Coin1 --by AbsCoin coin.tex
refused 'coin.tex:1:1: Coin and Coin share hand; expected states without a common component' spec refine Coin Coin --by AbsCoin coin.tex
refused '--pair:1:1: no pair Toss; expected AOP=COP' spec refine Coin Coin1 --by AbsCoin coin.tex --pair Toss
refused 'coin.tex:1:1: the outputs of Look1: face!; expected those of Toss: none' spec refine Coin Coin1 --by AbsCoin coin.tex --pair Toss=Look1
refused 'coin.tex:1:1: the text has no given set NAME; expected one' spec refine Coin Coin1 --by AbsCoin coin.tex --given NAME=2
sed 's/tossed = no /tossed = maybe /' coin.tex >ill.tex
refused 'ill.tex:' spec refine Coin Coin1 --by AbsCoin ill.tex --write kept.tex
absent kept.tex
finish
