#!/bin/sh
# The audit of the proofs: what could make a theorem of proofs/Main.v mean less than it says.
# The statements are those of Main.v and of the files that it continues, Main*.v; below, Main.v stands for all of them.
#   audit.sh CHECK PROOFS [BUILD_DIRECTORY]
#     text         no proof is left open, nothing is assumed outside a section or a module type, no check of Coq's is
#                  switched off, and Main.v holds statements and nothing that they could be bent with
#     reachable    Main.v or an Instances*.v depends on every file, so that none is proved beside the point
#     assumptions  each theorem of Main.v rests on the axioms that assumptions.txt says, and those are of classical reals
#     statements   each theorem of Main.v says what statements.md says, and so does each definition that it reaches
#     instances    each theorem of Main.v with premises has an instance in Instances*.v, which has none and rests on it,
#                  and on those axioms
#     kernel       coqchk, which shares no code with the tactics, accepts Main.v, Instances*.v and all below them
#     all          each of these
#     daily        each but kernel, which takes minutes
# Except for `text` the build directory holds the proofs, built. `update` writes assumptions.txt and statements.md anew:
# their difference is then for a reader to judge.
set -eu
export LC_ALL=C
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
check=$1 proofs=$2 build=${3-}
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT

# The axioms of Coq's classical real numbers, and no others, by their full names.
allowed='Coq.Reals.ClassicalDedekindReals.sig_forall_dec
Coq.Reals.ClassicalDedekindReals.sig_not_dec
Coq.Logic.FunctionalExtensionality.functional_extensionality_dep
Coq.Logic.Classical_Prop.classic'

# The options that every file is compiled with, and no others: some of Coq's make it prove anything.
options='-Q . Durero
-arg -w -arg -notation-overridden'

# The files without comments and strings, each line as FILE:LINE:TEXT.
without_comments() {
  awk 'FNR == 1 { depth = 0; string = 0 }
    { text = $0; out = ""
      while (text != "") {
        two = substr(text, 1, 2); one = substr(text, 1, 1); step = 1
        if (string) { if (one == "\"") string = 0 }
        else if (two == "(*") { depth++; step = 2 }
        else if (depth && two == "*)") { depth--; step = 2; out = out " " }
        else if (one == "\"") { string = 1; if (!depth) out = out "\"\"" }
        else if (!depth) out = out one
        text = substr(text, step + 1)
      }
      print FILENAME ":" FNR ":" out }' "$@"
}

# The sentences of the files, each in one line as FILE:LINE:SENTENCE, its words one blank apart.
sentences() {
  without_comments "$@" | awk '
    function told() { if (sentence != "") print file ":" begin ":" sentence; sentence = "" }
    { line = $0; sub(/:.*/, "", line)
      if (line != file) { told(); file = line }
      line = text = substr($0, length(file) + 2); sub(/:.*/, "", line); sub(/^[0-9]*:/, "", text)
      n = split(text, words, /[ \t\r\f]+/)
      for (i = 1; i <= n; i++) if (words[i] != "") {
        if (sentence == "") begin = line
        sentence = sentence (sentence == "" ? "" : " ") words[i]
        if (words[i] ~ /(^|[^.])(\.|\.\.\.)$/) told()
      } }
    END { told() }'
}

# What may begin a sentence of any file, and of Main.v: all else could assume, or switch a check off, or say in Main.v
# what a word of a statement means. What begins with a small letter is a tactic. Whoever needs another kind of sentence
# adds it here, if it can do neither.
common='Theorem Variable Variables Hypothesis Hypotheses Let Notation Section End Import From Proof Qed'
in_main="$common Implicit"
in_any="$common Implicit Lemma Corollary Definition Fixpoint Inductive Record Instance Context Module Parameter Ltac Opaque
  Transparent Arguments Defined Unshelve"

