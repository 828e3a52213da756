(** spec/promocion.tex: the two ways between a scene and its shapes are one relation, and each operation that is
      lifted from
    one shape is that of the scene, both ways. *)
From Coq Require Import Reals Setoid Morphisms.
From Durero Require Import Toolkit Especificacion Escena Operaciones Tablas Promocion.
From Durero Require Retrieve.
Local Open Scope zed_scope.

Section Lifted.
Context {Elemento : Type}.
Notation Escena := (Especificacion.Escena Elemento).
Notation Formas := (rel Elemento Forma).
Implicit Types (s : Escena) (e : Elemento) (f : Formas) (x : Forma).

(** ** One relation *)

Lemma what_shapes_say_is_one f s : Recobro f s -> Escena_eq (scene_of f) s.
Proof.
  intros [_ ok T C1 C2 C3 C4 C5 C6]. split; cbn; try assumption.
  - intros e. rewrite (Escena_inv_1 ok e), (dom_proper _ _ T e). unfold dom, comp, tipo_de, of_shape, single. cbn.
    split; [intros [t [x [H _]]]; now exists x | intros [x H]; now exists (Retrieve.type_of x), x].
  - now rewrite (Escena_inv_7 ok), T.
Qed.
Lemma scene_of_recovers f : Formas_ok f -> Recobro f (scene_of f).
Proof. intros ok. split; [exact ok | now apply scene_of_ok | reflexivity ..]. Qed.
Lemma recovered s f : Formas_ok f -> Escena_ok s -> Escena_eq (scene_of f) s -> Recobro f s.
Proof. intros okf ok []. split; assumption. Qed.
Lemma equal_scenes_have_equal_shapes s s' : Escena_eq s s' -> shapes_of s' ≡ shapes_of s.
Proof.
  intros [_ _ T C1 C2 C3 C4 C5 C6] [e x]. rewrite !shapes_of_spec. destruct x; cbn;
    unfold is_esfera, is_cilindro, is_cono, is_tronco, is_plano, is_disco, is_triangulo;
    now rewrite ?(T (e, _)), ?(C1 (e, _)), ?(C2 (e, _)), ?(C3 (e, _)), ?(C4 (e, _)), ?(C5 (e, _)), ?(C6 (e, _)).
Qed.
Lemma shapes_of_scene_of f : Formas_ok f -> shapes_of (scene_of f) ≡ f.
Proof.
  intros ok. pose proof (scene_of_ok f ok) as oks.
  assert (U : forall e x, (e, x) ∈ f -> has_shape (scene_of f) e x).
  { intros e x H. destruct x; cbn; unfold is_esfera, is_cilindro, is_cono, is_tronco, is_plano, is_disco, is_triangulo;
      repeat apply conj; eexists; (split; [exact H |]); reflexivity. }
  intros [e x]. rewrite shapes_of_spec. split; [| apply U]. intros H.
  destruct (element_of_shape _ oks e x H) as [y Hy]. now rewrite (shape_unique _ oks e x y H (U e y Hy)).
Qed.
Lemma ways_agree s f : Retrato s f <-> Recobro f s.
Proof.
  split.
  - intros [ok okf E]. destruct (shapes_say_the_scene s ok) as [_ _ T C1 C2 C3 C4 C5 C6].
    split; [exact okf | exact ok | now rewrite E ..].
  - intros R. pose proof (what_shapes_say_is_one f s R) as E. destruct R as [okf ok _ _ _ _ _ _ _].
    split; [exact ok | exact okf |]. now rewrite (equal_scenes_have_equal_shapes _ _ E), shapes_of_scene_of.
Qed.
Lemma portrayed s : Escena_ok s -> Retrato s (shapes_of s).
Proof. intros ok. split; [exact ok | now apply shapes_of_ok | reflexivity]. Qed.

(** Discharges Retrato.inv.1, Retrato.conj.1. *)
Theorem a_scene_has_one_function_to_shapes : @Retrato_conj_1 Elemento.
Proof.
  intros s ok. exists (shapes_of s). split; [split; [now apply portrayed | now apply shapes_say_the_scene] |].
  intros f' [[_ _ E] _]. exact E.
