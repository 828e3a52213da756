(** spec/malla.tex: the elements that are of no mesh are a scene; with the meshes they say all, and no operation on meshes
    changes them. So the program may keep both apart.

    others S m           == the names of the triangles of the meshes of S but m
    together s f         == the scene s with the triangles of the meshes f
    edited, replaced, removed == as in Meshes.v *)
From Coq Require Import Reals List Setoid Classical_Prop.
From Durero Require Import Toolkit Especificacion Escena Malla Meshes.
Local Open Scope zed_scope.

Section MeshesApart.
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
Notation sueltas := (Malla.sueltas Elemento nombre_cara).
Notation edited := (Meshes.edited Elemento).
Notation replaced := (Meshes.replaced Elemento nombre_cara).
Notation removed := (Meshes.removed Elemento nombre_cara).
Implicit Types (s : Escena) (S T : Mallas) (e m w : Elemento) (r q : Red).

(** ** The other elements are a scene *)

Lemma de_malla_triangulo S e : Mallas_ok S -> de_malla S e -> (e, soy_triangulo) ∈ de_que_tipo (escena S).
Proof. intros ok [m [_ H]]. exact (suyos_triangulo _ _ S m e ok H). Qed.
Lemma de_malla_of S e : de_malla S e <-> exists w q, (w, q) ∈ mallas S /\ dom (familia w q) e.
Proof.
  split.
  - intros [w [_ [q [H He]]]]. now exists w, q.
  - intros [w [q [H He]]]. exists w. split; [now exists q | now exists q].
Qed.
Lemma without_none (N : set Elemento) s : Escena_ok s ->
  Escena_eq (edited s N ∅) {| elementos := elementos s ∖ N; tipos := ran (ndres N (de_que_tipo s));
    de_que_tipo := ndres N (de_que_tipo s); mi_centro := mi_centro s; mi_radio := mi_radio s; mi_vector := mi_vector s;
    mi_altura := mi_altura s; mi_proporcion := mi_proporcion s; mi_vertices := ndres N (mi_vertices s) |}.
Proof.
  intros ok.
  assert (T : ndres N (de_que_tipo s) ∪ cartesian (dom (∅ : rel Elemento Terna)) ⦃soy_triangulo⦄ ≡ ndres N (de_que_tipo s)).
  { intros x. unfold union. split; [now intros [H | [[y []] _]] | now left]. }
  split; cbn; try reflexivity.
  - intros x. unfold union. split; [now left | now intros [H | [y []]]].
  - now rewrite T.
  - now rewrite T.
  - intros x. unfold union. split; [now left | now intros [H | []]].
Qed.

(** Discharges sueltas.def.1, sueltas.conj.1. *)
Theorem elements_of_no_mesh_are_a_scene : sueltas_conj_1 Elemento nombre_cara.
Proof.
  intros S ok. pose proof (Mallas_Escena _ _ _ ok) as ok1.
  apply (Escena_ok_eq _ _ _ (without_none (de_malla S) (escena S) ok1)). apply edited_ok.
  - exact ok1.
  - intros e. now apply de_malla_triangulo.
  - now intros e t t' [].
  - split; [easy | exists nil]. intros e. split; [now intros [t []] | intros []].
  - now intros t [e []].
  - now intros e [t []].
Qed.

(** ** With the meshes they say all *)

Lemma de_malla_eq S T : mallas T ≡ mallas S -> de_malla T ≡ de_malla S.
Proof. intros M e. rewrite !de_malla_of. now setoid_rewrite (M _). Qed.

(** The triangle of a name of a mesh is what its mesh says. *)
Lemma vertices_of_meshes S e t : Mallas_ok S -> de_malla S e ->
  (mi_vertices (escena S) (e, t) <-> exists w q, (w, q) ∈ mallas S /\ familia w q (e, t)).
