(** spec/auditoria.tex, by hand: the edges of faces, the determinant of three points and what faces have in common, with the
    rules at the head of Malla.v. *)
From Coq Require Import Reals Lra Classical_Prop.
From Durero Require Import Toolkit Especificacion Malla.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Definition aristas (c : Cara) : set (nat * nat) :=
  fun a => a = (Cara_i c, Cara_j c) \/ a = (Cara_j c, Cara_k c) \/ a = (Cara_k c, Cara_i c).

Definition turned_over (c : Cara) : Cara := mk_Cara (Cara_j c) (Cara_i c) (Cara_k c).

(** A face that is turned over walks each of its edges the other way. So two faces that agree at an edge walk it in
    opposite ways. Discharges aristas.def.1. *)
Theorem turned_over_walks_back c i j : (i, j) ∈ aristas (turned_over c) <-> (j, i) ∈ aristas c.
Proof.
  unfold aristas, turned_over. destruct c as [a b d]. cbn. split; intros [H | [H | H]]; inversion H; subst; auto.
Qed.

Definition determinante (v : Terna) : R :=
  Punto_x (Terna_a v) * (Punto_y (Terna_b v) * Punto_z (Terna_c v) - Punto_z (Terna_b v) * Punto_y (Terna_c v)) +
  Punto_y (Terna_a v) * (Punto_z (Terna_b v) * Punto_x (Terna_c v) - Punto_x (Terna_b v) * Punto_z (Terna_c v)) +
  Punto_z (Terna_a v) * (Punto_x (Terna_b v) * Punto_y (Terna_c v) - Punto_y (Terna_b v) * Punto_x (Terna_c v)).

(** The determinant of a face is the same from whichever corner it is walked, and changes its sign where the face is
    turned over. Discharges determinante.def.1. *)
Theorem determinant_alternates a b c :
  determinante (mk_Terna b c a) = determinante (mk_Terna a b c) /\
  determinante (mk_Terna b a c) = - determinante (mk_Terna a b c).
Proof. unfold determinante. cbn. split; ring. Qed.

(** ** Faces that cross *)

Definition esquinas (c : Cara) : set nat := corners_of c.

(** The point w is the mean of three by weights. *)
Record is_mean (w p q t : Punto) (f g h : R) : Prop := {
  mean_weights : 0 <= f /\ 0 <= g /\ 0 <= h /\ f + g + h = 1;
  mean_x : Punto_x w = f * Punto_x p + g * Punto_x q + h * Punto_x t;
  mean_y : Punto_y w = f * Punto_y p + g * Punto_y q + h * Punto_y t;
  mean_z : Punto_z w = f * Punto_z p + g * Punto_z q + h * Punto_z t }.

Definition envolvente (r : Red) (s : set nat) : set Punto := fun w =>
  exists i j k p q t f g h, (i ∈ s /\ (i, p) ∈ numbered (puntos r)) /\ (j ∈ s /\ (j, q) ∈ numbered (puntos r)) /\
  (k ∈ s /\ (k, t) ∈ numbered (puntos r)) /\ is_mean w p q t f g h.

Definition cruzadas (r : Red) : set (nat * nat) := fun mn =>
  (fst mn < snd mn)%nat /\ exists a b, (fst mn, a) ∈ numbered (caras r) /\ (snd mn, b) ∈ numbered (caras r) /\
  ~ envolvente r (esquinas a) ∩ envolvente r (esquinas b) ⊆ envolvente r (esquinas a ∩ esquinas b).

(** How far a point has advanced along a direction, from the origin. *)
Definition along (d p : Punto) : R := Punto_x d * Punto_x p + Punto_y d * Punto_y p + Punto_z d * Punto_z p.

Lemma along_mean d w p q t f g h : is_mean w p q t f g h -> along d w = f * along d p + g * along d q + h * along d t.
Proof. intros [_ X Y Z]. unfold along. rewrite X, Y, Z. ring. Qed.

(** A mean is one of those corners alone that have weight, of which there is one. *)
Lemma mean_of_weighty r (s : set nat) (w : Punto) i j k p q t f g h :
  is_mean w p q t f g h -> (i, p) ∈ numbered (puntos r) -> (j, q) ∈ numbered (puntos r) -> (k, t) ∈ numbered (puntos r) ->
  (0 < f -> i ∈ s) -> (0 < g -> j ∈ s) -> (0 < h -> k ∈ s) -> w ∈ envolvente r s.