Qed.
(** Discharges Formas.def.1, Recobro.conj.1. *)
Theorem shapes_say_one_scene : @Recobro_conj_1 Elemento.
Proof.
  intros f ok. exists (scene_of f). pose proof (scene_of_recovers f ok) as R.
  split; [split; [exact R | now apply ways_agree] |]. intros s' [R' _]. now apply what_shapes_say_is_one.
Qed.
(** Discharges Init_Formas.def.1, Init_Formas.conj.1. *)
Theorem first_shapes_say_the_first_scene : @Init_Formas_conj_1 Elemento.
Proof.
  intros f' [ok E]. exists (scene_of f'). split; [now apply scene_of_recovers |]. split; [now apply scene_of_ok |].
  intros e. cbn. split; [intros [x H]; now apply E in H | intros []].
Qed.
(** Discharges Init_Formas.conj.2. *)
Theorem the_first_scene_has_the_first_shapes : @Init_Formas_conj_2 Elemento.
Proof.
  intros s' [ok E]. exists (shapes_of s'). split; [now apply portrayed |]. split; [now apply shapes_of_ok |].
  intros [e x]. split; [| intros []]. intros H. apply (E e), (dom_shapes_of s' ok e). now exists x.
Qed.

(** ** The frames. Each moves one shape, and so one element *)

Definition with_shape s e x : Escena :=
  scene_with _ s e (Retrieve.type_of x) (Retrieve.centres x) (Retrieve.radii x) (Retrieve.axes x) (Retrieve.heights x)
    (Retrieve.proportions x) (Retrieve.vertices x).
Lemma comp_added f e x {V} (A : Forma -> set V) :
  comp (f ∪ ⦃(e, x)⦄) (of_shape A) ≡ comp f (of_shape A) ∪ at_one e (A x).
Proof.
  intros [k v]. unfold comp, union, single, at_one, of_shape. cbn. split.
  - intros [y [[H | E] Hv]]; [left; now exists y | apply pair_eq in E as [-> ->]; now right].
  - intros [[y [H Hv]] | [-> Hv]]; [exists y; auto | exists x; auto].
Qed.
Lemma comp_removed f e {V} (A : Forma -> set V) : comp (ndres ⦃e⦄ f) (of_shape A) ≡ ndres ⦃e⦄ (comp f (of_shape A)).
Proof. intros [k v]. unfold comp, ndres, single. cbn. firstorder. Qed.
Lemma scene_of_added f e x f' : f' ≡ f ∪ ⦃(e, x)⦄ -> Escena_eq (with_shape (scene_of f) e x) (scene_of f').
Proof.
  intros E. unfold with_shape, scene_with. split; cbn; rewrite E; try apply comp_added.
  - intros k. rewrite dom_union_single. reflexivity.
  - unfold tipo_de. now rewrite comp_added, at_one_single.
  - unfold tipo_de. now rewrite comp_added, at_one_single.
Qed.
Lemma scene_of_removed f e f' : f' ≡ ndres ⦃e⦄ f -> Escena_eq (scene_without _ (scene_of f) e) (scene_of f').
Proof.
  intros E. split; cbn; rewrite E; try apply comp_removed.
  - intros k. rewrite dom_ndres. reflexivity.
  - unfold tipo_de. now rewrite comp_removed.
Qed.
Lemma with_shape_eq s s' e x : Escena_eq s s' -> Escena_eq (with_shape s e x) (with_shape s' e x).
Proof.
  intros [E1 _ T C1 C2 C3 C4 C5 C6].
  split; cbn; rewrite ?E1, ?T, ?C1, ?C2, ?C3, ?C4, ?C5, ?C6; reflexivity.
Qed.
Lemma scene_without_eq s s' e : Escena_eq s s' -> Escena_eq (scene_without _ s e) (scene_without _ s' e).
Proof.
  intros [E1 _ T C1 C2 C3 C4 C5 C6].
  split; cbn; rewrite ?E1, ?T, ?C1, ?C2, ?C3, ?C4, ?C5, ?C6; reflexivity.
Qed.

(** Discharges Una_Forma.def.1, Marco_Agregar.def.1. *)
Lemma an_element_added_is_a_shape_added s s' e x : Escena_ok s -> Escena_ok s' -> e ∉ elementos s -> valid x ->
  Escena_eq (with_shape s e x) s' -> exists f f', Retrato s f /\ Retrato s' f' /\ Marco_Agregar f f' x e.
Proof.
  intros ok ok' N V E. exists (shapes_of s), (shapes_of s ∪ ⦃(e, x)⦄).
  pose proof (shapes_of_ok s ok) as okf. assert (Nf : e ∉ dom (shapes_of s)) by now rewrite (dom_shapes_of s ok e).
  assert (okf' : Formas_ok (shapes_of s ∪ ⦃(e, x)⦄)).
  { split.
    - rewrite <- at_one_single. apply pfun_union; [apply okf | exact Nf | apply single_at_most_one |].
      now intros y ->.
    - assert (D : dom (shapes_of s ∪ ⦃(e, x)⦄) ≡ dom (shapes_of s) ∪ ⦃e⦄) by (intros k; apply dom_union_single).
      rewrite D. apply finset_add, okf. }
  split; [now apply portrayed | split; [| now split]]. apply ways_agree, recovered; [exact okf' | exact ok' |].
  apply Escena_eq_trans with (with_shape s e x); [| exact E]. apply Escena_eq_sym.
  apply Escena_eq_trans with (with_shape (scene_of (shapes_of s)) e x); [| now apply scene_of_added].
  apply with_shape_eq, Escena_eq_sym, what_shapes_say_is_one. now apply shapes_say_the_scene.
Qed.
Lemma a_shape_added_is_an_element_added f f' x e : Marco_Agregar f f' x e ->
  Recobro f (scene_of f) /\ Recobro f' (scene_of f') /\ Escena_ok (scene_of f) /\ e ∉ elementos (scene_of f)
  /\ Escena_eq (with_shape (scene_of f) e x) (scene_of f').
Proof.
  intros [ok ok' V N E]. split; [now apply scene_of_recovers | split; [now apply scene_of_recovers |]].
  split; [now apply scene_of_ok | split; [exact N | now apply scene_of_added]].
Qed.
(** Discharges Marco_Eliminar.def.1. *)
Lemma an_element_removed_is_a_shape_removed s s' e t : Escena_ok s -> Escena_ok s' -> (e, t) ∈ de_que_tipo s ->
  Escena_eq (scene_without _ s e) s' ->
  exists f f' x, Retrato s f /\ Retrato s' f' /\ Marco_Eliminar f f' x e /\ Retrieve.type_of x = t.
Proof.
  intros ok ok' H E. pose proof (shapes_of_ok s ok) as okf.
  destruct (every_element_has_a_shape s ok e (element_of_type _ s ok e t H)) as [x [Hx V]].
  exists (shapes_of s), (ndres ⦃e⦄ (shapes_of s)), x.
  assert (okf' : Formas_ok (ndres ⦃e⦄ (shapes_of s))).
  { split; [apply pfun_ndres, okf |]. apply finset_subset with (dom (shapes_of s)); [apply okf |].
    intros k Hk. now apply dom_ndres in Hk. }
  assert (Hf : (e, x) ∈ shapes_of s) by now apply shapes_of_spec.
  split; [now apply portrayed | split; [| split]].
  - apply ways_agree, recovered; [exact okf' | exact ok' |].
    apply Escena_eq_trans with (scene_without _ s e); [| exact E]. apply Escena_eq_sym.
    apply Escena_eq_trans with (scene_without _ (scene_of (shapes_of s)) e); [| now apply scene_of_removed].
    apply scene_without_eq, Escena_eq_sym, what_shapes_say_is_one. now apply shapes_say_the_scene.
  - split; [exact okf | exact okf' | exact V | split; [now exists x | exact Hf] | reflexivity].
  - exact (type_unique _ s ok e _ t (has_type s e x Hx) H).
Qed.
Lemma a_shape_removed_is_an_element_removed f f' x e : Marco_Eliminar f f' x e ->
  Recobro f (scene_of f) /\ Recobro f' (scene_of f') /\ Escena_ok (scene_of f)
  /\ (e, Retrieve.type_of x) ∈ de_que_tipo (scene_of f) /\ Escena_eq (scene_without _ (scene_of f) e) (scene_of f').
Proof.
  intros [ok ok' V [_ H] E]. split; [now apply scene_of_recovers | split; [now apply scene_of_recovers |]].
  split; [now apply scene_of_ok | split; [| now apply scene_of_removed]]. exists x. now split.
Qed.

(** ** Each operation *)

Ltac removal_lifted computed :=
  let s := fresh "s" in let s' := fresh "after" in let e := fresh "e" in let r_out := fresh "r" in
  let A := fresh "A" in
  let ok := fresh "ok" in let H := fresh "H" in let E := fresh "E" in let f := fresh "f" in let f' := fresh "now" in
  let x := fresh "x" in let R := fresh "R" in let R' := fresh "then" in let M := fresh "M" in let T := fresh "T" in
  intros s s' e r_out A; pose proof (proj1 (computed _ _ _ _ _) A) as [[ok H] [E ->]];
  destruct (an_element_removed_is_a_shape_removed s s' e _ ok ltac:(apply A) H E) as [f [f' [x [R [R' [M T]]]]]];
  exists f, f'; split; [exact R | split; [exact R' |]]; exists x; exact (conj M (conj T eq_refl)).
Ltac removal_of_the_scene computed :=
  let f := fresh "f" in let f' := fresh "now" in let e := fresh "e" in let r_out := fresh "r" in let x := fresh "x" in
  let M := fresh "M" in let T := fresh "T" in let R := fresh "R" in let R' := fresh "then" in let ok := fresh "ok" in
  let H := fresh "H" in let E := fresh "E" in
  intros f f' e r_out [x [M [T ->]]];
  destruct (a_shape_removed_is_an_element_removed _ _ _ _ M) as [R [R' [ok [H E]]]]; rewrite T in H;
  exists (scene_of f), (scene_of f'); split; [exact R | split; [exact R' |]]; apply computed;
  split; [exact (conj ok H) | split; [exact E | reflexivity]].

(** Discharges Agregar_Esfera_Formas.conj.1. *)
Theorem Agregar_Esfera_is_lifted : @Agregar_Esfera_Formas_conj_1 Elemento.
Proof.
  intros s s' e t r_out c r A. pose proof (proj1 (Agregar_Esfera_computed _ _ _ _ _ _ _ _) A) as [[ok [N [_ P]]] [E
  ->]].
  destruct (an_element_added_is_a_shape_added s s' e (Retrieve.Sphere c r) ok ltac:(apply A) N P E) as [f [f' [R [R'
  M]]]].
  exists f, f'. split; [exact R | split; [exact R' |]]. eexists. split; [exact M |].
  exact (conj P (conj P (conj eq_refl eq_refl))).
Qed.
(** Discharges Nueva_Esfera.def.1, Agregar_Esfera_Formas.def.1, Agregar_Esfera_Formas.conj.2. *)
Theorem Agregar_Esfera_Formas_is_of_the_scene : @Agregar_Esfera_Formas_conj_2 Elemento.
Proof.
  intros f f' e r_out c r [x [M [_ [P [-> ->]]]]].
  destruct (a_shape_added_is_an_element_added _ _ _ _ M) as [R [R' [ok [N E]]]].
  exists (scene_of f), (scene_of f'), soy_esfera. split; [exact R | split; [exact R' |]]. apply
  Agregar_Esfera_computed.
  split; [exact (conj ok (conj N (conj eq_refl P))) | split; [exact E | reflexivity]].
Qed.
(** Discharges Agregar_Cilindro_Formas.conj.1. *)
Theorem Agregar_Cilindro_is_lifted : @Agregar_Cilindro_Formas_conj_1 Elemento.
Proof.
  intros s s' e t r_out c r d h A. pose proof (proj1 (Agregar_Cilindro_computed _ _ _ _ _ _ _ _ _ _) A) as [[ok [N [_
  P]]] [E ->]].
  destruct (an_element_added_is_a_shape_added s s' e (Retrieve.Cylinder c r d h) ok ltac:(apply A) N P E) as [f [f'
  [R [R' M]]]].
  exists f, f'. split; [exact R | split; [exact R' |]]. eexists. split; [exact M |].
  exact (conj P (conj P (conj eq_refl eq_refl))).
Qed.
(** Discharges Nuevo_Cilindro.def.1, Agregar_Cilindro_Formas.def.1, Agregar_Cilindro_Formas.conj.2. *)
Theorem Agregar_Cilindro_Formas_is_of_the_scene : @Agregar_Cilindro_Formas_conj_2 Elemento.
Proof.
  intros f f' e r_out c r d h [x [M [_ [P [-> ->]]]]].
  destruct (a_shape_added_is_an_element_added _ _ _ _ M) as [R [R' [ok [N E]]]].
  exists (scene_of f), (scene_of f'), soy_cilindro. split; [exact R | split; [exact R' |]]. apply
  Agregar_Cilindro_computed.
  split; [exact (conj ok (conj N (conj eq_refl P))) | split; [exact E | reflexivity]].
Qed.
(** Discharges Agregar_Cono_Formas.conj.1. *)
Theorem Agregar_Cono_is_lifted : @Agregar_Cono_Formas_conj_1 Elemento.
Proof.
  intros s s' e t r_out c k d h A. pose proof (proj1 (Agregar_Cono_computed _ _ _ _ _ _ _ _ _ _) A) as [[ok [N [_
  P]]] [E ->]].
  destruct (an_element_added_is_a_shape_added s s' e (Retrieve.Cone c k d h) ok ltac:(apply A) N P E) as [f [f' [R
  [R' M]]]].
  exists f, f'. split; [exact R | split; [exact R' |]]. eexists. split; [exact M |].
  exact (conj P (conj P (conj eq_refl eq_refl))).
Qed.
(** Discharges Nuevo_Cono.def.1, Agregar_Cono_Formas.def.1, Agregar_Cono_Formas.conj.2. *)
Theorem Agregar_Cono_Formas_is_of_the_scene : @Agregar_Cono_Formas_conj_2 Elemento.
Proof.
  intros f f' e r_out c k d h [x [M [_ [P [-> ->]]]]].
  destruct (a_shape_added_is_an_element_added _ _ _ _ M) as [R [R' [ok [N E]]]].
  exists (scene_of f), (scene_of f'), soy_cono. split; [exact R | split; [exact R' |]]. apply Agregar_Cono_computed.
  split; [exact (conj ok (conj N (conj eq_refl P))) | split; [exact E | reflexivity]].
Qed.
(** Discharges Agregar_Tronco_Formas.conj.1. *)
Theorem Agregar_Tronco_is_lifted : @Agregar_Tronco_Formas_conj_1 Elemento.
Proof.
  intros s s' e t r_out c r k d h A. pose proof (proj1 (Agregar_Tronco_computed _ _ _ _ _ _ _ _ _ _ _) A) as [[ok [N
  [_ P]]] [E ->]].
  destruct (an_element_added_is_a_shape_added s s' e (Retrieve.TruncatedCone c r k d h) ok ltac:(apply A) N P E) as
  [f [f' [R [R' M]]]].
  exists f, f'. split; [exact R | split; [exact R' |]]. eexists. split; [exact M |].
  exact (conj P (conj P (conj eq_refl eq_refl))).
