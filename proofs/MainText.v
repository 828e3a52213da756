(** What is proved of the Z text and of its mathematics, and nothing else: each statement in full, each proof a reference to
    where it is done. MainModels.v goes on with the oracle, the tables and acceleration, Main.v with the program.

    Names and glossaries: Especificacion.v is the Z text; Toolkit.v its sets (∈, ≡, ⇸, ∖, dom, …). For a scene s and a ray:
    Escena_ok s          == s satisfies the invariant of the text
    point_at ray t       == the point p + t·v
    of_esfera, of_cilindro, of_cono, of_tronco, of_plano, of_disco, of_triangulo == the coefficients of A·t² + 2B·t + C,
                            and the bounds that clip it, each a condition a·t² + 2b·t + c ≤ 0
    proper f             == the bounds of f are convex: no a is negative
    roots f              == the computed solutions;  reach f == the parameters t > 0 that solve f within its clip
    linear_roots a0 a1 S == S are the solutions of a0 + a1·t = 0: one quotient, none, or the whole line
    normal abc           == (b − a) × (c − a), for the vertices abc of a triangle
    on_rim c r d w, top c d h == w is on the disc at the distance r from its centre;  the point c + h·d
    combination abc β γ, toward p q λ, vertex abc p == a + β·(b − a) + γ·(c − a);  p + λ·(q − p);  p is a, b or c
    met ray s en e       == the parameters t > 0 at which the ray meets the element e, the ray starting on the elements en
    met_scene ray s en   == the same for the whole scene
    is_least T t         == t is the least of T;  starts_in T == T holds every parameter from 0 up to some ε > 0 *)
From Coq Require Import Reals List.
From Durero Require Import Toolkit Especificacion.
From Durero Require Tipos Escena Operaciones Edits Totals Errata Puntos Trazador Flat Interseccion Printed Retrieve
  Iluminacion Power Luz Sheets Haces Distribuida Proyeccion Distancias.
Import Escena Operaciones Edits Totals Errata Puntos Trazador Flat Interseccion Printed Retrieve Iluminacion.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** * 0. What the text assumes of the reals is so of Coq's, with Coq's own order and operations *)

Theorem the_reals_are_those_of_the_text :
  real_axiom_1 /\ real_axiom_2 /\ real_axiom_3 /\ real_axiom_4 /\ real_axiom_5 /\ real_axiom_6 /\ real_axiom_7
  /\ real_axiom_8 /\ real_axiom_9.
Proof. exact Tipos.reals_of_the_text. Qed.

(** * 1. The scene and its operations *)
Section Scenes.
Variable Elemento : Type.
Notation Escena := (Escena Elemento).
Implicit Types (s : Escena) (e : Elemento).

Theorem the_first_scene_exists : exists s, Init s.
Proof. destruct (Init_exists Elemento) as [s [_ H]]. now exists s. Qed.

(** The precondition of each operation, computed, is exactly its stated clauses. *)
Theorem preconditions_are_as_stated s e t c r d h k abc :
  ((exists s' r_out, Agregar_Esfera s s' e t r_out c r) <->
     Escena_ok s /\ e ∉ elementos s /\ t = soy_esfera /\ r ∈ Rmas)
  /\ ((exists s' r_out, Agregar_Cilindro s s' e t r_out c r d h) <->
     Escena_ok s /\ e ∉ elementos s /\ t = soy_cilindro /\ r ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas)
  /\ ((exists s' r_out, Agregar_Cono s s' e t r_out c k d h) <->
     Escena_ok s /\ e ∉ elementos s /\ t = soy_cono /\ k ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas)
  /\ ((exists s' r_out, Agregar_Tronco s s' e t r_out c r k d h) <->
     Escena_ok s /\ e ∉ elementos s /\ t = soy_tronco /\ r ∈ Rmas /\ k ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas)
  /\ ((exists s' r_out, Agregar_Plano s s' e t r_out c d) <->
     Escena_ok s /\ e ∉ elementos s /\ t = soy_plano /\ d ∈ Unitario)
  /\ ((exists s' r_out, Agregar_Disco s s' e t r_out c r d) <->
     Escena_ok s /\ e ∉ elementos s /\ t = soy_disco /\ r ∈ Rmas /\ d ∈ Unitario)
  /\ ((exists s' r_out, Agregar_Triangulo s s' e t r_out abc) <->
     Escena_ok s /\ e ∉ elementos s /\ t = soy_triangulo /\ abc ∈ Vertices)
  /\ ((exists s' r_out, Eliminar_Esfera s s' e r_out) <-> Escena_ok s /\ (e, soy_esfera) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Eliminar_Cilindro s s' e r_out) <-> Escena_ok s /\ (e, soy_cilindro) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Eliminar_Cono s s' e r_out) <-> Escena_ok s /\ (e, soy_cono) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Eliminar_Tronco s s' e r_out) <-> Escena_ok s /\ (e, soy_tronco) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Eliminar_Plano s s' e r_out) <-> Escena_ok s /\ (e, soy_plano) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Eliminar_Disco s s' e r_out) <-> Escena_ok s /\ (e, soy_disco) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Eliminar_Triangulo s s' e r_out) <-> Escena_ok s /\ (e, soy_triangulo) ∈ de_que_tipo s).
