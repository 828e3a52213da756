(** * Wide: the hierarchy of eight boxes a node, in binary32, as it runs

    accel/wide_bvh rounds the box of each element outwards to binary32 and joins them on the way up; accel/wide_node takes
    the planes back to binary64, exactly, and tests them there by the operations of Slab.v, eight at a time; what is met
    waits with its entry, and is left behind once the limit has fallen below that.

    promoted y             == the binary32 y as a binary64;  nearest x == the binary64 x as the nearest binary32
    below x, above x       == the greatest binary32 that is not above x, the least that is not below
    box32, outwards b      == six planes of binary32;  the box b rounded outwards;  in_binary64 c == c, taken exactly
    within c d             == each plane of c is within those of d
    wide, place            == what lies in a place of a node: nothing, an element, a node; with its box
    nested bounds ps       == the boxes of elements are their bounds, rounded outwards, and are within all boxes above
    elements_of ps         == the elements in these places and below
    asked r                == the ray is of ordinary numbers, by the recorded test
    prunable st c          == the box of c is rejected up to the limit of st, or its place is empty *)
From Coq Require Import ZArith Reals List Bool Lra Lia.
From Flocq Require Import Core BinarySingleNaN.
From Durero Require Import Toolkit Especificacion Puntos Interseccion Slab Walk Limits Boxes.
From Durero Require Vectors Flotante Formas Chain.
Import ListNotations.
Local Open Scope R_scope.

(** ** Between the two formats *)

Notation binary32 := (binary_float 24 128).
Notation rnd32 := (round radix2 (FLT_exp (-149) 24) ZnearestE).

Local Instance prec53 : Prec_gt_0 53 := eq_refl.
Local Instance prec24 : Prec_gt_0 24 := eq_refl.

Definition promoted (y : binary32) : binary64 :=
  match y with
  | B754_zero s => B754_zero s
  | B754_infinity s => B754_infinity s
  | B754_nan => B754_nan
  | B754_finite s m e _ => binary_normalize 53 1024 prec64 less64 mode_NE (cond_Zopp s (Zpos m)) e s
  end.
Definition nearest (x : binary64) : binary32 :=
  match x with
  | B754_zero s => B754_zero s
  | B754_infinity s => B754_infinity s
  | B754_nan => B754_nan
  | B754_finite s m e _ => binary_normalize 24 128 prec32 less32 mode_NE (cond_Zopp s (Zpos m)) e s
  end.
Definition below (x : binary64) : binary32 :=
  let y := nearest x in if Bltb x (promoted y) then @Bpred 24 128 prec32 less32 y else y.
Definition above (x : binary64) : binary32 := Bopp (below (Bopp x)).

Lemma of_binary32 (y : binary32) : generic_format radix2 (FLT_exp (-1074) 53) (B2R y) /\ Rabs (B2R y) < bpow radix2 1024.
Proof.
  split.
  - pose proof (generic_format_B2R 24 128 y) as H. apply FLT_format_generic in H; [| reflexivity].
    destruct H as [f E M X]. rewrite E. apply generic_format_FLT. exists f; [reflexivity | |]; cbn in *; lia.
  - apply Rlt_le_trans with (1 := abs_B2R_lt_emax 24 128 y). now apply bpow_le.
Qed.

Lemma promoted_exact y : is_finite y = true -> is_finite (promoted y) = true /\ B2R (promoted y) = B2R y.
Proof.
  destruct y as [s | s | | s m e H]; try discriminate; [now split | intros _].
  destruct (of_binary32 (B754_finite s m e H)) as [F L].
  pose proof (binary_normalize_correct 53 1024 prec64 less64 mode_NE (cond_Zopp s (Zpos m)) e s) as C.
  change (F2R (Float radix2 (cond_Zopp s (Zpos m)) e)) with (B2R (B754_finite s m e H)) in C.
  change (round_mode mode_NE) with ZnearestE in C. change (SpecFloat.emin 53 1024) with (-1074)%Z in C.
  cbv zeta in C. rewrite round_generic in C by (auto with typeclass_instances).
  rewrite Rlt_bool_true in C by exact L. cbn [promoted]. tauto.
