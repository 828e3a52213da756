(** spec/historia.tex: a change beside meshes leaves each mesh as it is and can be answered always, and each operation on
    meshes has an operation that undoes it.

    removed, replaced    == as in Meshes.v;  spares == as in Beside.v *)
From Coq Require Import Reals List Setoid Classical_Prop.
From Durero Require Import Toolkit Especificacion Escena Operaciones Malla Meshes MeshClaims Beside Cambios Changes.
Local Open Scope zed_scope.

Section MeshInverses.
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
Notation replaced := (Meshes.replaced Elemento nombre_cara).
Notation removed := (Meshes.removed Elemento nombre_cara).
Notation spares := (Beside.spares Elemento).
Notation Mallas_eq_refl := (Meshes.Mallas_eq_refl Elemento).
Notation Mallas_eq_sym := (Meshes.Mallas_eq_sym Elemento).
Notation Mallas_eq_trans := (Meshes.Mallas_eq_trans Elemento).
Notation Agregar_Malla_computed := (Meshes.Agregar_Malla_computed Elemento nombre_cara named).
Notation Eliminar_Malla_computed := (Meshes.Eliminar_Malla_computed Elemento nombre_cara named).
Notation Reemplazar_Malla_computed := (Meshes.Reemplazar_Malla_computed Elemento nombre_cara named).
Notation Mover_Vertice_computed := (Meshes.Mover_Vertice_computed Elemento nombre_cara named).
Implicit Types (s : Escena) (S T : Mallas) (e m : Elemento) (r q : Red) (c : Punto) (rad h k : R)
  (d : Vector) (abc : Terna) (r_out : Respuesta).

(** ** Changes beside meshes *)

