#!/bin/sh
# Proofs that a reader can follow and another Coq can repeat: a file has 500 lines at most, but for those that a program
# writes; and a step in nonlinear arithmetic names the products that it needs. The tactic that guesses them (nra, nia) is
# left where a number below says how often it still is: the numbers only fall.
set -u
left='Luz 1
Quadratic 1
Surd 4'
for file in proofs/*.v; do
  stem=${file#proofs/} stem=${stem%.v}
  case $stem in Especificacion | Formas) continue ;; esac  # written by durero spec export and by tests/proofs/formas.cpp
  lines=$(wc -l <"$file")
  [ "$lines" -le 500 ] || echo "$file:1: $lines lines; 500 at most"
  guesses=$(grep -cwE 'nra|nia' "$file")
  allowed=$(echo "$left" | sed -n "s/^$stem //p")
  [ "$guesses" -le "${allowed:-0}" ] || echo "$file:1: nra or nia in $guesses lines; ${allowed:-0} at most: name the products"
  [ "$guesses" -ge "${allowed:-0}" ] || echo "$file:1: nra or nia in $guesses lines; write so in tests/lint/proofs.sh"
done | { ! grep .; }