Qed.

Lemma nearest_right x : is_finite x = true ->
  if Rlt_bool (Rabs (rnd32 (B2R x))) (bpow radix2 128) then is_finite (nearest x) = true /\ B2R (nearest x) = rnd32 (B2R x)
  else nearest x = B754_infinity (Rlt_bool (B2R x) 0).
Proof.
  destruct x as [s | s | | s m e H]; try discriminate; intros _.
  - cbn [B2R nearest]. rewrite round_0, Rabs_R0, Rlt_bool_true by (auto with typeclass_instances; apply bpow_gt_0). now split.
  - pose proof (binary_normalize_correct 24 128 prec32 less32 mode_NE (cond_Zopp s (Zpos m)) e s) as C.
    change (F2R (Float radix2 (cond_Zopp s (Zpos m)) e)) with (B2R (B754_finite s m e H)) in C.
    change (round_mode mode_NE) with ZnearestE in C. change (SpecFloat.emin 24 128) with (-149)%Z in C.
    cbv zeta in C. cbn [nearest]. destruct (Rlt_bool (Rabs _) _); [tauto |]. unfold binary_overflow in C. cbn in C.
    destruct (binary_normalize 24 128 prec32 less32 mode_NE (cond_Zopp s (Zpos m)) e s); cbn in C; try discriminate C.
    now injection C as ->.
Qed.

Notation largest := (@Bmax_float 24 128 prec32 less32).

(** What is rounded beyond the largest number is not less than it. *)
Lemma beyond_largest x : bpow radix2 128 <= Rabs (rnd32 x) -> 0 <= x -> B2R largest <= x.
Proof.
  intros Hr Hx. apply Rnot_lt_le. intros Hlt. set (b := largest) in *.
  pose proof (abs_B2R_lt_emax 24 128 b) as Hb. pose proof (Rle_abs (B2R b)).
  assert (L : rnd32 x <= B2R b).
  { replace (B2R b) with (rnd32 (B2R b)); [apply round_le; auto with typeclass_instances; lra |].
    apply round_generic; [auto with typeclass_instances | apply (generic_format_B2R 24 128)]. }
  assert (P : 0 <= rnd32 x).
  { replace 0 with (rnd32 0) by (apply round_0; auto with typeclass_instances). apply round_le; auto with typeclass_instances. }
  rewrite Rabs_pos_eq in Hr by exact P. lra.
Qed.

Theorem below_is_below x : is_finite x = true -> is_finite (below x) = true -> B2R (below x) <= B2R x.
Proof.
  intros Fx. pose proof (nearest_right x Fx) as N. unfold below. destruct (Rlt_bool_spec (Rabs (rnd32 (B2R x))) (bpow radix2 128)).
  - destruct N as [Fy Ey]. destruct (promoted_exact _ Fy) as [Fp Ep]. rewrite Bltb_correct by assumption. rewrite Ep.
    destruct (Rlt_bool_spec (B2R x) (B2R (nearest x))) as [_ | L]; [| intros _; exact L].
    pose proof (Bpred_correct 24 128 prec32 less32 (nearest x) Fy) as C. destruct (Rlt_bool _ _).
    + intros _. destruct C as [-> _]. rewrite Ey. apply pred_round_le_id; auto with typeclass_instances.
    + destruct (Bpred (nearest x)); try discriminate C; intros F; discriminate F.
  - rewrite N. destruct (Rlt_bool_spec (B2R x) 0) as [_ | P]; cbn [promoted].
    + destruct x as [| | | []]; try discriminate Fx; cbn; intros F; discriminate F.
    + intros _. replace (Bltb x (B754_infinity false)) with true by (destruct x as [[] | | | []]; easy).
      change (B2R (Bopp (Bopp largest)) <= B2R x). rewrite !B2R_Bopp, Ropp_involutive. now apply beyond_largest.
Qed.

