(** * Levels: what is rounded of a point on a flat surface

    Formas.Pairs.round_plano, round_disco and round_triangulo, of src/trace/rounding-inl.hpp. Where a plane stands at a right
    angle to an axis, all its points have one coordinate in common, that of its centre or of the corners; no interval about a
    computed one is asked then. Elsewhere it is as Once.v has it.

    level_of_centre, level_of_corners, either, joined == as there
    round_on p v sh t e    == what the program rounds of a hit of the element with the numbers sh *)
From Coq Require Import Reals ZArith Lra Lia Bool.
From Flocq Require Import Core.
From Durero Require Import Toolkit Especificacion Escena Puntos.
From Durero Require Import Rounding Vectors Flotante Steps Triage Twofold Once AtRoot AtRootText.
From Durero Require Formas Chain Tipos.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Open Scope zed_scope.
Local Opaque bpow.

Definition level_of_centre (c other another : R) : once := Once (rnd (c + 0)) (andb (Req_bool other 0) (Req_bool another 0)).
Definition level_of_corners (a b c : R) : once := Once (rnd (a + 0)) (andb (Req_bool a b) (Req_bool a c)).
Definition either (first second : once) : once :=
  Once (if certain first then rounded first else rounded second) (orb (certain first) (certain second)).
Definition joined (t x y z : once) : once_point := Once_point (rounded t) (rounded x) (rounded y) (rounded z)
  (andb (andb (andb (certain t) (certain x)) (certain y)) (certain z)).

Definition round_on (p v : vec) (sh : shape) (t : twofold) (error : R) : once_point :=
  match sh with
  | Plane c d => round_plano p v t error c d
  | Disc c r d => round_disco p v t error c r d
  | Triangle a b c => round_triangulo p v t error a b c
  | _ => round_point p v t error
  end.

(** It is right of x. *)
Definition rounds_to (o : once) (x : R) : Prop := certain o = true -> rounded o = rnd x /\ Rabs (rnd x) < bpow radix2 900.

Lemma either_right first second x : rounds_to first x -> rounds_to second x -> rounds_to (either first second) x.
Proof.
  unfold rounds_to, either; cbn [certain rounded]; intros F S; destruct (certain first); cbn [orb]; auto.
Qed.

Lemma both_zero a b : andb (Req_bool a 0) (Req_bool b 0) = true -> a = 0 /\ b = 0.
Proof. intros H; apply andb_true_iff in H as [A B]; destruct (Req_bool_spec a 0), (Req_bool_spec b 0); try discriminate; auto. Qed.

(** A coordinate that all points of the plane have. *)
Lemma level_right c x : ordinary c -> x = c -> rnd (c + 0) = rnd x /\ Rabs (rnd x) < bpow radix2 900.
Proof.
  intros Hc ->; rewrite Rplus_0_r; split; [reflexivity|]; rewrite (rnd_format c (proj1 Hc)).
  apply Rle_lt_trans with (1 := ordinary_size c Hc), bpow_lt; lia.
Qed.

(** The only component of a normal that is not 0. *)
Lemma only_component n w c : n <> 0 -> n * (w - c) = 0 -> w = c.
Proof. intros N H; apply Rmult_integral in H as [H|H]; [contradiction | lra]. Qed.

Section Flat.
Variables p v c n : vec.
Variable T : R.
Hypothesis c_ordinary : ordinary_vec c.
Hypothesis n_not_zero : n <> Vec 0 0 0.
Let w := Vec (cx p + T * cx v) (cy p + T * cy v) (cz p + T * cz v).
Hypothesis in_plane : dot (minus w c) n = 0.

Lemma levels_of_centre_right : rounds_to (level_of_centre (cx c) (cy n) (cz n)) (cx w) /\
  rounds_to (level_of_centre (cy c) (cz n) (cx n)) (cy w) /\ rounds_to (level_of_centre (cz c) (cx n) (cy n)) (cz w).
Proof.
  destruct c_ordinary as (Ox & Oy & Oz); unfold dot, minus in in_plane; cbn [cx cy cz] in in_plane.
  unfold rounds_to, level_of_centre; cbn [certain rounded]; split; [|split]; intros H; apply both_zero in H as [A B];
    apply level_right; auto.
  - apply (only_component (cx n)); [|rewrite A, B in in_plane; rewrite <- in_plane; unfold w; cbn; ring].
    intros Z0; apply n_not_zero; destruct n; cbn in *; now subst.
  - apply (only_component (cy n)); [|rewrite A, B in in_plane; rewrite <- in_plane; unfold w; cbn; ring].
    intros Z0; apply n_not_zero; destruct n; cbn in *; now subst.
  - apply (only_component (cz n)); [|rewrite A, B in in_plane; rewrite <- in_plane; unfold w; cbn; ring].
    intros Z0; apply n_not_zero; destruct n; cbn in *; now subst.
