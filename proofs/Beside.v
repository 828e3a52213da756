(** spec/malla.tex: the operations of single elements in a scene with meshes are total, and leave each mesh as it is.

    grows s s'           == s' is a scene with the triangles of s
    spares e s s'        == s' is a scene with the triangles of s, but perhaps that of the name e *)
From Coq Require Import Reals Classical_Prop.
From Durero Require Import Toolkit Especificacion Escena Totals Malla Meshes MeshClaims.
Local Open Scope zed_scope.

Section Beside.
Variable Elemento : Type.
Notation Escena := (Especificacion.Escena Elemento).
Variable nombre_cara : rel (Elemento * nat) Elemento.
Notation Mallas := (Malla.Mallas Elemento).
Notation Mallas_ok := (Malla.Mallas_ok Elemento nombre_cara).
Notation escena := (Malla.escena Elemento).
Notation mallas := (Malla.mallas Elemento).
Notation de_malla := (Malla.de_malla Elemento nombre_cara).
Implicit Types (s : Escena) (S : Mallas) (e : Elemento).

Definition spares e s s' : Prop :=
  Escena_ok s' /\ forall p, mi_vertices s p -> fst p <> e -> mi_vertices s' p.
Definition grows s s' : Prop := Escena_ok s' /\ mi_vertices s ⊆ mi_vertices s'.

