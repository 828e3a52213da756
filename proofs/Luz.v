(** Light: what spec/luz.tex claims of the local model, of the depth of recursion and of the window.
    What it claims of the power is in Power.v. *)
From Coq Require Import Reals Lra Lia.
From Durero Require Import Toolkit Especificacion Tipos Puntos Iluminacion Power.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Lemma mayor_is_Rmax a b : mayor a b = Rmax a b.
Proof. reflexivity. Qed.

(** ** Refraction: the numbers of the source text *)

(** Discharges coseno_cuadrado.conj.1. *)
Theorem into_glass_at_45_degrees : coseno_cuadrado_conj_1.
Proof. intros i n k Hk _ Hc Hr. unfold coseno_cuadrado. unfold cuadrado in *. replace k with (2 / 3) by lra. nra. Qed.

(** Discharges reflexion_total.conj.2. *)
Theorem out_of_glass_and_out_of_water : reflexion_total_conj_2.
Proof.
  intros i n k Hk H. unfold reflexion_total, coseno_cuadrado. split; intros E; split.
  - intros [_ L]. unfold cuadrado in *. replace k with (3 / 2) in L by lra. lra.
  - intros L. split; [exact H |]. unfold cuadrado in *. replace k with (3 / 2) by lra. lra.
  - intros [_ L]. unfold cuadrado in *. replace k with (133 / 100) in L by lra. lra.
  - intros L. split; [exact H |]. unfold cuadrado in *. replace k with (133 / 100) by lra. lra.
Qed.

(** ** The local model *)

(** Discharges especular.def.1, especular.conj.1. *)
Theorem a_highlight_is_the_mirrored_light : especular_conj_1.
Proof.
  intros l n r v [_ [Hx [Hy Hz]]] Hn. rewrite Hn in Hx, Hy, Hz. unfold especular.
  replace (producto r v) with
    ((1 * (Vector_x r + Vector_x l)) * Vector_x v + (1 * (Vector_y r + Vector_y l)) * Vector_y v
     + (1 * (Vector_z r + Vector_z l)) * Vector_z v - producto l v) by (components; ring).
  rewrite Hx, Hy, Hz. components. ring.
Qed.

(** Discharges especular.conj.2. *)
Theorem either_may_be_mirrored : especular_conj_2.
Proof. intros l n v. unfold especular. components. ring. Qed.

Lemma producto_symmetric u v : producto u v = producto v u.
Proof. components. ring. Qed.

(** The terms of the local model, with the condition of the highlight decided. *)
Lemma directa_behind m n v l : producto n l <= 0 -> directa m n v l = Material_k_a m * Material_C m.
Proof.
  intros H. unfold directa. rewrite mayor_is_Rmax, Rmax_left by exact H. destruct (Rgt_dec _ _); [lra | ring].
Qed.

Lemma directa_before m n v l : producto n l > 0 ->
  directa m n v l = Material_k_a m * Material_C m + Material_k_d m * Material_C m * producto n l
                    + Material_k_s m * elevado (Rmax 0 (especular l n v)) (Material_e m).
Proof.
  intros H. unfold directa. rewrite !mayor_is_Rmax, Rmax_right by lra. destruct (Rgt_dec _ _); [reflexivity | contradiction].
Qed.

(** Discharges mayor.def.1, directa.conj.1. *)
Theorem behind_the_surface_the_first_term_is_left : directa_conj_1.
Proof. intros m n v l _ H. now apply directa_behind. Qed.

(** Discharges directa.conj.2. *)
Theorem without_a_highlight_it_is_Lamberts_law : directa_conj_2.
Proof.
  intros m n v l _ Hs [H | H].
  - rewrite directa_before, Hs by exact H. ring.
  - rewrite directa_behind by lra. rewrite H. ring.
Qed.