Qed.
End Flat.

Section Ray.
Variables p v : vec.
Hypothesis ray_ordinary : ordinary_ray p v.
Notation ray := (ray_of p v).

Variables (t : twofold) (error T : R).
Hypothesis t_pair : pair t.
Hypothesis error_binary64 : format error.
Hypothesis error_least : bpow radix2 (-900) <= error.
Hypothesis t_near : Rabs (T - whole t) <= error.

Lemma joined_right x y z out : rounds_to x (cx p + T * cx v) -> rounds_to y (cy p + T * cy v) -> rounds_to z (cz p + T * cz v) ->
  all_certain (joined (round_once t error) x y z) = true -> stores out (joined (round_once t error) x y z) ->
  Chain.rounds ray out T.
Proof.
  intros X Y Z0; unfold joined; cbn [all_certain]; rewrite !andb_true_iff.
  intros [[[Ct Cx] Cy] Cz] (St & Sx & Sy & Sz); cbn [of_t of_x of_y of_z] in *; pose proof (bpow_gt_0 radix2 (-900)).
  split; [|split; [|split]].
  - apply (stored_once _ _ _ St), round_once_right; [apply t_pair | exact error_binary64 | | lra | exact Ct].
    apply Rle_trans with (2 := error_least), bpow_le; lia.
  - exact (stored_once _ _ _ Sx (X Cx)).
  - exact (stored_once _ _ _ Sy (Y Cy)).
  - exact (stored_once _ _ _ Sz (Z0 Cz)).
Qed.

Lemma coordinates_right : rounds_to (round_coordinate (cx p) (cx v) t error) (cx p + T * cx v) /\
  rounds_to (round_coordinate (cy p) (cy v) t error) (cy p + T * cy v) /\
  rounds_to (round_coordinate (cz p) (cz v) t error) (cz p + T * cz v).
Proof.
  destruct (p_ordinary ray_ordinary) as (Px & Py & Pz), (v_ordinary ray_ordinary) as (Vx & Vy & Vz); split; [|split];
  intros H; now apply round_coordinate_right.
Qed.

Lemma plane_is c n : round_plano p v t error c n = joined (round_once t error)
  (either (level_of_centre (cx c) (cy n) (cz n)) (round_coordinate (cx p) (cx v) t error))
  (either (level_of_centre (cy c) (cz n) (cx n)) (round_coordinate (cy p) (cy v) t error))
  (either (level_of_centre (cz c) (cx n) (cy n)) (round_coordinate (cz p) (cz v) t error)).
Proof. reflexivity. Qed.

Lemma triangle_is a b c : round_triangulo p v t error a b c = joined (round_once t error)
  (either (level_of_corners (cx a) (cx b) (cx c)) (round_coordinate (cx p) (cx v) t error))
  (either (level_of_corners (cy a) (cy b) (cy c)) (round_coordinate (cy p) (cy v) t error))
  (either (level_of_corners (cz a) (cz b) (cz c)) (round_coordinate (cz p) (cz v) t error)).
Proof. reflexivity. Qed.

Lemma plane_right c n out : ordinary_vec c -> n <> Vec 0 0 0 ->
  dot (minus (Vec (cx p + T * cx v) (cy p + T * cy v) (cz p + T * cz v)) c) n = 0 ->
  all_certain (round_plano p v t error c n) = true -> stores out (round_plano p v t error c n) -> Chain.rounds ray out T.
Proof.
  intros Hc Hn Hw; rewrite plane_is; destruct (levels_of_centre_right p v c n T Hc Hn Hw) as (X & Y & Z0).
  destruct coordinates_right as (CX & CY & CZ); apply joined_right; now apply either_right.
Qed.

(** The corners of a plane across an axis have the coordinate of its points. *)
Lemma corners_as_centre a b c x y : (a = b -> a = c -> x = 0 /\ y = 0) ->
  certain (level_of_corners a b c) = true -> certain (level_of_centre a x y) = true.
Proof.
  intros H C; unfold level_of_corners, level_of_centre in *; cbn [certain] in *; apply andb_true_iff in C as [A B].
  destruct (Req_bool_spec a b), (Req_bool_spec a c); try discriminate; destruct H as [-> ->]; auto; now rewrite Req_bool_true.
