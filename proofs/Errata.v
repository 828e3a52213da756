(** spec/erratas.md: the defects of the printed text that mathematics can show, one theorem each, named by its number.

    Printed_ok s         == the scene's invariant as printed, its arrows read as partial functions (E20)
    Printed_…            == a schema or set as printed in spec/impresa/; Δ of an operation is read as inclusion (E04),
                            t? for i? (E08), and the general answer is kept only where a theorem is about it (E05) *)
From Coq Require Import Reals Lra Lia.
From Durero Require Import Toolkit Especificacion Tipos Escena Operaciones Puntos Trazador Interseccion.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** ** The scene *)
Section Errata.
Variable Elemento : Type.
Notation Escena := (Especificacion.Escena Elemento).
Implicit Types (s : Escena) (e x : Elemento) (c : Punto) (d : Vector) (r h k : R).

Record Printed_ok s : Prop := {
  Printed_de_que_tipo : de_que_tipo s ∈ (univ ⇸ univ);
  Printed_mi_radio : mi_radio s ∈ (univ ⇸ Rmas);
  Printed_mi_centro : mi_centro s ∈ (univ ⇸ univ);
  Printed_mi_vector : mi_vector s ∈ (univ ⇸ univ);
  Printed_mi_proporcion : mi_proporcion s ∈ (univ ⇸ Rmas);
  Printed_mi_altura : mi_altura s ∈ (univ ⇸ Rmas);
  Printed_1 : elementos s ≡ dom (de_que_tipo s);
  Printed_2 : elementos s ≡ dom (mi_centro s);
  Printed_3 : dom (mi_radio s) ⊆ elementos s;
  Printed_4 : dom (mi_vector s) ⊆ elementos s;
  Printed_5 : tipos s ≡ ran (de_que_tipo s)
}.

Definition printed_types : set Tipo := ⦃soy_esfera⦄ ∪ ⦃soy_cilindro⦄ ∪ ⦃soy_cono⦄.

(** The corrected invariant is the stronger one, of a scene of the printed types. *)
Theorem corrected_implies_printed s : Escena_ok s -> ran (de_que_tipo s) ⊆ printed_types -> Printed_ok s.
Proof.
  intros ok P. split; try apply ok; intros x;
    [split | intros H; now apply (element_of_radio _ _ ok) | intros H; now apply (element_of_vector _ _ ok)].
  - intros He. destruct (type_of_element _ _ ok x He) as [t Ht]. apply (has_centro _ _ ok x t Ht).
    assert (T : ran (de_que_tipo s) t) by now exists x. apply P in T as [[-> | ->] | ->]; cbv; tauto.
  - intros H. now apply (element_of_centro _ _ ok).
Qed.

Lemma empty_ok : Escena_ok (empty_scene Elemento).
Proof. apply empty_scene_Init. Qed.
Lemma empty_printed : Printed_ok (empty_scene Elemento).
Proof. apply corrected_implies_printed; [exact empty_ok | now intros t [x []]]. Qed.

(** E07: a scene that satisfies the printed invariant may hold a cylinder with neither radius nor height. *)
Theorem E07_undefined_attribute x c :
  exists s, Printed_ok s /\ (x, soy_cilindro) ∈ de_que_tipo s /\ x ∉ dom (mi_radio s) /\ x ∉ dom (mi_altura s).
Proof.
  pose proof empty_printed as P.
  exists (scene_with _ (empty_scene _) x soy_cilindro ⦃c⦄ ∅ ∅ ∅ ∅ ∅).
  assert (N : forall X, dom (∅ ∪ at_one x (∅ : set X)) x -> False) by now intros X [y [[] | [_ []]]].
  assert (F : forall X (B : set X), ∅ ∪ at_one x ∅ ∈ (univ ⇸ B)).
  { intros X B. rewrite at_one_empty. split; [now intros ? ? ? [] | split; [easy | now intros ? [? []]]]. }
  assert (G : forall X (v : X), ∅ ∪ at_one x ⦃v⦄ ∈ (univ ⇸ univ)).
  { intros X v. split; [| easy]. intros a b b' [[] | [_ H]] [[] | [_ H']]. cbn in *. unfold single in *. congruence. }
  split; [split; cbn; auto | split; [now right | split; intros H; exact (N _ H)]].
  - rewrite <- at_one_single. apply G.
  - intros y. rewrite dom_union_single. split; [intros [[] | H]; now right | intros [[t []] | H]; now right].
  - intros y. split; [intros [[] | ->]; exists c; right; now split | intros [v [[] | [H _]]]; now right].
  - intros y [v [[] | [_ []]]].
  - intros y [v [[] | [_ []]]].
  - reflexivity.