Proof.
  exact (conj (pre_Agregar_Esfera _ s e t c r) (conj (pre_Agregar_Cilindro _ s e t c r d h)
    (conj (pre_Agregar_Cono _ s e t c k d h) (conj (pre_Agregar_Tronco _ s e t c r k d h)
    (conj (pre_Agregar_Plano _ s e t c d) (conj (pre_Agregar_Disco _ s e t c r d)
    (conj (pre_Agregar_Triangulo _ s e t abc) (pre_Eliminar _ s e)))))))).
Qed.

(** The clauses that state the after-state already give the invariant: for each operation of one type. *)
Theorem operations_preserve_the_invariant s e c r d h k abc : Escena_ok s ->
  (e ∉ elementos s -> r ∈ Rmas -> Escena_ok (with_esfera _ s e c r))
  /\ (e ∉ elementos s -> r ∈ Rmas -> d ∈ Unitario -> h ∈ Rmas -> Escena_ok (with_cilindro _ s e c r d h))
  /\ (e ∉ elementos s -> k ∈ Rmas -> d ∈ Unitario -> h ∈ Rmas -> Escena_ok (with_cono _ s e c k d h))
  /\ (e ∉ elementos s -> r ∈ Rmas -> k ∈ Rmas -> d ∈ Unitario -> h ∈ Rmas -> Escena_ok (with_tronco _ s e c r k d h))
  /\ (e ∉ elementos s -> d ∈ Unitario -> Escena_ok (with_plano _ s e c d))
  /\ (e ∉ elementos s -> r ∈ Rmas -> d ∈ Unitario -> Escena_ok (with_disco _ s e c r d))
  /\ (e ∉ elementos s -> abc ∈ Vertices -> Escena_ok (with_triangulo _ s e abc))
  /\ Escena_ok (scene_without _ s e).
Proof.
  intros ok. exact (conj (with_esfera_ok _ s e c r ok) (conj (with_cilindro_ok _ s e c r d h ok)
    (conj (with_cono_ok _ s e c k d h ok) (conj (with_tronco_ok _ s e c r k d h ok)
    (conj (with_plano_ok _ s e c d ok) (conj (with_disco_ok _ s e c r d ok) (conj (with_triangulo_ok _ s e abc ok)
    (scene_without_ok _ s e ok)))))))).
Qed.

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
Proof. exact (Totals.total_operations_are_total _ s e t c r d h k abc). Qed.

Theorem adding_then_removing_is_the_identity s s1 e t c r d h k abc r1 : Elemento_Agregado s s1 e t c r d h k abc r1 ->
  (exists s2 r2, Elemento_Eliminado s1 s2 e r2)
  /\ forall s2 r2, Elemento_Eliminado s1 s2 e r2 -> Escena_eq s s2.
Proof. exact (add_then_remove _ s s1 e t c r d h k abc r1). Qed.

Theorem an_edit_touches_one_element x s s' e t c r d h k abc r_out : x <> e ->
  Elemento_Agregado s s' e t c r d h k abc r_out \/ Elemento_Eliminado s s' e r_out -> same_at _ x s s'.