Theorem above_is_above x : is_finite x = true -> is_finite (above x) = true -> B2R x <= B2R (above x).
Proof.
  unfold above. rewrite is_finite_Bopp, B2R_Bopp. intros Fx Fa.
  pose proof (below_is_below (Bopp x)) as L. rewrite is_finite_Bopp, B2R_Bopp in L. specialize (L Fx Fa). lra.
Qed.

(** Nothing but a finite number is rounded to one. *)
Lemma below_of_finite x : is_finite (below x) = true -> is_finite x = true.
Proof. now destruct x as [| [] | |]. Qed.

(** ** Boxes *)

Record box32 := Box32 { low32_x : binary32; high32_x : binary32; low32_y : binary32; high32_y : binary32;
  low32_z : binary32; high32_z : binary32 }.

Definition outwards (b : box64) : box32 :=
  Box32 (below (low_x b)) (above (high_x b)) (below (low_y b)) (above (high_y b)) (below (low_z b)) (above (high_z b)).
Definition in_binary64 (c : box32) : box64 :=
  Box64 (promoted (low32_x c)) (promoted (high32_x c)) (promoted (low32_y c)) (promoted (high32_y c))
    (promoted (low32_z c)) (promoted (high32_z c)).
Definition finite (c : box32) : Prop :=
  is_finite (low32_x c) = true /\ is_finite (high32_x c) = true /\ is_finite (low32_y c) = true
  /\ is_finite (high32_y c) = true /\ is_finite (low32_z c) = true /\ is_finite (high32_z c) = true.
Definition within (c d : box32) : Prop :=
  (B2R (low32_x d) <= B2R (low32_x c) /\ B2R (high32_x c) <= B2R (high32_x d))
  /\ (B2R (low32_y d) <= B2R (low32_y c) /\ B2R (high32_y c) <= B2R (high32_y d))
  /\ (B2R (low32_z d) <= B2R (low32_z c) /\ B2R (high32_z c) <= B2R (high32_z d)).

(** What a box of binary32 holds, of its planes as they are. *)
Lemma holds_planes c w : finite c -> holds (in_binary64 c) w <->
  B2R (low32_x c) <= Punto_x w <= B2R (high32_x c) /\ B2R (low32_y c) <= Punto_y w <= B2R (high32_y c)
  /\ B2R (low32_z c) <= Punto_z w <= B2R (high32_z c).
Proof.
  intros (Xl & Xh & Yl & Yh & Zl & Zh). unfold holds, in_binary64. cbn [low_x high_x low_y high_y low_z high_z].
  rewrite (proj2 (promoted_exact _ Xl)), (proj2 (promoted_exact _ Xh)), (proj2 (promoted_exact _ Yl)),
    (proj2 (promoted_exact _ Yh)), (proj2 (promoted_exact _ Zl)), (proj2 (promoted_exact _ Zh)). reflexivity.
Qed.
Theorem outwards_holds b w : finite (outwards b) -> holds b w -> holds (in_binary64 (outwards b)) w.
Proof.
  intros F (Hx & Hy & Hz). apply holds_planes; [exact F |]. destruct F as (Xl & Xh & Yl & Yh & Zl & Zh).
  assert (Low : forall x, is_finite (below x) = true -> B2R (below x) <= B2R x).
  { intros x H. apply below_is_below; [now apply below_of_finite | exact H]. }
  assert (High : forall x, is_finite (above x) = true -> B2R x <= B2R (above x)).
  { intros x H. apply above_is_above; [| exact H]. unfold above in H. rewrite is_finite_Bopp in H.
    apply below_of_finite in H. now rewrite is_finite_Bopp in H. }
  cbn in *. apply Low in Xl, Yl, Zl. apply High in Xh, Yh, Zh. lra.
Qed.
Lemma within_holds c d w : finite c -> finite d -> within c d -> holds (in_binary64 c) w -> holds (in_binary64 d) w.
Proof. intros Fc Fd (X & Y & Z). rewrite !holds_planes by assumption. lra. Qed.

(** ** The ray *)

