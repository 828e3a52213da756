(** The Z text of spec/*.tex, without tablas, malla, auditoria, historia and promocion, in Coq, written by
    `durero spec export --coq` of its sections: change the text, not this file. Nothing is proved here. The rules:

    ℝ, ℤ                  == Coq's R, and those of it that are integers (Toolkit.integers); what the text assumes of
                             them are statements, proved in Tipos.v
    a given set           == a Type, a section variable
    a free type           == an Inductive
    a set, ℙ T            == a predicate on the carrier of T (Toolkit.set); univ where the set is the whole carrier
    x ∈ T, T a whole type == x has a value: exists c : T, c = x
    a partial function    == a set of pairs (Toolkit.rel)
    (_ + _), and − and *  == the set of pairs of Coq's operation (Toolkit.graph)
    S × T                 == univ of whole types, else cartesian S T;  S → T == the set of total functions, S ⟶ T
    f(e) within a predicate P  == exists v, (e, v) ∈ f /\ P: an application outside the domain makes P false. P is the
                             relation that f(e) stands in, a chain counting as one; in a condition, all of its IF
    A = B, sets           == A ≡ B
    IF P THEN E ELSE F    == y is E or F: P /\ y = E \/ ~ P /\ y = F; of sets, with y ∈; within a sum or a product,
                             where P compares two reals: if Rle_dec a b then E else F, for ≤
    a function with ∀ … f(x) = E     == a Definition; arguments are taken from the carriers
    a partial function with dom f = S and ∀ … | … f(x) = E  == the relation "x ∈ S and y is E"
    another name of a box == its declaration and predicates as statements f_decl and the labels', about any such f; and
                             f itself: what solves f * n = m, or Coq's sqrt, or Toolkit.power_of
    { x : S | P }         == fun x => x ∈ S /\ P
    { D | P } of several  == a Definition of the arguments, a Prop;  (x, y) ∈ S  == S x y
    λ D | P • E, E a set  == a Definition of the arguments; outside P the set is empty
    λ D | P • E, otherwise == the same with the set of E alone as value
    S                     == a Record S of carriers and a predicate S_ok with one field a declaration that says more than
                             a type and one a predicate; components are prefixed by S, but for those of the state
    ΔS, ΞS, θS = θS '     == Delta_S, Xi_S, S_eq, for the state S: the schema that boxes include as ΔS, ΞS or S '
    other schemas         == predicates on their components: a Record with one field an inclusion, a declaration that says
                             more than a type, and a predicate; or a Definition where the text combines schemas
    pre S                 == there are an after-state and outputs of S
    ⊢? P                  == P as a statement: the theorem that its label leads to proves it
    θS, θS '; x?, x!      == s, s'; x_in, x_out
    a label A.kind.n      == the field or Definition A_kind_n *)
From Coq Require Import Reals.
From Durero Require Import Toolkit.
Local Open Scope R_scope.
Local Open Scope zed_scope.
Set Implicit Arguments.

Section Especificacion.

(** * tipos.tex *)

Definition real_axiom_1 : Prop := integers ⊆ univ. (* real.axiom.1 *)
Definition real_axiom_2 : Prop :=
  dres univ (graph Rplus) ∈ univ ⟶ univ /\ dres univ (graph Rminus) ∈ univ ⟶ univ
  /\ dres univ (graph Rmult) ∈ univ ⟶ univ. (* real.axiom.2 *)
Definition real_axiom_3 : Prop := forall a : R, a <> 0 -> exists! b : R, a * b = 1. (* real.axiom.3 *)
Definition real_axiom_4 : Prop :=
  forall S : set R, (exists x1, x1 ∈ S) -> (exists c : R, forall a : R, a ∈ S -> a <= c)
  -> exists! c : R, (forall a : R, a ∈ S -> a <= c) /\ forall d : R, (forall a : R, a ∈ S -> a <= d)
  -> c <= d. (* real.axiom.4 *)
Definition real_axiom_5 : Prop :=
  forall a b c : R, a + b = b + a /\ a + (b + c) = a + b + c /\ a + 0 = a /\ a - b + b = a. (* real.axiom.5 *)
Definition real_axiom_6 : Prop :=
  forall a b c : R, a * b = b * a /\ a * (b * c) = a * b * c /\ a * 1 = a
  /\ a * (b + c) = a * b + a * c. (* real.axiom.6 *)
Definition real_axiom_7 : Prop :=
  forall a b c : R, (a <= b \/ b <= a) /\ (a <= b /\ b <= a -> a = b)
  /\ (a <= b /\ b <= c -> a <= c). (* real.axiom.7 *)
Definition real_axiom_8 : Prop :=
  forall a b c : R, (a <= b -> a + c <= b + c) /\ (0 <= a /\ 0 <= b -> 0 <= a * b). (* real.axiom.8 *)
Definition real_axiom_9 : Prop :=
  forall a b : R, (a < b <-> a <= b /\ a <> b) /\ (a > b <-> b < a) /\ (a >= b <-> b <= a). (* real.axiom.9 *)

Definition Rmas : set R := fun r => r > 0. (* Rmas.inv.1 *)

Record Punto := mk_Punto {
  Punto_x : R;
  Punto_y : R;
  Punto_z : R
}.

Record Vector := mk_Vector {
  Vector_x : R;
  Vector_y : R;
  Vector_z : R
}.

Record Rayo := mk_Rayo {
  Rayo_p : Punto;
  Rayo_v : Vector
}.

Record Rayo_ok (s : Rayo) : Prop := {
  Rayo_inv_1 : ~ (Vector_x (Rayo_v s) = 0 /\ Vector_y (Rayo_v s) = 0 /\ Vector_z (Rayo_v s) = 0) (* Rayo.inv.1 *)
}.

Definition tolerancia_unidad_decl (tolerancia_unidad : R) : Prop := tolerancia_unidad ∈ Rmas.
Definition tolerancia_unidad_def_1 (tolerancia_unidad : R) : Prop :=
  tolerancia_unidad * 1125899906842624 = 1. (* tolerancia_unidad.def.1 *)
Definition tolerancia_unidad : R := 1 / 1125899906842624.

Definition Unitario : set Vector :=
  fun d => 1 - tolerancia_unidad <= Vector_x d * Vector_x d + Vector_y d * Vector_y d + Vector_z d * Vector_z d <= 1
  + tolerancia_unidad. (* Unitario.inv.1 *)

Record Terna := mk_Terna {
  Terna_a : Punto;
  Terna_b : Punto;
  Terna_c : Punto
}.

Definition Vertices : set Terna :=
  fun v => ~ ((Punto_y (Terna_b v) - Punto_y (Terna_a v)) * (Punto_z (Terna_c v) - Punto_z (Terna_a v))
  = (Punto_z (Terna_b v) - Punto_z (Terna_a v)) * (Punto_y (Terna_c v) - Punto_y (Terna_a v))
  /\ (Punto_z (Terna_b v) - Punto_z (Terna_a v)) * (Punto_x (Terna_c v) - Punto_x (Terna_a v))
  = (Punto_x (Terna_b v) - Punto_x (Terna_a v)) * (Punto_z (Terna_c v) - Punto_z (Terna_a v))
  /\ (Punto_x (Terna_b v) - Punto_x (Terna_a v)) * (Punto_y (Terna_c v) - Punto_y (Terna_a v))
  = (Punto_y (Terna_b v) - Punto_y (Terna_a v)) * (Punto_x (Terna_c v) - Punto_x (Terna_a v))). (* Vertices.inv.1 *)

Variable Elemento : Type.

Inductive Tipo := | soy_esfera | soy_cilindro | soy_cono | soy_tronco | soy_plano | soy_disco | soy_triangulo.

Inductive Respuesta := | elemento_agregado | elemento_eliminado | esfera_agregada | cilindro_agregado | cono_agregado
  | tronco_agregado | plano_agregado | disco_agregado | triangulo_agregado | esfera_eliminada | cilindro_eliminado |
  cono_eliminado | tronco_eliminado | plano_eliminado | disco_eliminado | triangulo_eliminado | elemento_ya_existe |
  elemento_no_existe | tipo_incorrecto | radio_no_positivo | vector_no_unitario | altura_no_positiva |
  proporcion_no_positiva | vertices_alineados | malla_agregada | malla_eliminada | malla_reemplazada | vertice_movido
  | malla_ya_existe | malla_no_existe | cara_incompleta | cara_sin_nombre | vertice_no_existe | es_de_malla |
  elemento_cambiado | material_no_existe | grupo_no_existe | hecho | deshecho | rehecho | transaccion_rechazada |
  nada_que_deshacer | nada_que_rehacer.

(** * escena.tex *)

Record Escena := mk_Escena {
  elementos : set Elemento;
  tipos : set Tipo;
  de_que_tipo : rel Elemento Tipo;
  mi_centro : rel Elemento Punto;
  mi_radio : rel Elemento R;
  mi_vector : rel Elemento Vector;
  mi_altura : rel Elemento R;
  mi_proporcion : rel Elemento R;
  mi_vertices : rel Elemento Terna
}.

Record Escena_ok (s : Escena) : Prop := {
  Escena_decl_elementos : elementos s ∈ 𝔽 univ;
  Escena_decl_tipos : tipos s ∈ ℙ univ;
  Escena_decl_de_que_tipo : de_que_tipo s ∈ univ ⇸ univ;
  Escena_decl_mi_centro : mi_centro s ∈ univ ⇸ univ;
  Escena_decl_mi_radio : mi_radio s ∈ univ ⇸ Rmas;
  Escena_decl_mi_vector : mi_vector s ∈ univ ⇸ univ;
  Escena_decl_mi_altura : mi_altura s ∈ univ ⇸ Rmas;
  Escena_decl_mi_proporcion : mi_proporcion s ∈ univ ⇸ Rmas;
  Escena_decl_mi_vertices : mi_vertices s ∈ univ ⇸ Vertices;
  Escena_inv_1 : elementos s ≡ dom (de_que_tipo s); (* Escena.inv.1 *)
  Escena_inv_2 : dom (mi_centro s) ≡ image (inverse (de_que_tipo s)) (⦃soy_esfera⦄ ∪ ⦃soy_cilindro⦄ ∪ ⦃soy_cono⦄ ∪
    ⦃soy_tronco⦄ ∪ ⦃soy_plano⦄ ∪ ⦃soy_disco⦄); (* Escena.inv.2 *)
  Escena_inv_3 : dom (mi_radio s) ≡ image (inverse (de_que_tipo s)) (⦃soy_esfera⦄ ∪ ⦃soy_cilindro⦄ ∪ ⦃soy_tronco⦄ ∪
    ⦃soy_disco⦄); (* Escena.inv.3 *)
  Escena_inv_4 : dom (mi_vector s) ≡ image (inverse (de_que_tipo s)) (⦃soy_cilindro⦄ ∪ ⦃soy_cono⦄ ∪ ⦃soy_tronco⦄ ∪
    ⦃soy_plano⦄ ∪ ⦃soy_disco⦄); (* Escena.inv.4 *)
  Escena_inv_5 : dom (mi_altura s) ≡ image (inverse (de_que_tipo s)) (⦃soy_cilindro⦄ ∪ ⦃soy_cono⦄ ∪ ⦃soy_tronco⦄);
    (* Escena.inv.5 *)
  Escena_inv_6 : dom (mi_proporcion s) ≡ image (inverse (de_que_tipo s)) (⦃soy_cono⦄ ∪ ⦃soy_tronco⦄);
    (* Escena.inv.6 *)
  Escena_inv_7 : tipos s ≡ ran (de_que_tipo s); (* Escena.inv.7 *)
  Escena_inv_8 : ran (mi_vector s) ⊆ Unitario; (* Escena.inv.8 *)
  Escena_inv_9 : dom (mi_vertices s) ≡ image (inverse (de_que_tipo s)) ⦃soy_triangulo⦄ (* Escena.inv.9 *)
}.

Record Escena_eq (s s' : Escena) : Prop := {
  Escena_eq_elementos : elementos s' ≡ elementos s;
  Escena_eq_tipos : tipos s' ≡ tipos s;
  Escena_eq_de_que_tipo : de_que_tipo s' ≡ de_que_tipo s;
  Escena_eq_mi_centro : mi_centro s' ≡ mi_centro s;
  Escena_eq_mi_radio : mi_radio s' ≡ mi_radio s;
  Escena_eq_mi_vector : mi_vector s' ≡ mi_vector s;
  Escena_eq_mi_altura : mi_altura s' ≡ mi_altura s;
  Escena_eq_mi_proporcion : mi_proporcion s' ≡ mi_proporcion s;
  Escena_eq_mi_vertices : mi_vertices s' ≡ mi_vertices s
}.

Record Delta_Escena (s s' : Escena) : Prop := {
  Delta_Escena_before : Escena_ok s;
  Delta_Escena_after : Escena_ok s'
}.

Record Xi_Escena (s s' : Escena) : Prop := {
  Xi_Escena_Delta : Delta_Escena s s';
  Xi_Escena_eq : Escena_eq s s'
}.

Record Init (s' : Escena) : Prop := {
  Init_Escena : Escena_ok s';
  Init_post_1 : elementos s' ≡ ∅ (* Init.post.1 *)
}.

Definition Init_conj_1 : Prop := exists s' : Escena, Escena_ok s' /\ Init s'. (* Init.conj.1 *)

(** * puntos.tex *)

Definition cuadrado (r : R) : R := r * r. (* cuadrado.def.1 *)

Definition raizcuadrada_decl (raizcuadrada : R -> R) : Prop := forall x1 : R, x1 >= 0 -> raizcuadrada x1 >= 0.
Definition raizcuadrada_def_1 (raizcuadrada : R -> R) : Prop :=
  forall r : R, r >= 0 -> raizcuadrada r * raizcuadrada r = r. (* raizcuadrada.def.1 *)
Definition raizcuadrada : R -> R := sqrt.

Definition avance (w centro : Punto) (dir : Vector) : R :=
  (Punto_x w - Punto_x centro) * Vector_x dir + (Punto_y w - Punto_y centro) * Vector_y dir
  + (Punto_z w - Punto_z centro) * Vector_z dir. (* avance.def.1 *)
Definition alejamiento (w centro : Punto) (dir : Vector) : R :=
  cuadrado (Punto_x w - (Punto_x centro + avance w centro dir * Vector_x dir))
  + cuadrado (Punto_y w - (Punto_y centro + avance w centro dir * Vector_y dir))
  + cuadrado (Punto_z w - (Punto_z centro + avance w centro dir * Vector_z dir)). (* alejamiento.def.1 *)

Definition potencia_esfera (w centro : Punto) (radio : R) : R :=
  cuadrado (Punto_x w - Punto_x centro) + cuadrado (Punto_y w - Punto_y centro)
  + cuadrado (Punto_z w - Punto_z centro) - cuadrado radio. (* potencia_esfera.def.1 *)
Definition potencia_cilindro (w centro : Punto) (radio : R) (dir : Vector) : R :=
  alejamiento w centro dir - cuadrado radio. (* potencia_cilindro.def.1 *)
Definition potencia_cono (w centro : Punto) (prop : R) (dir : Vector) (h : R) : R :=
  alejamiento w centro dir - cuadrado (prop * avance w centro dir - h * prop). (* potencia_cono.def.1 *)
Definition potencia_tronco (w centro : Punto) (radio prop : R) (dir : Vector) (h : R) : R :=
  alejamiento w centro dir - cuadrado (radio + prop * (h - avance w centro dir)). (* potencia_tronco.def.1 *)
Definition potencia_plano (w centro : Punto) (dir : Vector) : R := avance w centro dir. (* potencia_plano.def.1 *)
Definition potencia_triangulo (w : Punto) (v : Terna) : R :=
  (Punto_x w - Punto_x (Terna_a v)) * ((Punto_y (Terna_b v) - Punto_y (Terna_a v)) * (Punto_z (Terna_c v)
  - Punto_z (Terna_a v)) - (Punto_z (Terna_b v) - Punto_z (Terna_a v)) * (Punto_y (Terna_c v)
  - Punto_y (Terna_a v))) + (Punto_y w - Punto_y (Terna_a v)) * ((Punto_z (Terna_b v)
  - Punto_z (Terna_a v)) * (Punto_x (Terna_c v) - Punto_x (Terna_a v))
  - (Punto_x (Terna_b v) - Punto_x (Terna_a v)) * (Punto_z (Terna_c v) - Punto_z (Terna_a v)))
  + (Punto_z w - Punto_z (Terna_a v)) * ((Punto_x (Terna_b v) - Punto_x (Terna_a v)) * (Punto_y (Terna_c v)
  - Punto_y (Terna_a v)) - (Punto_y (Terna_b v) - Punto_y (Terna_a v)) * (Punto_x (Terna_c v)
  - Punto_x (Terna_a v))). (* potencia_triangulo.def.1 *)

Definition puntos_esfera (centro : Punto) (radio : R) : set Punto :=
  fun w => potencia_esfera w centro radio = 0. (* puntos_esfera.def.1 *)

Definition puntos_cilindro (centro : Punto) (radio : R) (dir : Vector) (h : R) : set Punto :=
  fun w => potencia_cilindro w centro radio dir = 0 /\ 0 <= avance w centro dir <= h. (* puntos_cilindro.def.1 *)

Definition puntos_cono (centro : Punto) (prop : R) (dir : Vector) (h : R) : set Punto :=
  fun w => potencia_cono w centro prop dir h = 0 /\ 0 <= avance w centro dir <= h. (* puntos_cono.def.1 *)

Definition puntos_tronco (centro : Punto) (radio prop : R) (dir : Vector) (h : R) : set Punto :=
  fun w => potencia_tronco w centro radio prop dir h = 0 /\ 0 <= avance w centro dir <= h. (* puntos_tronco.def.1 *)

Definition puntos_plano (centro : Punto) (dir : Vector) : set Punto :=
  fun w => potencia_plano w centro dir = 0. (* puntos_plano.def.1 *)

Definition puntos_disco (centro : Punto) (radio : R) (dir : Vector) : set Punto :=
  fun w => potencia_plano w centro dir = 0 /\ potencia_esfera w centro radio <= 0. (* puntos_disco.def.1 *)

Definition escalar (p q r s1 : Punto) : R :=
  (Punto_x q - Punto_x p) * (Punto_x s1 - Punto_x r) + (Punto_y q - Punto_y p) * (Punto_y s1 - Punto_y r)
  + (Punto_z q - Punto_z p) * (Punto_z s1 - Punto_z r). (* escalar.def.1 *)

Definition producto (u v : Vector) : R :=
  Vector_x u * Vector_x v + Vector_y u * Vector_y v + Vector_z u * Vector_z v. (* producto.def.1 *)

Definition lado (w a b c : Punto) : R :=
  escalar a b a b * escalar a w a c - escalar a b a c * escalar a w a b. (* lado.def.1 *)

Definition prisma (v : Terna) : set Punto :=
  fun w => 0 <= lado w (Terna_a v) (Terna_b v) (Terna_c v) /\ 0 <= lado w (Terna_b v) (Terna_c v) (Terna_a v)
  /\ 0 <= lado w (Terna_c v) (Terna_a v) (Terna_b v). (* prisma.def.1 *)

Definition puntos_triangulo (v : Terna) : set Punto :=
  fun w => w ∈ prisma v /\ potencia_triangulo w v = 0. (* puntos_triangulo.def.1 *)

Definition puntos_de_rayo (ray : Rayo) : set Punto :=
  ⋃[Rmas] (fun t => fun temp => Punto_x temp = Punto_x (Rayo_p ray) + t * Vector_x (Rayo_v ray)
  /\ Punto_y temp = Punto_y (Rayo_p ray) + t * Vector_y (Rayo_v ray)
  /\ Punto_z temp = Punto_z (Rayo_p ray) + t * Vector_z (Rayo_v ray)). (* puntos_de_rayo.def.1 *)

Definition puntos_de_elemento (s : Escena) (e : Elemento) : set Punto :=
  fun x1 => e ∈ elementos s /\ exists v1, (e, v1) ∈ de_que_tipo s
  /\ ((v1 = soy_esfera /\ exists v2 v3, (e, v2) ∈ mi_centro s /\ (e, v3) ∈ mi_radio s /\ x1 ∈ puntos_esfera v2 v3)
  \/ (v1 <> soy_esfera /\ ((v1 = soy_cilindro /\ exists v2 v3 v4 v5, (e, v2) ∈ mi_centro s /\ (e, v3) ∈ mi_radio s
  /\ (e, v4) ∈ mi_vector s /\ (e, v5) ∈ mi_altura s /\ x1 ∈ puntos_cilindro v2 v3 v4 v5)
  \/ (v1 <> soy_cilindro /\ ((v1 = soy_cono /\ exists v2 v3 v4 v5, (e, v2) ∈ mi_centro s
  /\ (e, v3) ∈ mi_proporcion s /\ (e, v4) ∈ mi_vector s /\ (e, v5) ∈ mi_altura s /\ x1 ∈ puntos_cono v2 v3 v4 v5)
  \/ (v1 <> soy_cono /\ ((v1 = soy_tronco /\ exists v2 v3 v4 v5 v6, (e, v2) ∈ mi_centro s /\ (e, v3) ∈ mi_radio s
  /\ (e, v4) ∈ mi_proporcion s /\ (e, v5) ∈ mi_vector s /\ (e, v6) ∈ mi_altura s
  /\ x1 ∈ puntos_tronco v2 v3 v4 v5 v6) \/ (v1 <> soy_tronco
  /\ ((v1 = soy_plano /\ exists v2 v3, (e, v2) ∈ mi_centro s /\ (e, v3) ∈ mi_vector s /\ x1 ∈ puntos_plano v2 v3)
  \/ (v1 <> soy_plano /\ ((v1 = soy_disco /\ exists v2 v3 v4, (e, v2) ∈ mi_centro s /\ (e, v3) ∈ mi_radio s
  /\ (e, v4) ∈ mi_vector s /\ x1 ∈ puntos_disco v2 v3 v4)
  \/ (v1 <> soy_disco /\ exists v2, (e, v2) ∈ mi_vertices s
  /\ x1 ∈ puntos_triangulo v2)))))))))))). (* puntos_de_elemento.def.1 *)

Definition puntos_de_escena (s : Escena) : set Punto :=
  ⋃[elementos s] (fun e => puntos_de_elemento s e). (* puntos_de_escena.def.1 *)

Definition potencia_esfera_conj_1 : Prop :=
  forall (w u o centro : Punto) (r : R), r ∈ Rmas -> Punto_x o = 0 -> Punto_y o = 0 -> Punto_z o = 0
  -> r * Punto_x u = Punto_x w - Punto_x centro -> r * Punto_y u = Punto_y w - Punto_y centro
  -> r * Punto_z u = Punto_z w - Punto_z centro
  -> potencia_esfera u o 1 = cuadrado (Punto_x u) + cuadrado (Punto_y u) + cuadrado (Punto_z u) - 1
  /\ potencia_esfera w centro r = cuadrado r * potencia_esfera u o 1
  /\ (w ∈ puntos_esfera centro r <-> u ∈ puntos_esfera o 1). (* potencia_esfera.conj.1 *)

Definition potencia_cilindro_conj_1 : Prop :=
  forall (w o : Punto) (d : Vector), d ∈ Unitario -> Punto_x o = 0 -> Punto_y o = 0 -> Punto_z o = 0
  -> Vector_x d = 0 -> Vector_y d = 0 -> Vector_z d = 1
  -> w ∈ puntos_cilindro o 1 d 1 <-> cuadrado (Punto_x w) + cuadrado (Punto_y w) - 1 = 0
  /\ 0 <= Punto_z w <= 1. (* potencia_cilindro.conj.1 *)

Definition potencia_cono_conj_1 : Prop :=
  forall (w o : Punto) (d : Vector), d ∈ Unitario -> Punto_x o = 0 -> Punto_y o = 0 -> Punto_z o = 0
  -> Vector_x d = 0 -> Vector_y d = 0 -> Vector_z d = 1
  -> w ∈ puntos_cono o 1 d 1 <-> cuadrado (Punto_x w) + cuadrado (Punto_y w) - cuadrado (1 - Punto_z w) = 0
  /\ 0 <= Punto_z w <= 1. (* potencia_cono.conj.1 *)

(** * interseccion.tex *)

Definition interseccion (ps qs : set Punto) : set Punto := ps ∩ qs. (* interseccion.def.1 *)

Definition distancia (a b : Punto) : R :=
  raizcuadrada (cuadrado (Punto_x a - Punto_x b) + cuadrado (Punto_y a - Punto_y b)
  + cuadrado (Punto_z a - Punto_z b)). (* distancia.def.1 *)

Definition reduccion : rel (set Punto * Punto) Punto :=
  fun '((ps, ojo), y1) => (exists! temp : Punto, temp ∈ ps /\ forall otro : Punto, otro ∈ ps
  -> distancia temp ojo <= distancia otro ojo)
  /\ y1 ∈ is_mu (fun temp => temp ∈ ps /\ forall otro : Punto, otro ∈ ps
  -> distancia temp ojo <= distancia otro ojo). (* reduccion.def.1, reduccion.def.2 *)

Definition de_que_elemento (s : Escena) (p : Punto) : set Elemento :=
  fun e => e ∈ elementos s /\ p ∈ puntos_de_elemento s e. (* de_que_elemento.def.1 *)

Definition potencia (s : Escena) (e : Elemento) (w : Punto) : set R :=
  fun y1 => e ∈ elementos s /\ exists v1, (e, v1) ∈ de_que_tipo s
  /\ ((v1 = soy_esfera /\ exists v2 v3, (e, v2) ∈ mi_centro s /\ (e, v3) ∈ mi_radio s
  /\ y1 = potencia_esfera w v2 v3) \/ (v1 <> soy_esfera
  /\ ((v1 = soy_cilindro /\ exists v2 v3 v4, (e, v2) ∈ mi_centro s /\ (e, v3) ∈ mi_radio s /\ (e, v4) ∈ mi_vector s
  /\ y1 = potencia_cilindro w v2 v3 v4) \/ (v1 <> soy_cilindro
  /\ ((v1 = soy_cono /\ exists v2 v3 v4 v5, (e, v2) ∈ mi_centro s /\ (e, v3) ∈ mi_proporcion s
  /\ (e, v4) ∈ mi_vector s /\ (e, v5) ∈ mi_altura s /\ y1 = potencia_cono w v2 v3 v4 v5)
  \/ (v1 <> soy_cono /\ ((v1 = soy_tronco /\ exists v2 v3 v4 v5 v6, (e, v2) ∈ mi_centro s /\ (e, v3) ∈ mi_radio s
  /\ (e, v4) ∈ mi_proporcion s /\ (e, v5) ∈ mi_vector s /\ (e, v6) ∈ mi_altura s
  /\ y1 = potencia_tronco w v2 v3 v4 v5 v6)
  \/ (v1 <> soy_tronco /\ ((v1 = soy_plano /\ exists v2 v3, (e, v2) ∈ mi_centro s /\ (e, v3) ∈ mi_vector s
  /\ y1 = potencia_plano w v2 v3) \/ (v1 <> soy_plano
  /\ ((v1 = soy_disco /\ exists v2 v3, (e, v2) ∈ mi_centro s /\ (e, v3) ∈ mi_vector s
  /\ y1 = potencia_plano w v2 v3) \/ (v1 <> soy_disco /\ exists v2, (e, v2) ∈ mi_vertices s
  /\ y1 = potencia_triangulo w v2)))))))))))). (* potencia.def.1 *)

Definition tramo (s : Escena) (e : Elemento) : set Punto :=
  fun w => e ∈ elementos s /\ (e ∈ dom (mi_altura s)
  -> (exists v1 v2 v3, (e, v1) ∈ mi_centro s /\ (e, v2) ∈ mi_vector s /\ (e, v3) ∈ mi_altura s
  /\ 0 <= avance w v1 v2 <= v3)) /\ ((exists v1, (e, v1) ∈ de_que_tipo s /\ v1 = soy_disco)
  -> (exists v1 v2, (e, v1) ∈ mi_centro s /\ (e, v2) ∈ mi_radio s /\ potencia_esfera w v1 v2 <= 0))
  /\ (e ∈ dom (mi_vertices s) -> (exists v1, (e, v1) ∈ mi_vertices s /\ w ∈ prisma v1)). (* tramo.def.1 *)

Definition puntos_desde (s : Escena) (e : Elemento) (p : Punto) : set Punto :=
  fun w => e ∈ elementos s /\ w ∈ tramo s e /\ exists v1 v2, v1 ∈ potencia s e w /\ v2 ∈ potencia s e p
  /\ v1 = v2. (* puntos_desde.def.1 *)

Definition alcance (s : Escena) (rayo : Rayo) (en : set Elemento) (e : Elemento) : set Punto :=
  fun x1 => e ∈ elementos s /\ x1 ∈ interseccion (puntos_de_rayo rayo) (fun x2 =>
  (e ∈ en /\ x2 ∈ puntos_desde s e (Rayo_p rayo)) \/ (e ∉ en /\ x2 ∈ puntos_de_elemento s e)). (* alcance.def.1 *)

Definition alcances (s : Escena) (rayo : Rayo) (en : set Elemento) : set Punto :=
  ⋃[elementos s] (fun e => alcance s rayo en e). (* alcances.def.1 *)

Inductive Resultado := | hit | miss | no_minimum.

Record Pregunta (s s' : Escena) (rayo_in : Rayo) (en_in : set Elemento) (resultado_out : Resultado) (elementos_out :
  set Elemento) : Prop := {
  Pregunta_Xi : Xi_Escena s s';
  Pregunta_decl_rayo : rayo_in ∈ Rayo_ok;
  Pregunta_decl_en : en_in ∈ ℙ univ;
  Pregunta_decl_elementos : elementos_out ∈ ℙ univ;
  Pregunta_pre_1 : en_in ⊆ elementos s (* Pregunta.pre.1 *)
}.

Record Hay_Interseccion (s s' : Escena) (rayo_in : Rayo) (en_in : set Elemento) (resultado_out : Resultado)
  (elementos_out : set Elemento) (t_out : R) (punto_out : Punto) : Prop := {
  Hay_Interseccion_Pregunta : Pregunta s s' rayo_in en_in resultado_out elementos_out;
  Hay_Interseccion_decl_t : t_out ∈ Rmas;
  Hay_Interseccion_pre_1 : (alcances s rayo_in en_in, Rayo_p rayo_in) ∈ dom reduccion; (* Hay_Interseccion.pre.1 *)
  Hay_Interseccion_post_1 : exists v1, ((alcances s rayo_in en_in, Rayo_p rayo_in), v1) ∈ reduccion
    /\ punto_out = v1; (* Hay_Interseccion.post.1 *)
  Hay_Interseccion_post_2 : Punto_x punto_out = Punto_x (Rayo_p rayo_in) + t_out * Vector_x (Rayo_v rayo_in)
    /\ Punto_y punto_out = Punto_y (Rayo_p rayo_in) + t_out * Vector_y (Rayo_v rayo_in)
    /\ Punto_z punto_out = Punto_z (Rayo_p rayo_in) + t_out * Vector_z (Rayo_v rayo_in); (* Hay_Interseccion.post.2 *)
  Hay_Interseccion_post_3 : elementos_out
    ≡ (fun e => e ∈ elementos s /\ punto_out ∈ alcance s rayo_in en_in e); (* Hay_Interseccion.post.3 *)
  Hay_Interseccion_post_4 : resultado_out = hit (* Hay_Interseccion.post.4 *)
}.

Record No_Hay_Interseccion (s s' : Escena) (rayo_in : Rayo) (en_in : set Elemento) (resultado_out : Resultado)
  (elementos_out : set Elemento) : Prop := {
  No_Hay_Interseccion_Pregunta : Pregunta s s' rayo_in en_in resultado_out elementos_out;
  No_Hay_Interseccion_pre_1 : alcances s rayo_in en_in ≡ ∅; (* No_Hay_Interseccion.pre.1 *)
  No_Hay_Interseccion_post_1 : elementos_out ≡ ∅; (* No_Hay_Interseccion.post.1 *)
  No_Hay_Interseccion_post_2 : resultado_out = miss (* No_Hay_Interseccion.post.2 *)
}.

Record No_Hay_Minimo (s s' : Escena) (rayo_in : Rayo) (en_in : set Elemento) (resultado_out : Resultado)
  (elementos_out : set Elemento) : Prop := {
  No_Hay_Minimo_Pregunta : Pregunta s s' rayo_in en_in resultado_out elementos_out;
  No_Hay_Minimo_pre_1 : ~ (alcances s rayo_in en_in ≡ ∅); (* No_Hay_Minimo.pre.1 *)
  No_Hay_Minimo_pre_2 : (alcances s rayo_in en_in, Rayo_p rayo_in) ∉ dom reduccion; (* No_Hay_Minimo.pre.2 *)
  No_Hay_Minimo_post_1 : elementos_out ≡ (fun e => e ∈ elementos s /\ ~ (alcance s rayo_in en_in e ≡ ∅)
    /\ (alcance s rayo_in en_in e, Rayo_p rayo_in) ∉ dom reduccion); (* No_Hay_Minimo.post.1 *)
  No_Hay_Minimo_post_2 : resultado_out = no_minimum (* No_Hay_Minimo.post.2 *)
}.

Definition Primera_Interseccion (s s' : Escena) (rayo_in : Rayo) (en_in : set Elemento) (resultado_out : Resultado)
  (elementos_out : set Elemento) (t_out : R) (punto_out : Punto) : Prop :=
  Hay_Interseccion s s' rayo_in en_in resultado_out elementos_out t_out punto_out
  \/ No_Hay_Interseccion s s' rayo_in en_in resultado_out elementos_out
  \/ No_Hay_Minimo s s' rayo_in en_in resultado_out elementos_out. (* Primera_Interseccion.def.1 *)

Definition occluded (s : Escena) (rayo : Rayo) (en : set Elemento) : Prop :=
  ~ (alcances s rayo en ≡ ∅). (* occluded.def.1 *)

Definition occluded_segment (s : Escena) (rayo : Rayo) (en : set Elemento) : Prop :=
  exists (t : R) (punto : Punto), t ∈ Rmas /\ punto ∈ alcances s rayo en /\ t < 1
  /\ Punto_x punto = Punto_x (Rayo_p rayo) + t * Vector_x (Rayo_v rayo)
  /\ Punto_y punto = Punto_y (Rayo_p rayo) + t * Vector_y (Rayo_v rayo)
  /\ Punto_z punto = Punto_z (Rayo_p rayo) + t * Vector_z (Rayo_v rayo). (* occluded_segment.def.1 *)

Definition Primera_Interseccion_conj_1 : Prop :=
  forall (s : Escena) (rayo_in : Rayo) (en_in : set Elemento), Escena_ok s -> rayo_in ∈ Rayo_ok
  -> (exists (s' : Escena) (resultado_out : Resultado) (elementos_out : set Elemento) (t_out : R) (punto_out : Punto),
  Primera_Interseccion s s' rayo_in en_in resultado_out elementos_out t_out punto_out) <-> en_in ⊆ elementos s.
  (* Primera_Interseccion.conj.1 *)

Definition alcances_conj_1 : Prop :=
  forall (s : Escena) (rayo : Rayo) (w : Punto), Escena_ok s -> rayo ∈ Rayo_ok
  -> w ∈ interseccion (puntos_de_escena s) (puntos_de_rayo rayo) <-> w ∈ alcances s rayo ∅. (* alcances.conj.1 *)

Definition de_que_elemento_conj_1 : Prop :=
  forall (s : Escena) (rayo : Rayo) (w : Punto), Escena_ok s -> rayo ∈ Rayo_ok -> w ∈ puntos_de_rayo rayo
  -> (fun e => e ∈ elementos s /\ w ∈ alcance s rayo ∅ e) ≡ de_que_elemento s w. (* de_que_elemento.conj.1 *)

Definition Hay_Interseccion_conj_1 : Prop :=
  forall (s s' : Escena) (rayo_in : Rayo) (en_in : set Elemento) (resultado_out : Resultado) (elementos_out : set
  Elemento) (t_out : R) (punto_out : Punto), Hay_Interseccion s s' rayo_in en_in resultado_out elementos_out t_out
  punto_out -> en_in ≡ ∅ -> elementos_out ≡ de_que_elemento s punto_out. (* Hay_Interseccion.conj.1 *)

(** * distancias.tex *)

Definition cercanos (ps : set Punto) (p : Punto) : set Punto :=
  fun w => w ∈ ps /\ forall otro : Punto, otro ∈ ps -> distancia w p <= distancia otro p. (* cercanos.def.1 *)

Definition a_distancia (ps : set Punto) (p : Punto) (r : R) : Prop :=
  exists w : Punto, w ∈ cercanos ps p /\ r = distancia w p. (* a_distancia.def.1 *)

Definition con_signo (s : Escena) (e : Elemento) (p : Punto) (r : R) : Prop :=
  e ∈ elementos s /\ (exists v1, (e, v1) ∈ de_que_tipo s /\ v1 = soy_esfera)
  /\ exists d : R, a_distancia (puntos_de_elemento s e) p d
  /\ ((exists v1, v1 ∈ potencia s e p /\ v1 < 0) /\ r + d = 0 \/ (exists v1, v1 ∈ potencia s e p /\ v1 >= 0)
  /\ r = d). (* con_signo.def.1 *)

Definition antes (a b : Punto) : Prop :=
  Punto_x a < Punto_x b \/ Punto_x a = Punto_x b
  /\ (Punto_y a < Punto_y b \/ Punto_y a = Punto_y b /\ Punto_z a <= Punto_z b). (* antes.def.1 *)

Definition mas_cercano (s : Escena) (p : Punto) (d : R) (w : Punto) (en : set Elemento) : Prop :=
  w ∈ cercanos (puntos_de_escena s) p /\ d = distancia w p
  /\ (forall otro : Punto, otro ∈ cercanos (puntos_de_escena s) p -> antes w otro)
  /\ en ≡ (fun e => e ∈ elementos s /\ a_distancia (puntos_de_elemento s e) p d). (* mas_cercano.def.1 *)

Definition a_distancia_conj_1 : Prop :=
  forall (ps : set Punto) (p : Punto) (r s1 : R), a_distancia ps p r -> a_distancia ps p s1
  -> r = s1. (* a_distancia.conj.1 *)

Definition a_distancia_conj_2 : Prop :=
  forall (ps : set Punto) (p w : Punto) (r : R), a_distancia ps p r -> distancia w p < r
  -> w ∉ ps. (* a_distancia.conj.2 *)

Definition a_distancia_conj_3 : Prop :=
  forall (ps : set Punto) (p q : Punto) (r s1 : R), a_distancia ps p r -> a_distancia ps q s1
  -> r <= s1 + distancia p q. (* a_distancia.conj.3 *)

Definition a_distancia_conj_4 : Prop :=
  forall (ps : set Punto) (rayo : Rayo) (q w : Punto) (r t u : R), rayo ∈ Rayo_ok
  -> Punto_x q = Punto_x (Rayo_p rayo) + t * Vector_x (Rayo_v rayo)
  -> Punto_y q = Punto_y (Rayo_p rayo) + t * Vector_y (Rayo_v rayo)
  -> Punto_z q = Punto_z (Rayo_p rayo) + t * Vector_z (Rayo_v rayo)
  -> Punto_x w = Punto_x (Rayo_p rayo) + u * Vector_x (Rayo_v rayo)
  -> Punto_y w = Punto_y (Rayo_p rayo) + u * Vector_y (Rayo_v rayo)
  -> Punto_z w = Punto_z (Rayo_p rayo) + u * Vector_z (Rayo_v rayo) -> a_distancia ps q r -> t <= u
  -> (u - t) * raizcuadrada (producto (Rayo_v rayo) (Rayo_v rayo)) < r -> w ∉ ps. (* a_distancia.conj.4 *)

Definition con_signo_conj_1 : Prop :=
  forall (s : Escena) (e : Elemento) (p : Punto) (r : R), Escena_ok s -> e ∈ elementos s
  -> (exists v1, (e, v1) ∈ de_que_tipo s /\ v1 = soy_esfera)
  -> con_signo s e p r <-> (exists v1 v2, (e, v1) ∈ mi_centro s /\ (e, v2) ∈ mi_radio s
  /\ r = distancia p v1 - v2). (* con_signo.conj.1 *)

Definition mas_cercano_conj_1 : Prop :=
  forall (s : Escena) (p w : Punto) (d r : R) (en : set Elemento) (e : Elemento), Escena_ok s
  -> mas_cercano s p d w en -> e ∈ elementos s -> a_distancia (puntos_de_elemento s e) p r -> d <= r
  /\ (e ∈ en <-> r = d). (* mas_cercano.conj.1 *)

(** * iluminacion.tex *)

Definition reflexion (v n r : Vector) : Prop :=
  producto n n > 0 /\ producto n n * (Vector_x r + Vector_x v) = 2 * producto v n * Vector_x n
  /\ producto n n * (Vector_y r + Vector_y v) = 2 * producto v n * Vector_y n
  /\ producto n n * (Vector_z r + Vector_z v) = 2 * producto v n * Vector_z n. (* reflexion.def.1 *)

Definition incidencia (i n : Vector) : Prop :=
  producto i i = 1 /\ producto n n = 1 /\ producto i n >= 0. (* incidencia.def.1 *)

Definition coseno_cuadrado (i n : Vector) (razon : R) : R :=
  1 - cuadrado razon * (1 - cuadrado (producto i n)). (* coseno_cuadrado.def.1 *)

Definition reflexion_total (i n : Vector) (razon : R) : Prop :=
  incidencia i n /\ coseno_cuadrado i n razon < 0. (* reflexion_total.def.1 *)

Definition refraccion (i n : Vector) (razon : R) (t : Vector) : Prop :=
  incidencia i n /\ coseno_cuadrado i n razon >= 0
  /\ Vector_x t = (razon * producto i n - raizcuadrada (coseno_cuadrado i n razon)) * Vector_x n
  - razon * Vector_x i /\ Vector_y t = (razon * producto i n
  - raizcuadrada (coseno_cuadrado i n razon)) * Vector_y n - razon * Vector_y i
  /\ Vector_z t = (razon * producto i n - raizcuadrada (coseno_cuadrado i n razon)) * Vector_z n
  - razon * Vector_z i. (* refraccion.def.1 *)

Definition reflexion_conj_1 : Prop :=
  forall v n r : Vector, reflexion v n r -> producto r r = producto v v /\ producto r n = producto v n
  /\ reflexion r n v. (* reflexion.conj.1 *)

Definition refraccion_conj_1 : Prop :=
  forall (i n : Vector) (razon : R) (t : Vector), razon ∈ Rmas -> refraccion i n razon t -> producto t t = 1
  /\ producto t n <= 0. (* refraccion.conj.1 *)

Definition refraccion_conj_2 : Prop :=
  forall (i n : Vector) (razon : R) (t : Vector), razon ∈ Rmas -> refraccion i n razon t
  -> 1 - cuadrado (producto t n) = cuadrado razon * (1 - cuadrado (producto i n))
  /\ exists a b : R, Vector_x t = a * Vector_x n + b * Vector_x i /\ Vector_y t = a * Vector_y n + b * Vector_y i
  /\ Vector_z t = a * Vector_z n + b * Vector_z i. (* refraccion.conj.2 *)

Definition reflexion_total_conj_1 : Prop :=
  forall (i n : Vector) (razon : R), razon ∈ Rmas -> incidencia i n
  -> ((exists t : Vector, refraccion i n razon t) <-> ~ reflexion_total i n razon)
  /\ (reflexion_total i n razon -> razon > 1). (* reflexion_total.conj.1 *)

Definition refraccion_conj_3 : Prop :=
  forall i n t : Vector, refraccion i n 1 t -> Vector_x t + Vector_x i = 0 /\ Vector_y t + Vector_y i = 0
  /\ Vector_z t + Vector_z i = 0. (* refraccion.conj.3 *)

Definition refraccion_conj_4 : Prop :=
  forall (i n m t : Vector) (razon otra : R), razon ∈ Rmas -> otra ∈ Rmas -> refraccion i n razon t
  -> razon * otra = 1 -> Vector_x m + Vector_x n = 0 -> Vector_y m + Vector_y n = 0 -> Vector_z m + Vector_z n = 0
  -> refraccion t m otra i. (* refraccion.conj.4 *)

(** * luz.tex *)

Definition Parte : set R := fun k => 0 <= k <= 1. (* Parte.inv.1 *)

Definition Cantidad : set R := fun r => r >= 0. (* Cantidad.inv.1 *)

Definition mayor (a b : R) : R := if Rle_dec a b then b else a. (* mayor.def.1 *)

Definition elevado_decl (elevado : R -> R -> R) : Prop :=
  forall x1 x2 : R, x1 ∈ Cantidad -> x2 ∈ Cantidad -> elevado x1 x2 ∈ Cantidad.
Definition elevado_def_1 (elevado : R -> R -> R) : Prop :=
  forall x : R, x ∈ Cantidad -> elevado x 0 = 1 /\ elevado x 1 = x /\ elevado 1 x = 1. (* elevado.def.1 *)
Definition elevado_def_2 (elevado : R -> R -> R) : Prop :=
  forall x a b : R, x ∈ Cantidad -> a ∈ Cantidad -> b ∈ Cantidad
  -> elevado x (a + b) = elevado x a * elevado x b. (* elevado.def.2 *)
Definition elevado_def_3 (elevado : R -> R -> R) : Prop :=
  forall x y a : R, x ∈ Cantidad -> y ∈ Cantidad -> a ∈ Cantidad -> x <= y
  -> elevado x a <= elevado y a. (* elevado.def.3 *)
Definition elevado : R -> R -> R := power_of.

Record Material := mk_Material {
  Material_k_a : R;
  Material_k_d : R;
  Material_k_s : R;
  Material_k_ps : R;
  Material_k_t : R;
  Material_C : R;
  Material_M_PS : R;
  Material_M_T : R;
  Material_emisividad : R;
  Material_A_G : R;
  Material_e : R;
  Material_indice : R
}.

Record Material_ok (s : Material) : Prop := {
  Material_inv_1 : Material_k_a s ∈ Parte; (* Material.inv.1 *)
  Material_inv_2 : Material_k_d s ∈ Parte; (* Material.inv.2 *)
  Material_inv_3 : Material_k_s s ∈ Parte; (* Material.inv.3 *)
  Material_inv_4 : Material_k_ps s ∈ Parte; (* Material.inv.4 *)
  Material_inv_5 : Material_k_t s ∈ Parte; (* Material.inv.5 *)
  Material_inv_6 : Material_C s ∈ Parte; (* Material.inv.6 *)
  Material_inv_7 : Material_M_PS s ∈ Parte; (* Material.inv.7 *)
  Material_inv_8 : Material_M_T s ∈ Parte; (* Material.inv.8 *)
  Material_inv_9 : Material_emisividad s ∈ Cantidad; (* Material.inv.9 *)
  Material_inv_10 : Material_A_G s ∈ Cantidad; (* Material.inv.10 *)
  Material_inv_11 : Material_e s ∈ Cantidad; (* Material.inv.11 *)
  Material_inv_12 : Material_indice s ∈ Rmas (* Material.inv.12 *)
}.

Definition conserva : set Material :=
  fun m => m ∈ Material_ok /\ Material_k_ps m * Material_M_PS m + Material_k_t m * Material_M_T m
  <= 1. (* conserva.def.1 *)

Record Fuente := mk_Fuente {
  Fuente_l : Vector;
  Fuente_S : R;
  Fuente_V : R
}.

Record Fuente_ok (s : Fuente) : Prop := {
  Fuente_inv_1 : Fuente_S s ∈ Cantidad; (* Fuente.inv.1 *)
  Fuente_inv_2 : Fuente_V s = 0 \/ Fuente_V s = 1 (* Fuente.inv.2 *)
}.

Definition visible (s : Escena) (p q : Punto) (en : set Elemento) : Prop :=
  exists rayo : Rayo, rayo ∈ Rayo_ok /\ Rayo_p rayo = p /\ Vector_x (Rayo_v rayo) = Punto_x q - Punto_x p
  /\ Vector_y (Rayo_v rayo) = Punto_y q - Punto_y p /\ Vector_z (Rayo_v rayo) = Punto_z q - Punto_z p
  /\ ~ occluded_segment s rayo en. (* visible.def.1 *)

Definition visible_lejos (s : Escena) (p : Punto) (l : Vector) (en : set Elemento) : Prop :=
  exists rayo : Rayo, rayo ∈ Rayo_ok /\ Rayo_p rayo = p /\ Vector_x (Rayo_v rayo) = Vector_x l
  /\ Vector_y (Rayo_v rayo) = Vector_y l /\ Vector_z (Rayo_v rayo) = Vector_z l
  /\ ~ occluded s rayo en. (* visible_lejos.def.1 *)

Definition ante (s : Escena) (rayo : Rayo) (en : set Elemento) (e : Elemento) (punto : Punto) : Prop :=
  e ∈ elementos s /\ punto ∈ alcance s rayo en e /\ exists t : R, t ∈ Rmas /\ t < 1
  /\ Punto_x punto = Punto_x (Rayo_p rayo) + t * Vector_x (Rayo_v rayo)
  /\ Punto_y punto = Punto_y (Rayo_p rayo) + t * Vector_y (Rayo_v rayo)
  /\ Punto_z punto = Punto_z (Rayo_p rayo) + t * Vector_z (Rayo_v rayo). (* ante.def.1 *)

Definition ante_lejos (s : Escena) (rayo : Rayo) (en : set Elemento) (e : Elemento) (punto : Punto) : Prop :=
  e ∈ elementos s /\ punto ∈ alcance s rayo en e. (* ante_lejos.def.1 *)

Definition enumerado (S : rel Elemento Punto) (n : R) (c : rel R (Elemento * Punto)) : Prop :=
  n >= 0 /\ (forall i : R, i ∈ integers -> 0 <= i < n -> exists v1, (i, v1) ∈ c /\ v1 ∈ S)
  /\ (forall i j : R, i ∈ integers -> j ∈ integers -> 0 <= i < j -> j < n -> exists v1 v2, (i, v1) ∈ c
  /\ (j, v2) ∈ c /\ v1 <> v2) /\ forall a : Elemento * Punto, a ∈ S -> exists i : R, i ∈ integers /\ 0 <= i < n
  /\ exists v1, (i, v1) ∈ c /\ v1 = a. (* enumerado.def.1 *)

Definition atenuado (dada resto : rel R R) : Prop :=
  (exists v1, (0, v1) ∈ resto /\ v1 = 1) /\ forall i : R, i ∈ integers -> i >= 0
  -> exists v1 v2 v3, (i + 1, v1) ∈ resto /\ (i, v2) ∈ resto /\ (i, v3) ∈ dada /\ v1 = v2 * v3. (* atenuado.def.1 *)

Definition transmitido (S : rel Elemento Punto) (paso : rel (Elemento * Punto) R) (k : R) : Prop :=
  exists (n : R) (c : rel R (Elemento * Punto)) (dada resto : rel R R), n ∈ integers /\ c ∈ integers ⟶ univ
  /\ dada ∈ integers ⟶ univ /\ resto ∈ integers ⟶ univ /\ enumerado S n c
  /\ (forall i : R, i ∈ integers -> exists v1 v2 v3, (i, v1) ∈ dada /\ (i, v2) ∈ c /\ (v2, v3) ∈ paso /\ v1 = v3)
  /\ atenuado dada resto /\ exists v1, (n, v1) ∈ resto /\ v1 = k. (* transmitido.def.1 *)

Definition menguada (f : Fuente) (k : R) (g : Fuente) : Prop :=
  Fuente_l g = Fuente_l f /\ Fuente_S g = k * Fuente_S f /\ Fuente_V g = Fuente_V f. (* menguada.def.1 *)

Record Cono_de_Luz := mk_Cono_de_Luz {
  Cono_de_Luz_eje : Vector;
  Cono_de_Luz_pleno : R;
  Cono_de_Luz_borde : R;
  Cono_de_Luz_estrechez : R
}.

Record Cono_de_Luz_ok (s : Cono_de_Luz) : Prop := {
  Cono_de_Luz_inv_1 : producto (Cono_de_Luz_eje s) (Cono_de_Luz_eje s) = 1; (* Cono_de_Luz.inv.1 *)
  Cono_de_Luz_inv_2 : 0 < Cono_de_Luz_borde s /\ Cono_de_Luz_borde s <= Cono_de_Luz_pleno s
    /\ Cono_de_Luz_pleno s <= 1; (* Cono_de_Luz.inv.2 *)
  Cono_de_Luz_inv_3 : Cono_de_Luz_estrechez s ∈ Cantidad (* Cono_de_Luz.inv.3 *)
}.

Definition intensidad (c : Cono_de_Luz) (w : Vector) (k : R) : Prop :=
  producto w w = 1 /\ (producto (Cono_de_Luz_eje c) w < Cono_de_Luz_borde c -> k = 0)
  /\ (producto (Cono_de_Luz_eje c) w >= Cono_de_Luz_pleno c
  -> k = elevado (producto (Cono_de_Luz_eje c) w) (Cono_de_Luz_estrechez c))
  /\ (Cono_de_Luz_borde c <= producto (Cono_de_Luz_eje c) w /\ producto (Cono_de_Luz_eje c) w < Cono_de_Luz_pleno c
  -> (exists x : R, x ∈ Parte /\ x * (Cono_de_Luz_pleno c - Cono_de_Luz_borde c) = producto (Cono_de_Luz_eje c) w
  - Cono_de_Luz_borde c /\ k = elevado (producto (Cono_de_Luz_eje c) w) (Cono_de_Luz_estrechez c) * (x * x * (3
  - 2 * x)))). (* intensidad.def.1 *)

Definition normal_suave (a b c : Vector) (u v : R) (n : Vector) : Prop :=
  Vector_x n = (1 - u - v) * Vector_x a + u * Vector_x b + v * Vector_x c
  /\ Vector_y n = (1 - u - v) * Vector_y a + u * Vector_y b + v * Vector_y c
  /\ Vector_z n = (1 - u - v) * Vector_z a + u * Vector_z b + v * Vector_z c. (* normal_suave.def.1 *)

Definition especular (l n v : Vector) : R := 2 * producto l n * producto v n - producto l v. (* especular.def.1 *)

Definition directa (m : Material) (n v l : Vector) : R :=
  Material_k_a m * Material_C m + Material_k_d m * Material_C m * mayor 0 (producto n l)
  + (if Rgt_dec (producto n l) 0 then Material_k_s m * elevado (mayor 0 (especular l n v)) (Material_e m) else 0).
  (* directa.def.1 *)

Definition aportacion (m : Material) (n v : Vector) (f : Fuente) : R :=
  Fuente_V f * Fuente_S f * directa m n v (Fuente_l f). (* aportacion.def.1 *)

Definition indirecta (m : Material) (r t : R) : R :=
  Material_A_G m + Material_k_ps m * Material_M_PS m * r + Material_k_t m * Material_M_T m * t. (* indirecta.def.1 *)

Definition radiancia (m : Material) (suma r t : R) : R :=
  Material_emisividad m + indirecta m r t + suma. (* radiancia.def.1 *)

Definition acumulado (dada suma : rel R R) : Prop :=
  (exists v1, (0, v1) ∈ suma /\ v1 = 0) /\ forall i : R, i ∈ integers -> i >= 0
  -> exists v1 v2 v3, (i + 1, v1) ∈ suma /\ (i, v2) ∈ suma /\ (i, v3) ∈ dada /\ v1 = v2 + v3. (* acumulado.def.1 *)

Variable Camino : Type.

Record Trazado := mk_Trazado {
  Trazado_llega : set Camino;
  Trazado_fondo : rel Camino R;
  Trazado_material : rel Camino Material;
  Trazado_de_luces : rel Camino R;
  Trazado_reflejado : rel Camino Camino;
  Trazado_refractado : rel Camino Camino
}.

Record Trazado_ok (s : Trazado) : Prop := {
  Trazado_decl_llega : Trazado_llega s ∈ ℙ univ;
  Trazado_decl_fondo : Trazado_fondo s ∈ univ ⟶ univ;
  Trazado_decl_material : Trazado_material s ∈ univ ⟶ Material_ok;
  Trazado_decl_de_luces : Trazado_de_luces s ∈ univ ⟶ univ;
  Trazado_decl_reflejado : Trazado_reflejado s ∈ univ ⟶ univ;
  Trazado_decl_refractado : Trazado_refractado s ∈ univ ⟶ univ
}.

Definition trazador (t : Trazado) (maximo : R) (L : rel (R * Camino) R) : Prop :=
  (forall (n : R) (c : Camino), n ∈ integers -> n > maximo -> exists v1, ((n, c), v1) ∈ L /\ v1 = 0)
  /\ (forall (n : R) (c : Camino), n ∈ integers -> n <= maximo -> c ∉ Trazado_llega t
  -> exists v1 v2, ((n, c), v1) ∈ L /\ (c, v2) ∈ Trazado_fondo t /\ v1 = v2)
  /\ forall (n : R) (c : Camino), n ∈ integers -> n <= maximo -> c ∈ Trazado_llega t
  -> exists v1 v2 v3 v4 v5 v6 v7, ((n, c), v1) ∈ L /\ (c, v2) ∈ Trazado_material t /\ (c, v3) ∈ Trazado_de_luces t
  /\ (c, v4) ∈ Trazado_reflejado t /\ ((n + 1, v4), v5) ∈ L /\ (c, v6) ∈ Trazado_refractado t
  /\ ((n + 1, v6), v7) ∈ L /\ v1 = radiancia v2 v3 v5 v7. (* trazador.def.1 *)

Record Ventana := mk_Ventana {
  Ventana_ojo : Punto;
  Ventana_esquina : Punto;
  Ventana_ancho : Vector;
  Ventana_alto : Vector;
  Ventana_H : R;
  Ventana_V : R
}.

Record Ventana_ok (s : Ventana) : Prop := {
  Ventana_decl_H : Ventana_H s ∈ integers;
  Ventana_decl_V : Ventana_V s ∈ integers;
  Ventana_inv_1 : Ventana_H s >= 1; (* Ventana.inv.1 *)
  Ventana_inv_2 : Ventana_V s >= 1 (* Ventana.inv.2 *)
}.

Definition centro_de_pixel (w : Ventana) (x y : R) (q : Punto) : Prop :=
  0 <= x < Ventana_H w /\ 0 <= y < Ventana_V w
  /\ 2 * Ventana_H w * Ventana_V w * (Punto_x q - Punto_x (Ventana_esquina w))
  = (2 * x + 1) * Ventana_V w * Vector_x (Ventana_ancho w) + (2 * y + 1) * Ventana_H w * Vector_x (Ventana_alto w)
  /\ 2 * Ventana_H w * Ventana_V w * (Punto_y q - Punto_y (Ventana_esquina w))
  = (2 * x + 1) * Ventana_V w * Vector_y (Ventana_ancho w) + (2 * y + 1) * Ventana_H w * Vector_y (Ventana_alto w)
  /\ 2 * Ventana_H w * Ventana_V w * (Punto_z q - Punto_z (Ventana_esquina w))
  = (2 * x + 1) * Ventana_V w * Vector_z (Ventana_ancho w)
  + (2 * y + 1) * Ventana_H w * Vector_z (Ventana_alto w). (* centro_de_pixel.def.1 *)

Definition rayo_de_pixel (w : Ventana) (x y : R) (rayo : Rayo) : Prop :=
  Rayo_p rayo = Ventana_ojo w /\ exists q : Punto, q ∈ puntos_de_rayo rayo
  /\ centro_de_pixel w x y q. (* rayo_de_pixel.def.1 *)

Definition visible_conj_1 : Prop :=
  forall (s : Escena) (p q : Punto) (l : Vector) (en : set Elemento), Escena_ok s
  -> Vector_x l = Punto_x q - Punto_x p -> Vector_y l = Punto_y q - Punto_y p -> Vector_z l = Punto_z q - Punto_z p
  -> visible_lejos s p l en -> visible s p q en. (* visible.conj.1 *)

Definition ante_conj_1 : Prop :=
  forall (s : Escena) (rayo : Rayo) (en : set Elemento), Escena_ok s -> rayo ∈ Rayo_ok
  -> (occluded_segment s rayo en <-> (exists (e : Elemento) (punto : Punto), ante s rayo en e punto))
  /\ (occluded s rayo en <-> (exists (e : Elemento) (punto : Punto), ante_lejos s rayo en e punto)). (* ante.conj.1 *)

Definition transmitido_conj_1 : Prop :=
  forall (S : rel Elemento Punto) (paso : rel (Elemento * Punto) R) (k j : R), paso ∈ univ ⟶ univ
  -> transmitido S paso k -> transmitido S paso j -> k = j. (* transmitido.conj.1 *)

Definition transmitido_conj_2 : Prop :=
  forall (S : rel Elemento Punto) (paso : rel (Elemento * Punto) R) (k : R), paso ∈ univ ⟶ univ
  -> transmitido S paso k -> (S ≡ ∅ -> k = 1)
  /\ ((exists a : Elemento * Punto, a ∈ S /\ exists v1, (a, v1) ∈ paso /\ v1 = 0) -> k = 0). (* transmitido.conj.2 *)

Definition transmitido_conj_3 : Prop :=
  forall (S : rel Elemento Punto) (paso : rel (Elemento * Punto) R) (k : R), paso ∈ univ ⟶ Parte
  -> transmitido S paso k -> k ∈ Parte. (* transmitido.conj.3 *)

Definition menguada_conj_1 : Prop :=
  forall (m : Material) (n v : Vector) (f g : Fuente) (k : R), m ∈ Material_ok -> f ∈ Fuente_ok -> g ∈ Fuente_ok
  -> k ∈ Parte -> menguada f k g -> aportacion m n v g = k * aportacion m n v f. (* menguada.conj.1 *)

Definition intensidad_conj_1 : Prop :=
  forall (c : Cono_de_Luz) (w : Vector), c ∈ Cono_de_Luz_ok -> producto w w = 1
  -> (exists! k : R, intensidad c w k) /\ forall k : R, intensidad c w k -> k ∈ Parte. (* intensidad.conj.1 *)

Definition intensidad_conj_2 : Prop :=
  forall (c : Cono_de_Luz) (w : Vector) (k : R), c ∈ Cono_de_Luz_ok -> intensidad c w k
  -> (w = Cono_de_Luz_eje c -> k = 1) /\ (producto (Cono_de_Luz_eje c) w = Cono_de_Luz_borde c
  /\ Cono_de_Luz_borde c < Cono_de_Luz_pleno c -> k = 0). (* intensidad.conj.2 *)

Definition Material_conj_1 : Prop :=
  forall m n : Material, m ∈ Material_ok -> n ∈ Material_ok -> exists! razon : R, razon ∈ Rmas
  /\ razon * Material_indice n = Material_indice m. (* Material.conj.1 *)

Definition elevado_conj_1 : Prop :=
  forall m : R, 2 * m = 1 -> 20 * elevado m 5 < 1 <= 20 * elevado m 4. (* elevado.conj.1 *)

Definition elevado_conj_2 : Prop :=
  forall c a : R, c ∈ Parte -> a ∈ Cantidad -> elevado c a <= 1. (* elevado.conj.2 *)

Definition coseno_cuadrado_conj_1 : Prop :=
  forall (i n : Vector) (razon : R), razon ∈ Rmas -> incidencia i n -> 2 * cuadrado (producto i n) = 1
  -> 3 * razon = 2 -> 9 * coseno_cuadrado i n razon = 7. (* coseno_cuadrado.conj.1 *)

Definition reflexion_total_conj_2 : Prop :=
  forall (i n : Vector) (razon : R), razon ∈ Rmas -> incidencia i n
  -> (2 * razon = 3 -> reflexion_total i n razon <-> 9 * (1 - cuadrado (producto i n)) > 4)
  /\ (100 * razon = 133 -> reflexion_total i n razon <-> 17689 * (1
  - cuadrado (producto i n)) > 10000). (* reflexion_total.conj.2 *)

Definition normal_suave_conj_1 : Prop :=
  forall (a b c d : Vector) (u : R) (n m : Vector), normal_suave a b c u 0 n -> normal_suave a b d u 0 m
  -> Vector_x n = Vector_x m /\ Vector_y n = Vector_y m /\ Vector_z n = Vector_z m. (* normal_suave.conj.1 *)

Definition normal_suave_conj_2 : Prop :=
  forall (a : Vector) (u v : R) (n : Vector), normal_suave a a a u v n -> Vector_x n = Vector_x a
  /\ Vector_y n = Vector_y a /\ Vector_z n = Vector_z a. (* normal_suave.conj.2 *)

Definition normal_suave_conj_3 : Prop :=
  forall (a b c g : Vector) (u v : R) (n : Vector), normal_suave a b c u v n -> 0 <= u -> 0 <= v -> u + v <= 1
  -> producto a g > 0 -> producto b g > 0 -> producto c g > 0 -> producto n g > 0. (* normal_suave.conj.3 *)

Definition especular_conj_1 : Prop :=
  forall l n r v : Vector, reflexion l n r -> producto n n = 1
  -> especular l n v = producto r v. (* especular.conj.1 *)

Definition especular_conj_2 : Prop := forall l n v : Vector, especular l n v = especular v n l. (* especular.conj.2 *)

Definition directa_conj_1 : Prop :=
  forall (m : Material) (n v l : Vector), m ∈ Material_ok -> producto n l <= 0
  -> directa m n v l = Material_k_a m * Material_C m. (* directa.conj.1 *)

Definition directa_conj_2 : Prop :=
  forall (m : Material) (n v l : Vector), m ∈ Material_ok -> Material_k_s m = 0 -> producto n l >= 0
  -> directa m n v l = Material_C m * (Material_k_a m + Material_k_d m * producto n l). (* directa.conj.2 *)

Definition directa_conj_3 : Prop :=
  forall (m : Material) (n v l : Vector), m ∈ Material_ok -> Material_C m = 0 -> producto n l > 0
  -> (especular l n v >= 0 -> directa m n v l = Material_k_s m * elevado (especular l n v) (Material_e m))
  /\ (especular l n v <= 0 /\ Material_e m > 0 -> directa m n v l = 0). (* directa.conj.3 *)

Definition directa_conj_4 : Prop :=
  forall (m : Material) (n v l : Vector), m ∈ Material_ok -> producto n n = 1 -> producto v v = 1
  -> producto l l = 1 -> 0 <= directa m n v l <= Material_C m * (Material_k_a m + Material_k_d m)
  + Material_k_s m. (* directa.conj.4 *)

Definition aportacion_conj_1 : Prop :=
  forall (m : Material) (n v : Vector) (f g : Fuente) (dada suma : rel R R), m ∈ Material_ok -> f ∈ Fuente_ok
  -> g ∈ Fuente_ok -> dada ∈ integers ⟶ univ -> suma ∈ integers ⟶ univ -> Material_k_d m = 0 -> Material_k_s m = 0
  -> acumulado dada suma -> (exists v1, (0, v1) ∈ dada /\ v1 = aportacion m n v f)
  -> (exists v1, (1, v1) ∈ dada /\ v1 = aportacion m n v g) -> exists v1, (2, v1) ∈ suma
  /\ radiancia m v1 0 0 = Material_emisividad m + Material_A_G m
  + (Fuente_V f * Fuente_S f + Fuente_V g * Fuente_S g) * Material_k_a m * Material_C m. (* aportacion.conj.1 *)

Definition acumulado_conj_1 : Prop :=
  forall (dada suma otra : rel R R) (i : R), dada ∈ integers ⟶ univ -> suma ∈ integers ⟶ univ
  -> otra ∈ integers ⟶ univ -> i ∈ integers -> acumulado dada suma -> acumulado dada otra -> i >= 0
  -> exists v1 v2, (i, v1) ∈ suma /\ (i, v2) ∈ otra /\ v1 = v2. (* acumulado.conj.1 *)

Definition conserva_conj_1 : Prop :=
  forall (m : Material) (r t : R), m ∈ conserva -> r ∈ Cantidad -> t ∈ Cantidad
  -> indirecta m r t <= Material_A_G m + mayor r t. (* conserva.conj.1 *)

Definition trazador_conj_1 : Prop :=
  forall (t : Trazado) (maximo : R), t ∈ Trazado_ok -> maximo ∈ integers
  -> exists L : rel (R * Camino) R, L ∈ cartesian integers univ ⟶ univ /\ trazador t maximo L. (* trazador.conj.1 *)

Definition trazador_conj_2 : Prop :=
  forall (t : Trazado) (maximo : R) (L M : rel (R * Camino) R), t ∈ Trazado_ok -> maximo ∈ integers
  -> L ∈ cartesian integers univ ⟶ univ -> M ∈ cartesian integers univ ⟶ univ -> trazador t maximo L
  -> trazador t maximo M -> L ≡ M. (* trazador.conj.2 *)

Definition trazador_conj_3 : Prop :=
  forall (t : Trazado) (L M : rel (R * Camino) R) (c : Camino), t ∈ Trazado_ok
  -> L ∈ cartesian integers univ ⟶ univ -> M ∈ cartesian integers univ ⟶ univ -> trazador t 0 L -> trazador t 1 M
  -> c ∈ Trazado_llega t -> (exists v1, ((1, c), v1) ∈ L /\ v1 = 0) /\ exists v1 v2 v3, ((1, c), v1) ∈ M
  /\ (c, v2) ∈ Trazado_material t /\ (c, v3) ∈ Trazado_de_luces t /\ v1 = radiancia v2 v3 0 0. (* trazador.conj.3 *)

Definition centro_de_pixel_conj_1 : Prop :=
  forall (w : Ventana) (x y j k : R) (p q : Punto), w ∈ Ventana_ok -> x ∈ integers -> y ∈ integers -> j ∈ integers
  -> k ∈ integers -> centro_de_pixel w x y p -> centro_de_pixel w j k q -> x + j + 1 = Ventana_H w
  -> y + k + 1 = Ventana_V w -> Punto_x p + Punto_x q = 2 * Punto_x (Ventana_esquina w) + Vector_x (Ventana_ancho w)
  + Vector_x (Ventana_alto w) /\ Punto_y p + Punto_y q = 2 * Punto_y (Ventana_esquina w)
  + Vector_y (Ventana_ancho w) + Vector_y (Ventana_alto w)
  /\ Punto_z p + Punto_z q = 2 * Punto_z (Ventana_esquina w) + Vector_z (Ventana_ancho w)
  + Vector_z (Ventana_alto w). (* centro_de_pixel.conj.1 *)

Definition rayo_de_pixel_conj_1 : Prop :=
  forall (w : Ventana) (x y : R) (q : Punto), w ∈ Ventana_ok -> x ∈ integers -> y ∈ integers
  -> centro_de_pixel w x y q -> q <> Ventana_ojo w -> exists rayo : Rayo, rayo ∈ Rayo_ok
  /\ rayo_de_pixel w x y rayo. (* rayo_de_pixel.conj.1 *)

(** * distribuida.tex *)

Record Sorteo := mk_Sorteo {
  Sorteo_n : R;
  Sorteo_p : rel R R
}.

Record Sorteo_ok (s : Sorteo) : Prop := {
  Sorteo_decl_n : Sorteo_n s ∈ integers;
  Sorteo_decl_p : Sorteo_p s ∈ integers ⟶ univ;
  Sorteo_inv_1 : Sorteo_n s >= 1; (* Sorteo.inv.1 *)
  Sorteo_inv_2 : forall i : R, i ∈ integers -> 0 <= i < Sorteo_n s -> exists v1, (i, v1) ∈ Sorteo_p s
    /\ v1 >= 0; (* Sorteo.inv.2 *)
  Sorteo_inv_3 : exists suma : rel R R, suma ∈ integers ⟶ univ /\ acumulado (Sorteo_p s) suma
    /\ exists v1, (Sorteo_n s, v1) ∈ suma /\ v1 = 1 (* Sorteo.inv.3 *)
}.

Definition media (s1 : Sorteo) (x : rel R R) (m : R) : Prop :=
  exists dada suma : rel R R, dada ∈ integers ⟶ univ /\ suma ∈ integers ⟶ univ
  /\ (forall i : R, i ∈ integers -> exists v1 v2 v3, (i, v1) ∈ dada /\ (i, v2) ∈ Sorteo_p s1 /\ (i, v3) ∈ x
  /\ v1 = v2 * v3) /\ acumulado dada suma /\ exists v1, (Sorteo_n s1, v1) ∈ suma /\ v1 = m. (* media.def.1 *)

Definition de_luz_extensa (m : Material) (n v : Vector) (s1 : Sorteo) (F : rel R Fuente) (r : R) : Prop :=
  exists x : rel R R, x ∈ integers ⟶ univ
  /\ (forall i : R, i ∈ integers -> exists v1 v2, (i, v1) ∈ x /\ (i, v2) ∈ F /\ v1 = aportacion m n v v2)
  /\ media s1 x r. (* de_luz_extensa.def.1 *)

Record Lente := mk_Lente {
  Lente_ojo : Punto;
  Lente_eje : Vector;
  Lente_abertura : R;
  Lente_foco : R
}.

Record Lente_ok (s : Lente) : Prop := {
  Lente_inv_1 : producto (Lente_eje s) (Lente_eje s) = 1; (* Lente.inv.1 *)
  Lente_inv_2 : Lente_abertura s ∈ Cantidad; (* Lente.inv.2 *)
  Lente_inv_3 : Lente_foco s ∈ Rmas (* Lente.inv.3 *)
}.

Definition puntos_de_lente (l : Lente) (q : Punto) : Prop :=
  avance q (Lente_ojo l) (Lente_eje l) = 0
  /\ 4 * (cuadrado (Punto_x q - Punto_x (Lente_ojo l)) + cuadrado (Punto_y q - Punto_y (Lente_ojo l))
  + cuadrado (Punto_z q - Punto_z (Lente_ojo l))) <= cuadrado (Lente_abertura l). (* puntos_de_lente.def.1 *)

Definition punto_en_foco (l : Lente) (v : Vector) (f : Punto) : Prop :=
  avance f (Lente_ojo l) (Lente_eje l) = Lente_foco l /\ exists t : R, t ∈ Rmas
  /\ Punto_x f = Punto_x (Lente_ojo l) + t * Vector_x v /\ Punto_y f = Punto_y (Lente_ojo l) + t * Vector_y v
  /\ Punto_z f = Punto_z (Lente_ojo l) + t * Vector_z v. (* punto_en_foco.def.1 *)

Definition rayo_de_lente (l : Lente) (v : Vector) (rayo : Rayo) : Prop :=
  puntos_de_lente l (Rayo_p rayo) /\ exists f : Punto, f ∈ puntos_de_rayo rayo
  /\ punto_en_foco l v f. (* rayo_de_lente.def.1 *)

Definition visto_en_foco (l : Lente) (q w u : Punto) : Prop :=
  avance w (Lente_ojo l) (Lente_eje l) > 0
  /\ avance w (Lente_ojo l) (Lente_eje l) * (Punto_x u - Punto_x q) = Lente_foco l * (Punto_x w - Punto_x q)
  /\ avance w (Lente_ojo l) (Lente_eje l) * (Punto_y u - Punto_y q) = Lente_foco l * (Punto_y w - Punto_y q)
  /\ avance w (Lente_ojo l) (Lente_eje l) * (Punto_z u - Punto_z q)
  = Lente_foco l * (Punto_z w - Punto_z q). (* visto_en_foco.def.1 *)

Definition circulo_de_confusion (l : Lente) (z c : R) : Prop :=
  c * z = Lente_abertura l * mayor (z - Lente_foco l) (Lente_foco l - z). (* circulo_de_confusion.def.1 *)

Definition desplazado (p : Punto) (v : Vector) (t : R) (q : Punto) : Prop :=
  Punto_x q = Punto_x p + t * Vector_x v /\ Punto_y q = Punto_y p + t * Vector_y v
  /\ Punto_z q = Punto_z p + t * Vector_z v. (* desplazado.def.1 *)

Definition repartida (p q : Sorteo) (w o f x y : rel R R) : Prop :=
  Sorteo_n p = Sorteo_n q /\ forall i : R, i ∈ integers -> 0 <= i < Sorteo_n p
  -> (exists v1 v2, (i, v1) ∈ w /\ (i, v2) ∈ o /\ v1 + v2 = 1)
  /\ (exists v1 v2 v3 v4, (i, v1) ∈ Sorteo_p p /\ (i, v2) ∈ x /\ (i, v3) ∈ w /\ (i, v4) ∈ f /\ v1 * v2 = v3 * v4)
  /\ exists v1 v2 v3 v4, (i, v1) ∈ Sorteo_p q /\ (i, v2) ∈ y /\ (i, v3) ∈ o /\ (i, v4) ∈ f
  /\ v1 * v2 = v3 * v4. (* repartida.def.1 *)

Definition ruleta (c x y : R) : Prop := c * y = x. (* ruleta.def.1 *)

Definition media_conj_1 : Prop :=
  forall (s1 : Sorteo) (x : rel R R), s1 ∈ Sorteo_ok -> x ∈ integers ⟶ univ
  -> exists! m : R, media s1 x m. (* media.conj.1 *)

Definition media_conj_2 : Prop :=
  forall (s1 : Sorteo) (x : rel R R) (m a b : R), s1 ∈ Sorteo_ok -> x ∈ integers ⟶ univ -> media s1 x m
  -> (forall i : R, i ∈ integers -> 0 <= i < Sorteo_n s1 -> exists v1, (i, v1) ∈ x /\ a <= v1 <= b)
  -> a <= m <= b. (* media.conj.2 *)

Definition de_luz_extensa_conj_1 : Prop :=
  forall (m : Material) (n v : Vector) (s1 : Sorteo) (F : rel R Fuente) (f : Fuente) (r : R), m ∈ Material_ok
  -> s1 ∈ Sorteo_ok -> F ∈ integers ⟶ Fuente_ok -> f ∈ Fuente_ok -> de_luz_extensa m n v s1 F r
  -> (forall i : R, i ∈ integers -> exists v1, (i, v1) ∈ F /\ v1 = f)
  -> r = aportacion m n v f. (* de_luz_extensa.conj.1 *)

Definition rayo_de_lente_conj_1 : Prop :=
  forall (l : Lente) (v : Vector) (r s1 : Rayo), l ∈ Lente_ok -> r ∈ Rayo_ok -> s1 ∈ Rayo_ok -> rayo_de_lente l v r
  -> rayo_de_lente l v s1 -> exists f : Punto, f ∈ puntos_de_rayo r /\ f ∈ puntos_de_rayo s1
  /\ avance f (Lente_ojo l) (Lente_eje l) = Lente_foco l. (* rayo_de_lente.conj.1 *)

Definition circulo_de_confusion_conj_1 : Prop :=
  forall (l : Lente) (q w u k : Punto) (z c : R), l ∈ Lente_ok -> z ∈ Rmas -> c ∈ Cantidad -> puntos_de_lente l q
  -> avance w (Lente_ojo l) (Lente_eje l) = z -> visto_en_foco l q w u -> visto_en_foco l (Lente_ojo l) w k
  -> circulo_de_confusion l z c -> 4 * (cuadrado (Punto_x u - Punto_x k) + cuadrado (Punto_y u - Punto_y k)
  + cuadrado (Punto_z u - Punto_z k)) <= cuadrado c. (* circulo_de_confusion.conj.1 *)

Definition circulo_de_confusion_conj_2 : Prop :=
  forall (l : Lente) (z F a b c d : R), l ∈ Lente_ok -> z ∈ Rmas -> F ∈ Rmas -> a ∈ Rmas -> b ∈ Rmas
  -> c ∈ Cantidad -> d ∈ Cantidad -> F * (Lente_foco l + a) = Lente_foco l * a -> F * (z + b) = z * b
  -> d * b = Lente_abertura l * mayor (a - b) (b - a) -> circulo_de_confusion l z c
  -> d * Lente_foco l = a * c. (* circulo_de_confusion.conj.2 *)

Definition desplazado_conj_1 : Prop :=
  forall (p q c d : Punto) (v dir : Vector) (t r : R), r ∈ Rmas -> desplazado p v t q -> desplazado c v t d
  -> potencia_esfera q d r = potencia_esfera p c r /\ avance q d dir = avance p c dir
  /\ alejamiento q d dir = alejamiento p c dir. (* desplazado.conj.1 *)

Definition repartida_conj_1 : Prop :=
  forall (p q : Sorteo) (w o f x y suma : rel R R) (m k : R), p ∈ Sorteo_ok -> q ∈ Sorteo_ok -> w ∈ integers ⟶ univ
  -> o ∈ integers ⟶ univ -> f ∈ integers ⟶ univ -> x ∈ integers ⟶ univ -> y ∈ integers ⟶ univ
  -> suma ∈ integers ⟶ univ -> repartida p q w o f x y -> acumulado f suma -> media p x m -> media q y k
  -> exists v1, (Sorteo_n p, v1) ∈ suma /\ v1 = m + k. (* repartida.conj.1 *)

Definition ruleta_conj_1 : Prop :=
  forall (s1 : Sorteo) (z : rel R R) (c x y m : R), s1 ∈ Sorteo_ok -> z ∈ integers ⟶ univ -> ruleta c x y
  -> Sorteo_n s1 = 2 -> (exists v1, (0, v1) ∈ Sorteo_p s1 /\ v1 = c) -> (exists v1, (0, v1) ∈ z /\ v1 = y)
  -> (exists v1, (1, v1) ∈ z /\ v1 = 0) -> media s1 z m -> m = x. (* ruleta.conj.1 *)

(** * haces.tex *)

Definition cono_de_rayos (eje rayo : Rayo) (c : R) : Prop :=
  Rayo_p rayo = Rayo_p eje /\ producto (Rayo_v eje) (Rayo_v rayo) > 0
  /\ cuadrado (producto (Rayo_v eje) (Rayo_v rayo)) >= c * producto (Rayo_v eje) (Rayo_v eje) * producto (Rayo_v rayo)
  (Rayo_v rayo). (* cono_de_rayos.def.1 *)

Definition cubierto (s : Escena) (eje rayo : Rayo) (c : R) (e : Elemento) : Prop :=
  cono_de_rayos eje rayo c /\ e ∈ elementos s /\ ~ (alcance s rayo ∅ e ≡ ∅). (* cubierto.def.1 *)

Definition haz (o : Punto) (base : set Punto) (rayo : Rayo) : Prop :=
  Rayo_p rayo = o /\ exists q : Punto, q ∈ base /\ q ∈ puntos_de_rayo rayo. (* haz.def.1 *)

Definition seccion (o : Punto) (base : set Punto) (a : Punto) (n : Vector) (w : Punto) : Prop :=
  avance w a n = 0 /\ exists rayo : Rayo, rayo ∈ Rayo_ok /\ haz o base rayo
  /\ w ∈ puntos_de_rayo rayo. (* seccion.def.1 *)

Definition imagen (a : Punto) (n : Vector) (p q : Punto) : Prop :=
  producto n n > 0 /\ producto n n * (Punto_x q - Punto_x p) + 2 * avance p a n * Vector_x n = 0
  /\ producto n n * (Punto_y q - Punto_y p) + 2 * avance p a n * Vector_y n = 0
  /\ producto n n * (Punto_z q - Punto_z p) + 2 * avance p a n * Vector_z n = 0. (* imagen.def.1 *)

Record Desvio := mk_Desvio {
  Desvio_x : R;
  Desvio_y : R;
  Desvio_u : R;
  Desvio_v : R
}.

Record Matriz := mk_Matriz {
  Matriz_x : Desvio;
  Matriz_y : Desvio;
  Matriz_u : Desvio;
  Matriz_v : Desvio
}.

Record Pincel := mk_Pincel {
  Pincel_eje : Rayo;
  Pincel_m : Matriz
}.

Record Pincel_ok (s : Pincel) : Prop := {
  Pincel_decl_eje : Pincel_eje s ∈ Rayo_ok
}.

Definition aplicado (m : Matriz) (d e : Desvio) : Prop :=
  Desvio_x e = Desvio_x (Matriz_x m) * Desvio_x d + Desvio_y (Matriz_x m) * Desvio_y d
  + Desvio_u (Matriz_x m) * Desvio_u d + Desvio_v (Matriz_x m) * Desvio_v d
  /\ Desvio_y e = Desvio_x (Matriz_y m) * Desvio_x d + Desvio_y (Matriz_y m) * Desvio_y d
  + Desvio_u (Matriz_y m) * Desvio_u d + Desvio_v (Matriz_y m) * Desvio_v d
  /\ Desvio_u e = Desvio_x (Matriz_u m) * Desvio_x d + Desvio_y (Matriz_u m) * Desvio_y d
  + Desvio_u (Matriz_u m) * Desvio_u d + Desvio_v (Matriz_u m) * Desvio_v d
  /\ Desvio_v e = Desvio_x (Matriz_v m) * Desvio_x d + Desvio_y (Matriz_v m) * Desvio_y d
  + Desvio_u (Matriz_v m) * Desvio_u d + Desvio_v (Matriz_v m) * Desvio_v d. (* aplicado.def.1 *)

Definition traslado (t : R) (d e : Desvio) : Prop :=
  Desvio_x e = Desvio_x d + t * Desvio_u d /\ Desvio_y e = Desvio_y d + t * Desvio_v d /\ Desvio_u e = Desvio_u d
  /\ Desvio_v e = Desvio_v d. (* traslado.def.1 *)

Definition refraccion_paraxial (r razon : R) (d e : Desvio) : Prop :=
  Desvio_x e = Desvio_x d /\ Desvio_y e = Desvio_y d
  /\ r * (Desvio_u e - razon * Desvio_u d) = (razon - 1) * Desvio_x d
  /\ r * (Desvio_v e - razon * Desvio_v d) = (razon - 1) * Desvio_y d. (* refraccion_paraxial.def.1 *)

Definition cono_de_rayos_conj_1 : Prop :=
  forall eje rayo : Rayo, eje ∈ Rayo_ok -> rayo ∈ Rayo_ok -> cono_de_rayos eje rayo 1
  -> puntos_de_rayo rayo ≡ puntos_de_rayo eje. (* cono_de_rayos.conj.1 *)

Definition cono_de_rayos_conj_2 : Prop :=
  forall (eje rayo : Rayo) (c d : R), eje ∈ Rayo_ok -> rayo ∈ Rayo_ok -> c ∈ Parte -> d ∈ Parte
  -> cono_de_rayos eje rayo c -> d <= c -> cono_de_rayos eje rayo d. (* cono_de_rayos.conj.2 *)

Definition imagen_conj_1 : Prop :=
  forall (a p q : Punto) (n : Vector), imagen a n p q -> imagen a n q p. (* imagen.conj.1 *)

Definition imagen_conj_2 : Prop :=
  forall (a o i q : Punto) (n v r : Vector), imagen a n o i -> avance q a n = 0
  -> Vector_x v = Punto_x o - Punto_x q -> Vector_y v = Punto_y o - Punto_y q -> Vector_z v = Punto_z o - Punto_z q
  -> Vector_x r = Punto_x q - Punto_x i -> Vector_y r = Punto_y q - Punto_y i -> Vector_z r = Punto_z q - Punto_z i
  -> reflexion v n r. (* imagen.conj.2 *)

Definition haz_conj_1 : Prop :=
  forall (a o i : Punto) (n : Vector) (base : set Punto) (rayo otro : Rayo), rayo ∈ Rayo_ok -> otro ∈ Rayo_ok
  -> imagen a n o i -> haz o base rayo -> Rayo_p otro = i
  -> (forall p q : Punto, p ∈ puntos_de_rayo rayo -> imagen a n p q -> q ∈ puntos_de_rayo otro)
  -> haz i (fun q => exists p : Punto, p ∈ base /\ imagen a n p q) otro. (* haz.conj.1 *)

Definition haz_conj_2 : Prop :=
  forall (o : Punto) (n : Vector) (base : set Punto) (rayo : Rayo), rayo ∈ Rayo_ok -> haz o base rayo
  -> ~ (haz o (fun q => q ∈ base /\ avance q o n >= 0) rayo <-> haz o (fun q => q ∈ base
  /\ avance q o n < 0) rayo). (* haz.conj.2 *)

Definition aplicado_conj_1 : Prop :=
  forall m n : Matriz, exists p : Matriz, forall d e f : Desvio, aplicado m d e -> aplicado n e f
  -> aplicado p d f. (* aplicado.conj.1 *)

Definition traslado_conj_1 : Prop :=
  forall t : R, exists m : Matriz, forall d e : Desvio, traslado t d e <-> aplicado m d e. (* traslado.conj.1 *)

Definition traslado_conj_2 : Prop :=
  forall (s1 t : R) (d e f : Desvio), traslado s1 d e -> traslado t e f
  -> traslado (s1 + t) d f. (* traslado.conj.2 *)

Definition refraccion_paraxial_conj_1 : Prop :=
  forall (r n k s1 : R) (a b c d e : Desvio), r ∈ Rmas -> n ∈ Rmas -> k ∈ Rmas -> n > 1 -> n * k = 1
  -> 2 * (n - 1) * (s1 + r) = n * r -> Desvio_u a = 0 -> Desvio_v a = 0 -> refraccion_paraxial r k a b
  -> traslado (2 * r) b c -> refraccion_paraxial (0 - r) n c d -> traslado s1 d e -> Desvio_x e = 0
  /\ Desvio_y e = 0. (* refraccion_paraxial.conj.1 *)

(** * instancias.tex *)

Definition mixto (a b c : Vector) : R :=
  Vector_x a * (Vector_y b * Vector_z c - Vector_z b * Vector_y c)
  + Vector_y a * (Vector_z b * Vector_x c - Vector_x b * Vector_z c)
  + Vector_z a * (Vector_x b * Vector_y c - Vector_y b * Vector_x c). (* mixto.def.1 *)

Record Mapa := mk_Mapa {
  Mapa_centro : Punto;
  Mapa_x : Vector;
  Mapa_y : Vector;
  Mapa_z : Vector
}.

Record Mapa_ok (s : Mapa) : Prop := {
  Mapa_inv_1 : mixto (Mapa_x s) (Mapa_y s) (Mapa_z s) <> 0 (* Mapa.inv.1 *)
}.

Definition puesto (m : Mapa) (u w : Punto) : Prop :=
  Punto_x w = Punto_x (Mapa_centro m) + Punto_x u * Vector_x (Mapa_x m) + Punto_y u * Vector_x (Mapa_y m)
  + Punto_z u * Vector_x (Mapa_z m) /\ Punto_y w = Punto_y (Mapa_centro m) + Punto_x u * Vector_y (Mapa_x m)
  + Punto_y u * Vector_y (Mapa_y m) + Punto_z u * Vector_y (Mapa_z m)
  /\ Punto_z w = Punto_z (Mapa_centro m) + Punto_x u * Vector_z (Mapa_x m) + Punto_y u * Vector_z (Mapa_y m)
  + Punto_z u * Vector_z (Mapa_z m). (* puesto.def.1 *)

Definition dirigido (m : Mapa) (u w : Vector) : Prop :=
  Vector_x w = Vector_x u * Vector_x (Mapa_x m) + Vector_y u * Vector_x (Mapa_y m)
  + Vector_z u * Vector_x (Mapa_z m) /\ Vector_y w = Vector_x u * Vector_y (Mapa_x m)
  + Vector_y u * Vector_y (Mapa_y m) + Vector_z u * Vector_y (Mapa_z m)
  /\ Vector_z w = Vector_x u * Vector_z (Mapa_x m) + Vector_y u * Vector_z (Mapa_y m)
  + Vector_z u * Vector_z (Mapa_z m). (* dirigido.def.1 *)

Definition visto (m : Mapa) (w u : Punto) : Prop :=
  exists q : Vector, Vector_x q = Punto_x w - Punto_x (Mapa_centro m)
  /\ Vector_y q = Punto_y w - Punto_y (Mapa_centro m) /\ Vector_z q = Punto_z w - Punto_z (Mapa_centro m)
  /\ mixto (Mapa_x m) (Mapa_y m) (Mapa_z m) * Punto_x u = mixto q (Mapa_y m) (Mapa_z m)
  /\ mixto (Mapa_x m) (Mapa_y m) (Mapa_z m) * Punto_y u = mixto (Mapa_x m) q (Mapa_z m)
  /\ mixto (Mapa_x m) (Mapa_y m) (Mapa_z m) * Punto_z u = mixto (Mapa_x m) (Mapa_y m) q. (* visto.def.1 *)

Definition visto_conj_1 : Prop :=
  forall (m : Mapa) (w u : Punto), m ∈ Mapa_ok -> puesto m u w <-> visto m w u. (* visto.conj.1 *)

Definition copia (m : Mapa) (ps : set Punto) : set Punto :=
  fun w => exists u : Punto, u ∈ ps /\ puesto m u w. (* copia.def.1 *)

Definition copia_conj_1 : Prop :=
  forall (m : Mapa) (ps : set Punto) (u w : Punto), m ∈ Mapa_ok -> puesto m u w
  -> w ∈ copia m ps <-> u ∈ ps. (* copia.conj.1 *)

Definition movido (m : Mapa) (rayo otro : Rayo) : Prop :=
  puesto m (Rayo_p otro) (Rayo_p rayo) /\ dirigido m (Rayo_v otro) (Rayo_v rayo). (* movido.def.1 *)

Definition movido_conj_1 : Prop :=
  forall (m : Mapa) (rayo : Rayo), m ∈ Mapa_ok -> rayo ∈ Rayo_ok -> exists otro : Rayo, otro ∈ Rayo_ok
  /\ movido m rayo otro. (* movido.conj.1 *)

Definition movido_conj_2 : Prop :=
  forall (m : Mapa) (rayo otro : Rayo) (u w : Punto) (t : R), m ∈ Mapa_ok -> rayo ∈ Rayo_ok -> otro ∈ Rayo_ok
  -> movido m rayo otro -> Punto_x u = Punto_x (Rayo_p otro) + t * Vector_x (Rayo_v otro)
  -> Punto_y u = Punto_y (Rayo_p otro) + t * Vector_y (Rayo_v otro)
  -> Punto_z u = Punto_z (Rayo_p otro) + t * Vector_z (Rayo_v otro)
  -> Punto_x w = Punto_x (Rayo_p rayo) + t * Vector_x (Rayo_v rayo)
  -> Punto_y w = Punto_y (Rayo_p rayo) + t * Vector_y (Rayo_v rayo)
  -> Punto_z w = Punto_z (Rayo_p rayo) + t * Vector_z (Rayo_v rayo) -> puesto m u w. (* movido.conj.2 *)

Definition copia_conj_2 : Prop :=
  forall (m : Mapa) (ps : set Punto) (rayo otro : Rayo) (u w : Punto), m ∈ Mapa_ok -> rayo ∈ Rayo_ok
  -> otro ∈ Rayo_ok -> movido m rayo otro -> puesto m u w
  -> w ∈ cercanos (interseccion (copia m ps) (puntos_de_rayo rayo)) (Rayo_p rayo) <-> u
  ∈ cercanos (interseccion ps (puntos_de_rayo otro)) (Rayo_p otro). (* copia.conj.2 *)

Definition copia_conj_3 : Prop :=
  forall (m : Mapa) (ps qs : set Punto), m ∈ Mapa_ok
  -> copia m (ps ∪ qs) ≡ copia m ps ∪ copia m qs. (* copia.conj.3 *)

Definition compuesto (m n k : Mapa) : Prop :=
  puesto m (Mapa_centro n) (Mapa_centro k) /\ dirigido m (Mapa_x n) (Mapa_x k) /\ dirigido m (Mapa_y n) (Mapa_y k)
  /\ dirigido m (Mapa_z n) (Mapa_z k). (* compuesto.def.1 *)

Definition compuesto_conj_1 : Prop :=
  forall (m n k : Mapa) (ps : set Punto), m ∈ Mapa_ok -> n ∈ Mapa_ok -> k ∈ Mapa_ok -> compuesto m n k
  -> copia k ps ≡ copia m (copia n ps). (* compuesto.conj.1 *)

Definition compuesto_conj_2 : Prop :=
  forall m n : Mapa, m ∈ Mapa_ok -> n ∈ Mapa_ok -> exists k : Mapa, k ∈ Mapa_ok /\ compuesto m n k
  /\ mixto (Mapa_x k) (Mapa_y k) (Mapa_z k)
  = mixto (Mapa_x m) (Mapa_y m) (Mapa_z m) * mixto (Mapa_x n) (Mapa_y n) (Mapa_z n). (* compuesto.conj.2 *)

Definition identidad : set Mapa :=
  fun m => m ∈ Mapa_ok /\ Punto_x (Mapa_centro m) = 0 /\ Punto_y (Mapa_centro m) = 0 /\ Punto_z (Mapa_centro m) = 0
  /\ Vector_x (Mapa_x m) = 1 /\ Vector_y (Mapa_x m) = 0 /\ Vector_z (Mapa_x m) = 0 /\ Vector_x (Mapa_y m) = 0
  /\ Vector_y (Mapa_y m) = 1 /\ Vector_z (Mapa_y m) = 0 /\ Vector_x (Mapa_z m) = 0 /\ Vector_y (Mapa_z m) = 0
  /\ Vector_z (Mapa_z m) = 1. (* identidad.def.1 *)

Definition identidad_conj_1 : Prop :=
  forall (m : Mapa) (ps : set Punto), m ∈ Mapa_ok -> m ∈ identidad -> copia m ps ≡ ps. (* identidad.conj.1 *)

Definition estirado (m : Mapa) (r h : R) : Prop :=
  Vector_x (Mapa_x m) = r /\ Vector_y (Mapa_x m) = 0 /\ Vector_z (Mapa_x m) = 0 /\ Vector_x (Mapa_y m) = 0
  /\ Vector_y (Mapa_y m) = r /\ Vector_z (Mapa_y m) = 0 /\ Vector_x (Mapa_z m) = 0 /\ Vector_y (Mapa_z m) = 0
  /\ Vector_z (Mapa_z m) = h. (* estirado.def.1 *)

Definition estirado_conj_1 : Prop :=
  forall (m : Mapa) (o : Punto) (r : R), m ∈ Mapa_ok -> r ∈ Rmas -> estirado m r r -> Punto_x o = 0
  -> Punto_y o = 0 -> Punto_z o = 0 -> copia m (puntos_esfera o 1)
  ≡ puntos_esfera (Mapa_centro m) r. (* estirado.conj.1 *)

Definition estirado_conj_2 : Prop :=
  forall (m : Mapa) (o : Punto) (d : Vector) (r h : R), m ∈ Mapa_ok -> d ∈ Unitario -> r ∈ Rmas -> h ∈ Rmas
  -> estirado m r h -> Punto_x o = 0 -> Punto_y o = 0 -> Punto_z o = 0 -> Vector_x d = 0 -> Vector_y d = 0
  -> Vector_z d = 1 -> copia m (puntos_cilindro o 1 d 1)
  ≡ puntos_cilindro (Mapa_centro m) r d h. (* estirado.conj.2 *)

Definition estirado_conj_3 : Prop :=
  forall (m : Mapa) (o : Punto) (d : Vector) (r h k : R), m ∈ Mapa_ok -> d ∈ Unitario -> r ∈ Rmas -> h ∈ Rmas
  -> k ∈ Rmas -> estirado m r h -> Punto_x o = 0 -> Punto_y o = 0 -> Punto_z o = 0 -> Vector_x d = 0
  -> Vector_y d = 0 -> Vector_z d = 1 -> k * h = r
  -> copia m (puntos_cono o 1 d 1) ≡ puntos_cono (Mapa_centro m) k d h. (* estirado.conj.3 *)

Definition puntos_de_instancia (s : Escena) (m : Mapa) (e : Elemento) : set Punto :=
  fun x1 => e ∈ elementos s /\ x1 ∈ copia m (puntos_de_elemento s e). (* puntos_de_instancia.def.1 *)

Definition instancia_desde (s : Escena) (m : Mapa) (e : Elemento) (p : Punto) : set Punto :=
  fun w => e ∈ elementos s /\ exists o u : Punto, puesto m o p /\ puesto m u w
  /\ u ∈ puntos_desde s e o. (* instancia_desde.def.1 *)

Definition instancia_desde_conj_1 : Prop :=
  forall (s : Escena) (m : Mapa) (e : Elemento) (rayo otro : Rayo) (u w : Punto), Escena_ok s -> m ∈ Mapa_ok
  -> rayo ∈ Rayo_ok -> otro ∈ Rayo_ok -> e ∈ elementos s -> movido m rayo otro -> puesto m u w
  -> (w ∈ interseccion (puntos_de_rayo rayo) (instancia_desde s m e (Rayo_p rayo)) <-> u ∈ alcance s otro ⦃e⦄ e)
  /\ (w ∈ interseccion (puntos_de_rayo rayo) (puntos_de_instancia s m e) <-> u
  ∈ alcance s otro ∅ e). (* instancia_desde.conj.1 *)

(** * operaciones.tex *)

Record Agregar_Elemento (s s' : Escena) (e_in : Elemento) (t_in : Tipo) (r_out : Respuesta) : Prop := {
  Agregar_Elemento_Delta : Delta_Escena s s';
  Agregar_Elemento_pre_1 : e_in ∉ elementos s; (* Agregar_Elemento.pre.1 *)
  Agregar_Elemento_post_1 : elementos s' ≡ elementos s ∪ ⦃e_in⦄; (* Agregar_Elemento.post.1 *)
  Agregar_Elemento_post_2 : de_que_tipo s' ≡ de_que_tipo s ∪ ⦃(e_in, t_in)⦄ (* Agregar_Elemento.post.2 *)
}.

Record Eliminar_Elemento (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop := {
  Eliminar_Elemento_Delta : Delta_Escena s s';
  Eliminar_Elemento_pre_1 : e_in ∈ elementos s; (* Eliminar_Elemento.pre.1 *)
  Eliminar_Elemento_post_1 : elementos s' ≡ elementos s ∖ ⦃e_in⦄; (* Eliminar_Elemento.post.1 *)
  Eliminar_Elemento_post_2 : de_que_tipo s' ≡ ndres ⦃e_in⦄ (de_que_tipo s) (* Eliminar_Elemento.post.2 *)
}.

Record Agregar_Esfera (s s' : Escena) (e_in : Elemento) (t_in : Tipo) (r_out : Respuesta) (centro_in : Punto)
  (radio_in : R) : Prop := {
  Agregar_Esfera_Agregar_Elemento : Agregar_Elemento s s' e_in t_in r_out;
  Agregar_Esfera_pre_1 : t_in = soy_esfera; (* Agregar_Esfera.pre.1 *)
  Agregar_Esfera_pre_2 : radio_in ∈ Rmas; (* Agregar_Esfera.pre.2 *)
  Agregar_Esfera_post_1 : mi_centro s' ≡ mi_centro s ∪ ⦃(e_in, centro_in)⦄; (* Agregar_Esfera.post.1 *)
  Agregar_Esfera_post_2 : mi_radio s' ≡ mi_radio s ∪ ⦃(e_in, radio_in)⦄; (* Agregar_Esfera.post.2 *)
  Agregar_Esfera_post_3 : mi_vector s' ≡ mi_vector s; (* Agregar_Esfera.post.3 *)
  Agregar_Esfera_post_4 : mi_altura s' ≡ mi_altura s; (* Agregar_Esfera.post.4 *)
  Agregar_Esfera_post_5 : mi_proporcion s' ≡ mi_proporcion s; (* Agregar_Esfera.post.5 *)
  Agregar_Esfera_post_6 : mi_vertices s' ≡ mi_vertices s; (* Agregar_Esfera.post.6 *)
  Agregar_Esfera_post_7 : r_out = esfera_agregada (* Agregar_Esfera.post.7 *)
}.

Record Agregar_Cilindro (s s' : Escena) (e_in : Elemento) (t_in : Tipo) (r_out : Respuesta) (centro_in : Punto)
  (radio_in : R) (vector_in : Vector) (altura_in : R) : Prop := {
  Agregar_Cilindro_Agregar_Elemento : Agregar_Elemento s s' e_in t_in r_out;
  Agregar_Cilindro_pre_1 : t_in = soy_cilindro; (* Agregar_Cilindro.pre.1 *)
  Agregar_Cilindro_pre_2 : radio_in ∈ Rmas; (* Agregar_Cilindro.pre.2 *)
  Agregar_Cilindro_pre_3 : vector_in ∈ Unitario; (* Agregar_Cilindro.pre.3 *)
  Agregar_Cilindro_pre_4 : altura_in ∈ Rmas; (* Agregar_Cilindro.pre.4 *)
  Agregar_Cilindro_post_1 : mi_centro s' ≡ mi_centro s ∪ ⦃(e_in, centro_in)⦄; (* Agregar_Cilindro.post.1 *)
  Agregar_Cilindro_post_2 : mi_radio s' ≡ mi_radio s ∪ ⦃(e_in, radio_in)⦄; (* Agregar_Cilindro.post.2 *)
  Agregar_Cilindro_post_3 : mi_vector s' ≡ mi_vector s ∪ ⦃(e_in, vector_in)⦄; (* Agregar_Cilindro.post.3 *)
  Agregar_Cilindro_post_4 : mi_altura s' ≡ mi_altura s ∪ ⦃(e_in, altura_in)⦄; (* Agregar_Cilindro.post.4 *)
  Agregar_Cilindro_post_5 : mi_proporcion s' ≡ mi_proporcion s; (* Agregar_Cilindro.post.5 *)
  Agregar_Cilindro_post_6 : mi_vertices s' ≡ mi_vertices s; (* Agregar_Cilindro.post.6 *)
  Agregar_Cilindro_post_7 : r_out = cilindro_agregado (* Agregar_Cilindro.post.7 *)
}.

Record Agregar_Cono (s s' : Escena) (e_in : Elemento) (t_in : Tipo) (r_out : Respuesta) (centro_in : Punto)
  (proporcion_in : R) (vector_in : Vector) (altura_in : R) : Prop := {
  Agregar_Cono_Agregar_Elemento : Agregar_Elemento s s' e_in t_in r_out;
  Agregar_Cono_pre_1 : t_in = soy_cono; (* Agregar_Cono.pre.1 *)
  Agregar_Cono_pre_2 : proporcion_in ∈ Rmas; (* Agregar_Cono.pre.2 *)
  Agregar_Cono_pre_3 : vector_in ∈ Unitario; (* Agregar_Cono.pre.3 *)
  Agregar_Cono_pre_4 : altura_in ∈ Rmas; (* Agregar_Cono.pre.4 *)
  Agregar_Cono_post_1 : mi_centro s' ≡ mi_centro s ∪ ⦃(e_in, centro_in)⦄; (* Agregar_Cono.post.1 *)
  Agregar_Cono_post_2 : mi_radio s' ≡ mi_radio s; (* Agregar_Cono.post.2 *)
  Agregar_Cono_post_3 : mi_vector s' ≡ mi_vector s ∪ ⦃(e_in, vector_in)⦄; (* Agregar_Cono.post.3 *)
  Agregar_Cono_post_4 : mi_altura s' ≡ mi_altura s ∪ ⦃(e_in, altura_in)⦄; (* Agregar_Cono.post.4 *)
  Agregar_Cono_post_5 : mi_proporcion s' ≡ mi_proporcion s ∪ ⦃(e_in, proporcion_in)⦄; (* Agregar_Cono.post.5 *)
  Agregar_Cono_post_6 : mi_vertices s' ≡ mi_vertices s; (* Agregar_Cono.post.6 *)
  Agregar_Cono_post_7 : r_out = cono_agregado (* Agregar_Cono.post.7 *)
}.

Record Agregar_Tronco (s s' : Escena) (e_in : Elemento) (t_in : Tipo) (r_out : Respuesta) (centro_in : Punto)
  (radio_in proporcion_in : R) (vector_in : Vector) (altura_in : R) : Prop := {
  Agregar_Tronco_Agregar_Elemento : Agregar_Elemento s s' e_in t_in r_out;
  Agregar_Tronco_pre_1 : t_in = soy_tronco; (* Agregar_Tronco.pre.1 *)
  Agregar_Tronco_pre_2 : radio_in ∈ Rmas; (* Agregar_Tronco.pre.2 *)
  Agregar_Tronco_pre_3 : proporcion_in ∈ Rmas; (* Agregar_Tronco.pre.3 *)
  Agregar_Tronco_pre_4 : vector_in ∈ Unitario; (* Agregar_Tronco.pre.4 *)
  Agregar_Tronco_pre_5 : altura_in ∈ Rmas; (* Agregar_Tronco.pre.5 *)
  Agregar_Tronco_post_1 : mi_centro s' ≡ mi_centro s ∪ ⦃(e_in, centro_in)⦄; (* Agregar_Tronco.post.1 *)
  Agregar_Tronco_post_2 : mi_radio s' ≡ mi_radio s ∪ ⦃(e_in, radio_in)⦄; (* Agregar_Tronco.post.2 *)
  Agregar_Tronco_post_3 : mi_vector s' ≡ mi_vector s ∪ ⦃(e_in, vector_in)⦄; (* Agregar_Tronco.post.3 *)
  Agregar_Tronco_post_4 : mi_altura s' ≡ mi_altura s ∪ ⦃(e_in, altura_in)⦄; (* Agregar_Tronco.post.4 *)
  Agregar_Tronco_post_5 : mi_proporcion s' ≡ mi_proporcion s ∪ ⦃(e_in, proporcion_in)⦄; (* Agregar_Tronco.post.5 *)
  Agregar_Tronco_post_6 : mi_vertices s' ≡ mi_vertices s; (* Agregar_Tronco.post.6 *)
  Agregar_Tronco_post_7 : r_out = tronco_agregado (* Agregar_Tronco.post.7 *)
}.

Record Agregar_Plano (s s' : Escena) (e_in : Elemento) (t_in : Tipo) (r_out : Respuesta) (centro_in : Punto)
  (vector_in : Vector) : Prop := {
  Agregar_Plano_Agregar_Elemento : Agregar_Elemento s s' e_in t_in r_out;
  Agregar_Plano_pre_1 : t_in = soy_plano; (* Agregar_Plano.pre.1 *)
  Agregar_Plano_pre_2 : vector_in ∈ Unitario; (* Agregar_Plano.pre.2 *)
  Agregar_Plano_post_1 : mi_centro s' ≡ mi_centro s ∪ ⦃(e_in, centro_in)⦄; (* Agregar_Plano.post.1 *)
  Agregar_Plano_post_2 : mi_radio s' ≡ mi_radio s; (* Agregar_Plano.post.2 *)
  Agregar_Plano_post_3 : mi_vector s' ≡ mi_vector s ∪ ⦃(e_in, vector_in)⦄; (* Agregar_Plano.post.3 *)
  Agregar_Plano_post_4 : mi_altura s' ≡ mi_altura s; (* Agregar_Plano.post.4 *)
  Agregar_Plano_post_5 : mi_proporcion s' ≡ mi_proporcion s; (* Agregar_Plano.post.5 *)
  Agregar_Plano_post_6 : mi_vertices s' ≡ mi_vertices s; (* Agregar_Plano.post.6 *)
  Agregar_Plano_post_7 : r_out = plano_agregado (* Agregar_Plano.post.7 *)
}.

Record Agregar_Disco (s s' : Escena) (e_in : Elemento) (t_in : Tipo) (r_out : Respuesta) (centro_in : Punto) (radio_in
  : R) (vector_in : Vector) : Prop := {
  Agregar_Disco_Agregar_Elemento : Agregar_Elemento s s' e_in t_in r_out;
  Agregar_Disco_pre_1 : t_in = soy_disco; (* Agregar_Disco.pre.1 *)
  Agregar_Disco_pre_2 : radio_in ∈ Rmas; (* Agregar_Disco.pre.2 *)
  Agregar_Disco_pre_3 : vector_in ∈ Unitario; (* Agregar_Disco.pre.3 *)
  Agregar_Disco_post_1 : mi_centro s' ≡ mi_centro s ∪ ⦃(e_in, centro_in)⦄; (* Agregar_Disco.post.1 *)
  Agregar_Disco_post_2 : mi_radio s' ≡ mi_radio s ∪ ⦃(e_in, radio_in)⦄; (* Agregar_Disco.post.2 *)
  Agregar_Disco_post_3 : mi_vector s' ≡ mi_vector s ∪ ⦃(e_in, vector_in)⦄; (* Agregar_Disco.post.3 *)
  Agregar_Disco_post_4 : mi_altura s' ≡ mi_altura s; (* Agregar_Disco.post.4 *)
  Agregar_Disco_post_5 : mi_proporcion s' ≡ mi_proporcion s; (* Agregar_Disco.post.5 *)
  Agregar_Disco_post_6 : mi_vertices s' ≡ mi_vertices s; (* Agregar_Disco.post.6 *)
  Agregar_Disco_post_7 : r_out = disco_agregado (* Agregar_Disco.post.7 *)
}.

Record Agregar_Triangulo (s s' : Escena) (e_in : Elemento) (t_in : Tipo) (r_out : Respuesta) (vertices_in : Terna) :
  Prop := {
  Agregar_Triangulo_Agregar_Elemento : Agregar_Elemento s s' e_in t_in r_out;
  Agregar_Triangulo_pre_1 : t_in = soy_triangulo; (* Agregar_Triangulo.pre.1 *)
  Agregar_Triangulo_pre_2 : vertices_in ∈ Vertices; (* Agregar_Triangulo.pre.2 *)
  Agregar_Triangulo_post_1 : mi_centro s' ≡ mi_centro s; (* Agregar_Triangulo.post.1 *)
  Agregar_Triangulo_post_2 : mi_radio s' ≡ mi_radio s; (* Agregar_Triangulo.post.2 *)
  Agregar_Triangulo_post_3 : mi_vector s' ≡ mi_vector s; (* Agregar_Triangulo.post.3 *)
  Agregar_Triangulo_post_4 : mi_altura s' ≡ mi_altura s; (* Agregar_Triangulo.post.4 *)
  Agregar_Triangulo_post_5 : mi_proporcion s' ≡ mi_proporcion s; (* Agregar_Triangulo.post.5 *)
  Agregar_Triangulo_post_6 : mi_vertices s' ≡ mi_vertices s ∪ ⦃(e_in, vertices_in)⦄; (* Agregar_Triangulo.post.6 *)
  Agregar_Triangulo_post_7 : r_out = triangulo_agregado (* Agregar_Triangulo.post.7 *)
}.

Record Eliminar_Esfera (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop := {
  Eliminar_Esfera_Eliminar_Elemento : Eliminar_Elemento s s' e_in r_out;
  Eliminar_Esfera_pre_1 : exists v1, (e_in, v1) ∈ de_que_tipo s /\ v1 = soy_esfera; (* Eliminar_Esfera.pre.1 *)
  Eliminar_Esfera_post_1 : mi_centro s' ≡ ndres ⦃e_in⦄ (mi_centro s); (* Eliminar_Esfera.post.1 *)
  Eliminar_Esfera_post_2 : mi_radio s' ≡ ndres ⦃e_in⦄ (mi_radio s); (* Eliminar_Esfera.post.2 *)
  Eliminar_Esfera_post_3 : mi_vector s' ≡ mi_vector s; (* Eliminar_Esfera.post.3 *)
  Eliminar_Esfera_post_4 : mi_altura s' ≡ mi_altura s; (* Eliminar_Esfera.post.4 *)
  Eliminar_Esfera_post_5 : mi_proporcion s' ≡ mi_proporcion s; (* Eliminar_Esfera.post.5 *)
  Eliminar_Esfera_post_6 : mi_vertices s' ≡ mi_vertices s; (* Eliminar_Esfera.post.6 *)
  Eliminar_Esfera_post_7 : r_out = esfera_eliminada (* Eliminar_Esfera.post.7 *)
}.

Record Eliminar_Cilindro (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop := {
  Eliminar_Cilindro_Eliminar_Elemento : Eliminar_Elemento s s' e_in r_out;
  Eliminar_Cilindro_pre_1 : exists v1, (e_in, v1) ∈ de_que_tipo s /\ v1 = soy_cilindro; (* Eliminar_Cilindro.pre.1 *)
  Eliminar_Cilindro_post_1 : mi_centro s' ≡ ndres ⦃e_in⦄ (mi_centro s); (* Eliminar_Cilindro.post.1 *)
  Eliminar_Cilindro_post_2 : mi_radio s' ≡ ndres ⦃e_in⦄ (mi_radio s); (* Eliminar_Cilindro.post.2 *)
  Eliminar_Cilindro_post_3 : mi_vector s' ≡ ndres ⦃e_in⦄ (mi_vector s); (* Eliminar_Cilindro.post.3 *)
  Eliminar_Cilindro_post_4 : mi_altura s' ≡ ndres ⦃e_in⦄ (mi_altura s); (* Eliminar_Cilindro.post.4 *)
  Eliminar_Cilindro_post_5 : mi_proporcion s' ≡ mi_proporcion s; (* Eliminar_Cilindro.post.5 *)
  Eliminar_Cilindro_post_6 : mi_vertices s' ≡ mi_vertices s; (* Eliminar_Cilindro.post.6 *)
  Eliminar_Cilindro_post_7 : r_out = cilindro_eliminado (* Eliminar_Cilindro.post.7 *)
}.

Record Eliminar_Cono (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop := {
  Eliminar_Cono_Eliminar_Elemento : Eliminar_Elemento s s' e_in r_out;
  Eliminar_Cono_pre_1 : exists v1, (e_in, v1) ∈ de_que_tipo s /\ v1 = soy_cono; (* Eliminar_Cono.pre.1 *)
  Eliminar_Cono_post_1 : mi_centro s' ≡ ndres ⦃e_in⦄ (mi_centro s); (* Eliminar_Cono.post.1 *)
  Eliminar_Cono_post_2 : mi_radio s' ≡ mi_radio s; (* Eliminar_Cono.post.2 *)
  Eliminar_Cono_post_3 : mi_vector s' ≡ ndres ⦃e_in⦄ (mi_vector s); (* Eliminar_Cono.post.3 *)
  Eliminar_Cono_post_4 : mi_altura s' ≡ ndres ⦃e_in⦄ (mi_altura s); (* Eliminar_Cono.post.4 *)
  Eliminar_Cono_post_5 : mi_proporcion s' ≡ ndres ⦃e_in⦄ (mi_proporcion s); (* Eliminar_Cono.post.5 *)
  Eliminar_Cono_post_6 : mi_vertices s' ≡ mi_vertices s; (* Eliminar_Cono.post.6 *)
  Eliminar_Cono_post_7 : r_out = cono_eliminado (* Eliminar_Cono.post.7 *)
}.

Record Eliminar_Tronco (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop := {
  Eliminar_Tronco_Eliminar_Elemento : Eliminar_Elemento s s' e_in r_out;
  Eliminar_Tronco_pre_1 : exists v1, (e_in, v1) ∈ de_que_tipo s /\ v1 = soy_tronco; (* Eliminar_Tronco.pre.1 *)
  Eliminar_Tronco_post_1 : mi_centro s' ≡ ndres ⦃e_in⦄ (mi_centro s); (* Eliminar_Tronco.post.1 *)
  Eliminar_Tronco_post_2 : mi_radio s' ≡ ndres ⦃e_in⦄ (mi_radio s); (* Eliminar_Tronco.post.2 *)
  Eliminar_Tronco_post_3 : mi_vector s' ≡ ndres ⦃e_in⦄ (mi_vector s); (* Eliminar_Tronco.post.3 *)
  Eliminar_Tronco_post_4 : mi_altura s' ≡ ndres ⦃e_in⦄ (mi_altura s); (* Eliminar_Tronco.post.4 *)
  Eliminar_Tronco_post_5 : mi_proporcion s' ≡ ndres ⦃e_in⦄ (mi_proporcion s); (* Eliminar_Tronco.post.5 *)
  Eliminar_Tronco_post_6 : mi_vertices s' ≡ mi_vertices s; (* Eliminar_Tronco.post.6 *)
  Eliminar_Tronco_post_7 : r_out = tronco_eliminado (* Eliminar_Tronco.post.7 *)
}.

Record Eliminar_Plano (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop := {
  Eliminar_Plano_Eliminar_Elemento : Eliminar_Elemento s s' e_in r_out;
  Eliminar_Plano_pre_1 : exists v1, (e_in, v1) ∈ de_que_tipo s /\ v1 = soy_plano; (* Eliminar_Plano.pre.1 *)
  Eliminar_Plano_post_1 : mi_centro s' ≡ ndres ⦃e_in⦄ (mi_centro s); (* Eliminar_Plano.post.1 *)
  Eliminar_Plano_post_2 : mi_radio s' ≡ mi_radio s; (* Eliminar_Plano.post.2 *)
  Eliminar_Plano_post_3 : mi_vector s' ≡ ndres ⦃e_in⦄ (mi_vector s); (* Eliminar_Plano.post.3 *)
  Eliminar_Plano_post_4 : mi_altura s' ≡ mi_altura s; (* Eliminar_Plano.post.4 *)
  Eliminar_Plano_post_5 : mi_proporcion s' ≡ mi_proporcion s; (* Eliminar_Plano.post.5 *)
  Eliminar_Plano_post_6 : mi_vertices s' ≡ mi_vertices s; (* Eliminar_Plano.post.6 *)
  Eliminar_Plano_post_7 : r_out = plano_eliminado (* Eliminar_Plano.post.7 *)
}.

Record Eliminar_Disco (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop := {
  Eliminar_Disco_Eliminar_Elemento : Eliminar_Elemento s s' e_in r_out;
  Eliminar_Disco_pre_1 : exists v1, (e_in, v1) ∈ de_que_tipo s /\ v1 = soy_disco; (* Eliminar_Disco.pre.1 *)
  Eliminar_Disco_post_1 : mi_centro s' ≡ ndres ⦃e_in⦄ (mi_centro s); (* Eliminar_Disco.post.1 *)
  Eliminar_Disco_post_2 : mi_radio s' ≡ ndres ⦃e_in⦄ (mi_radio s); (* Eliminar_Disco.post.2 *)
  Eliminar_Disco_post_3 : mi_vector s' ≡ ndres ⦃e_in⦄ (mi_vector s); (* Eliminar_Disco.post.3 *)
  Eliminar_Disco_post_4 : mi_altura s' ≡ mi_altura s; (* Eliminar_Disco.post.4 *)
  Eliminar_Disco_post_5 : mi_proporcion s' ≡ mi_proporcion s; (* Eliminar_Disco.post.5 *)
  Eliminar_Disco_post_6 : mi_vertices s' ≡ mi_vertices s; (* Eliminar_Disco.post.6 *)
  Eliminar_Disco_post_7 : r_out = disco_eliminado (* Eliminar_Disco.post.7 *)
}.

Record Eliminar_Triangulo (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop := {
  Eliminar_Triangulo_Eliminar_Elemento : Eliminar_Elemento s s' e_in r_out;
  Eliminar_Triangulo_pre_1 : exists v1, (e_in, v1) ∈ de_que_tipo s
    /\ v1 = soy_triangulo; (* Eliminar_Triangulo.pre.1 *)
  Eliminar_Triangulo_post_1 : mi_centro s' ≡ mi_centro s; (* Eliminar_Triangulo.post.1 *)
  Eliminar_Triangulo_post_2 : mi_radio s' ≡ mi_radio s; (* Eliminar_Triangulo.post.2 *)
  Eliminar_Triangulo_post_3 : mi_vector s' ≡ mi_vector s; (* Eliminar_Triangulo.post.3 *)
  Eliminar_Triangulo_post_4 : mi_altura s' ≡ mi_altura s; (* Eliminar_Triangulo.post.4 *)
  Eliminar_Triangulo_post_5 : mi_proporcion s' ≡ mi_proporcion s; (* Eliminar_Triangulo.post.5 *)
  Eliminar_Triangulo_post_6 : mi_vertices s' ≡ ndres ⦃e_in⦄ (mi_vertices s); (* Eliminar_Triangulo.post.6 *)
  Eliminar_Triangulo_post_7 : r_out = triangulo_eliminado (* Eliminar_Triangulo.post.7 *)
}.

Definition Elemento_Agregado (s s' : Escena) (e_in : Elemento) (t_in : Tipo) (centro_in : Punto) (radio_in : R)
  (vector_in : Vector) (altura_in proporcion_in : R) (vertices_in : Terna) (r_out : Respuesta) : Prop :=
  (exists r_out : Respuesta, Agregar_Esfera s s' e_in t_in r_out centro_in radio_in
  \/ Agregar_Cilindro s s' e_in t_in r_out centro_in radio_in vector_in altura_in
  \/ Agregar_Cono s s' e_in t_in r_out centro_in proporcion_in vector_in altura_in
  \/ Agregar_Tronco s s' e_in t_in r_out centro_in radio_in proporcion_in vector_in altura_in
  \/ Agregar_Plano s s' e_in t_in r_out centro_in vector_in
  \/ Agregar_Disco s s' e_in t_in r_out centro_in radio_in vector_in
  \/ Agregar_Triangulo s s' e_in t_in r_out vertices_in) /\ r_out = elemento_agregado. (* Elemento_Agregado.post.1 *)

Definition Elemento_Eliminado (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop :=
  (exists r_out : Respuesta, Eliminar_Esfera s s' e_in r_out \/ Eliminar_Cilindro s s' e_in r_out
  \/ Eliminar_Cono s s' e_in r_out \/ Eliminar_Tronco s s' e_in r_out \/ Eliminar_Plano s s' e_in r_out
  \/ Eliminar_Disco s s' e_in r_out \/ Eliminar_Triangulo s s' e_in r_out)
  /\ r_out = elemento_eliminado. (* Elemento_Eliminado.post.1 *)

Record Elemento_Ya_Existe (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop := {
  Elemento_Ya_Existe_Xi : Xi_Escena s s';
  Elemento_Ya_Existe_pre_1 : e_in ∈ elementos s; (* Elemento_Ya_Existe.pre.1 *)
  Elemento_Ya_Existe_post_1 : r_out = elemento_ya_existe (* Elemento_Ya_Existe.post.1 *)
}.

Record Elemento_No_Existe (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop := {
  Elemento_No_Existe_Xi : Xi_Escena s s';
  Elemento_No_Existe_pre_1 : e_in ∉ elementos s; (* Elemento_No_Existe.pre.1 *)
  Elemento_No_Existe_post_1 : r_out = elemento_no_existe (* Elemento_No_Existe.post.1 *)
}.

Record Radio_No_Positivo (s s' : Escena) (radio_in : R) (r_out : Respuesta) : Prop := {
  Radio_No_Positivo_Xi : Xi_Escena s s';
  Radio_No_Positivo_pre_1 : radio_in ∉ Rmas; (* Radio_No_Positivo.pre.1 *)
  Radio_No_Positivo_post_1 : r_out = radio_no_positivo (* Radio_No_Positivo.post.1 *)
}.

Record Vector_No_Unitario (s s' : Escena) (vector_in : Vector) (r_out : Respuesta) : Prop := {
  Vector_No_Unitario_Xi : Xi_Escena s s';
  Vector_No_Unitario_pre_1 : vector_in ∉ Unitario; (* Vector_No_Unitario.pre.1 *)
  Vector_No_Unitario_post_1 : r_out = vector_no_unitario (* Vector_No_Unitario.post.1 *)
}.

Record Altura_No_Positiva (s s' : Escena) (altura_in : R) (r_out : Respuesta) : Prop := {
  Altura_No_Positiva_Xi : Xi_Escena s s';
  Altura_No_Positiva_pre_1 : altura_in ∉ Rmas; (* Altura_No_Positiva.pre.1 *)
  Altura_No_Positiva_post_1 : r_out = altura_no_positiva (* Altura_No_Positiva.post.1 *)
}.

Record Proporcion_No_Positiva (s s' : Escena) (proporcion_in : R) (r_out : Respuesta) : Prop := {
  Proporcion_No_Positiva_Xi : Xi_Escena s s';
  Proporcion_No_Positiva_pre_1 : proporcion_in ∉ Rmas; (* Proporcion_No_Positiva.pre.1 *)
  Proporcion_No_Positiva_post_1 : r_out = proporcion_no_positiva (* Proporcion_No_Positiva.post.1 *)
}.

Record Vertices_Alineados (s s' : Escena) (vertices_in : Terna) (r_out : Respuesta) : Prop := {
  Vertices_Alineados_Xi : Xi_Escena s s';
  Vertices_Alineados_pre_1 : vertices_in ∉ Vertices; (* Vertices_Alineados.pre.1 *)
  Vertices_Alineados_post_1 : r_out = vertices_alineados (* Vertices_Alineados.post.1 *)
}.

Record No_Es_Esfera (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop := {
  No_Es_Esfera_Xi : Xi_Escena s s';
  No_Es_Esfera_pre_1 : e_in ∈ elementos s; (* No_Es_Esfera.pre.1 *)
  No_Es_Esfera_pre_2 : exists v1, (e_in, v1) ∈ de_que_tipo s /\ v1 <> soy_esfera; (* No_Es_Esfera.pre.2 *)
  No_Es_Esfera_post_1 : r_out = tipo_incorrecto (* No_Es_Esfera.post.1 *)
}.

Record No_Es_Cilindro (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop := {
  No_Es_Cilindro_Xi : Xi_Escena s s';
  No_Es_Cilindro_pre_1 : e_in ∈ elementos s; (* No_Es_Cilindro.pre.1 *)
  No_Es_Cilindro_pre_2 : exists v1, (e_in, v1) ∈ de_que_tipo s /\ v1 <> soy_cilindro; (* No_Es_Cilindro.pre.2 *)
  No_Es_Cilindro_post_1 : r_out = tipo_incorrecto (* No_Es_Cilindro.post.1 *)
}.

Record No_Es_Cono (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop := {
  No_Es_Cono_Xi : Xi_Escena s s';
  No_Es_Cono_pre_1 : e_in ∈ elementos s; (* No_Es_Cono.pre.1 *)
  No_Es_Cono_pre_2 : exists v1, (e_in, v1) ∈ de_que_tipo s /\ v1 <> soy_cono; (* No_Es_Cono.pre.2 *)
  No_Es_Cono_post_1 : r_out = tipo_incorrecto (* No_Es_Cono.post.1 *)
}.

Record No_Es_Tronco (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop := {
  No_Es_Tronco_Xi : Xi_Escena s s';
  No_Es_Tronco_pre_1 : e_in ∈ elementos s; (* No_Es_Tronco.pre.1 *)
  No_Es_Tronco_pre_2 : exists v1, (e_in, v1) ∈ de_que_tipo s /\ v1 <> soy_tronco; (* No_Es_Tronco.pre.2 *)
  No_Es_Tronco_post_1 : r_out = tipo_incorrecto (* No_Es_Tronco.post.1 *)
}.

Record No_Es_Plano (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop := {
  No_Es_Plano_Xi : Xi_Escena s s';
  No_Es_Plano_pre_1 : e_in ∈ elementos s; (* No_Es_Plano.pre.1 *)
  No_Es_Plano_pre_2 : exists v1, (e_in, v1) ∈ de_que_tipo s /\ v1 <> soy_plano; (* No_Es_Plano.pre.2 *)
  No_Es_Plano_post_1 : r_out = tipo_incorrecto (* No_Es_Plano.post.1 *)
}.

Record No_Es_Disco (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop := {
  No_Es_Disco_Xi : Xi_Escena s s';
  No_Es_Disco_pre_1 : e_in ∈ elementos s; (* No_Es_Disco.pre.1 *)
  No_Es_Disco_pre_2 : exists v1, (e_in, v1) ∈ de_que_tipo s /\ v1 <> soy_disco; (* No_Es_Disco.pre.2 *)
  No_Es_Disco_post_1 : r_out = tipo_incorrecto (* No_Es_Disco.post.1 *)
}.

Record No_Es_Triangulo (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop := {
  No_Es_Triangulo_Xi : Xi_Escena s s';
  No_Es_Triangulo_pre_1 : e_in ∈ elementos s; (* No_Es_Triangulo.pre.1 *)
  No_Es_Triangulo_pre_2 : exists v1, (e_in, v1) ∈ de_que_tipo s /\ v1 <> soy_triangulo; (* No_Es_Triangulo.pre.2 *)
  No_Es_Triangulo_post_1 : r_out = tipo_incorrecto (* No_Es_Triangulo.post.1 *)
}.

Definition Agregar_Esfera_Total (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) (centro_in : Punto) (radio_in :
  R) : Prop :=
  (exists t_in : Tipo, Agregar_Esfera s s' e_in t_in r_out centro_in radio_in)
  \/ Elemento_Ya_Existe s s' e_in r_out \/ Radio_No_Positivo s s' radio_in r_out. (* Agregar_Esfera_Total.def.1 *)

Definition Agregar_Cilindro_Total (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) (centro_in : Punto) (radio_in
  : R) (vector_in : Vector) (altura_in : R) : Prop :=
  (exists t_in : Tipo, Agregar_Cilindro s s' e_in t_in r_out centro_in radio_in vector_in altura_in)
  \/ Elemento_Ya_Existe s s' e_in r_out \/ Radio_No_Positivo s s' radio_in r_out
  \/ Vector_No_Unitario s s' vector_in r_out
  \/ Altura_No_Positiva s s' altura_in r_out. (* Agregar_Cilindro_Total.def.1 *)

Definition Agregar_Cono_Total (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) (centro_in : Punto) (proporcion_in
  : R) (vector_in : Vector) (altura_in : R) : Prop :=
  (exists t_in : Tipo, Agregar_Cono s s' e_in t_in r_out centro_in proporcion_in vector_in altura_in)
  \/ Elemento_Ya_Existe s s' e_in r_out \/ Proporcion_No_Positiva s s' proporcion_in r_out
  \/ Vector_No_Unitario s s' vector_in r_out
  \/ Altura_No_Positiva s s' altura_in r_out. (* Agregar_Cono_Total.def.1 *)

Definition Agregar_Tronco_Total (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) (centro_in : Punto) (radio_in
  proporcion_in : R) (vector_in : Vector) (altura_in : R) : Prop :=
  (exists t_in : Tipo, Agregar_Tronco s s' e_in t_in r_out centro_in radio_in proporcion_in vector_in altura_in)
  \/ Elemento_Ya_Existe s s' e_in r_out \/ Radio_No_Positivo s s' radio_in r_out
  \/ Proporcion_No_Positiva s s' proporcion_in r_out \/ Vector_No_Unitario s s' vector_in r_out
  \/ Altura_No_Positiva s s' altura_in r_out. (* Agregar_Tronco_Total.def.1 *)

Definition Agregar_Plano_Total (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) (centro_in : Punto) (vector_in :
  Vector) : Prop :=
  (exists t_in : Tipo, Agregar_Plano s s' e_in t_in r_out centro_in vector_in)
  \/ Elemento_Ya_Existe s s' e_in r_out \/ Vector_No_Unitario s s' vector_in r_out. (* Agregar_Plano_Total.def.1 *)

Definition Agregar_Disco_Total (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) (centro_in : Punto) (radio_in :
  R) (vector_in : Vector) : Prop :=
  (exists t_in : Tipo, Agregar_Disco s s' e_in t_in r_out centro_in radio_in vector_in)
  \/ Elemento_Ya_Existe s s' e_in r_out \/ Radio_No_Positivo s s' radio_in r_out
  \/ Vector_No_Unitario s s' vector_in r_out. (* Agregar_Disco_Total.def.1 *)

Definition Agregar_Triangulo_Total (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) (vertices_in : Terna) : Prop
  :=
  (exists t_in : Tipo, Agregar_Triangulo s s' e_in t_in r_out vertices_in) \/ Elemento_Ya_Existe s s' e_in r_out
  \/ Vertices_Alineados s s' vertices_in r_out. (* Agregar_Triangulo_Total.def.1 *)

Definition Eliminar_Esfera_Total (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop :=
  Eliminar_Esfera s s' e_in r_out \/ Elemento_No_Existe s s' e_in r_out
  \/ No_Es_Esfera s s' e_in r_out. (* Eliminar_Esfera_Total.def.1 *)

Definition Eliminar_Cilindro_Total (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop :=
  Eliminar_Cilindro s s' e_in r_out \/ Elemento_No_Existe s s' e_in r_out
  \/ No_Es_Cilindro s s' e_in r_out. (* Eliminar_Cilindro_Total.def.1 *)

Definition Eliminar_Cono_Total (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop :=
  Eliminar_Cono s s' e_in r_out \/ Elemento_No_Existe s s' e_in r_out
  \/ No_Es_Cono s s' e_in r_out. (* Eliminar_Cono_Total.def.1 *)

Definition Eliminar_Tronco_Total (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop :=
  Eliminar_Tronco s s' e_in r_out \/ Elemento_No_Existe s s' e_in r_out
  \/ No_Es_Tronco s s' e_in r_out. (* Eliminar_Tronco_Total.def.1 *)

Definition Eliminar_Plano_Total (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop :=
  Eliminar_Plano s s' e_in r_out \/ Elemento_No_Existe s s' e_in r_out
  \/ No_Es_Plano s s' e_in r_out. (* Eliminar_Plano_Total.def.1 *)

Definition Eliminar_Disco_Total (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop :=
  Eliminar_Disco s s' e_in r_out \/ Elemento_No_Existe s s' e_in r_out
  \/ No_Es_Disco s s' e_in r_out. (* Eliminar_Disco_Total.def.1 *)

Definition Eliminar_Triangulo_Total (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop :=
  Eliminar_Triangulo s s' e_in r_out \/ Elemento_No_Existe s s' e_in r_out
  \/ No_Es_Triangulo s s' e_in r_out. (* Eliminar_Triangulo_Total.def.1 *)

Definition Con_Radio (t_in : Tipo) : Prop :=
  t_in ∈ ⦃soy_esfera⦄ ∪ ⦃soy_cilindro⦄ ∪ ⦃soy_tronco⦄ ∪ ⦃soy_disco⦄. (* Con_Radio.pre.1 *)

Definition Con_Vector (t_in : Tipo) : Prop :=
  t_in ∈ ⦃soy_cilindro⦄ ∪ ⦃soy_cono⦄ ∪ ⦃soy_tronco⦄ ∪ ⦃soy_plano⦄ ∪ ⦃soy_disco⦄. (* Con_Vector.pre.1 *)

Definition Con_Altura (t_in : Tipo) : Prop :=
  t_in ∈ ⦃soy_cilindro⦄ ∪ ⦃soy_cono⦄ ∪ ⦃soy_tronco⦄. (* Con_Altura.pre.1 *)

Definition Con_Proporcion (t_in : Tipo) : Prop := t_in ∈ ⦃soy_cono⦄ ∪ ⦃soy_tronco⦄. (* Con_Proporcion.pre.1 *)

Definition Con_Vertices (t_in : Tipo) : Prop := t_in ∈ ⦃soy_triangulo⦄. (* Con_Vertices.pre.1 *)

Definition Agregar_Elemento_Total (s s' : Escena) (e_in : Elemento) (t_in : Tipo) (centro_in : Punto) (radio_in : R)
  (vector_in : Vector) (altura_in proporcion_in : R) (vertices_in : Terna) (r_out : Respuesta) : Prop :=
  Elemento_Agregado s s' e_in t_in centro_in radio_in vector_in altura_in proporcion_in vertices_in r_out
  \/ Elemento_Ya_Existe s s' e_in r_out \/ Radio_No_Positivo s s' radio_in r_out /\ Con_Radio t_in
  \/ Proporcion_No_Positiva s s' proporcion_in r_out /\ Con_Proporcion t_in
  \/ Vector_No_Unitario s s' vector_in r_out /\ Con_Vector t_in \/ Altura_No_Positiva s s' altura_in r_out
  /\ Con_Altura t_in \/ Vertices_Alineados s s' vertices_in r_out
  /\ Con_Vertices t_in. (* Agregar_Elemento_Total.def.1 *)

Definition Eliminar_Elemento_Total (s s' : Escena) (e_in : Elemento) (r_out : Respuesta) : Prop :=
  Elemento_Eliminado s s' e_in r_out \/ Elemento_No_Existe s s' e_in r_out. (* Eliminar_Elemento_Total.def.1 *)

Definition Agregar_Esfera_Total_conj_1 : Prop :=
  forall (s : Escena) (e_in : Elemento) (centro_in : Punto) (radio_in : R), Escena_ok s
  -> exists (s' : Escena) (r_out : Respuesta), Agregar_Esfera_Total s s' e_in r_out centro_in radio_in.
  (* Agregar_Esfera_Total.conj.1 *)

Definition Agregar_Cilindro_Total_conj_1 : Prop :=
  forall (s : Escena) (e_in : Elemento) (centro_in : Punto) (radio_in : R) (vector_in : Vector) (altura_in : R),
  Escena_ok s -> exists (s' : Escena) (r_out : Respuesta), Agregar_Cilindro_Total s s' e_in r_out centro_in radio_in
  vector_in altura_in. (* Agregar_Cilindro_Total.conj.1 *)

Definition Agregar_Cono_Total_conj_1 : Prop :=
  forall (s : Escena) (e_in : Elemento) (centro_in : Punto) (proporcion_in : R) (vector_in : Vector) (altura_in : R),
  Escena_ok s -> exists (s' : Escena) (r_out : Respuesta), Agregar_Cono_Total s s' e_in r_out centro_in proporcion_in
  vector_in altura_in. (* Agregar_Cono_Total.conj.1 *)

Definition Agregar_Tronco_Total_conj_1 : Prop :=
  forall (s : Escena) (e_in : Elemento) (centro_in : Punto) (radio_in proporcion_in : R) (vector_in : Vector)
  (altura_in : R), Escena_ok s -> exists (s' : Escena) (r_out : Respuesta), Agregar_Tronco_Total s s' e_in r_out
  centro_in radio_in proporcion_in vector_in altura_in. (* Agregar_Tronco_Total.conj.1 *)

Definition Agregar_Plano_Total_conj_1 : Prop :=
  forall (s : Escena) (e_in : Elemento) (centro_in : Punto) (vector_in : Vector), Escena_ok s
  -> exists (s' : Escena) (r_out : Respuesta), Agregar_Plano_Total s s' e_in r_out centro_in vector_in.
  (* Agregar_Plano_Total.conj.1 *)

Definition Agregar_Disco_Total_conj_1 : Prop :=
  forall (s : Escena) (e_in : Elemento) (centro_in : Punto) (radio_in : R) (vector_in : Vector), Escena_ok s
  -> exists (s' : Escena) (r_out : Respuesta), Agregar_Disco_Total s s' e_in r_out centro_in radio_in vector_in.
  (* Agregar_Disco_Total.conj.1 *)

Definition Agregar_Triangulo_Total_conj_1 : Prop :=
  forall (s : Escena) (e_in : Elemento) (vertices_in : Terna), Escena_ok s
  -> exists (s' : Escena) (r_out : Respuesta), Agregar_Triangulo_Total s s' e_in r_out vertices_in.
  (* Agregar_Triangulo_Total.conj.1 *)

Definition Eliminar_Esfera_Total_conj_1 : Prop :=
  forall (s : Escena) (e_in : Elemento), Escena_ok s
  -> exists (s' : Escena) (r_out : Respuesta), Eliminar_Esfera_Total s s' e_in r_out.
  (* Eliminar_Esfera_Total.conj.1 *)

Definition Eliminar_Cilindro_Total_conj_1 : Prop :=
  forall (s : Escena) (e_in : Elemento), Escena_ok s
  -> exists (s' : Escena) (r_out : Respuesta), Eliminar_Cilindro_Total s s' e_in r_out.
  (* Eliminar_Cilindro_Total.conj.1 *)

Definition Eliminar_Cono_Total_conj_1 : Prop :=
  forall (s : Escena) (e_in : Elemento), Escena_ok s
  -> exists (s' : Escena) (r_out : Respuesta), Eliminar_Cono_Total s s' e_in r_out. (* Eliminar_Cono_Total.conj.1 *)

Definition Eliminar_Tronco_Total_conj_1 : Prop :=
  forall (s : Escena) (e_in : Elemento), Escena_ok s
  -> exists (s' : Escena) (r_out : Respuesta), Eliminar_Tronco_Total s s' e_in r_out.
  (* Eliminar_Tronco_Total.conj.1 *)

Definition Eliminar_Plano_Total_conj_1 : Prop :=
  forall (s : Escena) (e_in : Elemento), Escena_ok s
  -> exists (s' : Escena) (r_out : Respuesta), Eliminar_Plano_Total s s' e_in r_out. (* Eliminar_Plano_Total.conj.1 *)

Definition Eliminar_Disco_Total_conj_1 : Prop :=
  forall (s : Escena) (e_in : Elemento), Escena_ok s
  -> exists (s' : Escena) (r_out : Respuesta), Eliminar_Disco_Total s s' e_in r_out. (* Eliminar_Disco_Total.conj.1 *)

Definition Eliminar_Triangulo_Total_conj_1 : Prop :=
  forall (s : Escena) (e_in : Elemento), Escena_ok s
  -> exists (s' : Escena) (r_out : Respuesta), Eliminar_Triangulo_Total s s' e_in r_out.
  (* Eliminar_Triangulo_Total.conj.1 *)

Definition Agregar_Elemento_Total_conj_1 : Prop :=
  forall (s : Escena) (e_in : Elemento) (t_in : Tipo) (centro_in : Punto) (radio_in : R) (vector_in : Vector)
  (altura_in proporcion_in : R) (vertices_in : Terna), Escena_ok s
  -> exists (s' : Escena) (r_out : Respuesta), Agregar_Elemento_Total s s' e_in t_in centro_in radio_in vector_in
  altura_in proporcion_in vertices_in r_out. (* Agregar_Elemento_Total.conj.1 *)

Definition Eliminar_Elemento_Total_conj_1 : Prop :=
  forall (s : Escena) (e_in : Elemento), Escena_ok s
  -> exists (s' : Escena) (r_out : Respuesta), Eliminar_Elemento_Total s s' e_in r_out.
  (* Eliminar_Elemento_Total.conj.1 *)

(** * proyeccion.tex *)

Definition entre (x y q : Punto) : Prop :=
  exists s1 : R, s1 ∈ Rmas /\ s1 < 1 /\ Punto_x q = Punto_x x + s1 * (Punto_x y - Punto_x x)
  /\ Punto_y q = Punto_y x + s1 * (Punto_y y - Punto_y x)
  /\ Punto_z q = Punto_z x + s1 * (Punto_z y - Punto_z x). (* entre.def.1 *)

Definition sombra (y : Punto) (ps : set Punto) : set Punto :=
  fun x => exists q : Punto, q ∈ ps /\ entre x y q. (* sombra.def.1 *)

Definition iluminada (y : Punto) (ps : set Punto) (otros : set (set Punto)) : set Punto :=
  fun x => x ∈ ps /\ forall qs : set Punto, qs ∈ otros -> x ∉ sombra y qs. (* iluminada.def.1 *)

Definition proyectado (y p centro : Punto) (dir : Vector) (x : Punto) : Prop :=
  x ∈ puntos_plano centro dir /\ exists t : R, t ∈ Rmas /\ Punto_x x = Punto_x y + t * (Punto_x p - Punto_x y)
  /\ Punto_y x = Punto_y y + t * (Punto_y p - Punto_y y)
  /\ Punto_z x = Punto_z y + t * (Punto_z p - Punto_z y). (* proyectado.def.1 *)

Definition profundidad (rayo : Rayo) (ps : set Punto) (d : R) : Prop :=
  exists q : Punto, q ∈ interseccion (puntos_de_rayo rayo) ps /\ d = distancia q (Rayo_p rayo)
  /\ forall otro : Punto, otro ∈ interseccion (puntos_de_rayo rayo) ps
  -> d <= distancia otro (Rayo_p rayo). (* profundidad.def.1 *)

Definition oscura (d : R) (q y : Punto) : Prop := d < distancia q y. (* oscura.def.1 *)

Definition mezcla (m : Material) (propio I : R) : R :=
  propio + Material_k_t m * Material_M_T m * I. (* mezcla.def.1 *)

Definition iluminada_conj_1 : Prop :=
  forall (s : Escena) (e : Elemento) (p q : Punto), Escena_ok s -> e ∈ dom (mi_vertices s)
  -> p ∈ puntos_de_elemento s e -> (exists v1, v1 ∈ potencia s e q /\ v1 <> 0)
  -> visible s p q ⦃e⦄ <-> p ∈ iluminada q (puntos_de_elemento s e) (fun y1 => exists o : Elemento, o ∈ elementos s
  /\ o <> e /\ y1 ≡ puntos_de_elemento s o). (* iluminada.conj.1 *)

Definition proyectado_conj_1 : Prop :=
  forall (y a b u v centro : Punto) (dir : Vector) (h d : R), dir ∈ Unitario -> proyectado y a centro dir u
  -> proyectado y b centro dir v -> h = avance y centro dir -> d = avance a centro dir -> d = avance b centro dir
  -> (h - d) * (Punto_x v - Punto_x u) = h * (Punto_x b - Punto_x a)
  /\ (h - d) * (Punto_y v - Punto_y u) = h * (Punto_y b - Punto_y a)
  /\ (h - d) * (Punto_z v - Punto_z u) = h * (Punto_z b - Punto_z a). (* proyectado.conj.1 *)

Definition oscura_conj_1 : Prop :=
  forall (rayo : Rayo) (ps : set Punto) (d : R) (q : Punto), rayo ∈ Rayo_ok -> q ∈ ps -> q ∈ puntos_de_rayo rayo
  -> profundidad rayo ps d -> oscura d q (Rayo_p rayo) <-> q ∈ sombra (Rayo_p rayo) ps. (* oscura.conj.1 *)

Definition oscura_conj_2 : Prop :=
  exists (rayo : Rayo) (ps : set Punto) (d : R) (q : Punto), rayo ∈ Rayo_ok /\ q ∈ ps /\ profundidad rayo ps d
  /\ oscura d q (Rayo_p rayo) /\ q ∉ sombra (Rayo_p rayo) ps. (* oscura.conj.2 *)

Definition mezcla_conj_1 : Prop :=
  forall (m : Material) (suma r t : R), m ∈ Material_ok -> Material_k_ps m = 0
  -> radiancia m suma r t = mezcla m (Material_emisividad m + Material_A_G m + suma) t. (* mezcla.conj.1 *)

Definition mezcla_conj_2 : Prop :=
  forall (m o : Material) (I : R), m ∈ Material_ok -> o ∈ Material_ok
  -> mezcla m 0 (mezcla o 0 I) = mezcla o 0 (mezcla m 0 I). (* mezcla.conj.2 *)

Definition mezcla_conj_3 : Prop :=
  forall (m o : Material) (x y z : R), m ∈ Material_ok -> o ∈ Material_ok
  -> 2 * (Material_k_t m * Material_M_T m) = 1 -> 4 * (Material_k_t o * Material_M_T o) = 1 -> 10 * x = 8
  -> 10 * y = 2 -> 10 * z = 1 -> 100 * mezcla o z (mezcla m y x) = 25 /\ 1000 * mezcla m z (mezcla o x y) = 525
  /\ 100 * mezcla m y (mezcla o z x) = 35. (* mezcla.conj.3 *)

(** * solidos.tex *)

Record Cuadrica := mk_Cuadrica {
  Cuadrica_xx : R;
  Cuadrica_yy : R;
  Cuadrica_zz : R;
  Cuadrica_yz : R;
  Cuadrica_zx : R;
  Cuadrica_xy : R;
  Cuadrica_x : R;
  Cuadrica_y : R;
  Cuadrica_z : R;
  Cuadrica_uno : R
}.

Record Cuadrica_ok (s : Cuadrica) : Prop := {
  Cuadrica_inv_1 : ~ (Cuadrica_xx s = 0 /\ Cuadrica_yy s = 0 /\ Cuadrica_zz s = 0 /\ Cuadrica_yz s = 0
    /\ Cuadrica_zx s = 0 /\ Cuadrica_xy s = 0 /\ Cuadrica_x s = 0 /\ Cuadrica_y s = 0 /\ Cuadrica_z s = 0
    /\ Cuadrica_uno s = 0) (* Cuadrica.inv.1 *)
}.

Definition valor (c : Cuadrica) (w : Punto) : R :=
  Cuadrica_xx c * cuadrado (Punto_x w) + Cuadrica_yy c * cuadrado (Punto_y w) + Cuadrica_zz c * cuadrado (Punto_z w)
  + Cuadrica_yz c * (Punto_y w * Punto_z w) + Cuadrica_zx c * (Punto_z w * Punto_x w)
  + Cuadrica_xy c * (Punto_x w * Punto_y w) + Cuadrica_x c * Punto_x w + Cuadrica_y c * Punto_y w
  + Cuadrica_z c * Punto_z w + Cuadrica_uno c. (* valor.def.1 *)

Definition multiplo (a b : Cuadrica) (k : R) : Prop :=
  k <> 0 /\ Cuadrica_xx a = k * Cuadrica_xx b /\ Cuadrica_yy a = k * Cuadrica_yy b
  /\ Cuadrica_zz a = k * Cuadrica_zz b /\ Cuadrica_yz a = k * Cuadrica_yz b /\ Cuadrica_zx a = k * Cuadrica_zx b
  /\ Cuadrica_xy a = k * Cuadrica_xy b /\ Cuadrica_x a = k * Cuadrica_x b /\ Cuadrica_y a = k * Cuadrica_y b
  /\ Cuadrica_z a = k * Cuadrica_z b /\ Cuadrica_uno a = k * Cuadrica_uno b. (* multiplo.def.1 *)

Definition dentro (w : Punto) : set Cuadrica := fun c => c ∈ Cuadrica_ok /\ valor c w < 0. (* dentro.def.1 *)
Definition fuera (w : Punto) : set Cuadrica := fun c => c ∈ Cuadrica_ok /\ valor c w > 0. (* fuera.def.1 *)

Definition repartos (ds fs : set Cuadrica) : set (set Cuadrica) :=
  fun l => l ∈ ℙ Cuadrica_ok /\ ds ⊆ l /\ (forall c : Cuadrica, c ∈ fs -> c ∉ l)
  /\ forall (a b : Cuadrica) (k : R), a ∈ Cuadrica_ok -> b ∈ Cuadrica_ok -> multiplo a b k
  -> (k > 0 -> a ∈ l <-> b ∈ l) /\ (k < 0 -> a ∈ l <-> b ∉ l). (* repartos.def.1 *)

Definition solido_union (S T : set (set Cuadrica)) : set (set Cuadrica) := S ∪ T. (* solido_union.def.1 *)
Definition solido_interseccion (S T : set (set Cuadrica)) : set (set Cuadrica) :=
  S ∩ T. (* solido_interseccion.def.1 *)
Definition solido_diferencia (S T : set (set Cuadrica)) : set (set Cuadrica) := S ∖ T. (* solido_diferencia.def.1 *)

Definition solido_esfera (centro : Punto) (radio : R) : set (set Cuadrica) :=
  fun l => l ∈ ℙ Cuadrica_ok /\ exists c : Cuadrica, c ∈ l
  /\ forall w : Punto, valor c w = potencia_esfera w centro radio. (* solido_esfera.def.1 *)

Definition solido_plano (centro : Punto) (dir : Vector) : set (set Cuadrica) :=
  fun l => l ∈ ℙ Cuadrica_ok /\ exists c : Cuadrica, c ∈ l
  /\ forall w : Punto, valor c w = potencia_plano w centro dir. (* solido_plano.def.1 *)

Definition solido_tramo (centro : Punto) (dir : Vector) (h : R) : set (set Cuadrica) :=
  fun l => l ∈ ℙ Cuadrica_ok /\ exists base tapa : Cuadrica, base ∈ l /\ tapa ∈ l
  /\ forall w : Punto, valor base w = 0 - avance w centro dir
  /\ valor tapa w = avance w centro dir - h. (* solido_tramo.def.1 *)

Definition solido_cilindro (centro : Punto) (radio : R) (dir : Vector) (h : R) : set (set Cuadrica) :=
  fun l => l ∈ solido_tramo centro dir h /\ exists c : Cuadrica, c ∈ l
  /\ forall w : Punto, valor c w = potencia_cilindro w centro radio dir. (* solido_cilindro.def.1 *)
Definition solido_cono (centro : Punto) (prop : R) (dir : Vector) (h : R) : set (set Cuadrica) :=
  fun l => l ∈ solido_tramo centro dir h /\ exists c : Cuadrica, c ∈ l
  /\ forall w : Punto, valor c w = potencia_cono w centro prop dir h. (* solido_cono.def.1 *)
Definition solido_tronco (centro : Punto) (radio prop : R) (dir : Vector) (h : R) : set (set Cuadrica) :=
  fun l => l ∈ solido_tramo centro dir h /\ exists c : Cuadrica, c ∈ l
  /\ forall w : Punto, valor c w = potencia_tronco w centro radio prop dir h. (* solido_tronco.def.1 *)

Definition cuerpo (S : set (set Cuadrica)) : set Punto :=
  fun w => exists l : set Cuadrica, l ∈ repartos (dentro w) (fuera w) /\ l ∈ S. (* cuerpo.def.1 *)
Definition interior (S : set (set Cuadrica)) : set Punto :=
  fun w => forall l : set Cuadrica, l ∈ repartos (dentro w) (fuera w) -> l ∈ S. (* interior.def.1 *)

Definition superficie (S : set (set Cuadrica)) : set Punto := cuerpo S ∖ interior S. (* superficie.def.1 *)

Definition con_multiplos : set (set Cuadrica) :=
  fun en => en ∈ ℙ Cuadrica_ok /\ forall (a b : Cuadrica) (k : R), a ∈ Cuadrica_ok -> b ∈ Cuadrica_ok
  -> multiplo a b k -> a ∈ en <-> b ∈ en. (* con_multiplos.def.1 *)

Definition dentro_desde (p : Punto) (en : set Cuadrica) (w : Punto) : set Cuadrica :=
  fun c => c ∈ Cuadrica_ok /\ (c ∈ en /\ valor c w < valor c p \/ c ∉ en /\ valor c w < 0). (* dentro_desde.def.1 *)
Definition fuera_desde (p : Punto) (en : set Cuadrica) (w : Punto) : set Cuadrica :=
  fun c => c ∈ Cuadrica_ok /\ (c ∈ en /\ valor c w > valor c p \/ c ∉ en /\ valor c w > 0). (* fuera_desde.def.1 *)

Definition superficie_desde (S : set (set Cuadrica)) (rayo : Rayo) (en : set Cuadrica) (w : Punto) : Prop :=
  w ∈ puntos_de_rayo rayo /\ (exists l : set Cuadrica, l
  ∈ repartos (dentro_desde (Rayo_p rayo) en w) (fuera_desde (Rayo_p rayo) en w) /\ l ∈ S)
  /\ exists l : set Cuadrica, l ∈ repartos (dentro_desde (Rayo_p rayo) en w) (fuera_desde (Rayo_p rayo) en w)
  /\ l ∉ S. (* superficie_desde.def.1 *)

Definition en_parametro (rayo : Rayo) (t : R) (q : Punto) : Prop :=
  Punto_x q = Punto_x (Rayo_p rayo) + t * Vector_x (Rayo_v rayo)
  /\ Punto_y q = Punto_y (Rayo_p rayo) + t * Vector_y (Rayo_v rayo)
  /\ Punto_z q = Punto_z (Rayo_p rayo) + t * Vector_z (Rayo_v rayo). (* en_parametro.def.1 *)

Definition hecho_de (S : set (set Cuadrica)) (cs : set Cuadrica) : Prop :=
  forall l m : set Cuadrica, l ∈ ℙ Cuadrica_ok -> m ∈ ℙ Cuadrica_ok
  -> (forall c : Cuadrica, c ∈ cs -> c ∈ l <-> c ∈ m) -> l ∈ S <-> m ∈ S. (* hecho_de.def.1 *)

Definition superficie_desde_conj_2 : Prop :=
  forall (S : set (set Cuadrica)) (rayo : Rayo) (w : Punto), S ∈ ℙ (ℙ Cuadrica_ok) -> rayo ∈ Rayo_ok
  -> superficie_desde S rayo ∅ w <-> w ∈ interseccion (puntos_de_rayo rayo) (superficie S).
  (* superficie_desde.conj.2 *)

Definition cuerpo_conj_1 : Prop :=
  forall S T : set (set Cuadrica), S ∈ ℙ (ℙ Cuadrica_ok) -> T ∈ ℙ (ℙ Cuadrica_ok)
  -> cuerpo (solido_union S T) ≡ cuerpo S ∪ cuerpo T. (* cuerpo.conj.1 *)

Definition interior_conj_1 : Prop :=
  forall S T : set (set Cuadrica), S ∈ ℙ (ℙ Cuadrica_ok) -> T ∈ ℙ (ℙ Cuadrica_ok)
  -> interior (solido_interseccion S T) ≡ interior S ∩ interior T. (* interior.conj.1 *)

Definition superficie_conj_1 : Prop :=
  forall (S : set (set Cuadrica)) (w : Punto), S ∈ ℙ (ℙ Cuadrica_ok)
  -> (w ∈ cuerpo (ℙ Cuadrica_ok ∖ S) <-> w ∉ interior S)
  /\ (w ∈ superficie (ℙ Cuadrica_ok ∖ S) <-> w ∈ superficie S). (* superficie.conj.1 *)

Definition interior_conj_2 : Prop :=
  forall S T : set (set Cuadrica), S ∈ ℙ (ℙ Cuadrica_ok) -> T ∈ ℙ (ℙ Cuadrica_ok)
  -> interior (solido_diferencia S T) ≡ interior S ∖ cuerpo T. (* interior.conj.2 *)

Definition cuerpo_conj_2 : Prop :=
  forall (S T : set (set Cuadrica)) (w : Punto), S ∈ ℙ (ℙ Cuadrica_ok) -> T ∈ ℙ (ℙ Cuadrica_ok)
  -> w ∈ cuerpo (solido_diferencia S T) -> w ∈ cuerpo S /\ w ∉ interior T. (* cuerpo.conj.2 *)

Definition interior_conj_3 : Prop :=
  forall (S : set (set Cuadrica)) (w : Punto), S ∈ ℙ (ℙ Cuadrica_ok) -> w ∈ interior S
  -> w ∈ cuerpo S. (* interior.conj.3 *)

Definition solido_esfera_conj_1 : Prop :=
  forall (centro w : Punto) (radio : R), radio ∈ Rmas
  -> (w ∈ superficie (solido_esfera centro radio) <-> w ∈ puntos_esfera centro radio)
  /\ (w ∈ interior (solido_esfera centro radio) <-> potencia_esfera w centro radio < 0). (* solido_esfera.conj.1 *)

Definition solido_plano_conj_1 : Prop :=
  forall (centro w : Punto) (dir : Vector), dir ∈ Unitario
  -> w ∈ superficie (solido_plano centro dir) <-> w ∈ puntos_plano centro dir. (* solido_plano.conj.1 *)

Definition solido_cilindro_conj_1 : Prop :=
  forall (centro w : Punto) (radio h : R) (dir : Vector), radio ∈ Rmas -> h ∈ Rmas -> dir ∈ Unitario
  -> w ∈ superficie (solido_cilindro centro radio dir h) <-> w ∈ puntos_cilindro centro radio dir h
  \/ potencia_cilindro w centro radio dir <= 0
  /\ (avance w centro dir = 0 \/ avance w centro dir = h). (* solido_cilindro.conj.1 *)

Definition superficie_conj_2 : Prop :=
  forall (S : set (set Cuadrica)) (u w : Punto), S ∈ ℙ (ℙ Cuadrica_ok) -> dentro w ⊆ dentro u -> fuera w ⊆ fuera u
  -> (u ∈ cuerpo S -> w ∈ cuerpo S) /\ (u ∈ superficie S -> w ∈ superficie S). (* superficie.conj.2 *)

Definition superficie_desde_conj_1 : Prop :=
  forall (S : set (set Cuadrica)) (cs : set Cuadrica) (rayo : Rayo) (en : set Cuadrica) (w : Punto), S
  ∈ ℙ (ℙ Cuadrica_ok) -> cs ∈ 𝔽 Cuadrica_ok -> rayo ∈ Rayo_ok -> en ∈ con_multiplos -> hecho_de S cs
  -> superficie_desde S rayo en w -> (exists (t : R) (q : Punto), t ∈ Rmas /\ en_parametro rayo t q
  /\ superficie_desde S rayo en q /\ forall (s1 : R) (u : Punto), s1 ∈ Rmas -> en_parametro rayo s1 u
  -> superficie_desde S rayo en u -> t <= s1) \/ exists t : R, t ∈ Rmas /\ forall (s1 : R) (u : Punto), s1 ∈ Rmas
  -> s1 < t -> en_parametro rayo s1 u -> superficie_desde S rayo en u. (* superficie_desde.conj.1 *)

End Especificacion.
