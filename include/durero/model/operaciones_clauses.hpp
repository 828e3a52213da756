#pragma once
/// The clauses of spec/operaciones.tex, in its order.

#include "durero/contract/contract.hpp"

namespace durero::model {

using contract::clause;

inline constexpr clause Agregar_Elemento_pre_1{"Agregar_Elemento.pre.1", "e? ∉ elementos"};
inline constexpr clause Agregar_Elemento_post_1{"Agregar_Elemento.post.1", "elementos' = elementos ∪ { e? }"};
inline constexpr clause Agregar_Elemento_post_2{"Agregar_Elemento.post.2", "de_que_tipo' = de_que_tipo ∪ { e? ↦ t? }"};

inline constexpr clause Eliminar_Elemento_pre_1{"Eliminar_Elemento.pre.1", "e? ∈ elementos"};
inline constexpr clause Eliminar_Elemento_post_1{"Eliminar_Elemento.post.1", "elementos' = elementos ∖ { e? }"};
inline constexpr clause Eliminar_Elemento_post_2{"Eliminar_Elemento.post.2", "de_que_tipo' = { e? } ⩤ de_que_tipo"};

inline constexpr clause Agregar_Esfera_pre_1{"Agregar_Esfera.pre.1", "t? = soy_esfera"};
inline constexpr clause Agregar_Esfera_pre_2{"Agregar_Esfera.pre.2", "radio? ∈ Rmas"};
inline constexpr clause Agregar_Esfera_post_1{"Agregar_Esfera.post.1", "mi_centro' = mi_centro ∪ { e? ↦ centro? }"};
inline constexpr clause Agregar_Esfera_post_2{"Agregar_Esfera.post.2", "mi_radio' = mi_radio ∪ { e? ↦ radio? }"};
inline constexpr clause Agregar_Esfera_post_3{"Agregar_Esfera.post.3", "mi_vector' = mi_vector"};
inline constexpr clause Agregar_Esfera_post_4{"Agregar_Esfera.post.4", "mi_altura' = mi_altura"};
inline constexpr clause Agregar_Esfera_post_5{"Agregar_Esfera.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Agregar_Esfera_post_6{"Agregar_Esfera.post.6", "r! = esfera_agregada"};

inline constexpr clause Agregar_Cilindro_pre_1{"Agregar_Cilindro.pre.1", "t? = soy_cilindro"};
inline constexpr clause Agregar_Cilindro_pre_2{"Agregar_Cilindro.pre.2", "radio? ∈ Rmas"};
inline constexpr clause Agregar_Cilindro_pre_3{"Agregar_Cilindro.pre.3", "vector? ∈ Unitario"};
inline constexpr clause Agregar_Cilindro_pre_4{"Agregar_Cilindro.pre.4", "altura? ∈ Rmas"};
inline constexpr clause Agregar_Cilindro_post_1{"Agregar_Cilindro.post.1", "mi_centro' = mi_centro ∪ { e? ↦ centro? }"};
inline constexpr clause Agregar_Cilindro_post_2{"Agregar_Cilindro.post.2", "mi_radio' = mi_radio ∪ { e? ↦ radio? }"};
inline constexpr clause Agregar_Cilindro_post_3{"Agregar_Cilindro.post.3", "mi_vector' = mi_vector ∪ { e? ↦ vector? }"};
inline constexpr clause Agregar_Cilindro_post_4{"Agregar_Cilindro.post.4", "mi_altura' = mi_altura ∪ { e? ↦ altura? }"};
inline constexpr clause Agregar_Cilindro_post_5{"Agregar_Cilindro.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Agregar_Cilindro_post_6{"Agregar_Cilindro.post.6", "r! = cilindro_agregado"};

inline constexpr clause Agregar_Cono_pre_1{"Agregar_Cono.pre.1", "t? = soy_cono"};
inline constexpr clause Agregar_Cono_pre_2{"Agregar_Cono.pre.2", "proporcion? ∈ Rmas"};
inline constexpr clause Agregar_Cono_pre_3{"Agregar_Cono.pre.3", "vector? ∈ Unitario"};
inline constexpr clause Agregar_Cono_pre_4{"Agregar_Cono.pre.4", "altura? ∈ Rmas"};
inline constexpr clause Agregar_Cono_post_1{"Agregar_Cono.post.1", "mi_centro' = mi_centro ∪ { e? ↦ centro? }"};
inline constexpr clause Agregar_Cono_post_2{"Agregar_Cono.post.2", "mi_radio' = mi_radio"};
inline constexpr clause Agregar_Cono_post_3{"Agregar_Cono.post.3", "mi_vector' = mi_vector ∪ { e? ↦ vector? }"};
inline constexpr clause Agregar_Cono_post_4{"Agregar_Cono.post.4", "mi_altura' = mi_altura ∪ { e? ↦ altura? }"};
inline constexpr clause Agregar_Cono_post_5{"Agregar_Cono.post.5",
                                            "mi_proporcion' = mi_proporcion ∪ { e? ↦ proporcion? }"};
inline constexpr clause Agregar_Cono_post_6{"Agregar_Cono.post.6", "r! = cono_agregado"};

inline constexpr clause Eliminar_Esfera_pre_1{"Eliminar_Esfera.pre.1", "de_que_tipo(e?) = soy_esfera"};
inline constexpr clause Eliminar_Esfera_post_1{"Eliminar_Esfera.post.1", "mi_centro' = { e? } ⩤ mi_centro"};
inline constexpr clause Eliminar_Esfera_post_2{"Eliminar_Esfera.post.2", "mi_radio' = { e? } ⩤ mi_radio"};
inline constexpr clause Eliminar_Esfera_post_3{"Eliminar_Esfera.post.3", "mi_vector' = mi_vector"};
inline constexpr clause Eliminar_Esfera_post_4{"Eliminar_Esfera.post.4", "mi_altura' = mi_altura"};
inline constexpr clause Eliminar_Esfera_post_5{"Eliminar_Esfera.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Eliminar_Esfera_post_6{"Eliminar_Esfera.post.6", "r! = esfera_eliminada"};

inline constexpr clause Eliminar_Cilindro_pre_1{"Eliminar_Cilindro.pre.1", "de_que_tipo(e?) = soy_cilindro"};
inline constexpr clause Eliminar_Cilindro_post_1{"Eliminar_Cilindro.post.1", "mi_centro' = { e? } ⩤ mi_centro"};
inline constexpr clause Eliminar_Cilindro_post_2{"Eliminar_Cilindro.post.2", "mi_radio' = { e? } ⩤ mi_radio"};
inline constexpr clause Eliminar_Cilindro_post_3{"Eliminar_Cilindro.post.3", "mi_vector' = { e? } ⩤ mi_vector"};
inline constexpr clause Eliminar_Cilindro_post_4{"Eliminar_Cilindro.post.4", "mi_altura' = { e? } ⩤ mi_altura"};
inline constexpr clause Eliminar_Cilindro_post_5{"Eliminar_Cilindro.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Eliminar_Cilindro_post_6{"Eliminar_Cilindro.post.6", "r! = cilindro_eliminado"};

inline constexpr clause Eliminar_Cono_pre_1{"Eliminar_Cono.pre.1", "de_que_tipo(e?) = soy_cono"};
inline constexpr clause Eliminar_Cono_post_1{"Eliminar_Cono.post.1", "mi_centro' = { e? } ⩤ mi_centro"};
inline constexpr clause Eliminar_Cono_post_2{"Eliminar_Cono.post.2", "mi_radio' = mi_radio"};
inline constexpr clause Eliminar_Cono_post_3{"Eliminar_Cono.post.3", "mi_vector' = { e? } ⩤ mi_vector"};
inline constexpr clause Eliminar_Cono_post_4{"Eliminar_Cono.post.4", "mi_altura' = { e? } ⩤ mi_altura"};
inline constexpr clause Eliminar_Cono_post_5{"Eliminar_Cono.post.5", "mi_proporcion' = { e? } ⩤ mi_proporcion"};
inline constexpr clause Eliminar_Cono_post_6{"Eliminar_Cono.post.6", "r! = cono_eliminado"};

inline constexpr clause Elemento_Agregado_post_1{"Elemento_Agregado.post.1", "r! = elemento_agregado"};

inline constexpr clause Elemento_Eliminado_post_1{"Elemento_Eliminado.post.1", "r! = elemento_eliminado"};

inline constexpr clause Elemento_Ya_Existe_pre_1{"Elemento_Ya_Existe.pre.1", "e? ∈ elementos"};
inline constexpr clause Elemento_Ya_Existe_post_1{"Elemento_Ya_Existe.post.1", "r! = elemento_ya_existe"};

inline constexpr clause Elemento_No_Existe_pre_1{"Elemento_No_Existe.pre.1", "e? ∉ elementos"};
inline constexpr clause Elemento_No_Existe_post_1{"Elemento_No_Existe.post.1", "r! = elemento_no_existe"};

inline constexpr clause Radio_No_Positivo_pre_1{"Radio_No_Positivo.pre.1", "radio? ∉ Rmas"};
inline constexpr clause Radio_No_Positivo_post_1{"Radio_No_Positivo.post.1", "r! = radio_no_positivo"};

inline constexpr clause Vector_No_Unitario_pre_1{"Vector_No_Unitario.pre.1", "vector? ∉ Unitario"};
inline constexpr clause Vector_No_Unitario_post_1{"Vector_No_Unitario.post.1", "r! = vector_no_unitario"};

inline constexpr clause Altura_No_Positiva_pre_1{"Altura_No_Positiva.pre.1", "altura? ∉ Rmas"};
inline constexpr clause Altura_No_Positiva_post_1{"Altura_No_Positiva.post.1", "r! = altura_no_positiva"};

inline constexpr clause Proporcion_No_Positiva_pre_1{"Proporcion_No_Positiva.pre.1", "proporcion? ∉ Rmas"};
inline constexpr clause Proporcion_No_Positiva_post_1{"Proporcion_No_Positiva.post.1", "r! = proporcion_no_positiva"};

inline constexpr clause No_Es_Esfera_pre_1{"No_Es_Esfera.pre.1", "e? ∈ elementos"};
inline constexpr clause No_Es_Esfera_pre_2{"No_Es_Esfera.pre.2", "de_que_tipo(e?) ≠ soy_esfera"};
inline constexpr clause No_Es_Esfera_post_1{"No_Es_Esfera.post.1", "r! = tipo_incorrecto"};

inline constexpr clause No_Es_Cilindro_pre_1{"No_Es_Cilindro.pre.1", "e? ∈ elementos"};
inline constexpr clause No_Es_Cilindro_pre_2{"No_Es_Cilindro.pre.2", "de_que_tipo(e?) ≠ soy_cilindro"};
inline constexpr clause No_Es_Cilindro_post_1{"No_Es_Cilindro.post.1", "r! = tipo_incorrecto"};

inline constexpr clause No_Es_Cono_pre_1{"No_Es_Cono.pre.1", "e? ∈ elementos"};
inline constexpr clause No_Es_Cono_pre_2{"No_Es_Cono.pre.2", "de_que_tipo(e?) ≠ soy_cono"};
inline constexpr clause No_Es_Cono_post_1{"No_Es_Cono.post.1", "r! = tipo_incorrecto"};

inline constexpr clause Es_Esfera_pre_1{"Es_Esfera.pre.1", "t? = soy_esfera"};

inline constexpr clause Es_Cono_pre_1{"Es_Cono.pre.1", "t? = soy_cono"};

}  // namespace durero::model
