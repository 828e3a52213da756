(** Extraction of the search's model to OCaml, as Extract.v does it: binary64 stays Flocq's, a sign, a significand and an
    exponent, so that no processor compares for the model. *)
From Coq Require Import ZArith Extraction ExtrOcamlBasic ExtrOcamlZBigInt.
From Flocq Require Import BinarySingleNaN.
From Durero Require Import Surd Quadratic Limits Search Occlusion.

Extract Inlined Constant Z.sgn => "(fun x -> Big_int_Z.big_int_of_int (Big_int_Z.sign_big_int x))".
Extraction "search.ml" Search.start Search.take Search.published Occlusion.blocks Occlusion.blocks_segment.