Proof. exact (others_untouched _ x s s' e t c r d h k abc r_out). Qed.
End Scenes.

(** * 2. Defects of the printed text (the others by number in Errata.v) *)

Theorem E05_no_after_state Elemento (s s' : Escena Elemento) e t r_out c r d h k :
  ~ (Printed_Agregar_Esfera _ s s' e t r_out c r /\ r_out = elemento_agregado)
  /\ ~ (Printed_Agregar_Cilindro _ s s' e t r_out c r d h /\ r_out = elemento_agregado)
  /\ ~ (Printed_Agregar_Cono _ s s' e t r_out c k d h /\ r_out = elemento_agregado)
  /\ ~ (Printed_Eliminar_Esfera _ s s' e r_out /\ r_out = elemento_eliminado)
  /\ ~ (Printed_Eliminar_Cilindro _ s s' e r_out /\ r_out = elemento_eliminado)
  /\ ~ (Printed_Eliminar_Cono _ s s' e r_out /\ r_out = elemento_eliminado).
Proof. exact (Errata.E05_no_after_state _ s s' e t r_out c r d h k). Qed.

Theorem E06_another_element_changes Elemento (x e : Elemento) c : x <> e ->
  exists s s', Escena_ok s /\ Escena_ok s' /\ Printed_Agregar_Esfera _ s s' e soy_esfera esfera_agregada c 1
    /\ (x, 1) ∈ mi_altura s /\ (x, 2) ∈ mi_altura s'.
Proof. exact (Errata.E06_another_element_changes _ x e c). Qed.

Theorem E09_wrong_type_leaves_attributes Elemento (s s' : Escena Elemento) e c r d h :
  Escena_ok s -> is_cilindro _ s e c r d h ->
  elementos s' ≡ elementos s ∖ ⦃e⦄ -> mi_vector s' ≡ mi_vector s -> mi_altura s' ≡ mi_altura s ->
  (e, d) ∈ mi_vector s' /\ (e, h) ∈ mi_altura s' /\ ~ Printed_ok _ s' /\ ~ Escena_ok s'.
Proof. exact (Errata.E09_wrong_type_leaves_attributes _ s s' e c r d h). Qed.

Theorem E10_other_surface c r d h : r > 0 ->
  printed_puntos_cilindro c r d h ≡ puntos_cilindro c (sqrt r) d h
  /\ (r <> 1 -> forall w, w ∈ printed_puntos_cilindro c r d h -> w ∉ puntos_cilindro c r d h)
  /\ (h > 0 -> exists w, w ∈ puntos_cilindro c r axis_z h).
Proof. exact (Errata.E10_other_surface c r d h). Qed.

Theorem E11_plane c k d h : k > 0 -> h > 0 -> printed_puntos_cono c k d h ≡ (fun w => avance w c d = h).
Proof. exact (Errata.E11_plane c k d h). Qed.

Theorem E14_no_description (ps : set Punto) ojo a b :
  a <> b -> ps a -> ps b -> 0 < distancia a ojo -> 0 < distancia b ojo ->
  ~ exists w, is_mu (fun temp => temp ∈ ps /\ exists t, t ∈ Rmas /\ is_least ⦃distancia temp ojo⦄ t) w.
Proof. exact (Errata.E14_no_description ps ojo a b). Qed.

(** * 3. The closed forms *)

(** A point of the ray is on the element exactly when its parameter is a computed root that passes the clip, for every
    axis, unit or not, any three vertices, and in every case of A, B and C. *)
Theorem closed_forms_are_sound_and_complete ray c r k d h abc t :
  (point_at ray t ∈ puntos_esfera c r <-> solves (roots (of_esfera ray c r)) t)
  /\ (point_at ray t ∈ puntos_cilindro c r d h <->
      solves (roots (of_cilindro ray c r d h)) t /\ within (of_cilindro ray c r d h) t)
  /\ (point_at ray t ∈ puntos_cono c k d h <->
      solves (roots (of_cono ray c k d h)) t /\ within (of_cono ray c k d h) t)
  /\ (point_at ray t ∈ puntos_tronco c r k d h <->
      solves (roots (of_tronco ray c r k d h)) t /\ within (of_tronco ray c r k d h) t)
  /\ (point_at ray t ∈ puntos_plano c d <-> solves (roots (of_plano ray c d)) t)
  /\ (point_at ray t ∈ puntos_disco c r d <->
      solves (roots (of_disco ray c r d)) t /\ within (of_disco ray c r d) t)
  /\ (point_at ray t ∈ puntos_triangulo abc <->
      solves (roots (of_triangulo ray abc)) t /\ within (of_triangulo ray abc) t).
Proof.
  rewrite <- !roots_correct. exact (conj (esfera_along _ _ _ _) (conj (cilindro_along _ _ _ _ _ _)
    (conj (cono_along _ _ _ _ _ _) (conj (tronco_along _ _ _ _ _ _ _) (conj (plano_along _ _ _ _)
    (conj (disco_along _ _ _ _ _) (triangulo_along _ _ _))))))).
Qed.

(** A plane, a disc and a triangle have one root where the ray is not parallel to them; otherwise none, or the whole
    line. *)
Theorem what_is_flat_has_one_root_none_or_the_whole_line ray c r d abc :
  let a0 := Tipos.dot (from c (Rayo_p ray)) d in let a1 := Tipos.dot (Rayo_v ray) d in
  let b0 := Tipos.dot (from (Terna_a abc) (Rayo_p ray)) (normal abc) in let b1 := Tipos.dot (Rayo_v ray) (normal abc) in
  linear_roots a0 a1 (roots (of_plano ray c d)) /\ linear_roots a0 a1 (roots (of_disco ray c r d))
  /\ linear_roots b0 b1 (roots (of_triangulo ray abc)).
Proof. exact (conj (roots_plano ray c d) (conj (roots_disco ray c r d) (roots_triangulo ray abc))). Qed.

Theorem stable_roots_are_the_textbook_ones f : cA f <> 0 -> 0 <= discriminant f -> stable_sum f <> 0 ->
  let plus := (- cB f + sqrt (discriminant f)) / cA f in
  let minus := (- cB f - sqrt (discriminant f)) / cA f in
  (stable_sum f / cA f = plus /\ cC f / stable_sum f = minus)
  \/ (stable_sum f / cA f = minus /\ cC f / stable_sum f = plus).
Proof. exact (stable_roots_are_textbook f). Qed.

(** With a and b the parts of v and q0 = p − c across the axis, g = h − q0·d, and ρ = r + k·g the radius at the ray's origin. *)
Theorem stable_discriminants ray c r k d h abc :
  let v := Rayo_v ray in let q := from c (Rayo_p ray) in let a := across d v in let b := across d q in
  let g := h - Tipos.dot q d in
  discriminant (of_esfera ray c r) = r * r * Tipos.sq v - Tipos.sq (cross q v)
  /\ discriminant (of_cilindro ray c r d h) = r * r * Tipos.sq a - Tipos.sq (cross b a)
  /\ discriminant (of_cono ray c k d h) = k * k * Tipos.sq (combine g a (Tipos.dot v d) b) - Tipos.sq (cross b a)
  /\ discriminant (of_tronco ray c r k d h)
     = Tipos.sq (combine (r + k * g) a (k * Tipos.dot v d) b) - Tipos.sq (cross b a)
  /\ discriminant (of_plano ray c d) = Tipos.dot v d / 2 * (Tipos.dot v d / 2)
  /\ discriminant (of_disco ray c r d) = Tipos.dot v d / 2 * (Tipos.dot v d / 2)
  /\ discriminant (of_triangulo ray abc) = Tipos.dot v (normal abc) / 2 * (Tipos.dot v (normal abc) / 2).
Proof.
  exact (conj (discriminant_esfera _ _ _) (conj (discriminant_cilindro _ _ _ _ _)
    (conj (discriminant_cono _ _ _ _ _) (conj (discriminant_tronco _ _ _ _ _ _) (conj (discriminant_plano _ _ _)
    (conj (discriminant_disco _ _ _ _) (discriminant_triangulo _ _))))))).
Qed.

Theorem the_bounds_of_every_type_are_convex ray c r k d h abc :
  proper (of_esfera ray c r) /\ proper (of_cilindro ray c r d h) /\ proper (of_cono ray c k d h)
  /\ proper (of_tronco ray c r k d h) /\ proper (of_plano ray c d) /\ proper (of_disco ray c r d)
  /\ proper (of_triangulo ray abc).
Proof.
  exact (conj (proper_esfera _ _ _) (conj (proper_cilindro _ _ _ _ _) (conj (proper_cono _ _ _ _ _)
    (conj (proper_tronco _ _ _ _ _ _) (conj (proper_plano _ _ _) (conj (proper_disco _ _ _ _)
    (proper_triangulo _ _))))))).
Qed.

Theorem at_most_two_points_or_a_segment f : proper f ->
  (exists t1 t2, forall t, reach f t -> t = t1 \/ t = t2)
  \/ ((forall t, value f t = 0) /\ forall a b t, reach f a -> reach f b -> a <= t <= b -> reach f t).
Proof. exact (two_points_or_a_segment f). Qed.

(** The first hit that the tracer computes of one element is right. *)
Theorem first_hit_of_an_element f : proper f -> is_first (reach f) (first f).
Proof. exact (first_correct f). Qed.

(** The program's form of a triangle, with T = p − a, E1 = b − a, E2 = c − a, P = v × E2, Q = T × E1 and det = E1·P: the
    root is E2·Q/det; there the sides of the text times det are |n|² times v·Q, T·P and det − T·P − v·Q; so these have the
    signs of the sides, times that of det, and clip as the text does. *)
Theorem the_program_clips_a_triangle_as_the_text_does ray abc :
  let a := Terna_a abc in let b := Terna_b abc in let c := Terna_c abc in let v := Rayo_v ray in
  let T := from a (Rayo_p ray) in let E1 := from a b in let E2 := from a c in
  let P := cross v E2 in let Q := cross T E1 in let det := Tipos.dot E1 P in let n2 := Tipos.sq (normal abc) in
  let w := point_at ray (Tipos.dot E2 Q / det) in
  (forall t, potencia_triangulo (point_at ray t) abc = Tipos.dot E2 Q - t * det)
  /\ (det <> 0 ->
      (forall t, potencia_triangulo (point_at ray t) abc = 0 <-> t = Tipos.dot E2 Q / det)
      /\ lado w a b c * det = n2 * Tipos.dot v Q
      /\ lado w c a b * det = n2 * Tipos.dot T P
      /\ lado w b c a * det = n2 * (det - Tipos.dot T P - Tipos.dot v Q)
      /\ (w ∈ prisma abc <->
          0 <= Tipos.dot v Q * det /\ 0 <= (det - Tipos.dot T P - Tipos.dot v Q) * det /\ 0 <= Tipos.dot T P * det)).
Proof. exact (program_of_a_triangle ray abc). Qed.

(** What discs close: the base for every axis, unit or not; the top for an axis that is a unit vector exactly. *)
Theorem discs_close_cylinders_and_cones w c r k d h : 0 <= h ->
  (on_rim c r d w <-> w ∈ puntos_cilindro c r d h /\ avance w c d = 0)
  /\ (on_rim c (k * h) d w <-> w ∈ puntos_cono c k d h /\ avance w c d = 0)
  /\ (on_rim c (r + k * h) d w <-> w ∈ puntos_tronco c r k d h /\ avance w c d = 0)
  /\ (Tipos.sq d = 1 ->
      (on_rim (top c d h) r d w <-> w ∈ puntos_cilindro c r d h /\ avance w c d = h)
      /\ (on_rim (top c d h) r d w <-> w ∈ puntos_tronco c r k d h /\ avance w c d = h)).
Proof. exact (discs_close w c r k d h). Qed.

Theorem a_triangle_is_the_convex_combinations_of_its_vertices abc w : abc ∈ Vertices ->
  (w ∈ puntos_triangulo abc <->
   exists beta gamma, 0 <= beta /\ 0 <= gamma /\ beta + gamma <= 1 /\ w = combination abc beta gamma).
Proof. exact (triangle_is_the_convex_combinations abc w). Qed.

Theorem triangles_share_the_edge_between_common_vertices abc abc' p q l :
  vertex abc p -> vertex abc q -> vertex abc' p -> vertex abc' q -> 0 <= l <= 1 ->
  toward p q l ∈ puntos_triangulo abc ∩ puntos_triangulo abc'.
Proof. exact (triangles_share_their_edge abc abc' p q l). Qed.

(** * 4. The first hit of a scene *)
Section FirstHit.
Variable ray : Rayo.
Hypothesis ray_ok : Rayo_ok ray.

Theorem nearest_point_exists_iff_infimum_attained ps : ps ⊆ puntos_de_rayo ray ->
  ((ps, Rayo_p ray) ∈ dom reduccion <->
   (exists w, w ∈ ps) /\ exists m, is_infimum (parameters ray ps) m /\ parameters ray ps m).
Proof. exact (reduccion_exists_iff_infimum_attained ray ray_ok ps). Qed.

Variable Elemento : Type.
Variables s s' : Escena Elemento.
Variable en : set Elemento.
Hypothesis ok : Escena_ok s.
Hypothesis same : Xi_Escena s s'.
Hypothesis known : en ⊆ elementos s.
Notation met := (met ray Elemento s en).
Notation met_scene := (met_scene ray Elemento s en).

(** Where the nearest point is missing though the ray meets the scene, the ray starts in a segment of some element. *)
Theorem no_minimum_iff_the_ray_starts_in_a_segment :
  ~ (alcances s ray en ≡ ∅) /\ (alcances s ray en, Rayo_p ray) ∉ dom reduccion
  <-> exists e, e ∈ elementos s /\ starts_in (met e).
Proof. exact (scene_no_minimum_iff ray ray_ok _ s ok en). Qed.

(** And then the whole line lies in that element's unbounded surface, along a generator, and the ray meets it wherever
    the clip lets it. The element is never a sphere; the ray is parallel to a plane, a disc or a triangle; and in a plane,
    which nothing clips, the segment is the whole ray. *)
Theorem the_segment_is_of_a_generator e : e ∈ elementos s -> starts_in (met e) ->
  exists f g, equation ray _ s e f /\ seen _ en e f g /\ (forall t, value g t = 0)
    /\ (forall t, met e t <-> 0 < t /\ within g t) /\ (~ exists c r, is_esfera _ s e c r)
    /\ (forall c d, is_plano _ s e c d -> Tipos.dot (Rayo_v ray) d = 0 /\ forall t, 0 < t -> met e t)
    /\ (forall c r d, is_disco _ s e c r d -> Tipos.dot (Rayo_v ray) d = 0)
    /\ forall abc, is_triangulo _ s e abc -> Tipos.dot (Rayo_v ray) (normal abc) = 0.
Proof. exact (starts_in_a_generator ray ray_ok _ s ok en e). Qed.

Theorem first_hit_is_the_least_of_first_hits t :
  is_least met_scene t <->
  (forall e, e ∈ elementos s -> ~ starts_in (met e))
  /\ (exists e, e ∈ elementos s /\ is_least (met e) t)
  /\ forall e' t', e' ∈ elementos s -> is_least (met e') t' -> t <= t'.
Proof. exact (first_hit_is_least_of_first_hits ray _ s ok en t). Qed.

(** A hit names its parameter, its point and the elements that attain it. *)
Theorem a_hit_names_the_elements_that_attain_it resultado els t w :
  Hay_Interseccion s s' ray en resultado els t w <->
  is_least met_scene t /\ w = point_at ray t /\ els ≡ (fun e => e ∈ elementos s /\ is_least (met e) t)
  /\ resultado = hit.
Proof. now apply hit_computed. Qed.

Theorem every_question_has_one_answer :
  (exists resultado els t w, Primera_Interseccion s s' ray en resultado els t w)
  /\ forall res1 els1 t1 w1 res2 els2 t2 w2,
     Primera_Interseccion s s' ray en res1 els1 t1 w1 -> Primera_Interseccion s s' ray en res2 els2 t2 w2 ->
     res1 = res2 /\ els1 ≡ els2 /\ (res1 = hit -> t1 = t2 /\ w1 = w2).
Proof.
  exact (conj (Primera_Interseccion_is_total ray ray_ok _ s ok en s' same known)
    (Primera_Interseccion_deterministic ray ray_ok _ s ok en s' same known)).
Qed.

Theorem a_shadow_ray_is_occluded_where_it_meets_something :
  (occluded s ray en <-> exists t, met_scene t) /\ (occluded_segment s ray en <-> exists t, met_scene t /\ t < 1).
Proof. exact (occluded_computed ray _ s en). Qed.
End FirstHit.

Theorem the_elements_of_a_hit_are_de_que_elemento ray Elemento (s s' : Escena Elemento) resultado els t w :
  Hay_Interseccion s s' ray ∅ resultado els t w -> els ≡ de_que_elemento s w /\ w ∈ puntos_de_escena s.
Proof. exact (hit_elements_are_de_que_elemento ray Elemento s s' resultado els t w). Qed.

(** * 5. What the text claims of itself: each of its conjectures, as the export states it *)

Theorem the_conjectures_of_the_text_hold Elemento :
  Init_conj_1 Elemento
  /\ Agregar_Esfera_Total_conj_1 Elemento
  /\ Agregar_Cilindro_Total_conj_1 Elemento
  /\ Agregar_Cono_Total_conj_1 Elemento
  /\ Agregar_Tronco_Total_conj_1 Elemento
  /\ Agregar_Plano_Total_conj_1 Elemento
  /\ Agregar_Disco_Total_conj_1 Elemento
  /\ Agregar_Triangulo_Total_conj_1 Elemento
  /\ Eliminar_Esfera_Total_conj_1 Elemento
  /\ Eliminar_Cilindro_Total_conj_1 Elemento
  /\ Eliminar_Cono_Total_conj_1 Elemento
  /\ Eliminar_Tronco_Total_conj_1 Elemento
  /\ Eliminar_Plano_Total_conj_1 Elemento
  /\ Eliminar_Disco_Total_conj_1 Elemento
  /\ Eliminar_Triangulo_Total_conj_1 Elemento
  /\ Agregar_Elemento_Total_conj_1 Elemento
  /\ Eliminar_Elemento_Total_conj_1 Elemento
  /\ Primera_Interseccion_conj_1 Elemento
  /\ alcances_conj_1 Elemento
  /\ de_que_elemento_conj_1 Elemento
  /\ Hay_Interseccion_conj_1 Elemento.
Proof.
  exact (conj (Init_exists Elemento) (conj (Agregar_Esfera_Total_is_total Elemento) (conj
    (Agregar_Cilindro_Total_is_total Elemento) (conj (Agregar_Cono_Total_is_total Elemento) (conj
    (Agregar_Tronco_Total_is_total Elemento) (conj (Agregar_Plano_Total_is_total Elemento) (conj
    (Agregar_Disco_Total_is_total Elemento) (conj (Agregar_Triangulo_Total_is_total Elemento) (conj
    (Eliminar_Esfera_Total_is_total Elemento) (conj (Eliminar_Cilindro_Total_is_total Elemento) (conj
    (Eliminar_Cono_Total_is_total Elemento) (conj (Eliminar_Tronco_Total_is_total Elemento) (conj
    (Eliminar_Plano_Total_is_total Elemento) (conj (Eliminar_Disco_Total_is_total Elemento) (conj
    (Eliminar_Triangulo_Total_is_total Elemento) (conj (Agregar_Elemento_Total_is_total Elemento) (conj
    (Eliminar_Elemento_Total_is_total Elemento) (conj (precondition_of_Primera_Interseccion Elemento) (conj
    (printed_intersection_is_alcances Elemento) (conj (printed_elements_are_those_met Elemento)
    (printed_elements_are_the_answer Elemento))))))))))))))))))))).
Qed.

(** And of the surfaces of radius and height one, which have the fields of the textbooks: every sphere is that of one, seen
    from its own space; the cone of one keeps one nappe. *)
Theorem the_surfaces_of_one : potencia_esfera_conj_1 /\ potencia_cilindro_conj_1 /\ potencia_cono_conj_1.
Proof. exact (conj every_sphere_is_that_of_one (conj the_cylinder_of_one the_cone_of_one)). Qed.

(** And of light at a surface: a mirror keeps length and angle; what refracts is a unit vector beyond the surface, in one
    plane and by the law of Snell; it exists exactly where there is no total reflection; equal media leave it straight;
    and it may be gone back. *)
Theorem the_conjectures_of_light_hold :
  reflexion_conj_1 /\ refraccion_conj_1 /\ refraccion_conj_2 /\ reflexion_total_conj_1 /\ refraccion_conj_3
  /\ refraccion_conj_4.
Proof.
  exact (conj a_mirror_keeps_length_and_angle (conj the_refracted_direction_is_a_unit_vector_beyond (conj
    the_refracted_direction_obeys_Snell (conj refraction_exists_but_in_total_reflection (conj
    equal_indices_leave_the_direction light_goes_back_the_way_it_came))))).
Qed.

(** Of the distance of a point from a set of points: there is one at most, the ball of that radius holds no point of the set,
    it changes no faster than the point moves, and a step of sphere tracing passes nothing. That of a sphere is the distance
    of its centre less the radius, which has the sign; that of a scene is the least of those of its elements. *)
Theorem the_conjectures_of_distance_hold (Elemento : Type) :
  a_distancia_conj_1 /\ a_distancia_conj_2 /\ a_distancia_conj_3 /\ a_distancia_conj_4
  /\ con_signo_conj_1 Elemento /\ mas_cercano_conj_1 Elemento.
Proof.
  exact (conj Distancias.a_set_has_one_distance (conj Distancias.the_ball_of_the_distance_is_empty (conj
    Distancias.the_distance_changes_no_faster_than_the_point_moves (conj
    Distancias.a_step_of_sphere_tracing_passes_nothing (conj
    (Distancias.a_sphere_is_as_far_as_its_centre_less_the_radius Elemento)
    (Distancias.a_scene_is_as_far_as_its_nearest_element Elemento)))))).
Qed.

(** Of the power: it has the laws of the text, and whatever has them is it. *)
Theorem the_power_of_the_text_exists_and_is_one :
  (elevado_decl elevado /\ elevado_def_1 elevado /\ elevado_def_2 elevado /\ elevado_def_3 elevado)
  /\ forall f, elevado_decl f -> elevado_def_1 f -> elevado_def_2 f -> elevado_def_3 f ->
     forall x a, Cantidad x -> Cantidad a -> f x a = elevado x a.
Proof. exact (conj Power.the_power_has_the_laws Power.the_power_is_one). Qed.

(** Of the local model: the numbers of the source text; each of its terms alone; its bound; the sum over the lights. *)
Theorem the_conjectures_of_the_local_model_hold :
  elevado_conj_1 /\ elevado_conj_2 /\ coseno_cuadrado_conj_1 /\ reflexion_total_conj_2 /\ especular_conj_1
  /\ especular_conj_2 /\ directa_conj_1 /\ directa_conj_2 /\ directa_conj_3 /\ directa_conj_4 /\ aportacion_conj_1
  /\ acumulado_conj_1 /\ conserva_conj_1 /\ Material_conj_1.
Proof.
  exact (conj Power.half_five_times_is_below_a_twentieth (conj Power.no_power_of_a_share_is_above_one (conj
    Luz.into_glass_at_45_degrees (conj Luz.out_of_glass_and_out_of_water (conj Luz.a_highlight_is_the_mirrored_light (conj
    Luz.either_may_be_mirrored (conj Luz.behind_the_surface_the_first_term_is_left (conj
    Luz.without_a_highlight_it_is_Lamberts_law (conj Luz.a_highlight_has_no_colour_and_no_back (conj
    Luz.a_light_is_sent_back_by_its_shares_at_most (conj Luz.the_first_term_counts_for_each_light (conj Luz.a_sum_is_one
    (conj Luz.what_conserves_shines_no_brighter Luz.two_media_have_one_ratio))))))))))))).
Qed.

(** Of smooth normals: no edge is seen where triangles meet, equal normals are kept, and no direction is lost. *)
Theorem the_conjectures_of_smooth_normals_hold : normal_suave_conj_1 /\ normal_suave_conj_2 /\ normal_suave_conj_3.
Proof.
  exact (conj Luz.a_smooth_surface_has_no_edge (conj Luz.between_equal_normals_is_the_same
    Luz.within_a_triangle_no_direction_is_lost)).
Qed.

(** Of Whitted's recursion: whatever there is to follow, there is an answer, and one. Of the lights and of the window of
    the picture: what hides nothing without end hides nothing nearer, and each pixel has its ray, evenly. *)
Theorem the_recursion_ends_in_one_answer (Camino Elemento : Type) :
  trazador_conj_1 Camino /\ trazador_conj_2 Camino /\ trazador_conj_3 Camino /\ visible_conj_1 Elemento
  /\ centro_de_pixel_conj_1 /\ rayo_de_pixel_conj_1.
Proof.
  exact (conj (Luz.the_recursion_ends Camino) (conj (Luz.there_is_one_answer Camino) (conj
    (Luz.no_depth_is_black_and_one_goes_not_on Camino) (conj (Luz.a_light_without_end_is_visible_nearer Elemento) (conj
    Luz.opposite_pixels_lie_about_the_middle Luz.every_pixel_has_its_ray))))).
Qed.

(** Of rays made wide: a cone of no angle is its axis; the mirror image of a beam is the beam of the mirrored origin, and a
    plane through its origin divides it; matrices of pencils compose, and a ball of glass has its focus. *)
Theorem the_conjectures_of_wide_rays_hold :
  cono_de_rayos_conj_1 /\ cono_de_rayos_conj_2 /\ imagen_conj_1 /\ imagen_conj_2 /\ haz_conj_1 /\ haz_conj_2
  /\ aplicado_conj_1 /\ traslado_conj_1 /\ traslado_conj_2 /\ refraccion_paraxial_conj_1.
Proof.
  exact (conj Haces.a_cone_of_no_angle_is_its_axis (conj Haces.a_wider_cone_holds_a_narrower (conj
    Haces.an_image_of_an_image_is_what_there_was (conj Haces.what_is_mirrored_comes_from_the_image (conj
    Haces.the_image_of_a_beam_is_the_beam_of_the_image (conj Haces.a_plane_through_its_origin_divides_a_beam (conj
    Haces.matrices_compose (conj Haces.the_way_along_the_axis_is_a_matrix (conj Haces.two_ways_are_the_way_of_their_sum
    Haces.a_ball_unites_what_comes_along_its_axis))))))))).
Qed.

(** Of the mean that a picture is: there are draws; it is one, and lies between the bounds; a light whose points stand in
    one place has no size; all rays of a direction meet in focus, nothing is seen outside its circle of confusion, which is
    that of the formula of thin lenses; what moves keeps its shape; two draws that share a sum add to it, and roulette
    keeps the mean. *)
Theorem a_picture_is_a_mean :
  (exists s, s ∈ Sorteo_ok) /\ media_conj_1 /\ media_conj_2 /\ de_luz_extensa_conj_1 /\ rayo_de_lente_conj_1
  /\ circulo_de_confusion_conj_1 /\ circulo_de_confusion_conj_2 /\ desplazado_conj_1 /\ repartida_conj_1 /\ ruleta_conj_1.
Proof.
  exact (conj (ex_intro _ _ Distribuida.a_coin_is_a_draw) (conj Distribuida.the_mean_is_one (conj Distribuida.the_mean_lies_between_the_bounds (conj
    Distribuida.points_of_one_place_are_a_light_without_a_size (conj Distribuida.all_rays_of_a_direction_meet_in_focus (conj
    Distribuida.nothing_is_seen_outside_its_circle (conj Distribuida.the_circle_is_that_of_thin_lenses (conj
    Distribuida.whatever_moves_keeps_its_shape (conj Distribuida.shared_means_add_to_the_sum
    Distribuida.roulette_keeps_the_mean))))))))).
Qed.

(** Of rasters, from spec/proyeccion.tex: a point of a triangle sees a light exactly where it lies in no shadow; a parallel shadow
    has its polygon's shape; a depth map is right in the direction that it was asked in, and has a plane shadow itself beside it;
    what is drawn over what, and when the order counts. *)
Theorem the_conjectures_of_projection_hold (Elemento : Type) :
  iluminada_conj_1 Elemento /\ proyectado_conj_1 /\ oscura_conj_1 /\ oscura_conj_2 /\ mezcla_conj_1 /\ mezcla_conj_2
  /\ mezcla_conj_3.
Proof.
  exact (conj (Proyeccion.clipping_by_shadows_is_sending_rays Elemento) (conj
    Proyeccion.a_parallel_shadow_is_larger_by_the_heights (conj Proyeccion.in_its_very_direction_a_depth_map_is_right (conj
    Proyeccion.asked_beside_it_finds_a_plane_to_shadow_itself (conj Proyeccion.drawing_over_is_following_the_ray_straight_on
    (conj Proyeccion.without_own_colours_the_order_is_free Proyeccion.with_own_colours_the_order_counts)))))).
Qed.

(** Of the light that sheets let through, and of cones of light: there are both; what hides a light stands before it; no
    order counts, nothing takes nothing, a stone takes all; a cone is full along its axis and ends without a step. *)
Theorem the_conjectures_of_sheets_and_cones_hold (Elemento : Type) :
  (exists (S : rel unit Punto) paso, paso ∈ univ ⟶ Parte /\ transmitido S paso (1 / 2)) /\ (exists c, c ∈ Cono_de_Luz_ok)
  /\ ante_conj_1 Elemento /\ transmitido_conj_1 Elemento /\ transmitido_conj_2 Elemento /\ transmitido_conj_3 Elemento
  /\ menguada_conj_1 /\ intensidad_conj_1 /\ intensidad_conj_2.
Proof.
  exact (conj Sheets.one_pane_lets_its_share_through (conj (ex_intro _ _ Sheets.a_cone_of_light) (conj
    (Sheets.what_hides_a_light_stands_before_it Elemento) (conj (Sheets.what_is_let_through_has_no_order Elemento) (conj
    (Sheets.nothing_takes_nothing_and_a_stone_takes_all Elemento) (conj (Sheets.of_shares_it_is_a_share Elemento) (conj
    Sheets.of_a_share_of_a_light_its_share_is_sent_back (conj Sheets.a_cone_sends_one_share_each_way
    Sheets.a_cone_is_full_along_its_axis_and_ends_without_a_step)))))))).
Qed.