(** Discharges directa.conj.3. *)
Theorem a_highlight_has_no_colour_and_no_back : directa_conj_3.
Proof.
  intros m n v l _ HC H. rewrite directa_before, HC by exact H. split.
  - intros E. rewrite Rmax_right by lra. ring.
  - intros [E He]. rewrite Rmax_left by lra. unfold elevado. rewrite power_of_zero by lra. ring.
Qed.

(** Of unit vectors no product is above one: the square of the difference is not negative. *)
Lemma producto_below_one u v : producto u u = 1 -> producto v v = 1 -> producto u v <= 1.
Proof.
  intros Hu Hv.
  assert (0 <= (Vector_x u - Vector_x v) * (Vector_x u - Vector_x v)
    + (Vector_y u - Vector_y v) * (Vector_y u - Vector_y v) + (Vector_z u - Vector_z v) * (Vector_z u - Vector_z v)).
  { apply Rplus_le_le_0_compat; [apply Rplus_le_le_0_compat |]; apply Rle_0_sqr. }
  replace (producto u v) with ((producto u u + producto v v
    - ((Vector_x u - Vector_x v) * (Vector_x u - Vector_x v) + (Vector_y u - Vector_y v) * (Vector_y u - Vector_y v)
       + (Vector_z u - Vector_z v) * (Vector_z u - Vector_z v))) / 2) by (components; field).
  lra.
Qed.

(** The mirror image of a unit vector is one, so that the cosine of the highlight is not above one either. *)
Lemma especular_below_one l n v : producto n n = 1 -> producto v v = 1 -> producto l l = 1 -> especular l n v <= 1.
Proof.
  intros Hn Hv Hl.
  set (k := 2 * producto l n).
  set (r := mk_Vector (k * Vector_x n - Vector_x l) (k * Vector_y n - Vector_y l) (k * Vector_z n - Vector_z l)).
  replace (especular l n v) with (producto r v).
  - apply producto_below_one; [| exact Hv].
    replace (producto r r) with (k * (k * producto n n - 2 * producto l n) + producto l l)
      by (unfold r; clearbody k; components; ring).
    rewrite Hn, Hl. unfold k. ring.
  - unfold especular. fold k. unfold r. clearbody k. components. ring.
Qed.

(** Discharges directa.def.1, directa.conj.4, Material.inv.1, Material.inv.2, Material.inv.3, Material.inv.6,
    Material.inv.11. *)
Theorem a_light_is_sent_back_by_its_shares_at_most : directa_conj_4.
Proof.
  intros m n v l Hm Hn Hv Hl.
  destruct Hm as [[Ha0 Ha1] [Hd0 Hd1] [Hs0 Hs1] _ _ [HC0 HC1] _ _ _ _ He _].
  assert (P : 0 <= Material_k_a m * Material_C m) by now apply Rmult_le_pos.
  assert (Q : 0 <= Material_k_d m * Material_C m) by now apply Rmult_le_pos.
  destruct (Rgt_dec (producto n l) 0) as [H | H].
  - rewrite directa_before by exact H.
    set (t := elevado (Rmax 0 (especular l n v)) (Material_e m)).
    assert (T : 0 <= t <= 1).
    { split; [apply power_not_negative |]. apply no_power_of_a_share_is_above_one; [| exact He].
      split; [apply Rmax_l |]. apply Rmax_lub; [lra |]. now apply especular_below_one. }
    assert (N : producto n l <= 1) by now apply producto_below_one.
    assert (0 <= Material_k_d m * Material_C m * producto n l) by (apply Rmult_le_pos; lra).
    assert (Material_k_d m * Material_C m * producto n l <= Material_k_d m * Material_C m * 1)
      by (apply Rmult_le_compat_l; lra).
    assert (0 <= Material_k_s m * t) by (apply Rmult_le_pos; lra).
    assert (Material_k_s m * t <= Material_k_s m * 1) by (apply Rmult_le_compat_l; lra).
    lra.
  - rewrite directa_behind by lra. lra.
Qed.

