(** Solids that are joined: what spec/solidos.tex claims of their bodies and surfaces, and of the first point of a ray.

    value_from r en c w   == the value of c at w that a ray sees which starts on the quadrics en *)
From Coq Require Import Reals Lra List Classical.
From Durero Require Import Toolkit Especificacion Tipos Puntos Allotments SmallSteps.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** ** The algebra of sets *)

Lemma of_quadrics ds fs l : l ∈ repartos ds fs -> l ∈ ℙ Cuadrica_ok.
Proof. now intros [H _]. Qed.

(** Discharges repartos.def.1, solido_union.def.1, cuerpo.def.1, cuerpo.conj.1. *)
Theorem the_body_of_a_union_is_the_union_of_the_bodies : cuerpo_conj_1.
Proof. intros S T _ _ w. unfold cuerpo, solido_union, union. firstorder. Qed.

(** Discharges solido_interseccion.def.1, interior.def.1, interior.conj.1. *)
Theorem the_interior_of_an_intersection_is_that_of_both : interior_conj_1.
Proof. intros S T _ _ w. unfold interior, solido_interseccion, inter. firstorder. Qed.

(** Discharges superficie.def.1, superficie.conj.1. *)
Theorem the_rest_of_space_has_the_same_surface : superficie_conj_1.
Proof.
  intros S w HS. assert (B : w ∈ cuerpo ((ℙ Cuadrica_ok) ∖ S) <-> w ∉ interior S).
  { unfold cuerpo, interior, diff. split.
    - intros [l [Hl [_ N]]] H. apply N. now apply H.
    - intros N. apply not_all_ex_not in N as [l N]. apply imply_to_and in N as [Hl N].
      exists l. split; [exact Hl | split; [now apply (of_quadrics _ _ _ Hl) | exact N]]. }
  assert (I : w ∈ interior ((ℙ Cuadrica_ok) ∖ S) <-> w ∉ cuerpo S).
  { unfold cuerpo, interior, diff. split.
    - intros H [l [Hl HS']]. now apply (H l Hl).
    - intros N l Hl. split; [now apply (of_quadrics _ _ _ Hl) | intros HS']. apply N. now exists l. }
  split; [exact B |]. split; intros [C N]; split.
  - apply NNPP. intros Q. now apply N, I.
  - now apply B.
  - now apply B.
  - intros Q. now apply I in Q.
Qed.

(** Discharges solido_diferencia.def.1, interior.conj.2. *)
Theorem the_interior_of_a_difference_is_outside_of_what_is_taken : interior_conj_2.
Proof. intros S T _ _ w. unfold interior, cuerpo, solido_diferencia, diff. firstorder. Qed.

(** Discharges cuerpo.conj.2. *)
Theorem a_difference_has_nothing_of_the_inside_of_what_is_taken : cuerpo_conj_2.
Proof. intros S T w _ _ [l [Hl [HS HT]]]. split; [now exists l |]. intros I. now apply HT, I. Qed.

(** Discharges interior.conj.3. *)
Theorem the_interior_is_of_the_body : interior_conj_3.
Proof. intros S w _ H. destruct (an_allotment w) as [l Hl]. exists l. split; [exact Hl | now apply H]. Qed.

(** Discharges dentro.def.1, fuera.def.1, superficie.conj.2. *)
Theorem body_and_surface_are_closed : superficie_conj_2.
Proof.
  intros S u w _ Hd Hf.
  assert (R : repartos (dentro u) (fuera u) ⊆ repartos (dentro w) (fuera w)).
  { intros l [Hok [H1 [H2 H3]]]. split; [exact Hok | split; [| split; [| exact H3]]].
    - intros c Hc. now apply H1, Hd.
    - intros c Hc. now apply H2, Hf. }
  assert (C : u ∈ cuerpo S -> w ∈ cuerpo S) by (intros [l [Hl HS]]; exists l; auto).
  split; [exact C |]. intros [HC HI]. split; [now apply C | intros H; apply HI; intros l Hl; apply H; auto].
Qed.

(** ** The solids of spheres, planes and cylinders *)

Lemma same_coefficients a b : (forall w, valor a w = valor b w) -> a = b.
Proof.
  intros H. destruct a as [a1 a2 a3 a4 a5 a6 a7 a8 a9 a0], b as [b1 b2 b3 b4 b5 b6 b7 b8 b9 b0].
  pose proof (fun x y z => H (mk_Punto x y z)) as E. unfold valor, cuadrado in E. cbn in E.
  pose proof (E 0 0 0). pose proof (E 1 0 0). pose proof (E (-1) 0 0). pose proof (E 0 1 0). pose proof (E 0 (-1) 0).
  pose proof (E 0 0 1). pose proof (E 0 0 (-1)). pose proof (E 0 1 1). pose proof (E 1 0 1). pose proof (E 1 1 0).
  f_equal; lra.
Qed.

(** A quadric whose value is this everywhere, which is not zero everywhere. *)
Lemma not_null c f w : (forall u, valor c u = f u) -> f w <> 0 -> c ∈ Cuadrica_ok.
Proof.
  intros H N. constructor. intros [E1 [E2 [E3 [E4 [E5 [E6 [E7 [E8 [E9 E0]]]]]]]]]. apply N. rewrite <- H.
  unfold valor. rewrite E1, E2, E3, E4, E5, E6, E7, E8, E9, E0. ring.
Qed.

(** Of what is inside of several surfaces the body is where no value is above 0, the interior where all are below. *)
Lemma inside_of_all S cs : cs ⊆ Cuadrica_ok -> (forall a b k, a ∈ cs -> b ∈ cs -> multiplo a b k -> a = b) ->
  (forall l, l ∈ ℙ Cuadrica_ok -> (l ∈ S <-> cs ⊆ l)) ->
  forall w, (w ∈ cuerpo S <-> forall c, c ∈ cs -> valor c w <= 0) /\ (w ∈ interior S <-> forall c, c ∈ cs -> valor c w < 0).
Proof.
  intros Hok One HS w.
  assert (In : forall l, l ∈ repartos (dentro w) (fuera w) -> (l ∈ S <-> cs ⊆ l)).
  { intros l Hl. apply HS. exact (of_quadrics _ _ _ Hl). }
  assert (Any : forall P : set Cuadrica, (forall c, c ∈ cs -> (valor c w < 0 -> c ∈ P) /\ (valor c w > 0 -> c ∉ P)) ->
    exists l, l ∈ repartos (dentro w) (fuera w) /\ forall c, c ∈ cs -> (c ∈ l <-> c ∈ P)).
  { intros P HP. apply at_point. split; [exact Hok | split; [exact HP |]].
    intros a b k Ha Hb H. pose proof (One a b k Ha Hb H). subst b.
    assert (k = 1); [| subst k; split; [tauto | lra]].
    pose proof (lead_of_multiples _ _ _ H). pose proof (lead_nonzero _ (Hok a Ha)).
    apply Rmult_eq_reg_r with (lead a); lra. }
  split; split.
  - intros [l [Hl HSl]] c Hc. apply In in HSl; [| exact Hl]. apply Rnot_gt_le. intros E.
    destruct Hl as [_ [_ [Out _]]]. apply (Out c); [split; auto | now apply HSl].
  - intros H. destruct (Any univ) as [l [Hl HP]].
    + intros c Hc. split; [easy |]. specialize (H c Hc). lra.
    + exists l. split; [exact Hl |]. apply In; [exact Hl |]. intros c Hc. now apply HP.
  - intros H c Hc. apply Rnot_ge_lt. intros E.
    destruct (Any (fun b => valor b w < 0 \/ valor b w = 0 /\ b <> c)) as [l [Hl HP]].
    + intros b _. lra.
    + specialize (H l Hl). apply In in H; [| exact Hl]. specialize (H c Hc). apply HP in H; [| exact Hc].
      destruct H as [H | [_ H]]; [lra | now apply H].
  - intros H l Hl. apply In; [exact Hl |]. intros c Hc. destruct Hl as [_ [Hd _]]. apply Hd. split; auto.
Qed.

Lemma inside_of_one S c : c ∈ Cuadrica_ok -> (forall l, l ∈ ℙ Cuadrica_ok -> (l ∈ S <-> c ∈ l)) ->
  forall w, (w ∈ superficie S <-> valor c w = 0) /\ (w ∈ interior S <-> valor c w < 0).
Proof.
  intros Hok HS w. destruct (inside_of_all S ⦃c⦄) with (w := w) as [B I].
  - now intros d ->.
  - now intros a b k -> ->.
  - intros l Hl. rewrite (HS l Hl). split; [now intros H d -> | intros H; now apply H].
  - assert (B' : w ∈ cuerpo S <-> valor c w <= 0) by (rewrite B; split; [intros H; now apply H | now intros H d ->]).
    assert (I' : w ∈ interior S <-> valor c w < 0) by (rewrite I; split; [intros H; now apply H | now intros H d ->]).
    split; [| exact I']. unfold superficie, diff. rewrite B', I'. lra.
Qed.

Definition sphere_quadric (c : Punto) (r : R) : Cuadrica :=
  mk_Cuadrica 1 1 1 0 0 0 (-2 * Punto_x c) (-2 * Punto_y c) (-2 * Punto_z c)
    (Punto_x c * Punto_x c + Punto_y c * Punto_y c + Punto_z c * Punto_z c - r * r).
Lemma value_of_sphere c r w : valor (sphere_quadric c r) w = potencia_esfera w c r.
Proof. unfold valor, sphere_quadric, potencia_esfera, cuadrado. cbn. ring. Qed.

Definition plane_quadric (c : Punto) (d : Vector) (k h : R) : Cuadrica :=
  mk_Cuadrica 0 0 0 0 0 0 (k * Vector_x d) (k * Vector_y d) (k * Vector_z d)
    (- k * (Punto_x c * Vector_x d + Punto_y c * Vector_y d + Punto_z c * Vector_z d) - h).
Lemma value_of_plane c d k h w : valor (plane_quadric c d k h) w = k * avance w c d - h.
Proof. unfold valor, plane_quadric, avance, cuadrado. cbn. ring. Qed.

Lemma in_solid_sphere c r l : l ∈ ℙ Cuadrica_ok -> (l ∈ solido_esfera c r <-> sphere_quadric c r ∈ l).
Proof.
  intros Hl. split.
  - intros [_ [d [Hd E]]]. rewrite (same_coefficients (sphere_quadric c r) d); [exact Hd |].
    intros u. now rewrite E, value_of_sphere.
  - intros H. split; [exact Hl |]. exists (sphere_quadric c r). split; [exact H | apply value_of_sphere].
Qed.

Lemma sphere_is_a_quadric c r : 0 < r -> sphere_quadric c r ∈ Cuadrica_ok.
Proof.
  intros Hr. apply (not_null _ _ c (value_of_sphere c r)). unfold potencia_esfera, cuadrado.
  pose proof (Rmult_lt_0_compat r r Hr Hr). lra.
Qed.

(** Discharges Cuadrica.inv.1, valor.def.1, multiplo.def.1, solido_esfera.def.1, solido_esfera.conj.1. *)
Theorem the_surface_of_a_solid_sphere_is_the_sphere : solido_esfera_conj_1.
Proof.
  intros c w r Hr. change (r > 0) in Hr.
  destruct (inside_of_one (solido_esfera c r) _ (sphere_is_a_quadric c r Hr)) with (w := w) as [Su In].
  - apply in_solid_sphere.
  - rewrite value_of_sphere in Su, In. split; [exact Su | exact In].
Qed.

(** Discharges solido_plano.def.1, solido_plano.conj.1. *)
Theorem the_surface_of_what_lies_behind_a_plane_is_the_plane : solido_plano_conj_1.
Proof.
  intros c w d Hd. apply axis_square_bounds in Hd as [Hd _].
  assert (V : forall u, valor (plane_quadric c d 1 0) u = potencia_plano u c d).
  { intros u. rewrite value_of_plane. unfold potencia_plano. ring. }
  assert (Hok : plane_quadric c d 1 0 ∈ Cuadrica_ok).
  { apply (not_null _ _ (mk_Punto (Punto_x c + Vector_x d) (Punto_y c + Vector_y d) (Punto_z c + Vector_z d)) V).
    unfold potencia_plano, avance, sq, dot in *. cbn. lra. }
  destruct (inside_of_one (solido_plano c d) _ Hok) with (w := w) as [Su _].
  - intros l Hl. split.
    + intros [_ [q [Hq E]]]. rewrite (same_coefficients (plane_quadric c d 1 0) q); [exact Hq |].
      intros u. now rewrite E, V.
    + intros H. split; [exact Hl |]. exists (plane_quadric c d 1 0). split; [exact H | apply V].
  - rewrite V in Su. exact Su.
Qed.

Definition cylinder_quadric (c : Punto) (r : R) (d : Vector) : Cuadrica :=
  let '(mk_Punto a b e) := c in let '(mk_Vector x y z) := d in let n := x * x + y * y + z * z in let k := n - 2 in
  let m := a * x + b * y + e * z in
  mk_Cuadrica (1 + k * (x * x)) (1 + k * (y * y)) (1 + k * (z * z)) (2 * k * (y * z)) (2 * k * (z * x)) (2 * k * (x * y))
    (- 2 * a - 2 * k * m * x) (- 2 * b - 2 * k * m * y) (- 2 * e - 2 * k * m * z)
    (a * a + b * b + e * e + k * (m * m) - r * r).
Lemma value_of_cylinder c r d w : valor (cylinder_quadric c r d) w = potencia_cilindro w c r d.
Proof.
  destruct c as [a b e], d as [x y z], w as [p q s].
  unfold valor, cylinder_quadric, potencia_cilindro, alejamiento, avance, cuadrado. cbn. ring.
Qed.

(** The point of the axis at an advance, and its power: the wall is as far on both sides of the centre. *)
Definition on_axis (c : Punto) (d : Vector) (s : R) : Punto :=
  mk_Punto (Punto_x c + s * Vector_x d) (Punto_y c + s * Vector_y d) (Punto_z c + s * Vector_z d).
Lemma advance_on_axis c d s : avance (on_axis c d s) c d = s * sq d.
Proof. unfold avance, on_axis, sq, dot. cbn. ring. Qed.
Lemma power_on_axis c r d s : potencia_cilindro (on_axis c d s) c r d = s * s * (sq d * ((1 - sq d) * (1 - sq d))) - r * r.
Proof. unfold potencia_cilindro, alejamiento. rewrite advance_on_axis. unfold on_axis, cuadrado, sq, dot. cbn. ring. Qed.

(** No two of the three quadrics of a solid cylinder are one surface. *)
Lemma wall_and_plane c r d j h k : 0 < sq d -> j <> 0 ->
  ~ (forall w, potencia_cilindro w c r d = k * (j * avance w c d - h)) \/ k = 0.
Proof.
  intros Hd Hj. destruct (Req_dec k 0) as [Hk | Hk]; [now right | left]. intros E.
  pose proof (E (on_axis c d 1)) as E1. pose proof (E (on_axis c d (-1))) as E2.
  rewrite power_on_axis, advance_on_axis in E1, E2.
  assert (Z : k * (j * sq d) = 0) by lra. apply Rmult_integral in Z as [Z | Z]; [contradiction |].
  apply Rmult_integral in Z as [Z | Z]; [contradiction | lra].
Qed.

(** Discharges solido_tramo.def.1, solido_cilindro.def.1, solido_cilindro.conj.1. *)
Theorem the_surface_of_a_solid_cylinder_is_the_cylinder_and_two_lids : solido_cilindro_conj_1.
Proof.
  intros c w r h d Hr Hh Hd. change (r > 0) in Hr. change (h > 0) in Hh. apply axis_square_bounds in Hd as [Hd _].
  set (W := cylinder_quadric c r d). set (B := plane_quadric c d (-1) 0). set (T := plane_quadric c d 1 h).
  assert (VW : forall u, valor W u = potencia_cilindro u c r d) by apply value_of_cylinder.
  assert (VB : forall u, valor B u = 0 - avance u c d) by (intros u; unfold B; rewrite value_of_plane; ring).
  assert (VT : forall u, valor T u = avance u c d - h) by (intros u; unfold T; rewrite value_of_plane; ring).
  assert (A0 : avance (on_axis c d 0) c d = 0) by (rewrite advance_on_axis; ring).
  assert (A1 : avance (on_axis c d 1) c d = sq d) by (rewrite advance_on_axis; ring).
  assert (WB : forall k, ~ multiplo W B k).
  { intros k H. destruct (wall_and_plane c r d (-1) 0 k) as [N | N]; [lra | lra | | now apply (multiple_nonzero _ _ _ H)].
    apply N. intros u. rewrite <- VW, (valor_of_multiples _ _ _ u H), VB. ring. }
  assert (WT : forall k, ~ multiplo W T k).
  { intros k H. destruct (wall_and_plane c r d 1 h k) as [N | N]; [lra | lra | | now apply (multiple_nonzero _ _ _ H)].
    apply N. intros u. rewrite <- VW, (valor_of_multiples _ _ _ u H), VT. ring. }
  assert (BT : forall k, ~ multiplo B T k).
  { intros k H. pose proof (valor_of_multiples _ _ _ (on_axis c d 0) H) as E. rewrite VB, VT, A0 in E.
    apply (multiple_nonzero _ _ _ H). apply Rmult_eq_reg_r with h; lra. }
  assert (OW : W ∈ Cuadrica_ok).
  { apply (not_null _ _ (on_axis c d 0) VW). rewrite power_on_axis. pose proof (Rmult_lt_0_compat r r Hr Hr). lra. }
  assert (OB : B ∈ Cuadrica_ok) by (apply (not_null _ _ (on_axis c d 1) VB); rewrite A1; lra).
  assert (OT : T ∈ Cuadrica_ok) by (apply (not_null _ _ (on_axis c d 0) VT); rewrite A0; lra).
  destruct (inside_of_all (solido_cilindro c r d h) (fun q => q = W \/ q = B \/ q = T)) with (w := w) as [Body Inner].
  - now intros q [-> | [-> | ->]].
  - intros a b k Ha Hb H. pose proof (fun Oa Ob => multiple_back a b k Oa Ob H) as M.
    destruct Ha as [-> | [-> | ->]], Hb as [-> | [-> | ->]]; try reflexivity; exfalso;
      first [now apply (WB k) | now apply (WT k) | now apply (BT k)
            | now apply (WB (/ k)), M | now apply (WT (/ k)), M | now apply (BT (/ k)), M].
  - intros l Hl. split.
    + intros [[_ [b [t [Hb [Ht E]]]]] [q [Hq F]]].
      assert (q = W) by (apply same_coefficients; intros u; now rewrite F, VW).
      assert (b = B) by (apply same_coefficients; intros u; now rewrite (proj1 (E u)), VB).
      assert (t = T) by (apply same_coefficients; intros u; now rewrite (proj2 (E u)), VT).
      subst. now intros x [-> | [-> | ->]].
    + intros H. split; [split; [exact Hl |] |].
      * exists B, T. repeat split; auto.
      * exists W. split; auto.
  - assert (B' : w ∈ cuerpo (solido_cilindro c r d h) <-> potencia_cilindro w c r d <= 0 /\ 0 <= avance w c d <= h).
    { rewrite Body. split.
      - intros H. pose proof (H W (or_introl eq_refl)) as H1. pose proof (H B (or_intror (or_introl eq_refl))) as H2.
        pose proof (H T (or_intror (or_intror eq_refl))) as H3. rewrite VW in H1. rewrite VB in H2. rewrite VT in H3. lra.
      - intros H q [-> | [-> | ->]]; rewrite ?VW, ?VB, ?VT; lra. }
    assert (I' : w ∈ interior (solido_cilindro c r d h) <-> potencia_cilindro w c r d < 0 /\ 0 < avance w c d < h).
    { rewrite Inner. split.
      - intros H. pose proof (H W (or_introl eq_refl)) as H1. pose proof (H B (or_intror (or_introl eq_refl))) as H2.
        pose proof (H T (or_intror (or_intror eq_refl))) as H3. rewrite VW in H1. rewrite VB in H2. rewrite VT in H3. lra.
      - intros H q [-> | [-> | ->]]; rewrite ?VW, ?VB, ?VT; lra. }
    unfold superficie, diff. rewrite B', I'. change (w ∈ puntos_cilindro c r d h) with
      (potencia_cilindro w c r d = 0 /\ 0 <= avance w c d /\ avance w c d <= h).
    destruct (Rle_lt_dec 0 (potencia_cilindro w c r d)), (Rle_lt_dec (avance w c d) 0), (Rle_lt_dec h (avance w c d));
      split; intros; lra.
Qed.

(** The other two lie between their lids, where their powers are not above 0. Discharges solido_cono.def.1,
    solido_tronco.def.1. *)
Theorem cones_lie_within_their_bounds c w r p d h :
  (w ∈ cuerpo (solido_cono c p d h) -> potencia_cono w c p d h <= 0 /\ 0 <= avance w c d <= h) /\
  (w ∈ cuerpo (solido_tronco c r p d h) -> potencia_tronco w c r p d h <= 0 /\ 0 <= avance w c d <= h).
Proof.
  assert (Side : forall l q, l ∈ repartos (dentro w) (fuera w) -> q ∈ l -> valor q w <= 0).
  { intros l q [Hok [_ [Out _]]] Hq. apply Rnot_gt_le. intros E. apply (Out q); [split; auto | exact Hq]. }
  split; intros [l [Hl [[_ [b [t [Hb [Ht E]]]]] [q [Hq F]]]]]; rewrite <- F; destruct (E w) as [Eb Et];
    pose proof (Side l b Hl Hb); pose proof (Side l t Hl Ht); pose proof (Side l q Hl Hq); lra.
Qed.

(** ** Along a ray *)

(** The point of a ray at a parameter, and the value that the ray sees of a quadric at a point. *)
Definition at_parameter (rayo : Rayo) (t : R) : Punto :=
  mk_Punto (Punto_x (Rayo_p rayo) + t * Vector_x (Rayo_v rayo)) (Punto_y (Rayo_p rayo) + t * Vector_y (Rayo_v rayo))
    (Punto_z (Rayo_p rayo) + t * Vector_z (Rayo_v rayo)).
Definition member (P : Prop) : {P} + {~ P} :=
  match ClassicalDedekindReals.sig_not_dec P with left H => left (NNPP P H) | right H => right H end.
Definition value_from (rayo : Rayo) (en : set Cuadrica) (c : Cuadrica) (w : Punto) : R :=
  valor c w - (if member (c ∈ en) then valor c (Rayo_p rayo) else 0).

Lemma values_are_quadratic rayo en c : quadratic (fun t => value_from rayo en c (at_parameter rayo t)).
Proof.
  set (v := Rayo_v rayo). set (p := Rayo_p rayo).
  exists (Cuadrica_xx c * Vector_x v * Vector_x v + Cuadrica_yy c * Vector_y v * Vector_y v
    + Cuadrica_zz c * Vector_z v * Vector_z v + Cuadrica_yz c * Vector_y v * Vector_z v
    + Cuadrica_zx c * Vector_z v * Vector_x v + Cuadrica_xy c * Vector_x v * Vector_y v).
  exists (2 * Cuadrica_xx c * Punto_x p * Vector_x v + 2 * Cuadrica_yy c * Punto_y p * Vector_y v
    + 2 * Cuadrica_zz c * Punto_z p * Vector_z v + Cuadrica_yz c * (Punto_y p * Vector_z v + Punto_z p * Vector_y v)
    + Cuadrica_zx c * (Punto_z p * Vector_x v + Punto_x p * Vector_z v)
    + Cuadrica_xy c * (Punto_x p * Vector_y v + Punto_y p * Vector_x v)
    + Cuadrica_x c * Vector_x v + Cuadrica_y c * Vector_y v + Cuadrica_z c * Vector_z v).
  exists (value_from rayo en c p). intros t. unfold value_from, at_parameter, valor, cuadrado. cbn. fold p v. ring.
Qed.

Lemma values_from_go_along rayo en w : en ∈ con_multiplos -> goes_along (fun c => value_from rayo en c w).
Proof.
  intros [_ Hen] a b k Ha Hb H. pose proof (Hen a b k Ha Hb H) as E. unfold value_from.
  rewrite !(valor_of_multiples _ _ _ _ H).
  destruct (member (a ∈ en)), (member (b ∈ en)); try tauto; ring.
Qed.

Lemma sides_from rayo en w : dentro_desde (Rayo_p rayo) en w ≡ below (fun c => value_from rayo en c w)
  /\ fuera_desde (Rayo_p rayo) en w ≡ above (fun c => value_from rayo en c w).
Proof.
  split; intros c; unfold dentro_desde, fuera_desde, below, above, value_from;
    destruct (member (c ∈ en)) as [H | H]; split; intros [Hok E]; (split; [exact Hok |]);
    try (destruct E as [[? E] | [? E]]; [try contradiction; lra | try contradiction; lra]);
    try (left; split; [exact H | lra]); try (right; split; [exact H | lra]).
Qed.

Lemma same_allotments ds ds' fs fs' : ds ≡ ds' -> fs ≡ fs' -> repartos ds fs ≡ repartos ds' fs'.
Proof. intros Hd Hf l. unfold repartos. setoid_rewrite (Hf _). now rewrite Hd. Qed.

(** What a ray sees of a solid at a point, it sees at any point where the quadrics of the solid have the same sides, or
    are zero. *)
Lemma closed_from S cs rayo en u w : hecho_de S cs -> cs ⊆ Cuadrica_ok -> en ∈ con_multiplos -> w ∈ puntos_de_rayo rayo ->
  (forall c, c ∈ cs -> (value_from rayo en c w < 0 -> value_from rayo en c u < 0)
                       /\ (value_from rayo en c w > 0 -> value_from rayo en c u > 0)) ->
  superficie_desde S rayo en u -> superficie_desde S rayo en w.
Proof.
  intros HS Hcs Hen Hw Side [_ [[l [Hl Inl]] [m [Hm Outm]]]]. split; [exact Hw |].
  destruct (sides_from rayo en u) as [Du Fu]. destruct (sides_from rayo en w) as [Dw Fw].
  pose proof (same_allotments _ _ _ _ Du Fu) as Ru. pose proof (same_allotments _ _ _ _ Dw Fw) as Rw.
  assert (Carry : forall l, l ∈ repartos (dentro_desde (Rayo_p rayo) en u) (fuera_desde (Rayo_p rayo) en u) ->
    exists l', l' ∈ repartos (dentro_desde (Rayo_p rayo) en w) (fuera_desde (Rayo_p rayo) en w) /\ (l' ∈ S <-> l ∈ S)).
  { intros k Hk. apply Ru in Hk. pose proof (of_quadrics _ _ _ Hk) as Ok.
    destruct (extension (fun c => value_from rayo en c w) cs k) as [k' [Hk' Same]].
    - now apply values_from_go_along.
    - destruct Hk as [_ [Hd [Hf Hm']]]. split; [exact Hcs | split].
      + intros c Hc. specialize (Side c Hc) as [Sn Sp]. split; intros E; [apply Hd | apply Hf]; split; auto.
      + intros a b j Ha Hb. apply Hm'; auto.
    - exists k'. split; [now apply Rw |]. apply HS; [exact (of_quadrics _ _ _ Hk') | exact Ok | exact Same]. }
  destruct (Carry l Hl) as [l' [Hl' El]], (Carry m Hm) as [m' [Hm' Em]].
  split; [exists l' | exists m']; split; tauto.
Qed.

(** Discharges hecho_de.def.1, en_parametro.def.1, dentro_desde.def.1, fuera_desde.def.1, con_multiplos.def.1,
    superficie_desde.def.1, superficie_desde.conj.1. *)
Theorem a_ray_meets_the_surface_first_in_a_point_or_runs_along_it : superficie_desde_conj_1.
Proof.
  intros S cs rayo en w _ [Hcs [known Hknown]] _ Hen HS Hw.
  set (F := fun c t => value_from rayo en c (at_parameter rayo t)).
  assert (HF : forall c, quadratic (F c)) by (intros c; apply values_are_quadratic).
  assert (Point : forall t q, en_parametro rayo t q -> q = at_parameter rayo t).
  { intros t [x y z] [Ex [Ey Ez]]. cbn in *. unfold at_parameter. now rewrite <- Ex, <- Ey, <- Ez. }
  assert (On : forall t, t > 0 -> at_parameter rayo t ∈ puntos_de_rayo rayo).
  { intros t Ht. exists t. split; [exact Ht |]. repeat split. }
  set (T := fun t => t > 0 /\ superficie_desde S rayo en (at_parameter rayo t)).
  assert (T0 : exists t, T t).
  { pose proof Hw as [[t [Ht Q]] _]. exists t. split; [exact Ht |]. pose proof (Point t w Q) as E. rewrite <- E. exact Hw. }
  destruct T0 as [t0 Ht0].
  destruct (completeness (fun x => forall t, T t -> x <= t)) as [m [Ub Lub]].
  { exists t0. intros x Hx. now apply Hx. }
  { exists 0. intros t [Ht _]. lra. }
  assert (Low : forall t, T t -> m <= t) by (intros t Ht; apply Lub; intros x Hx; now apply Hx).
  assert (M0 : 0 <= m) by (apply Ub; intros t [Ht _]; lra).
  destruct (classic (T m)) as [Hm | Hm].
  - left. exists m, (at_parameter rayo m). destruct Hm as [Hpos Hm]. split; [exact Hpos |].
    split; [repeat split | split; [exact Hm |]].
    intros s u Hs Hu H. apply Low. split; [exact Hs |]. rewrite <- (Point s u Hu). exact H.
  - destruct (signs_after F known m HF) as [e [He Signs]].
    assert (Near : exists t, T t /\ m < t < m + e).
    { apply NNPP. intros N. assert (m + e <= m); [| lra]. apply Ub. intros t Ht. apply Rnot_lt_le. intros Hlt. apply N.
      exists t. split; [exact Ht |]. split; [| exact Hlt]. destruct (Low t Ht) as [H | <-]; [exact H | contradiction]. }
    destruct Near as [t [[Ht HT] Hte]]. destruct (Rle_lt_or_eq_dec 0 m M0) as [Hm0 | <-].
    + exfalso. apply Hm. split; [exact Hm0 |].
      apply (closed_from S cs rayo en (at_parameter rayo t)); [exact HS | exact Hcs | exact Hen | now apply On | | exact HT].
      intros c Hc. apply Hknown in Hc. exact (proj2 (Signs c t t Hc Hte Hte)).
    + right. exists e. split; [exact He |]. intros s u Hs Hse Hu. rewrite (Point s u Hu).
      apply (closed_from S cs rayo en (at_parameter rayo t)); [exact HS | exact Hcs | exact Hen | now apply On | | exact HT].
      intros c Hc. apply Hknown in Hc. destruct (Signs c s t Hc) as [[En Ep] _]; [change (s > 0) in Hs; lra | exact Hte |].
      fold (F c s) (F c t). tauto.
Qed.

(** Discharges superficie_desde.conj.2. *)
Theorem a_ray_that_starts_on_nothing_meets_the_surface : superficie_desde_conj_2.
Proof.
  intros S rayo w _ _.
  assert (R : repartos (dentro_desde (Rayo_p rayo) ∅ w) (fuera_desde (Rayo_p rayo) ∅ w) ≡ repartos (dentro w) (fuera w)).
  { apply same_allotments; intros c; unfold dentro_desde, fuera_desde, dentro, fuera, empty; cbn; tauto. }
  unfold superficie_desde, interseccion, superficie, cuerpo, interior, inter, diff. split.
  - intros [Hw [[l [Hl Il]] [m [Hm Om]]]]. split; [exact Hw | split].
    + exists l. split; [now apply R | exact Il].
    + intros H. apply Om, H. now apply R.
  - intros [Hw [[l [Hl Il]] N]]. split; [exact Hw | split; [exists l; split; [now apply R | exact Il] |]].
    apply not_all_ex_not in N as [m N]. apply imply_to_and in N as [Hm Om]. exists m. split; [now apply R | exact Om].
Qed.

(** There are such solids and rays: the ball of radius one about the origin, and a ray along the last axis towards it. *)
Theorem a_ray_meets_a_solid_ball :
  let o := mk_Punto 0 0 0 in let rayo := mk_Rayo (mk_Punto 0 0 (-2)) (mk_Vector 0 0 1) in
  hecho_de (solido_esfera o 1) ⦃sphere_quadric o 1⦄ /\ ⦃sphere_quadric o 1⦄ ∈ 𝔽 Cuadrica_ok /\ rayo ∈ Rayo_ok
  /\ ∅ ∈ con_multiplos /\ superficie_desde (solido_esfera o 1) rayo ∅ (mk_Punto 0 0 (-1)).
Proof.
  intros o rayo. split; [| split; [| split; [| split]]].
  - intros l m Hl Hm Same. rewrite (in_solid_sphere _ _ _ Hl), (in_solid_sphere _ _ _ Hm). now apply Same.
  - split; [intros c ->; apply sphere_is_a_quadric; lra |]. exists (sphere_quadric o 1 :: nil). intros c.
    unfold single. cbn. intuition congruence.
  - constructor. cbn. lra.
  - split; [easy |]. now intros a b k.
  - apply a_ray_that_starts_on_nothing_meets_the_surface; [now intros l [H _] | constructor; cbn; lra |]. split.
    + exists 1. split; [unfold Rmas; lra |]. cbn. repeat split; lra.
    + apply the_surface_of_a_solid_sphere_is_the_sphere; [unfold Rmas; lra |].
      unfold puntos_esfera, potencia_esfera, cuadrado, o. cbn. lra.
Qed.

(** ** The walk *)

(** The program sorts the roots of the quadrics along the ray and goes from one to the next. Between two of them no
    quadric changes its side, and each has at a root the sides of after it, or is zero. So the first root on the surface
    is the least parameter on it, unless the ray runs along the surface before the first root. *)
Theorem the_first_root_on_the_surface_is_the_first_of_the_surface S cs rayo en (roots : list R) t :
  hecho_de S cs -> cs ⊆ Cuadrica_ok -> en ∈ con_multiplos ->
  (forall c s u, c ∈ cs -> 0 < s -> 0 < u -> (forall r, In r roots -> r <= s \/ u < r) ->
    let f x := value_from rayo en c (at_parameter rayo x) in s <= u -> (f s < 0 -> f u < 0) /\ (f s > 0 -> f u > 0)) ->
  (forall r, In r roots -> r < t -> ~ superficie_desde S rayo en (at_parameter rayo r)) ->
  (forall s, 0 < s -> (forall r, In r roots -> s < r) -> ~ superficie_desde S rayo en (at_parameter rayo s)) ->
  (forall r, In r roots -> r > 0) ->
  forall s, 0 < s < t -> ~ superficie_desde S rayo en (at_parameter rayo s).
Proof.
  intros HS Hcs Hen Sides Before Start Pos s [Hs Hst] H.
  assert (G : (forall r, In r roots -> s < r) \/ exists r, In r roots /\ r <= s /\ forall q, In q roots -> q <= r \/ s < q).
  { clear - roots. induction roots as [| a l [IH | [r [Hr [Hrs IH]]]]]; [now left | |].
    - destruct (Rlt_le_dec s a) as [Ha | Ha].
      + left. intros q [<- | Hq]; auto.
      + right. exists a. split; [now left | split; [exact Ha |]]. intros q [<- | Hq]; [left; lra | right; auto].
    - right. destruct (Rlt_le_dec s a) as [Ha | Ha].
      + exists r. split; [now right | split; [exact Hrs |]]. intros q [<- | Hq]; [now right | auto].
      + exists (Rmax r a). split; [unfold Rmax; destruct (Rle_dec r a); [now left | now right] |].
        split; [now apply Rmax_lub |]. pose proof (Rmax_l r a). pose proof (Rmax_r r a).
        intros q [<- | Hq]; [left; lra |]. destruct (IH q Hq); [left; lra | now right]. }
  destruct G as [G | [r [Hr [Hrs G]]]]; [now apply (Start s) |].
  pose proof (Pos r Hr) as R0. apply (Before r Hr); [lra |].
  apply (closed_from S cs rayo en (at_parameter rayo s)); [exact HS | exact Hcs | exact Hen | | | exact H].
  - exists r. split; [exact R0 |]. repeat split.
  - intros c Hc. now apply (Sides c r s Hc R0 Hs G).
Qed.

Theorem the_conjectures_hold :
  cuerpo_conj_1 /\ interior_conj_1 /\ superficie_conj_1 /\ interior_conj_2 /\ cuerpo_conj_2 /\ interior_conj_3
  /\ solido_esfera_conj_1 /\ solido_plano_conj_1 /\ solido_cilindro_conj_1 /\ superficie_conj_2
  /\ superficie_desde_conj_1 /\ superficie_desde_conj_2.
Proof.
  exact (conj the_body_of_a_union_is_the_union_of_the_bodies (conj the_interior_of_an_intersection_is_that_of_both (conj
    the_rest_of_space_has_the_same_surface (conj the_interior_of_a_difference_is_outside_of_what_is_taken (conj
    a_difference_has_nothing_of_the_inside_of_what_is_taken (conj the_interior_is_of_the_body (conj
    the_surface_of_a_solid_sphere_is_the_sphere (conj the_surface_of_what_lies_behind_a_plane_is_the_plane (conj
    the_surface_of_a_solid_cylinder_is_the_cylinder_and_two_lids (conj body_and_surface_are_closed (conj
    a_ray_meets_the_surface_first_in_a_point_or_runs_along_it
    a_ray_that_starts_on_nothing_meets_the_surface))))))))))).
Qed.