Proof.
  intros M Ip Jq Kt Fi Gj Hk. destruct M as [[F [G [H E]]] X Y Z].
  assert (B : exists n b, n ∈ s /\ (n, b) ∈ numbered (puntos r)).
  { destruct (Rle_lt_or_eq_dec _ _ F) as [P | P]; [now exists i, p; auto |].
    destruct (Rle_lt_or_eq_dec _ _ G) as [Q | Q]; [now exists j, q; auto |].
    exists k, t. split; [apply Hk; lra | exact Kt]. }
  destruct B as [n [b [Ns Nb]]].
  assert (C : forall u v c, 0 <= u -> (v, c) ∈ numbered (puntos r) -> (0 < u -> v ∈ s) ->
    exists v' c', v' ∈ s /\ (v', c') ∈ numbered (puntos r) /\ u * Punto_x c' = u * Punto_x c /\
    u * Punto_y c' = u * Punto_y c /\ u * Punto_z c' = u * Punto_z c).
  { intros u v c U Vc Us. destruct (Rle_lt_or_eq_dec _ _ U) as [P | <-]; [now exists v, c; auto |].
    exists n, b. split; [exact Ns | split; [exact Nb | split; [ring | split; ring]]]. }
  destruct (C f i p F Ip Fi) as [i' [p' [Is [Ip' [Xp [Yp Zp]]]]]].
  destruct (C g j q G Jq Gj) as [j' [q' [Js [Jq' [Xq [Yq Zq]]]]]].
  destruct (C h k t H Kt Hk) as [k' [t' [Ks [Kt' [Xt [Yt Zt]]]]]].
  exists i', j', k', p', q', t', f, g, h. repeat split; auto; lra.
Qed.

(** A plane parts two faces where it has one of them on the one side, and the other on the other, and no corner of the first
    lies on it but those that both have: the faces do not cross. This is what are_surely_apart() looks for. Discharges
    esquinas.def.1, envolvente.def.1, cruzadas.def.1. *)
Theorem faces_that_a_plane_parts_do_not_cross r m n a b d level :
  (m, a) ∈ numbered (caras r) -> (n, b) ∈ numbered (caras r) ->
  (forall i p, i ∈ esquinas a -> (i, p) ∈ numbered (puntos r) ->
    along d p <= level /\ (i ∉ esquinas b -> along d p < level)) ->
  (forall i p, i ∈ esquinas b -> (i, p) ∈ numbered (puntos r) -> level <= along d p) ->
  (m, n) ∉ cruzadas r.
Proof.
  intros Ma Nb A B [_ [a' [b' [Ma' [Nb' C]]]]]. cbn in Ma', Nb'.
  rewrite (numbered_functional (caras r) _ _ _ Ma' Ma), (numbered_functional (caras r) _ _ _ Nb' Nb) in C.
  apply C. clear C Ma' Nb'. intros w [[i [j [k [p [q [t [f [g [h [[Ia Ip] [[Ja Jq] [[Ka Kt] M]]]]]]]]]]]] Wb].
  assert (L : level <= along d w).
  { destruct Wb as [i' [j' [k' [p' [q' [t' [f' [g' [h' [[Ia' Ip'] [[Ja' Jq'] [[Ka' Kt'] M']]]]]]]]]]]].
    rewrite (along_mean d _ _ _ _ _ _ _ M'). destruct M' as [[F [G [H E]]] _ _ _].
    pose proof (B _ _ Ia' Ip'). pose proof (B _ _ Ja' Jq'). pose proof (B _ _ Ka' Kt').
    replace level with (f' * level + g' * level + h' * level) by (rewrite <- !Rmult_plus_distr_r, E; ring).
    repeat apply Rplus_le_compat; now apply Rmult_le_compat_l. }
  rewrite (along_mean d _ _ _ _ _ _ _ M) in L. pose proof M as [[F [G [H E]]] _ _ _].
  destruct (A _ _ Ia Ip) as [Pi Qi], (A _ _ Ja Jq) as [Pj Qj], (A _ _ Ka Kt) as [Pk Qk].
  assert (S : f * (level - along d p) + g * (level - along d q) + h * (level - along d t) <= 0).
  { replace (f * (level - along d p) + g * (level - along d q) + h * (level - along d t)) with
      ((f + g + h) * level - (f * along d p + g * along d q + h * along d t)) by ring. rewrite E. lra. }
  assert (Nf : 0 <= f * (level - along d p)) by (apply Rmult_le_pos; lra).
  assert (Ng : 0 <= g * (level - along d q)) by (apply Rmult_le_pos; lra).
  assert (Nh : 0 <= h * (level - along d t)) by (apply Rmult_le_pos; lra).
  assert (W : forall u v x, v ∈ esquinas a -> u * (level - x) <= 0 -> (v ∉ esquinas b -> x < level) -> 0 < u ->
    v ∈ esquinas a ∩ esquinas b).
  { intros u v x Va U Q P. split; [exact Va |]. destruct (classic (v ∈ esquinas b)) as [Y | N]; [exact Y |].
    specialize (Q N). pose proof (Rmult_lt_0_compat u (level - x) P ltac:(lra)). lra. }
  apply (mean_of_weighty r _ w i j k p q t f g h M Ip Jq Kt); intros P.
  - apply (W f i (along d p)); auto; lra.
  - apply (W g j (along d q)); auto; lra.
  - apply (W h k (along d t)); auto; lra.
Qed.