(** What relates one number to another, where it is a function. *)
Lemma value_of {X Y} (A : set X) (B : set Y) f x : f ∈ A ⟶ B -> x ∈ A -> exists y, (x, y) ∈ f /\ y ∈ B.
Proof.
  intros [_ [Hdom Hran]] Hx. apply Hdom in Hx. destruct Hx as [y Hy]. exists y. split; [exact Hy |].
  apply Hran. now exists x.
Qed.

Lemma one_value {X Y} (A : set X) (B : set Y) f x y y' : f ∈ A ⟶ B -> (x, y) ∈ f -> (x, y') ∈ f -> y = y'.
Proof. intros [H _]. apply H. Qed.

Lemma integer z : IZR z ∈ integers.
Proof. now exists z. Qed.

(** Discharges acumulado.def.1, acumulado.conj.1. *)
Theorem a_sum_is_one : acumulado_conj_1.
Proof.
  intros dada suma otra i Hd Hs Ho [z ->] [S0 S1] [O0 O1] Hi.
  assert (Hz : (0 <= z)%Z) by (apply le_IZR; lra).
  clear Hi. revert z Hz. apply natlike_ind.
  - destruct S0 as [v1 [H1 ->]], O0 as [v2 [H2 ->]]. now exists 0, 0.
  - intros z Hz [u [w [Hu [Hw E]]]]. subst w. unfold Z.succ. rewrite plus_IZR.
    assert (P : IZR z >= 0) by (apply Rle_ge, IZR_le, Hz).
    destruct (S1 _ (integer z) P) as [a [b [c [Ha [Hb [Hc ->]]]]]].
    destruct (O1 _ (integer z) P) as [a' [b' [c' [Ha' [Hb' [Hc' ->]]]]]].
    exists (b + c), (b' + c'). repeat split; try assumption.
    rewrite (one_value _ _ _ _ _ _ Hs Hb Hu), (one_value _ _ _ _ _ _ Ho Hb' Hw), (one_value _ _ _ _ _ _ Hd Hc Hc').
    reflexivity.
Qed.

(** Discharges aportacion.def.1, radiancia.def.1, aportacion.conj.1, Fuente.inv.1, Fuente.inv.2, Material.inv.9,
    Material.inv.10. *)
