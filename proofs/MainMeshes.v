(** What is proved of scenes with meshes, of copies and of solids, and nothing else. As in MainText.v, which has the names, each
    proof is a reference. *)
From Coq Require Import Reals List.
From Durero Require Import Toolkit Especificacion.
From Durero Require Escena Operaciones Edits Totals Puntos Tipos Malla Meshes MeshClaims MeshesApart Beside Watertight Auditoria
  VolumeOfMesh Pieces Enclosed Screen Instancias Solidos.
Import Escena Operaciones Edits Totals Puntos.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** * Scenes with meshes *)

(** Of meshes, from spec/malla.tex, under any names of faces that are of one face each: a first scene exists; triangles of
    different meshes have different names, and all are triangles of the scene; the operations are total; a mesh that was
    added can be removed, which gives the scene before; to replace a mesh is to remove it and to add the other, and to move
    a vertex is to replace the mesh by the moved one. *)
Section Meshes.
Variables (Elemento : Type) (nombre_cara : rel (Elemento * nat) Elemento).
Hypothesis named : Malla.nombre_cara_def_1 Elemento nombre_cara.

Theorem the_conjectures_of_meshes_hold :
  Malla.Init_Mallas_conj_1 Elemento nombre_cara
  /\ Malla.suyos_conj_1 Elemento nombre_cara
  /\ Malla.de_malla_conj_1 Elemento nombre_cara
  /\ Malla.Agregar_Malla_Total_conj_1 Elemento nombre_cara
  /\ Malla.Eliminar_Malla_Total_conj_1 Elemento nombre_cara
  /\ Malla.Reemplazar_Malla_Total_conj_1 Elemento nombre_cara
  /\ Malla.Mover_Vertice_Total_conj_1 Elemento nombre_cara
  /\ Malla.Eliminar_Malla_conj_1 Elemento nombre_cara
  /\ Malla.Reemplazar_Malla_conj_1 Elemento nombre_cara
  /\ Malla.Mover_Vertice_conj_1 Elemento nombre_cara.
Proof.
  exact (conj (MeshClaims.a_first_scene_with_meshes_exists Elemento nombre_cara) (conj
    (Meshes.different_meshes_have_different_names Elemento nombre_cara named) (conj
    (Meshes.triangles_of_meshes_are_triangles Elemento nombre_cara) (conj (MeshClaims.adding_a_mesh_is_total Elemento
    nombre_cara named) (conj (MeshClaims.removing_a_mesh_is_total Elemento nombre_cara named) (conj
    (MeshClaims.replacing_a_mesh_is_total Elemento nombre_cara named) (conj (MeshClaims.moving_a_vertex_is_total
    Elemento nombre_cara named) (conj (MeshClaims.adding_then_removing_a_mesh_is_the_identity Elemento nombre_cara
    named) (conj (MeshClaims.replacing_is_removing_then_adding Elemento nombre_cara named)
    (MeshClaims.moving_is_replacing_by_the_moved Elemento nombre_cara named)))))))))).
Qed.

(** And the operations of single elements are total beside meshes, which they leave as they are. *)
Theorem single_elements_are_edited_beside_meshes :
  Malla.Agregar_Esfera_Mallas_conj_1 Elemento nombre_cara
  /\ Malla.Agregar_Cilindro_Mallas_conj_1 Elemento nombre_cara
  /\ Malla.Agregar_Cono_Mallas_conj_1 Elemento nombre_cara
  /\ Malla.Agregar_Tronco_Mallas_conj_1 Elemento nombre_cara
  /\ Malla.Agregar_Plano_Mallas_conj_1 Elemento nombre_cara
  /\ Malla.Agregar_Disco_Mallas_conj_1 Elemento nombre_cara
  /\ Malla.Agregar_Triangulo_Mallas_conj_1 Elemento nombre_cara
  /\ Malla.Agregar_Elemento_Mallas_conj_1 Elemento nombre_cara
  /\ Malla.Eliminar_Esfera_Mallas_conj_1 Elemento nombre_cara
  /\ Malla.Eliminar_Cilindro_Mallas_conj_1 Elemento nombre_cara
  /\ Malla.Eliminar_Cono_Mallas_conj_1 Elemento nombre_cara
  /\ Malla.Eliminar_Tronco_Mallas_conj_1 Elemento nombre_cara
  /\ Malla.Eliminar_Plano_Mallas_conj_1 Elemento nombre_cara
  /\ Malla.Eliminar_Disco_Mallas_conj_1 Elemento nombre_cara
  /\ Malla.Eliminar_Triangulo_Mallas_conj_1 Elemento nombre_cara
  /\ Malla.Eliminar_Elemento_Mallas_conj_1 Elemento nombre_cara.
