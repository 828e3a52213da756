(** spec/operaciones.tex: every total operation answers every call, and keeps the invariant. *)
From Coq Require Import Reals Setoid Classical_Prop.
From Durero Require Import Toolkit Especificacion Escena Operaciones.
Local Open Scope zed_scope.

Section Totals.
Variable Elemento : Type.
Notation Escena := (Especificacion.Escena Elemento).
Implicit Types (s : Escena) (e : Elemento) (c : Punto) (d : Vector) (abc : Terna).
Notation scene_without := (scene_without Elemento).
Notation pre_Agregar_Esfera := (pre_Agregar_Esfera Elemento).
Notation pre_Agregar_Cilindro := (pre_Agregar_Cilindro Elemento).
Notation pre_Agregar_Cono := (pre_Agregar_Cono Elemento).
Notation pre_Agregar_Tronco := (pre_Agregar_Tronco Elemento).
Notation pre_Agregar_Plano := (pre_Agregar_Plano Elemento).
Notation pre_Agregar_Disco := (pre_Agregar_Disco Elemento).
Notation pre_Agregar_Triangulo := (pre_Agregar_Triangulo Elemento).
Notation pre_Eliminar := (pre_Eliminar Elemento).
Notation addition_possible := (addition_possible Elemento).
Notation scene_added := (scene_added Elemento).
Notation Elemento_Agregado_computed := (Elemento_Agregado_computed Elemento).
Notation Elemento_Eliminado_computed := (Elemento_Eliminado_computed Elemento).
Notation Xi_refl := (Xi_refl Elemento).

(** An element that cannot be added, though its name is free, lacks a value that its type asks for. *)
Lemma clause_fails s e t r d h k abc : Escena_ok s -> e ∉ elementos s -> ~ addition_possible s e t r d h k abc ->
  (r ∉ Rmas /\ Con_Radio t) \/ (k ∉ Rmas /\ Con_Proporcion t) \/ (d ∉ Unitario /\ Con_Vector t)
  \/ (h ∉ Rmas /\ Con_Altura t) \/ (abc ∉ Vertices /\ Con_Vertices t).
Proof.
  intros ok He P.
  apply NNPP; intros N; apply P.
  assert (HR : Con_Radio t -> r ∈ Rmas) by (intros C; apply NNPP; tauto).
  assert (HK : Con_Proporcion t -> k ∈ Rmas) by (intros C; apply NNPP; tauto).
  assert (HD : Con_Vector t -> d ∈ Unitario) by (intros C; apply NNPP; tauto).
  assert (HH : Con_Altura t -> h ∈ Rmas) by (intros C; apply NNPP; tauto).
  assert (HV : Con_Vertices t -> abc ∈ Vertices) by (intros C; apply NNPP; tauto).
  unfold addition_possible, Con_Radio, Con_Vector, Con_Altura, Con_Proporcion, Con_Vertices, union, single in *.
  destruct t; (split; [exact ok | split; [exact He | auto 12]]).
Qed.

(** Every total operation answers every call on a scene that satisfies the invariant.
    Discharges Elemento_Ya_Existe.pre.1, Elemento_Ya_Existe.post.1, Elemento_No_Existe.pre.1,
    Elemento_No_Existe.post.1, Radio_No_Positivo.pre.1, Radio_No_Positivo.post.1, Vector_No_Unitario.pre.1,
    Vector_No_Unitario.post.1, Altura_No_Positiva.pre.1, Altura_No_Positiva.post.1, Proporcion_No_Positiva.pre.1,
    Proporcion_No_Positiva.post.1, Vertices_Alineados.pre.1, Vertices_Alineados.post.1, No_Es_Esfera.pre.1,
    No_Es_Esfera.pre.2, No_Es_Esfera.post.1, No_Es_Cilindro.pre.1, No_Es_Cilindro.pre.2, No_Es_Cilindro.post.1,
    No_Es_Cono.pre.1, No_Es_Cono.pre.2, No_Es_Cono.post.1,
    No_Es_Tronco.pre.1, No_Es_Tronco.pre.2, No_Es_Tronco.post.1, No_Es_Plano.pre.1, No_Es_Plano.pre.2,
    No_Es_Plano.post.1, No_Es_Disco.pre.1, No_Es_Disco.pre.2, No_Es_Disco.post.1, No_Es_Triangulo.pre.1,
    No_Es_Triangulo.pre.2, No_Es_Triangulo.post.1, Con_Radio.pre.1, Con_Vector.pre.1, Con_Altura.pre.1,
    Con_Proporcion.pre.1, Con_Vertices.pre.1. *)
