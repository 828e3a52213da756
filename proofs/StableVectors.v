(** * StableVectors: what is computed in double-double of ordinary numbers and vectors

    Numbers as they stand and differences of two are exact; the product of such a vector along an axis is within three
    operations of the exact one. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Durero Require Import Rounding Vectors Flotante Twofold Words.
From Durero Require Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

Lemma word_of r : ordinary r -> 0 < r -> worded 0 (-152) (exactly r) r r.
Proof. intros Hr Pos; destruct (ordinary_grid r Hr); rewrite <- (Rabs_pos_eq r) at 3 by lra; now apply worded_exactly. Qed.

Lemma words_of a : ordinary_vec a -> words_close 0 (-152) (exactly2 a) a.
Proof. intros Ha; now apply words_exactly, ordinary_on_grid. Qed.

Lemma words_between a b : ordinary_vec a -> ordinary_vec b -> words_close 0 (-152) (minus2 a b) (minus a b).
Proof. intros Ha Hb; apply words_minus; [lia | now apply ordinary_on_grid..]. Qed.

Lemma worded_along d a x : ordinary_vec d -> words_close 0 (-152) a x ->
  worded 3 (-304) (dot2 a (exactly2 d)) (dot x d) (size_of_dot x d).
Proof. intros Hd Ha; exact (dot2_worded 0 0 (-152) (-152) _ _ _ _ ltac:(lia) Ha (words_of d Hd)). Qed.