Lemma others_keep {Y} (f f' : rel Elemento Y) e v : f' ≡ oplus f ⦃(e, v)⦄ -> forall p, f p -> fst p <> e -> f' p.
Proof.
  intros Q [x y] H N. apply Q. right. split; [| exact H]. intros [z E].
  unfold single in E. injection E as E _. now apply N.
Qed.
Lemma change_spares s s' e c rad d h k abc r_out : Cambio_Total s s' e c rad d h k abc r_out -> spares e s s'.
Proof.
  assert (Kept : mi_vertices s' ≡ mi_vertices s -> Escena_ok s' -> spares e s s').
  { intros Q ok'. split; [exact ok' |]. intros p Hp _. now apply Q. }
  intros [H | [H | [H | [H | [H | H]]]]]; destruct H as [H | H];
    try (now apply spares_Xi; repeat destruct H as [H | H]; apply H); try (now apply Kept; apply H).
  split; [apply H |]. apply others_keep with abc, H.
Qed.

(** A change of an element of no mesh leaves each mesh as it is, whatever it does. *)
Theorem changes_leave_meshes S s' e c rad d h k abc r_out : Mallas_ok S -> e ∉ de_malla S ->
  Cambio_Total (escena S) s' e c rad d h k abc r_out ->
  Cambio_Mallas nombre_cara S (mk_Mallas _ s' (mallas S)) e c rad d h k abc r_out.
Proof.
  intros ok Out H. destruct (change_spares _ _ _ _ _ _ _ _ _ _ H) as [ok' K]. left.
  split; [exact H | split; [| now split]]. split; [exact ok | | reflexivity].
  split; cbn; [exact ok' | apply ok | apply ok | apply (Mallas_inv_1 _ _ _ ok) |].
  intros m r Hr [u t] Hp. apply K; [now apply (Mallas_inv_2 _ _ _ ok m r Hr) |].
  cbn. intros ->. apply Out. exists m. split; [now exists r | exists r; split; [exact Hr | now exists t]].
Qed.

(** Discharges Cambio_Total.def.1, Cambio_Mallas.def.1, Cambio_Mallas.conj.1. *)
Theorem changes_beside_meshes_are_total : Cambio_Mallas_conj_1 nombre_cara.
Proof.
  intros S e c rad d h k abc ok. destruct (classic (e ∈ de_malla S)) as [In | Out].
  - exists S, es_de_malla. right. split; [now apply Xi_Mallas_refl | exact In | reflexivity].
  - destruct (Cambiar_Centro_Total_is_total (escena S) e c ltac:(apply ok)) as [s' [r_out H]].
    exists (mk_Mallas _ s' (mallas S)), r_out. apply changes_leave_meshes; [exact ok | exact Out | now left].
Qed.

(** ** Operations on meshes *)

(** A mesh that is put where it stands already changes nothing. *)
Lemma replaced_same S m r : Mallas_ok S -> (m, r) ∈ mallas S -> Mallas_eq (replaced S m r) S.
Proof.
  intros ok Hr. pose proof (suyos_of Elemento nombre_cara S m r ok Hr) as Own.
  pose proof (Mallas_Escena _ _ _ ok) as oks. pose proof (Mallas_inv_2 _ _ _ ok m r Hr) as Fam.
  assert (Types : ndres (suyos S m) (de_que_tipo (escena S)) ∪ cartesian (dom (familia m r)) ⦃soy_triangulo⦄
    ≡ de_que_tipo (escena S)).
  { intros [e t]. unfold union, ndres, cartesian, single. cbn. split.
    - intros [[_ H] | [D ->]]; [exact H | apply (suyos_triangulo Elemento nombre_cara S m e ok), Own, D].
    - intros H. destruct (classic (suyos S m e)) as [D | N]; [right | now left]. split; [now apply Own |].
      exact (type_unique _ _ oks _ _ _ H (suyos_triangulo Elemento nombre_cara S m e ok D)). }
  split; [split; cbn; try reflexivity |].
  - intros e. unfold union, diff. split.
    + intros H. destruct (classic (suyos S m e)) as [D | N]; [right; now apply Own | now left].
    + intros [[H _] | D]; [exact H | apply (suyos_element Elemento nombre_cara S m e ok), Own, D].
  - rewrite Types. apply (Escena_inv_7 oks).
  - now rewrite Types.
  - intros [e t]. unfold union, ndres. cbn. split.
    + intros H. destruct (classic (suyos S m e)) as [D | N]; [right | now left]. apply Own in D as [u Hu].
      now rewrite (vertices_unique _ _ oks _ _ _ H (Fam _ Hu)).
    + intros [[_ H] | H]; [exact H | now apply Fam].
  - cbn. intros [w q]. unfold union, ndres, single. cbn. split.
    + intros H. destruct (classic (w = m)) as [-> | N]; [right | now left].
      now rewrite (proj1 (Mallas_decl_mallas _ _ _ ok) _ _ _ H Hr).
    + intros [[_ H] | H]; [exact H |]. injection H as -> ->. exact Hr.
Qed.

(** Two meshes of one name, put one after the other, leave the second. *)
Lemma replaced_twice S m r q : Mallas_ok S -> nameable m r -> nameable m q ->
  dom (familia m r) ∩ (elementos (escena S) ∖ suyos S m) ≡ ∅ ->
  Mallas_eq (replaced (replaced S m r) m q) (replaced S m q).
Proof.
  intros ok Nr Nq Free. pose proof (removed_ok Elemento nombre_cara named S m ok) as ok0.
  assert (None : m ∉ dom (mallas (removed S m))) by (intros [w [N _]]; now apply N).
  assert (Free0 : dom (familia m r) ∩ elementos (escena (removed S m)) ≡ ∅).
  { intros e. rewrite <- (Free e). unfold inter, diff, removed. cbn. unfold union, diff. split; [| tauto].
    intros [D [H | [y []]]]. now split. }
  pose proof (replaced_ok Elemento nombre_cara named S m r ok Nr Free) as okr.
  pose proof (replaced_removed Elemento nombre_cara S m r ok Nr) as A.
  pose proof (removed_replaced Elemento nombre_cara named (removed S m) m r ok0 None Nr Free0) as B.
  assert (C : Mallas_eq (removed (replaced S m r) m) (removed S m)).
  { apply Mallas_eq_sym, Mallas_eq_trans with (1 := B). now apply removed_eq. }
  apply Mallas_eq_trans with (replaced (removed (replaced S m r) m) m q);
    [now apply Mallas_eq_sym, replaced_removed |].
  apply Mallas_eq_trans with (replaced (removed S m) m q); [now apply replaced_eq | now apply replaced_removed].
Qed.

(** Discharges Agregar_Malla.conj.1. *)
Theorem adding_a_mesh_is_undone : Agregar_Malla_conj_1 nombre_cara.
Proof.
  intros S S' m r r_out H. pose proof H as P. apply Agregar_Malla_computed in P as [[ok [P1 [P4 P5]]] [E _]].
  exists malla_eliminada. apply Eliminar_Malla_computed. split; [split; [apply H |] | split; [| reflexivity]].
  - exists r. apply (Mallas_eq_mallas _ _ _ E). now right.
  - apply Mallas_eq_trans with (removed (replaced S m r) m).
    + now apply removed_eq, Mallas_eq_sym.
    + now apply Mallas_eq_sym, (removed_replaced Elemento nombre_cara named).
Qed.

(** Discharges Eliminar_Malla.conj.2. *)
Theorem removing_a_mesh_is_undone : Eliminar_Malla_conj_2 nombre_cara.
Proof.
  intros S S' m r_out H. pose proof H as P. apply Eliminar_Malla_computed in P as [[ok [r Hr]] [E _]].
  pose proof (Mallas_inv_1 _ _ _ ok _ _ Hr) as Nm. exists r. split; [exact Hr |]. exists malla_agregada.
  apply Agregar_Malla_computed. split; [split; [apply H | split; [| split; [exact Nm |]]] | split; [| reflexivity]].
  - intros [q Hq]. apply (Mallas_eq_mallas _ _ _ E) in Hq as [N _]. now apply N.
  - intros e. split; [| intros []]. intros [D He]. apply (Escena_eq_elementos (Mallas_eq_Escena _ _ _ E)) in He.
    destruct He as [[_ N] | [t []]]. apply N. now apply (suyos_of Elemento nombre_cara S m r ok Hr).
  - apply Mallas_eq_trans with (replaced (removed S m) m r); [now apply replaced_eq, Mallas_eq_sym |].
    apply Mallas_eq_trans with (replaced S m r); [now apply replaced_removed | now apply replaced_same].
Qed.

(** A mesh in the place of another is replaced by the one before. *)
Lemma replacing_back S S' m r q : Mallas_ok S -> (m, q) ∈ mallas S -> nameable m r ->
  dom (familia m r) ∩ (elementos (escena S) ∖ suyos S m) ≡ ∅ -> Mallas_eq (replaced S m r) S' ->
  Mallas_ok S' /\ (m, r) ∈ mallas S' /\ dom (familia m q) ∩ (elementos (escena S') ∖ suyos S' m) ≡ ∅
  /\ Mallas_eq (replaced S' m q) S.
Proof.
  intros ok Hq Nr Free E. pose proof (Mallas_inv_1 _ _ _ ok _ _ Hq) as Nq.
  assert (ok' : Mallas_ok S').
  { apply (Mallas_ok_eq Elemento nombre_cara _ _ E). now apply (replaced_ok Elemento nombre_cara named). }
  assert (Hr : (m, r) ∈ mallas S') by (apply (Mallas_eq_mallas _ _ _ E); now right).
  split; [exact ok' | split; [exact Hr | split]].
  - intros e. split; [| intros []]. intros [D [He N]]. apply N, (suyos_of Elemento nombre_cara S' m r ok' Hr).
    apply (Escena_eq_elementos (Mallas_eq_Escena _ _ _ E)) in He as [[_ N'] | D']; [| exact D'].
    destruct N'. now apply (suyos_of Elemento nombre_cara S m q ok Hq).
  - apply Mallas_eq_trans with (replaced (replaced S m r) m q); [now apply replaced_eq, Mallas_eq_sym |].
    apply Mallas_eq_trans with (replaced S m q); [now apply replaced_twice | now apply replaced_same].
Qed.

(** Discharges Reemplazar_Malla.conj.2. *)
Theorem replacing_a_mesh_is_undone : Reemplazar_Malla_conj_2 nombre_cara.
Proof.
  intros S S' m r r_out H. apply Reemplazar_Malla_computed in H as [[ok [[q Hq] [Nr Free]]] [E _]].
  destruct (replacing_back S S' m r q ok Hq Nr Free E) as [ok' [Hr [Free' Back]]].
  exists q. split; [exact Hq |]. exists malla_reemplazada. apply Reemplazar_Malla_computed.
  split; [split; [exact ok' | split; [now exists r | split; [exact (Mallas_inv_1 _ _ _ ok _ _ Hq) | exact Free']]] |].
  now split.
Qed.

Lemma replace_back {X} n (x y : X) l : nth_error l n = Some y -> replace n y (replace n x l) = l.
Proof. revert n; induction l as [| z l IH]; intros [| n] H; cbn in *; [easy | easy | congruence | now rewrite IH]. Qed.
Lemma movida_back r n p w : (n, p) ∈ numbered (puntos r) -> movida (movida r n w) n p = r.
Proof. intros H. destruct r as [ps cs]. unfold movida. cbn in *. now rewrite replace_back. Qed.

(** Discharges Mover_Vertice.conj.2. *)
Theorem moving_a_vertex_is_undone : Mover_Vertice_conj_2 nombre_cara.
Proof.
  intros S S' m n p r_out H. apply Mover_Vertice_computed in H as [r [[ok [Hr [[p0 Hp] HM]]] [E _]]].
  pose proof (Mallas_inv_1 _ _ _ ok _ _ Hr) as Nm. destruct (moved_names Elemento nombre_cara m r n p Nm HM) as [Nm' D].
  assert (Free : dom (familia m (movida r n p)) ∩ (elementos (escena S) ∖ suyos S m) ≡ ∅).
  { intros e. split; [| intros []]. intros [De [_ N]]. apply N, (suyos_of Elemento nombre_cara S m r ok Hr), D, De. }
  destruct (replacing_back S S' m _ r ok Hr Nm' Free E) as [ok' [Hr' [_ Back]]].
  exists r, p0. split; [exact Hr | split; [exact Hp |]]. exists vertice_movido. apply Mover_Vertice_computed.
  exists (movida r n p). pose proof (movida_back r n p0 p Hp) as M.
  split; [split; [exact ok' | split; [exact Hr' | split]] | rewrite M; now split].
  - apply dom_numbered. unfold below. cbn. rewrite length_replace. apply dom_numbered. now exists p0.
  - rewrite M. apply Nm.
Qed.
End MeshInverses.