Definition asked (r : beam) : Prop :=
  is_finite (p_x r) = true /\ is_finite (p_y r) = true /\ is_finite (p_z r) = true
  /\ is_finite (v_x r) = true /\ is_finite (v_y r) = true /\ is_finite (v_z r) = true
  /\ Formas.ray_in_range (Vectors.Vec (B2R (p_x r)) (B2R (p_y r)) (B2R (p_z r)))
       (Vectors.Vec (B2R (v_x r)) (B2R (v_y r)) (B2R (v_z r))) = true.

Lemma ordinary_slab low high (p v : binary64) : is_finite low = true -> is_finite high = true -> is_finite p = true ->
  is_finite v = true -> Flotante.ordinary (B2R p) -> Flotante.ordinary (B2R v) ->
  slab64_ok (Slab64 (promoted low) (promoted high) p v).
Proof.
  intros Fl Fh Fp Fv [_ Op] [_ Ov]. unfold slab_ok, moderate. cbn [lo hi origin dir].
  assert (Plane : forall y, is_finite y = true -> is_finite (promoted y) = true /\ Rabs (B2R (promoted y)) <= bpow radix2 (1024 - 2)).
  { intros y F. destruct (promoted_exact y F) as [Fy ->]. split; [exact Fy |].
    apply Rlt_le, Rlt_le_trans with (1 := abs_B2R_lt_emax 24 128 y). now apply bpow_le. }
  assert (Size : forall x, x = 0 \/ bpow radix2 (-100) <= Rabs x <= bpow radix2 100 -> Rabs x <= bpow radix2 (1024 - 2)).
  { intros x [-> | [_ H]]; [rewrite Rabs_R0; apply bpow_ge_0 |]. apply Rle_trans with (1 := H). now apply bpow_le. }
  pose proof (Size _ Op). pose proof (Size _ Ov). repeat split; try assumption; try (now apply Plane).
  destruct Ov as [Ov | [Ov _]]; [now left | right]. apply Rle_trans with (2 := Ov). now apply bpow_le.
Qed.
Lemma asked_slabs r c : asked r -> finite c -> Forall slab64_ok (slabs (in_binary64 c) r).
Proof.
  intros (Px & Py & Pz & Vx & Vy & Vz & Hr) (Xl & Xh & Yl & Yh & Zl & Zh).
  apply Flotante.ray_in_range_ordinary in Hr; try apply (generic_format_B2R 53 1024).
  destruct Hr as [(Ox & Oy & Oz) (Ux & Uy & Uz)]. cbn [Vectors.cx Vectors.cy Vectors.cz] in *.
  unfold slabs, in_binary64. cbn [low_x high_x low_y high_y low_z high_z].
  repeat (apply Forall_cons; [now apply ordinary_slab |]). apply Forall_nil.
Qed.

(** ** The tree *)

Section Wide.
Variables E State : Type.
Variable limit_of : State -> binary64.
Variable r : beam.
Variable bounds : E -> box64.

Inductive wide := Nothing | Element (e : E) | Node (places : list (box32 * wide)).

Inductive nested : box32 -> wide -> Prop :=
| nested_nothing c : nested c Nothing
| nested_element e : finite (outwards (bounds e)) -> nested (outwards (bounds e)) (Element e)
| nested_node c places : finite c -> (forall d a, In (d, a) places -> nested d a /\ (a <> Nothing -> within d c)) ->
    nested c (Node places).

Inductive lies_in (e : E) : wide -> Prop :=
| lies_here : lies_in e (Element e)
| lies_below c a places : In (c, a) places -> lies_in e a -> lies_in e (Node places).

Fixpoint cell_of (c : box32) (a : wide) : cell E :=
  Cell (fun t => 0 < t /\ holds (in_binary64 c) (point_at (of_beam r) t))
    match a with Element e => [e] | _ => [] end
    match a with Node places => map (fun place => cell_of (fst place) (snd place)) places | _ => [] end.
Definition cells_of (places : list (box32 * wide)) : list (cell E) := map (fun place => cell_of (fst place) (snd place)) places.