Proof.
  exact (conj (Beside.Agregar_Esfera_Mallas_is_total Elemento nombre_cara) (conj
    (Beside.Agregar_Cilindro_Mallas_is_total Elemento nombre_cara) (conj (Beside.Agregar_Cono_Mallas_is_total Elemento
    nombre_cara) (conj (Beside.Agregar_Tronco_Mallas_is_total Elemento nombre_cara) (conj
    (Beside.Agregar_Plano_Mallas_is_total Elemento nombre_cara) (conj (Beside.Agregar_Disco_Mallas_is_total Elemento
    nombre_cara) (conj (Beside.Agregar_Triangulo_Mallas_is_total Elemento nombre_cara) (conj
    (Beside.Agregar_Elemento_Mallas_is_total Elemento nombre_cara) (conj (Beside.Eliminar_Esfera_Mallas_is_total
    Elemento nombre_cara) (conj (Beside.Eliminar_Cilindro_Mallas_is_total Elemento nombre_cara) (conj
    (Beside.Eliminar_Cono_Mallas_is_total Elemento nombre_cara) (conj (Beside.Eliminar_Tronco_Mallas_is_total Elemento
    nombre_cara) (conj (Beside.Eliminar_Plano_Mallas_is_total Elemento nombre_cara) (conj
    (Beside.Eliminar_Disco_Mallas_is_total Elemento nombre_cara) (conj (Beside.Eliminar_Triangulo_Mallas_is_total
    Elemento nombre_cara) (Beside.Eliminar_Elemento_Mallas_is_total Elemento nombre_cara)))))))))))))))).
Qed.

(** The elements of no mesh are a scene by themselves; with the meshes they say all, and any scene and any meshes go
    together whose names are free; no operation on meshes changes them, and none on single elements a triangle of a mesh. *)
Theorem meshes_stand_apart_from_the_other_elements :
  Malla.sueltas_conj_1 Elemento nombre_cara
  /\ Malla.sueltas_conj_2 Elemento nombre_cara
  /\ Malla.sueltas_conj_3 Elemento nombre_cara
  /\ Malla.sueltas_conj_4 Elemento nombre_cara
  /\ Malla.sueltas_conj_5 Elemento nombre_cara
  /\ Malla.sueltas_conj_6 Elemento nombre_cara
  /\ Malla.sueltas_conj_7 Elemento nombre_cara
  /\ Malla.sueltas_conj_8 Elemento nombre_cara.
Proof.
  exact (conj (MeshesApart.elements_of_no_mesh_are_a_scene Elemento nombre_cara) (conj
    (MeshesApart.elements_and_meshes_say_all Elemento nombre_cara) (conj
    (MeshesApart.elements_and_meshes_go_together Elemento nombre_cara named) (conj
    (MeshesApart.adding_a_mesh_keeps_the_others Elemento nombre_cara named) (conj
    (MeshesApart.removing_a_mesh_keeps_the_others Elemento nombre_cara named) (conj
    (MeshesApart.replacing_a_mesh_keeps_the_others Elemento nombre_cara named) (conj
    (MeshesApart.moving_a_vertex_keeps_the_others Elemento nombre_cara named)
    (MeshesApart.single_elements_leave_meshes_alone Elemento nombre_cara)))))))).
Qed.
End Meshes.

(** What makes a mesh watertight: an edge has one volume but for the sign, three signs decide what the line of a ray meets,
    no line passes between two triangles that share an edge, and one that meets the one on that edge meets the other. *)
Theorem no_line_passes_between_triangles_that_share_an_edge :
  Malla.giro_conj_1 /\ Malla.giro_conj_2 /\ Malla.giro_conj_3 /\ Malla.giro_conj_4.
Proof.
  exact (conj Watertight.an_edge_turns_one_way (conj Watertight.three_signs_decide (conj Watertight.no_line_passes_between
    Watertight.what_meets_the_edge_meets_both))).
