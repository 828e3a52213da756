(** spec/malla.tex: what the text claims of meshes and of the operations on them.

    edited, replaced, removed == as in Meshes.v *)
From Coq Require Import Reals Setoid Classical_Prop.
From Durero Require Import Toolkit Especificacion Escena Malla Meshes.
Local Open Scope zed_scope.

Section MeshClaims.
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
Notation edited := (Meshes.edited Elemento).
Notation replaced := (Meshes.replaced Elemento nombre_cara).
Notation removed := (Meshes.removed Elemento nombre_cara).
Notation suyos_none := (Meshes.suyos_none Elemento nombre_cara).
Notation suyos_of := (Meshes.suyos_of Elemento nombre_cara).
Notation suyos_eq := (Meshes.suyos_eq Elemento nombre_cara).
Notation replaced_ok := (Meshes.replaced_ok Elemento nombre_cara named).
Notation removed_ok := (Meshes.removed_ok Elemento nombre_cara named).
Notation moved_names := (Meshes.moved_names Elemento nombre_cara).
Notation Mallas_eq_refl := (Meshes.Mallas_eq_refl Elemento).
Notation Mallas_eq_sym := (Meshes.Mallas_eq_sym Elemento).
Notation Mallas_eq_trans := (Meshes.Mallas_eq_trans Elemento).
Notation Agregar_Malla_computed := (Meshes.Agregar_Malla_computed Elemento nombre_cara named).
Notation Eliminar_Malla_computed := (Meshes.Eliminar_Malla_computed Elemento nombre_cara named).
Notation Reemplazar_Malla_computed := (Meshes.Reemplazar_Malla_computed Elemento nombre_cara named).
Notation Mover_Vertice_computed := (Meshes.Mover_Vertice_computed Elemento nombre_cara named).
Implicit Types (s : Escena) (S T : Mallas) (e m w : Elemento) (r q : Red).

(** ** What the text claims *)

(** Discharges Mallas.inv.1, Mallas.inv.2, Init_Mallas.post.1, Init_Mallas.conj.1. *)
Theorem a_first_scene_with_meshes_exists : Init_Mallas_conj_1 Elemento nombre_cara.
Proof.
  destruct (Init_exists Elemento) as [s H]. exists (mk_Mallas _ s ∅). split; cbn; [apply H | | reflexivity].
  split; cbn; try easy.
  - split; [now intros m r q [] | split; [easy | now intros r [m []]]].
  - split; [easy | exists nil]. intros m. split; [now intros [r []] | intros []].
Qed.

Lemma Xi_Mallas_refl S : Mallas_ok S -> Xi_Mallas Elemento nombre_cara S S.
Proof. intros ok. split; auto using Mallas_eq_refl. Qed.

(** What can be wrong with points and faces that a mesh is to have, in the order of the text. *)
Ltac by_cases P := destruct (classic P).

(** Discharges Agregar_Malla_Total.def.1, Agregar_Malla_Total.conj.1, Malla_Ya_Existe.pre.1, Malla_Ya_Existe.post.1,
    Cara_Incompleta.pre.1, Cara_Incompleta.post.1, Caras_Alineadas.pre.1, Caras_Alineadas.pre.2, Caras_Alineadas.post.1,
    Cara_Sin_Nombre.pre.1, Cara_Sin_Nombre.pre.2, Cara_Sin_Nombre.post.1, Cara_Ya_Existe.pre.1, Cara_Ya_Existe.pre.2,
    Cara_Ya_Existe.post.1. *)
Theorem adding_a_mesh_is_total : Agregar_Malla_Total_conj_1 Elemento nombre_cara.
Proof.
  intros S m r ok. pose proof (Xi_Mallas_refl S ok) as X. unfold Agregar_Malla_Total.
  by_cases (m ∈ dom (mallas S)); [exists S, malla_ya_existe; right; left; now split |].
  by_cases (r ∈ Completa); [| exists S, cara_incompleta; do 2 right; left; now split].
  by_cases (r ∈ Malla); [| exists S, vertices_alineados; do 3 right; left; now split].
  by_cases (nameable m r); [| exists S, cara_sin_nombre; do 4 right; left; now split].
  destruct (classic (dom (familia m r) ∩ (elementos (escena S) ∖ suyos S m) ≡ ∅)) as [Free | Free];
    [| exists S, elemento_ya_existe; do 5 right; now split].
  exists (replaced S m r), malla_agregada. left. apply Agregar_Malla_computed. split; [| auto using Mallas_eq_refl].
  split; [exact ok | do 2 (split; [assumption |])].
  now rewrite (diff_nothing _ _ (suyos_none S m ltac:(assumption))) in Free.