(** An empty place leads nowhere; and no test rejects a box in which the ray has a point up to the limit. *)
Definition prunable (st : State) (k : cell E) : Prop :=
  exists c a, k = cell_of c a /\ (a = Nothing \/ finite c /\ rejects (in_binary64 c) r (limit_of st)).

Theorem prunable_right st k : asked r -> prunable st k -> forall e t, leads k e t -> ~ at_least (limit_of st) t.
Proof.
  intros Hr [c [a [-> H]]] e t Hl. destruct H as [-> | [F H]].
  - exfalso. now inversion Hl.
  - assert (S : stretch E (cell_of c a) t) by now destruct Hl.
    assert (T : 0 < t /\ holds (in_binary64 c) (point_at (of_beam r) t)) by now destruct a.
    destruct T as [Ht Hb]. apply rejected_is_beyond with (in_binary64 c) r; try assumption. now apply asked_slabs.
Qed.

Lemma nested_finite c a e : nested c a -> lies_in e a -> finite c.
Proof. intros N L. destruct N; [inversion L | assumption | assumption]. Qed.
Lemma nested_holds a e w : lies_in e a -> forall c, nested c a -> holds (bounds e) w -> holds (in_binary64 c) w.
Proof.
  intros L. induction L as [| d a places Hin L IH]; intros c N Hw; inversion N as [| ? F | ? ? F Below]; subst.
  - now apply outwards_holds.
  - destruct (Below d a Hin) as [Nd Wd]. apply within_holds with d; [now apply nested_finite with a e | exact F | | now apply IH].
    apply Wd. intros ->. inversion L.
Qed.
Theorem nested_leads a e t : lies_in e a -> 0 < t -> holds (bounds e) (point_at (of_beam r) t) ->
  forall c, nested c a -> leads (cell_of c a) e t.
Proof.
  intros L Ht Hw. induction L as [| d a places Hin L IH]; intros c N.
  - apply leads_here; [split; [exact Ht | now apply nested_holds with (Element e) e; [constructor | |]] | now left].
  - pose proof (nested_holds (Node places) e _ (lies_below e d a places Hin L) c N Hw) as Hc.
    inversion N as [| | ? ? F Below]; subst. apply leads_below with (cell_of d a).
    + split; [exact Ht | exact Hc].
    + exact (in_map (fun place => cell_of (fst place) (snd place)) places (d, a) Hin).
    + apply IH. now apply Below.
Qed.
End Wide.

(** ** The search *)

Section Text.
Variable Elemento : Type.
Variables (s : Especificacion.Escena Elemento) (en : set Elemento).
Variables (elements apart : list Elemento) (State : Type) (limit_of : State -> binary64) (bounds : Elemento -> box64).

Theorem places_are_well_walked r places : asked r -> (forall e, In e elements -> en e -> In e apart) ->
  (forall e, In e elements -> ~ In e apart ->
   (forall w, puntos_de_elemento s e w -> holds (bounds e) w) /\ lies_in Elemento e (Node _ places)) ->
  (forall c a, In (c, a) places -> nested Elemento bounds c a) ->
  (forall st k, prunable Elemento State limit_of r st k -> forall e t, leads k e t -> ~ at_least (limit_of st) t)
  /\ forall e t, In e elements -> ~ In e apart -> met (of_beam r) Elemento s en e t ->
     exists k, In k (cells_of Elemento r places) /\ leads k e t.
Proof.
  intros Hr Hen Hin Hn. split; [intros st k Hp; now apply prunable_right with (1 := Hr) |]. intros e t He Ha Ht.
  apply Chain.met_of_another in Ht; [| intros N; now apply Ha, Hen]. destruct Ht as [Ht Hw].
  destruct (Hin e He Ha) as [Hb L]. inversion L as [| c a ? Hc La]; subst. exists (cell_of Elemento r c a). split.
  - exact (in_map (fun place => cell_of Elemento r (fst place) (snd place)) places (c, a) Hc).
  - apply nested_leads with bounds; auto.
Qed.
End Text.
