# durero spec tests: the cases of operations as text, JSON, and as programs that run.
. "$(dirname "$0")/harness.sh"
book=$(cd "$(dirname "$0")/../../demo" && pwd)/birthday_book.tex

run 0 spec tests "$book" --members 2
has out '9 cases of 7 operations, 9 with an example'
has out 'case        RAddBirthday: name? ∉ known ∧ '
has out 'RAddBirthday  date? = DATE1; name? = NAME1; result! = ok'
has out '  or 1 other answer'

cat >gate.tex <<'EOF'
\begin{zed} Word ::= go | wait \end{zed}
\begin{schema}{Gate} n : 0 \upto 2 \end{schema}
\begin{schema}{Init} Gate~' \where n' = 0 \end{schema}
\begin{schema}{Pass} \Delta Gate \\ word! : Word \where
  (n < 2 \land n' = n + 1 \land word! = go) \lor (n = 2 \land n' = n \land word! = wait) \lor
  (n > 2 \land n' = 0 \land word! = wait) \end{schema}
EOF
run 0 spec tests gate.tex
has out '3 cases of 1 operation, 2 with an example'
has out "infeasible  Pass: n > 2 ∧ n' = 0 ∧ word! = wait"
run 0 spec tests gate.tex --json
python3 - out >err 2>&1 <<'EOF' || fail 'the JSON'
import json, sys
made = json.load(open(sys.argv[1]))
assert made["format"] == "durero-spec-tests" and made["version"] == 1 and made["bounded"] == []
assert [each["feasible"] for each in made["cases"]] == [True, True, False]
assert made["cases"][1]["before"] == {"n": "2"} and made["cases"][1]["way"] == ["Init", "Pass  word! = go", "Pass  word! = go"]
assert made["cases"][0]["admitted"] == [{"outputs": {"word!": "go"}, "after": {"n": "1"}}]
EOF

# The program in Python skips what is not filled in; a right system passes, and a wrong one does not.
run 0 spec tests gate.tex --python -o gate_test.py
python3 gate_test.py >out 2>err || fail 'the program in Python runs'
has err 'OK (skipped=2)'
fill() {  # fill ANSWER FILE : the call of the system answers so
  sed "s/        raise NotImplementedError(\"Pass\")/        return $1/" gate_test.py >"$2"
}
fill '{"word!": "go" if before["n"] < 2 else "wait"}, {"n": min(2, before["n"] + 1)}' right.py
python3 right.py >out 2>err || fail 'a right system passes'
has err 'OK'
fill '{"word!": "go"}, {"n": before["n"] + 1}' wrong.py
if python3 wrong.py >out 2>err; then fail 'a wrong system passes'; fi
has err 'FAILED (failures=1)'

# So does the program in C++.
run 0 spec tests gate.tex --cpp -o gate_test.cpp
if command -v c++ >/dev/null; then
  c++ -std=c++17 -Wall -Wextra -Werror gate_test.cpp -o gate_test 2>err || fail 'the program in C++ compiles'
  ./gate_test >out || fail 'the program in C++ runs'
  has out '0 passed, 0 failed, 2 not filled in'
  sed 's|  return std::nullopt;.*|  return Answer{{{"word!", "go"}}, {{"n", before.at("n") == "0" ? "1" : "3"}}};|' gate_test.cpp >wrong.cpp
  c++ -std=c++17 wrong.cpp -o wrong 2>err || fail 'the filled program compiles'
  if ./wrong >out; then fail 'a wrong system passes in C++'; fi
  has out 'FAILED: 2 Pass'
  has out '1 passed, 1 failed, 0 not filled in'
fi

# Values of each kind in Python, and an interrupt.
run 0 spec tests "$book" --members 2 --python
python3 - out >err 2>&1 <<'EOF' || fail 'the values in Python'
import sys
program = open(sys.argv[1]).read()
compile(program, "book", "exec")
assert 'frozenset({("NAME1", "DATE1", ), })' in program
EOF
run 2 spec tests gate.tex --json --cpp
finish
