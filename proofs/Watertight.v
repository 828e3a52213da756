(** spec/malla.tex: the signs at the edges of triangles decide what the line of a ray meets, and no line passes between two
    triangles that share an edge.

    point_at ray t       == p + t·v, as in Puntos.v *)
From Coq Require Import Reals Lra.
From Durero Require Import Toolkit Especificacion Tipos Puntos Flat Malla.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** The line of a ray has its points at every parameter. Discharges recta.def.1. *)
Theorem the_line_of_a_ray ray w : w ∈ recta ray <-> exists t, w = point_at ray t.
Proof.
  split.
  - intros [t [Hx [Hy Hz]]]. exists t. destruct w; cbn in *. now subst.
  - intros [t ->]. now exists t.
Qed.

(** An edge has one volume but for the sign, whichever of its ends comes first. Discharges giro.def.1, giro.conj.1. *)
Theorem an_edge_turns_one_way : giro_conj_1.
Proof. intros ray a b _. unfold giro. ring. Qed.

(** With the products of Möller and Trumbore, as Flat.v has them: their signs are those of the volumes.
    Discharges cruce.def.1. *)
Theorem volumes_of_the_program ray v : let a := Terna_a v in let b := Terna_b v in let c := Terna_c v in
  let E1 := from a b in let E2 := from a c in let T := from a (Rayo_p ray) in let P := cross (Rayo_v ray) E2 in
  let Q := cross T E1 in
  dot E1 P = - cruce ray v /\ dot (Rayo_v ray) Q = - giro ray a b /\ dot T P = - giro ray c a
  /\ dot E1 P - dot T P - dot (Rayo_v ray) Q = - giro ray b c.
Proof.
  cbv zeta. destruct ray as [[px py pz] [vx vy vz]], v as [[ax ay az] [bx b_y bz] [cx cy cz]].
  unfold cruce, giro, from, cross, dot; cbn. repeat split; ring.
Qed.

(** The line of a ray that is not parallel to a triangle meets its plane in one point, and the triangle there or nowhere. *)
Lemma one_point_of_the_plane ray v : cruce ray v <> 0 -> exists t0,
  (forall t, potencia_triangulo (point_at ray t) v = 0 <-> t = t0)
  /\ lado (point_at ray t0) (Terna_a v) (Terna_b v) (Terna_c v) * cruce ray v
     = sq (normal v) * giro ray (Terna_a v) (Terna_b v)
  /\ (point_at ray t0 ∈ puntos_triangulo v <->
      0 <= giro ray (Terna_a v) (Terna_b v) * cruce ray v /\ 0 <= giro ray (Terna_b v) (Terna_c v) * cruce ray v
      /\ 0 <= giro ray (Terna_c v) (Terna_a v) * cruce ray v).
Proof.
  intros N. destruct (program_of_a_triangle ray v) as [_ H]. destruct (volumes_of_the_program ray v) as [D [Q [P B]]].
  cbv zeta in *. rewrite D, P, Q in *.
  assert (D0 : - cruce ray v <> 0) by lra. destruct (H D0) as [H0 [H1 [_ [_ Clip]]]].
  eexists. split; [exact H0 |]. split; [lra |].
  replace (- cruce ray v - - giro ray (Terna_c v) (Terna_a v) - - giro ray (Terna_a v) (Terna_b v)) with
    (- giro ray (Terna_b v) (Terna_c v)) in Clip by lra.
  rewrite !Rmult_opp_opp in Clip. rewrite <- Clip. split; [now intros [K _] | intros K]. split; [exact K |].
  now apply H0.
Qed.

(** Of three numbers whose sum is not zero: they have one sign exactly where none has the sign against the sum. *)
Lemma one_sign x y z : x + y + z <> 0 ->
  (0 <= x * (x + y + z) /\ 0 <= y * (x + y + z) /\ 0 <= z * (x + y + z) <->
   (x >= 0 /\ y >= 0 /\ z >= 0) \/ (x <= 0 /\ y <= 0 /\ z <= 0)).
Proof.
  intros N. set (s := x + y + z) in *.
  assert (E : forall u, 0 <= u * s -> (0 < s -> 0 <= u) /\ (s < 0 -> u <= 0)).
  { intros u H. split; intros Hs; [apply Rmult_le_reg_r with s | apply Rmult_le_reg_r with (- s)]; lra. }
  assert (F : forall u, 0 <= u -> 0 <= s -> 0 <= u * s) by (intros; now apply Rmult_le_pos).
  assert (G : forall u, u <= 0 -> s <= 0 -> 0 <= u * s).
  { intros u Hu Hs. replace (u * s) with ((- u) * (- s)) by ring. apply Rmult_le_pos; lra. }
  split.
  - intros [Hx [Hy Hz]]. destruct (E x Hx), (E y Hy), (E z Hz). destruct (Rtotal_order s 0) as [L | [L | L]];
      [right | lra | left]; repeat split; try apply Rle_ge; auto.
  - intros [[Hx [Hy Hz]] | [Hx [Hy Hz]]]; repeat split; [apply F .. | apply G | apply G | apply G]; unfold s; lra.