Qed.

(** The audit of a mesh: a face that is turned over walks its edges the other way, and its determinant changes the sign; from
    whichever corner it is walked, the determinant is the same. *)
Theorem a_face_turned_over_is_audited_as_such :
  (forall c i j, Auditoria.aristas (Auditoria.turned_over c) (i, j) <-> Auditoria.aristas c (j, i))
  /\ (forall a b c : Punto,
       Auditoria.determinante (mk_Terna b c a) = Auditoria.determinante (mk_Terna a b c)
       /\ Auditoria.determinante (mk_Terna b a c) = - Auditoria.determinante (mk_Terna a b c)).
Proof. exact (conj Auditoria.turned_over_walks_back Auditoria.determinant_alternates). Qed.

(** Two faces do not cross where a plane has one of them on the one side and the other on the other, and no corner of the first
    lies on it but those that both have. *)
Theorem faces_that_a_plane_parts_do_not_cross r m n a b d level :
  (m, a) ∈ Malla.numbered (Malla.caras r) -> (n, b) ∈ Malla.numbered (Malla.caras r) ->
  (forall i p, i ∈ Auditoria.esquinas a -> (i, p) ∈ Malla.numbered (Malla.puntos r) ->
    Auditoria.along d p <= level /\ (i ∉ Auditoria.esquinas b -> Auditoria.along d p < level)) ->
  (forall i p, i ∈ Auditoria.esquinas b -> (i, p) ∈ Malla.numbered (Malla.puntos r) -> level <= Auditoria.along d p) ->
  (m, n) ∉ Auditoria.cruzadas r.
Proof. exact (Auditoria.faces_that_a_plane_parts_do_not_cross r m n a b d level). Qed.

(** Faces of which no edge is open, and no two walk an edge the same way, have a volume of their own: it is the same when all
    their points are moved, though it is told by determinants from the origin. *)
Theorem a_closed_mesh_has_one_volume o r m :
  VolumeOfMesh.abiertas r ≡ ∅ -> VolumeOfMesh.discordes r ≡ ∅ ->
  VolumeOfMesh.volumen r m -> VolumeOfMesh.volumen (VolumeOfMesh.moved o r) m.
Proof. exact (VolumeOfMesh.a_closed_mesh_has_one_volume o r m). Qed.

(** The pieces that the audit tells divide the faces: each face is in one, and no two share a face. *)
Theorem pieces_divide_the_faces r :
  (forall n, n ∈ Pieces.faces r -> exists s, s ∈ Pieces.piezas r /\ n ∈ s)
  /\ (forall s t n, s ∈ Pieces.piezas r -> t ∈ Pieces.piezas r -> n ∈ s -> n ∈ t -> s ≡ t).
Proof. exact (Pieces.pieces_divide_the_faces r). Qed.

(** A point is singular exactly where its faces are no fan, in which each is reached from each by steps between faces that share
    another point too. *)
Theorem a_point_without_a_fan_is_singular r v : v ∈ Pieces.singulares r <-> ~ Pieces.fan r v.
Proof. exact (Pieces.a_point_without_a_fan_is_singular r v). Qed.

(** A mesh of which no edge is open or multiple bounds something. *)
Theorem what_has_neither_open_nor_multiple_edges_bounds r :
  r ∈ Malla.Malla -> VolumeOfMesh.abiertas r ≡ ∅ -> Pieces.multiples r ≡ ∅ -> Pieces.pares r.
Proof. exact (Pieces.what_has_neither_open_nor_multiple_edges_bounds r). Qed.

(** In a mesh a face that stands twice shares all its edges with the one before it. *)
Theorem a_face_that_stands_twice_shares_its_edges r n : r ∈ Malla.Malla -> n ∈ Pieces.repetidas r ->
  exists m, (m < n)%nat /\ forall i j, n ∈ VolumeOfMesh.de_arista r i j <-> m ∈ VolumeOfMesh.de_arista r i j.
Proof. exact (Pieces.a_face_that_stands_twice_shares_its_edges r n). Qed.

(** Faces of points are a mesh exactly where none of them is degenerate. *)
Theorem a_mesh_has_no_degenerate_face r : r ∈ Malla.Completa -> (r ∈ Malla.Malla <-> Pieces.degeneradas r ≡ ∅).
Proof. exact (Pieces.a_mesh_has_no_degenerate_face r). Qed.

