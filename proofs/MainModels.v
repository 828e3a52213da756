(** What is proved of the models beside the text, and nothing else: the executable oracle, the compact tables, and
    acceleration, with the tests of its boxes in floating point. As in MainText.v, which has the names, each proof is a reference.

    tables_ok, retrieve  == the compact tables' invariant, and the scene they represent *)
From Coq Require Import Reals List.
From Flocq Require Raux Zaux BinarySingleNaN Binary Bits.
From Durero Require Import Toolkit Especificacion.
From Durero Require Escena Operaciones Edits Totals Errata Puntos Trazador Flat Interseccion Printed Retrieve TotalTables
  Tablas RowsAdded RowsRemoved TotalRows RowsRefused Promocion Lifted TablasOfRows ClosedForm
  Iluminacion Recorrido Acceleration Firsts Surd Quadratic Exacto ExactoEscena
  Limits Nearest Chain Quick Exactly ExactHit Slab Bundles Beams.
Import Escena Operaciones Edits Totals Errata Puntos Trazador Flat Interseccion Printed Retrieve Iluminacion.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** * 6. The executable oracle, extracted to OCaml and run in the tests *)

Theorem executable_first_hit_is_right I S p v (es : list (I * Exacto.shape * bool)) :
  (0 < S)%Z -> Exacto.is_first_hit S p v es (Exacto.first_hit S p v es).
Proof. exact (Exacto.first_hit_correct S p v es). Qed.