Proof.
  intros ok D. split.
  - intros V. apply de_malla_of in D as [w [q [H [t' F]]]]. exists w, q. split; [exact H |].
    pose proof (Mallas_inv_2 _ _ _ ok _ _ H _ F) as V'.
    now rewrite (vertices_unique _ _ (Mallas_Escena _ _ _ ok) _ _ _ V V').
  - intros [w [q [H F]]]. exact (Mallas_inv_2 _ _ _ ok _ _ H _ F).
Qed.

(** Discharges sueltas.conj.2. *)
Theorem elements_and_meshes_say_all : sueltas_conj_2 Elemento nombre_cara.
Proof.
  intros S S' ok ok' [[E1 _ E3 E4 E5 E6 E7 E8 E9] M]. cbn in *. pose proof (de_malla_eq _ _ M) as D.
  pose proof (Mallas_Escena _ _ _ ok) as ok1. pose proof (Mallas_Escena _ _ _ ok') as ok2.
  assert (Types : de_que_tipo (escena S') ≡ de_que_tipo (escena S)).
  { intros [e t]. destruct (classic (de_malla S e)) as [De | Ne].
    - assert (De' : de_malla S' e) by now apply D. apply (de_malla_triangulo _ _ ok) in De.
      apply (de_malla_triangulo _ _ ok') in De'. split; intros H.
      + now rewrite (type_unique _ _ ok2 _ _ _ H De').
      + now rewrite (type_unique _ _ ok1 _ _ _ H De).
    - assert (Ne' : ~ de_malla S' e) by now rewrite (D e). specialize (E3 (e, t)). unfold ndres in E3. cbn in E3. tauto. }
  split; [split; auto | exact M].
  - intros e. rewrite (Escena_inv_1 ok2 e), (Escena_inv_1 ok1 e). now apply dom_proper.
  - rewrite (Escena_inv_7 ok2), (Escena_inv_7 ok1). now rewrite Types.
  - intros [e t]. destruct (classic (de_malla S e)) as [De | Ne].
    + assert (De' : de_malla S' e) by now apply D. rewrite (vertices_of_meshes _ _ _ ok' De'), (vertices_of_meshes _ _ _ ok De).
      now setoid_rewrite (M _).
    + assert (Ne' : ~ de_malla S' e) by now rewrite (D e). specialize (E9 (e, t)). unfold ndres in E9. cbn in E9. tauto.
Qed.

(** ** Any scene and any meshes with free names go together *)

Definition families (f : rel Elemento Red) : rel Elemento Terna := fun p => exists w q, (w, q) ∈ f /\ familia w q p.
Definition together s f : Mallas := mk_Mallas _ (edited s ∅ (families f)) f.

Lemma dom_families f e : dom (families f) e <-> exists w q, (w, q) ∈ f /\ dom (familia w q) e.
Proof.
  split.
  - intros [t [w [q [H F]]]]. exists w, q. split; [exact H | now exists t].
  - intros [w [q [H [t F]]]]. exists t, w, q. now split.
Qed.
Lemma finite_families f : functional f -> dom f ∈ 𝔽 univ -> (forall m r, (m, r) ∈ f -> nameable m r) -> dom (families f) ∈ 𝔽 univ.
Proof.
  intros Ff [_ [l Hl]] Nm. split; [easy |].
  assert (L : forall l, exists k, forall w q e, In w l -> (w, q) ∈ f -> dom (familia w q) e -> In e k).
  { clear l Hl. induction l as [| w l [k Hk]]; [now exists nil |].
    destruct (classic (exists q, (w, q) ∈ f)) as [[q Hq] | N].
    - destruct (family_of_a_mesh _ _ named w q (Nm _ _ Hq)) as [_ [[_ [k' Hk']] _]]. exists (k ++ k').
      intros w' q' e [<- | Hw] Hq' He; rewrite in_app_iff; [right | left; now apply (Hk w' q')].
      rewrite (Ff _ _ _ Hq' Hq) in He. now apply Hk'.
    - exists k. intros w' q' e [<- | Hw] Hq' He; [destruct N; now exists q' | now apply (Hk w' q')]. }
  destruct (L l) as [k Hk].
  assert (F : (fun e => In e k) ∈ 𝔽 univ) by (split; [easy | now exists k]).
  apply (finset_subset _ (dom (families f))) in F; [apply F |]. intros e He. apply dom_families in He as [w [q [H He]]].
  apply (Hk w q); [| exact H | exact He]. apply Hl. now exists q.
Qed.

Section Together.
Variables (s : Escena) (f : rel Elemento Red).
Hypothesis ok : Escena_ok s.
Hypothesis function : f ∈ (univ ⇸ Malla.Malla).
Hypothesis finite : dom f ∈ 𝔽 univ.
Hypothesis names : forall m r, (m, r) ∈ f -> nameable m r.
Hypothesis free : forall m r, (m, r) ∈ f -> dom (familia m r) ∩ elementos s ≡ ∅.

Lemma families_free e : dom (families f) e -> ~ elementos s e.
Proof. intros D He. apply dom_families in D as [w [q [H D]]]. exact (proj1 (free _ _ H e) (conj D He)). Qed.

Lemma together_ok : Mallas_ok (together s f).
Proof.
  split; cbn.
  - apply edited_ok.
    + exact ok.
    + intros e [].
    + intros e t t' [w [q [H F]]] [w' [q' [H' F']]].
      assert (E : w = w') by (apply (names_apart _ _ named w w' q q' e); [now exists t | now exists t']). subst w'.
      rewrite (proj1 function _ _ _ H' H) in F'. destruct (family_of_a_mesh _ _ named w q (names _ _ H)) as [Ff _].
      exact (Ff _ _ _ F F').
    + apply finite_families; [apply function | exact finite | exact names].
    + intros t [e [w [q [H F]]]]. destruct (family_of_a_mesh _ _ named w q (names _ _ H)) as [_ [_ V]]. apply V. now exists e.
    + intros e D He. exact (False_ind _ (families_free e D He)).
  - exact function.
  - exact finite.
  - exact names.
  - intros m r H p Hp. right. now exists m, r.
Qed.

Lemma together_apart : Escena_eq s (sueltas (together s f)).
Proof.
  assert (D : forall e, de_malla (together s f) e <-> dom (families f) e).
  { intros e. rewrite de_malla_of, dom_families. reflexivity. }
  assert (Types : ndres (de_malla (together s f)) (de_que_tipo (escena (together s f))) ≡ de_que_tipo s).
  { intros [e t]. cbn. unfold ndres, union, cartesian. cbn. rewrite (D e). split.
    - intros [N [[_ H] | [H _]]]; [exact H | contradiction].
    - intros H. pose proof (element_of_type _ _ ok _ _ H) as He. split; [intros De; exact (families_free e De He) |].
      left. split; [now intros [] | exact H]. }
  split; cbn; try reflexivity.
  - intros e. unfold diff, union. rewrite (D e). split.
    + intros [[[He _] | H] N]; [exact He | contradiction].
    + intros He. split; [left; split; [exact He | now intros []] | intros De; exact (families_free e De He)].
  - rewrite (Escena_inv_7 ok). cbn in Types. now rewrite Types.
  - exact Types.
  - intros [e t]. unfold ndres, union. cbn. rewrite (D e). split.
    + intros [N [[_ H] | H]]; [exact H |]. destruct N. now exists t.
    + intros H. assert (He : elementos s e) by (apply (element_of_vertices _ _ ok); now exists t).
      split; [intros De; exact (families_free e De He) |]. left. split; [now intros [] | exact H].
Qed.
End Together.

(** Discharges sueltas.conj.3. *)
Theorem elements_and_meshes_go_together : sueltas_conj_3 Elemento nombre_cara.
Proof.
  intros s f ok function finite [names free]. exists (together s f). split; [now apply together_ok |].
  split; [| reflexivity]. apply together_apart; auto.
Qed.

(** ** No operation on meshes changes them *)

Definition others S m : set Elemento := fun e => exists w q, (w, q) ∈ mallas S /\ w <> m /\ dom (familia w q) e.

Lemma de_malla_split S m e : de_malla S e <-> others S m e \/ suyos S m e.
Proof.
  rewrite de_malla_of. split.
  - intros [w [q [H D]]]. destruct (classic (w = m)) as [-> | N]; [right; now exists q | left; now exists w, q].
  - intros [[w [q [H [_ D]]]] | [q [H D]]]; [now exists w, q | now exists m, q].
Qed.

Lemma sueltas_eq S T : Mallas_eq S T -> Escena_eq (sueltas S) (sueltas T).
Proof. intros [[E1 _ E3 E4 E5 E6 E7 E8 E9] M]. pose proof (de_malla_eq _ _ M) as D. split; cbn; now rewrite ?D, ?E1, ?E3, ?E9. Qed.

Lemma apart_of_edited S m F M : Mallas_ok S ->
  (forall e, de_malla (mk_Mallas _ (edited (escena S) (suyos S m) F) M) e <-> others S m e \/ dom F e) ->
  (forall e, dom F e -> elementos (escena S) e -> suyos S m e) ->
  Escena_eq (sueltas S) (sueltas (mk_Mallas _ (edited (escena S) (suyos S m) F) M)).
Proof.
  intros ok D Free. pose proof (Mallas_Escena _ _ _ ok) as ok1. set (T := mk_Mallas _ _ _) in *.
  assert (Types : ndres (de_malla T) (de_que_tipo (escena T)) ≡ ndres (de_malla S) (de_que_tipo (escena S))).
  { intros [e t]. unfold ndres. cbn. rewrite (D e), (de_malla_split S m e). unfold union, ndres, cartesian. cbn. split.
    - intros [N [[Ns H] | [H _]]]; tauto.
    - intros [N H]. pose proof (element_of_type _ _ ok1 _ _ H) as He. specialize (Free e). tauto. }
  split; cbn; try reflexivity.
  - intros e. unfold diff, union. rewrite (D e), (de_malla_split S m e). specialize (Free e). unfold diff. tauto.
  - cbn in Types. now rewrite Types.
  - exact Types.
  - intros [e t]. unfold ndres. cbn. rewrite (D e), (de_malla_split S m e). unfold union, ndres. cbn. split.
    + intros [N [[Ns H] | H]]; [tauto |]. destruct N. right. now exists t.
    + intros [N H]. assert (He : elementos (escena S) e) by (apply (element_of_vertices _ _ ok1); now exists t).
      specialize (Free e). tauto.
Qed.

Lemma apart_of_replaced S m r : Mallas_ok S -> dom (familia m r) ∩ (elementos (escena S) ∖ suyos S m) ≡ ∅ ->
  Escena_eq (sueltas S) (sueltas (replaced S m r)).
Proof.
  intros ok Free. apply apart_of_edited; [exact ok | |].
  - intros e. rewrite de_malla_of. cbn. split.
    + intros [w [q [[[N H] | H] D]]]; cbn in *; [left; exists w, q; repeat split; auto |].
      unfold single in H. injection H as -> ->. now right.
    + intros [[w [q [H [N D]]]] | D]; [exists w, q; split; [left; split; [| exact H] | exact D]; cbn; congruence |].
      exists m, r. split; [now right | exact D].
  - intros e D He. apply NNPP. intros N. exact (proj1 (Free e) (conj D (conj He N))).
Qed.

Lemma apart_of_removed S m : Mallas_ok S -> Escena_eq (sueltas S) (sueltas (removed S m)).
Proof.
  intros ok. apply apart_of_edited; [exact ok | |].
  - intros e. rewrite de_malla_of. cbn. split.
    + intros [w [q [[N H] D]]]. cbn in *. left. exists w, q. repeat split; auto.
    + intros [[w [q [H [N D]]]] | [t []]]. exists w, q. split; [split; [| exact H] | exact D]. cbn. congruence.
  - intros e [t []].
Qed.

(** Discharges sueltas.conj.4. *)
Theorem adding_a_mesh_keeps_the_others : sueltas_conj_4 Elemento nombre_cara.
Proof.
  intros S S' m r r_out H. apply (Agregar_Malla_computed _ _ named) in H as [[ok [P1 [P4 P5]]] [E _]].
  apply Escena_eq_trans with (sueltas (replaced S m r)); [| now apply sueltas_eq].
  apply apart_of_replaced; [exact ok |]. now rewrite (diff_nothing _ _ (suyos_none _ _ S m P1)).
Qed.
(** Discharges sueltas.conj.5. *)
Theorem removing_a_mesh_keeps_the_others : sueltas_conj_5 Elemento nombre_cara.
Proof.
  intros S S' m r_out H. apply (Eliminar_Malla_computed _ _ named) in H as [[ok P1] [E _]].
  apply Escena_eq_trans with (sueltas (removed S m)); [now apply apart_of_removed | now apply sueltas_eq].
Qed.
(** Discharges sueltas.conj.6. *)
Theorem replacing_a_mesh_keeps_the_others : sueltas_conj_6 Elemento nombre_cara.
Proof.
  intros S S' m r r_out H. apply (Reemplazar_Malla_computed _ _ named) in H as [[ok [P1 [P4 P5]]] [E _]].
  apply Escena_eq_trans with (sueltas (replaced S m r)); [now apply apart_of_replaced | now apply sueltas_eq].
Qed.
(** A moved mesh has the names that it had. Discharges sueltas.conj.7. *)
Theorem moving_a_vertex_keeps_the_others : sueltas_conj_7 Elemento nombre_cara.
Proof.
  intros S S' m n p r_out H. apply (Mover_Vertice_computed _ _ named) in H as [r [[ok [Hr [Hn HM]]] [E _]]].
  apply Escena_eq_trans with (sueltas (replaced S m (movida r n p))); [| now apply sueltas_eq].
  apply apart_of_replaced; [exact ok |].
  destruct (moved_names _ _ m r n p (Mallas_inv_1 _ _ _ ok _ _ Hr) HM) as [_ D].
  intros e. split; [| intros []]. intros [H [_ N]]. apply N. exists r. split; [exact Hr |]. now apply D.
Qed.

(** Discharges sueltas.conj.8. *)
Theorem single_elements_leave_meshes_alone : sueltas_conj_8 Elemento nombre_cara.
Proof.
  intros S S' [ok ok' M] [e t]. pose proof (de_malla_eq _ _ M) as D. unfold dres. cbn. rewrite (D e). split.
  - intros [De V]. split; [exact De |]. assert (De' : de_malla S' e) by now apply D.
    apply (vertices_of_meshes _ _ _ ok' De') in V. apply (vertices_of_meshes _ _ _ ok De). now setoid_rewrite (M _) in V.
  - intros [De V]. split; [exact De |]. assert (De' : de_malla S' e) by now apply D.
    apply (vertices_of_meshes _ _ _ ok De) in V. apply (vertices_of_meshes _ _ _ ok' De'). now setoid_rewrite (M _).
Qed.
End MeshesApart.