audit_text() {
  printf '%s\n' "$options" | diff - "$proofs/_CoqProject" || { echo '_CoqProject has other options than it should'; return 1; }
  sentences "$proofs"/*.v | awk -v any="$in_any" -v main="$in_main" '
    BEGIN { n = split(any, list); for (i = 1; i <= n; i++) in_any[list[i]] = 1
      n = split(main, list); for (i = 1; i <= n; i++) in_main[list[i]] = 1 }
    function wrong(why) { print $0 "  <- " why; bad = 1 }
    { file = $0; sub(/:.*/, "", file); if (file != last) { depth = 0; last = file }
      sentence = substr($0, length(file) + 2); sub(/^[0-9]*:/, "", sentence)
      gsub(/[^A-Za-z0-9_.\047]/, " & ", sentence); words = split(sentence, word)
      for (i = 1; i <= words; i++) if (word[i] ~ /^(Admitted|admit|give_up|Abort|Admit)\.?$/) wrong("left open")
      first = 1
      while (word[first] ~ /^([-+*{}:,!]|\[|\]|[0-9]+)$/) first++  # bullets, braces, and which goals
      if (word[first] ~ /^([a-z(]|[A-Z][A-Za-z_]*\.[a-z])/) next  # a tactic
      if (file !~ /\/Main[A-Za-z]*\.v$/ && (word[first] == "Local" || word[first] == "Global")) first++
      if (word[first] == "Local" && word[first + 1] ~ /^(Open|Notation)$/) first++
      kind = word[first]; sub(/\.$/, "", kind)
      two = kind " " word[first + 1]
      if (two == "Open Scope" || two == "Declare Scope" || two == "Delimit Scope" || two == "Set Implicit") next
      if (file ~ /\/Main[A-Za-z]*\.v$/ && !(kind in in_main)) wrong("no sentence for Main.v, which states and refers only")
      else if (!(kind in in_any)) wrong("a kind of sentence that the audit does not know: it may assume anything")
      else if (kind ~ /^(Variable|Hypothes|Context)/ && room[depth] != "Section") wrong("assumed outside a section")
      else if (kind == "Parameter" && room[depth] != "Module Type") wrong("assumed outside a module type")
      if (kind == "Section") room[++depth] = kind
      else if (two == "Module Type" && sentence !~ / : = /) room[++depth] = two
      else if (kind == "Module" && sentence !~ / : = /) room[++depth] = kind
      else if (kind == "End") depth-- }
    END { exit bad }'
}

