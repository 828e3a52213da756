(* The late coin is a backward simulation of the coin: each obligation that spec refine writes is a theorem. *)
From Export Require Import backward.

Ltac opened := unfold AbsCoin, InitCoin1, InitCoin, Look1, Look, Toss1, Toss, Coin, Coin1, z_in, z_all in *.

Goal obligation_AbsCoin_conj_1.
Proof.
  intros tossed _. destruct tossed; [exists empty | exists (covers heads)]; opened; repeat split; easy.
Qed.

Goal obligation_InitCoin1_conj_1.
Proof.
  intros tossed hand [[_ Begun] [_ [_ Related]]]. split; [exact I |]. now apply Related.
Qed.

Goal obligation_Look1_conj_1.
Proof.
  intros tossed [_ May]. destruct tossed.
  - destruct (May empty) as [face [after [_ [_ [Impossible _]]]]]; [| discriminate]. opened; repeat split; easy.
  - exists heads, no. opened; repeat split.
Qed.

Goal obligation_Look1_conj_2.
Proof.
  intros face before after hand [[_ [_ [Tossed Over]]] [[_ [_ Related]] _]].
  exists (covers face). opened. rewrite Tossed. repeat split; try easy. now apply Related.
Qed.

Goal obligation_Toss1_conj_1.
Proof.
  intros tossed [_ May]. destruct tossed.
  - exists yes. opened; repeat split.
  - destruct (May (covers heads)) as [after [_ [Impossible _]]]; [| discriminate]. opened; repeat split; easy.
Qed.

Goal obligation_Toss1_conj_2.
Proof.
  intros before after hand [[_ [Ready Done]] [[_ [_ Related]] _]].
  exists empty. opened. rewrite Ready. repeat split; try easy.
  rewrite Done in Related. destruct hand as [| face]; [discriminate (proj2 Related eq_refl) |].
  destruct face; [now left | right; now left].
Qed.
