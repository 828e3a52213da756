(** spec/malla.tex: each operation on meshes has one after-state, which keeps the invariant, and its preconditions are the
    clauses stated in the text.

    edited s N F         == s without the triangles named in N, and with those of F
    replaced S m r       == S with the mesh m being r, whether there was one of that name or not
    removed S m          == S without the mesh m *)
From Coq Require Import Reals List Lia Arith Setoid Classical_Prop.
From Durero Require Import Toolkit Especificacion Escena Malla.
Local Open Scope zed_scope.

Lemma finset_union {X} (A B : set X) : A ∈ 𝔽 univ -> B ∈ 𝔽 univ -> A ∪ B ∈ 𝔽 univ.
Proof.
  intros [_ [l Hl]] [_ [l' Hl']]. split; [easy |]. exists (l ++ l'). intros x. unfold union.
  now rewrite in_app_iff, <- Hl, <- Hl'.
Qed.
Lemma diff_nothing {X} (A N : set X) : N ≡ ∅ -> A ∖ N ≡ A.
Proof. intros H x. unfold diff. rewrite (H x). unfold empty. tauto. Qed.
Lemma ndres_nothing {X Y} (N : set X) (f : rel X Y) : N ≡ ∅ -> ndres N f ≡ f.
Proof. intros H [x y]. unfold ndres. cbn. rewrite (H x). unfold empty. tauto. Qed.
Lemma oplus_single {X Y} (f : rel X Y) x y : oplus f ⦃(x, y)⦄ ≡ ndres ⦃x⦄ f ∪ ⦃(x, y)⦄.
Proof.
  intros [u v]. unfold oplus, ndres, union, dom, single; cbn. split.
  - intros [H | [N H]]; [now right | left]. split; [| exact H]. intros ->. apply N. now exists y.
  - intros [[N H] | H]; [right | now left]. split; [| exact H]. intros [z [= -> _]]. contradiction.
Qed.
Global Instance cartesian_proper {X Y} : Morphisms.Proper (Morphisms.respectful seteq (Morphisms.respectful seteq seteq))
  (@cartesian X Y).
Proof. intros A A' H B B' H' x. unfold cartesian. now rewrite (H _), (H' _). Qed.
Global Instance oplus_proper {X Y} : Morphisms.Proper (Morphisms.respectful seteq (Morphisms.respectful seteq seteq))
  (@oplus X Y).