audit_reachable() {
  (cd "$build" && coqdep -Q . Durero ./*.v 2>/dev/null) | tr -d '\r' | awk '
    { split($0, sides, ": "); n = split(sides[1], target, " "); from = ""
      for (i = 1; i <= n; i++) if (target[i] ~ /\.vo$/) { from = target[i]; all[from] = 1 }
      if (from == "") next
      m = split(sides[2], need, " ")
      for (i = 1; i <= m; i++) if (need[i] ~ /\.vo$/) edges[from] = edges[from] " " need[i] }
    END { for (file in all) if (file ~ /^(\.\/)?(Main|Instances[A-Za-z]*)\.vo$/) todo = todo " " file
      while (todo != "") {
        n = split(todo, queue, " "); todo = ""
        for (i = 1; i <= n; i++) if (!(queue[i] in seen)) { seen[queue[i]] = 1; todo = todo " " edges[queue[i]] }
      }
      for (file in all) if (!(file in seen)) { sub(/^\.\//, "", file); sub(/\.vo$/, ".v", file)
        print "proofs/" file ": neither Main.v nor an Instances*.v depends on it"; bad = 1 }
      exit bad }'
}

# The theorems of Main.v, in its order, each as FILE.NAME. MainText.v comes first, Main.v last.
theorems() {
  for file in $(printf '%s\n' "$proofs"/Main*.v | sort -r); do
    sentences "$file" | sed -n 's/^.*\/\(Main[A-Za-z]*\)\.v:[0-9]*:Theorem \([A-Za-z0-9_]*\).*/\1.\2/p'
  done
}

# ask FILE: Coq's answers to the commands of that file, with Main.v loaded and nothing imported: then a name is printed
# with its file, whatever notations and coercions say.
ask() {
  { echo 'From Durero Require Main.'
    echo 'Unset Printing Notations. Set Printing Coercions. Set Printing Width 120. Set Printing Depth 1000000.'
    cat "$1"
  } >"$tmp/asked.v"
  (cd "$build" && coqc -q -Q . Durero "$tmp/asked.v")
}

# The files of instances, Instances*.v, as modules.
of_instances() { (cd "$proofs" && printf '%s\n' Instances*.v) | sed 's/\.v$//' | tr '\n' ' '; }

# axioms_of BEFORE NAME...: of each name one line, the name and the axioms that it rests on, sorted. Coq reads the file
# BEFORE first.
axioms_of() {
  cat "$1" >"$tmp/questions"
  shift
  for name; do echo "Redirect \"$tmp/$name\" Print Assumptions $name."; done >>"$tmp/questions"
  ask "$tmp/questions" >&2 || return 1
  for name; do  # an axiom begins its line; its type is indented, or follows a colon
    found=$(sed -n 's/^Closed under the global context$/none/; /^Axioms:$/d; s/ *:.*//; /^[^ ]/p' \
      "$tmp/$name.out" | sort -u | tr '\n' ' ')
    [ -n "$found" ] || { echo "Main.v: no assumptions found of $name" >&2; return 1; }
    echo "$name: ${found% }"
  done
}

# axioms_of_each NAMES: the same of the names in that file, those of instances too.
axioms_of_each() {
  echo "From Durero Require $(of_instances)." >"$tmp/before.v"
  # shellcheck disable=SC2046  # a word a name
  axioms_of "$tmp/before.v" $(cat "$1")
}

# One line a theorem of Main.v: its name and the axioms that it rests on.
assumptions() {
  theorems >"$tmp/all"
  axioms_of_each "$tmp/all" | sed 's/^[^.]*\.//'
}

# Of lines of axioms_of: FILE.NAME: AXIOM where that is no axiom of the classical reals. Coq prints the last two parts of a
# name; `kernel` has the full ones.
other_axioms() {
  printf '%s\n' "$allowed" none | sed 's/.*\.\([^.]*\.[^.]*\)$/\1/' >"$tmp/allowed"
  awk 'FNR == NR { allowed[$0] = 1; next } { for (i = 2; i <= NF; ++i) if (!($i in allowed)) print $1, $i }' "$tmp/allowed" "$1"
}

audit_assumptions() {
  assumptions >"$tmp/now"
  [ -s "$tmp/now" ] || { echo "Main.v states no theorem"; return 1; }
  other_axioms "$tmp/now" >"$tmp/others"
  if [ -s "$tmp/others" ]; then cat "$tmp/others"; echo 'these are not axioms of the classical reals'; return 1; fi
  diff -u "$proofs/assumptions.txt" "$tmp/now" || { echo 'assumptions.txt does not say what Main.v rests on'; return 1; }
}

# What Coq says of each theorem of Main.v, and then, round by round, of what was named in the round before: sections are
# closed, so that their hypotheses show. A block begins with the full name; that of a theorem is followed by one with its
# proof; the last one has the full names of what Coq's libraries define.
answers() {
  own=$(cd "$proofs" && printf '%s\n' ./*.v | sed 's|^\./||; s|\.v$||' | tr '\n' '|')
  theorems >"$tmp/new"
  : >"$tmp/known"
  round=0
  while [ -s "$tmp/new" ]; do
    round=$((round + 1))
    awk -v out="$tmp/$round" '{ say = $0 ~ /^(Durero\.)?Main[A-Za-z]*\./ ? "Check @" : "Print "
      printf "Redirect \"%s.%04d.is\" About %s.\nRedirect \"%s.%04d.says\" %s%s.\n", out, NR, $0, out, NR, say, $0
      printf "Redirect \"%s.%04d.type\" Check @%s.\n", out, NR, $0
      if (say != "Print ") printf "Redirect \"%s.%04d.says.proof\" Print %s.\n", out, NR, $0 }' "$tmp/new" >"$tmp/questions"
    ask "$tmp/questions" >&2 || return 1
    # Of a proof that a definition carries nothing matters but what it proves: no other proof can look into it.
    for is in "$tmp/$round".*.is.out; do
      if grep -q ' is opaque$' "$is"; then mv "${is%.is.out}.type.out" "${is%.is.out}.says.out"; fi
    done
    cat "$tmp/new" >>"$tmp/known"
    # What Coq says of a definition's arguments is left out, up to a blank line or the end of the answer.
    awk 'FNR == 1 { skip = 0 } /^Arguments / { skip = 1 } /^$/ { skip = 0 } !skip' "$tmp/$round".*.says.out >"$tmp/said"
    grep -oE "[A-Za-z_][A-Za-z0-9_']*(\.[A-Za-z_][A-Za-z0-9_']*)+" "$tmp/said" | sort -u >"$tmp/names.$round"
    grep -E "^(Durero\.)?(${own%|})\." "$tmp/names.$round" | grep -vxFf "$tmp/known" >"$tmp/new" || true
  done
  cat "$tmp"/names.* | sort -u | grep -vxFf "$tmp/known" | sed "s|.*|About &.|" >"$tmp/questions" || true
  ask "$tmp/questions" >"$tmp/libraries" || return 1
  awk '
    FILENAME ~ /\.is\.out$/ { if (sub(/^Expands to: /, "")) full = $0; next }
    FNR == 1 && FILENAME ~ /\.proof\.out$/ { skip = 0; sub(/^[A-Za-z]*/, "Proof", full); print "[" full "]" }
    FNR == 1 && FILENAME ~ /\.says\.out$/ { if (full ~ /^Constructor /) skip = 2; else { skip = 0; print "[" full "]" } }  # its type is printed
    /^Arguments / { if (!skip) skip = 1 } /^$/ { if (skip == 1) skip = 0; next }
    !skip' $(printf '%s\n' "$tmp"/*.out | grep -E '/[0-9]+\.[0-9]+\.(is|says|says\.proof)\.out$')
  echo '[the libraries]'
  sed -n 's/^Expands to: //p' "$tmp/libraries" | sort -u
}

