(** * Firsts: the first hit of Recorrido.v is that of the Z text

    first, le              == the first hit of one element: a parameter, or below all of them None, where there is no
                              minimum; the order of these
    is_first_of T x        == x is that of the set T of parameters: nothing, if T is empty *)
From Coq Require Import Reals List Lra.
From Durero Require Import Toolkit Especificacion Puntos Trazador Interseccion Recorrido.
Import ListNotations.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Definition first := option R.
Definition le (a b : first) : bool :=
  match a, b with
  | None, _ => true
  | Some _, None => false
  | Some x, Some y => if Rle_dec x y then true else false
  end.

Lemma le_some x y : le (Some x) (Some y) = true <-> x <= y.
Proof. cbn. destruct (Rle_dec x y) as [H | H]; [tauto | split; [discriminate | contradiction]]. Qed.
Lemma le_total a b : le a b = true \/ le b a = true.
Proof.
  destruct a as [x |], b as [y |]; auto. rewrite !le_some. destruct (Rle_dec x y); [now left | right; lra].
Qed.
Lemma le_trans a b c : le a b = true -> le b c = true -> le a c = true.
Proof.
  destruct a as [x |], b as [y |], c as [z |]; try discriminate; auto. rewrite !le_some. apply Rle_trans.
Qed.
Lemma le_antisym a b : le a b = true -> le b a = true -> a = b.
Proof.
  destruct a as [x |], b as [y |]; try discriminate; auto. rewrite !le_some. intros H H'.
  now rewrite (Rle_antisym x y H H').
Qed.

Definition is_first_of (T : set R) (x : option first) : Prop :=
  match x with
  | None => forall t, ~ T t
  | Some None => starts_in T
  | Some (Some t) => is_least T t
  end.

Section Firsts.
Variable Elemento : Type.
Notation Escena := (Especificacion.Escena Elemento).
Variables s s' : Escena.
Variable ray : Rayo.
Variable en : set Elemento.
Hypothesis ok : Escena_ok s.
Hypothesis ray_ok : Rayo_ok ray.
Hypothesis same : Xi_Escena s s'.
Hypothesis known : en ⊆ elementos s.
Variable elements : list Elemento.
Hypothesis all : forall e, In e elements <-> e ∈ elementos s.
Notation met := (met ray Elemento s en).
Variable hit_of : Elemento -> option first.
Hypothesis firsts : forall e, In e elements -> is_first_of (met e) (hit_of e).

Lemma first_of_least e t : In e elements -> (hit_of e = Some (Some t) <-> is_least (met e) t).
Proof.
  intros He. pose proof (firsts e He) as H. destruct (hit_of e) as [[u |] |]; cbn in H.
  - split; [intros [= <-]; exact H | intros Ht; now rewrite (least_unique _ _ _ H Ht)].
  - split; [discriminate |]. intros Ht. exfalso. apply (starts_in_no_least _ H); [now intros x [Hx _] | now exists t].
  - split; [discriminate |]. intros [Ht _]. now destruct (H t).
Qed.
Lemma first_of_start e : In e elements -> (hit_of e = Some None <-> starts_in (met e)).
Proof.
  intros He. pose proof (firsts e He) as H. destruct (hit_of e) as [[u |] |]; cbn in H.
  - split; [discriminate |]. intros S. exfalso. apply (starts_in_no_least _ S); [now intros x [Hx _] | now exists u].
  - now split.
  - split; [discriminate |]. intros [eps [Hpos S]]. destruct (H (eps / 2)). apply S. lra.
Qed.

(** The least first hit and those that attain it are the answer of the text. *)
Theorem first_hit_says best : first_hit first le Elemento hit_of elements best ->
  match best with
  | None => No_Hay_Interseccion s s' ray en miss ∅
  | Some (None, l) => No_Hay_Minimo s s' ray en no_minimum (fun e => In e l)
  | Some (Some t, l) => Hay_Interseccion s s' ray en hit (fun e => In e l) t (point_at ray t)
  end.
Proof.
  destruct best as [[[t |] l] |]; cbn [first_hit].
  - intros [Hne [Hin Hle]]. apply hit_computed; auto.
    assert (Least : forall e, In e l <-> e ∈ elementos s /\ is_least (met e) t).
    { intros e. rewrite (Hin e), (all e). split; intros [He H]; (split; [exact He |]); apply all in He;
        now apply (first_of_least e t He). }
    split; [| split; [reflexivity | split; [exact Least | reflexivity]]].
    apply first_hit_is_least_of_first_hits; [exact ok |]. split; [| split].
    + intros e He S. apply all in He. pose proof (Hle e None He (proj2 (first_of_start e He) S)). discriminate.
    + destruct l as [| e l]; [contradiction |]. exists e. apply Least. now left.
    + intros e u He Hu. apply all in He. apply le_some, (Hle e); [exact He | now apply first_of_least].
  - intros [Hne [Hin _]]. apply no_minimum_computed; auto.
    assert (Starts : (fun e => In e l) ≡ (fun e => e ∈ elementos s /\ starts_in (met e))).
    { intros e. rewrite (Hin e), (all e). split; intros [He H]; (split; [exact He |]); apply all in He;
        now apply (first_of_start e He). }
    split; [| split; [exact Starts | reflexivity]].
    destruct l as [| e l]; [contradiction |]. exists e. apply (Starts e). now left.
  - intros Hno. apply miss_computed; auto. split; [| now split]. intros t Ht.
    apply met_scene_is_union in Ht as [e [He Ht]]. apply all in He. pose proof (firsts e He) as H.
    rewrite (Hno e He) in H. now apply (H t).
Qed.
End Firsts.
