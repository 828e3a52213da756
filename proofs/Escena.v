(** spec/escena.tex: the first scene exists, and what the invariant says of one element.

    empty_scene          == the scene without elements
    is_esfera s e c r    == e is a sphere of s with centre c and radius r; is_cilindro, is_cono, is_tronco, is_plano,
                            is_disco, is_triangulo likewise; abc are the vertices of a triangle
    radio_types          == the types that have a radius; centro_types, vector_types, altura_types, proporcion_types,
                            vertices_types likewise
    Escena_eq            == equality of scenes, component by component: an equivalence that keeps the invariant *)
From Coq Require Import Reals List Lra.
From Durero Require Import Toolkit Especificacion.
Local Open Scope zed_scope.

Section Escena.
Variable Elemento : Type.
Notation Escena := (Especificacion.Escena Elemento).

Definition empty_scene : Escena := mk_Escena ∅ ∅ ∅ ∅ ∅ ∅ ∅ ∅ ∅.

Lemma empty_of_seteq {X} (A B : set X) : A ≡ B -> B ≡ ∅ -> A ≡ ∅.
Proof. intros H H'. now apply seteq_trans with B. Qed.
Lemma dom_empty {X Y} (f : rel X Y) : dom f ≡ ∅ <-> f ≡ ∅.
Proof.
  split; intros H.
  - intros [x y]. split; [intros Hf; apply (H x); now exists y | intros []].
  - intros x. split; [intros [y Hy]; apply (H (x, y)), Hy | intros []].
Qed.
Lemma ran_empty {X Y} (f : rel X Y) : f ≡ ∅ -> ran f ≡ ∅.
Proof. intros H y. split; [intros [x Hx]; apply (H (x, y)), Hx | intros []]. Qed.
Lemma image_inverse_empty {X Y} (f : rel X Y) T : f ≡ ∅ -> image (inverse f) T ≡ ∅.
Proof. intros H x. split; [intros [y [_ Hy]]; apply (H (x, y)), Hy | intros []]. Qed.

