(** spec/auditoria.tex, by hand: the edges of faces and the determinant of three points, with the rules at the head of
    Malla.v. *)
From Coq Require Import Reals Lra.
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