Qed.
(** Discharges Nuevo_Tronco.def.1, Agregar_Tronco_Formas.def.1, Agregar_Tronco_Formas.conj.2. *)
Theorem Agregar_Tronco_Formas_is_of_the_scene : @Agregar_Tronco_Formas_conj_2 Elemento.
Proof.
  intros f f' e r_out c r k d h [x [M [_ [P [-> ->]]]]].
  destruct (a_shape_added_is_an_element_added _ _ _ _ M) as [R [R' [ok [N E]]]].
  exists (scene_of f), (scene_of f'), soy_tronco. split; [exact R | split; [exact R' |]]. apply
  Agregar_Tronco_computed.
  split; [exact (conj ok (conj N (conj eq_refl P))) | split; [exact E | reflexivity]].
Qed.
(** Discharges Agregar_Plano_Formas.conj.1. *)
Theorem Agregar_Plano_is_lifted : @Agregar_Plano_Formas_conj_1 Elemento.
Proof.
  intros s s' e t r_out c d A. pose proof (proj1 (Agregar_Plano_computed _ _ _ _ _ _ _ _) A) as [[ok [N [_ P]]] [E
  ->]].
  destruct (an_element_added_is_a_shape_added s s' e (Retrieve.Plane c d) ok ltac:(apply A) N P E) as [f [f' [R [R'
  M]]]].
  exists f, f'. split; [exact R | split; [exact R' |]]. eexists. split; [exact M |].
  exact (conj P (conj P (conj eq_refl eq_refl))).
