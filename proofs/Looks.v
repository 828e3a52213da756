(** spec/historia.tex: groups and materials follow the elements, each operation on them has one after-state, which keeps
    the invariant, the total ones answer every call, and each has an operation that undoes it.

    looks V f m          == V with the groups f and the materials m
    fits A B f           == f gives elements of A names of B *)
From Coq Require Import Reals Setoid Classical_Prop.
From Durero Require Import Toolkit Especificacion Escena Operaciones Totals Malla Cambios Changes Vista.
From Durero Require Meshes MeshInverses.
Local Open Scope zed_scope.

Definition fits {X Y} (A : set X) (B : set Y) (f : rel X Y) : Prop := f ∈ (univ ⇸ univ) /\ dom f ⊆ A /\ ran f ⊆ B.

Lemma fits_eq {X Y} (A A' : set X) (B B' : set Y) (f f' : rel X Y) :
  A' ≡ A -> B' ≡ B -> f' ≡ f -> fits A B f -> fits A' B' f'.
Proof. intros HA HB Hf H. unfold fits. now rewrite HA, HB, Hf. Qed.
Lemma fits_oplus {X Y} (A : set X) (B : set Y) f e v : fits A B f -> e ∈ A -> v ∈ B -> fits A B (oplus f ⦃(e, v)⦄).
Proof.
  intros [[Ff _] [D R]] He Hv. split; [split; [| easy] | split].
  - rewrite Meshes.oplus_single. intros x y y' [[N H] | H] [[N' H'] | H']; cbn in *; unfold single in *.
    + exact (Ff _ _ _ H H').
    + injection H' as -> _. now destruct N.
    + injection H as -> _. now destruct N'.
    + congruence.
  - intros x [y [H | [_ H]]]; [unfold single in H; injection H as -> _; exact He | apply D; now exists y].
  - intros y [x [H | [_ H]]]; [unfold single in H; injection H as _ ->; exact Hv | apply R; now exists x].
Qed.
Lemma fits_part {X Y} (A A' : set X) (B : set Y) (f f' : rel X Y) : fits A B f -> f' ⊆ f -> dom f' ⊆ A' -> fits A' B f'.
Proof.
  intros [[Ff _] [_ R]] P D. split; [split; [| easy] | split; [exact D |]].
  - intros x y y' H H'. exact (Ff _ _ _ (P _ H) (P _ H')).
  - intros y [x H]. apply R. exists x. now apply P.
Qed.
Lemma fits_ndres {X Y} (A : set X) (B : set Y) f e : fits A B f -> fits A B (ndres ⦃e⦄ f).
Proof.
  intros F. apply fits_part with (1 := F); [now intros p [_ H] |]. intros x [y [_ H]]. apply F. now exists y.
Qed.

(** The value before is given back: by another override, by taking the value away, or by giving it again. *)
Lemma overridden_back {X Y} (f : rel X Y) e v w : functional f -> (e, w) ∈ f -> oplus (oplus f ⦃(e, v)⦄) ⦃(e, w)⦄ ≡ f.
Proof. intros Ff H. rewrite <- !oplus_one. now apply oplus_back. Qed.
Lemma overridden_away {X Y} (f : rel X Y) e v : e ∉ dom f -> ndres ⦃e⦄ (oplus f ⦃(e, v)⦄) ≡ f.
Proof. intros N. rewrite Meshes.oplus_single, (ndres_outside f e N), <- at_one_single. now apply ndres_union_at_one. Qed.
Lemma taken_and_given {X Y} (f : rel X Y) e v : functional f -> (e, v) ∈ f -> oplus (ndres ⦃e⦄ f) ⦃(e, v)⦄ ≡ f.
Proof.
  intros Ff Hv. rewrite Meshes.oplus_single. intros [x y]. unfold union, ndres, single. cbn. split.
  - intros [[_ [_ H]] | E]; [exact H |]. injection E as -> ->. exact Hv.
  - intros H. destruct (classic (x = e)) as [-> | N]; [right; now rewrite (Ff _ _ _ H Hv) | left; now split].
Qed.

Section Looks.
Context {Elemento Nombre : Type}.
Notation Escena := (Especificacion.Escena Elemento).
Notation Vista := (@Vista.Vista Elemento Nombre).
Implicit Types (s : Escena) (V : Vista) (e : Elemento) (x g : Nombre) (r_out : Respuesta).

Lemma Vista_eq_refl V : Vista_eq V V.
Proof. split; [apply Escena_eq_refl | reflexivity ..]. Qed.
Lemma Vista_eq_sym V V' : Vista_eq V V' -> Vista_eq V' V.
Proof. intros []. split; [now apply Escena_eq_sym | now symmetry ..]. Qed.
Lemma Vista_eq_trans V V' W : Vista_eq V V' -> Vista_eq V' W -> Vista_eq V W.
Proof. intros [] []. split; [eapply Escena_eq_trans; eassumption | etransitivity; eassumption ..]. Qed.

Lemma groups_fit V : Vista_ok V -> fits (elementos (vista_escena V)) (grupos V) (mi_grupo V).
Proof. intros []. now split. Qed.
Lemma materials_fit V : Vista_ok V -> fits (elementos (vista_escena V)) (materiales V) (mi_material V).
Proof. intros []. now split. Qed.

Definition looks V (f m : rel Elemento Nombre) : Vista := mk_Vista (vista_escena V) (grupos V) (materiales V) f m.
Lemma looks_ok V f m : Vista_ok V -> fits (elementos (vista_escena V)) (grupos V) f ->
  fits (elementos (vista_escena V)) (materiales V) m -> Vista_ok (looks V f m).
Proof. intros ok [F1 [F2 F3]] [M1 [M2 M3]]. split; cbn; auto; apply ok. Qed.

(** Discharges Vista.inv.1, Vista.inv.2, Vista.inv.3, Vista.inv.4. *)
Theorem equal_looks_keep_the_invariant V V' : Vista_eq V V' -> Vista_ok V -> Vista_ok V'.
Proof.
  intros [E G M F K] ok. pose proof (Escena_eq_elementos E) as D.
  destruct (fits_eq _ _ _ _ _ _ D G F (groups_fit V ok)) as [F1 [F2 F3]].
  destruct (fits_eq _ _ _ _ _ _ D M K (materials_fit V ok)) as [K1 [K2 K3]].
  split; auto; [exact (Escena_ok_eq _ _ _ E (Vista_Escena _ ok)) | rewrite G; apply ok | rewrite M; apply ok].
Qed.

(** ** Operations on elements *)

(** Groups and materials of the elements that stay fit the scene that follows, whichever it is. *)
Lemma what_stays V s' : Vista_ok V -> Escena_ok s' -> exists V', vista_escena V' = s' /\ Mismo_Aspecto V V'.
Proof.
  intros ok ok'.
  exists (mk_Vista s' (grupos V) (materiales V) (dres (elementos s') (mi_grupo V)) (dres (elementos s') (mi_material V))).
  split; [reflexivity | split; cbn; try reflexivity]. split; [exact ok |].
  assert (Part : forall (B : set Nombre) f,
    fits (elementos (vista_escena V)) B f -> fits (elementos s') B (dres (elementos s') f)).
  { intros B f F. apply fits_part with (1 := F); [now intros p [_ H] | now intros y [v [H _]]]. }
  destruct (Part _ _ (groups_fit V ok)) as [F1 [F2 F3]]. destruct (Part _ _ (materials_fit V ok)) as [K1 [K2 K3]].
  split; cbn; auto; apply ok.
Qed.

(** Discharges Mismo_Aspecto.post.1, Mismo_Aspecto.post.2, Mismo_Aspecto.post.3, Mismo_Aspecto.post.4,
    Agregar_Elemento_Vista.def.1, Eliminar_Elemento_Vista.def.1, Cambio_Vista.def.1. *)
Theorem edits_of_elements_with_looks_are_total V e t c rad d h k abc : Vista_ok V ->
  (exists V' r_out, Agregar_Elemento_Vista V V' e t c rad d h k abc r_out)
  /\ (exists V' r_out, Eliminar_Elemento_Vista V V' e r_out)
  /\ exists V' r_out, Cambio_Vista V V' e c rad d h k abc r_out.
Proof.
  intros ok. pose proof (Vista_Escena _ ok) as oks.
  assert (Any : forall X : Escena -> Respuesta -> Prop, (exists s' r_out, X s' r_out) ->
    (forall s' r_out, X s' r_out -> Escena_ok s') -> exists V' r_out, X (vista_escena V') r_out /\ Mismo_Aspecto V V').
  { intros X [s' [r_out H]] Safe. destruct (what_stays V s' ok (Safe _ _ H)) as [V' [<- M]]. now exists V', r_out. }
  split; [| split].
  - apply (Any (fun s' r_out => Agregar_Elemento_Total (vista_escena V) s' e t c rad d h k abc r_out)).
    + now apply Agregar_Elemento_Total_is_total.
    + intros s' r_out H. now apply total_addition_safe in H.
  - apply (Any (fun s' r_out => Eliminar_Elemento_Total (vista_escena V) s' e r_out)).
    + now apply Eliminar_Elemento_Total_is_total.
    + intros s' r_out H. now apply total_removal_safe in H.
  - apply (Any (fun s' r_out => Cambio_Total (vista_escena V) s' e c rad d h k abc r_out)).
    + destruct (Cambiar_Centro_Total_is_total _ e c oks) as [s' [r_out H]]. exists s', r_out. now left.
    + intros s' r_out H. now apply MeshInverses.change_spares in H as [ok' _].
Qed.

(** Discharges Mismo_Aspecto.conj.1. *)
Theorem looks_survive_a_change : @Mismo_Aspecto_conj_1 Elemento Nombre.
Proof.
  intros V V' e r_out [[ok ok'] _ _ F K] [_ _ Q _ _].
  assert (All : forall (B : set Nombre) f,
    fits (elementos (vista_escena V)) B f -> dres (elementos (vista_escena V')) f ≡ f).
  { intros B f [_ [D _]] [y v]. unfold dres. cbn. split; [now intros [_ H] |]. intros H. split; [| exact H].
    apply Q, D. now exists v. }
  split; [rewrite F; apply (All _ _ (groups_fit V ok)) | rewrite K; apply (All _ _ (materials_fit V ok))].
Qed.

(** ** Materials and groups, computed *)

Lemma looks_after V V' f m : Vista_ok V -> fits (elementos (vista_escena V)) (grupos V) f ->
  fits (elementos (vista_escena V)) (materiales V) m -> Vista_eq (looks V f m) V' ->
  Delta_Vista V V' /\ Xi_Escena (vista_escena V) (vista_escena V') /\ grupos V' ≡ grupos V /\ materiales V' ≡ materiales V
  /\ mi_grupo V' ≡ f /\ mi_material V' ≡ m.
Proof.
  intros ok F M E. pose proof (equal_looks_keep_the_invariant _ _ E (looks_ok V f m ok F M)) as ok'.
  destruct E as [E G K Q R]. cbn in *. split; [now split | split; [| auto]].
  split; [split; [apply ok | apply ok'] | exact E].
Qed.
Ltac fit := try first [apply fits_oplus | apply fits_ndres]; auto using groups_fit, materials_fit.
Ltac looks_computed := split;
  [ intros [[ok ok'] [_ E] ? ? ? ? ?]; subst; split; [tauto | split; [split; cbn; auto | reflexivity]]
  | intros [C [E ->]]; decompose [and] C; apply looks_after in E; [| assumption | fit | fit];
    destruct E as (? & ? & ? & ? & ? & ?); split; auto ].

(** Discharges Cambiar_Material.pre.1, Cambiar_Material.pre.2, Cambiar_Material.post.1, Cambiar_Material.post.2,
    Cambiar_Material.post.3, Cambiar_Material.post.4, Cambiar_Material.post.5. *)
Theorem Cambiar_Material_computed V V' e x r_out : Cambiar_Material V V' e x r_out <->
  (Vista_ok V /\ e ∈ elementos (vista_escena V) /\ x ∈ materiales V)
  /\ Vista_eq (looks V (mi_grupo V) (oplus (mi_material V) ⦃(e, x)⦄)) V' /\ r_out = elemento_cambiado.
Proof. looks_computed. Qed.
(** Discharges Quitar_Material.pre.1, Quitar_Material.post.1, Quitar_Material.post.2, Quitar_Material.post.3,
    Quitar_Material.post.4, Quitar_Material.post.5. *)
Theorem Quitar_Material_computed V V' e r_out : Quitar_Material V V' e r_out <->
  (Vista_ok V /\ e ∈ elementos (vista_escena V))
  /\ Vista_eq (looks V (mi_grupo V) (ndres ⦃e⦄ (mi_material V))) V' /\ r_out = elemento_cambiado.
Proof. looks_computed. Qed.
(** Discharges Cambiar_Grupo.pre.1, Cambiar_Grupo.pre.2, Cambiar_Grupo.post.1, Cambiar_Grupo.post.2,
    Cambiar_Grupo.post.3, Cambiar_Grupo.post.4, Cambiar_Grupo.post.5. *)
Theorem Cambiar_Grupo_computed V V' e g r_out : Cambiar_Grupo V V' e g r_out <->
  (Vista_ok V /\ e ∈ elementos (vista_escena V) /\ g ∈ grupos V)
  /\ Vista_eq (looks V (oplus (mi_grupo V) ⦃(e, g)⦄) (mi_material V)) V' /\ r_out = elemento_cambiado.
Proof. looks_computed. Qed.
(** Discharges Quitar_Grupo.pre.1, Quitar_Grupo.post.1, Quitar_Grupo.post.2, Quitar_Grupo.post.3, Quitar_Grupo.post.4,
    Quitar_Grupo.post.5. *)
Theorem Quitar_Grupo_computed V V' e r_out : Quitar_Grupo V V' e r_out <->
  (Vista_ok V /\ e ∈ elementos (vista_escena V))
  /\ Vista_eq (looks V (ndres ⦃e⦄ (mi_grupo V)) (mi_material V)) V' /\ r_out = elemento_cambiado.
Proof. looks_computed. Qed.

(** ** Every call has an answer *)

Ltac answered computed := lazymatch goal with ok : Vista_ok ?V, e : Elemento |- _ =>
  let X := fresh "X" in assert (X : Xi_Vista V V) by (split; [now split | apply Vista_eq_refl]);
  destruct (classic (e ∈ elementos (vista_escena V))); [| exists V, elemento_no_existe; right; try left; now split];
  do 2 eexists; left; apply computed; split; [auto | split; [apply Vista_eq_refl | reflexivity]] end.

(** Discharges Cambiar_Material_Total.def.1, Cambiar_Material_Total.conj.1, Nadie_Se_Llama.pre.1, Nadie_Se_Llama.post.1,
    Material_No_Existe.pre.1, Material_No_Existe.post.1. *)
Theorem changing_a_material_is_total : @Cambiar_Material_Total_conj_1 Elemento Nombre.
Proof.
  intros V e x ok. destruct (classic (x ∈ materiales V)) as [Hx | Hx]; [answered Cambiar_Material_computed |].
  exists V, material_no_existe. right; right. split; auto. split; [now split | apply Vista_eq_refl].
Qed.
(** Discharges Quitar_Material_Total.def.1, Quitar_Material_Total.conj.1. *)
Theorem taking_a_material_away_is_total : @Quitar_Material_Total_conj_1 Elemento Nombre.
Proof. intros V e ok. answered Quitar_Material_computed. Qed.
(** Discharges Cambiar_Grupo_Total.def.1, Cambiar_Grupo_Total.conj.1, Grupo_No_Existe.pre.1, Grupo_No_Existe.post.1. *)
Theorem changing_a_group_is_total : @Cambiar_Grupo_Total_conj_1 Elemento Nombre.
Proof.
  intros V e g ok. destruct (classic (g ∈ grupos V)) as [Hg | Hg]; [answered Cambiar_Grupo_computed |].
  exists V, grupo_no_existe. right; right. split; auto. split; [now split | apply Vista_eq_refl].
Qed.
(** Discharges Quitar_Grupo_Total.def.1, Quitar_Grupo_Total.conj.1. *)
Theorem taking_a_group_away_is_total : @Quitar_Grupo_Total_conj_1 Elemento Nombre.
Proof. intros V e ok. answered Quitar_Grupo_computed. Qed.

(** ** Every operation on them has one that undoes it *)

(** A scene with looks that came of V leads back to V: all but the names that were changed are as in V. *)
Ltac looks_back E := destruct E as [E G K Q R]; cbn in *; split; cbn;
  [now apply Escena_eq_sym | now symmetry | now symmetry | ..]; first [now symmetry | symmetry; rewrite ?Q, ?R].

(** Discharges Cambiar_Material.conj.1. *)
Theorem a_new_material_is_undone : @Cambiar_Material_conj_1 Elemento Nombre.
Proof.
  intros V V' e x r_out H [y Hy]. pose proof H as P. apply Cambiar_Material_computed in P as [[ok [He _]] [E _]].
  exists y. split; [exact Hy |]. exists elemento_cambiado.
  apply Cambiar_Material_computed. split; [| split; [| reflexivity]].
  - split; [apply H | split; [now apply (Escena_eq_elementos (Vista_eq_Escena _ _ E)) |]].
    apply (Vista_eq_materiales _ _ E), (Vista_inv_4 _ ok). now exists e.
  - looks_back E. apply overridden_back; [apply ok | exact Hy].
Qed.
(** Discharges Cambiar_Material.conj.2. *)
Theorem a_first_material_is_undone : @Cambiar_Material_conj_2 Elemento Nombre.
Proof.
  intros V V' e x r_out H N. pose proof H as P. apply Cambiar_Material_computed in P as [[ok [He _]] [E _]].
  exists elemento_cambiado. apply Quitar_Material_computed. split; [| split; [| reflexivity]].
  - split; [apply H | now apply (Escena_eq_elementos (Vista_eq_Escena _ _ E))].
  - looks_back E. now apply overridden_away.
Qed.
(** Discharges Quitar_Material.conj.1. *)
Theorem a_material_taken_away_is_given_back : @Quitar_Material_conj_1 Elemento Nombre.
Proof.
  intros V V' e r_out H [y Hy]. pose proof H as P. apply Quitar_Material_computed in P as [[ok He] [E _]].
  exists y. split; [exact Hy |]. exists elemento_cambiado.
  apply Cambiar_Material_computed. split; [| split; [| reflexivity]].
  - split; [apply H | split; [now apply (Escena_eq_elementos (Vista_eq_Escena _ _ E)) |]].
    apply (Vista_eq_materiales _ _ E), (Vista_inv_4 _ ok). now exists e.
  - looks_back E. apply taken_and_given; [apply ok | exact Hy].
Qed.
(** Discharges Cambiar_Grupo.conj.1. *)
Theorem a_new_group_is_undone : @Cambiar_Grupo_conj_1 Elemento Nombre.
Proof.
  intros V V' e g r_out H [y Hy]. pose proof H as P. apply Cambiar_Grupo_computed in P as [[ok [He _]] [E _]].
  exists y. split; [exact Hy |]. exists elemento_cambiado.
  apply Cambiar_Grupo_computed. split; [| split; [| reflexivity]].
  - split; [apply H | split; [now apply (Escena_eq_elementos (Vista_eq_Escena _ _ E)) |]].
    apply (Vista_eq_grupos _ _ E), (Vista_inv_2 _ ok). now exists e.
  - looks_back E. apply overridden_back; [apply ok | exact Hy].
Qed.
(** Discharges Cambiar_Grupo.conj.2. *)
Theorem a_first_group_is_undone : @Cambiar_Grupo_conj_2 Elemento Nombre.
Proof.
  intros V V' e g r_out H N. pose proof H as P. apply Cambiar_Grupo_computed in P as [[ok [He _]] [E _]].
  exists elemento_cambiado. apply Quitar_Grupo_computed. split; [| split; [| reflexivity]].
  - split; [apply H | now apply (Escena_eq_elementos (Vista_eq_Escena _ _ E))].
  - looks_back E. now apply overridden_away.
Qed.
(** Discharges Quitar_Grupo.conj.1. *)
Theorem a_group_taken_away_is_given_back : @Quitar_Grupo_conj_1 Elemento Nombre.
Proof.
  intros V V' e r_out H [y Hy]. pose proof H as P. apply Quitar_Grupo_computed in P as [[ok He] [E _]].
  exists y. split; [exact Hy |]. exists elemento_cambiado.
  apply Cambiar_Grupo_computed. split; [| split; [| reflexivity]].
  - split; [apply H | split; [now apply (Escena_eq_elementos (Vista_eq_Escena _ _ E)) |]].
    apply (Vista_eq_grupos _ _ E), (Vista_inv_2 _ ok). now exists e.
  - looks_back E. apply taken_and_given; [apply ok | exact Hy].
Qed.
End Looks.