Theorem the_first_term_counts_for_each_light : aportacion_conj_1.
Proof.
  intros m n v f g dada suma Hm Hf Hg Hd Hs Hkd Hks [[z [S0 ->]] S1] [a [Da ->]] [b [Db ->]].
  assert (D : forall l, directa m n v l = Material_k_a m * Material_C m).
  { intros l. destruct (Rgt_dec (producto n l) 0) as [H | H].
    - rewrite directa_before, Hkd, Hks by exact H. ring.
    - apply directa_behind. lra. }
  destruct (S1 0 (integer 0)) as [p [q [r [P [Q [R ->]]]]]]; [lra |].
  destruct (S1 1 (integer 1)) as [p' [q' [r' [P' [Q' [R' ->]]]]]]; [lra |].
  rewrite Rplus_0_l in P.
  replace (1 + 1) with 2 in P' by ring.
  exists (q' + r'). split; [exact P' |].
  rewrite (one_value _ _ _ _ _ _ Hs Q' P), (one_value _ _ _ _ _ _ Hs Q S0), (one_value _ _ _ _ _ _ Hd R Da),
    (one_value _ _ _ _ _ _ Hd R' Db).
  unfold radiancia, indirecta, aportacion. rewrite !D. ring.
Qed.

(** Discharges conserva.def.1, indirecta.def.1, conserva.conj.1, Material.inv.4, Material.inv.5, Material.inv.7,
    Material.inv.8. *)
Theorem what_conserves_shines_no_brighter : conserva_conj_1.
Proof.
  intros m r t [Hm H] Hr Ht. destruct Hm as [_ _ _ [Hp0 _] [Ht0 _] _ [Mp0 _] [Mt0 _] _ _ _ _].
  unfold indirecta. rewrite mayor_is_Rmax. unfold Cantidad in Hr, Ht.
  set (a := Material_k_ps m * Material_M_PS m) in *. set (b := Material_k_t m * Material_M_T m) in *.
  assert (0 <= a) by now apply Rmult_le_pos. assert (0 <= b) by now apply Rmult_le_pos.
  pose proof (Rmax_l r t). pose proof (Rmax_r r t). set (w := Rmax r t) in *.
  assert (a * r <= a * w) by (apply Rmult_le_compat_l; lra).
  assert (b * t <= b * w) by (apply Rmult_le_compat_l; lra).
  assert ((a + b) * w <= 1 * w) by (apply Rmult_le_compat_r; lra).
  lra.
Qed.

(** ** The recursion ends *)

Section Following.
Variable Camino : Type.
Implicit Types (t : Trazado Camino) (L M : rel (R * Camino) R) (c : Camino).

(** What a way brings that may still have so many in a row, itself the first. *)
Fixpoint brings t (left : nat) c : set R := fun y =>
  match left with
  | O => y = 0
  | S fewer =>
      (c ∉ Trazado_llega t /\ (c, y) ∈ Trazado_fondo t)
      \/ (c ∈ Trazado_llega t /\ exists m u r f yr yf, (c, m) ∈ Trazado_material t /\ (c, u) ∈ Trazado_de_luces t
          /\ (c, r) ∈ Trazado_reflejado t /\ (c, f) ∈ Trazado_refractado t /\ brings t fewer r yr
          /\ brings t fewer f yf /\ y = radiancia m u yr yf)
  end.

Lemma brings_something t left c : t ∈ @Trazado_ok Camino -> exists y, brings t left c y.
Proof.
  intros Ht. revert c. induction left as [| fewer IH]; intros c; [now exists 0 |].
  destruct Ht as [_ Hfondo Hmaterial Hluces Hr Hf].
  destruct (Classical_Prop.classic (c ∈ Trazado_llega t)) as [H | H].
  - destruct (value_of _ _ _ c Hmaterial I) as [m [Hm _]]. destruct (value_of _ _ _ c Hluces I) as [u [Hu _]].
    destruct (value_of _ _ _ c Hr I) as [r [Hrc _]]. destruct (value_of _ _ _ c Hf I) as [f [Hfc _]].
    destruct (IH r) as [yr Hyr]. destruct (IH f) as [yf Hyf].
    exists (radiancia m u yr yf). right. split; [exact H |]. exists m, u, r, f, yr, yf. repeat split; assumption.
  - destruct (value_of _ _ _ c Hfondo I) as [y [Hy _]]. exists y. now left.
Qed.

Lemma brings_one t left c y y' : t ∈ @Trazado_ok Camino -> brings t left c y -> brings t left c y' -> y = y'.
Proof.
  intros Ht. revert c y y'. induction left as [| fewer IH]; intros c y y'; [cbn; congruence |].
  destruct Ht as [_ Hfondo Hmaterial Hluces Hr Hf].
  intros [[H Hy] | [H [m [u [r [f [yr [yf [Hm [Hu [Hrc [Hfc [Hyr [Hyf ->]]]]]]]]]]]]]]
    [[H' Hy'] | [H' [m' [u' [r' [f' [yr' [yf' [Hm' [Hu' [Hrc' [Hfc' [Hyr' [Hyf' ->]]]]]]]]]]]]]]; try contradiction.
  - exact (one_value _ _ _ _ _ _ Hfondo Hy Hy').
  - pose proof (one_value _ _ _ _ _ _ Hr Hrc Hrc'). pose proof (one_value _ _ _ _ _ _ Hf Hfc Hfc'). subst r' f'.
    rewrite (one_value _ _ _ _ _ _ Hmaterial Hm Hm'), (one_value _ _ _ _ _ _ Hluces Hu Hu'), (IH _ _ _ Hyr Hyr'),
      (IH _ _ _ Hyf Hyf'). reflexivity.
Qed.

(** How many ways in a row are left at a depth. *)
Definition left_at (maximo n : Z) : nat := Z.to_nat (maximo - n + 1).

Lemma left_at_deeper maximo n : (n <= maximo)%Z -> left_at maximo n = S (left_at maximo (n + 1)).
Proof. intros H. unfold left_at. rewrite <- Z2Nat.inj_succ by lia. f_equal. lia. Qed.

(** Every tracer brings that. *)
Lemma a_tracer_brings t maximo L : t ∈ @Trazado_ok Camino -> L ∈ cartesian integers univ ⟶ univ ->
  trazador t (IZR maximo) L -> forall n c y, ((IZR n, c), y) ∈ L <-> brings t (left_at maximo n) c y.
Proof.
  intros Ht HL [Black [Out In]].
  assert (Into : forall left n c y, left = left_at maximo n -> ((IZR n, c), y) ∈ L -> brings t left c y).
  { induction left as [| fewer IH]; intros n c y E Hy.
    - assert (H : (n > maximo)%Z) by (unfold left_at in E; lia).
      destruct (Black (IZR n) c (integer n)) as [v [Hv ->]]; [apply IZR_lt in H || apply Rlt_gt, IZR_lt; lia |].
      cbn. exact (one_value _ _ _ _ _ _ HL Hy Hv).
    - assert (H : (n <= maximo)%Z) by (unfold left_at in E; lia).
      pose proof (left_at_deeper _ _ H) as E'. rewrite <- E in E'. injection E' as E'.
      destruct (Classical_Prop.classic (c ∈ Trazado_llega t)) as [Hc | Hc].
      + destruct (In (IZR n) c (integer n)) as [v1 [m [u [r [yr [f [yf [H1 [H2 [H3 [H4 [H5 [H6 [H7 ->]]]]]]]]]]]]]];
          [now apply IZR_le | exact Hc |].
        rewrite <- plus_IZR in H5, H7.
        right. split; [exact Hc |]. exists m, u, r, f, yr, yf.
        repeat split; try assumption; try (eapply IH; eassumption).
        exact (one_value _ _ _ _ _ _ HL Hy H1).
      + destruct (Out (IZR n) c (integer n)) as [v1 [v2 [H1 [H2 ->]]]]; [now apply IZR_le | exact Hc |].
        left. split; [exact Hc |]. now rewrite (one_value _ _ _ _ _ _ HL Hy H1). }
  intros n c y. split; [now apply Into |]. intros Hy.
  destruct (value_of _ _ _ (IZR n, c) HL) as [v [Hv _]]; [split; [apply integer | exact I] |].
  now rewrite (brings_one _ _ _ _ _ Ht Hy (Into _ _ _ _ eq_refl Hv)).
Qed.

(** Discharges trazador.conj.2. *)
Theorem there_is_one_answer : trazador_conj_2 Camino.
Proof.
  intros t maximo L M Ht [z ->] HL HM HtL HtM [[n c] y].
  destruct (Classical_Prop.classic (n ∈ integers)) as [[k ->] | Hn].
  - rewrite (a_tracer_brings _ _ _ Ht HL HtL), (a_tracer_brings _ _ _ Ht HM HtM). reflexivity.
  - split; intros H; exfalso; apply Hn.
    + destruct HL as [_ [Hdom _]]. apply (Hdom (n, c)). now exists y.
    + destruct HM as [_ [Hdom _]]. apply (Hdom (n, c)). now exists y.
Qed.

(** Discharges trazador.def.1, trazador.conj.1. *)
Theorem the_recursion_ends : trazador_conj_1 Camino.
Proof.
  intros t maximo Ht [z ->].
  exists (fun p => exists n, fst (fst p) = IZR n /\ brings t (left_at z n) (snd (fst p)) (snd p)).
  assert (At : forall n c y, brings t (left_at z n) c y ->
    (fun p : (R * Camino) * R => exists n, fst (fst p) = IZR n /\ brings t (left_at z n) (snd (fst p)) (snd p))
      ((IZR n, c), y)).
  { intros n c y H. exists n. now split. }
  split; [split; [| split] | split; [| split]].
  - intros [x c] y y' [n [E H]] [n' [E' H']]. cbn in *. subst x. apply eq_IZR in E'. subst n'.
    exact (brings_one _ _ _ _ _ Ht H H').
  - intros [x c]. split.
    + intros [y [n [E _]]]. cbn in E. split; [now exists n | exact I].
    + intros [[n E] _]. cbn in E. subst x. destruct (brings_something t (left_at z n) c Ht) as [y Hy].
      exists y. now apply At.
  - easy.
  - intros x c [n ->] H. exists 0. split; [| reflexivity]. apply At.
    unfold left_at. replace (Z.to_nat (z - n + 1)) with O; [reflexivity |].
    apply Rgt_lt, lt_IZR in H. lia.
  - intros x c [n ->] H Hc. apply le_IZR in H.
    destruct (value_of _ _ _ c (Trazado_decl_fondo Ht) I) as [y [Hy _]].
    exists y, y. repeat split; [| exact Hy]. apply At. rewrite left_at_deeper by exact H. now left.
  - intros x c [n ->] H Hc. apply le_IZR in H.
    destruct (brings_something t (left_at z n) c Ht) as [y Hy]. pose proof Hy as Hy'.
    rewrite left_at_deeper in Hy' by exact H.
    destruct Hy' as [[Hc' _] | [_ [m [u [r [f [yr [yf [Hm [Hu [Hr [Hf [Hyr [Hyf E]]]]]]]]]]]]]]; [contradiction |].
    exists y, m, u, r, yr, f, yf. rewrite <- plus_IZR. repeat split; try assumption; now apply At.
Qed.

(** Discharges trazador.conj.3. *)
Theorem no_depth_is_black_and_one_goes_not_on : trazador_conj_3 Camino.
Proof.
  intros t L M c Ht HL HM [Black _] [BlackM [_ In]] Hc. split.
  - apply (Black 1 c (integer 1)). lra.
  - destruct (In 1 c (integer 1)) as [v1 [m [u [r [yr [f [yf [H1 [H2 [H3 [H4 [H5 [H6 [H7 E]]]]]]]]]]]]]]; [lra | exact Hc |].
    exists v1, m, u. repeat split; try assumption. replace (1 + 1) with 2 in H5, H7 by ring.
    destruct (BlackM 2 r (integer 2)) as [z [Hz ->]]; [lra |].
    destruct (BlackM 2 f (integer 2)) as [z' [Hz' ->]]; [lra |].
    now rewrite E, (one_value _ _ _ _ _ _ HM H5 Hz), (one_value _ _ _ _ _ _ HM H7 Hz').
Qed.
End Following.

(** ** The window *)

(** Discharges centro_de_pixel.def.1, centro_de_pixel.conj.1, Ventana.inv.1, Ventana.inv.2. *)
Theorem opposite_pixels_lie_about_the_middle : centro_de_pixel_conj_1.
Proof.
  intros w x y j k p q [_ _ HH HV] _ _ _ _ [_ [_ [Px [Py Pz]]]] [_ [_ [Qx [Qy Qz]]]] Ex Ey.
  assert (P : 0 < 2 * Ventana_H w * Ventana_V w) by (repeat apply Rmult_lt_0_compat; lra).
  assert (Sum : forall a b s d e,
    2 * Ventana_H w * Ventana_V w * (a - s) = (2 * x + 1) * Ventana_V w * d + (2 * y + 1) * Ventana_H w * e ->
    2 * Ventana_H w * Ventana_V w * (b - s) = (2 * j + 1) * Ventana_V w * d + (2 * k + 1) * Ventana_H w * e ->
    a + b = 2 * s + d + e).
  { intros a b s d e A B. apply Rmult_eq_reg_l with (2 * Ventana_H w * Ventana_V w); [| lra].
    replace (2 * Ventana_H w * Ventana_V w * (a + b)) with
      (2 * Ventana_H w * Ventana_V w * (a - s) + 2 * Ventana_H w * Ventana_V w * (b - s)
       + 2 * Ventana_H w * Ventana_V w * (2 * s)) by ring.
    rewrite A, B, <- Ex, <- Ey. ring. }
  split; [| split]; eapply Sum; eassumption.
Qed.

(** Discharges rayo_de_pixel.def.1, rayo_de_pixel.conj.1. *)
Theorem every_pixel_has_its_ray : rayo_de_pixel_conj_1.
Proof.
  intros w x y q _ _ _ Hq Hne.
  set (o := Ventana_ojo w) in *.
  set (v := mk_Vector (Punto_x q - Punto_x o) (Punto_y q - Punto_y o) (Punto_z q - Punto_z o)).
  exists (mk_Rayo o v). split; [| split; [reflexivity |]].
  - split. intros [Hx [Hy Hz]]. apply Hne. destruct q, o; cbn in *. f_equal; lra.
  - exists q. split; [| exact Hq]. exists 1. split; [unfold Rmas; lra |]. cbn. repeat split; ring.
Qed.

(** ** Smooth normals *)

(** Discharges normal_suave.def.1, normal_suave.conj.1. *)
Theorem a_smooth_surface_has_no_edge : normal_suave_conj_1.
Proof.
  intros a b c d u n m [Nx [Ny Nz]] [Mx [My Mz]]. rewrite Nx, Ny, Nz, Mx, My, Mz. repeat split; ring.
Qed.

(** Discharges normal_suave.conj.2. *)
Theorem between_equal_normals_is_the_same : normal_suave_conj_2.
Proof. intros a u v n [Nx [Ny Nz]]. rewrite Nx, Ny, Nz. repeat split; ring. Qed.

(** Discharges normal_suave.conj.3. *)
Theorem within_a_triangle_no_direction_is_lost : normal_suave_conj_3.
Proof.
  intros a b c g u v n [Nx [Ny Nz]] Hu Hv Huv Pa Pb Pc.
  replace (producto n g) with ((1 - u - v) * producto a g + u * producto b g + v * producto c g)
    by (components; rewrite Nx, Ny, Nz; ring).
  assert (A : 0 <= (1 - u - v) * producto a g) by (apply Rmult_le_pos; lra).
  assert (B : 0 <= u * producto b g) by (apply Rmult_le_pos; lra).
  assert (C : 0 <= v * producto c g) by (apply Rmult_le_pos; lra).
  destruct (Rlt_dec 0 (1 - u - v)) as [P | P]; [pose proof (Rmult_lt_0_compat _ _ P Pa); lra |].
  destruct (Rlt_dec 0 u) as [Q | Q]; [pose proof (Rmult_lt_0_compat _ _ Q Pb); lra |].
  assert (R : 0 < v) by lra. pose proof (Rmult_lt_0_compat _ _ R Pc). lra.
Qed.

(** ** Lights and media *)

(** Discharges Material.conj.1, Material.inv.12. *)
Theorem two_media_have_one_ratio : Material_conj_1.
Proof.
  intros m n Hm Hn. pose proof (Material_inv_12 Hm) as Pm. pose proof (Material_inv_12 Hn) as Pn. unfold Rmas in *.
  exists (Material_indice m / Material_indice n). split.
  - split; [now apply Rdiv_lt_0_compat | field; lra].
  - intros k [_ <-]. field. lra.
Qed.

(** Discharges visible.def.1, visible_lejos.def.1, visible.conj.1. *)
Theorem a_light_without_end_is_visible_nearer (Elemento : Type) : visible_conj_1 Elemento.
Proof.
  intros s p q l en _ Hx Hy Hz [rayo [Hok [Hp [Vx [Vy [Vz Hno]]]]]].
  refine (ex_intro _ rayo (conj Hok (conj Hp (conj _ (conj _ (conj _ _)))))); try congruence.
  intros [t [w [_ [Hw _]]]]. apply Hno. intros E. now apply (E w).
Qed.
