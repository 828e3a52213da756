(** * ExactoEscena: the executable procedure answers as the Z text's Primera_Interseccion does

    has_shape S s e sh    == the element e of the scene s has the attributes of sh, over the denominator S
    describes S s en es   == the list es is the scene s, each element marked that the ray is said to start on (en)
    the_ray S p v         == the Rayo of p and v *)
From Coq Require Import ZArith Reals List Lra.
From Durero Require Import Toolkit Especificacion Escena Puntos Trazador Interseccion Surd Quadratic Exacto.
Import ListNotations.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Section ExactoEscena.

Variable Elemento : Type.
Notation Escena := (Especificacion.Escena Elemento).
Variable S : Z.
Hypothesis S_positive : (0 < S)%Z.
Variable s : Escena.
Hypothesis ok : Escena_ok s.
Variable en : set Elemento.
Variables p v : vec3.
Variable es : list (Elemento * shape * bool).

Definition the_ray : Rayo := mk_Rayo (point S p) (direction S v).
Hypothesis ray_ok : Rayo_ok the_ray.

Definition has_shape (e : Elemento) (sh : shape) : Prop :=
  match sh with
  | Sphere c r => is_esfera _ s e (point S c) (over S r)
  | Cylinder c r d h => is_cilindro _ s e (point S c) (over S r) (direction S d) (over S h)
  | Cone c k d h => is_cono _ s e (point S c) (over S k) (direction S d) (over S h)
  | TruncatedCone c r k d h => is_tronco _ s e (point S c) (over S r) (over S k) (direction S d) (over S h)
  | Plane c d => is_plano _ s e (point S c) (direction S d)
  | Disc c r d => is_disco _ s e (point S c) (over S r) (direction S d)
  | Triangle a b c => is_triangulo _ s e (vertices S a b c)
  end.

Definition describes : Prop :=
  (forall e, elementos s e <-> exists sh on, In (e, sh, on) es) /\
  forall e sh on, In (e, sh, on) es -> has_shape e sh /\ (on = true <-> en e).

Hypothesis described : describes.

(** The points, the power and the stretch of an element are those of its shape. *)
Lemma shape_of_scene e sh : has_shape e sh ->
  (forall w, puntos_de_elemento s e w <-> power S sh w = 0 /\ clip S sh w) /\
  (forall w y, potencia s e w y <-> y = power S sh w) /\ (forall w, tramo s e w <-> clip S sh w).
Proof.
  destruct sh as [c r|c r d h|c k d h|c r k d h|c d|c r d|a b c]; intros H.
  - destruct (esfera_of_scene _ s ok e _ _ H) as (Q & P & T); split; [|split; [exact P|]]; intros w.
    + rewrite Q; unfold puntos_esfera; simpl; tauto.
    + simpl; split; auto.
  - destruct (cilindro_of_scene _ s ok e _ _ _ _ H) as (Q & P & T); split; [|split; [exact P | exact T]]; intros w.
    rewrite Q; reflexivity.
  - destruct (cono_of_scene _ s ok e _ _ _ _ H) as (Q & P & T); split; [|split; [exact P | exact T]]; intros w.
    rewrite Q; reflexivity.
  - destruct (tronco_of_scene _ s ok e _ _ _ _ _ H) as (Q & P & T); split; [|split; [exact P | exact T]]; intros w.
    rewrite Q; reflexivity.
  - destruct (plano_of_scene _ s ok e _ _ H) as (Q & P & T); split; [|split; [exact P|]]; intros w.
    + rewrite Q; unfold puntos_plano; simpl; tauto.
    + simpl; split; auto.
  - destruct (disco_of_scene _ s ok e _ _ _ H) as (Q & P & T); split; [|split; [exact P | exact T]]; intros w.
    rewrite Q; reflexivity.
  - destruct (triangulo_of_scene _ s ok e _ H) as (Q & P & T); split; [|split; [exact P | exact T]]; intros w.
    rewrite Q; unfold puntos_triangulo; simpl; tauto.
Qed.

Lemma at_point t : ray_at S p v t = point_at the_ray t.
Proof. reflexivity. Qed.

(** What the procedure takes the ray to meet of an element is its alcance. *)
Lemma meets_met e sh on t : In (e, sh, on) es -> (meets S sh on p v t <-> met the_ray _ s en e t).
Proof.
  intros Hin; destruct described as [Hall Hes]; destruct (Hes e sh on Hin) as [Hsh Hon].
  assert (He : elementos s e) by (apply Hall; now exists sh, on).
  destruct (shape_of_scene e sh Hsh) as (Q & P & T); unfold meets, met, parameters, points; rewrite at_point.
  split; intros [Ht H]; (split; [exact Ht|]); set (w := point_at the_ray t) in *.
  - split; [exact He | split; [now apply puntos_de_rayo_parameter; exists t |]].
    destruct on; [left | right]; (split; [first [now apply Hon | intros Hen; now apply Hon in Hen]|]).
    + destruct H as [Hp Hc]; split; [exact He | split; [now apply T|]].
      exists (power S sh w), (power S sh (point S p)); split; [now apply P | split; [now apply P | exact Hp]].
    + now apply Q.
  - destruct H as [_ [_ [[Hen [_ [Htr (y & y' & Hy & Hy' & E)]]]|[Hen H]]]]; destruct on.
    + apply P in Hy, Hy'; subst y y'; split; [exact E | now apply T].
    + apply Hon in Hen; discriminate.
    + exfalso; apply Hen, Hon; reflexivity.
    + now apply Q.