Qed.
(** Discharges Nuevo_Plano.def.1, Agregar_Plano_Formas.def.1, Agregar_Plano_Formas.conj.2. *)
Theorem Agregar_Plano_Formas_is_of_the_scene : @Agregar_Plano_Formas_conj_2 Elemento.
Proof.
  intros f f' e r_out c d [x [M [_ [P [-> ->]]]]].
  destruct (a_shape_added_is_an_element_added _ _ _ _ M) as [R [R' [ok [N E]]]].
  exists (scene_of f), (scene_of f'), soy_plano. split; [exact R | split; [exact R' |]]. apply Agregar_Plano_computed.
  split; [exact (conj ok (conj N (conj eq_refl P))) | split; [exact E | reflexivity]].
Qed.
(** Discharges Agregar_Disco_Formas.conj.1. *)
Theorem Agregar_Disco_is_lifted : @Agregar_Disco_Formas_conj_1 Elemento.
Proof.
  intros s s' e t r_out c r d A. pose proof (proj1 (Agregar_Disco_computed _ _ _ _ _ _ _ _ _) A) as [[ok [N [_ P]]]
  [E ->]].
  destruct (an_element_added_is_a_shape_added s s' e (Retrieve.Disc c r d) ok ltac:(apply A) N P E) as [f [f' [R [R'
  M]]]].
  exists f, f'. split; [exact R | split; [exact R' |]]. eexists. split; [exact M |].
  exact (conj P (conj P (conj eq_refl eq_refl))).