Lemma empty_scene_Init : Init empty_scene.
Proof.
  assert (P : forall X Y (B : set Y), (∅ : rel X Y) ∈ (univ ⇸ B)).
  { intros X Y B. repeat split; [now intros x y y' [] | now intros y [x []]]. }
  assert (E : forall X Y Z (T : set Z), dom (∅ : rel X Y) ≡ image (inverse (∅ : rel X Z)) T).
  { intros X Y Z T x. split; [now intros [y []] | now intros [y [_ []]]]. }
  split; [split; cbn; try apply P; try apply E | apply seteq_refl].
  - split; [easy |]. exists nil. intros x. split; intros [].
  - easy.
  - intros x. split; [intros [] | now intros [y []]].
  - intros x. split; [intros [] | now intros [y []]].
Qed.

(** The scene without elements satisfies the invariant, so that a first scene exists. Discharges Init.post.1, Init.conj.1. *)
Theorem Init_exists : Init_conj_1 Elemento.
Proof. exists empty_scene. split; [apply empty_scene_Init | exact empty_scene_Init]. Qed.

(** There is only one first scene: the invariant empties every component. *)
Theorem Init_unique (s s' : Escena) : Init s -> Init s' -> Escena_eq s s'.
Proof.
  assert (E : forall s : Escena, Init s -> elementos s ≡ ∅ /\ tipos s ≡ ∅ /\ de_que_tipo s ≡ ∅ /\ mi_centro s ≡ ∅
    /\ mi_radio s ≡ ∅ /\ mi_vector s ≡ ∅ /\ mi_altura s ≡ ∅ /\ mi_proporcion s ≡ ∅ /\ mi_vertices s ≡ ∅).
  { clear. intros s [H He]. destruct H.
    assert (T : de_que_tipo s ≡ ∅) by (apply dom_empty; eauto using seteq_sym, seteq_trans).
    assert (I : forall T, image (inverse (de_que_tipo s)) T ≡ ∅) by (intros; now apply image_inverse_empty).
    split; [exact He |]. split; [eapply empty_of_seteq; [eassumption | now apply ran_empty] |]. split; [exact T |].
    repeat split; apply dom_empty; eauto using empty_of_seteq, seteq_sym, seteq_trans. }
  intros H H'. apply E in H, H'. decompose [and] H. decompose [and] H'.
  split; eapply seteq_trans; try eassumption; now apply seteq_sym.
Qed.

Definition is_esfera (s : Escena) e c r : Prop :=
  (e, soy_esfera) ∈ de_que_tipo s /\ (e, c) ∈ mi_centro s /\ (e, r) ∈ mi_radio s.
Definition is_cilindro (s : Escena) e c r d h : Prop :=
  (e, soy_cilindro) ∈ de_que_tipo s /\ (e, c) ∈ mi_centro s /\ (e, r) ∈ mi_radio s
  /\ (e, d) ∈ mi_vector s /\ (e, h) ∈ mi_altura s.
Definition is_cono (s : Escena) e c k d h : Prop :=
  (e, soy_cono) ∈ de_que_tipo s /\ (e, c) ∈ mi_centro s /\ (e, k) ∈ mi_proporcion s
  /\ (e, d) ∈ mi_vector s /\ (e, h) ∈ mi_altura s.
Definition is_tronco (s : Escena) e c r k d h : Prop :=
  (e, soy_tronco) ∈ de_que_tipo s /\ (e, c) ∈ mi_centro s /\ (e, r) ∈ mi_radio s /\ (e, k) ∈ mi_proporcion s
  /\ (e, d) ∈ mi_vector s /\ (e, h) ∈ mi_altura s.
Definition is_plano (s : Escena) e c d : Prop :=
  (e, soy_plano) ∈ de_que_tipo s /\ (e, c) ∈ mi_centro s /\ (e, d) ∈ mi_vector s.

Definition is_disco (s : Escena) e c r d : Prop :=
  (e, soy_disco) ∈ de_que_tipo s /\ (e, c) ∈ mi_centro s /\ (e, r) ∈ mi_radio s /\ (e, d) ∈ mi_vector s.
Definition is_triangulo (s : Escena) e abc : Prop :=
  (e, soy_triangulo) ∈ de_que_tipo s /\ (e, abc) ∈ mi_vertices s.

Definition centro_types : set Tipo :=
  ⦃soy_esfera⦄ ∪ ⦃soy_cilindro⦄ ∪ ⦃soy_cono⦄ ∪ ⦃soy_tronco⦄ ∪ ⦃soy_plano⦄ ∪ ⦃soy_disco⦄.
Definition radio_types : set Tipo := ⦃soy_esfera⦄ ∪ ⦃soy_cilindro⦄ ∪ ⦃soy_tronco⦄ ∪ ⦃soy_disco⦄.
Definition vector_types : set Tipo := ⦃soy_cilindro⦄ ∪ ⦃soy_cono⦄ ∪ ⦃soy_tronco⦄ ∪ ⦃soy_plano⦄ ∪ ⦃soy_disco⦄.
Definition altura_types : set Tipo := ⦃soy_cilindro⦄ ∪ ⦃soy_cono⦄ ∪ ⦃soy_tronco⦄.
Definition proporcion_types : set Tipo := ⦃soy_cono⦄ ∪ ⦃soy_tronco⦄.
Definition vertices_types : set Tipo := ⦃soy_triangulo⦄.

Lemma Escena_eq_refl (s : Escena) : Escena_eq s s.
Proof. split; reflexivity. Qed.
Lemma Escena_eq_sym (s s' : Escena) : Escena_eq s s' -> Escena_eq s' s.
Proof. intros []. split; now symmetry. Qed.
Lemma Escena_eq_trans (s s' s'' : Escena) : Escena_eq s s' -> Escena_eq s' s'' -> Escena_eq s s''.
Proof. intros [] []. split; etransitivity; eassumption. Qed.

(** Equal scenes satisfy the invariant together. *)
Lemma Escena_ok_eq (s s' : Escena) : Escena_eq s s' -> Escena_ok s -> Escena_ok s'.
Proof.
  intros [H1 H2 H3 H4 H5 H6 H7 H8 H9] []. split; rewrite ?H1, ?H2, ?H3, ?H4, ?H5, ?H6, ?H7, ?H8, ?H9; assumption.
Qed.

(** The set of types follows from the types of the elements, which is why no operation states it.
    Discharges Escena.inv.7. *)
Theorem tipos_follow (s s' : Escena) : Escena_ok s -> Escena_ok s' -> de_que_tipo s' ≡ de_que_tipo s ->
  tipos s' ≡ tipos s.
Proof. intros ok ok' H. now rewrite (Escena_inv_7 ok), (Escena_inv_7 ok'), H. Qed.

(** ** What the invariant says of one element *)
Section Invariant.
Variable s : Escena.
Hypothesis ok : Escena_ok s.

Lemma type_of_element e : e ∈ elementos s -> exists t, (e, t) ∈ de_que_tipo s.
Proof. apply (Escena_inv_1 ok). Qed.
Lemma type_unique e t t' : (e, t) ∈ de_que_tipo s -> (e, t') ∈ de_que_tipo s -> t = t'.
Proof. apply (Escena_decl_de_que_tipo ok). Qed.
Lemma centro_unique e c c' : (e, c) ∈ mi_centro s -> (e, c') ∈ mi_centro s -> c = c'.
Proof. apply (Escena_decl_mi_centro ok). Qed.
Lemma radio_unique e r r' : (e, r) ∈ mi_radio s -> (e, r') ∈ mi_radio s -> r = r'.
Proof. apply (Escena_decl_mi_radio ok). Qed.
Lemma vector_unique e d d' : (e, d) ∈ mi_vector s -> (e, d') ∈ mi_vector s -> d = d'.
Proof. apply (Escena_decl_mi_vector ok). Qed.
Lemma altura_unique e h h' : (e, h) ∈ mi_altura s -> (e, h') ∈ mi_altura s -> h = h'.
Proof. apply (Escena_decl_mi_altura ok). Qed.
Lemma proporcion_unique e k k' : (e, k) ∈ mi_proporcion s -> (e, k') ∈ mi_proporcion s -> k = k'.
Proof. apply (Escena_decl_mi_proporcion ok). Qed.
Lemma vertices_unique e abc abc' : (e, abc) ∈ mi_vertices s -> (e, abc') ∈ mi_vertices s -> abc = abc'.
Proof. apply (Escena_decl_mi_vertices ok). Qed.

