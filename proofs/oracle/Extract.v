(** Extraction of Exacto and Nearest to OCaml, with Coq's Z as Zarith's big integers. What this adds to the trust is what
    ExtrOcamlZBigInt says: that Zarith's sums, products and comparisons are those of Z. *)
From Coq Require Import ZArith Extraction ExtrOcamlBasic ExtrOcamlZBigInt.
From Durero Require Import Surd Quadratic Exacto Nearest Chain.

Extract Inlined Constant Z.sgn => "(fun x -> Big_int_Z.big_int_of_int (Big_int_Z.sign_big_int x))".
Extraction "exacto.ml" first_hit exactly_printed bits.