Theorem total_operations_are_total s e t c r d h k abc : Escena_ok s ->
  (exists s' r_out, Agregar_Esfera_Total s s' e r_out c r)
  /\ (exists s' r_out, Agregar_Cilindro_Total s s' e r_out c r d h)
  /\ (exists s' r_out, Agregar_Cono_Total s s' e r_out c k d h)
  /\ (exists s' r_out, Agregar_Tronco_Total s s' e r_out c r k d h)
  /\ (exists s' r_out, Agregar_Plano_Total s s' e r_out c d)
  /\ (exists s' r_out, Agregar_Disco_Total s s' e r_out c r d)
  /\ (exists s' r_out, Agregar_Triangulo_Total s s' e r_out abc)
  /\ (exists s' r_out, Eliminar_Esfera_Total s s' e r_out)
  /\ (exists s' r_out, Eliminar_Cilindro_Total s s' e r_out)
  /\ (exists s' r_out, Eliminar_Cono_Total s s' e r_out)
  /\ (exists s' r_out, Eliminar_Tronco_Total s s' e r_out)
  /\ (exists s' r_out, Eliminar_Plano_Total s s' e r_out)
  /\ (exists s' r_out, Eliminar_Disco_Total s s' e r_out)
  /\ (exists s' r_out, Eliminar_Triangulo_Total s s' e r_out)
  /\ (exists s' r_out, Agregar_Elemento_Total s s' e t c r d h k abc r_out)
  /\ (exists s' r_out, Eliminar_Elemento_Total s s' e r_out).