# The same as a page for a person.
statements() { answers >"$tmp/answers" && python3 "$here/page.py" "$build" <"$tmp/answers"; }

audit_statements() {
  statements >"$tmp/now" || return 1
  diff -u "$proofs/statements.md" "$tmp/now" || {
    echo 'statements.md does not say what Main.v states; if it should, sh tests/proofs/run.sh build/proofs update'
    return 1
  }
}

# What has a premise: after a theorem's name, one line for each. A binder of which the type is a proposition is one, also
# behind a variable or a name for a term.
heads='Ltac heads := lazymatch goal with
  | |- forall x : ?A, _ => (lazymatch type of A with Prop => idtac "premise" | _ => idtac end); let y := fresh in intro y; heads
  | |- let x := _ in _ => let y := fresh in intro y; heads
  | |- _ => idtac end.'
premises() {  # NAMES: the file of names; each that has a premise
  { echo "From Durero Require $(of_instances)."; echo "$heads"
    sed 's/.*/Goal ltac:(let T := type of Durero.& in exact T). idtac "of" "&". heads. Abort./' "$1"; } >"$tmp/questions"
  ask "$tmp/questions" >"$tmp/premises" || return 1
  awk '$1 == "of" { name = $2 } $1 == "premise" && !seen[name]++ { print name }' "$tmp/premises"
}