Lemma element_of_type e t : (e, t) ∈ de_que_tipo s -> e ∈ elementos s.
Proof. intros H. apply (Escena_inv_1 ok). now exists t. Qed.
Lemma element_of_image e T : e ∈ image (inverse (de_que_tipo s)) T -> e ∈ elementos s.
Proof. intros [t [_ H]]. now apply element_of_type with t. Qed.
Lemma element_of_centro e : e ∈ dom (mi_centro s) -> e ∈ elementos s.
Proof. intros H. now apply (Escena_inv_2 ok), element_of_image in H. Qed.
Lemma element_of_radio e : e ∈ dom (mi_radio s) -> e ∈ elementos s.
Proof. intros H. now apply (Escena_inv_3 ok), element_of_image in H. Qed.
Lemma element_of_vector e : e ∈ dom (mi_vector s) -> e ∈ elementos s.
Proof. intros H. now apply (Escena_inv_4 ok), element_of_image in H. Qed.
Lemma element_of_altura e : e ∈ dom (mi_altura s) -> e ∈ elementos s.
Proof. intros H. now apply (Escena_inv_5 ok), element_of_image in H. Qed.
Lemma element_of_proporcion e : e ∈ dom (mi_proporcion s) -> e ∈ elementos s.
Proof. intros H. now apply (Escena_inv_6 ok), element_of_image in H. Qed.
Lemma element_of_vertices e : e ∈ dom (mi_vertices s) -> e ∈ elementos s.
Proof. intros H. now apply (Escena_inv_9 ok), element_of_image in H. Qed.

