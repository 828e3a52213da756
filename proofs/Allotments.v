(** Allotments of quadrics: every choice of sides that keeps to the values of a point and to multiples is a part of one
    (spec/solidos.tex).

    lead c                == the first coefficient of a quadric other than 0
    goes_along v          == v is a value for every quadric, multiplied where the quadric is
    may_be_chosen v cs P  == sides P for the quadrics cs that keep to the values v and to multiples
    extended v cs P       == the allotment that has them *)
From Coq Require Import Reals Lra Classical.
From Durero Require Import Toolkit Especificacion.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** The first coefficient other than 0: it goes along with multiples. *)
Definition first_of (x y : R) : R := if Req_EM_T x 0 then y else x.
Definition lead (c : Cuadrica) : R :=
  first_of (Cuadrica_xx c) (first_of (Cuadrica_yy c) (first_of (Cuadrica_zz c) (first_of (Cuadrica_yz c)
  (first_of (Cuadrica_zx c) (first_of (Cuadrica_xy c) (first_of (Cuadrica_x c) (first_of (Cuadrica_y c)
  (first_of (Cuadrica_z c) (Cuadrica_uno c))))))))).

Lemma first_of_multiples k x y x' y' : k <> 0 -> x = k * x' -> y = k * y' -> first_of x y = k * first_of x' y'.
Proof.
  intros Hk -> ->. unfold first_of. destruct (Req_EM_T x' 0) as [-> | N], (Req_EM_T (k * _) 0) as [E | E]; auto.
  - exfalso. apply E. ring.
  - exfalso. apply Rmult_integral in E as [E | E]; auto.
Qed.

Lemma coefficients_of_multiples a b k : multiplo a b k -> k <> 0 /\
  Cuadrica_xx a = k * Cuadrica_xx b /\ Cuadrica_yy a = k * Cuadrica_yy b /\ Cuadrica_zz a = k * Cuadrica_zz b /\
  Cuadrica_yz a = k * Cuadrica_yz b /\ Cuadrica_zx a = k * Cuadrica_zx b /\ Cuadrica_xy a = k * Cuadrica_xy b /\
  Cuadrica_x a = k * Cuadrica_x b /\ Cuadrica_y a = k * Cuadrica_y b /\ Cuadrica_z a = k * Cuadrica_z b /\
  Cuadrica_uno a = k * Cuadrica_uno b.
Proof. unfold multiplo. tauto. Qed.
Ltac multiple H :=
  apply coefficients_of_multiples in H as [Hk [Exx [Eyy [Ezz [Eyz [Ezx [Exy [Ex [Ey [Ez Euno]]]]]]]]]].

Lemma lead_of_multiples a b k : multiplo a b k -> lead a = k * lead b.
Proof. intros H. multiple H. unfold lead. repeat (apply first_of_multiples; [exact Hk | assumption |]). assumption. Qed.

Lemma lead_nonzero c : c ∈ Cuadrica_ok -> lead c <> 0.
Proof.
  intros [H] E. apply H. unfold lead, first_of in E.
  repeat match type of E with context [Req_EM_T ?x 0] => destruct (Req_EM_T x 0); [| contradiction] end.
  repeat (split; [assumption |]). exact E.
Qed.

Lemma valor_of_multiples a b k w : multiplo a b k -> valor a w = k * valor b w.
Proof.
  intros H. multiple H. unfold valor. rewrite Exx, Eyy, Ezz, Eyz, Ezx, Exy, Ex, Ey, Ez, Euno. ring.
Qed.

Lemma multiple_nonzero a b k : multiplo a b k -> k <> 0.
Proof. intros H. multiple H. exact Hk. Qed.

Lemma multiple_of_itself c : c ∈ Cuadrica_ok -> multiplo c c 1.
Proof. intros H. unfold multiplo. repeat (split; [exact H |]). repeat split; try lra. Qed.

Lemma multiple_back a b k : a ∈ Cuadrica_ok -> b ∈ Cuadrica_ok -> multiplo a b k -> multiplo b a (/ k).
Proof.
  intros Ha Hb H. multiple H. unfold multiplo. rewrite Exx, Eyy, Ezz, Eyz, Ezx, Exy, Ex, Ey, Ez, Euno.
  repeat (split; [assumption |]). split; [now apply Rinv_neq_0_compat |]. repeat split; field; exact Hk.
Qed.

Lemma multiple_through a b c j k : a ∈ Cuadrica_ok -> c ∈ Cuadrica_ok ->
  multiplo a b j -> multiplo b c k -> multiplo a c (j * k).
Proof.
  intros Ha Hc H H'. pose proof (multiple_nonzero _ _ _ H) as J. pose proof (multiple_nonzero _ _ _ H') as K.
  multiple H. unfold multiplo. rewrite Exx, Eyy, Ezz, Eyz, Ezx, Exy, Ex, Ey, Ez, Euno.
  clear - Ha Hc J K H'. multiple H'. rewrite Exx, Eyy, Ezz, Eyz, Ezx, Exy, Ex, Ey, Ez, Euno.
  repeat (split; [assumption |]). split; [intros E; apply Rmult_integral in E; tauto |]. repeat split; ring.