(** A point between the ends of an edge, at which faces meet without a vertex in common, lies on a face that has the edge. *)
Theorem a_junction_lies_on_a_face_of_its_edge r v i j : (v, i, j) ∈ Pieces.uniones_en_t r ->
  exists n c w, n ∈ VolumeOfMesh.de_arista r i j /\ Pieces.face r n c /\ (v, w) ∈ Malla.numbered (Malla.puntos r)
  /\ w ∈ Auditoria.envolvente r (Auditoria.esquinas c) /\ w ∈ Pieces.piel r.
Proof. exact (Pieces.a_junction_lies_on_a_face_of_its_edge r v i j). Qed.

(** A convex mesh, of which no face stands twice, encloses each point within: each face lies in a plane that has all other points
    of the mesh on one side, and the point on that side. *)
Theorem a_convex_mesh_encloses_what_lies_within r w : Pieces.pares r -> Pieces.repetidas r ≡ ∅ -> (exists n, n ∈ Pieces.faces r) ->
  (forall n, n ∈ Pieces.faces r -> exists d level, Enclosed.bears r n d level /\ Auditoria.along d w < level) ->
  w ∈ Enclosed.encerrados r.
Proof. exact (Enclosed.a_convex_mesh_encloses_what_lies_within r w). Qed.

(** * Copies and solids *)

(** Of affine maps: the point that is put at a point is found by Cramer's rule, and a copy has the points whose originals are
    in the set. Every ray is the copy of one; the parameter is kept, and so is what is nearest along a ray. The copy of a
    union, of a copy and by the identity. Spheres, upright cylinders and upright cones are copies of those of one. What a ray
    meets of an instance is what the moved ray meets of the original, whether it starts on it or not. *)
Theorem the_conjectures_of_instances_hold (Elemento : Type) :
  visto_conj_1 /\ copia_conj_1 /\ movido_conj_1 /\ movido_conj_2 /\ copia_conj_2 /\ copia_conj_3 /\ compuesto_conj_1
  /\ compuesto_conj_2 /\ identidad_conj_1 /\ estirado_conj_1 /\ estirado_conj_2 /\ estirado_conj_3
  /\ instancia_desde_conj_1 Elemento.
Proof. exact (Instancias.the_conjectures_hold Elemento). Qed.

(** Of solids: unions, intersections and differences are those of sets; a solid and the rest of space have one surface; the
    surface of a solid sphere, plane or cylinder is that, with two lids; body and surface are closed. A ray meets the surface
    first in a point, or runs along it from its origin on. *)
Theorem the_conjectures_of_solids_hold :
  cuerpo_conj_1 /\ interior_conj_1 /\ superficie_conj_1 /\ interior_conj_2 /\ cuerpo_conj_2 /\ interior_conj_3
  /\ solido_esfera_conj_1 /\ solido_plano_conj_1 /\ solido_cilindro_conj_1 /\ superficie_conj_2
  /\ superficie_desde_conj_1 /\ superficie_desde_conj_2.
Proof. exact Solidos.the_conjectures_hold. Qed.

(** The test of a triangle in binary32 by which most answers on meshes are given: where it says miss no point of the line lies
    in the triangle, where it says hit one does, and the parameter of the point lies between its bounds. *)
Theorem the_screen_of_triangles_is_right ray abc s (is_turned : bool) :
  Screen.in_range ray abc -> Screen.computed ray abc s -> 0 < Tipos.sq (Puntos.normal abc) ->
  (if is_turned then Screen.det_fl s <= 0 else 0 <= Screen.det_fl s) ->
  (Screen.margin s is_turned < - Screen.error s -> forall t, ~ point_at ray t ∈ puntos_triangulo abc)
  /\ (Screen.error s < Screen.margin s is_turned -> exists t, forall t', point_at ray t' ∈ puntos_triangulo abc <-> t' = t)
  /\ (forall t t_error t', Screen.placed s is_turned t t_error -> Screen.known s ->
      potencia_triangulo (point_at ray t') abc = 0 -> Screen.bounds t t_error t').
Proof. exact (Screen.the_screen_is_right ray abc s is_turned). Qed.