(** On a list that describes a scene with integer attributes over S, its answer is the Z text's. *)
Theorem executable_first_hit_is_Primera_Interseccion Elemento (s s' : Escena Elemento) S en p v es :
  (0 < S)%Z -> Escena_ok s -> Rayo_ok (ExactoEscena.the_ray S p v) -> ExactoEscena.describes Elemento S s en es ->
  Xi_Escena s s' -> en ⊆ elementos s ->
  let ray := ExactoEscena.the_ray S p v in
  match Exacto.first_hit S p v es with
  | Exacto.Hit x l => Hay_Interseccion s s' ray en hit (fun e => In e l) (Surd.val x) (point_at ray (Surd.val x))
  | Exacto.Miss => No_Hay_Interseccion s s' ray en miss ∅
  | Exacto.NoMin l => No_Hay_Minimo s s' ray en no_minimum (fun e => In e l)
  end.
Proof. intros. now apply ExactoEscena.first_hit_is_Primera_Interseccion. Qed.

(** What is compared with a program's answer, bit by bit: the parameter and the point, each rounded once to binary64, by a
    function over integers. Hints of where to look change nothing; a zero has the sign of what was rounded. *)
Theorem the_executable_rounding_is_that_of_binary64 guess place x : Surd.valid x ->
  let f := Nearest.nearest guess place x in
  Limits.rounded_once f (Surd.val x) /\ BinarySingleNaN.is_nan f = false
  /\ BinarySingleNaN.Bsign f = Raux.Rlt_bool (Surd.val x) 0
  /\ Binary.B2BSN 53 1024 (Bits.b64_of_bits (Nearest.bits f)) = f.
Proof. exact (Nearest.nearest_right guess place x). Qed.

Theorem the_judged_bytes_are_the_texts_rounded_once Elemento (s s' : Escena Elemento) S en p v es guess at_t at_x at_y at_z :
  (0 < S)%Z -> Escena_ok s -> Rayo_ok (ExactoEscena.the_ray S p v) -> ExactoEscena.describes Elemento S s en es ->
  Xi_Escena s s' -> en ⊆ elementos s ->
  let ray := ExactoEscena.the_ray S p v in
  forall x l, Exacto.first_hit S p v es = Exacto.Hit x l ->
  let out := Chain.exactly_printed guess at_t at_x at_y at_z S p v x in
  exists t, Hay_Interseccion s s' ray en hit (fun e => In e l) t (point_at ray t) /\ Chain.rounds ray out t.
Proof. exact (Chain.judged_bytes_are_the_texts Elemento s s' S en p v es guess at_t at_x at_y at_z). Qed.

(** What rounds in the program, after its quick path: if it ends, in however many turns, what it stores is the number
    (x + y√delta)/w rounded once. Exactly.v has number/dyadic_surd step by step. *)
Theorem the_exact_rounding_says_nothing_false turns mx ex my ey md ed mw ew out x :
  BinInt.Z.le 0 md -> mw <> 0%Z -> Exactly.exactly turns mx ex my ey md ed mw ew = Some out -> Exactly.stored x out ->
  Limits.rounded_once x ((Quick.dyadic mx ex + Quick.dyadic my ey * sqrt (Quick.dyadic md ed)) / Quick.dyadic mw ew).
Proof. exact (Exactly.exact_rounding_right turns mx ex my ey md ed mw ew out x). Qed.

(** And it ends. *)
Theorem the_exact_rounding_ends mx ex my ey md ed mw ew : BinInt.Z.le 0 md -> mw <> 0%Z ->
  exists turns out, Exactly.exactly turns mx ex my ey md ed mw ew = Some out.
Proof. exact (ExactHit.exactly_ends mx ex my ey md ed mw ew). Qed.

(** * 7. The compact scene refines the model *)
Section Refinement.
Variable Elemento : Type.
Hypothesis Elemento_dec : forall e e' : Elemento, {e = e'} + {e <> e'}.
Notation add_total := (TotalTables.add_total Elemento Elemento_dec).
Notation remove_total := (TotalTables.remove_total Elemento Elemento_dec).

Theorem tables_represent_scenes :
  (tables_ok _ (empty_tables Elemento) /\ Init (retrieve _ (empty_tables Elemento)))
  /\ forall T, tables_ok Elemento T -> Escena_ok (retrieve _ T).
Proof. exact (conj (empty_tables_Init Elemento) (retrieve_ok Elemento)). Qed.

Theorem operations_on_tables_commute T e t c r d h k abc : tables_ok Elemento T ->
  (let (T', answer) := add_total T e t c r d h k abc in
   tables_ok _ T' /\ Agregar_Elemento_Total (retrieve _ T) (retrieve _ T') e t c r d h k abc answer)
  /\ (let (T', answer) := remove_total T e in
   tables_ok _ T' /\ Eliminar_Elemento_Total (retrieve _ T) (retrieve _ T') e answer).
Proof. exact (TotalTables.general_operations_refine Elemento Elemento_dec T e t c r d h k abc). Qed.

(** And of one type: their t? is hidden, an element that is there is told first, then the first clause that does not hold;
    a removal that names another type than the element's leaves the tables as they are. *)
Theorem operations_of_one_type_commute T e t c r d h k abc : tables_ok Elemento T ->
  (let (T', answer) := TotalTables.add_total_of Elemento Elemento_dec t T e c r d h k abc in
   tables_ok _ T' /\ TotalTables.Agregar_Total Elemento t (retrieve _ T) (retrieve _ T') e answer c r d h k abc)
  /\ (let (T', answer) := TotalTables.remove_total_of Elemento Elemento_dec t T e in
   tables_ok _ T' /\ TotalTables.Eliminar_Total Elemento t (retrieve _ T) (retrieve _ T') e answer).
Proof.
  intros ok. exact (conj (TotalTables.add_total_of_refines Elemento Elemento_dec t T e c r d h k abc ok)
    (TotalTables.remove_total_of_refines Elemento Elemento_dec t T e ok)).
Qed.
(** The lists of rows are the tables of spec/tablas.tex, as Tablas.v states them: they stand for the scene that the text
    says, and what appends a row or moves the last one into the gap is the text's addition and removal, which leave no
    other next state. *)
Notation tablas_of := (TablasOfRows.tablas_of Elemento).
Notation texts_addition := (TablasOfRows.texts_addition Elemento).
Notation texts_removal := (TablasOfRows.texts_removal Elemento).
Notation add := (Retrieve.add Elemento Elemento_dec).
Notation remove := (Retrieve.remove Elemento Elemento_dec).

Theorem rows_are_the_tables_of_the_text :
  Tablas.Init_Tablas (tablas_of (empty_tables Elemento))
  /\ forall T, tables_ok Elemento T -> Tablas.Retrieve (retrieve _ T) (tablas_of T)
  /\ (forall e x, index Elemento T e = None -> valid x -> texts_addition x (tablas_of T) (tablas_of (add T e x)) e
      /\ forall U, texts_addition x (tablas_of T) U e -> Tablas.Tablas_eq (tablas_of (add T e x)) U)
  /\ (forall e t i, index Elemento T e = Some (t, i) -> texts_removal t (tablas_of T) (tablas_of (remove T e)) e
      /\ forall U, texts_removal t (tablas_of T) U e -> Tablas.Tablas_eq (tablas_of (remove T e)) U).
Proof.
  split; [apply TablasOfRows.empty_rows_are_the_first_tables |]. intros T ok.
  split; [now apply TablasOfRows.rows_retrieve_as_the_text | split].
  - intros e x new good. pose proof (TablasOfRows.add_is_the_texts Elemento Elemento_dec T e x ok new good) as A.
    split; [exact A | intros U H; exact (TablasOfRows.an_addition_has_one_outcome _ _ _ _ _ _ A H)].
  - intros e t i found. pose proof (TablasOfRows.remove_is_the_texts Elemento Elemento_dec T e t i ok found) as A.
    split; [exact A | intros U H; exact (TablasOfRows.a_removal_has_one_outcome _ _ _ _ _ _ A H)].
Qed.
End Refinement.

(** The refinement as the text has it: the obligations of spec/tablas.tex, as Tablas.v states them *)

Theorem the_obligations_of_the_tables_hold Elemento :
  @Tablas.Retrieve_conj_1 Elemento
  /\ @Tablas.Retrieve_conj_2 Elemento
  /\ @Tablas.Retrieve_conj_3 Elemento
  /\ @Tablas.Init_Tablas_conj_1 Elemento
  /\ @Tablas.Init_Tablas_conj_2 Elemento
  /\ @Tablas.Agregar_Esfera_Tablas_conj_1 Elemento
  /\ @Tablas.Agregar_Esfera_Tablas_conj_2 Elemento
  /\ @Tablas.Agregar_Cilindro_Tablas_conj_1 Elemento
  /\ @Tablas.Agregar_Cilindro_Tablas_conj_2 Elemento
  /\ @Tablas.Agregar_Cono_Tablas_conj_1 Elemento
  /\ @Tablas.Agregar_Cono_Tablas_conj_2 Elemento
  /\ @Tablas.Agregar_Tronco_Tablas_conj_1 Elemento
  /\ @Tablas.Agregar_Tronco_Tablas_conj_2 Elemento
  /\ @Tablas.Agregar_Plano_Tablas_conj_1 Elemento
  /\ @Tablas.Agregar_Plano_Tablas_conj_2 Elemento
  /\ @Tablas.Agregar_Disco_Tablas_conj_1 Elemento
  /\ @Tablas.Agregar_Disco_Tablas_conj_2 Elemento
  /\ @Tablas.Agregar_Triangulo_Tablas_conj_1 Elemento
  /\ @Tablas.Agregar_Triangulo_Tablas_conj_2 Elemento
  /\ @Tablas.Eliminar_Esfera_Tablas_conj_1 Elemento
  /\ @Tablas.Eliminar_Esfera_Tablas_conj_2 Elemento
  /\ @Tablas.Eliminar_Cilindro_Tablas_conj_1 Elemento
  /\ @Tablas.Eliminar_Cilindro_Tablas_conj_2 Elemento
  /\ @Tablas.Eliminar_Cono_Tablas_conj_1 Elemento
  /\ @Tablas.Eliminar_Cono_Tablas_conj_2 Elemento
  /\ @Tablas.Eliminar_Tronco_Tablas_conj_1 Elemento
  /\ @Tablas.Eliminar_Tronco_Tablas_conj_2 Elemento
  /\ @Tablas.Eliminar_Plano_Tablas_conj_1 Elemento
  /\ @Tablas.Eliminar_Plano_Tablas_conj_2 Elemento
  /\ @Tablas.Eliminar_Disco_Tablas_conj_1 Elemento
  /\ @Tablas.Eliminar_Disco_Tablas_conj_2 Elemento
  /\ @Tablas.Eliminar_Triangulo_Tablas_conj_1 Elemento
  /\ @Tablas.Eliminar_Triangulo_Tablas_conj_2 Elemento.
Proof.
  exact (conj RowsAdded.tables_stand_for_one_scene
    (conj RowsAdded.tables_that_stay_stand_for_a_scene_that_stays
    (conj RowsAdded.the_index_knows_the_elements
    (conj RowsAdded.first_tables_stand_for_the_first_scene
    (conj RowsAdded.first_tables_exist
    (conj RowsAdded.Agregar_Esfera_Tablas_applicable
    (conj RowsAdded.Agregar_Esfera_Tablas_correct
    (conj RowsAdded.Agregar_Cilindro_Tablas_applicable
    (conj RowsAdded.Agregar_Cilindro_Tablas_correct
    (conj RowsAdded.Agregar_Cono_Tablas_applicable
    (conj RowsAdded.Agregar_Cono_Tablas_correct
    (conj RowsAdded.Agregar_Tronco_Tablas_applicable
    (conj RowsAdded.Agregar_Tronco_Tablas_correct
    (conj RowsAdded.Agregar_Plano_Tablas_applicable
    (conj RowsAdded.Agregar_Plano_Tablas_correct
    (conj RowsAdded.Agregar_Disco_Tablas_applicable
    (conj RowsAdded.Agregar_Disco_Tablas_correct
    (conj RowsAdded.Agregar_Triangulo_Tablas_applicable
    (conj RowsAdded.Agregar_Triangulo_Tablas_correct
    (conj RowsRemoved.Eliminar_Esfera_Tablas_applicable
    (conj RowsRemoved.Eliminar_Esfera_Tablas_correct
    (conj RowsRemoved.Eliminar_Cilindro_Tablas_applicable
    (conj RowsRemoved.Eliminar_Cilindro_Tablas_correct
    (conj RowsRemoved.Eliminar_Cono_Tablas_applicable
    (conj RowsRemoved.Eliminar_Cono_Tablas_correct
    (conj RowsRemoved.Eliminar_Tronco_Tablas_applicable
    (conj RowsRemoved.Eliminar_Tronco_Tablas_correct
    (conj RowsRemoved.Eliminar_Plano_Tablas_applicable
    (conj RowsRemoved.Eliminar_Plano_Tablas_correct
    (conj RowsRemoved.Eliminar_Disco_Tablas_applicable
    (conj RowsRemoved.Eliminar_Disco_Tablas_correct
    (conj RowsRemoved.Eliminar_Triangulo_Tablas_applicable
    RowsRemoved.Eliminar_Triangulo_Tablas_correct)))))))))))))))))))))))))))))))).
Qed.

(** And its total operations: each happens whatever its inputs, and changes, refuses and answers as that of the scene. *)
Theorem the_total_operations_on_tables_are_those_of_a_scene Elemento :
  @TotalRows.Agregar_Esfera_Total_Tablas_conj_1 Elemento
  /\ @TotalRows.Agregar_Esfera_Total_Tablas_conj_2 Elemento
  /\ @TotalRows.Agregar_Cilindro_Total_Tablas_conj_1 Elemento
  /\ @TotalRows.Agregar_Cilindro_Total_Tablas_conj_2 Elemento
  /\ @TotalRows.Agregar_Cono_Total_Tablas_conj_1 Elemento
  /\ @TotalRows.Agregar_Cono_Total_Tablas_conj_2 Elemento
  /\ @TotalRows.Agregar_Tronco_Total_Tablas_conj_1 Elemento
  /\ @TotalRows.Agregar_Tronco_Total_Tablas_conj_2 Elemento
  /\ @TotalRows.Agregar_Plano_Total_Tablas_conj_1 Elemento
  /\ @TotalRows.Agregar_Plano_Total_Tablas_conj_2 Elemento
  /\ @TotalRows.Agregar_Disco_Total_Tablas_conj_1 Elemento
  /\ @TotalRows.Agregar_Disco_Total_Tablas_conj_2 Elemento
  /\ @TotalRows.Agregar_Triangulo_Total_Tablas_conj_1 Elemento
  /\ @TotalRows.Agregar_Triangulo_Total_Tablas_conj_2 Elemento
  /\ @TotalRows.Eliminar_Esfera_Total_Tablas_conj_1 Elemento
  /\ @TotalRows.Eliminar_Esfera_Total_Tablas_conj_2 Elemento
  /\ @TotalRows.Eliminar_Cilindro_Total_Tablas_conj_1 Elemento
  /\ @TotalRows.Eliminar_Cilindro_Total_Tablas_conj_2 Elemento
  /\ @TotalRows.Eliminar_Cono_Total_Tablas_conj_1 Elemento
  /\ @TotalRows.Eliminar_Cono_Total_Tablas_conj_2 Elemento
  /\ @TotalRows.Eliminar_Tronco_Total_Tablas_conj_1 Elemento
  /\ @TotalRows.Eliminar_Tronco_Total_Tablas_conj_2 Elemento
  /\ @TotalRows.Eliminar_Plano_Total_Tablas_conj_1 Elemento
  /\ @TotalRows.Eliminar_Plano_Total_Tablas_conj_2 Elemento
  /\ @TotalRows.Eliminar_Disco_Total_Tablas_conj_1 Elemento
  /\ @TotalRows.Eliminar_Disco_Total_Tablas_conj_2 Elemento
  /\ @TotalRows.Eliminar_Triangulo_Total_Tablas_conj_1 Elemento
  /\ @TotalRows.Eliminar_Triangulo_Total_Tablas_conj_2 Elemento
  /\ @TotalRows.Agregar_Elemento_Total_Tablas_conj_1 Elemento
  /\ @TotalRows.Agregar_Elemento_Total_Tablas_conj_2 Elemento
  /\ @TotalRows.Eliminar_Elemento_Total_Tablas_conj_1 Elemento
  /\ @TotalRows.Eliminar_Elemento_Total_Tablas_conj_2 Elemento.
Proof.
  exact (conj RowsRefused.Agregar_Esfera_Total_Tablas_applicable
    (conj RowsRefused.Agregar_Esfera_Total_Tablas_correct
    (conj RowsRefused.Agregar_Cilindro_Total_Tablas_applicable
    (conj RowsRefused.Agregar_Cilindro_Total_Tablas_correct
    (conj RowsRefused.Agregar_Cono_Total_Tablas_applicable
    (conj RowsRefused.Agregar_Cono_Total_Tablas_correct
    (conj RowsRefused.Agregar_Tronco_Total_Tablas_applicable
    (conj RowsRefused.Agregar_Tronco_Total_Tablas_correct
    (conj RowsRefused.Agregar_Plano_Total_Tablas_applicable
    (conj RowsRefused.Agregar_Plano_Total_Tablas_correct
    (conj RowsRefused.Agregar_Disco_Total_Tablas_applicable
    (conj RowsRefused.Agregar_Disco_Total_Tablas_correct
    (conj RowsRefused.Agregar_Triangulo_Total_Tablas_applicable
    (conj RowsRefused.Agregar_Triangulo_Total_Tablas_correct
    (conj RowsRefused.Eliminar_Esfera_Total_Tablas_applicable
    (conj RowsRefused.Eliminar_Esfera_Total_Tablas_correct
    (conj RowsRefused.Eliminar_Cilindro_Total_Tablas_applicable
    (conj RowsRefused.Eliminar_Cilindro_Total_Tablas_correct
    (conj RowsRefused.Eliminar_Cono_Total_Tablas_applicable
    (conj RowsRefused.Eliminar_Cono_Total_Tablas_correct
    (conj RowsRefused.Eliminar_Tronco_Total_Tablas_applicable
    (conj RowsRefused.Eliminar_Tronco_Total_Tablas_correct
    (conj RowsRefused.Eliminar_Plano_Total_Tablas_applicable
    (conj RowsRefused.Eliminar_Plano_Total_Tablas_correct
    (conj RowsRefused.Eliminar_Disco_Total_Tablas_applicable
    (conj RowsRefused.Eliminar_Disco_Total_Tablas_correct
    (conj RowsRefused.Eliminar_Triangulo_Total_Tablas_applicable
    (conj RowsRefused.Eliminar_Triangulo_Total_Tablas_correct
    (conj RowsRefused.Agregar_Elemento_Total_Tablas_applicable
    (conj RowsRefused.Agregar_Elemento_Total_Tablas_correct
    (conj RowsRefused.Eliminar_Elemento_Total_Tablas_applicable
    RowsRefused.Eliminar_Elemento_Total_Tablas_correct))))))))))))))))))))))))))))))).
Qed.

(** The scene of spec/promocion.tex, as Promocion.v states it: one function from names to shapes is the same scene, and an
    operation on a shape, lifted by a frame, is that of the scene. *)
Theorem shapes_and_lifted_operations_are_the_scene_and_its_own Elemento :
  @Promocion.Retrato_conj_1 Elemento
  /\ @Promocion.Recobro_conj_1 Elemento
  /\ @Promocion.Init_Formas_conj_1 Elemento
  /\ @Promocion.Init_Formas_conj_2 Elemento
  /\ @Promocion.Agregar_Esfera_Formas_conj_1 Elemento
  /\ @Promocion.Agregar_Esfera_Formas_conj_2 Elemento
  /\ @Promocion.Agregar_Cilindro_Formas_conj_1 Elemento
  /\ @Promocion.Agregar_Cilindro_Formas_conj_2 Elemento
  /\ @Promocion.Agregar_Cono_Formas_conj_1 Elemento
  /\ @Promocion.Agregar_Cono_Formas_conj_2 Elemento
  /\ @Promocion.Agregar_Tronco_Formas_conj_1 Elemento
  /\ @Promocion.Agregar_Tronco_Formas_conj_2 Elemento
  /\ @Promocion.Agregar_Plano_Formas_conj_1 Elemento
  /\ @Promocion.Agregar_Plano_Formas_conj_2 Elemento
  /\ @Promocion.Agregar_Disco_Formas_conj_1 Elemento
  /\ @Promocion.Agregar_Disco_Formas_conj_2 Elemento
  /\ @Promocion.Agregar_Triangulo_Formas_conj_1 Elemento
  /\ @Promocion.Agregar_Triangulo_Formas_conj_2 Elemento
  /\ @Promocion.Eliminar_Esfera_Formas_conj_1 Elemento
  /\ @Promocion.Eliminar_Esfera_Formas_conj_2 Elemento
  /\ @Promocion.Eliminar_Cilindro_Formas_conj_1 Elemento
  /\ @Promocion.Eliminar_Cilindro_Formas_conj_2 Elemento
  /\ @Promocion.Eliminar_Cono_Formas_conj_1 Elemento
  /\ @Promocion.Eliminar_Cono_Formas_conj_2 Elemento
  /\ @Promocion.Eliminar_Tronco_Formas_conj_1 Elemento
  /\ @Promocion.Eliminar_Tronco_Formas_conj_2 Elemento
  /\ @Promocion.Eliminar_Plano_Formas_conj_1 Elemento
  /\ @Promocion.Eliminar_Plano_Formas_conj_2 Elemento
  /\ @Promocion.Eliminar_Disco_Formas_conj_1 Elemento
  /\ @Promocion.Eliminar_Disco_Formas_conj_2 Elemento
  /\ @Promocion.Eliminar_Triangulo_Formas_conj_1 Elemento
  /\ @Promocion.Eliminar_Triangulo_Formas_conj_2 Elemento.
Proof.
  exact (conj Lifted.a_scene_has_one_function_to_shapes
    (conj Lifted.shapes_say_one_scene
    (conj Lifted.first_shapes_say_the_first_scene
    (conj Lifted.the_first_scene_has_the_first_shapes
    (conj Lifted.Agregar_Esfera_is_lifted
    (conj Lifted.Agregar_Esfera_Formas_is_of_the_scene
    (conj Lifted.Agregar_Cilindro_is_lifted
    (conj Lifted.Agregar_Cilindro_Formas_is_of_the_scene
    (conj Lifted.Agregar_Cono_is_lifted
    (conj Lifted.Agregar_Cono_Formas_is_of_the_scene
    (conj Lifted.Agregar_Tronco_is_lifted
    (conj Lifted.Agregar_Tronco_Formas_is_of_the_scene
    (conj Lifted.Agregar_Plano_is_lifted
    (conj Lifted.Agregar_Plano_Formas_is_of_the_scene
    (conj Lifted.Agregar_Disco_is_lifted
    (conj Lifted.Agregar_Disco_Formas_is_of_the_scene
    (conj Lifted.Agregar_Triangulo_is_lifted
    (conj Lifted.Agregar_Triangulo_Formas_is_of_the_scene
    (conj Lifted.Eliminar_Esfera_is_lifted
    (conj Lifted.Eliminar_Esfera_Formas_is_of_the_scene
    (conj Lifted.Eliminar_Cilindro_is_lifted
    (conj Lifted.Eliminar_Cilindro_Formas_is_of_the_scene
    (conj Lifted.Eliminar_Cono_is_lifted
    (conj Lifted.Eliminar_Cono_Formas_is_of_the_scene
    (conj Lifted.Eliminar_Tronco_is_lifted
    (conj Lifted.Eliminar_Tronco_Formas_is_of_the_scene
    (conj Lifted.Eliminar_Plano_is_lifted
    (conj Lifted.Eliminar_Plano_Formas_is_of_the_scene
    (conj Lifted.Eliminar_Disco_is_lifted
    (conj Lifted.Eliminar_Disco_Formas_is_of_the_scene
    (conj Lifted.Eliminar_Triangulo_is_lifted
    Lifted.Eliminar_Triangulo_Formas_is_of_the_scene))))))))))))))))))))))))))))))).
Qed.

Theorem the_closed_form_of_the_text_is_alcance Elemento :
  Tablas.raices_conj_1 Elemento
  /\ Tablas.raices_conj_2 Elemento
  /\ Tablas.raices_conj_3 Elemento
  /\ Tablas.raices_conj_4 Elemento.
Proof.
  exact (conj (ClosedForm.the_closed_form_of_a_sphere_is_alcance Elemento)
    (conj (ClosedForm.the_closed_form_of_a_cylinder_is_alcance Elemento)
    (conj (ClosedForm.the_closed_form_of_a_cone_is_alcance Elemento)
    (ClosedForm.the_closed_form_of_a_truncated_cone_is_alcance Elemento)))).
Qed.

(** * 8. Acceleration: visiting cells in any order, and skipping those beyond the best, loses nothing *)
Section Acceleration.
Variables (T : Type) (le : T -> T -> bool).
Hypothesis total : forall a b, le a b = true \/ le b a = true.
Hypothesis trans : forall a b c, le a b = true -> le b c = true -> le a c = true.
Hypothesis antisym : forall a b, le a b = true -> le b a = true -> a = b.
Variables (E : Type) (hit_of : E -> option T).
Notation first_hit := (Recorrido.first_hit T le E hit_of).
Notation walks := (Recorrido.walks T le E hit_of (Recorrido.entered_beyond T le E)).

Theorem the_scan_finds_the_first_hit es : first_hit es (Recorrido.scan T le E hit_of es).
Proof. exact (Recorrido.scan_first_hit T le total trans antisym E hit_of es). Qed.

(** Whatever rule skips cells, if it skips only what leads to no hit up to the best. *)
Theorem every_traversal_finds_the_first_hit (prunable : Recorrido.best_so_far T E -> Recorrido.cell T E -> Prop) es cs best :
  (forall best c, prunable best c -> forall e t, Recorrido.leads T le E c e t -> hit_of e = Some t ->
   exists b gs, best = Some (b, gs) /\ le t b = false) ->
  Forall (Recorrido.lists_from T E es) cs -> Recorrido.reachable T le E hit_of es cs ->
  Recorrido.walks T le E hit_of prunable (cs, None) (nil, best) -> first_hit es best.
Proof.
  intros prunable_right.
  exact (Recorrido.traversal_first_hit T le total trans antisym E hit_of prunable prunable_right es cs best).
Qed.

(** There is such a traversal, and its end is one: the same parameter and the same set of elements. *)
Theorem every_walk_can_end prunable cs best : exists best', Recorrido.walks T le E hit_of prunable (cs, best) (nil, best').
Proof. exact (Recorrido.walk_exists T le E hit_of prunable cs best). Qed.

Theorem the_first_hit_is_one es es' r r' : (forall e, In e es <-> In e es') -> first_hit es r -> first_hit es' r' ->
  match r, r' with
  | None, None => True
  | Some (b, gs), Some (b', gs') => b = b' /\ forall e, In e gs <-> In e gs'
  | _, _ => False
  end.
Proof. exact (Recorrido.first_hit_unique T le antisym E hit_of es es' r r'). Qed.

Variables (ray : T -> Acceleration.point) (surface : E -> Acceleration.point -> Prop).
Hypothesis hits_on_surface : forall e t, hit_of e = Some t -> surface e (ray t).

(** Boxes that contain the elements below them, whose test never rejects a ray that meets them. *)
Theorem bounding_volumes_find_the_first_hit box_entry :
  (forall b, Acceleration.conservative T le ray (Acceleration.inside b) (box_entry b)) ->
  forall es a best,
  Recorrido.lists_from T E es (Acceleration.bvh_cell T E box_entry a) ->
  (forall e, In e es -> Acceleration.under E surface e a) ->
  walks (Acceleration.bvh_cell T E box_entry a :: nil, None) (nil, best) -> first_hit es best.
Proof. exact (Acceleration.bvh_first_hit T le total trans antisym E hit_of ray surface hits_on_surface box_entry). Qed.

(** Cells that overlap elements: each element stands in every leaf that its surface meets. *)
Theorem octrees_find_the_first_hit box_entry :
  (forall b, Acceleration.conservative T le ray (Acceleration.inside b) (box_entry b)) ->
  forall es b a best,
  Recorrido.lists_from T E es (Acceleration.oct_cell T E box_entry b a) -> Acceleration.oct_listed E surface es b a ->
  (forall e w, In e es -> surface e w -> Acceleration.inside b w) ->
  walks (Acceleration.oct_cell T E box_entry b a :: nil, None) (nil, best) -> first_hit es best.
Proof. exact (Acceleration.octree_first_hit T le total trans antisym E hit_of ray surface hits_on_surface box_entry). Qed.

Theorem bsp_trees_find_the_first_hit region_entry :
  (forall r, Acceleration.conservative T le ray (Acceleration.in_region r) (region_entry r)) ->
  forall es a best,
  Recorrido.lists_from T E es (Acceleration.bsp_cell T E region_entry nil a) ->
  Acceleration.bsp_listed E surface es nil a ->
  walks (Acceleration.bsp_cell T E region_entry nil a :: nil, None) (nil, best) -> first_hit es best.
Proof. exact (Acceleration.bsp_first_hit T le total trans antisym E hit_of ray surface hits_on_surface region_entry). Qed.

(** A grid walked in the order of the ray, stopping only when the best lies strictly before the end of the cell. *)
Theorem grids_find_the_first_hit es (path : list (Acceleration.box * Recorrido.stretch T E)) :
  let cs := map snd path in
  Forall (fun c => incl (Recorrido.listed T E c) es) cs -> Recorrido.in_order T le E cs ->
  (forall b c, In (b, c) path -> Acceleration.lists_box T E surface es b c) ->
  (forall e t, In e es -> hit_of e = Some t -> exists b c, In (b, c) path /\ Acceleration.inside b (ray t) /\
     le (Recorrido.t_in T E c) t = true /\ le t (Recorrido.t_out T E c) = true) ->
  first_hit es (Recorrido.front_to_back T le E hit_of true cs None).
Proof. exact (Acceleration.grid_first_hit T le total trans antisym E hit_of ray surface hits_on_surface es path). Qed.
End Acceleration.

(** The parameters that these are about: reals, and below all of them "no minimum". The first hit that a traversal finds of
    the first hits of the elements is that of the text. *)
Theorem the_first_hit_of_a_traversal_is_Primera_Interseccion Elemento (s s' : Escena Elemento) ray en elements
  (hit_of : Elemento -> option Firsts.first) best :
  Escena_ok s -> Rayo_ok ray -> Xi_Escena s s' -> en ⊆ elementos s -> (forall e, In e elements <-> e ∈ elementos s) ->
  (forall e, In e elements -> Firsts.is_first_of (met ray Elemento s en e) (hit_of e)) ->
  Recorrido.first_hit Firsts.first Firsts.le Elemento hit_of elements best ->
  match best with
  | None => No_Hay_Interseccion s s' ray en miss ∅
  | Some (None, l) => No_Hay_Minimo s s' ray en no_minimum (fun e => In e l)
  | Some (Some t, l) => Hay_Interseccion s s' ray en hit (fun e => In e l) t (point_at ray t)
  end.
Proof.
  intros ok ray_ok same known all firsts.
  exact (Firsts.first_hit_says Elemento s s' ray en ok ray_ok same known elements all hit_of firsts best).
Qed.

Theorem those_parameters_are_totally_ordered :
  (forall a b, Firsts.le a b = true \/ Firsts.le b a = true)
  /\ (forall a b c, Firsts.le a b = true -> Firsts.le b c = true -> Firsts.le a c = true)
  /\ forall a b, Firsts.le a b = true -> Firsts.le b a = true -> a = b.
Proof. exact (conj Firsts.le_total (conj Firsts.le_trans Firsts.le_antisym)). Qed.

(** The box test with its widened exit, computed in IEEE 754 arithmetic, never rejects a ray that meets the box. *)
Theorem the_slab_test_never_rejects_in_binary64 box best t :
  Forall (Slab.slab_ok 53 1024) box -> 0 <= t -> Forall (fun a => Slab.covers 53 1024 a t) box ->
  Slab.not_before 53 1024 best t ->
  Slab.visit 53 1024 Slab.prec64 Slab.less64 Slab.grow64 Slab.tiny64 box best = true.
Proof. exact (Slab.slab64_never_rejects box best t). Qed.

Theorem the_slab_test_never_rejects_in_binary32 box best t :
  Forall (Slab.slab_ok 24 128) box -> 0 <= t -> Forall (fun a => Slab.covers 24 128 a t) box ->
  Slab.not_before 24 128 best t ->
  Slab.visit 24 128 Slab.prec32 Slab.less32 Slab.grow32 Slab.tiny32 box best = true.
Proof. exact (Slab.slab32_never_rejects box best t). Qed.

(** Rays that are tested together, by the ends between which they lie: none enters earlier, none leaves later, so that the
    bundle passes where one of them does. *)
Theorem a_bundle_is_entered_no_later plane p0 p1 a b p i : p0 <= p <= p1 -> a <= i <= b ->
  (0 < a -> Rmin (Bundles.crossed 53 1024 plane p1 a) (Bundles.crossed 53 1024 plane p1 b) <= Bundles.crossed 53 1024 plane p i) /\
  (b < 0 -> Rmin (Bundles.crossed 53 1024 plane p0 a) (Bundles.crossed 53 1024 plane p0 b) <= Bundles.crossed 53 1024 plane p i).
Proof. exact (Bundles.bundle_entry 53 1024 Slab.prec64 plane p0 p1 a b p i). Qed.

Theorem a_bundle_is_left_no_earlier plane p0 p1 a b p i : p0 <= p <= p1 -> a <= i <= b ->
  (0 < a -> Bundles.crossed 53 1024 plane p i <= Rmax (Bundles.crossed 53 1024 plane p0 a) (Bundles.crossed 53 1024 plane p0 b)) /\
  (b < 0 -> Bundles.crossed 53 1024 plane p i <= Rmax (Bundles.crossed 53 1024 plane p1 a) (Bundles.crossed 53 1024 plane p1 b)).
Proof. exact (Bundles.bundle_exit 53 1024 Slab.prec64 plane p0 p1 a b p i). Qed.

(** Segments that are tested together, by the half-spaces that hold the ends of each, one computed (cx, cy): a box that
    holds a point between the ends is not passed over. *)
Theorem a_beam_keeps_what_its_low_side_holds px py qx qy cx cy t x0 x1 y0 y1 b X Y A :
  Rabs px <= X /\ Rabs py <= Y /\ Rabs cx <= X /\ Rabs cy <= Y ->
  Rabs (cx - qx) <= 4 * Raux.bpow Zaux.radix2 (-53) * X /\ Rabs (cy - qy) <= 4 * Raux.bpow Zaux.radix2 (-53) * Y ->
  Rabs x0 <= X /\ Rabs x1 <= X /\ Rabs y0 <= Y /\ Rabs y1 <= Y ->
  0 <= t <= 1 /\ x0 <= px + t * (qx - px) <= x1 /\ y0 <= py + t * (qy - py) <= y1 ->
  A <= Beams.side 53 1024 px b py - Beams.slack64 b X Y -> A <= Beams.side 53 1024 cx b cy - Beams.slack64 b X Y ->
  A <= Beams.side 53 1024 x1 b (Beams.near_corner b y0 y1).
Proof. exact (Beams.low_side64_keeps px py qx qy cx cy t x0 x1 y0 y1 b X Y A). Qed.

Theorem a_beam_keeps_what_its_high_side_holds px py qx qy cx cy t x0 x1 y0 y1 b X Y C :
  Rabs px <= X /\ Rabs py <= Y /\ Rabs cx <= X /\ Rabs cy <= Y ->
  Rabs (cx - qx) <= 4 * Raux.bpow Zaux.radix2 (-53) * X /\ Rabs (cy - qy) <= 4 * Raux.bpow Zaux.radix2 (-53) * Y ->
  Rabs x0 <= X /\ Rabs x1 <= X /\ Rabs y0 <= Y /\ Rabs y1 <= Y ->
  0 <= t <= 1 /\ x0 <= px + t * (qx - px) <= x1 /\ y0 <= py + t * (qy - py) <= y1 ->
  Beams.side 53 1024 px b py + Beams.slack64 b X Y <= C -> Beams.side 53 1024 cx b cy + Beams.slack64 b X Y <= C ->
  Beams.side 53 1024 x0 b (Beams.far_corner b y0 y1) <= C.
Proof. exact (Beams.high_side64_keeps px py qx qy cx cy t x0 x1 y0 y1 b X Y C). Qed.