Qed.

(** Discharges Eliminar_Malla_Total.def.1, Eliminar_Malla_Total.conj.1, Malla_No_Existe.pre.1, Malla_No_Existe.post.1. *)
Theorem removing_a_mesh_is_total : Eliminar_Malla_Total_conj_1 Elemento nombre_cara.
Proof.
  intros S m ok. by_cases (m ∈ dom (mallas S)).
  - exists (removed S m), malla_eliminada. left. apply Eliminar_Malla_computed. auto using Mallas_eq_refl.
  - exists S, malla_no_existe. right. split; auto using Xi_Mallas_refl.
Qed.

(** Discharges Reemplazar_Malla_Total.def.1, Reemplazar_Malla_Total.conj.1. *)
Theorem replacing_a_mesh_is_total : Reemplazar_Malla_Total_conj_1 Elemento nombre_cara.
Proof.
  intros S m r ok. pose proof (Xi_Mallas_refl S ok) as X. unfold Reemplazar_Malla_Total.
  by_cases (m ∈ dom (mallas S)); [| exists S, malla_no_existe; right; left; now split].
  by_cases (r ∈ Completa); [| exists S, cara_incompleta; do 2 right; left; now split].
  by_cases (r ∈ Malla); [| exists S, vertices_alineados; do 3 right; left; now split].
  by_cases (nameable m r); [| exists S, cara_sin_nombre; do 4 right; left; now split].
  by_cases (dom (familia m r) ∩ (elementos (escena S) ∖ suyos S m) ≡ ∅);
    [| exists S, elemento_ya_existe; do 5 right; now split].
  exists (replaced S m r), malla_reemplazada. left. apply Reemplazar_Malla_computed. auto 8 using Mallas_eq_refl.
Qed.

(** Discharges Mover_Vertice_Total.def.1, Mover_Vertice_Total.conj.1, Vertice_No_Existe.pre.1, Vertice_No_Existe.pre.2,
    Vertice_No_Existe.post.1, Vertice_Alineado.pre.1, Vertice_Alineado.pre.2, Vertice_Alineado.pre.3,
    Vertice_Alineado.post.1. *)
Theorem moving_a_vertex_is_total : Mover_Vertice_Total_conj_1 Elemento nombre_cara.
Proof.
  intros S m n p ok. pose proof (Xi_Mallas_refl S ok) as X. unfold Mover_Vertice_Total.
  destruct (classic (m ∈ dom (mallas S))) as [D | D]; [| exists S, malla_no_existe; right; left; now split].
  destruct D as [r Hr]. assert (D : m ∈ dom (mallas S)) by now exists r.
  by_cases (n ∈ dom (numbered (puntos r))); [| exists S, vertice_no_existe; do 2 right; left; split; auto; now exists r].
  by_cases (movida r n p ∈ Malla); [| exists S, vertices_alineados; do 3 right; split; auto; now exists r].
  exists (replaced S m (movida r n p)), vertice_movido. left. apply Mover_Vertice_computed. exists r.
  auto 8 using Mallas_eq_refl.
Qed.

(** Taking what was put in gives what there was. *)
Lemma removed_replaced S m r : Mallas_ok S -> m ∉ dom (mallas S) -> nameable m r ->
  dom (familia m r) ∩ elementos (escena S) ≡ ∅ -> Mallas_eq S (removed (replaced S m r) m).