Lemma grows_Xi s s' : Xi_Escena s s' -> grows s s'.
Proof. intros [[_ ok'] E]. split; [exact ok' |]. intros p Hp. now apply (Escena_eq_mi_vertices E). Qed.
Lemma spares_Xi e s s' : Xi_Escena s s' -> spares e s s'.
Proof. intros [[_ ok'] E]. split; [exact ok' |]. intros p Hp _. now apply (Escena_eq_mi_vertices E). Qed.

(** What an addition and a removal say of the vertices. *)
Ltac vertices_grow P := split; [apply P | intros p Hp; apply P; first [exact Hp | now left]].
Ltac vertices_stay P := split; [apply P | intros p Hp Ne; apply P; first [exact Hp | now split]].

Lemma Agregar_Esfera_grows s s' e t r_out c rad : Agregar_Esfera s s' e t r_out c rad -> grows s s'.
Proof. intros H. vertices_grow H. Qed.
Lemma Agregar_Cilindro_grows s s' e t r_out c rad d h : Agregar_Cilindro s s' e t r_out c rad d h -> grows s s'.
Proof. intros H. vertices_grow H. Qed.
Lemma Agregar_Cono_grows s s' e t r_out c k d h : Agregar_Cono s s' e t r_out c k d h -> grows s s'.
Proof. intros H. vertices_grow H. Qed.
Lemma Agregar_Tronco_grows s s' e t r_out c rad k d h : Agregar_Tronco s s' e t r_out c rad k d h -> grows s s'.
Proof. intros H. vertices_grow H. Qed.
Lemma Agregar_Plano_grows s s' e t r_out c d : Agregar_Plano s s' e t r_out c d -> grows s s'.
Proof. intros H. vertices_grow H. Qed.
Lemma Agregar_Disco_grows s s' e t r_out c rad d : Agregar_Disco s s' e t r_out c rad d -> grows s s'.
Proof. intros H. vertices_grow H. Qed.
Lemma Agregar_Triangulo_grows s s' e t r_out abc : Agregar_Triangulo s s' e t r_out abc -> grows s s'.
Proof. intros H. vertices_grow H. Qed.
Lemma Eliminar_Esfera_spares s s' e r_out : Eliminar_Esfera s s' e r_out -> spares e s s'.
Proof. intros H. vertices_stay H. Qed.
Lemma Eliminar_Cilindro_spares s s' e r_out : Eliminar_Cilindro s s' e r_out -> spares e s s'.
Proof. intros H. vertices_stay H. Qed.
Lemma Eliminar_Cono_spares s s' e r_out : Eliminar_Cono s s' e r_out -> spares e s s'.
Proof. intros H. vertices_stay H. Qed.
Lemma Eliminar_Tronco_spares s s' e r_out : Eliminar_Tronco s s' e r_out -> spares e s s'.
Proof. intros H. vertices_stay H. Qed.
Lemma Eliminar_Plano_spares s s' e r_out : Eliminar_Plano s s' e r_out -> spares e s s'.
Proof. intros H. vertices_stay H. Qed.
Lemma Eliminar_Disco_spares s s' e r_out : Eliminar_Disco s s' e r_out -> spares e s s'.
Proof. intros H. vertices_stay H. Qed.
Lemma Eliminar_Triangulo_spares s s' e r_out : Eliminar_Triangulo s s' e r_out -> spares e s s'.
Proof. intros H. vertices_stay H. Qed.

(** A total operation that spares the triangles of the meshes can happen beside them. *)
Lemma beside_meshes S (X : Escena -> Respuesta -> Prop) : Mallas_ok S -> (exists s' r_out, X s' r_out) ->
  (forall s' r_out, X s' r_out -> Escena_ok s' /\ forall m r, (m, r) ∈ mallas S ->
    Malla.familia Elemento nombre_cara m r ⊆ mi_vertices s') ->
  exists S' r_out, X (escena S') r_out /\ Mismas_Mallas Elemento nombre_cara S S'.
Proof.
  intros ok [s' [r_out H]] Keep. destruct (Keep s' r_out H) as [ok' K]. exists (mk_Mallas _ s' (mallas S)), r_out.
  split; [exact H |]. split; [exact ok | | reflexivity]. split; cbn; [exact ok' | apply ok | apply ok | | exact K].
  apply (Mallas_inv_1 _ _ _ ok).
Qed.
Lemma addition_beside_meshes S (X : Escena -> Respuesta -> Prop) : Mallas_ok S -> (exists s' r_out, X s' r_out) ->
  (forall s' r_out, X s' r_out -> grows (escena S) s') ->
  exists S' r_out, X (escena S') r_out /\ Mismas_Mallas Elemento nombre_cara S S'.
Proof.
  intros ok Can Keep. apply beside_meshes; [exact ok | exact Can |]. intros s' r_out H.
  destruct (Keep s' r_out H) as [ok' K]. split; [exact ok' |]. intros m r Hr p Hp. now apply K, (Mallas_inv_2 _ _ _ ok m r Hr).
Qed.
Lemma removal_beside_meshes S e (X : Escena -> Respuesta -> Prop) : Mallas_ok S -> (exists s' r_out, X s' r_out) ->
  (forall s' r_out, X s' r_out -> spares e (escena S) s') ->
  exists S' r_out, (X (escena S') r_out /\ Mismas_Mallas Elemento nombre_cara S S'
    /\ Fuera_De_Malla Elemento nombre_cara S e) \/ Es_De_Malla Elemento nombre_cara S S' e r_out.
Proof.
  intros ok Can Keep. destruct (classic (e ∈ de_malla S)) as [In | Out].
  - exists S, es_de_malla. right. split; [now apply Xi_Mallas_refl | exact In | reflexivity].
  - destruct (beside_meshes S X ok Can) as [S' [r_out [H M]]].
    + intros s' r_out H. destruct (Keep s' r_out H) as [ok' K]. split; [exact ok' |]. intros m r Hr [u t] Hp. apply K.
      * now apply (Mallas_inv_2 _ _ _ ok m r Hr).
      * cbn. intros ->. apply Out. exists m. split; [now exists r | exists r; split; [exact Hr | now exists t]].
    + exists S', r_out. left. split; [exact H | split; [exact M | now split]].
Qed.

(** Discharges Mismas_Mallas.post.1, Agregar_Esfera_Mallas.def.1, Agregar_Esfera_Mallas.conj.1. *)
Theorem Agregar_Esfera_Mallas_is_total : Agregar_Esfera_Mallas_conj_1 Elemento nombre_cara.
Proof.
  intros S e c rad ok.
  apply (addition_beside_meshes S (fun s' r_out => Agregar_Esfera_Total (escena S) s' e r_out c rad) ok);
    [now apply Agregar_Esfera_Total_is_total, ok |].
  intros s' r_out [[t H] | H]; [exact (Agregar_Esfera_grows _ _ _ _ _ _ _ H) |].
  apply grows_Xi. repeat destruct H as [H | H]; apply H.
Qed.
(** Discharges Agregar_Cilindro_Mallas.def.1, Agregar_Cilindro_Mallas.conj.1. *)
Theorem Agregar_Cilindro_Mallas_is_total : Agregar_Cilindro_Mallas_conj_1 Elemento nombre_cara.
Proof.
  intros S e c rad d h ok.
  apply (addition_beside_meshes S (fun s' r_out => Agregar_Cilindro_Total (escena S) s' e r_out c rad d h) ok);
    [now apply Agregar_Cilindro_Total_is_total, ok |].
  intros s' r_out [[t H] | H]; [exact (Agregar_Cilindro_grows _ _ _ _ _ _ _ _ _ H) |].
  apply grows_Xi. repeat destruct H as [H | H]; apply H.
Qed.
(** Discharges Agregar_Cono_Mallas.def.1, Agregar_Cono_Mallas.conj.1. *)
Theorem Agregar_Cono_Mallas_is_total : Agregar_Cono_Mallas_conj_1 Elemento nombre_cara.
Proof.
  intros S e c k d h ok.
  apply (addition_beside_meshes S (fun s' r_out => Agregar_Cono_Total (escena S) s' e r_out c k d h) ok);
    [now apply Agregar_Cono_Total_is_total, ok |].
  intros s' r_out [[t H] | H]; [exact (Agregar_Cono_grows _ _ _ _ _ _ _ _ _ H) |].
  apply grows_Xi. repeat destruct H as [H | H]; apply H.
Qed.
(** Discharges Agregar_Tronco_Mallas.def.1, Agregar_Tronco_Mallas.conj.1. *)
Theorem Agregar_Tronco_Mallas_is_total : Agregar_Tronco_Mallas_conj_1 Elemento nombre_cara.
Proof.
  intros S e c rad k d h ok.
  apply (addition_beside_meshes S (fun s' r_out => Agregar_Tronco_Total (escena S) s' e r_out c rad k d h) ok);
    [now apply Agregar_Tronco_Total_is_total, ok |].
  intros s' r_out [[t H] | H]; [exact (Agregar_Tronco_grows _ _ _ _ _ _ _ _ _ _ H) |].
  apply grows_Xi. repeat destruct H as [H | H]; apply H.
Qed.
(** Discharges Agregar_Plano_Mallas.def.1, Agregar_Plano_Mallas.conj.1. *)
Theorem Agregar_Plano_Mallas_is_total : Agregar_Plano_Mallas_conj_1 Elemento nombre_cara.
Proof.
  intros S e c d ok.
  apply (addition_beside_meshes S (fun s' r_out => Agregar_Plano_Total (escena S) s' e r_out c d) ok);
    [now apply Agregar_Plano_Total_is_total, ok |].
  intros s' r_out [[t H] | H]; [exact (Agregar_Plano_grows _ _ _ _ _ _ _ H) |].
  apply grows_Xi. repeat destruct H as [H | H]; apply H.
Qed.
(** Discharges Agregar_Disco_Mallas.def.1, Agregar_Disco_Mallas.conj.1. *)
Theorem Agregar_Disco_Mallas_is_total : Agregar_Disco_Mallas_conj_1 Elemento nombre_cara.
Proof.
  intros S e c rad d ok.
  apply (addition_beside_meshes S (fun s' r_out => Agregar_Disco_Total (escena S) s' e r_out c rad d) ok);
    [now apply Agregar_Disco_Total_is_total, ok |].
  intros s' r_out [[t H] | H]; [exact (Agregar_Disco_grows _ _ _ _ _ _ _ _ H) |].
  apply grows_Xi. repeat destruct H as [H | H]; apply H.
Qed.
(** Discharges Agregar_Triangulo_Mallas.def.1, Agregar_Triangulo_Mallas.conj.1. *)
Theorem Agregar_Triangulo_Mallas_is_total : Agregar_Triangulo_Mallas_conj_1 Elemento nombre_cara.
Proof.
  intros S e abc ok.
  apply (addition_beside_meshes S (fun s' r_out => Agregar_Triangulo_Total (escena S) s' e r_out abc) ok);
    [now apply Agregar_Triangulo_Total_is_total, ok |].
  intros s' r_out [[t H] | H]; [exact (Agregar_Triangulo_grows _ _ _ _ _ _ H) |].
  apply grows_Xi. repeat destruct H as [H | H]; apply H.
Qed.
(** Discharges Agregar_Elemento_Mallas.def.1, Agregar_Elemento_Mallas.conj.1. *)
Theorem Agregar_Elemento_Mallas_is_total : Agregar_Elemento_Mallas_conj_1 Elemento nombre_cara.
Proof.
  intros S e t c rad d h k abc ok.
  apply (addition_beside_meshes S (fun s' => Agregar_Elemento_Total (escena S) s' e t c rad d h k abc) ok);
    [now apply Agregar_Elemento_Total_is_total, ok |].
  intros s' r_out [[[r0 H] _] | H].
  - destruct H as [H | [H | [H | [H | [H | [H | H]]]]]];
      [apply Agregar_Esfera_grows in H | apply Agregar_Cilindro_grows in H | apply Agregar_Cono_grows in H
      | apply Agregar_Tronco_grows in H | apply Agregar_Plano_grows in H | apply Agregar_Disco_grows in H
      | apply Agregar_Triangulo_grows in H]; exact H.
  - apply grows_Xi. destruct H as [H | [[H _] | [[H _] | [[H _] | [[H _] | [H _]]]]]]; apply H.
Qed.

(** Discharges Fuera_De_Malla.pre.1, Es_De_Malla.pre.1, Es_De_Malla.post.1,
    Eliminar_Esfera_Mallas.def.1, Eliminar_Esfera_Mallas.conj.1. *)
Theorem Eliminar_Esfera_Mallas_is_total : Eliminar_Esfera_Mallas_conj_1 Elemento nombre_cara.
Proof.
  intros S e ok. apply (removal_beside_meshes S e (fun s' => Eliminar_Esfera_Total (escena S) s' e) ok).
  - now apply Eliminar_Esfera_Total_is_total, ok.
  - intros s' r_out [H | H]; [exact (Eliminar_Esfera_spares _ _ _ _ H) |].
    apply spares_Xi. destruct H as [H | H]; apply H.
Qed.
(** Discharges Eliminar_Cilindro_Mallas.def.1, Eliminar_Cilindro_Mallas.conj.1. *)
Theorem Eliminar_Cilindro_Mallas_is_total : Eliminar_Cilindro_Mallas_conj_1 Elemento nombre_cara.
Proof.
  intros S e ok. apply (removal_beside_meshes S e (fun s' => Eliminar_Cilindro_Total (escena S) s' e) ok).
  - now apply Eliminar_Cilindro_Total_is_total, ok.
  - intros s' r_out [H | H]; [exact (Eliminar_Cilindro_spares _ _ _ _ H) |].
    apply spares_Xi. destruct H as [H | H]; apply H.
Qed.
(** Discharges Eliminar_Cono_Mallas.def.1, Eliminar_Cono_Mallas.conj.1. *)
Theorem Eliminar_Cono_Mallas_is_total : Eliminar_Cono_Mallas_conj_1 Elemento nombre_cara.
Proof.
  intros S e ok. apply (removal_beside_meshes S e (fun s' => Eliminar_Cono_Total (escena S) s' e) ok).
  - now apply Eliminar_Cono_Total_is_total, ok.
  - intros s' r_out [H | H]; [exact (Eliminar_Cono_spares _ _ _ _ H) |].
    apply spares_Xi. destruct H as [H | H]; apply H.
Qed.
(** Discharges Eliminar_Tronco_Mallas.def.1, Eliminar_Tronco_Mallas.conj.1. *)
Theorem Eliminar_Tronco_Mallas_is_total : Eliminar_Tronco_Mallas_conj_1 Elemento nombre_cara.
Proof.
  intros S e ok. apply (removal_beside_meshes S e (fun s' => Eliminar_Tronco_Total (escena S) s' e) ok).
  - now apply Eliminar_Tronco_Total_is_total, ok.
  - intros s' r_out [H | H]; [exact (Eliminar_Tronco_spares _ _ _ _ H) |].
    apply spares_Xi. destruct H as [H | H]; apply H.
Qed.
(** Discharges Eliminar_Plano_Mallas.def.1, Eliminar_Plano_Mallas.conj.1. *)
Theorem Eliminar_Plano_Mallas_is_total : Eliminar_Plano_Mallas_conj_1 Elemento nombre_cara.
Proof.
  intros S e ok. apply (removal_beside_meshes S e (fun s' => Eliminar_Plano_Total (escena S) s' e) ok).
  - now apply Eliminar_Plano_Total_is_total, ok.
  - intros s' r_out [H | H]; [exact (Eliminar_Plano_spares _ _ _ _ H) |].
    apply spares_Xi. destruct H as [H | H]; apply H.
Qed.
(** Discharges Eliminar_Disco_Mallas.def.1, Eliminar_Disco_Mallas.conj.1. *)
Theorem Eliminar_Disco_Mallas_is_total : Eliminar_Disco_Mallas_conj_1 Elemento nombre_cara.
Proof.
  intros S e ok. apply (removal_beside_meshes S e (fun s' => Eliminar_Disco_Total (escena S) s' e) ok).
  - now apply Eliminar_Disco_Total_is_total, ok.
  - intros s' r_out [H | H]; [exact (Eliminar_Disco_spares _ _ _ _ H) |].
    apply spares_Xi. destruct H as [H | H]; apply H.
Qed.
(** Discharges Eliminar_Triangulo_Mallas.def.1, Eliminar_Triangulo_Mallas.conj.1. *)
Theorem Eliminar_Triangulo_Mallas_is_total : Eliminar_Triangulo_Mallas_conj_1 Elemento nombre_cara.
Proof.
  intros S e ok. apply (removal_beside_meshes S e (fun s' => Eliminar_Triangulo_Total (escena S) s' e) ok).
  - now apply Eliminar_Triangulo_Total_is_total, ok.
  - intros s' r_out [H | H]; [exact (Eliminar_Triangulo_spares _ _ _ _ H) |].
    apply spares_Xi. destruct H as [H | H]; apply H.
Qed.
(** Discharges Eliminar_Elemento_Mallas.def.1, Eliminar_Elemento_Mallas.conj.1. *)
Theorem Eliminar_Elemento_Mallas_is_total : Eliminar_Elemento_Mallas_conj_1 Elemento nombre_cara.
Proof.
  intros S e ok. apply (removal_beside_meshes S e (fun s' => Eliminar_Elemento_Total (escena S) s' e) ok).
  - now apply Eliminar_Elemento_Total_is_total, ok.
  - intros s' r_out [[[r0 H] _] | H]; [| apply spares_Xi, H].
    destruct H as [H | [H | [H | [H | [H | [H | H]]]]]];
      [apply Eliminar_Esfera_spares in H | apply Eliminar_Cilindro_spares in H | apply Eliminar_Cono_spares in H
      | apply Eliminar_Tronco_spares in H | apply Eliminar_Plano_spares in H | apply Eliminar_Disco_spares in H
      | apply Eliminar_Triangulo_spares in H]; exact H.
Qed.
End Beside.