audit_instances() {
  files=$(printf '%s\n' "$proofs"/Instance*.v)
  theorems >"$tmp/theorems"
  premises "$tmp/theorems" >"$tmp/asked" || return 1
  sentences $files | sed -n 's/^.*\/\(Instance[A-Za-z]*\)\.v:[0-9]*:\(Theorem\|Lemma\|Definition\|Fixpoint\) \([A-Za-z0-9_]*\).*/\1.\3/p' >"$tmp/there"
  grep '\.instance_of_' "$tmp/there" >"$tmp/instances" || true
  # Each theorem with premises has one instance, and nothing else has any.
  sed 's/.*\.//' "$tmp/asked" | sort >"$tmp/needed"
  sed 's/.*\.instance_of_//' "$tmp/instances" | sort >"$tmp/with"
  diff "$tmp/needed" "$tmp/with" | sed -n 's/^< \(.*\)/\1: a theorem with premises and no instance/p
    s/^> \(.*\)/\1: twice, or no theorem with premises/p' >"$tmp/wrong"
  # An instance has no premise, and rests on its theorem and on no other axioms than a theorem may.
  premises "$tmp/instances" | sed 's/$/: an instance with a premise/' >>"$tmp/wrong"
  # All are asked at once, which is quicker; one by one only where something is wrong.
  { echo "From Durero Require $(of_instances)."; echo 'Definition every : True :='
    sed 's/.*/  let _ := @Durero.& in/' "$tmp/instances"; echo '  I.'; } >"$tmp/every.v"
  axioms_of "$tmp/every.v" every >"$tmp/axioms" || return 1
  other_axioms "$tmp/axioms" >"$tmp/others"
  if [ -s "$tmp/others" ]; then
    axioms_of_each "$tmp/instances" >"$tmp/axioms" || return 1
    other_axioms "$tmp/axioms" | sed 's/$/: an instance rests on no such axiom/' >>"$tmp/wrong"
  fi
  { echo "From Durero Require $(of_instances)."
    sed "s|.*|Redirect \"$tmp/body.&\" Print Durero.&.|" "$tmp/there"; } >"$tmp/questions"
  ask "$tmp/questions" >"$tmp/log" 2>&1 || { cat "$tmp/log"; return 1; }
  while read -r instance; do
    name=${instance#*.instance_of_} todo=$instance seen=
    theorem=$(grep "\.$name\$" "$tmp/theorems") || continue
    while [ -n "$todo" ]; do
      bodies=$(printf "$tmp/body.%s.out " $todo) seen="$seen $todo"
      if grep -qwF "$theorem" $bodies; then break; fi
      todo=$(grep -ohE 'Instance[A-Za-z]*\.[A-Za-z0-9_]+' $bodies | sort -u | grep -xFf "$tmp/there" |
        grep -vxF "$(printf '%s\n' $seen)" | tr '\n' ' ') || true
    done
    [ -n "$todo" ] || echo "$instance: does not rest on $theorem" >>"$tmp/wrong"
  done <"$tmp/instances"
  if [ -s "$tmp/wrong" ]; then cat "$tmp/wrong"; return 1; fi
}

audit_kernel() {
  coqchk -silent -o -Q "$build" Durero Durero.Main $(of_instances | sed 's/[^ ][^ ]*/Durero.&/g') >"$tmp/chk" 2>&1 || { cat "$tmp/chk"; return 1; }
  sed -n '/^\* Axioms:/,/^\* Constants/p' "$tmp/chk" | sed -n 's/^    *//p' >"$tmp/axioms"
  if printf '%s\n' "$allowed" | grep -vxFf - "$tmp/axioms"; then echo 'coqchk finds these other axioms'; return 1; fi
  [ "$(grep -v '^\* Axioms:' "$tmp/chk" | grep -c ': <none>$')" = 3 ] || { cat "$tmp/chk"; return 1; }
}

case $check in
  text | reachable | assumptions | statements | instances | kernel) "audit_$check" ;;
  update)
    assumptions >"$tmp/assumptions" && statements >"$tmp/statements"
    cp "$tmp/assumptions" "$proofs/assumptions.txt" && cp "$tmp/statements" "$proofs/statements.md" ;;
  daily) audit_text && audit_reachable && audit_assumptions && audit_statements && audit_instances ;;
  all) sh "$0" daily "$proofs" "$build" && audit_kernel ;;
  *) echo "audit.sh does not know $check"; exit 2 ;;
esac
