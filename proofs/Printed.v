(** spec/interseccion.tex: the way of the printed text is ours, for a ray that starts on no element. *)
From Coq Require Import Reals List.
From Durero Require Import Toolkit Especificacion Escena Puntos Interseccion.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Section Printed.
Variable Elemento : Type.

Lemma alcance_from_nowhere (s : Escena Elemento) ray e w :
  w ∈ alcance s ray ∅ e <-> e ∈ elementos s /\ w ∈ puntos_de_rayo ray /\ w ∈ puntos_de_elemento s e.
Proof.
  split; [intros [He [Hr [[[] _] | [_ H]]]]; now split |].
  intros [He [Hr H]]. split; [exact He | split; [exact Hr | right; split; [intros [] | exact H]]].
Qed.

(** What the print intersects is what ours meets. Discharges alcances.conj.1. *)
Theorem printed_intersection_is_alcances : alcances_conj_1 Elemento.
Proof.
  intros s ray w _ _. split.
  - intros [[e [He H]] Hr]. exists e. split; [exact He | now apply alcance_from_nowhere].
  - intros [e [He H]]. apply alcance_from_nowhere in H as [_ [Hr H]]. split; [now exists e | exact Hr].
Qed.

(** Of a point of the ray, the elements that it is of are those that the ray meets there. Discharges
    de_que_elemento.conj.1. *)
Theorem printed_elements_are_those_met : de_que_elemento_conj_1 Elemento.
Proof.
  intros s ray w _ _ Hr e. split.
  - intros [He H]. apply alcance_from_nowhere in H as [_ [_ H]]. now split.
  - intros [He H]. split; [exact He | now apply alcance_from_nowhere].
Qed.

(** So the answer to a hit is the element of the print. Discharges Hay_Interseccion.conj.1. *)
Theorem printed_elements_are_the_answer : Hay_Interseccion_conj_1 Elemento.
Proof.
  intros s s' ray en resultado els t w H none. pose proof H as [[_ _ _ _ _] _ _ [v [Hv ->]] _ Hels _].
  destruct Hv as [_ [[[u [_ [_ [Hr _]]]] _] _]]. intros e. rewrite (Hels e).
  assert (A : v ∈ alcance s ray en e <-> v ∈ alcance s ray ∅ e).
  { split; intros [He [Hv [[Hn _] | [_ Hp]]]].
    - now apply none in Hn.
    - split; [exact He | split; [exact Hv | right; split; [intros [] | exact Hp]]].
    - destruct Hn.
    - split; [exact He | split; [exact Hv | right; split; [| exact Hp]]]. intros Hn. now apply none in Hn. }
  split.
  - intros [He Ha]. apply A, alcance_from_nowhere in Ha as [_ [_ Hp]]. now split.
  - intros [He Hp]. split; [exact He | apply A, alcance_from_nowhere]. now split.
Qed.

(** The precondition, calculated. Discharges Primera_Interseccion.conj.1. *)
Theorem precondition_of_Primera_Interseccion : Primera_Interseccion_conj_1 Elemento.
Proof.
  intros s ray en ok ray_ok. split.
  - intros [s' [resultado [els [t [w H]]]]]. destruct H as [[P _ _ _ _ _ _] | [[P _ _ _] | [P _ _ _ _]]]; apply P.
  - intros known. exists s.
    assert (same : Xi_Escena s s) by (split; [now split | apply Escena_eq_refl]).
    exact (Primera_Interseccion_is_total ray ray_ok Elemento s ok en s same known).
Qed.
End Printed.