Proof.
  intros ok P1 P4 P5. pose proof (suyos_none S m P1) as None.
  assert (ok' : Mallas_ok (replaced S m r)) by (apply replaced_ok; auto; now rewrite (diff_nothing _ _ None)).
  assert (Own : suyos (replaced S m r) m ≡ dom (familia m r)) by (apply suyos_of; [exact ok' | now right]).
  assert (Apart : forall e, elementos (escena S) e -> ~ dom (familia m r) e).
  { intros e He H. exact (proj1 (P5 e) (conj H He)). }
  assert (Types : ndres (dom (familia m r)) (de_que_tipo (escena S) ∪ cartesian (dom (familia m r)) ⦃soy_triangulo⦄)
    ∪ cartesian (dom (∅ : rel Elemento Terna)) ⦃soy_triangulo⦄ ≡ de_que_tipo (escena S)).
  { intros [e t]. unfold union, ndres, cartesian. cbn. split.
    - intros [[Ne [H | [H _]]] | [[y []] _]]; [exact H | contradiction].
    - intros H. left. split; [| now left]. apply Apart. exact (element_of_type _ _ (Mallas_Escena _ _ _ ok) e t H). }
  split; [split; cbn; try reflexivity |].
  - rewrite Own, (diff_nothing _ _ None). intros e. unfold union, diff. split.
    + intros [[[He | He] Ne] | [y []]]; [exact He | contradiction].
    + intros He. left. split; [now left | now apply Apart].
  - rewrite Own, (ndres_nothing _ _ None), Types. symmetry. apply (Escena_inv_7 (Mallas_Escena _ _ _ ok)).
  - now rewrite Own, (ndres_nothing _ _ None), Types.
  - rewrite Own, (ndres_nothing _ _ None). intros [e t]. unfold union, ndres. cbn. split.
    + intros [[Ne [H | H]] | []]; [exact H |]. destruct Ne. now exists t.
    + intros H. left. split; [| now left]. apply Apart, (element_of_vertices _ _ (Mallas_Escena _ _ _ ok)). now exists t.
  - cbn. rewrite (ndres_outside _ _ P1). intros [w q]. unfold ndres, union, single. cbn. split.
    + intros [N [H | H]]; [exact H | congruence].
    + intros H. split; [| now left]. intros ->. apply P1. now exists q.
Qed.

Lemma edited_eq s s' N N' F : Escena_eq s s' -> N ≡ N' -> Escena_eq (edited s N F) (edited s' N' F).
Proof. intros [H1 H2 H3 H4 H5 H6 H7 H8 H9] H. split; cbn; now rewrite ?H1, ?H3, ?H4, ?H5, ?H6, ?H7, ?H8, ?H9, ?H. Qed.
Lemma removed_eq S T m : Mallas_eq S T -> Mallas_eq (removed S m) (removed T m).
Proof.
  intros E. split; cbn; [apply edited_eq; [apply E | now rewrite (suyos_eq S T m E)] | now rewrite (Mallas_eq_mallas _ _ _ E)].
Qed.
Lemma replaced_eq S T m r : Mallas_eq S T -> Mallas_eq (replaced S m r) (replaced T m r).
Proof.
  intros E. split; cbn; [apply edited_eq; [apply E | now rewrite (suyos_eq S T m E)] | now rewrite (Mallas_eq_mallas _ _ _ E)].
Qed.

(** To remove a mesh that was added gives the scene before. Discharges Eliminar_Malla.conj.1. *)
Theorem adding_then_removing_a_mesh_is_the_identity : Eliminar_Malla_conj_1 Elemento nombre_cara.
Proof.
  intros S S' m r ok ok' [T0 [r0 A0]]. apply Agregar_Malla_computed in A0 as [[_ [P1 [P4 P5]]] _].
  pose proof (removed_replaced S m r ok P1 P4 P5) as Id. split.
  - intros [T [[r1 A] [r2 R]]]. apply Agregar_Malla_computed in A as [_ [E _]].
    apply Eliminar_Malla_computed in R as [_ [E' _]].
    apply Mallas_eq_trans with (1 := Id), Mallas_eq_trans with (2 := E'). now apply removed_eq.
  - intros E. exists (replaced S m r). split.
    + exists malla_agregada. apply Agregar_Malla_computed. auto using Mallas_eq_refl.
    + exists malla_eliminada. apply Eliminar_Malla_computed. split; [split | split; [| reflexivity]].
      * apply replaced_ok; auto. now rewrite (diff_nothing _ _ (suyos_none S m P1)).
      * exists r. now right.
      * apply Mallas_eq_trans with (2 := E). now apply Mallas_eq_sym.
Qed.

(** Putting the mesh into what it was taken from is replacing it. *)
Lemma replaced_removed S m r : Mallas_ok S -> nameable m r -> Mallas_eq (replaced (removed S m) m r) (replaced S m r).
Proof.
  intros ok P4. assert (None : suyos (removed S m) m ≡ ∅).
  { apply suyos_none. intros [q [N _]]. now apply N. }
  assert (Types : ndres (suyos (removed S m) m) (ndres (suyos S m) (de_que_tipo (escena S))
    ∪ cartesian (dom (∅ : rel Elemento Terna)) ⦃soy_triangulo⦄) ≡ ndres (suyos S m) (de_que_tipo (escena S))).
  { rewrite (ndres_nothing _ _ None). intros [e t]. unfold union, cartesian. cbn.
    split; [now intros [H | [[y []] _]] | now left]. }
  split; [split; cbn; try reflexivity |].
  - rewrite (diff_nothing _ _ None). intros e. unfold union. split.
    + intros [H | H]; [now left; left | now right].
    + intros [[H | [y []]] | H]; [now left | now right].
  - now rewrite Types.
  - now rewrite Types.
  - rewrite (ndres_nothing _ _ None). intros [e t]. unfold union. cbn. split.
    + intros [H | H]; [now left; left | now right].
    + intros [[H | []] | H]; [now left | now right].
  - cbn. intros [w q]. unfold ndres, union. cbn. split.
    + intros [H | H]; [left; split; [apply H | split; [apply H | apply H]] | now right].
    + intros [[N [_ H]] | H]; [left; now split | now right].
Qed.

(** To replace a mesh is to remove it and to add the other. Discharges Reemplazar_Malla.conj.1. *)
Theorem replacing_is_removing_then_adding : Reemplazar_Malla_conj_1 Elemento nombre_cara.
Proof.
  intros S S' m r ok ok'.
  assert (None : m ∉ dom (mallas (removed S m))) by (intros [q [N _]]; now apply N).
  assert (Left : elementos (escena (removed S m)) ≡ elementos (escena S) ∖ suyos S m).
  { intros e. cbn. unfold union. split; [now intros [H | [y []]] | now left]. }
  split.
  - intros [r0 H]. apply Reemplazar_Malla_computed in H as [[_ [P1 [P4 P5]]] [E _]]. exists (removed S m). split.
    + exists malla_eliminada. apply Eliminar_Malla_computed. auto using Mallas_eq_refl.
    + exists malla_agregada. apply Agregar_Malla_computed. split; [| split; [| reflexivity]].
      * split; [now apply removed_ok |]. split; [exact None |]. split; [exact P4 | now rewrite Left].
      * apply Mallas_eq_trans with (2 := E). now apply replaced_removed.
  - intros [T [[r1 R] [r2 A]]]. apply Eliminar_Malla_computed in R as [[_ P1] [E _]].
    apply Agregar_Malla_computed in A as [[_ [_ [P4 P5]]] [E' _]].
    exists malla_reemplazada. apply Reemplazar_Malla_computed. split; [| split; [| reflexivity]].
    + split; [exact ok |]. split; [exact P1 |]. split; [exact P4 |]. rewrite <- Left.
      now rewrite (Escena_eq_elementos (Mallas_eq_Escena _ _ _ E)) in P5.
    + apply Mallas_eq_trans with (2 := E'), Mallas_eq_trans with (replaced (removed S m) m r).
      * now apply Mallas_eq_sym, replaced_removed.
      * now apply replaced_eq.
Qed.

(** To move a vertex is to replace the mesh by the moved one. Discharges Mover_Vertice.conj.1. *)
Theorem moving_is_replacing_by_the_moved : Mover_Vertice_conj_1 Elemento nombre_cara.
Proof.
  intros S S' m n p r ok ok' [P1 [_ [q [Hq [Hn ->]]]]]. pose proof (proj1 (Mallas_decl_mallas _ _ _ ok)) as Fm.
  pose proof (Mallas_inv_1 _ _ _ ok _ _ Hq) as Nq. split.
  - intros [r0 H]. apply Mover_Vertice_computed in H as [q' [[_ [Hq' [_ HM]]] [E _]]].
    rewrite <- (Fm _ _ _ Hq Hq') in *. destruct (moved_names m q n p Nq HM) as [Nm D].
    exists malla_reemplazada. apply Reemplazar_Malla_computed. split; [| auto].
    split; [exact ok |]. split; [exact P1 |]. split; [exact Nm |].
    intros e. split; [| intros []]. intros [H [_ N]]. apply N.
    apply (suyos_of S m q ok Hq), D, H.
  - intros [r0 H]. apply Reemplazar_Malla_computed in H as [[_ [_ [Nm _]]] [E _]].
    exists vertice_movido. apply Mover_Vertice_computed. exists q. split; [| auto].
    split; [exact ok |]. split; [exact Hq |]. split; [exact Hn | apply Nm].
Qed.
End MeshClaims.
