(** Means: what spec/distribuida.tex claims of the mean that a picture is, of a thin lens, of what moves, and of the estimate
    along some of the ways of light. *)
From Coq Require Import Reals Lra Lia ZArith.
From Durero Require Import Toolkit Especificacion Tipos Puntos Iluminacion Power Luz.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** ** Sums *)

(** A sum has one number more with each step. *)
Lemma one_more dada suma z : acumulado dada suma -> (0 <= z)%Z ->
  exists b c, (IZR z, b) ∈ suma /\ (IZR z, c) ∈ dada /\ (IZR (z + 1), b + c) ∈ suma.
Proof.
  intros [_ Next] Hz.
  destruct (Next (IZR z) (integer z)) as [a [b [c [Ha [Hb [Hc ->]]]]]]; [now apply Rle_ge, IZR_le |].
  exists b, c. rewrite plus_IZR. now repeat split.
Qed.

Lemma empty_sum dada suma : acumulado dada suma -> (0, 0) ∈ suma.
Proof. now intros [[v [H ->]] _]. Qed.

(** Induction up to the number of outcomes. *)
Lemma up_to (P : Z -> Prop) n : P 0%Z -> (forall z, (0 <= z < n)%Z -> P z -> P (z + 1)%Z) -> (0 <= n)%Z -> P n.
Proof.
  intros H0 Hn N. assert (H : forall z, (0 <= z)%Z -> (z <= n)%Z -> P z); [| now apply H].
  apply (natlike_ind (fun z => (z <= n)%Z -> P z)); [easy |]. intros z Hz IH Hle. apply Hn; [lia | apply IH; lia].
Qed.

Lemma below z n : (0 <= z < n)%Z -> 0 <= IZR z < IZR n.
Proof. intros [H0 H1]. split; [now apply IZR_le | now apply IZR_lt]. Qed.

(** The number of outcomes. *)
Lemma outcomes s : s ∈ Sorteo_ok -> exists n, Sorteo_n s = IZR n /\ (1 <= n)%Z.
Proof.
  intros [[n Hn] _ H1 _ _]. exists n. split; [exact Hn |]. apply le_IZR. rewrite <- Hn. lra.
Qed.

(** ** The mean *)

(** The sum of the first numbers of a sequence. *)
Fixpoint first_ones (d : rel R R) (n : nat) : set R := fun y =>
  match n with
  | O => y = 0
  | S k => exists b c, first_ones d k b /\ (IZR (Z.of_nat k), c) ∈ d /\ y = b + c
  end.
Definition sums (d : rel R R) : rel R R := fun p => exists z, fst p = IZR z /\ first_ones d (Z.to_nat z) (snd p).

Lemma first_ones_are_one d n y y' : d ∈ integers ⟶ univ -> first_ones d n y -> first_ones d n y' -> y = y'.
Proof.
  intros Hd. revert y y'. induction n as [| n IH]; intros y y'; [cbn; congruence |].
  intros [b [c [Hb [Hc ->]]]] [b' [c' [Hb' [Hc' ->]]]].
  now rewrite (IH _ _ Hb Hb'), (one_value _ _ _ _ _ _ Hd Hc Hc').
Qed.

Lemma first_ones_exist d n : d ∈ integers ⟶ univ -> exists y, first_ones d n y.
Proof.
  intros Hd. induction n as [| n [b Hb]]; [now exists 0 |].
  destruct (value_of _ _ _ (IZR (Z.of_nat n)) Hd (integer _)) as [c [Hc _]]. exists (b + c). now exists b, c.
Qed.