Qed.

Lemma met_somewhere t : met_scene the_ray _ s en t <-> exists e sh on, In (e, sh, on) es /\ meets S sh on p v t.
Proof.
  rewrite met_scene_is_union; destruct described as [Hall _]; split.
  - intros (e & He & H); apply Hall in He as (sh & on & Hin); exists e, sh, on; split;
    [exact Hin | now apply (meets_met e)].
  - intros (e & sh & on & Hin & H); exists e; split; [apply Hall; now exists sh, on | now apply (meets_met e sh on)].
Qed.

(** Names of elements with a property of their shape, and elements of the scene with that property. *)
Lemma lists_elements (P : shape -> bool -> Prop) (Q : Elemento -> Prop) l : lists P l es ->
  (forall e sh on, In (e, sh, on) es -> (P sh on <-> Q e)) -> (fun e => In e l) ≡ (fun e => e ∈ elementos s /\ Q e).
Proof.
  intros Hl HPQ e; destruct described as [Hall _]; rewrite (Hl e); split.
  - intros (sh & on & Hin & HP); split; [apply Hall; now exists sh, on | now apply (HPQ e sh on)].
  - intros [He HQ]; apply Hall in He as (sh & on & Hin); exists sh, on; split; [exact Hin | now apply (HPQ e)].
Qed.

Lemma starts_from_origin (P Q : set R) : (forall t, P t <-> Q t) -> (from_origin P <-> starts_in Q).
Proof.
  intros HPQ; split; intros (e & He & H).
  - exists e; split; [exact He | intros t Ht; apply HPQ, H; lra].
  - exists (e / 2); split; [lra | intros t Ht; apply HPQ, H; lra].
Qed.

Variable s' : Escena.
Hypothesis same : Xi_Escena s s'.
Hypothesis known : en ⊆ elementos s.

(** The procedure's answer is the Z text's: outcome, set of elements, parameter and point. *)
Theorem first_hit_is_Primera_Interseccion :
  match first_hit S p v es with
  | Hit x l => Hay_Interseccion s s' the_ray en hit (fun e => In e l) (val x) (point_at the_ray (val x))
  | Miss => No_Hay_Interseccion s s' the_ray en miss ∅
  | NoMin l => No_Hay_Minimo s s' the_ray en no_minimum (fun e => In e l)
  end.
Proof.
  pose proof (first_hit_correct S p v es S_positive) as H; destruct (first_hit S p v es) as [|x l|l]; simpl in H.
  - apply miss_computed; auto; split; [|split; reflexivity].
    intros t Ht; apply met_somewhere in Ht as (e & sh & on & Hin & Hm); exact (H e sh on t Hin Hm).
  - destruct H as (_ & Hl & Hmin & Hlist); apply hit_computed; auto.
    assert (Hleast : is_least (met_scene the_ray _ s en) (val x)).
    { split.
      - destruct l as [|e l]; [contradiction|]; destruct (proj1 (Hlist e) (or_introl eq_refl)) as (sh & on & Hin & Hm).
        apply met_somewhere; now exists e, sh, on.
      - intros t Ht; apply met_somewhere in Ht as (e & sh & on & Hin & Hm); exact (Hmin e sh on t Hin Hm). }
    split; [exact Hleast | split; [reflexivity | split; [|reflexivity]]].
    apply (lists_elements _ _ _ Hlist); intros e sh on Hin; rewrite (meets_met e sh on _ Hin); split;
      [|now intros [Hm _]].
    intros Hm; split; [exact Hm | intros t Ht; apply Hleast, met_somewhere; exists e, sh, on].
    split; [exact Hin | now apply (meets_met e)].
  - destruct H as (Hl & Hlist); apply no_minimum_computed; auto.
    assert (E : (fun e => In e l) ≡ (fun e => e ∈ elementos s /\ starts_in (met the_ray _ s en e))).
    { apply (lists_elements _ _ _ Hlist); intros e sh on Hin; apply starts_from_origin; intros t; now apply meets_met. }
    split; [|split; [exact E | reflexivity]].
    destruct l as [|e l]; [contradiction|]; exists e; apply (E e); now left.
Qed.

End ExactoEscena.
