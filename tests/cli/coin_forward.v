(* The late coin is no forward simulation of the coin: spec refine has found the case, and Coq has it too. *)
From Export Require Import forward.

Goal ~ obligation_Look1_conj_2.
Proof.
  intros H. destruct (H (covers heads) yes tails no) as [after [_ [_ Looked]]].
  - unfold AbsCoin, Look1, Look, Coin, Coin1, z_in, z_all. repeat split; try easy. exists heads, empty. repeat split.
  - destruct Looked as [_ [_ [Different _]]]. discriminate.
Qed.