Lemma sums_are_total d : d ∈ integers ⟶ univ -> sums d ∈ integers ⟶ univ.
Proof.
  intros Hd. split; [| split].
  - intros i y y' [z [E H]] [z' [E' H']]. cbn in *. subst i. apply eq_IZR in E'. subst z'.
    exact (first_ones_are_one _ _ _ _ Hd H H').
  - intros i. split.
    + intros [y [z [E _]]]. now exists z.
    + intros [z ->]. destruct (first_ones_exist d (Z.to_nat z) Hd) as [y Hy]. exists y. now exists z.
  - easy.
Qed.

Lemma sums_accumulate d : d ∈ integers ⟶ univ -> acumulado d (sums d).
Proof.
  intros Hd. split; [exists 0; split; [now exists 0%Z | reflexivity] |].
  intros i [z ->] Hz. apply Rge_le, le_IZR in Hz. destruct (Z_of_nat_complete z Hz) as [n ->].
  destruct (first_ones_exist d n Hd) as [b Hb].
  destruct (value_of _ _ _ (IZR (Z.of_nat n)) Hd (integer _)) as [c [Hc _]].
  exists (b + c), b, c. repeat split; try exact Hc.
  - exists (Z.of_nat (S n)). split; [rewrite Nat2Z.inj_succ, succ_IZR; reflexivity |]. rewrite Nat2Z.id. now exists b, c.
  - exists (Z.of_nat n). split; [reflexivity |]. now rewrite Nat2Z.id.
Qed.

(** The products of two sequences. *)
Definition products (p x : rel R R) : rel R R := fun q => exists a b, (fst q, a) ∈ p /\ (fst q, b) ∈ x /\ snd q = a * b.

Lemma products_are_total p x : p ∈ integers ⟶ univ -> x ∈ integers ⟶ univ -> products p x ∈ integers ⟶ univ.
Proof.
  intros Hp Hx. split; [| split].
  - intros i y y' [a [b [Ha [Hb E]]]] [a' [b' [Ha' [Hb' E']]]]. cbn in *.
    now rewrite E, E', (one_value _ _ _ _ _ _ Hp Ha Ha'), (one_value _ _ _ _ _ _ Hx Hb Hb').
  - intros i. split.
    + intros [y [a [b [Ha _]]]]. destruct Hp as [_ [D _]]. apply D. now exists a.
    + intros Hi. destruct (value_of _ _ _ i Hp Hi) as [a [Ha _]]. destruct (value_of _ _ _ i Hx Hi) as [b [Hb _]].
      exists (a * b). now exists a, b.
  - easy.
Qed.

Lemma a_mean_exists s x : s ∈ Sorteo_ok -> x ∈ integers ⟶ univ -> exists m, media s x m.
Proof.
  intros [Hn Hp _ _ _] Hx. pose proof (products_are_total _ _ Hp Hx) as Hd. pose proof (sums_are_total _ Hd) as Hs.
  destruct (value_of _ _ _ _ Hs Hn) as [m [Hm _]].
  exists m, (products (Sorteo_p s) x), (sums (products (Sorteo_p s) x)).
  split; [exact Hd | split; [exact Hs | split; [| split; [now apply sums_accumulate | now exists m]]]].
  intros i Hi. destruct (value_of _ _ _ i Hp Hi) as [a [Ha _]]. destruct (value_of _ _ _ i Hx Hi) as [b [Hb _]].
  exists (a * b), a, b. repeat split; try assumption. now exists a, b.
Qed.

Lemma no_two_means s x m k : s ∈ Sorteo_ok -> x ∈ integers ⟶ univ -> media s x m -> media s x k -> m = k.
Proof.
  intros Hs Hx [d [u [Hd [Hu [Ed [Su [v [Hv <-]]]]]]]] [d' [u' [Hd' [Hu' [Ed' [Su' [v' [Hv' <-]]]]]]]].
  destruct (outcomes s Hs) as [n [En Pn]]. destruct Hs as [_ Hp _ _ _]. rewrite En in Hv, Hv'.
  assert (H : exists w, (IZR n, w) ∈ u /\ (IZR n, w) ∈ u').
  { apply (up_to (fun z => exists w, (IZR z, w) ∈ u /\ (IZR z, w) ∈ u')); [| | lia].
    - exists 0. split; eapply empty_sum; eassumption.
    - intros z Hz [w [Hw Hw']].
      destruct (one_more _ _ _ Su (proj1 Hz)) as [b [c [Hb [Hc Hn]]]].
      destruct (one_more _ _ _ Su' (proj1 Hz)) as [b' [c' [Hb' [Hc' Hn']]]].
      destruct (Ed _ (integer z)) as [e [p1 [x1 [He [Hp1 [Hx1 ->]]]]]].
      destruct (Ed' _ (integer z)) as [e' [p2 [x2 [He' [Hp2 [Hx2 ->]]]]]].
      assert (E : c = c').
      { rewrite (one_value _ _ _ _ _ _ Hd Hc He), (one_value _ _ _ _ _ _ Hd' Hc' He'),
          (one_value _ _ _ _ _ _ Hp Hp1 Hp2), (one_value _ _ _ _ _ _ Hx Hx1 Hx2). reflexivity. }
      exists (b + c). split; [exact Hn |].
      now rewrite E, (one_value _ _ _ _ _ _ Hu Hb Hw), (one_value _ _ _ _ _ _ Hu' Hw' Hb'). }
  destruct H as [w [Hw Hw']].
  now rewrite (one_value _ _ _ _ _ _ Hu Hv Hw), (one_value _ _ _ _ _ _ Hu' Hv' Hw').
Qed.

(** Discharges media.def.1, media.conj.1. *)
Theorem the_mean_is_one : media_conj_1.
Proof.
  intros s x Hs Hx. destruct (a_mean_exists s x Hs Hx) as [m Hm]. exists m. split; [exact Hm |].
  intros k Hk. exact (no_two_means s x m k Hs Hx Hm Hk).
Qed.

(** The coin, a draw. *)
Definition always (x : R) : rel R R := fun p => integers (fst p) /\ snd p = x.
Definition coin := mk_Sorteo 2 (always (1 / 2)).

Lemma always_is_total x : always x ∈ integers ⟶ univ.
Proof.
  split; [| split; [| easy]].
  - intros i y y' [_ E] [_ E']. cbn in *. congruence.
  - intros i. split; [intros [y [H _]]; exact H | intros H; now exists x].
Qed.

Theorem a_coin_is_a_draw : coin ∈ Sorteo_ok.
Proof.
  split; cbn; [exact (integer 2) | apply always_is_total | lra | |].
  - intros i Hi _. exists (1 / 2). split; [now split | lra].
  - exists (sums (always (1 / 2))). pose proof (always_is_total (1 / 2)) as H.
    split; [now apply sums_are_total | split; [now apply sums_accumulate |]].
    exists 1. split; [| reflexivity]. exists 2%Z. split; [reflexivity |].
    exists (1 / 2), (1 / 2). split; [| split; [split; [apply integer | reflexivity] | cbn; lra]].
    exists 0, (1 / 2). split; [reflexivity | split; [split; [apply integer | reflexivity] | cbn; lra]].
Qed.

(** Discharges Sorteo.inv.1, Sorteo.inv.2, Sorteo.inv.3, media.conj.2. *)
Theorem the_mean_lies_between_the_bounds : media_conj_2.
Proof.
  intros s x m a b Hs Hx [d [u [Hd [Hu [Ed [Su [v [Hv <-]]]]]]]] Bounds.
  destruct (outcomes s Hs) as [n [En Pn]].
  destruct Hs as [_ Hp _ Hpos [chances [Hc [Sc [one [Hone ->]]]]]]. rewrite En in *.
  assert (H : exists w y, (IZR n, w) ∈ chances /\ (IZR n, y) ∈ u /\ a * w <= y <= b * w).
  { apply (up_to (fun z => exists w y, (IZR z, w) ∈ chances /\ (IZR z, y) ∈ u /\ a * w <= y <= b * w)); [| | lia].
    - exists 0, 0. repeat split; try lra; eapply empty_sum; eassumption.
    - intros z Hz [w [y [Hw [Hy B]]]].
      destruct (one_more _ _ _ Sc (proj1 Hz)) as [w' [p [Hw' [Hpz Hcn]]]].
      destruct (one_more _ _ _ Su (proj1 Hz)) as [y' [c [Hy' [Hcz Hun]]]].
      destruct (Ed _ (integer z)) as [e [p1 [x1 [He [Hp1 [Hx1 ->]]]]]].
      destruct (Bounds _ (integer z) (below _ _ Hz)) as [x2 [Hx2 [A B2]]].
      destruct (Hpos _ (integer z) (below _ _ Hz)) as [p2 [Hp2 P]].
      pose proof (one_value _ _ _ _ _ _ Hd Hcz He) as E. subst c.
      pose proof (one_value _ _ _ _ _ _ Hp Hp1 Hpz) as E. subst p1.
      pose proof (one_value _ _ _ _ _ _ Hp Hp2 Hpz) as E. subst p2.
      pose proof (one_value _ _ _ _ _ _ Hx Hx1 Hx2) as E. subst x1.
      pose proof (one_value _ _ _ _ _ _ Hc Hw' Hw) as E. subst w'.
      pose proof (one_value _ _ _ _ _ _ Hu Hy' Hy) as E. subst y'.
      exists (w + p), (y + p * x2). repeat split; [exact Hcn | exact Hun | |].
      + assert (a * p <= x2 * p) by (apply Rmult_le_compat_r; lra). lra.
      + assert (x2 * p <= b * p) by (apply Rmult_le_compat_r; lra). lra. }
  destruct H as [w [y [Hw [Hy B]]]].
  pose proof (one_value _ _ _ _ _ _ Hc Hw Hone) as E. subst w.
  rewrite (one_value _ _ _ _ _ _ Hu Hv Hy). lra.
Qed.

(** Discharges de_luz_extensa.def.1, de_luz_extensa.conj.1. *)
Theorem points_of_one_place_are_a_light_without_a_size : de_luz_extensa_conj_1.
Proof.
  intros m n v s F f r Hm Hs HF Hf [x [Hx [Each Mean]]] One.
  assert (B : aportacion m n v f <= r <= aportacion m n v f); [| lra].
  apply (the_mean_lies_between_the_bounds s x r _ _ Hs Hx Mean). intros i Hi _.
  destruct (Each i Hi) as [y [g [Hy [Hg ->]]]]. destruct (One i Hi) as [h [Hh ->]].
  rewrite (one_value _ _ _ _ _ _ HF Hg Hh) in Hy. exists (aportacion m n v f). split; [exact Hy | lra].
Qed.

(** ** The lens *)

Lemma point_equality p q : Punto_x p = Punto_x q -> Punto_y p = Punto_y q -> Punto_z p = Punto_z q -> p = q.
Proof. destruct p, q. cbn. now intros -> -> ->. Qed.

(** A direction has one point in focus: its advance fixes how far it is gone. *)
Lemma one_point_in_focus l v f g : l ∈ Lente_ok -> punto_en_foco l v f -> punto_en_foco l v g -> f = g.
Proof.
  intros [_ _ Hfoco] [Af [t [Ht [Fx [Fy Fz]]]]] [Ag [u [Hu [Gx [Gy Gz]]]]].
  unfold Rmas in *. unfold avance in *. rewrite Fx, Fy, Fz in Af. rewrite Gx, Gy, Gz in Ag.
  set (e := Vector_x v * Vector_x (Lente_eje l) + Vector_y v * Vector_y (Lente_eje l) + Vector_z v * Vector_z (Lente_eje l)).
  assert (T : t * e = Lente_foco l) by (unfold e; lra). assert (U : u * e = Lente_foco l) by (unfold e; lra).
  assert (E : e <> 0) by (intros E; rewrite E in T; lra).
  assert (t = u) by (apply Rmult_eq_reg_r with e; [lra | exact E]). subst u.
  apply point_equality; congruence.
Qed.

(** Discharges Lente.inv.3, punto_en_foco.def.1, rayo_de_lente.def.1, rayo_de_lente.conj.1. *)
Theorem all_rays_of_a_direction_meet_in_focus : rayo_de_lente_conj_1.
Proof.
  intros l v r s Hl _ _ [_ [f [Hf Ff]]] [_ [g [Hg Gg]]]. exists f.
  rewrite (one_point_in_focus l v f g Hl Ff Gg) in *. now repeat split; [| | apply Gg].
Qed.

Lemma mayor_squared a b : mayor (a - b) (b - a) * mayor (a - b) (b - a) = (a - b) * (a - b).
Proof. unfold mayor. destruct (Rle_dec _ _); ring. Qed.

(** Discharges Lente.inv.1, Lente.inv.2, puntos_de_lente.def.1, visto_en_foco.def.1, circulo_de_confusion.def.1,
    circulo_de_confusion.conj.1. *)
Theorem nothing_is_seen_outside_its_circle : circulo_de_confusion_conj_1.
Proof.
  intros l q w u k z c Hl Hz Hc [_ Hq] Ez [_ [Ux [Uy Uz]]] [_ [Kx [Ky Kz]]] C. rewrite Ez in *.
  unfold Rmas, circulo_de_confusion, cuadrado in *.
  set (g := z - Lente_foco l). set (A := Lente_abertura l) in *.
  assert (Dx : z * (Punto_x u - Punto_x k) = g * (Punto_x q - Punto_x (Lente_ojo l))) by (unfold g; lra).
  assert (Dy : z * (Punto_y u - Punto_y k) = g * (Punto_y q - Punto_y (Lente_ojo l))) by (unfold g; lra).
  assert (Dz : z * (Punto_z u - Punto_z k) = g * (Punto_z q - Punto_z (Lente_ojo l))) by (unfold g; lra).
  assert (Cz : c * z * (c * z) = A * A * (g * g)).
  { rewrite C. unfold g. rewrite <- (mayor_squared z (Lente_foco l)). ring. }
  apply Rmult_le_reg_l with (z * z); [now apply Rmult_lt_0_compat |].
  replace (z * z * (c * c)) with (c * z * (c * z)) by ring. rewrite Cz.
  match goal with |- ?a <= _ => replace a with
    (4 * (z * (Punto_x u - Punto_x k) * (z * (Punto_x u - Punto_x k)) + z * (Punto_y u - Punto_y k) * (z * (Punto_y u - Punto_y k))
      + z * (Punto_z u - Punto_z k) * (z * (Punto_z u - Punto_z k)))) by ring end.
  rewrite Dx, Dy, Dz.
  match type of Hq with ?b <= _ => match goal with |- ?a <= _ => replace a with (b * (g * g)) by ring end end.
  apply Rmult_le_compat_r; [apply Rle_0_sqr | exact Hq].
Qed.

Lemma mayor_scaled k x y j u v : 0 < k -> 0 < j -> k * (x - y) = j * (u - v) ->
  k * mayor (x - y) (y - x) = j * mayor (u - v) (v - u).
Proof.
  intros Hk Hj E. rewrite !mayor_is_Rmax, <- !RmaxRmult by lra. f_equal; [exact E |].
  replace (k * (y - x)) with (- (k * (x - y))) by ring. rewrite E. ring.
Qed.

(** Discharges circulo_de_confusion.conj.2. *)
Theorem the_circle_is_that_of_thin_lenses : circulo_de_confusion_conj_2.
Proof.
  intros l z F a b c d [_ HA Hs] Hz HF Ha Hb _ _ Ea Eb D C.
  unfold Rmas, Cantidad, circulo_de_confusion in *. set (s := Lente_foco l) in *. set (A := Lente_abertura l) in *.
  assert (E : a * b * (z - s) = s * z * (a - b)).
  { assert (E : (s + a) * (z * b) = s * a * (z + b)).
    { apply Rmult_eq_reg_l with F; [| lra].
      replace (F * ((s + a) * (z * b))) with (F * (s + a) * (z * b)) by ring.
      replace (F * (s * a * (z + b))) with (s * a * (F * (z + b))) by ring. rewrite Ea, Eb. ring. }
    replace (a * b * (z - s)) with ((s + a) * (z * b) - s * a * (z + b) + s * z * (a - b)) by ring. lra. }
  assert (Pab : 0 < a * b) by now apply Rmult_lt_0_compat. assert (Psz : 0 < s * z) by now apply Rmult_lt_0_compat.
  pose proof (mayor_scaled _ _ _ _ _ _ Pab Psz E) as M.
  apply Rmult_eq_reg_r with (b * z); [| apply Rgt_not_eq; now apply Rmult_lt_0_compat].
  replace (d * s * (b * z)) with (d * b * (s * z)) by ring. replace (a * c * (b * z)) with (a * b * (c * z)) by ring.
  rewrite D, C. replace (A * mayor (a - b) (b - a) * (s * z)) with (A * (s * z * mayor (a - b) (b - a))) by ring.
  rewrite <- M. ring.
Qed.

(** ** What moves *)

(** Discharges desplazado.def.1, desplazado.conj.1. *)
Theorem whatever_moves_keeps_its_shape : desplazado_conj_1.
Proof.
  intros p q c d v dir t r _ [Qx [Qy Qz]] [Dx [Dy Dz]].
  unfold potencia_esfera, alejamiento, avance, cuadrado. rewrite Qx, Qy, Qz, Dx, Dy, Dz. repeat split; ring.
Qed.

(** ** The estimate *)

(** Discharges repartida.def.1, repartida.conj.1. *)
Theorem shared_means_add_to_the_sum : repartida_conj_1.
Proof.
  intros p q w o f x y suma m k Hp Hq Hw Ho Hf Hx Hy Hs [En Shared] Sf
    [d [u [Hd [Hu [Ed [Su [v [Hv <-]]]]]]]] [d' [u' [Hd' [Hu' [Ed' [Su' [v' [Hv' <-]]]]]]]].
  destruct (outcomes p Hp) as [n [E Pn]]. destruct Hp as [_ Fp _ _ _], Hq as [_ Fq _ _ _].
  rewrite <- En in *. rewrite E in *.
  assert (H : exists a b c, (IZR n, a) ∈ suma /\ (IZR n, b) ∈ u /\ (IZR n, c) ∈ u' /\ a = b + c).
  { apply (up_to (fun z => exists a b c, (IZR z, a) ∈ suma /\ (IZR z, b) ∈ u /\ (IZR z, c) ∈ u' /\ a = b + c)); [| | lia].
    - exists 0, 0, 0. repeat split; try lra; eapply empty_sum; eassumption.
    - intros z Hz [a [b [c [Ha [Hb [Hc ->]]]]]].
      destruct (one_more _ _ _ Sf (proj1 Hz)) as [a' [fz [Ha' [Hfz Na]]]].
      destruct (one_more _ _ _ Su (proj1 Hz)) as [b' [e [Hb' [He Nb]]]].
      destruct (one_more _ _ _ Su' (proj1 Hz)) as [c' [e' [Hc' [He' Nc]]]].
      destruct (Ed _ (integer z)) as [e1 [p1 [x1 [He1 [Hp1 [Hx1 ->]]]]]].
      destruct (Ed' _ (integer z)) as [e2 [q1 [y1 [He2 [Hq1 [Hy1 ->]]]]]].
      destruct (Shared _ (integer z) (below _ _ Hz)) as [[w1 [o1 [Hw1 [Ho1 W]]]]
        [[p2 [x2 [w2 [f2 [Hp2 [Hx2 [Hw2 [Hf2 X]]]]]]]] [q2 [y2 [o2 [f3 [Hq2 [Hy2 [Ho2 [Hf3 Y]]]]]]]]]].
      rewrite (one_value _ _ _ _ _ _ Fp Hp2 Hp1), (one_value _ _ _ _ _ _ Hx Hx2 Hx1), (one_value _ _ _ _ _ _ Hw Hw2 Hw1),
        (one_value _ _ _ _ _ _ Hf Hf2 Hfz) in X.
      rewrite (one_value _ _ _ _ _ _ Fq Hq2 Hq1), (one_value _ _ _ _ _ _ Hy Hy2 Hy1), (one_value _ _ _ _ _ _ Ho Ho2 Ho1),
        (one_value _ _ _ _ _ _ Hf Hf3 Hfz) in Y.
      exists (a' + fz), (b' + e), (c' + e'). repeat split; try assumption.
      rewrite (one_value _ _ _ _ _ _ Hs Ha' Ha), (one_value _ _ _ _ _ _ Hu Hb' Hb), (one_value _ _ _ _ _ _ Hu' Hc' Hc),
        (one_value _ _ _ _ _ _ Hd He He1), (one_value _ _ _ _ _ _ Hd' He' He2), X, Y.
      replace fz with ((w1 + o1) * fz) at 1 by (rewrite W; ring). ring. }
  destruct H as [a [b [c [Ha [Hb [Hc ->]]]]]]. exists (b + c). split; [exact Ha |].
  now rewrite (one_value _ _ _ _ _ _ Hu Hv Hb), (one_value _ _ _ _ _ _ Hu' Hv' Hc).
Qed.

(** Discharges ruleta.def.1, ruleta.conj.1. *)
Theorem roulette_keeps_the_mean : ruleta_conj_1.
Proof.
  intros s z c x y m Hs Hz R N [p0 [Hp0 ->]] [z0 [Hz0 ->]] [z1 [Hz1 ->]] [d [u [Hd [Hu [Ed [Su [v [Hv <-]]]]]]]].
  destruct Hs as [_ Hp _ _ _]. rewrite N in Hv. unfold ruleta in R.
  destruct (one_more _ _ 0 Su ltac:(lia)) as [a [e [Ha [He Na]]]].
  destruct (one_more _ _ 1 Su ltac:(lia)) as [b [e' [Hb [He' Nb]]]].
  destruct (Ed _ (integer 0)) as [e1 [p1 [x1 [He1 [Hp1 [Hx1 ->]]]]]].
  destruct (Ed _ (integer 1)) as [e2 [p2 [x2 [He2 [Hp2 [Hx2 ->]]]]]].
  cbn in Na, Nb.
  rewrite (one_value _ _ _ _ _ _ Hu Hv Nb), (one_value _ _ _ _ _ _ Hu Hb Na),
    (one_value _ _ _ _ _ _ Hu Ha (empty_sum _ _ Su)), (one_value _ _ _ _ _ _ Hd He He1),
    (one_value _ _ _ _ _ _ Hd He' He2), (one_value _ _ _ _ _ _ Hz Hx2 Hz1), (one_value _ _ _ _ _ _ Hp Hp1 Hp0),
    (one_value _ _ _ _ _ _ Hz Hx1 Hz0), <- R. ring.
Qed.