Qed.

(** E20: with total functions every name is an element already, and nothing can be added. *)
Theorem E20_nothing_to_add s : elementos s ≡ dom (de_que_tipo s) -> dom (de_que_tipo s) ≡ univ ->
  forall e, ~ (e ∉ elementos s).
Proof. intros H1 H2 e He. apply He, H1, H2. exact I. Qed.

(** ** The operations *)

Record Printed_Agregar_Elemento s s' e (t : Tipo) (r_out : Respuesta) : Prop := {
  printed_add_delta : Printed_ok s /\ Printed_ok s';
  printed_add_pre : e ∉ elementos s;
  printed_add_post_1 : elementos s' ≡ elementos s ∪ ⦃e⦄;
  printed_add_post_2 : de_que_tipo s' ≡ de_que_tipo s ∪ ⦃(e, t)⦄
}.
Record Printed_Eliminar_Elemento s s' e (r_out : Respuesta) : Prop := {
  printed_remove_delta : Printed_ok s /\ Printed_ok s';
  printed_remove_pre : e ∈ elementos s;
  printed_remove_post_1 : elementos s' ≡ elementos s ∖ ⦃e⦄;
  printed_remove_post_2 : de_que_tipo s' ≡ dres ⦃e⦄ (de_que_tipo s)
}.
Record Printed_Agregar_Esfera s s' e (t : Tipo) (r_out : Respuesta) c r : Prop := {
  printed_esfera_add : Printed_Agregar_Elemento s s' e t r_out;
  printed_esfera_type : t = soy_esfera;
  printed_esfera_centro : mi_centro s' ≡ mi_centro s ∪ ⦃(e, c)⦄;
  printed_esfera_radio : mi_radio s' ≡ mi_radio s ∪ ⦃(e, r)⦄;
  printed_esfera_answer : r_out = esfera_agregada
}.
Record Printed_Agregar_Cilindro s s' e (t : Tipo) (r_out : Respuesta) c r d h : Prop := {
  printed_cilindro_add : Printed_Agregar_Elemento s s' e t r_out;
  printed_cilindro_type : t = soy_cilindro;
  printed_cilindro_centro : mi_centro s' ≡ mi_centro s ∪ ⦃(e, c)⦄;
  printed_cilindro_radio : mi_radio s' ≡ mi_radio s ∪ ⦃(e, r)⦄;
  printed_cilindro_vector : mi_vector s' ≡ mi_vector s ∪ ⦃(e, d)⦄;
  printed_cilindro_altura : mi_altura s' ≡ mi_altura s ∪ ⦃(e, h)⦄;
  printed_cilindro_answer : r_out = cilindro_agregado
}.
Record Printed_Agregar_Cono s s' e (t : Tipo) (r_out : Respuesta) c k d h : Prop := {
  printed_cono_add : Printed_Agregar_Elemento s s' e t r_out;
  printed_cono_type : t = soy_cono;
  printed_cono_centro : mi_centro s' ≡ mi_centro s ∪ ⦃(e, c)⦄;
  printed_cono_proporcion : mi_proporcion s' ≡ mi_proporcion s ∪ ⦃(e, k)⦄;
  printed_cono_vector : mi_vector s' ≡ mi_vector s ∪ ⦃(e, d)⦄;
  printed_cono_altura : mi_altura s' ≡ mi_altura s ∪ ⦃(e, h)⦄;
  printed_cono_answer : r_out = cono_agregado
}.
Record Printed_Eliminar_Esfera s s' e (r_out : Respuesta) : Prop := {
  printed_no_esfera_remove : Printed_Eliminar_Elemento s s' e r_out;
  printed_no_esfera_centro : mi_centro s' ≡ dres ⦃e⦄ (mi_centro s);
  printed_no_esfera_radio : mi_radio s' ≡ dres ⦃e⦄ (mi_radio s);
  printed_no_esfera_answer : r_out = esfera_eliminada
}.
Record Printed_Eliminar_Cilindro s s' e (r_out : Respuesta) : Prop := {
  printed_no_cilindro_remove : Printed_Eliminar_Elemento s s' e r_out;
  printed_no_cilindro_centro : mi_centro s' ≡ dres ⦃e⦄ (mi_centro s);
  printed_no_cilindro_radio : mi_radio s' ≡ dres ⦃e⦄ (mi_radio s);
  printed_no_cilindro_vector : mi_vector s' ≡ dres ⦃e⦄ (mi_vector s);
  printed_no_cilindro_altura : mi_altura s' ≡ dres ⦃e⦄ (mi_altura s);
  printed_no_cilindro_answer : r_out = cilindro_eliminado
}.
Record Printed_Eliminar_Cono s s' e (r_out : Respuesta) : Prop := {
  printed_no_cono_remove : Printed_Eliminar_Elemento s s' e r_out;
  printed_no_cono_centro : mi_centro s' ≡ dres ⦃e⦄ (mi_centro s);
  printed_no_cono_vector : mi_vector s' ≡ dres ⦃e⦄ (mi_vector s);
  printed_no_cono_altura : mi_altura s' ≡ dres ⦃e⦄ (mi_altura s);
  printed_no_cono_proporcion : mi_proporcion s' ≡ dres ⦃e⦄ (mi_proporcion s);
  printed_no_cono_answer : r_out = cono_eliminado
}.

