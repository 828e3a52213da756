#pragma once
/// The predicates of spec/malla.tex about each operation on meshes and each error, over the states of the model.

#include "durero/model/malla.hpp"

namespace durero::model {

inline constexpr clause Solo_Triangulos_post_1{"Solo_Triangulos.post.1", "mi_centro' = mi_centro"};
inline constexpr clause Solo_Triangulos_post_2{"Solo_Triangulos.post.2", "mi_radio' = mi_radio"};
inline constexpr clause Solo_Triangulos_post_3{"Solo_Triangulos.post.3", "mi_vector' = mi_vector"};
inline constexpr clause Solo_Triangulos_post_4{"Solo_Triangulos.post.4", "mi_altura' = mi_altura"};
inline constexpr clause Solo_Triangulos_post_5{"Solo_Triangulos.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Agregar_Malla_pre_1{"Agregar_Malla.pre.1", "m? ∉ dom mallas"};
inline constexpr clause Agregar_Malla_pre_2{"Agregar_Malla.pre.2", "red? ∈ Completa"};
inline constexpr clause Agregar_Malla_pre_3{"Agregar_Malla.pre.3", "red? ∈ Malla"};
inline constexpr clause Agregar_Malla_pre_4{"Agregar_Malla.pre.4", "(m?, red?) ∈ dom familia"};
inline constexpr clause Agregar_Malla_pre_5{"Agregar_Malla.pre.5", "dom (familia(m?, red?)) ∩ elementos = ∅"};
inline constexpr clause Agregar_Malla_post_1{"Agregar_Malla.post.1",
                                             "elementos' = elementos ∪ dom (familia(m?, red?))"};
inline constexpr clause Agregar_Malla_post_2{
    "Agregar_Malla.post.2", "de_que_tipo' = de_que_tipo ∪ (dom (familia(m?, red?)) × { soy_triangulo })"};
inline constexpr clause Agregar_Malla_post_3{"Agregar_Malla.post.3", "mi_vertices' = mi_vertices ∪ familia(m?, red?)"};
inline constexpr clause Agregar_Malla_post_4{"Agregar_Malla.post.4", "mallas' = mallas ∪ { m? ↦ red? }"};
inline constexpr clause Agregar_Malla_post_5{"Agregar_Malla.post.5", "r! = malla_agregada"};
inline constexpr clause Eliminar_Malla_pre_1{"Eliminar_Malla.pre.1", "m? ∈ dom mallas"};
inline constexpr clause Eliminar_Malla_post_1{"Eliminar_Malla.post.1", "elementos' = elementos ∖ suyos(θMallas, m?)"};
inline constexpr clause Eliminar_Malla_post_2{"Eliminar_Malla.post.2",
                                              "de_que_tipo' = suyos(θMallas, m?) ⩤ de_que_tipo"};
inline constexpr clause Eliminar_Malla_post_3{"Eliminar_Malla.post.3",
                                              "mi_vertices' = suyos(θMallas, m?) ⩤ mi_vertices"};
inline constexpr clause Eliminar_Malla_post_4{"Eliminar_Malla.post.4", "mallas' = { m? } ⩤ mallas"};
inline constexpr clause Eliminar_Malla_post_5{"Eliminar_Malla.post.5", "r! = malla_eliminada"};
inline constexpr clause Reemplazar_Malla_pre_1{"Reemplazar_Malla.pre.1", "m? ∈ dom mallas"};
inline constexpr clause Reemplazar_Malla_pre_2{"Reemplazar_Malla.pre.2", "red? ∈ Completa"};
inline constexpr clause Reemplazar_Malla_pre_3{"Reemplazar_Malla.pre.3", "red? ∈ Malla"};
inline constexpr clause Reemplazar_Malla_pre_4{"Reemplazar_Malla.pre.4", "(m?, red?) ∈ dom familia"};
inline constexpr clause Reemplazar_Malla_pre_5{"Reemplazar_Malla.pre.5",
                                               "dom (familia(m?, red?)) ∩ (elementos ∖ suyos(θMallas, m?)) = ∅"};
inline constexpr clause Reemplazar_Malla_post_1{
    "Reemplazar_Malla.post.1", "elementos' = (elementos ∖ suyos(θMallas, m?)) ∪ dom (familia(m?, red?))"};
inline constexpr clause Reemplazar_Malla_post_2{
    "Reemplazar_Malla.post.2",
    "de_que_tipo' = (suyos(θMallas, m?) ⩤ de_que_tipo) ∪ (dom (familia(m?, red?)) × { soy_triangulo })"};
inline constexpr clause Reemplazar_Malla_post_3{
    "Reemplazar_Malla.post.3", "mi_vertices' = (suyos(θMallas, m?) ⩤ mi_vertices) ∪ familia(m?, red?)"};
inline constexpr clause Reemplazar_Malla_post_4{"Reemplazar_Malla.post.4", "mallas' = mallas ⊕ { m? ↦ red? }"};
inline constexpr clause Reemplazar_Malla_post_5{"Reemplazar_Malla.post.5", "r! = malla_reemplazada"};
inline constexpr clause Mover_Vertice_pre_1{"Mover_Vertice.pre.1", "m? ∈ dom mallas"};
inline constexpr clause Mover_Vertice_pre_2{"Mover_Vertice.pre.2", "n? ∈ dom (mallas(m?)).puntos"};
inline constexpr clause Mover_Vertice_pre_3{"Mover_Vertice.pre.3", "movida(mallas(m?), n?, punto?) ∈ Malla"};
inline constexpr clause Mover_Vertice_post_1{"Mover_Vertice.post.1", "elementos' = elementos"};
inline constexpr clause Mover_Vertice_post_2{"Mover_Vertice.post.2", "de_que_tipo' = de_que_tipo"};
inline constexpr clause Mover_Vertice_post_3{
    "Mover_Vertice.post.3", "mi_vertices' = mi_vertices ⊕ familia(m?, movida(mallas(m?), n?, punto?))"};
inline constexpr clause Mover_Vertice_post_4{"Mover_Vertice.post.4",
                                             "mallas' = mallas ⊕ { m? ↦ movida(mallas(m?), n?, punto?) }"};
inline constexpr clause Mover_Vertice_post_5{"Mover_Vertice.post.5", "r! = vertice_movido"};
inline constexpr clause Malla_Ya_Existe_pre_1{"Malla_Ya_Existe.pre.1", "m? ∈ dom mallas"};
inline constexpr clause Malla_Ya_Existe_post_1{"Malla_Ya_Existe.post.1", "r! = malla_ya_existe"};
inline constexpr clause Malla_No_Existe_pre_1{"Malla_No_Existe.pre.1", "m? ∉ dom mallas"};
inline constexpr clause Malla_No_Existe_post_1{"Malla_No_Existe.post.1", "r! = malla_no_existe"};
inline constexpr clause Cara_Incompleta_pre_1{"Cara_Incompleta.pre.1", "red? ∉ Completa"};
inline constexpr clause Cara_Incompleta_post_1{"Cara_Incompleta.post.1", "r! = cara_incompleta"};
inline constexpr clause Caras_Alineadas_pre_1{"Caras_Alineadas.pre.1", "red? ∈ Completa"};
inline constexpr clause Caras_Alineadas_pre_2{"Caras_Alineadas.pre.2", "red? ∉ Malla"};
inline constexpr clause Caras_Alineadas_post_1{"Caras_Alineadas.post.1", "r! = vertices_alineados"};
inline constexpr clause Cara_Sin_Nombre_pre_1{"Cara_Sin_Nombre.pre.1", "red? ∈ Malla"};
inline constexpr clause Cara_Sin_Nombre_pre_2{"Cara_Sin_Nombre.pre.2", "(m?, red?) ∉ dom familia"};
inline constexpr clause Cara_Sin_Nombre_post_1{"Cara_Sin_Nombre.post.1", "r! = cara_sin_nombre"};
inline constexpr clause Cara_Ya_Existe_pre_1{"Cara_Ya_Existe.pre.1", "(m?, red?) ∈ dom familia"};
inline constexpr clause Cara_Ya_Existe_pre_2{"Cara_Ya_Existe.pre.2",
                                             "dom (familia(m?, red?)) ∩ (elementos ∖ suyos(θMallas, m?)) ≠ ∅"};
inline constexpr clause Cara_Ya_Existe_post_1{"Cara_Ya_Existe.post.1", "r! = elemento_ya_existe"};
inline constexpr clause Vertice_No_Existe_pre_1{"Vertice_No_Existe.pre.1", "m? ∈ dom mallas"};
inline constexpr clause Vertice_No_Existe_pre_2{"Vertice_No_Existe.pre.2", "n? ∉ dom (mallas(m?)).puntos"};
inline constexpr clause Vertice_No_Existe_post_1{"Vertice_No_Existe.post.1", "r! = vertice_no_existe"};
inline constexpr clause Vertice_Alineado_pre_1{"Vertice_Alineado.pre.1", "m? ∈ dom mallas"};
inline constexpr clause Vertice_Alineado_pre_2{"Vertice_Alineado.pre.2", "n? ∈ dom (mallas(m?)).puntos"};
inline constexpr clause Vertice_Alineado_pre_3{"Vertice_Alineado.pre.3", "movida(mallas(m?), n?, punto?) ∉ Malla"};
inline constexpr clause Vertice_Alineado_post_1{"Vertice_Alineado.post.1", "r! = vertices_alineados"};
inline constexpr clause Mismas_Mallas_post_1{"Mismas_Mallas.post.1", "mallas' = mallas"};
inline constexpr clause Fuera_De_Malla_pre_1{"Fuera_De_Malla.pre.1", "e? ∉ de_malla(θMallas)"};
inline constexpr clause Es_De_Malla_pre_1{"Es_De_Malla.pre.1", "e? ∈ de_malla(θMallas)"};
inline constexpr clause Es_De_Malla_post_1{"Es_De_Malla.post.1", "r! = es_de_malla"};

// The errors, each with its answer; the state stays as it is (Ξ Mallas).

/// A mesh has the name already.
struct Malla_Ya_Existe {
  Elemento m;
  static constexpr Respuesta answer = Respuesta::malla_ya_existe;
};
/// No mesh has the name.
struct Malla_No_Existe {
  Elemento m;
  static constexpr Respuesta answer = Respuesta::malla_no_existe;
};
/// A face names a point that there is not.
struct Cara_Incompleta {
  Red red;
  static constexpr Respuesta answer = Respuesta::cara_incompleta;
};
/// A face has its points on one line.
struct Caras_Alineadas {
  Red red;
  static constexpr Respuesta answer = Respuesta::vertices_alineados;
};
/// A face has no name: it would be too long.
struct Cara_Sin_Nombre {
  Elemento m;
  Red red;
  static constexpr Respuesta answer = Respuesta::cara_sin_nombre;
};
/// A face has the name of an element that is none of the mesh's own.
struct Cara_Ya_Existe {
  Elemento m;
  Red red;
  static constexpr Respuesta answer = Respuesta::elemento_ya_existe;
};
/// The mesh has no vertex of that number.
struct Vertice_No_Existe {
  Elemento m;
  Ordinal n;
  static constexpr Respuesta answer = Respuesta::vertice_no_existe;
};
/// A face would have its points on one line.
struct Vertice_Alineado {
  Elemento m;
  Ordinal n;
  Punto punto;
  static constexpr Respuesta answer = Respuesta::vertices_alineados;
};
/// The element is a triangle of a mesh, and is not removed alone.
struct Es_De_Malla {
  Elemento e;
  static constexpr Respuesta answer = Respuesta::es_de_malla;
};
/// Any error.
using MeshError = std::variant<Malla_Ya_Existe, Malla_No_Existe, Cara_Incompleta, Caras_Alineadas, Cara_Sin_Nombre,
                               Cara_Ya_Existe, Vertice_No_Existe, Vertice_Alineado, Es_De_Malla>;

/// The judgements about an error that answers r, in the order of the text.
Judgements judgements(const Mallas& s, const MeshError& error, Respuesta r);

/// A precondition, judged, with the error by which the total operation denies it. What is undefined does not hold.
struct MeshPrecondition {
  Judgement judged;  ///< the clause, and whether it holds
  MeshError denial;  ///< the error that says that it does not
};

/// The preconditions over the before-state and the inputs, in the order of the text. O(n).
std::vector<MeshPrecondition> preconditions(const Mallas& before, const MeshOperation& operation);

/// The postconditions over both states, the inputs and r!, judged: the whole predicates. Precondition: the
/// preconditions hold of the before-state.
Judgements post(const Mallas& before, const MeshOperation& operation, const Mallas& after, Respuesta r);

}  // namespace durero::model
