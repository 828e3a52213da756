(** spec/tablas.tex: the total operations on the tables refine those of a scene. What is refused of a scene is
    refused of
    its tables, with the same answer, and the other way round. *)
From Coq Require Import Reals.
From Durero Require Import Toolkit Especificacion Escena Operaciones Totals Tablas RowsAdded RowsRemoved TotalRows.
Local Open Scope zed_scope.

Section RowsRefused.
Context {Elemento : Type}.
Notation Escena := (Especificacion.Escena Elemento).
Notation Tablas := (Tablas Elemento).
Implicit Types (s : Escena) (e : Elemento) (T : Tablas).

Lemma tables_stay T : Tablas_ok T -> Xi_Tablas T T.
Proof. intros ok. split; [exact ok | exact ok | split; reflexivity]. Qed.
Lemma tables_have_a_scene T : Tablas_ok T -> exists s, Retrieve s T /\ Escena_ok s.
Proof.
  intros ok. destruct (tables_stand_for_one_scene T ok) as [s [R _]]. exists s. split; [exact R | apply R].
Qed.
Lemma the_scene_stays s T T' : Retrieve s T -> Xi_Tablas T T' -> exists s', Retrieve s' T' /\ Xi_Escena s s'.
Proof.
  intros R [_ ok' E]. destruct (tables_stand_for_one_scene T' ok') as [s' [R' _]]. exists s'. split; [exact R' |].
  exact (tables_that_stay_stand_for_a_scene_that_stays s T s' T' R R' E).
Qed.

(** ** What is refused of a scene is refused of its tables, with the same answer, and the other way round *)

Ltac refused_too := let R := fresh "R" in let P := fresh "P" in
  intros ? ? ? ? ? R [_ P ->]; split; [apply tables_stay, R | split; [| reflexivity]];
  first [exact P | apply (the_index_knows_the_elements _ _ R); exact P
    | (let N := fresh "N" in intros N; apply P, (the_index_knows_the_elements _ _ R); exact N)].
Ltac refused_of_the_scene :=
  let R := fresh "R" in let X := fresh "X" in let P := fresh "P" in let s' := fresh "after" in
  let R' := fresh "after" in let Y := fresh "Y" in
  intros ? ? ? ? ? R [X [P ->]]; destruct (the_scene_stays _ _ _ R X) as [s' [R' Y]]; exists s'; split; [exact R' |];
  split; [exact Y | | reflexivity];
  first [exact P | apply (the_index_knows_the_elements _ _ R); exact P
    | (let N := fresh "N" in intros N; apply P, (the_index_knows_the_elements _ _ R); exact N)].

Lemma Elemento_Ya_Existe_too s s' T e r_out : Retrieve s T -> Elemento_Ya_Existe s s' e r_out ->
  Elemento_Ya_Existe_Tablas T T e r_out.
Proof. revert s s' T e r_out. refused_too. Qed.
(** Discharges Elemento_Ya_Existe_Tablas.def.1. *)
Lemma Elemento_Ya_Existe_of_scene s T T' e r_out : Retrieve s T -> Elemento_Ya_Existe_Tablas T T' e r_out ->
  exists s', Retrieve s' T' /\ Elemento_Ya_Existe s s' e r_out.
Proof. revert s T T' e r_out. refused_of_the_scene. Qed.
Lemma Elemento_No_Existe_too s s' T e r_out : Retrieve s T -> Elemento_No_Existe s s' e r_out ->
  Elemento_No_Existe_Tablas T T e r_out.
Proof. revert s s' T e r_out. refused_too. Qed.
(** Discharges Elemento_No_Existe_Tablas.def.1. *)
Lemma Elemento_No_Existe_of_scene s T T' e r_out : Retrieve s T -> Elemento_No_Existe_Tablas T T' e r_out ->
  exists s', Retrieve s' T' /\ Elemento_No_Existe s s' e r_out.
Proof. revert s T T' e r_out. refused_of_the_scene. Qed.
Lemma Radio_No_Positivo_too s s' T r r_out : Retrieve s T -> Radio_No_Positivo s s' r r_out ->
  Radio_No_Positivo_Tablas T T r r_out.
Proof. revert s s' T r r_out. refused_too. Qed.
(** Discharges Radio_No_Positivo_Tablas.def.1. *)
Lemma Radio_No_Positivo_of_scene s T T' r r_out : Retrieve s T -> Radio_No_Positivo_Tablas T T' r r_out ->
  exists s', Retrieve s' T' /\ Radio_No_Positivo s s' r r_out.
Proof. revert s T T' r r_out. refused_of_the_scene. Qed.
Lemma Vector_No_Unitario_too s s' T d r_out : Retrieve s T -> Vector_No_Unitario s s' d r_out ->
  Vector_No_Unitario_Tablas T T d r_out.
Proof. revert s s' T d r_out. refused_too. Qed.
(** Discharges Vector_No_Unitario_Tablas.def.1. *)
Lemma Vector_No_Unitario_of_scene s T T' d r_out : Retrieve s T -> Vector_No_Unitario_Tablas T T' d r_out ->
  exists s', Retrieve s' T' /\ Vector_No_Unitario s s' d r_out.
Proof. revert s T T' d r_out. refused_of_the_scene. Qed.
Lemma Altura_No_Positiva_too s s' T h r_out : Retrieve s T -> Altura_No_Positiva s s' h r_out ->
  Altura_No_Positiva_Tablas T T h r_out.
Proof. revert s s' T h r_out. refused_too. Qed.
(** Discharges Altura_No_Positiva_Tablas.def.1. *)
Lemma Altura_No_Positiva_of_scene s T T' h r_out : Retrieve s T -> Altura_No_Positiva_Tablas T T' h r_out ->
  exists s', Retrieve s' T' /\ Altura_No_Positiva s s' h r_out.
Proof. revert s T T' h r_out. refused_of_the_scene. Qed.
Lemma Proporcion_No_Positiva_too s s' T k r_out : Retrieve s T -> Proporcion_No_Positiva s s' k r_out ->
  Proporcion_No_Positiva_Tablas T T k r_out.
Proof. revert s s' T k r_out. refused_too. Qed.
(** Discharges Proporcion_No_Positiva_Tablas.def.1. *)
Lemma Proporcion_No_Positiva_of_scene s T T' k r_out : Retrieve s T -> Proporcion_No_Positiva_Tablas T T' k r_out ->
  exists s', Retrieve s' T' /\ Proporcion_No_Positiva s s' k r_out.
Proof. revert s T T' k r_out. refused_of_the_scene. Qed.
Lemma Vertices_Alineados_too s s' T abc r_out : Retrieve s T -> Vertices_Alineados s s' abc r_out ->
  Vertices_Alineados_Tablas T T abc r_out.
Proof. revert s s' T abc r_out. refused_too. Qed.
(** Discharges Vertices_Alineados_Tablas.def.1. *)
Lemma Vertices_Alineados_of_scene s T T' abc r_out : Retrieve s T -> Vertices_Alineados_Tablas T T' abc r_out ->
  exists s', Retrieve s' T' /\ Vertices_Alineados s s' abc r_out.
Proof. revert s T T' abc r_out. refused_of_the_scene. Qed.
Lemma other_type_too s T e t : Retrieve s T -> e ∈ elementos s -> (exists u, (e, u) ∈ de_que_tipo s /\ u <> t) ->
  De_Otra_Tabla T T e t tipo_incorrecto.
Proof.
  intros R P [u [H N]]. split; [apply tables_stay, R | split; [| split; [| reflexivity]]].
  - now apply (the_index_knows_the_elements _ _ R).
  - apply (type_is_table _ _ _ _ R) in H as [p [H <-]]. now exists p.
Qed.
(** Discharges De_Otra_Tabla.def.1. *)
Lemma other_type_of_scene s T T' e t r_out : Retrieve s T -> De_Otra_Tabla T T' e t r_out ->
  exists s', Retrieve s' T' /\ Xi_Escena s s' /\ e ∈ elementos s /\ (exists u, (e, u) ∈ de_que_tipo s /\ u <> t)
    /\ r_out = tipo_incorrecto.
Proof.
  intros R [X [P [[p [H N]] ->]]]. destruct (the_scene_stays _ _ _ R X) as [s' [R' Y]]. exists s'.
  split; [exact R' | split; [exact Y | split; [now apply (the_index_knows_the_elements _ _ R) |]]].
  split; [| reflexivity]. exists (tabla p). split; [| exact N]. apply (type_is_table _ _ _ _ R). now exists p.
Qed.

(** ** The total operations *)

(** Discharges Agregar_Esfera_Total_Tablas.conj.1. *)
Theorem Agregar_Esfera_Total_Tablas_applicable : @Agregar_Esfera_Total_Tablas_conj_1 Elemento.
Proof.
  intros T e c r ok. destruct (tables_have_a_scene T ok) as [s [R oks]].
  destruct (Agregar_Esfera_Total_is_total Elemento s e c r oks) as [s' [r_out [[t H] | [H | H]]]].
  - destruct (Agregar_Esfera_Tablas_applicable s T e t c r R) as [T' [r' H']]; [now exists s', r_out |].
    exists T', r'. left. now exists t.
  - exists T, r_out. right; left. exact (Elemento_Ya_Existe_too _ _ _ _ _ R H).
  - exists T, r_out. do 2 right. exact (Radio_No_Positivo_too _ _ _ _ _ R H).
Qed.
(** Discharges Agregar_Esfera_Total_Tablas.def.1, Agregar_Esfera_Total_Tablas.conj.2. *)
Theorem Agregar_Esfera_Total_Tablas_correct : @Agregar_Esfera_Total_Tablas_conj_2 Elemento.
Proof.
  intros s T T' e r_out c r R [[t H] | [H | H]].
  - destruct (Agregar_Esfera_Tablas_correct s T T' e t r_out c r R H) as [s' [R' A]]. exists s'.
    split; [exact R' | left; now exists t].
  - apply (Elemento_Ya_Existe_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | right; left; exact A].
  - apply (Radio_No_Positivo_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 2 right; exact A].
Qed.
(** Discharges Agregar_Cilindro_Total_Tablas.conj.1. *)
Theorem Agregar_Cilindro_Total_Tablas_applicable : @Agregar_Cilindro_Total_Tablas_conj_1 Elemento.
Proof.
  intros T e c r d h ok. destruct (tables_have_a_scene T ok) as [s [R oks]].
  destruct (Agregar_Cilindro_Total_is_total Elemento s e c r d h oks) as [s' [r_out [[t H] | [H | [H | [H | H]]]]]].
  - destruct (Agregar_Cilindro_Tablas_applicable s T e t c r d h R) as [T' [r' H']]; [now exists s', r_out |].
    exists T', r'. left. now exists t.
  - exists T, r_out. right; left. exact (Elemento_Ya_Existe_too _ _ _ _ _ R H).
  - exists T, r_out. do 2 right; left. exact (Radio_No_Positivo_too _ _ _ _ _ R H).
  - exists T, r_out. do 3 right; left. exact (Vector_No_Unitario_too _ _ _ _ _ R H).
  - exists T, r_out. do 4 right. exact (Altura_No_Positiva_too _ _ _ _ _ R H).
Qed.
(** Discharges Agregar_Cilindro_Total_Tablas.def.1, Agregar_Cilindro_Total_Tablas.conj.2. *)
Theorem Agregar_Cilindro_Total_Tablas_correct : @Agregar_Cilindro_Total_Tablas_conj_2 Elemento.
Proof.
  intros s T T' e r_out c r d h R [[t H] | [H | [H | [H | H]]]].
  - destruct (Agregar_Cilindro_Tablas_correct s T T' e t r_out c r d h R H) as [s' [R' A]]. exists s'.
    split; [exact R' | left; now exists t].
  - apply (Elemento_Ya_Existe_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | right; left; exact A].
  - apply (Radio_No_Positivo_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 2 right; left; exact A].
  - apply (Vector_No_Unitario_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 3 right; left; exact A].
  - apply (Altura_No_Positiva_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 4 right; exact A].
Qed.
(** Discharges Agregar_Cono_Total_Tablas.conj.1. *)
Theorem Agregar_Cono_Total_Tablas_applicable : @Agregar_Cono_Total_Tablas_conj_1 Elemento.
Proof.
  intros T e c k d h ok. destruct (tables_have_a_scene T ok) as [s [R oks]].
  destruct (Agregar_Cono_Total_is_total Elemento s e c k d h oks) as [s' [r_out [[t H] | [H | [H | [H | H]]]]]].
  - destruct (Agregar_Cono_Tablas_applicable s T e t c k d h R) as [T' [r' H']]; [now exists s', r_out |].
    exists T', r'. left. now exists t.
  - exists T, r_out. right; left. exact (Elemento_Ya_Existe_too _ _ _ _ _ R H).
  - exists T, r_out. do 2 right; left. exact (Proporcion_No_Positiva_too _ _ _ _ _ R H).
  - exists T, r_out. do 3 right; left. exact (Vector_No_Unitario_too _ _ _ _ _ R H).
  - exists T, r_out. do 4 right. exact (Altura_No_Positiva_too _ _ _ _ _ R H).
Qed.
(** Discharges Agregar_Cono_Total_Tablas.def.1, Agregar_Cono_Total_Tablas.conj.2. *)
Theorem Agregar_Cono_Total_Tablas_correct : @Agregar_Cono_Total_Tablas_conj_2 Elemento.
Proof.
  intros s T T' e r_out c k d h R [[t H] | [H | [H | [H | H]]]].
  - destruct (Agregar_Cono_Tablas_correct s T T' e t r_out c k d h R H) as [s' [R' A]]. exists s'.
    split; [exact R' | left; now exists t].
  - apply (Elemento_Ya_Existe_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | right; left; exact A].
  - apply (Proporcion_No_Positiva_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 2 right; left; exact A].
  - apply (Vector_No_Unitario_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 3 right; left; exact A].
  - apply (Altura_No_Positiva_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 4 right; exact A].
Qed.
(** Discharges Agregar_Tronco_Total_Tablas.conj.1. *)
Theorem Agregar_Tronco_Total_Tablas_applicable : @Agregar_Tronco_Total_Tablas_conj_1 Elemento.
Proof.
  intros T e c r k d h ok. destruct (tables_have_a_scene T ok) as [s [R oks]].
  destruct (Agregar_Tronco_Total_is_total Elemento s e c r k d h oks) as [s' [r_out [[t H] | [H | [H | [H | [H |
  H]]]]]]].
  - destruct (Agregar_Tronco_Tablas_applicable s T e t c r k d h R) as [T' [r' H']]; [now exists s', r_out |].
    exists T', r'. left. now exists t.
  - exists T, r_out. right; left. exact (Elemento_Ya_Existe_too _ _ _ _ _ R H).
  - exists T, r_out. do 2 right; left. exact (Radio_No_Positivo_too _ _ _ _ _ R H).
  - exists T, r_out. do 3 right; left. exact (Proporcion_No_Positiva_too _ _ _ _ _ R H).
  - exists T, r_out. do 4 right; left. exact (Vector_No_Unitario_too _ _ _ _ _ R H).
  - exists T, r_out. do 5 right. exact (Altura_No_Positiva_too _ _ _ _ _ R H).
Qed.
(** Discharges Agregar_Tronco_Total_Tablas.def.1, Agregar_Tronco_Total_Tablas.conj.2. *)
Theorem Agregar_Tronco_Total_Tablas_correct : @Agregar_Tronco_Total_Tablas_conj_2 Elemento.
Proof.
  intros s T T' e r_out c r k d h R [[t H] | [H | [H | [H | [H | H]]]]].
  - destruct (Agregar_Tronco_Tablas_correct s T T' e t r_out c r k d h R H) as [s' [R' A]]. exists s'.
    split; [exact R' | left; now exists t].
  - apply (Elemento_Ya_Existe_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | right; left; exact A].
  - apply (Radio_No_Positivo_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 2 right; left; exact A].
  - apply (Proporcion_No_Positiva_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 3 right; left; exact A].
  - apply (Vector_No_Unitario_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 4 right; left; exact A].
  - apply (Altura_No_Positiva_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 5 right; exact A].
Qed.
(** Discharges Agregar_Plano_Total_Tablas.conj.1. *)
Theorem Agregar_Plano_Total_Tablas_applicable : @Agregar_Plano_Total_Tablas_conj_1 Elemento.
Proof.
  intros T e c d ok. destruct (tables_have_a_scene T ok) as [s [R oks]].
  destruct (Agregar_Plano_Total_is_total Elemento s e c d oks) as [s' [r_out [[t H] | [H | H]]]].
  - destruct (Agregar_Plano_Tablas_applicable s T e t c d R) as [T' [r' H']]; [now exists s', r_out |].
    exists T', r'. left. now exists t.
  - exists T, r_out. right; left. exact (Elemento_Ya_Existe_too _ _ _ _ _ R H).
  - exists T, r_out. do 2 right. exact (Vector_No_Unitario_too _ _ _ _ _ R H).
Qed.
(** Discharges Agregar_Plano_Total_Tablas.def.1, Agregar_Plano_Total_Tablas.conj.2. *)
Theorem Agregar_Plano_Total_Tablas_correct : @Agregar_Plano_Total_Tablas_conj_2 Elemento.
Proof.
  intros s T T' e r_out c d R [[t H] | [H | H]].
  - destruct (Agregar_Plano_Tablas_correct s T T' e t r_out c d R H) as [s' [R' A]]. exists s'.
    split; [exact R' | left; now exists t].
  - apply (Elemento_Ya_Existe_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | right; left; exact A].
  - apply (Vector_No_Unitario_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 2 right; exact A].
Qed.
(** Discharges Agregar_Disco_Total_Tablas.conj.1. *)
Theorem Agregar_Disco_Total_Tablas_applicable : @Agregar_Disco_Total_Tablas_conj_1 Elemento.
Proof.
  intros T e c r d ok. destruct (tables_have_a_scene T ok) as [s [R oks]].
  destruct (Agregar_Disco_Total_is_total Elemento s e c r d oks) as [s' [r_out [[t H] | [H | [H | H]]]]].
  - destruct (Agregar_Disco_Tablas_applicable s T e t c r d R) as [T' [r' H']]; [now exists s', r_out |].
    exists T', r'. left. now exists t.
  - exists T, r_out. right; left. exact (Elemento_Ya_Existe_too _ _ _ _ _ R H).
  - exists T, r_out. do 2 right; left. exact (Radio_No_Positivo_too _ _ _ _ _ R H).
  - exists T, r_out. do 3 right. exact (Vector_No_Unitario_too _ _ _ _ _ R H).
Qed.
(** Discharges Agregar_Disco_Total_Tablas.def.1, Agregar_Disco_Total_Tablas.conj.2. *)
Theorem Agregar_Disco_Total_Tablas_correct : @Agregar_Disco_Total_Tablas_conj_2 Elemento.
Proof.
  intros s T T' e r_out c r d R [[t H] | [H | [H | H]]].
  - destruct (Agregar_Disco_Tablas_correct s T T' e t r_out c r d R H) as [s' [R' A]]. exists s'.
    split; [exact R' | left; now exists t].
  - apply (Elemento_Ya_Existe_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | right; left; exact A].
  - apply (Radio_No_Positivo_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 2 right; left; exact A].
  - apply (Vector_No_Unitario_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 3 right; exact A].
Qed.
(** Discharges Agregar_Triangulo_Total_Tablas.conj.1. *)
Theorem Agregar_Triangulo_Total_Tablas_applicable : @Agregar_Triangulo_Total_Tablas_conj_1 Elemento.
Proof.
  intros T e abc ok. destruct (tables_have_a_scene T ok) as [s [R oks]].
  destruct (Agregar_Triangulo_Total_is_total Elemento s e abc oks) as [s' [r_out [[t H] | [H | H]]]].
  - destruct (Agregar_Triangulo_Tablas_applicable s T e t abc R) as [T' [r' H']]; [now exists s', r_out |].
    exists T', r'. left. now exists t.
  - exists T, r_out. right; left. exact (Elemento_Ya_Existe_too _ _ _ _ _ R H).
  - exists T, r_out. do 2 right. exact (Vertices_Alineados_too _ _ _ _ _ R H).
Qed.
(** Discharges Agregar_Triangulo_Total_Tablas.def.1, Agregar_Triangulo_Total_Tablas.conj.2. *)
Theorem Agregar_Triangulo_Total_Tablas_correct : @Agregar_Triangulo_Total_Tablas_conj_2 Elemento.
Proof.
  intros s T T' e r_out abc R [[t H] | [H | H]].
  - destruct (Agregar_Triangulo_Tablas_correct s T T' e t r_out abc R H) as [s' [R' A]]. exists s'.
    split; [exact R' | left; now exists t].
  - apply (Elemento_Ya_Existe_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | right; left; exact A].
  - apply (Vertices_Alineados_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 2 right; exact A].
Qed.

Ltac removal_applicable is_total applicable soy :=
  let s := fresh "s" in let R := fresh "R" in let oks := fresh "oks" in let s' := fresh "after" in
  let r_out := fresh "r" in
  let H := fresh "H" in let T := fresh "T" in let e := fresh "e" in let ok := fresh "ok" in let P := fresh "P" in
  let N := fresh "N" in
  intros T e ok; destruct (tables_have_a_scene T ok) as [s [R oks]];
  destruct (is_total s e oks) as [s' [r_out [H | [H | [_ P N _]]]]];
  [ destruct (applicable s T e R (ex_intro _ s' (ex_intro _ r_out H))) as [? [? ?]]; do 2 eexists; left; eassumption
  | exists T, r_out; right; left; exact (Elemento_No_Existe_too _ _ _ _ _ R H)
  | exists T, tipo_incorrecto; right; right; exists soy; split; [exact (other_type_too s T e soy R P N) |
  reflexivity] ].
Ltac removal_correct correct :=
  let s := fresh "s" in let R := fresh "R" in let s' := fresh "after" in let H := fresh "H" in let T := fresh "T" in
  let T' := fresh "after" in let e := fresh "e" in let r_out := fresh "r" in let X := fresh "X" in
  let R' := fresh "after" in
  let P := fresh "P" in let N := fresh "N" in let A := fresh "A" in
  intros s T T' e r_out R [H | [H | [? [H ->]]]];
  [ destruct (correct s T T' e r_out R H) as [s' [R' A]]; exists s'; split; [exact R' | left; exact A]
  | apply (Elemento_No_Existe_of_scene _ _ _ _ _ R) in H as [s' [R' A]]; exists s';
    split; [exact R' | right; left; exact A]
  | apply (other_type_of_scene _ _ _ _ _ _ R) in H as [s' [R' [X [P [N ->]]]]]; exists s'; split; [exact R' |];
    right; right; split; [exact X | exact P | exact N | reflexivity] ].

(** Discharges Eliminar_Esfera_Total_Tablas.conj.1. *)
Theorem Eliminar_Esfera_Total_Tablas_applicable : @Eliminar_Esfera_Total_Tablas_conj_1 Elemento.
Proof.
  removal_applicable (Eliminar_Esfera_Total_is_total Elemento) (@Eliminar_Esfera_Tablas_applicable Elemento)
    soy_esfera.
Qed.
(** Discharges Eliminar_Esfera_Total_Tablas.def.1, Eliminar_Esfera_Total_Tablas.conj.2. *)
Theorem Eliminar_Esfera_Total_Tablas_correct : @Eliminar_Esfera_Total_Tablas_conj_2 Elemento.
Proof. removal_correct (@Eliminar_Esfera_Tablas_correct Elemento). Qed.
(** Discharges Eliminar_Cilindro_Total_Tablas.conj.1. *)
Theorem Eliminar_Cilindro_Total_Tablas_applicable : @Eliminar_Cilindro_Total_Tablas_conj_1 Elemento.
Proof.
  removal_applicable (Eliminar_Cilindro_Total_is_total Elemento) (@Eliminar_Cilindro_Tablas_applicable Elemento)
    soy_cilindro.
Qed.
(** Discharges Eliminar_Cilindro_Total_Tablas.def.1, Eliminar_Cilindro_Total_Tablas.conj.2. *)
Theorem Eliminar_Cilindro_Total_Tablas_correct : @Eliminar_Cilindro_Total_Tablas_conj_2 Elemento.
Proof. removal_correct (@Eliminar_Cilindro_Tablas_correct Elemento). Qed.
(** Discharges Eliminar_Cono_Total_Tablas.conj.1. *)
Theorem Eliminar_Cono_Total_Tablas_applicable : @Eliminar_Cono_Total_Tablas_conj_1 Elemento.
Proof.
  removal_applicable (Eliminar_Cono_Total_is_total Elemento) (@Eliminar_Cono_Tablas_applicable Elemento)
    soy_cono.
Qed.
(** Discharges Eliminar_Cono_Total_Tablas.def.1, Eliminar_Cono_Total_Tablas.conj.2. *)
Theorem Eliminar_Cono_Total_Tablas_correct : @Eliminar_Cono_Total_Tablas_conj_2 Elemento.
Proof. removal_correct (@Eliminar_Cono_Tablas_correct Elemento). Qed.
(** Discharges Eliminar_Tronco_Total_Tablas.conj.1. *)
Theorem Eliminar_Tronco_Total_Tablas_applicable : @Eliminar_Tronco_Total_Tablas_conj_1 Elemento.
Proof.
  removal_applicable (Eliminar_Tronco_Total_is_total Elemento) (@Eliminar_Tronco_Tablas_applicable Elemento)
    soy_tronco.
Qed.
(** Discharges Eliminar_Tronco_Total_Tablas.def.1, Eliminar_Tronco_Total_Tablas.conj.2. *)
Theorem Eliminar_Tronco_Total_Tablas_correct : @Eliminar_Tronco_Total_Tablas_conj_2 Elemento.
Proof. removal_correct (@Eliminar_Tronco_Tablas_correct Elemento). Qed.
(** Discharges Eliminar_Plano_Total_Tablas.conj.1. *)
Theorem Eliminar_Plano_Total_Tablas_applicable : @Eliminar_Plano_Total_Tablas_conj_1 Elemento.
Proof.
  removal_applicable (Eliminar_Plano_Total_is_total Elemento) (@Eliminar_Plano_Tablas_applicable Elemento)
    soy_plano.
Qed.
(** Discharges Eliminar_Plano_Total_Tablas.def.1, Eliminar_Plano_Total_Tablas.conj.2. *)
Theorem Eliminar_Plano_Total_Tablas_correct : @Eliminar_Plano_Total_Tablas_conj_2 Elemento.
Proof. removal_correct (@Eliminar_Plano_Tablas_correct Elemento). Qed.
(** Discharges Eliminar_Disco_Total_Tablas.conj.1. *)
Theorem Eliminar_Disco_Total_Tablas_applicable : @Eliminar_Disco_Total_Tablas_conj_1 Elemento.
Proof.
  removal_applicable (Eliminar_Disco_Total_is_total Elemento) (@Eliminar_Disco_Tablas_applicable Elemento)
    soy_disco.
Qed.
(** Discharges Eliminar_Disco_Total_Tablas.def.1, Eliminar_Disco_Total_Tablas.conj.2. *)
Theorem Eliminar_Disco_Total_Tablas_correct : @Eliminar_Disco_Total_Tablas_conj_2 Elemento.
Proof. removal_correct (@Eliminar_Disco_Tablas_correct Elemento). Qed.
(** Discharges Eliminar_Triangulo_Total_Tablas.conj.1. *)
Theorem Eliminar_Triangulo_Total_Tablas_applicable : @Eliminar_Triangulo_Total_Tablas_conj_1 Elemento.
Proof.
  removal_applicable (Eliminar_Triangulo_Total_is_total Elemento) (@Eliminar_Triangulo_Tablas_applicable Elemento)
    soy_triangulo.
Qed.
(** Discharges Eliminar_Triangulo_Total_Tablas.def.1, Eliminar_Triangulo_Total_Tablas.conj.2. *)
Theorem Eliminar_Triangulo_Total_Tablas_correct : @Eliminar_Triangulo_Total_Tablas_conj_2 Elemento.
Proof. removal_correct (@Eliminar_Triangulo_Tablas_correct Elemento). Qed.

(** ** The general ones *)

(** Discharges Agregar_Elemento_Total_Tablas.conj.1. *)
Theorem Agregar_Elemento_Total_Tablas_applicable : @Agregar_Elemento_Total_Tablas_conj_1 Elemento.
Proof.
  intros T e t c r d h k abc ok. destruct (tables_have_a_scene T ok) as [s [R oks]].
  destruct (Agregar_Elemento_Total_is_total Elemento s e t c r d h k abc oks)
    as [s' [r_out [[[a H] _] | [H | [[H C] | [[H C] | [[H C] | [[H C] | [H C]]]]]]]]].
  - assert (P : exists T' r', Elemento_Agregado_Tablas T T' e t c r d h k abc r').
    { destruct H as [H | [H | [H | [H | [H | [H | H]]]]]].
      + destruct (Agregar_Esfera_Tablas_applicable s T e t c r R) as [T' [b A]]; [now exists s', a |].
        exists T', elemento_agregado. split; [exists b; left; exact A | reflexivity].
      + destruct (Agregar_Cilindro_Tablas_applicable s T e t c r d h R) as [T' [b A]]; [now exists s', a |].
        exists T', elemento_agregado. split; [exists b; right; left; exact A | reflexivity].
      + destruct (Agregar_Cono_Tablas_applicable s T e t c k d h R) as [T' [b A]]; [now exists s', a |].
        exists T', elemento_agregado. split; [exists b; do 2 right; left; exact A | reflexivity].
      + destruct (Agregar_Tronco_Tablas_applicable s T e t c r k d h R) as [T' [b A]]; [now exists s', a |].
        exists T', elemento_agregado. split; [exists b; do 3 right; left; exact A | reflexivity].
      + destruct (Agregar_Plano_Tablas_applicable s T e t c d R) as [T' [b A]]; [now exists s', a |].
        exists T', elemento_agregado. split; [exists b; do 4 right; left; exact A | reflexivity].
      + destruct (Agregar_Disco_Tablas_applicable s T e t c r d R) as [T' [b A]]; [now exists s', a |].
        exists T', elemento_agregado. split; [exists b; do 5 right; left; exact A | reflexivity].
      + destruct (Agregar_Triangulo_Tablas_applicable s T e t abc R) as [T' [b A]]; [now exists s', a |].
        exists T', elemento_agregado. split; [exists b; do 6 right; exact A | reflexivity].
    }
    destruct P as [T' [r' A]]. exists T', r'. left. exact A.
  - exists T, r_out. right; left. exact (Elemento_Ya_Existe_too _ _ _ _ _ R H).
  - exists T, r_out. do 2 right; left. exact (conj (Radio_No_Positivo_too _ _ _ _ _ R H) C).
  - exists T, r_out. do 3 right; left. exact (conj (Proporcion_No_Positiva_too _ _ _ _ _ R H) C).
  - exists T, r_out. do 4 right; left. exact (conj (Vector_No_Unitario_too _ _ _ _ _ R H) C).
  - exists T, r_out. do 5 right; left. exact (conj (Altura_No_Positiva_too _ _ _ _ _ R H) C).
  - exists T, r_out. do 6 right. exact (conj (Vertices_Alineados_too _ _ _ _ _ R H) C).
Qed.
(** Discharges Elemento_Agregado_Tablas.def.1, Agregar_Elemento_Total_Tablas.def.1,
    Agregar_Elemento_Total_Tablas.conj.2. *)
Theorem Agregar_Elemento_Total_Tablas_correct : @Agregar_Elemento_Total_Tablas_conj_2 Elemento.
Proof.
  intros s T T' e t c r d h k abc r_out R [[[a H] ->] | [H | [[H C] | [[H C] | [[H C] | [[H C] | [H C]]]]]]].
  - assert (P : exists s', Retrieve s' T' /\ Elemento_Agregado s s' e t c r d h k abc elemento_agregado).
    { destruct H as [H | [H | [H | [H | [H | [H | H]]]]]].
      + destruct (Agregar_Esfera_Tablas_correct s T T' e t a c r R H) as [s' [R' A]]. exists s'.
        split; [exact R' | split; [exists a; left; exact A | reflexivity]].
      + destruct (Agregar_Cilindro_Tablas_correct s T T' e t a c r d h R H) as [s' [R' A]]. exists s'.
        split; [exact R' | split; [exists a; right; left; exact A | reflexivity]].
      + destruct (Agregar_Cono_Tablas_correct s T T' e t a c k d h R H) as [s' [R' A]]. exists s'.
        split; [exact R' | split; [exists a; do 2 right; left; exact A | reflexivity]].
      + destruct (Agregar_Tronco_Tablas_correct s T T' e t a c r k d h R H) as [s' [R' A]]. exists s'.
        split; [exact R' | split; [exists a; do 3 right; left; exact A | reflexivity]].
      + destruct (Agregar_Plano_Tablas_correct s T T' e t a c d R H) as [s' [R' A]]. exists s'.
        split; [exact R' | split; [exists a; do 4 right; left; exact A | reflexivity]].
      + destruct (Agregar_Disco_Tablas_correct s T T' e t a c r d R H) as [s' [R' A]]. exists s'.
        split; [exact R' | split; [exists a; do 5 right; left; exact A | reflexivity]].
      + destruct (Agregar_Triangulo_Tablas_correct s T T' e t a abc R H) as [s' [R' A]]. exists s'.
        split; [exact R' | split; [exists a; do 6 right; exact A | reflexivity]].
    }
    destruct P as [s' [R' A]]. exists s'. split; [exact R' | left; exact A].
  - apply (Elemento_Ya_Existe_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | right; left; exact A].
  - apply (Radio_No_Positivo_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 2 right; left; exact (conj A C)].
  - apply (Proporcion_No_Positiva_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 3 right; left; exact (conj A C)].
  - apply (Vector_No_Unitario_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 4 right; left; exact (conj A C)].
  - apply (Altura_No_Positiva_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 5 right; left; exact (conj A C)].
  - apply (Vertices_Alineados_of_scene _ _ _ _ _ R) in H as [s' [R' A]]. exists s'.
    split; [exact R' | do 6 right; exact (conj A C)].
Qed.
(** Discharges Eliminar_Elemento_Total_Tablas.conj.1. *)
Theorem Eliminar_Elemento_Total_Tablas_applicable : @Eliminar_Elemento_Total_Tablas_conj_1 Elemento.
Proof.
  intros T e ok. destruct (tables_have_a_scene T ok) as [s [R oks]].
  destruct (Eliminar_Elemento_Total_is_total Elemento s e oks) as [s' [r_out [[[a H] _] | H]]];
    [| exists T, r_out; right; exact (Elemento_No_Existe_too _ _ _ _ _ R H)].
  destruct H as [H | [H | [H | [H | [H | [H | H]]]]]].
  - destruct (Eliminar_Esfera_Tablas_applicable s T e R) as [T' [b A]]; [now exists s', a |].
    exists T', elemento_eliminado. left. split; [exists b; left; exact A | reflexivity].
  - destruct (Eliminar_Cilindro_Tablas_applicable s T e R) as [T' [b A]]; [now exists s', a |].
    exists T', elemento_eliminado. left. split; [exists b; right; left; exact A | reflexivity].
  - destruct (Eliminar_Cono_Tablas_applicable s T e R) as [T' [b A]]; [now exists s', a |].
    exists T', elemento_eliminado. left. split; [exists b; do 2 right; left; exact A | reflexivity].
  - destruct (Eliminar_Tronco_Tablas_applicable s T e R) as [T' [b A]]; [now exists s', a |].
    exists T', elemento_eliminado. left. split; [exists b; do 3 right; left; exact A | reflexivity].
  - destruct (Eliminar_Plano_Tablas_applicable s T e R) as [T' [b A]]; [now exists s', a |].
    exists T', elemento_eliminado. left. split; [exists b; do 4 right; left; exact A | reflexivity].
  - destruct (Eliminar_Disco_Tablas_applicable s T e R) as [T' [b A]]; [now exists s', a |].
    exists T', elemento_eliminado. left. split; [exists b; do 5 right; left; exact A | reflexivity].
  - destruct (Eliminar_Triangulo_Tablas_applicable s T e R) as [T' [b A]]; [now exists s', a |].
    exists T', elemento_eliminado. left. split; [exists b; do 6 right; exact A | reflexivity].
Qed.
(** Discharges Elemento_Eliminado_Tablas.def.1, Eliminar_Elemento_Total_Tablas.def.1,
    Eliminar_Elemento_Total_Tablas.conj.2. *)
Theorem Eliminar_Elemento_Total_Tablas_correct : @Eliminar_Elemento_Total_Tablas_conj_2 Elemento.
Proof.
  intros s T T' e r_out R [[[a H] ->] | H];
    [| apply (Elemento_No_Existe_of_scene _ _ _ _ _ R) in H as [s' [R' A]]; exists s';
       split; [exact R' | right; exact A]].
  destruct H as [H | [H | [H | [H | [H | [H | H]]]]]].
  - destruct (Eliminar_Esfera_Tablas_correct s T T' e a R H) as [s' [R' A]]. exists s'.
    split; [exact R' | left; split; [exists a; left; exact A | reflexivity]].
  - destruct (Eliminar_Cilindro_Tablas_correct s T T' e a R H) as [s' [R' A]]. exists s'.
    split; [exact R' | left; split; [exists a; right; left; exact A | reflexivity]].
  - destruct (Eliminar_Cono_Tablas_correct s T T' e a R H) as [s' [R' A]]. exists s'.
    split; [exact R' | left; split; [exists a; do 2 right; left; exact A | reflexivity]].
  - destruct (Eliminar_Tronco_Tablas_correct s T T' e a R H) as [s' [R' A]]. exists s'.
    split; [exact R' | left; split; [exists a; do 3 right; left; exact A | reflexivity]].
  - destruct (Eliminar_Plano_Tablas_correct s T T' e a R H) as [s' [R' A]]. exists s'.
    split; [exact R' | left; split; [exists a; do 4 right; left; exact A | reflexivity]].
  - destruct (Eliminar_Disco_Tablas_correct s T T' e a R H) as [s' [R' A]]. exists s'.
    split; [exact R' | left; split; [exists a; do 5 right; left; exact A | reflexivity]].
  - destruct (Eliminar_Triangulo_Tablas_correct s T T' e a R H) as [s' [R' A]]. exists s'.
    split; [exact R' | left; split; [exists a; do 6 right; exact A | reflexivity]].
Qed.
End RowsRefused.