Qed.
(** Discharges Nuevo_Disco.def.1, Agregar_Disco_Formas.def.1, Agregar_Disco_Formas.conj.2. *)
Theorem Agregar_Disco_Formas_is_of_the_scene : @Agregar_Disco_Formas_conj_2 Elemento.
Proof.
  intros f f' e r_out c r d [x [M [_ [P [-> ->]]]]].
  destruct (a_shape_added_is_an_element_added _ _ _ _ M) as [R [R' [ok [N E]]]].
  exists (scene_of f), (scene_of f'), soy_disco. split; [exact R | split; [exact R' |]]. apply Agregar_Disco_computed.
  split; [exact (conj ok (conj N (conj eq_refl P))) | split; [exact E | reflexivity]].
Qed.
(** Discharges Agregar_Triangulo_Formas.conj.1. *)
Theorem Agregar_Triangulo_is_lifted : @Agregar_Triangulo_Formas_conj_1 Elemento.
Proof.
  intros s s' e t r_out abc A. pose proof (proj1 (Agregar_Triangulo_computed _ _ _ _ _ _ _) A) as [[ok [N [_ P]]] [E
  ->]].
  destruct (an_element_added_is_a_shape_added s s' e (Retrieve.Triangle abc) ok ltac:(apply A) N P E) as [f [f' [R
  [R' M]]]].
  exists f, f'. split; [exact R | split; [exact R' |]]. eexists. split; [exact M |].
  exact (conj P (conj P (conj eq_refl eq_refl))).
Qed.
(** Discharges Nuevo_Triangulo.def.1, Agregar_Triangulo_Formas.def.1, Agregar_Triangulo_Formas.conj.2. *)
Theorem Agregar_Triangulo_Formas_is_of_the_scene : @Agregar_Triangulo_Formas_conj_2 Elemento.
Proof.
  intros f f' e r_out abc [x [M [_ [P [-> ->]]]]].
  destruct (a_shape_added_is_an_element_added _ _ _ _ M) as [R [R' [ok [N E]]]].
  exists (scene_of f), (scene_of f'), soy_triangulo. split; [exact R | split; [exact R' |]]. apply
  Agregar_Triangulo_computed.
  split; [exact (conj ok (conj N (conj eq_refl P))) | split; [exact E | reflexivity]].
Qed.
(** Discharges Eliminar_Esfera_Formas.conj.1. *)
Theorem Eliminar_Esfera_is_lifted : @Eliminar_Esfera_Formas_conj_1 Elemento.
Proof. removal_lifted Eliminar_Esfera_computed. Qed.
(** Discharges Vieja_Esfera.def.1, Eliminar_Esfera_Formas.def.1, Eliminar_Esfera_Formas.conj.2. *)
Theorem Eliminar_Esfera_Formas_is_of_the_scene : @Eliminar_Esfera_Formas_conj_2 Elemento.
Proof. removal_of_the_scene Eliminar_Esfera_computed. Qed.
(** Discharges Eliminar_Cilindro_Formas.conj.1. *)
Theorem Eliminar_Cilindro_is_lifted : @Eliminar_Cilindro_Formas_conj_1 Elemento.
Proof. removal_lifted Eliminar_Cilindro_computed. Qed.
(** Discharges Viejo_Cilindro.def.1, Eliminar_Cilindro_Formas.def.1, Eliminar_Cilindro_Formas.conj.2. *)
Theorem Eliminar_Cilindro_Formas_is_of_the_scene : @Eliminar_Cilindro_Formas_conj_2 Elemento.
Proof. removal_of_the_scene Eliminar_Cilindro_computed. Qed.
(** Discharges Eliminar_Cono_Formas.conj.1. *)
Theorem Eliminar_Cono_is_lifted : @Eliminar_Cono_Formas_conj_1 Elemento.
Proof. removal_lifted Eliminar_Cono_computed. Qed.
(** Discharges Viejo_Cono.def.1, Eliminar_Cono_Formas.def.1, Eliminar_Cono_Formas.conj.2. *)
Theorem Eliminar_Cono_Formas_is_of_the_scene : @Eliminar_Cono_Formas_conj_2 Elemento.
Proof. removal_of_the_scene Eliminar_Cono_computed. Qed.
(** Discharges Eliminar_Tronco_Formas.conj.1. *)
Theorem Eliminar_Tronco_is_lifted : @Eliminar_Tronco_Formas_conj_1 Elemento.
Proof. removal_lifted Eliminar_Tronco_computed. Qed.
(** Discharges Viejo_Tronco.def.1, Eliminar_Tronco_Formas.def.1, Eliminar_Tronco_Formas.conj.2. *)
Theorem Eliminar_Tronco_Formas_is_of_the_scene : @Eliminar_Tronco_Formas_conj_2 Elemento.
Proof. removal_of_the_scene Eliminar_Tronco_computed. Qed.
(** Discharges Eliminar_Plano_Formas.conj.1. *)
Theorem Eliminar_Plano_is_lifted : @Eliminar_Plano_Formas_conj_1 Elemento.
Proof. removal_lifted Eliminar_Plano_computed. Qed.
(** Discharges Viejo_Plano.def.1, Eliminar_Plano_Formas.def.1, Eliminar_Plano_Formas.conj.2. *)
Theorem Eliminar_Plano_Formas_is_of_the_scene : @Eliminar_Plano_Formas_conj_2 Elemento.
Proof. removal_of_the_scene Eliminar_Plano_computed. Qed.
(** Discharges Eliminar_Disco_Formas.conj.1. *)
Theorem Eliminar_Disco_is_lifted : @Eliminar_Disco_Formas_conj_1 Elemento.
Proof. removal_lifted Eliminar_Disco_computed. Qed.
(** Discharges Viejo_Disco.def.1, Eliminar_Disco_Formas.def.1, Eliminar_Disco_Formas.conj.2. *)
Theorem Eliminar_Disco_Formas_is_of_the_scene : @Eliminar_Disco_Formas_conj_2 Elemento.
Proof. removal_of_the_scene Eliminar_Disco_computed. Qed.
(** Discharges Eliminar_Triangulo_Formas.conj.1. *)
Theorem Eliminar_Triangulo_is_lifted : @Eliminar_Triangulo_Formas_conj_1 Elemento.
Proof. removal_lifted Eliminar_Triangulo_computed. Qed.
(** Discharges Viejo_Triangulo.def.1, Eliminar_Triangulo_Formas.def.1, Eliminar_Triangulo_Formas.conj.2. *)
Theorem Eliminar_Triangulo_Formas_is_of_the_scene : @Eliminar_Triangulo_Formas_conj_2 Elemento.
Proof. removal_of_the_scene Eliminar_Triangulo_computed. Qed.
End Lifted.