(** E05: with the general answer as well, which the included schemas print, none of the six operations has an
    after-state. *)
Theorem E05_no_after_state s s' e t r_out c r d h k :
  ~ (Printed_Agregar_Esfera s s' e t r_out c r /\ r_out = elemento_agregado)
  /\ ~ (Printed_Agregar_Cilindro s s' e t r_out c r d h /\ r_out = elemento_agregado)
  /\ ~ (Printed_Agregar_Cono s s' e t r_out c k d h /\ r_out = elemento_agregado)
  /\ ~ (Printed_Eliminar_Esfera s s' e r_out /\ r_out = elemento_eliminado)
  /\ ~ (Printed_Eliminar_Cilindro s s' e r_out /\ r_out = elemento_eliminado)
  /\ ~ (Printed_Eliminar_Cono s s' e r_out /\ r_out = elemento_eliminado).
Proof. repeat split; intros [H ->]; destruct H; discriminate. Qed.

Definition axis_z : Vector := mk_Vector 0 0 1.
Lemma axis_z_unit : axis_z ∈ Unitario.
Proof. unfold Unitario, tolerancia_unidad, axis_z; cbn. lra. Qed.

(** E06: the printed Agregar_Esfera, even without the double answer, allows that adding a sphere stretches a cylinder,
    between two scenes that satisfy the corrected invariant. *)
Theorem E06_another_element_changes x e c : x <> e ->
  exists s s', Escena_ok s /\ Escena_ok s' /\ Printed_Agregar_Esfera s s' e soy_esfera esfera_agregada c 1
    /\ (x, 1) ∈ mi_altura s /\ (x, 2) ∈ mi_altura s'.
Proof.
  intros Hx. set (cyl h := with_cilindro _ (empty_scene _) x c 1 axis_z h).
  assert (A : forall h, 0 < h -> Escena_ok (cyl h)).
  { intros h Hh. apply with_cilindro_ok; try exact axis_z_unit; try (unfold Rmas; lra); [apply empty_ok | now intros []]. }
  assert (N : e ∉ elementos (cyl 2)) by (intros [[] | E]; now apply Hx).
  assert (B : Escena_ok (with_esfera _ (cyl 2) e c 1)).
  { apply with_esfera_ok; [apply A; lra | exact N | unfold Rmas; lra]. }
  exists (cyl 1), (with_esfera _ (cyl 2) e c 1).
  split; [apply A; lra | split; [exact B |]]. split; [| cbn; unfold union, at_one, single; cbn; auto].
  split; cbn -[cyl]; rewrite ?at_one_single; try reflexivity. split; try reflexivity; [| exact N].
  split; (apply corrected_implies_printed; [first [exact B | apply A; lra] |]); intros t [y H]; cbn in H;
    unfold union, single, printed_types, empty in *; decompose [or] H; try contradiction;
    repeat match goal with E : _ = _ |- _ => injection E as _ -> end; cbv; tauto.
Qed.

(** E09: a cylinder removed as a sphere, every other component staying as it was, leaves its axis and its height behind;
    that breaks the printed invariant by the axis and the corrected one by both. *)
Theorem E09_wrong_type_leaves_attributes s s' e c r d h : Escena_ok s -> is_cilindro _ s e c r d h ->
  elementos s' ≡ elementos s ∖ ⦃e⦄ -> mi_vector s' ≡ mi_vector s -> mi_altura s' ≡ mi_altura s ->
  (e, d) ∈ mi_vector s' /\ (e, h) ∈ mi_altura s' /\ ~ Printed_ok s' /\ ~ Escena_ok s'.
Proof.
  intros ok [_ [_ [_ [Hd Hh]]]] E V A.
  assert (N : e ∉ elementos s') by (intros He; apply E in He as [_ He]; now apply He).
  assert (D : e ∈ dom (mi_vector s')) by (exists d; now apply V).
  split; [now apply V | split; [now apply A |]]. split; [intros P; now apply N, (Printed_4 _ P) |].
  intros ok'. now apply N, (element_of_vector _ _ ok').
Qed.

(** E19: with restriction in the place of subtraction, nothing can be removed. *)
Theorem E19_no_removal s s' e r_out : ~ Printed_Eliminar_Elemento s s' e r_out.
Proof.
  intros [[P P'] He E T]. assert (N : e ∈ elementos s').
  { apply (Printed_1 _ P'). apply (Printed_1 _ P) in He as [t Ht]. exists t. apply T. now split. }
  apply E in N as [_ N]. now apply N.
Qed.

(** E33: the printed invariant lets a name outside the scene keep a height, and then the cylinder of that name with
    another height cannot be added. *)
Theorem E33_leftover_height_blocks_addition e :
  (exists s, Printed_ok s /\ e ∉ elementos s /\ (e, 1) ∈ mi_altura s)
  /\ forall s s' t r_out c r d, Printed_ok s -> (e, 1) ∈ mi_altura s ->
     ~ Printed_Agregar_Cilindro s s' e t r_out c r d 2.
Proof.
  split.
  - exists (mk_Escena ∅ ∅ ∅ ∅ ∅ ∅ ⦃(e, 1)⦄ ∅ ∅).
    pose proof empty_printed as []. cbn in *.
    split; [split; cbn; auto | split; [intros [] | reflexivity]]. split; [| split; [easy |]].
    + now intros a b b' [= -> ->] [= ->].
    + intros b [a [= _ ->]]. unfold Rmas. lra.
  - intros s s' t r_out c r d P H [[[_ P'] _ _ _] _ _ _ _ A _].
    destruct (Printed_mi_altura _ P') as [F _]. assert (E : 1 = 2); [| lra]. apply F with e; apply A; [now left | now right].
Qed.

(** ** The points *)

(** E25: the printed points of a scene of the printed types, whose last branch is then unreachable, are those of the
    corrected text. *)
Definition printed_puntos_de_escena s : set Punto := fun w =>
  exists e t, e ∈ elementos s /\ (e, t) ∈ de_que_tipo s /\
    match t with
    | soy_esfera => exists c r, (e, c) ∈ mi_centro s /\ (e, r) ∈ mi_radio s /\ w ∈ puntos_esfera c r
    | soy_cilindro => exists c r d h, (e, c) ∈ mi_centro s /\ (e, r) ∈ mi_radio s /\ (e, d) ∈ mi_vector s
        /\ (e, h) ∈ mi_altura s /\ w ∈ puntos_cilindro c r d h
    | soy_cono => exists c k d h, (e, c) ∈ mi_centro s /\ (e, k) ∈ mi_proporcion s /\ (e, d) ∈ mi_vector s
        /\ (e, h) ∈ mi_altura s /\ w ∈ puntos_cono c k d h
    | _ => False
    end.
Theorem E25_same_points s : ran (de_que_tipo s) ⊆ printed_types -> printed_puntos_de_escena s ≡ puntos_de_escena s.
Proof.
  intros P w. split.
  - intros [e [t [He [Ht H]]]]. exists e. split; [exact He | split; [exact He |]]. exists t. split; [exact Ht |].
    destruct t; try contradiction; repeat first [left; now split | right; split; [discriminate |]].
  - intros [e [He [_ [t [Ht H]]]]]. exists e, t. split; [exact He | split; [exact Ht |]].
    assert (T : ran (de_que_tipo s) t) by now exists e. apply P in T as [[-> | ->] | ->];
      repeat match type of H with _ \/ _ => destruct H as [[? H] | [? H]]; [try discriminate | try easy] end; exact H.
Qed.

End Errata.

(** E10: the printed cylinder is the one of radius √radio, and unless the radius is 1 it has no point in common with the
    one that is meant, which has points. *)
Definition printed_puntos_cilindro c r d h : set Punto := fun w =>
  alejamiento w c d - r = 0 /\ 0 <= avance w c d <= h.
Theorem E10_other_surface c r d h : r > 0 ->
  printed_puntos_cilindro c r d h ≡ puntos_cilindro c (sqrt r) d h
  /\ (r <> 1 -> forall w, w ∈ printed_puntos_cilindro c r d h -> w ∉ puntos_cilindro c r d h)
  /\ (h > 0 -> exists w, w ∈ puntos_cilindro c r axis_z h).
Proof.
  intros Hr. split; [| split].
  - intros w. unfold printed_puntos_cilindro, puntos_cilindro, potencia_cilindro, cuadrado.
    now rewrite sqrt_sqrt by lra.
  - intros N w [H _] [H' _]. unfold potencia_cilindro, cuadrado in H'. apply N.
    apply Rmult_eq_reg_l with r; lra.
  - intros Hh. exists (mk_Punto (Punto_x c + r) (Punto_y c) (Punto_z c)).
    unfold puntos_cilindro, potencia_cilindro, alejamiento, avance, cuadrado; cbn. split; [ring | lra].
Qed.

(** E11: the printed cone is the plane s = h across the axis. *)
Definition printed_puntos_cono c k d h : set Punto := fun w =>
  k * avance w c d - h * k = 0 /\ 0 <= avance w c d <= h.
Theorem E11_plane c k d h : k > 0 -> h > 0 -> printed_puntos_cono c k d h ≡ (fun w => avance w c d = h).
Proof.
  intros Hk Hh w. split.
  - intros [H _]. apply Rmult_eq_reg_l with k; lra.
  - intros E. unfold printed_puntos_cono. rewrite E. split; lra.
Qed.

(** E34: a > that means the order on the integers only, as in Z's toolkit, agrees with > there, satisfies all that the
    text says of <=, and leaves the positive reals without 1/2. Every choice between is as right. *)
Definition integers_only (a b : R) : Prop := (exists m, a = IZR m) /\ (exists n, b = IZR n) /\ a > b.
Theorem E34_strict_order_on_integers_only :
  (forall m n : Z, integers_only (IZR m) (IZR n) <-> (m > n)%Z) /\ ~ integers_only (1 / 2) 0 /\ 1 / 2 > 0.
Proof.
  split; [| split; [| lra]].
  - intros m n. unfold integers_only. split.
    + intros [_ [_ H]]. apply Z.lt_gt, lt_IZR. lra.
    + intros H. repeat split; eauto. apply IZR_lt. lia.
  - intros [[m H] _]. assert (E : IZR (2 * m) = 1) by (rewrite mult_IZR; lra). apply eq_IZR in E. lia.
Qed.

(** E35: an addition that is the integers' own there, and elsewhere holds of every third number, is no function; one that
    holds elsewhere of no number is none of the reals. *)
Definition sum_if (other : Prop) (a b c : R) : Prop :=
  (exists m n, a = IZR m /\ b = IZR n /\ c = a + b) \/ (~ (exists m n, a = IZR m /\ b = IZR n) /\ other).
Theorem E35_sums_of_integers_only (other : Prop) :
  (forall m n c, sum_if other (IZR m) (IZR n) c <-> c = IZR (m + n))
  /\ (other -> forall c, sum_if other (1 / 2) (1 / 2) c) /\ (~ other -> forall c, ~ sum_if other (1 / 2) (1 / 2) c).
Proof.
  assert (half : ~ exists m n, 1 / 2 = IZR m /\ 1 / 2 = IZR n).
  { intros [m [_ [H _]]]. assert (E : IZR (2 * m) = 1) by (rewrite mult_IZR; lra). apply eq_IZR in E. lia. }
  unfold sum_if. split; [| split].
  - intros m n c. rewrite plus_IZR. split.
    + intros [[p [q [Hp [Hq ->]]]] | [H _]]; [reflexivity |]. destruct H. now exists m, n.
    + intros ->. left. now exists m, n.
  - intros H c. now right.
  - intros N c [[m [n [Hm [Hn _]]]] | [_ H]]; [apply half; now exists m, n | exact (N H)].
Qed.

(** E12: a ray whose direction is null is the point it starts at. *)
Theorem E12_null_ray_is_a_point q : puntos_de_rayo (mk_Rayo q (mk_Vector 0 0 0)) ≡ ⦃q⦄.
Proof.
  intros w. rewrite puntos_de_rayo_parameter. unfold single.
  assert (E : forall t, point_at (mk_Rayo q (mk_Vector 0 0 0)) t = q).
  { intros t. destruct q. unfold point_at; cbn. f_equal; ring. }
  split; [intros [t [_ ->]]; apply E | intros ->]. exists 1. split; [lra | now rewrite E].
Qed.

(** E13: the function that gives ∅ for every pair satisfies the printed description, and is not the intersection. *)
Theorem E13_another_function : let f (ps qs : set Punto) : set Punto := ∅ in
  (exists ps qs, f ps qs ≡ ps ∩ qs) /\ ~ forall ps qs, f ps qs ≡ interseccion ps qs.
Proof.
  split.
  - exists ∅, ∅. intros w. unfold inter, empty. tauto.
  - intros H. apply (H univ univ (mk_Punto 0 0 0)). now split.
Qed.

(** E14: the printed description, t being the minimum of the one distance of temp, describes nothing where the set has
    two points other than the eye. *)
Theorem E14_no_description (ps : set Punto) ojo a b : a <> b -> ps a -> ps b -> 0 < distancia a ojo -> 0 < distancia b ojo ->
  ~ exists w, is_mu (fun temp => temp ∈ ps /\ exists t, t ∈ Rmas /\ is_least ⦃distancia temp ojo⦄ t) w.
Proof.
  intros N Ha Hb Da Db [w [_ U]]. apply N. transitivity w; [| symmetry].
  - apply U. split; [exact Ha |]. exists (distancia a ojo). split; [exact Da | split; [reflexivity |]].
    intros t' ->. apply Rle_refl.
  - apply U. split; [exact Hb |]. exists (distancia b ojo). split; [exact Db | split; [reflexivity |]].
    intros t' ->. apply Rle_refl.
Qed.

(** E23: on a ray two nearest points are one, which the corrected text relies on. *)
Theorem E23_nearest_on_a_ray_is_unique ray (ps : set Punto) a b : Rayo_ok ray -> ps ⊆ puntos_de_rayo ray ->
  (ps a /\ forall otro, ps otro -> distancia a (Rayo_p ray) <= distancia otro (Rayo_p ray)) ->
  (ps b /\ forall otro, ps otro -> distancia b (Rayo_p ray) <= distancia otro (Rayo_p ray)) -> a = b.
Proof.
  intros ok Hps Ha Hb.
  destruct (proj1 (puntos_de_rayo_parameter _ _) (Hps a (proj1 Ha))) as [ta [Hta ->]].
  destruct (proj1 (puntos_de_rayo_parameter _ _) (Hps b (proj1 Hb))) as [tb [Htb ->]].
  f_equal. apply least_unique with (parameters ray ps); now apply nearest_is_least.
Qed.

(** E22: infinitely many spheres, the n-th first met at 1 + 1/(n+1): the ray meets all of them, and none first. *)
Definition accumulating_scene : Especificacion.Escena nat := {|
  elementos := univ; tipos := ⦃soy_esfera⦄; de_que_tipo := fun p => snd p = soy_esfera;
  mi_centro := fun p => snd p = mk_Punto (2 + / INR (S (fst p))) 0 0; mi_radio := fun p => snd p = 1;
  mi_vector := ∅; mi_altura := ∅; mi_proporcion := ∅; mi_vertices := ∅ |}.
Definition ray_x : Rayo := mk_Rayo (mk_Punto 0 0 0) (mk_Vector 1 0 0).

Theorem E22_no_first_of_infinitely_many :
  Printed_ok nat accumulating_scene /\ Rayo_ok ray_x
  /\ ~ (alcances accumulating_scene ray_x ∅ ≡ ∅)
  /\ (alcances accumulating_scene ray_x ∅, Rayo_p ray_x) ∉ dom reduccion.
Proof.
  assert (okx : Rayo_ok ray_x) by (split; cbn; lra).
  assert (Hpos : forall n, 0 < / INR (S n)) by (intros n; apply Rinv_0_lt_compat, lt_0_INR; lia).
  assert (M : forall n t, 0 < t -> t = 1 + / INR (S n) -> alcances accumulating_scene ray_x ∅ (point_at ray_x t)).
  { intros n t Ht E. exists n. split; [exact I | split; [exact I | split]].
    - apply puntos_de_rayo_parameter. now exists t.
    - right. split; [intros [] |]. split; [exact I |]. exists soy_esfera. split; [reflexivity |]. left.
      split; [reflexivity |]. exists (mk_Punto (2 + / INR (S n)) 0 0), 1. repeat split.
      unfold puntos_esfera, potencia_esfera, cuadrado, point_at; cbn [Punto_x Punto_y Punto_z Vector_x Vector_y Vector_z
        Rayo_p Rayo_v ray_x]. rewrite E. ring. }
  assert (L : forall t, 0 < t -> alcances accumulating_scene ray_x ∅ (point_at ray_x t) -> 1 < t).
  { intros t Ht [n [_ [_ [_ [[[] _] | [_ [_ [ti [-> H]]]]]]]]].
    destruct H as [[_ [c [r [-> [-> H]]]]] | [N _]]; [| easy]. specialize (Hpos n).
    unfold puntos_esfera, potencia_esfera, cuadrado, point_at in H; cbn [Punto_x Punto_y Punto_z Vector_x Vector_y
      Vector_z Rayo_p Rayo_v ray_x fst snd] in H. set (u := / INR (S n)) in *.
    assert (F : (t - (1 + u)) * (t - (3 + u)) = 0) by lra. apply Rmult_integral in F. lra. }
  split; [split; cbn | split; [exact okx | split]].
  - split; [intros a b b' H H'; cbn in *; congruence | easy].
  - split; [intros a b b' H H'; cbn in *; congruence | split; [easy |]]. intros b [a H]. cbn in H. rewrite H. unfold Rmas. lra.
  - split; [intros a b b' H H'; cbn in *; congruence | easy].
  - split; [now intros a b b' [] | easy].
  - split; [now intros a b b' [] | split; [easy | now intros b [a []]]].
  - split; [now intros a b b' [] | split; [easy | now intros b [a []]]].
  - intros n. split; [| easy]. intros _. now exists soy_esfera.
  - intros n. split; [| easy]. intros _. unfold dom. cbn [fst snd]. eexists. reflexivity.
  - easy.
  - now intros n [v []].
  - intros t. split; [intros H; now exists O | now intros [n Hn]].
  - intros E. apply (E (point_at ray_x (1 + / INR 1))). apply (M O); [specialize (Hpos O); lra | reflexivity].
  - intros [w H]. apply (reduccion_on_ray ray_x okx) in H as [t [_ [[Ht Hm] Hl]]].
    2: { intros y [n [_ [_ [Hy _]]]]. exact Hy. }
    specialize (L t Ht Hm). destruct (archimed_cor1 (t - 1)) as [n [Hn Hn0]]; [lra |].
    assert (B : t <= 1 + / INR (S (pred n))).
    { apply Hl. split; [specialize (Hpos (pred n)); lra |]. apply (M (pred n)); [specialize (Hpos (pred n)); lra | reflexivity]. }
    replace (S (pred n)) with n in B by lia. lra.
Qed.