Proof. intros f f' H g g' H' x. unfold oplus. now rewrite (H _), (H' _), (dom_proper _ _ H' _). Qed.

Section Meshes.
Variable Elemento : Type.
Notation Escena := (Especificacion.Escena Elemento).
Variable nombre_cara : rel (Elemento * nat) Elemento.
Hypothesis named : nombre_cara_def_1 Elemento nombre_cara.
Notation Mallas := (Malla.Mallas Elemento).
Notation Mallas_ok := (Malla.Mallas_ok Elemento nombre_cara).
Notation Mallas_eq := (Malla.Mallas_eq Elemento).
Notation escena := (Malla.escena Elemento).
Notation mallas := (Malla.mallas Elemento).
Notation familia := (Malla.familia Elemento nombre_cara).
Notation nameable := (Malla.nameable Elemento nombre_cara).
Notation suyos := (Malla.suyos Elemento nombre_cara).
Notation de_malla := (Malla.de_malla Elemento nombre_cara).
Implicit Types (s : Escena) (S T : Mallas) (e m w : Elemento) (r q : Red).

(** ** Families *)

(** A family is a function, since names are of one face; it is finite, and its triangles have vertices.
    Discharges nombre_cara.def.1, familia.def.1. *)
Theorem family_of_a_mesh m r : nameable m r ->
  functional (familia m r) /\ dom (familia m r) ∈ 𝔽 univ /\ ran (familia m r) ⊆ Vertices.
Proof.
  intros [[C V] N]. split; [| split].
  - intros e t t' [n [c [Hc [He Ht]]]] [n' [c' [Hc' [He' Ht']]]]. cbn in *.
    assert (E : (m, n) = (m, n')) by (exact (proj2 named e _ _ He He')). injection E as <-.
    rewrite (numbered_functional _ _ _ _ Hc Hc') in Ht.
    exact (proj1 (a_face_has_one_triple r c') _ _ Ht Ht').
  - assert (L : forall k, exists l, forall n e, (n < k)%nat -> ((m, n), e) ∈ nombre_cara -> In e l).
    { induction k as [| k [l Hl]]; [exists nil; intros n e H; lia |].
      destruct (classic (exists e, ((m, k), e) ∈ nombre_cara)) as [[e He] | Ne].
      - exists (e :: l). intros n e' Hn He'. destruct (Nat.eq_dec n k) as [-> | Nk].
        + left. exact (proj1 named _ _ _ He He').
        + right. apply Hl with n; [lia | exact He'].
      - exists l. intros n e Hn He. destruct (Nat.eq_dec n k) as [-> | Nk]; [destruct Ne; now exists e |].
        apply Hl with n; [lia | exact He]. }
    destruct (L (length (caras r))) as [l Hl]. apply finset_subset with (fun e => In e l).
    + split; [easy | now exists l].
    + intros e [t [n [c [Hc [He _]]]]]. apply Hl with n; [| exact He]. apply dom_numbered. now exists c.
  - intros t [e [n [c [Hc [_ Ht]]]]]. cbn in Ht. destruct (V c) as [t' [Ht' HV]]; [now exists n |].
    now rewrite (proj1 (a_face_has_one_triple r c) _ _ Ht Ht').
Qed.

(** The names of a mesh's triangles are those of its faces. *)
Lemma dom_familia m r e : nameable m r ->
  (dom (familia m r) e <-> exists n, n ∈ dom (numbered (caras r)) /\ ((m, n), e) ∈ nombre_cara).
Proof.
  intros [[_ V] _]. split.
  - intros [t [n [c [Hc [He _]]]]]. exists n. split; [now exists c | exact He].
  - intros [n [[c Hc] He]]. destruct (V c) as [t [Ht _]]; [now exists n |]. exists t, n, c. now split.
Qed.
Lemma names_apart m w r q e : e ∈ dom (familia m r) -> e ∈ dom (familia w q) -> m = w.
Proof.
  intros [t [n [c [_ [He _]]]]] [t' [n' [c' [_ [He' _]]]]]. pose proof (proj2 named e _ _ He He') as E. now injection E.
Qed.

Lemma suyos_of S m r : Mallas_ok S -> (m, r) ∈ mallas S -> suyos S m ≡ dom (familia m r).
Proof.
  intros ok H e. split; [| intros He; now exists r]. intros [q [Hq He]].
  now rewrite (proj1 (Mallas_decl_mallas _ _ _ ok) _ _ _ H Hq).
Qed.
Lemma suyos_none S m : m ∉ dom (mallas S) -> suyos S m ≡ ∅.
Proof. intros N e. split; [intros [r [Hr _]]; destruct N; now exists r | intros []]. Qed.
Lemma suyos_triangulo S m e : Mallas_ok S -> e ∈ suyos S m -> (e, soy_triangulo) ∈ de_que_tipo (escena S).
Proof.
  intros ok [r [Hr [t Ht]]]. apply (Mallas_inv_2 _ _ _ ok _ _ Hr) in Ht.
  assert (D : dom (mi_vertices (escena S)) e) by (now exists t).
  apply (Escena_inv_9 (Mallas_Escena _ _ _ ok)) in D as [t' [E H]]. unfold single in E. now subst.
Qed.
Lemma suyos_element S m e : Mallas_ok S -> e ∈ suyos S m -> e ∈ elementos (escena S).
Proof. intros ok H. apply (element_of_type _ _ (Mallas_Escena _ _ _ ok) e soy_triangulo). now apply suyos_triangulo with m. Qed.

(** Triangles of different meshes have different names. Discharges suyos.def.1, suyos.conj.1. *)
Theorem different_meshes_have_different_names : suyos_conj_1 Elemento nombre_cara.
Proof.
  intros S m w _ N e. split; [| intros []]. intros [[r [_ H]] [q [_ H']]]. apply N. now apply names_apart with r q e.
Qed.

(** Discharges de_malla.def.1, de_malla.conj.1. *)
Theorem triangles_of_meshes_are_triangles : de_malla_conj_1 Elemento nombre_cara.
Proof. intros S ok e [m [_ H]]. exists soy_triangulo. split; [reflexivity | now apply suyos_triangulo with m]. Qed.

(** ** The after-states *)

Definition edited s (N : set Elemento) (F : rel Elemento Terna) : Escena := {|
  elementos := elementos s ∖ N ∪ dom F;
  tipos := ran (ndres N (de_que_tipo s) ∪ cartesian (dom F) ⦃soy_triangulo⦄);
  de_que_tipo := ndres N (de_que_tipo s) ∪ cartesian (dom F) ⦃soy_triangulo⦄;
  mi_centro := mi_centro s;
  mi_radio := mi_radio s;
  mi_vector := mi_vector s;
  mi_altura := mi_altura s;
  mi_proporcion := mi_proporcion s;
  mi_vertices := ndres N (mi_vertices s) ∪ F
|}.

Section Edited.
Variables (s : Escena) (N : set Elemento) (F : rel Elemento Terna).
Hypothesis ok : Escena_ok s.
Hypothesis triangles : forall e, N e -> (e, soy_triangulo) ∈ de_que_tipo s.
Hypothesis function : functional F.
Hypothesis finite : dom F ∈ 𝔽 univ.
Hypothesis vertices : ran F ⊆ Vertices.
Hypothesis free : forall e, dom F e -> elementos s e -> N e.

Lemma types_edited (T : set Tipo) : soy_triangulo ∉ T ->
  image (inverse (de_que_tipo s)) T ≡ image (inverse (de_que_tipo (edited s N F))) T.
Proof.
  intros NT e. split; intros [t [Ht H]]; exists t; (split; [exact Ht |]); unfold inverse in *; cbn in *.
  - left. split; [| exact H]. cbn. intros He. apply NT.
    now rewrite (type_unique _ _ ok _ _ _ (triangles e He) H).
  - destruct H as [[_ H] | [_ H]]; [exact H |]. cbn in H. unfold single in H. now subst.
Qed.

Lemma edited_ok : Escena_ok (edited s N F).
Proof.
  assert (E : forall e t, (e, t) ∈ de_que_tipo s -> e ∈ elementos s) by (intros e t; apply (element_of_type _ _ ok)).
  split; cbn; try apply ok.
  - apply finset_union; [| exact finite]. apply finset_subset with (elementos s); [apply ok | now intros x []].
  - easy.
  - split; [| split; easy]. intros e t t' [[Ne H] | [D H]] [[Ne' H'] | [D' H']]; cbn in *; unfold single in *; subst.
    + exact (type_unique _ _ ok _ _ _ H H').
    + destruct Ne. now apply free, (E e t).
    + destruct Ne'. now apply free, (E e t').
    + reflexivity.
  - split; [| split; [easy |]].
    + intros e t t' [[Ne H] | H] [[Ne' H'] | H']; cbn in *.
      * exact (vertices_unique _ _ ok _ _ _ H H').
      * destruct Ne. apply free; [now exists t' | apply (element_of_vertices _ _ ok); now exists t].
      * destruct Ne'. apply free; [now exists t | apply (element_of_vertices _ _ ok); now exists t'].
      * exact (function _ _ _ H H').
    + intros t [e [[_ H] | H]]; [apply (Escena_decl_mi_vertices ok); now exists e | apply vertices; now exists e].
  - intros e. split.
    + intros [[He Ne] | [t Ht]].
      * apply (Escena_inv_1 ok) in He as [t Ht]. exists t. left. now split.
      * exists soy_triangulo. right. split; [now exists t | reflexivity].
    + intros [t [[Ne H] | [D _]]]; [left; split; [now apply (E e t) | exact Ne] | now right].
  - rewrite <- types_edited by (cbv; intuition discriminate). apply ok.
  - rewrite <- types_edited by (cbv; intuition discriminate). apply ok.
  - rewrite <- types_edited by (cbv; intuition discriminate). apply ok.
  - rewrite <- types_edited by (cbv; intuition discriminate). apply ok.
  - rewrite <- types_edited by (cbv; intuition discriminate). apply ok.
  - reflexivity.
  - intros e. split.
    + intros [t [[Ne H] | H]]; exists soy_triangulo; (split; [reflexivity |]); unfold inverse; cbn in *.
      * left. split; [exact Ne |]. cbn. assert (D : dom (mi_vertices s) e) by (now exists t).
        apply (Escena_inv_9 ok) in D as [u [Eu Hu]]. unfold single in Eu. now subst.
      * right. split; [now exists t | reflexivity].
    + intros [t [Et H]]. unfold single in Et. subst t. unfold inverse in H; cbn in H. destruct H as [[Ne H] | [[t Ht] _]].
      * assert (D : dom (mi_vertices s) e) by (apply (Escena_inv_9 ok); exists soy_triangulo; now split).
        destruct D as [t Ht]. exists t. left. now split.
      * exists t. now right.
Qed.
End Edited.

Lemma Mallas_eq_refl S : Mallas_eq S S.
Proof. split; [apply Escena_eq_refl | reflexivity]. Qed.
Lemma Mallas_eq_sym S T : Mallas_eq S T -> Mallas_eq T S.
Proof. intros [E M]. split; [now apply Escena_eq_sym | now symmetry]. Qed.
Lemma Mallas_eq_trans S T U : Mallas_eq S T -> Mallas_eq T U -> Mallas_eq S U.
Proof. intros [E M] [E' M']. split; [now apply Escena_eq_trans with (1 := E) | now rewrite M']. Qed.
Lemma Mallas_ok_eq S T : Mallas_eq S T -> Mallas_ok S -> Mallas_ok T.
Proof.
  intros [E M] ok. split.
  - exact (Escena_ok_eq _ _ _ E (Mallas_Escena _ _ _ ok)).
  - rewrite M. apply ok.
  - rewrite M. apply ok.
  - intros m r H. apply M in H. now apply (Mallas_inv_1 _ _ _ ok).
  - intros m r H p Hp. apply M in H. apply (Escena_eq_mi_vertices E). now apply (Mallas_inv_2 _ _ _ ok _ _ H).
Qed.
Lemma suyos_eq S T m : Mallas_eq S T -> suyos T m ≡ suyos S m.
Proof. intros [_ M] e. unfold Malla.suyos. now setoid_rewrite (M _). Qed.

Definition replaced S m r : Mallas :=
  mk_Mallas _ (edited (escena S) (suyos S m) (familia m r)) (ndres ⦃m⦄ (mallas S) ∪ ⦃(m, r)⦄).
Definition removed S m : Mallas := mk_Mallas _ (edited (escena S) (suyos S m) ∅) (ndres ⦃m⦄ (mallas S)).

(** No triangle of another mesh is among those that are taken. *)
Lemma others_stay S m w q : Mallas_ok S -> (w, q) ∈ mallas S -> w <> m ->
  familia w q ⊆ ndres (suyos S m) (mi_vertices (escena S)).
Proof.
  intros ok H N [e t] He. split; [| exact (Mallas_inv_2 _ _ _ ok _ _ H _ He)]. cbn. intros [r [_ He']].
  apply N. apply names_apart with q r e; [now exists t | exact He'].
Qed.

Lemma replaced_ok S m r : Mallas_ok S -> nameable m r ->
  dom (familia m r) ∩ (elementos (escena S) ∖ suyos S m) ≡ ∅ -> Mallas_ok (replaced S m r).
Proof.
  intros ok Nm Free. destruct (family_of_a_mesh m r Nm) as [Ff [Df Vf]]. pose proof (Mallas_decl_mallas _ _ _ ok) as [Fm [_ Rm]].
  split; cbn.
  - apply edited_ok; auto.
    + apply ok.
    + intros e. now apply suyos_triangulo.
    + intros e He Hs. apply NNPP. intros K. exact (proj1 (Free e) (conj He (conj Hs K))).
  - split; [| split; [easy |]].
    + intros w q q' [[Nw H] | H] [[Nw' H'] | H']; cbn in *; unfold single in *.
      * exact (Fm _ _ _ H H').
      * injection H' as -> _. now destruct Nw.
      * injection H as -> _. now destruct Nw'.
      * congruence.
    + intros q [w [[_ H] | H]]; [apply Rm; now exists w |]. injection H as _ ->. apply Nm.
  - apply finset_subset with (dom (mallas S) ∪ ⦃m⦄).
    + apply finset_add, ok.
    + intros w [q [[_ H] | H]]; [left; now exists q | right; now injection H].
  - intros w q [[_ H] | H]; [now apply (Mallas_inv_1 _ _ _ ok) |]. injection H as -> ->. exact Nm.
  - intros w q [[Nw H] | H] p Hp; [left; now apply (others_stay S m w q) |]. injection H as -> ->. now right.
Qed.

Lemma removed_ok S m : Mallas_ok S -> Mallas_ok (removed S m).
Proof.
  intros ok. pose proof (Mallas_decl_mallas _ _ _ ok) as M. split; cbn.
  - apply edited_ok.
    + apply ok.
    + intros e. now apply suyos_triangulo.
    + now intros e t t' [].
    + split; [easy | exists nil]. intros e. split; [now intros [t []] | intros []].
    + now intros t [e []].
    + now intros e [t []].
  - apply pfun_ndres, M.
  - apply finset_subset with (dom (mallas S)); [apply ok |]. intros w [q [_ H]]. now exists q.
  - intros w q [_ H]. now apply (Mallas_inv_1 _ _ _ ok).
  - intros w q [Nw H] p Hp. left. now apply (others_stay S m w q).
Qed.

(** ** Each operation, computed *)

Lemma eq_of_parts S S' (s : Escena) (M : rel Elemento Red) : Solo_Triangulos Elemento nombre_cara S S' ->
  mi_centro s = mi_centro (escena S) -> mi_radio s = mi_radio (escena S) -> mi_vector s = mi_vector (escena S) ->
  mi_altura s = mi_altura (escena S) -> mi_proporcion s = mi_proporcion (escena S) -> tipos s ≡ ran (de_que_tipo s) ->
  elementos (escena S') ≡ elementos s -> de_que_tipo (escena S') ≡ de_que_tipo s ->
  mi_vertices (escena S') ≡ mi_vertices s -> mallas S' ≡ M -> Mallas_eq (mk_Mallas _ s M) S'.
Proof.
  intros [_ ok' C1 C2 C3 C4 C5] E1 E2 E3 E4 E5 Et He Hd Hv Hm. split; [| exact Hm].
  split; cbn; rewrite ?E1, ?E2, ?E3, ?E4, ?E5; auto.
  now rewrite (Escena_inv_7 (Mallas_Escena _ _ _ ok')), Hd, Et.
Qed.
Lemma parts_of_eq S S' N F M : Mallas_ok S -> Mallas_ok (mk_Mallas _ (edited (escena S) N F) M) ->
  Mallas_eq (mk_Mallas _ (edited (escena S) N F) M) S' -> Solo_Triangulos Elemento nombre_cara S S'.
Proof.
  intros ok ok' E. pose proof (Mallas_ok_eq _ _ E ok') as ok2. destruct E as [[] _]. cbn in *. now split.
Qed.

(** Discharges Solo_Triangulos.post.1, Solo_Triangulos.post.2, Solo_Triangulos.post.3, Solo_Triangulos.post.4,
    Solo_Triangulos.post.5, Completa.inv.1, Malla.inv.1, Agregar_Malla.pre.1, Agregar_Malla.pre.2, Agregar_Malla.pre.3,
    Agregar_Malla.pre.4, Agregar_Malla.pre.5, Agregar_Malla.post.1, Agregar_Malla.post.2, Agregar_Malla.post.3,
    Agregar_Malla.post.4, Agregar_Malla.post.5. *)
Theorem Agregar_Malla_computed S S' m r r_out : Agregar_Malla Elemento nombre_cara S S' m r r_out <->
  (Mallas_ok S /\ m ∉ dom (mallas S) /\ nameable m r /\ dom (familia m r) ∩ elementos (escena S) ≡ ∅)
  /\ Mallas_eq (replaced S m r) S' /\ r_out = malla_agregada.
Proof.
  split.
  - intros [Solo P1 P2 P3 P4 P5 Q1 Q2 Q3 Q4 ->]. pose proof (suyos_none S m P1) as None.
    split; [split; [apply Solo | auto] | split; [| reflexivity]].
    apply eq_of_parts with (1 := Solo); try reflexivity; cbn.
    + now rewrite (diff_nothing _ _ None).
    + now rewrite (ndres_nothing _ _ None).
    + now rewrite (ndres_nothing _ _ None).
    + now rewrite (ndres_outside _ _ P1).
  - intros [[ok [P1 [P4 P5]]] [E ->]]. pose proof (suyos_none S m P1) as None.
    assert (ok' : Mallas_ok (replaced S m r)).
    { apply replaced_ok; auto. now rewrite (diff_nothing _ _ None). }
    pose proof (parts_of_eq _ _ _ _ _ ok ok' E) as Solo. destruct E as [[E1 _ E3 _ _ _ _ _ E9] Em]. cbn in *.
    rewrite (diff_nothing _ _ None) in E1. rewrite (ndres_nothing _ _ None) in E3. rewrite (ndres_nothing _ _ None) in E9.
    rewrite (ndres_outside _ _ P1) in Em.
    split; auto; apply P4.
Qed.

(** Discharges Eliminar_Malla.pre.1, Eliminar_Malla.post.1, Eliminar_Malla.post.2, Eliminar_Malla.post.3,
    Eliminar_Malla.post.4, Eliminar_Malla.post.5. *)
Theorem Eliminar_Malla_computed S S' m r_out : Eliminar_Malla Elemento nombre_cara S S' m r_out <->
  (Mallas_ok S /\ m ∈ dom (mallas S)) /\ Mallas_eq (removed S m) S' /\ r_out = malla_eliminada.
Proof.
  assert (E0 : forall (A : set Elemento), A ∪ dom (∅ : rel Elemento Terna) ≡ A).
  { intros A x. unfold union. split; [now intros [H | [y []]] | now left]. }
  assert (E1 : forall (f : rel Elemento Tipo), f ∪ cartesian (dom (∅ : rel Elemento Terna)) ⦃soy_triangulo⦄ ≡ f).
  { intros f x. unfold union. split; [now intros [H | [[y []] _]] | now left]. }
  assert (E2 : forall (f : rel Elemento Terna), f ∪ ∅ ≡ f).
  { intros f x. unfold union. split; [now intros [H | []] | now left]. }
  split.
  - intros [Solo P1 Q1 Q2 Q3 Q4 ->]. split; [split; [apply Solo | exact P1] | split; [| reflexivity]].
    apply eq_of_parts with (1 := Solo); try reflexivity; cbn; rewrite ?E0, ?E1, ?E2; auto.
  - intros [[ok P1] [E ->]]. pose proof (parts_of_eq _ _ _ _ _ ok (removed_ok S m ok) E) as Solo.
    destruct E as [[F1 _ F3 _ _ _ _ _ F9] Em]. cbn in *. rewrite E0 in F1. rewrite E1 in F3. rewrite E2 in F9.
    split; auto.
Qed.

(** Discharges Reemplazar_Malla.pre.1, Reemplazar_Malla.pre.2, Reemplazar_Malla.pre.3, Reemplazar_Malla.pre.4,
    Reemplazar_Malla.pre.5, Reemplazar_Malla.post.1, Reemplazar_Malla.post.2, Reemplazar_Malla.post.3,
    Reemplazar_Malla.post.4, Reemplazar_Malla.post.5. *)
Theorem Reemplazar_Malla_computed S S' m r r_out : Reemplazar_Malla Elemento nombre_cara S S' m r r_out <->
  (Mallas_ok S /\ m ∈ dom (mallas S) /\ nameable m r
   /\ dom (familia m r) ∩ (elementos (escena S) ∖ suyos S m) ≡ ∅)
  /\ Mallas_eq (replaced S m r) S' /\ r_out = malla_reemplazada.
Proof.
  split.
  - intros [Solo P1 P2 P3 P4 P5 Q1 Q2 Q3 Q4 ->]. split; [split; [apply Solo | auto] | split; [| reflexivity]].
    apply eq_of_parts with (1 := Solo); try reflexivity; cbn; auto. now rewrite Q4, oplus_single.
  - intros [[ok [P1 [P4 P5]]] [E ->]]. pose proof (replaced_ok S m r ok P4 P5) as ok'.
    pose proof (parts_of_eq _ _ _ _ _ ok ok' E) as Solo. destruct E as [[E1 _ E3 _ _ _ _ _ E9] Em]. cbn in *.
    rewrite <- oplus_single in Em. split; auto; apply P4.
Qed.

(** The moved mesh has the faces of the mesh, and so their names. *)
Lemma moved_names m r n p : nameable m r -> movida r n p ∈ Malla ->
  nameable m (movida r n p) /\ dom (familia m (movida r n p)) ≡ dom (familia m r).
Proof.
  intros Nm HM. assert (Nm' : nameable m (movida r n p)) by (split; [exact HM | exact (proj2 Nm)]).
  split; [exact Nm' |]. intros e. now rewrite !dom_familia.
Qed.

(** Discharges movida.def.1, Mover_Vertice.pre.1, Mover_Vertice.pre.2, Mover_Vertice.pre.3, Mover_Vertice.post.1,
    Mover_Vertice.post.2, Mover_Vertice.post.3, Mover_Vertice.post.4, Mover_Vertice.post.5. *)
Theorem Mover_Vertice_computed S S' m n p r_out : Mover_Vertice Elemento nombre_cara S S' m n p r_out <->
  exists r, (Mallas_ok S /\ (m, r) ∈ mallas S /\ n ∈ dom (numbered (puntos r)) /\ movida r n p ∈ Malla)
  /\ Mallas_eq (replaced S m (movida r n p)) S' /\ r_out = vertice_movido.
Proof.
  assert (Parts : forall r, Mallas_ok S -> (m, r) ∈ mallas S -> movida r n p ∈ Malla ->
    let F := familia m (movida r n p) in
    elementos (escena S) ≡ elementos (escena S) ∖ suyos S m ∪ dom F
    /\ de_que_tipo (escena S) ≡ ndres (suyos S m) (de_que_tipo (escena S)) ∪ cartesian (dom F) ⦃soy_triangulo⦄
    /\ oplus (mi_vertices (escena S)) F ≡ ndres (suyos S m) (mi_vertices (escena S)) ∪ F
    /\ dom F ∩ (elementos (escena S) ∖ suyos S m) ≡ ∅).
  { intros r ok Hr HM F. destruct (moved_names m r n p (Mallas_inv_1 _ _ _ ok _ _ Hr) HM) as [Nm D].
    assert (D' : dom F ≡ suyos S m) by (unfold F; rewrite D; symmetry; now apply suyos_of).
    split; [| split; [| split]].
    - intros e. unfold union, diff. rewrite (D' e). pose proof (suyos_element S m e ok).
      destruct (classic (suyos S m e)); tauto.
    - intros [e t]. unfold union, ndres, cartesian, single. cbn. rewrite (D' e).
      pose proof (suyos_triangulo S m e ok) as Tr. split.
      + intros H. destruct (classic (suyos S m e)) as [He | He]; [| tauto]. right. split; [exact He |].
        exact (type_unique _ _ (Mallas_Escena _ _ _ ok) _ _ _ H (Tr He)).
      + intros [[_ H] | [He ->]]; auto.
    - intros [e t]. unfold union, ndres, oplus. cbn. rewrite (D' e). tauto.
    - intros e. unfold inter, diff. rewrite (D' e). unfold empty. tauto. }
  split.
  - intros [Solo _ [r [Hr Hn]] [r1 [Hr1 [_ HM]]] Q1 Q2 [r2 [Hr2 Q3]] [r3 [Hr3 Q4]] ->].
    pose proof (Solo_Triangulos_before _ _ _ _ Solo) as ok. pose proof (proj1 (Mallas_decl_mallas _ _ _ ok)) as Fm.
    rewrite <- (Fm _ _ _ Hr Hr1) in HM. rewrite <- (Fm _ _ _ Hr Hr2) in Q3. rewrite <- (Fm _ _ _ Hr Hr3) in Q4.
    exists r. split; [auto | split; [| reflexivity]]. destruct (Parts r ok Hr HM) as [A1 [A2 [A3 _]]]. cbv zeta in *.
    apply eq_of_parts with (1 := Solo); try reflexivity; cbn.
    + now rewrite Q1.
    + now rewrite Q2.
    + now rewrite Q3.
    + now rewrite Q4, oplus_single.
  - intros [r [[ok [Hr [Hn HM]]] [E ->]]]. destruct (Parts r ok Hr HM) as [A1 [A2 [A3 A4]]]. cbv zeta in *.
    destruct (moved_names m r n p (Mallas_inv_1 _ _ _ ok _ _ Hr) HM) as [Nm _].
    pose proof (replaced_ok S m _ ok Nm A4) as ok'. pose proof (parts_of_eq _ _ _ _ _ ok ok' E) as Solo.
    destruct E as [[E1 _ E3 _ _ _ _ _ E9] Em]. cbn in *.
    split; auto; try (exists r; auto; fail); try (now exists r).
    + now rewrite E1, <- A1.
    + now rewrite E3, <- A2.
    + exists r. split; [exact Hr |]. now rewrite E9, A3.
    + exists r. split; [exact Hr |]. now rewrite Em, oplus_single.
Qed.
End Meshes.