Proof.
  intros ok. pose proof (Xi_refl s ok) as X.
  assert (pe := pre_Agregar_Esfera s e soy_esfera c r). assert (pl := pre_Agregar_Cilindro s e soy_cilindro c r d h).
  assert (pk := pre_Agregar_Cono s e soy_cono c k d h). assert (pt := pre_Agregar_Tronco s e soy_tronco c r k d h).
  assert (pp := pre_Agregar_Plano s e soy_plano c d). assert (pd := pre_Agregar_Disco s e soy_disco c r d).
  assert (pv := pre_Agregar_Triangulo s e soy_triangulo abc).
  destruct (pre_Eliminar s e) as [qe [ql [qk [qt [qp [qd qv]]]]]].
  assert (Y : e ∈ elementos s -> Elemento_Ya_Existe s s e elemento_ya_existe) by now split.
  assert (NE : e ∉ elementos s -> Elemento_No_Existe s s e elemento_no_existe) by now split.
  assert (RN : r ∉ Rmas -> Radio_No_Positivo s s r radio_no_positivo) by now split.
  assert (VN : d ∉ Unitario -> Vector_No_Unitario s s d vector_no_unitario) by now split.
  assert (AN : h ∉ Rmas -> Altura_No_Positiva s s h altura_no_positiva) by now split.
  assert (PN : k ∉ Rmas -> Proporcion_No_Positiva s s k proporcion_no_positiva) by now split.
  assert (AV : abc ∉ Vertices -> Vertices_Alineados s s abc vertices_alineados) by now split.
  pose proof (classic (e ∈ elementos s)) as Ce. pose proof (classic (r ∈ Rmas)) as Cr.
  pose proof (classic (d ∈ Unitario)) as Cd. pose proof (classic (h ∈ Rmas)) as Ch.
  pose proof (classic (k ∈ Rmas)) as Ck. pose proof (classic (abc ∈ Vertices)) as Cv.
  assert (removal : forall t' (P N : Escena -> Respuesta -> Prop),
    ((exists s' r_out, P s' r_out) <-> Escena_ok s /\ (e, t') ∈ de_que_tipo s) ->
    (e ∈ elementos s -> (exists v, (e, v) ∈ de_que_tipo s /\ v <> t') -> N s tipo_incorrecto) ->
    exists s' r_out, P s' r_out \/ Elemento_No_Existe s s' e r_out \/ N s' r_out).
  { intros t' P N HP HN. destruct Ce as [He |]; [| eauto 10]. destruct (type_of_element _ _ ok e He) as [v Hv].
    destruct (classic (v = t')) as [-> | Nv]; [| eauto 10]. destruct (proj2 HP) as [s' [r_out H']]; eauto. }
  unfold Agregar_Esfera_Total, Agregar_Cilindro_Total, Agregar_Cono_Total, Agregar_Tronco_Total, Agregar_Plano_Total,
    Agregar_Disco_Total, Agregar_Triangulo_Total, Eliminar_Esfera_Total, Eliminar_Cilindro_Total, Eliminar_Cono_Total,
    Eliminar_Tronco_Total, Eliminar_Plano_Total, Eliminar_Disco_Total, Eliminar_Triangulo_Total, Eliminar_Elemento_Total.
  repeat match goal with |- _ /\ _ => split end.
  - destruct Ce; [eauto 10 |]. destruct Cr; [| eauto 10].
    destruct (proj2 pe) as [s' [r_out H']]; [auto |]. eauto 10.
  - destruct Ce; [eauto 10 |]. destruct Cr; [| eauto 10]. destruct Cd; [| eauto 10]. destruct Ch; [| eauto 10].
    destruct (proj2 pl) as [s' [r_out H']]; [auto 8 |]. eauto 10.
  - destruct Ce; [eauto 10 |]. destruct Ck; [| eauto 10]. destruct Cd; [| eauto 10]. destruct Ch; [| eauto 10].
    destruct (proj2 pk) as [s' [r_out H']]; [auto 8 |]. eauto 10.
  - destruct Ce; [eauto 10 |]. destruct Cr; [| eauto 10]. destruct Ck; [| eauto 10]. destruct Cd; [| eauto 10].
    destruct Ch; [| eauto 10]. destruct (proj2 pt) as [s' [r_out H']]; [auto 9 |]. eauto 10.
  - destruct Ce; [eauto 10 |]. destruct Cd; [| eauto 10]. destruct (proj2 pp) as [s' [r_out H']]; [auto |]. eauto 10.
  - destruct Ce; [eauto 10 |]. destruct Cr; [| eauto 10]. destruct Cd; [| eauto 10].
    destruct (proj2 pd) as [s' [r_out H']]; [auto 8 |]. eauto 10.
  - destruct Ce; [eauto 10 |]. destruct Cv; [| eauto 10]. destruct (proj2 pv) as [s' [r_out H']]; [auto |]. eauto 10.
  - apply removal with (1 := qe). now split.
  - apply removal with (1 := ql). now split.
  - apply removal with (1 := qk). now split.
  - apply removal with (1 := qt). now split.
  - apply removal with (1 := qp). now split.
  - apply removal with (1 := qd). now split.
  - apply removal with (1 := qv). now split.
  - destruct Ce; [unfold Agregar_Elemento_Total; eauto 10 |].
    destruct (classic (addition_possible s e t r d h k abc)) as [P | P].
    { exists (scene_added s e t c r d h k abc), elemento_agregado. left. apply Elemento_Agregado_computed.
      auto using Escena_eq_refl. }
    destruct (clause_fails s e t r d h k abc) as [[F T] | [[F T] | [[F T] | [[F T] | [F T]]]]]; auto.
    + exists s, radio_no_positivo. right; right; left. auto.
    + exists s, proporcion_no_positiva. right; right; right; left. auto.
    + exists s, vector_no_unitario. right; right; right; right; left. auto.
    + exists s, altura_no_positiva. do 5 right; left. auto.
    + exists s, vertices_alineados. do 6 right. auto.
  - destruct Ce as [He | He].
    + exists (scene_without s e), elemento_eliminado. left. apply Elemento_Eliminado_computed. auto using Escena_eq_refl.
    + exists s, elemento_no_existe. right. auto.
Qed.

(** The same of each by name. *)
Let origin := mk_Punto 0 0 0.
Let null := mk_Vector 0 0 0.
Let origins := mk_Terna origin origin origin.
(** Discharges Agregar_Esfera_Total.def.1, Agregar_Esfera_Total.conj.1. *)
Theorem Agregar_Esfera_Total_is_total : Agregar_Esfera_Total_conj_1 Elemento.
Proof. intros s e c r ok. apply (total_operations_are_total s e soy_esfera c r null 0%R 0%R origins ok). Qed.
(** Discharges Agregar_Cilindro_Total.def.1, Agregar_Cilindro_Total.conj.1. *)
Theorem Agregar_Cilindro_Total_is_total : Agregar_Cilindro_Total_conj_1 Elemento.
Proof. intros s e c r d h ok. apply (total_operations_are_total s e soy_esfera c r d h 0%R origins ok). Qed.
(** Discharges Agregar_Cono_Total.def.1, Agregar_Cono_Total.conj.1. *)
Theorem Agregar_Cono_Total_is_total : Agregar_Cono_Total_conj_1 Elemento.
Proof. intros s e c k d h ok. apply (total_operations_are_total s e soy_esfera c 0%R d h k origins ok). Qed.
(** Discharges Agregar_Tronco_Total.def.1, Agregar_Tronco_Total.conj.1. *)
Theorem Agregar_Tronco_Total_is_total : Agregar_Tronco_Total_conj_1 Elemento.
Proof. intros s e c r k d h ok. apply (total_operations_are_total s e soy_esfera c r d h k origins ok). Qed.
(** Discharges Agregar_Plano_Total.def.1, Agregar_Plano_Total.conj.1. *)
Theorem Agregar_Plano_Total_is_total : Agregar_Plano_Total_conj_1 Elemento.
Proof. intros s e c d ok. apply (total_operations_are_total s e soy_esfera c 0%R d 0%R 0%R origins ok). Qed.
(** Discharges Agregar_Disco_Total.def.1, Agregar_Disco_Total.conj.1. *)
Theorem Agregar_Disco_Total_is_total : Agregar_Disco_Total_conj_1 Elemento.
Proof. intros s e c r d ok. apply (total_operations_are_total s e soy_esfera c r d 0%R 0%R origins ok). Qed.
(** Discharges Agregar_Triangulo_Total.def.1, Agregar_Triangulo_Total.conj.1. *)
Theorem Agregar_Triangulo_Total_is_total : Agregar_Triangulo_Total_conj_1 Elemento.
Proof. intros s e abc ok. apply (total_operations_are_total s e soy_esfera origin 0%R null 0%R 0%R abc ok). Qed.
(** Discharges Eliminar_Esfera_Total.def.1, Eliminar_Esfera_Total.conj.1. *)
Theorem Eliminar_Esfera_Total_is_total : Eliminar_Esfera_Total_conj_1 Elemento.
Proof. intros s e ok. apply (total_operations_are_total s e soy_esfera origin 0%R null 0%R 0%R origins ok). Qed.
(** Discharges Eliminar_Cilindro_Total.def.1, Eliminar_Cilindro_Total.conj.1. *)
Theorem Eliminar_Cilindro_Total_is_total : Eliminar_Cilindro_Total_conj_1 Elemento.
Proof. intros s e ok. apply (total_operations_are_total s e soy_esfera origin 0%R null 0%R 0%R origins ok). Qed.
(** Discharges Eliminar_Cono_Total.def.1, Eliminar_Cono_Total.conj.1. *)
Theorem Eliminar_Cono_Total_is_total : Eliminar_Cono_Total_conj_1 Elemento.
Proof. intros s e ok. apply (total_operations_are_total s e soy_esfera origin 0%R null 0%R 0%R origins ok). Qed.
(** Discharges Eliminar_Tronco_Total.def.1, Eliminar_Tronco_Total.conj.1. *)
Theorem Eliminar_Tronco_Total_is_total : Eliminar_Tronco_Total_conj_1 Elemento.
Proof. intros s e ok. apply (total_operations_are_total s e soy_esfera origin 0%R null 0%R 0%R origins ok). Qed.
(** Discharges Eliminar_Plano_Total.def.1, Eliminar_Plano_Total.conj.1. *)
Theorem Eliminar_Plano_Total_is_total : Eliminar_Plano_Total_conj_1 Elemento.
Proof. intros s e ok. apply (total_operations_are_total s e soy_esfera origin 0%R null 0%R 0%R origins ok). Qed.
(** Discharges Eliminar_Disco_Total.def.1, Eliminar_Disco_Total.conj.1. *)
Theorem Eliminar_Disco_Total_is_total : Eliminar_Disco_Total_conj_1 Elemento.
Proof. intros s e ok. apply (total_operations_are_total s e soy_esfera origin 0%R null 0%R 0%R origins ok). Qed.
(** Discharges Eliminar_Triangulo_Total.def.1, Eliminar_Triangulo_Total.conj.1. *)
Theorem Eliminar_Triangulo_Total_is_total : Eliminar_Triangulo_Total_conj_1 Elemento.
Proof. intros s e ok. apply (total_operations_are_total s e soy_esfera origin 0%R null 0%R 0%R origins ok). Qed.
(** Discharges Agregar_Elemento_Total.def.1, Agregar_Elemento_Total.conj.1. *)
Theorem Agregar_Elemento_Total_is_total : Agregar_Elemento_Total_conj_1 Elemento.
Proof. intros s e t c r d h k abc ok. apply (total_operations_are_total s e t c r d h k abc ok). Qed.
(** Discharges Eliminar_Elemento_Total.def.1, Eliminar_Elemento_Total.conj.1. *)
Theorem Eliminar_Elemento_Total_is_total : Eliminar_Elemento_Total_conj_1 Elemento.
Proof. intros s e ok. apply (total_operations_are_total s e soy_esfera origin 0%R null 0%R 0%R origins ok). Qed.

(** Whatever the total operation answers, the scene after it satisfies the invariant; and it is the scene before it
    unless the answer is that the element was added. *)
Theorem total_addition_safe s s' e t c r d h k abc r_out : Agregar_Elemento_Total s s' e t c r d h k abc r_out ->
  Escena_ok s' /\ (r_out <> elemento_agregado -> Escena_eq s s').
Proof.
  assert (X : Xi_Escena s s' -> Escena_ok s' /\ (r_out <> elemento_agregado -> Escena_eq s s')).
  { intros [[_ ok'] E]. auto. }
  intros [H | [H | [[H _] | [[H _] | [[H _] | [[H _] | [H _]]]]]]]; try (now apply X, H).
  pose proof (proj2 H) as ->. split; [| easy].
  destruct H as [[r0 [H | [H | [H | [H | [H | [H | H]]]]]]] _]; apply H.
Qed.
(** The same of the total removal. *)
Theorem total_removal_safe s s' e r_out : Eliminar_Elemento_Total s s' e r_out ->
  Escena_ok s' /\ (r_out <> elemento_eliminado -> Escena_eq s s').
Proof.
  intros [H | H]; [| destruct H as [[[_ ok'] E] _ _]; auto].
  pose proof (proj2 H) as ->. split; [| easy].
  destruct H as [[r0 [H | [H | [H | [H | [H | [H | H]]]]]]] _]; apply H.
Qed.
End Totals.