Qed.

(** Values for all quadrics, those of multiples with them: the values at a point, or what a ray sees. *)
Definition goes_along (v : Cuadrica -> R) : Prop :=
  forall a b k, a ∈ Cuadrica_ok -> b ∈ Cuadrica_ok -> multiplo a b k -> v a = k * v b.
Definition below (v : Cuadrica -> R) : set Cuadrica := fun c => c ∈ Cuadrica_ok /\ v c < 0.
Definition above (v : Cuadrica -> R) : set Cuadrica := fun c => c ∈ Cuadrica_ok /\ v c > 0.

(** Every choice of sides for some quadrics that keeps to the values and to multiples is a part of an allotment. *)
Definition may_be_chosen (v : Cuadrica -> R) (cs P : set Cuadrica) : Prop :=
  cs ⊆ Cuadrica_ok /\ (forall c, c ∈ cs -> (v c < 0 -> c ∈ P) /\ (v c > 0 -> c ∉ P)) /\
  (forall a b k, a ∈ cs -> b ∈ cs -> multiplo a b k -> (k > 0 -> (a ∈ P <-> b ∈ P)) /\ (k < 0 -> (a ∈ P <-> b ∉ P))).

Definition chosen (cs P : set Cuadrica) : set Cuadrica := fun c =>
  exists b k, b ∈ cs /\ multiplo c b k /\ (k > 0 /\ b ∈ P \/ k < 0 /\ b ∉ P).
Definition is_bound (cs : set Cuadrica) (c : Cuadrica) : Prop := exists b k, b ∈ cs /\ multiplo c b k.
Definition extended (v : Cuadrica -> R) (cs P : set Cuadrica) : set Cuadrica := fun c => c ∈ Cuadrica_ok /\
  (c ∈ chosen cs P \/ ~ is_bound cs c /\ (v c < 0 \/ v c = 0 /\ lead c < 0)).

Lemma bound_multiples cs a b k : a ∈ Cuadrica_ok -> b ∈ Cuadrica_ok -> cs ⊆ Cuadrica_ok ->
  multiplo a b k -> is_bound cs b -> is_bound cs a.
Proof. intros Ha Hb Hcs H [d [j [Hd Hj]]]. exists d, (k * j). split; [exact Hd |]. eapply multiple_through; eauto. Qed.

(** Which side a bound quadric is on does not depend on what binds it. *)
Lemma chosen_by v cs P a b k : may_be_chosen v cs P -> a ∈ Cuadrica_ok -> b ∈ cs -> multiplo a b k ->
  (a ∈ chosen cs P <-> (k > 0 /\ b ∈ P \/ k < 0 /\ b ∉ P)).
Proof.
  intros [Hcs [_ M]] Ha Hb H. split; [| now exists b, k].
  intros [d [j [Hd [Hj C]]]].
  assert (D : multiplo d b (/ j * k)) by (eapply multiple_through; eauto using multiple_back).
  specialize (M d b _ Hd Hb D) as [Mp Mn].
  pose proof (multiple_nonzero _ _ _ H) as K. pose proof (multiple_nonzero _ _ _ Hj) as J.
  assert (Jp : j > 0 -> / j > 0) by (intros; now apply Rinv_0_lt_compat).
  assert (Jn : j < 0 -> / j < 0) by (intros; now apply Rinv_lt_0_compat).
  assert (Pp : forall x y, x > 0 -> y > 0 -> x * y > 0) by (intros; now apply Rmult_lt_0_compat).
  assert (Pn : forall x y, x > 0 -> y < 0 -> x * y < 0).
  { intros x y Hx Hy. pose proof (Rmult_lt_0_compat x (- y)). lra. }
  assert (Np : forall x y, x < 0 -> y > 0 -> x * y < 0) by (intros x y Hx Hy; rewrite Rmult_comm; now apply Pn).
  assert (Nn : forall x y, x < 0 -> y < 0 -> x * y > 0).
  { intros x y Hx Hy. pose proof (Rmult_lt_0_compat (- x) (- y)). lra. }
  destruct (Rtotal_order k 0) as [Hk | [Hk | Hk]], C as [[Hj0 C] | [Hj0 C]]; try contradiction.
  - right. split; [exact Hk |]. apply Mn; auto.
  - right. split; [exact Hk |]. intros Hb'. apply C, Mp; auto.
  - left. split; [exact Hk |]. apply Mp; auto.
  - left. split; [exact Hk |]. apply NNPP. intros Hb'. apply C, Mn; auto.