Qed.

(** The three signs decide. *)
Lemma the_line_meets ray v : cruce ray v <> 0 ->
  ((exists w, w ∈ recta ray /\ w ∈ puntos_triangulo v) <->
   (giro ray (Terna_a v) (Terna_b v) >= 0 /\ giro ray (Terna_b v) (Terna_c v) >= 0
    /\ giro ray (Terna_c v) (Terna_a v) >= 0)
   \/ (giro ray (Terna_a v) (Terna_b v) <= 0 /\ giro ray (Terna_b v) (Terna_c v) <= 0
    /\ giro ray (Terna_c v) (Terna_a v) <= 0)).
Proof.
  intros N. rewrite <- (one_sign _ _ _ N). fold (cruce ray v).
  destruct (one_point_of_the_plane ray v N) as [t0 [Plane [_ Inside]]]. rewrite <- Inside. split.
  - intros [w [L Hw]]. apply the_line_of_a_ray in L as [t ->]. pose proof (proj2 Hw) as K. apply Plane in K. now subst.
  - intros Hw. exists (point_at ray t0). split; [apply the_line_of_a_ray; now exists t0 | exact Hw].
Qed.
Lemma not_empty {X} (A B : set X) : (exists x, A x /\ B x) -> ~ A ∩ B ≡ ∅.
Proof. intros [x Hx] E. exact (proj1 (E x) Hx). Qed.

(** Discharges giro.conj.2. *)
Theorem three_signs_decide : giro_conj_2.
Proof.
  intros ray v _ _ N. rewrite <- (the_line_meets ray v N). split; [| apply not_empty].
  intros H. apply Classical_Prop.NNPP. intros K. apply H. intros w. split; [| intros []]. intros Hw. apply K. now exists w.
Qed.

(** Discharges Vecinos.def.1, giro.conj.3. *)
Theorem no_line_passes_between : giro_conj_3.
Proof.
  intros ray v w ok [_ [_ [Ea Eb]]] [Nv [Nw H]]. apply not_empty.
  pose proof (the_line_meets ray v Nv) as Mv. pose proof (the_line_meets ray w Nw) as Mw.
  pose proof (an_edge_turns_one_way ray (Terna_a v) (Terna_b v) ok) as Turn. rewrite Ea, Eb in *.
  assert (K : (exists q, q ∈ recta ray /\ q ∈ puntos_triangulo v) \/ exists q, q ∈ recta ray /\ q ∈ puntos_triangulo w).
  { rewrite Mv, Mw. destruct (Rle_dec 0 (giro ray (Terna_a v) (Terna_b v))), H;
      [left; left | right; right | right; left | left; right]; repeat split; lra. }
  destruct K as [[q [L Hq]] | [q [L Hq]]]; exists q; (split; [exact L |]); [now left | now right].
Qed.

(** Discharges giro.conj.4. *)
Theorem what_meets_the_edge_meets_both : giro_conj_4.
Proof.
  intros ray v w _ [Vv [_ [Ea Eb]]] [Nv Zero] q [L Hq]. apply the_line_of_a_ray in L as [t ->].
  destruct (one_point_of_the_plane ray v Nv) as [t0 [Plane [Side _]]].
  pose proof (proj2 Hq) as K. apply Plane in K. subst t0. rewrite Zero, Rmult_0_r in Side.
  assert (S : lado (point_at ray t) (Terna_a v) (Terna_b v) (Terna_c v) = 0).
  { apply Rmult_integral in Side as [S | S]; [exact S | contradiction]. }
  apply (triangle_is_the_convex_combinations v _ Vv) in Hq as [beta [gamma [Hb [Hg [Hs E]]]]].
  rewrite E in S. destruct (sides_of_a_combination v beta gamma) as [_ [G _]]. cbv zeta in G. rewrite S in G.
  apply vertices_have_a_normal in Vv. symmetry in G. apply Rmult_integral in G as [G | G]; [| lra]. subst gamma.
  rewrite E. replace (combination v beta 0) with (toward (Terna_a v) (Terna_b v) beta).
  - apply triangle_contains_its_edges; [right; left; now symmetry | left; now symmetry | lra].
  - unfold toward, combination. f_equal; ring.
Qed.