(** An attribute is there exactly for the types that have it. *)
Lemma in_image e t T : (e, t) ∈ de_que_tipo s -> (image (inverse (de_que_tipo s)) T e <-> T t).
Proof.
  intros H. split; [| intros HT; now exists t].
  intros [t' [HT H']]. now rewrite (type_unique _ _ _ H H').
Qed.
Lemma has_centro e t : (e, t) ∈ de_que_tipo s -> (dom (mi_centro s) e <-> centro_types t).
Proof. intros H. rewrite (Escena_inv_2 ok e). exact (in_image e t _ H). Qed.
Lemma has_radio e t : (e, t) ∈ de_que_tipo s -> (dom (mi_radio s) e <-> radio_types t).
Proof. intros H. rewrite (Escena_inv_3 ok e). exact (in_image e t _ H). Qed.
Lemma has_vector e t : (e, t) ∈ de_que_tipo s -> (dom (mi_vector s) e <-> vector_types t).
Proof. intros H. rewrite (Escena_inv_4 ok e). exact (in_image e t _ H). Qed.
Lemma has_altura e t : (e, t) ∈ de_que_tipo s -> (dom (mi_altura s) e <-> altura_types t).
Proof. intros H. rewrite (Escena_inv_5 ok e). exact (in_image e t _ H). Qed.
Lemma has_proporcion e t : (e, t) ∈ de_que_tipo s -> (dom (mi_proporcion s) e <-> proporcion_types t).
Proof. intros H. rewrite (Escena_inv_6 ok e). exact (in_image e t _ H). Qed.
Lemma has_vertices e t : (e, t) ∈ de_que_tipo s -> (dom (mi_vertices s) e <-> vertices_types t).
Proof. intros H. rewrite (Escena_inv_9 ok e). exact (in_image e t _ H). Qed.

(** Every element of a scene is a sphere, a cylinder, a cone, a truncated cone, a plane, a disc or a triangle, with
    attributes in their ranges. Discharges Escena.inv.1, Escena.inv.2, Escena.inv.3, Escena.inv.4, Escena.inv.5,
    Escena.inv.6, Escena.inv.8, Escena.inv.9. *)
Theorem element_cases e : e ∈ elementos s ->
  (exists c r, is_esfera s e c r /\ r ∈ Rmas)
  \/ (exists c r d h, is_cilindro s e c r d h /\ r ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas)
  \/ (exists c k d h, is_cono s e c k d h /\ k ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas)
  \/ (exists c r k d h, is_tronco s e c r k d h /\ r ∈ Rmas /\ k ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas)
  \/ (exists c d, is_plano s e c d /\ d ∈ Unitario)
  \/ (exists c r d, is_disco s e c r d /\ r ∈ Rmas /\ d ∈ Unitario)
  \/ (exists abc, is_triangulo s e abc /\ abc ∈ Vertices).
Proof.
  intros He. destruct (type_of_element e He) as [t Ht].
  assert (HR : forall r, (e, r) ∈ mi_radio s -> r ∈ Rmas) by (intros; apply (Escena_decl_mi_radio ok); now exists e).
  assert (HH : forall r, (e, r) ∈ mi_altura s -> r ∈ Rmas) by (intros; apply (Escena_decl_mi_altura ok); now exists e).
  assert (HK : forall r, (e, r) ∈ mi_proporcion s -> r ∈ Rmas)
    by (intros; apply (Escena_decl_mi_proporcion ok); now exists e).
  assert (HD : forall d, (e, d) ∈ mi_vector s -> d ∈ Unitario) by (intros; apply (Escena_inv_8 ok); now exists e).
  assert (HV : forall abc, (e, abc) ∈ mi_vertices s -> abc ∈ Vertices)
    by (intros; apply (Escena_decl_mi_vertices ok); now exists e).
  pose proof (has_centro e t Ht) as [_ Jc]. pose proof (has_vertices e t Ht) as [_ Jv].
  pose proof (has_radio e t Ht) as [_ Jr]. pose proof (has_vector e t Ht) as [_ Jd].
  pose proof (has_altura e t Ht) as [_ Jh]. pose proof (has_proporcion e t Ht) as [_ Jk].
  unfold centro_types, radio_types, vector_types, altura_types, proporcion_types, vertices_types, union, single in *.
  destruct t; [left | right; left | do 2 right; left | do 3 right; left | do 4 right; left | do 5 right; left
    | do 6 right]; try (destruct Jc as [c Hc]; [now auto 7 |]; exists c).
  - destruct Jr as [r Hr]; auto. exists r. unfold is_esfera. auto.
  - destruct Jr as [r Hr], Jd as [d Hd], Jh as [h Hh]; auto. exists r, d, h. unfold is_cilindro. auto 10.
  - destruct Jk as [k Hk], Jd as [d Hd], Jh as [h Hh]; auto. exists k, d, h. unfold is_cono. auto 10.
  - destruct Jr as [r Hr], Jk as [k Hk], Jd as [d Hd], Jh as [h Hh]; auto. exists r, k, d, h. unfold is_tronco. auto 12.
  - destruct Jd as [d Hd]; auto. exists d. unfold is_plano. auto.
  - destruct Jr as [r Hr], Jd as [d Hd]; auto. exists r, d. unfold is_disco. auto 8.
  - destruct Jv as [abc Hv]; auto. exists abc. unfold is_triangulo. auto.
Qed.
End Invariant.

End Escena.