Qed.

Lemma triangle_right a b c out : ordinary_vec a -> let n := cross (minus b a) (minus c a) in n <> Vec 0 0 0 ->
  dot (minus (Vec (cx p + T * cx v) (cy p + T * cy v) (cz p + T * cz v)) a) n = 0 ->
  all_certain (round_triangulo p v t error a b c) = true -> stores out (round_triangulo p v t error a b c) -> Chain.rounds ray out T.
Proof.
  intros Ha n Hn Hw; rewrite triangle_is; destruct (levels_of_centre_right p v a n T Ha Hn Hw) as (X & Y & Z0).
  destruct coordinates_right as (CX & CY & CZ); apply joined_right; apply either_right; auto; intros C.
  - apply X; revert C; apply corners_as_centre; intros E F; unfold n, cross, minus; cbn; rewrite <- E, <- F; split; ring.
  - apply Y; revert C; apply corners_as_centre; intros E F; unfold n, cross, minus; cbn; rewrite <- E, <- F; split; ring.
  - apply Z0; revert C; apply corners_as_centre; intros E F; unfold n, cross, minus; cbn; rewrite <- E, <- F; split; ring.
Qed.
End Ray.

(** ** Of an element of a scene *)

Definition is_flat (sh : shape) : bool := match sh with Plane _ _ | Disc _ _ _ | Triangle _ _ _ => true | _ => false end.

Lemma axis_not_zero d : direction d ∈ Unitario -> d <> Vec 0 0 0.
Proof.
  intros Hd ->; apply axis_exact in Hd; unfold dot in Hd; cbn in Hd; pose proof u_bounds.
  apply Rabs_le_inv in Hd; lra.
Qed.

Lemma normal_not_zero a b c : vertices a b c ∈ Vertices -> cross (minus b a) (minus c a) <> Vec 0 0 0.
Proof.
  intros H E; apply H; unfold cross, minus in E; cbn in E; injection E as Ex Ey Ez; cbn; repeat split; lra.
Qed.

Theorem round_on_right Elemento (s : Especificacion.Escena Elemento) p v e sh t error T out :
  Escena_ok s -> ordinary_ray p v ->
  stands Elemento s e sh -> ordinary_shape sh -> (is_flat sh = true -> value (text_of p v sh) T = 0) ->
  pair t -> format error -> bpow radix2 (-900) <= error -> Rabs (T - whole t) <= error ->
  all_certain (round_on p v sh t error) = true -> stores out (round_on p v sh t error) -> Chain.rounds (ray_of p v) out T.
Proof.
  intros ok Ray Hs Ho Hflat Ht Fe Le HT.
  assert (HD : forall d, (e, d) ∈ mi_vector s -> d ∈ Unitario) by (intros; apply (Escena_inv_8 ok); now exists e).
  assert (In_plane : forall c n, value (text_of p v sh) T = dot (exact_place p v T c) n -> value (text_of p v sh) T = 0 ->
    dot (minus (Vec (cx p + T * cx v) (cy p + T * cy v) (cz p + T * cz v)) c) n = 0).
  { intros c n E V; rewrite E in V; rewrite <- V; unfold dot, exact_place, minus; cbn; ring. }
  destruct sh as [c r | c r d h | c k d h | c r k d h | c d | c r d | a b c]; cbn [is_flat round_on ordinary_shape] in *;
    try exact (certain_is_rounded_right p v t error T out (p_ordinary Ray) (v_ordinary Ray) Ht Fe Le HT).
  - destruct Hs as (_ & _ & Hd), Ho as [Oc _].
    apply (plane_right p v Ray t error T Ht Fe Le HT c d out Oc (axis_not_zero d (HD _ Hd))).
    apply In_plane; [now apply flat_value | auto].
  - destruct Hs as (_ & _ & _ & Hd), Ho as (Oc & _ & _).
    apply (plane_right p v Ray t error T Ht Fe Le HT c d out Oc (axis_not_zero d (HD _ Hd))).
    apply In_plane; [now apply flat_value | auto].
  - destruct Hs as (_ & Hv'), Ho as (Oa & _ & _); assert (HV : vertices a b c ∈ Vertices) by (apply (Escena_decl_mi_vertices ok); now exists e).
    apply (triangle_right p v Ray t error T Ht Fe Le HT a b c out Oa (normal_not_zero a b c HV)); apply In_plane;
    [now apply flat_value | auto].
Qed.