Qed.

Lemma extended_multiples v cs P a b k : goes_along v -> may_be_chosen v cs P -> a ∈ Cuadrica_ok -> b ∈ Cuadrica_ok ->
  multiplo a b k -> (k > 0 -> (a ∈ extended v cs P <-> b ∈ extended v cs P))
                    /\ (k < 0 -> (a ∈ extended v cs P <-> b ∉ extended v cs P)).
Proof.
  intros Hv Hc Ha Hb H. pose proof (multiple_nonzero _ _ _ H) as K. pose proof Hc as [Hcs _].
  destruct (classic (is_bound cs b)) as [B | B].
  - pose proof (bound_multiples _ _ _ _ Ha Hb Hcs H B) as B'. destruct B as [d [j [Hd Hj]]].
    pose proof (multiple_nonzero _ _ _ Hj) as J.
    assert (Q : multiplo a d (k * j)) by (eapply multiple_through; eauto).
    assert (Ea : a ∈ extended v cs P <-> k * j > 0 /\ d ∈ P \/ k * j < 0 /\ d ∉ P).
    { rewrite <- (chosen_by v cs P a d _ Hc Ha Hd Q). unfold extended. split; [tauto | now split; [| left]]. }
    assert (Eb : b ∈ extended v cs P <-> j > 0 /\ d ∈ P \/ j < 0 /\ d ∉ P).
    { rewrite <- (chosen_by v cs P b d _ Hc Hb Hd Hj). unfold extended. split; [| now split; [| left]].
      intros [_ [C | [N _]]]; [exact C |]. exfalso. apply N. now exists d, j. }
    rewrite Ea, Eb. destruct (classic (d ∈ P)) as [HP | HP].
    + split; intros Hk; destruct (Rtotal_order j 0) as [Hj0 | [Hj0 | Hj0]]; try contradiction.
      * pose proof (Rmult_lt_0_compat k (- j)). intuition lra.
      * pose proof (Rmult_lt_0_compat k j). intuition lra.
      * pose proof (Rmult_lt_0_compat (- k) (- j)). intuition lra.
      * pose proof (Rmult_lt_0_compat (- k) j). intuition lra.
    + split; intros Hk; destruct (Rtotal_order j 0) as [Hj0 | [Hj0 | Hj0]]; try contradiction.
      * pose proof (Rmult_lt_0_compat k (- j)). intuition lra.
      * pose proof (Rmult_lt_0_compat k j). intuition lra.
      * pose proof (Rmult_lt_0_compat (- k) (- j)). intuition lra.
      * pose proof (Rmult_lt_0_compat (- k) j). intuition lra.
  - assert (B' : ~ is_bound cs a).
    { intros B'. apply B. exact (bound_multiples _ _ _ _ Hb Ha Hcs (multiple_back _ _ _ Ha Hb H) B'). }
    assert (Free : forall c, c ∈ Cuadrica_ok -> ~ is_bound cs c ->
              (c ∈ extended v cs P <-> v c < 0 \/ v c = 0 /\ lead c < 0)).
    { intros c Hok N. unfold extended. split; [| tauto]. intros [_ [[d [j [Hd [Hj _]]]] | [_ C]]]; [| exact C].
      exfalso. apply N. now exists d, j. }
    rewrite (Free a Ha B'), (Free b Hb B). rewrite (Hv a b k Ha Hb H), (lead_of_multiples _ _ _ H).
    pose proof (lead_nonzero _ Hb) as L.
    assert (Z : k * v b = 0 <-> v b = 0) by (split; [intros E; apply Rmult_integral in E; tauto | intros ->; ring]).
    rewrite Z. clear Z Free. generalize dependent (lead b). generalize (v b). intros x y L. split; intros Hk.
    + assert (S : forall z, k * z < 0 <-> z < 0).
      { intros z. pose proof (Rmult_lt_0_compat k z). pose proof (Rmult_lt_0_compat k (- z)).
        destruct (Rtotal_order z 0) as [? | [-> | ?]]; split; lra. }
      rewrite !S. tauto.
    + assert (S : forall z, k * z < 0 <-> z > 0).
      { intros z. pose proof (Rmult_lt_0_compat (- k) z). pose proof (Rmult_lt_0_compat (- k) (- z)).
        destruct (Rtotal_order z 0) as [? | [-> | ?]]; split; lra. }
      rewrite !S. destruct (Rtotal_order x 0) as [? | [-> | ?]], (Rtotal_order y 0) as [? | [-> | ?]];
        split; intros; try tauto; lra.
Qed.

Lemma extension v cs P : goes_along v -> may_be_chosen v cs P ->
  exists l, l ∈ repartos (below v) (above v) /\ forall c, c ∈ cs -> (c ∈ l <-> c ∈ P).
Proof.
  intros Hv Hc. exists (extended v cs P). pose proof Hc as [Hcs [Side M]].
  assert (On : forall c, c ∈ cs -> (c ∈ extended v cs P <-> c ∈ P)).
  { intros c H. pose proof (Hcs c H) as Hok. pose proof (multiple_of_itself c Hok) as One.
    pose proof (chosen_by v cs P c c 1 Hc Hok H One) as C. unfold extended. split.
    - intros [_ [D | [N _]]]; [apply C in D; destruct D as [[_ D] | [D _]]; [exact D | lra] |].
      exfalso. apply N. now exists c, 1.
    - intros HP. split; [exact Hok | left]. apply C. left. split; [lra | exact HP]. }
  assert (Neg : forall c, c ∈ Cuadrica_ok -> is_bound cs c -> exists b k, b ∈ cs /\ multiplo c b k) by (intros ? ? B; exact B).
  split; [| exact On]. unfold repartos. split; [intros c [H _]; exact H |]. split; [| split].
  - intros c [Hok Hlt]. split; [exact Hok |].
    destruct (classic (is_bound cs c)) as [[b [k [Hb H]]] | N]; [left | now right; split; [| left]].
    pose proof (Hcs b Hb) as Hbok. rewrite (Hv c b k Hok Hbok H) in Hlt. exists b, k. split; [exact Hb | split; [exact H |]].
    destruct (Side b Hb) as [Sn Sp]. destruct (Rtotal_order k 0) as [Hk | [Hk | Hk]].
    + right. split; [exact Hk | apply Sp]. destruct (Rtotal_order (v b) 0) as [E | [E | E]]; [| rewrite E in Hlt; lra | exact E].
      pose proof (Rmult_lt_0_compat (- k) (- v b)). lra.
    + subst k. lra.
    + left. split; [exact Hk | apply Sn]. destruct (Rtotal_order (v b) 0) as [E | [E | E]]; [exact E | rewrite E in Hlt; lra |].
      pose proof (Rmult_lt_0_compat k (v b)). lra.
  - intros c [Hok Hgt] [_ [[b [k [Hb [H C]]]] | [_ [E | [E _]]]]]; [| lra | lra].
    pose proof (Hcs b Hb) as Hbok. rewrite (Hv c b k Hok Hbok H) in Hgt. destruct (Side b Hb) as [Sn Sp].
    destruct C as [[Hk C] | [Hk C]].
    + apply (Sp); [| exact C]. destruct (Rtotal_order (v b) 0) as [E | [E | E]]; [| rewrite E in Hgt; lra | exact E].
      pose proof (Rmult_lt_0_compat k (- v b)). lra.
    + apply C, Sn. destruct (Rtotal_order (v b) 0) as [E | [E | E]]; [exact E | rewrite E in Hgt; lra |].
      pose proof (Rmult_lt_0_compat (- k) (v b)). lra.
  - intros a b k Ha Hb H. now apply extended_multiples.
Qed.

Lemma values_go_along w : goes_along (fun c => valor c w).
Proof. intros a b k _ _ H. now apply valor_of_multiples. Qed.

Lemma at_point w cs P : may_be_chosen (fun c => valor c w) cs P ->
  exists l, l ∈ repartos (dentro w) (fuera w) /\ forall c, c ∈ cs -> (c ∈ l <-> c ∈ P).
Proof. intros H. exact (extension _ _ _ (values_go_along w) H). Qed.

Lemma an_allotment w : exists l, l ∈ repartos (dentro w) (fuera w).
Proof.
  destruct (at_point w ∅ ∅) as [l [H _]]; [| now exists l].
  split; [easy | split; [easy |]]. intros a b k Ha. destruct Ha.
Qed.
