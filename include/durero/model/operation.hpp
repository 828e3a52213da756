#pragma once
/// The operations of spec/operaciones.tex by their names alone, and what a total one answers: for whoever hands them on
/// and looks into none. What each is, stands in model/operaciones.hpp; whoever makes one or looks into one includes
/// that.

#include <variant>

#include "durero/model/tipos.hpp"

namespace durero::model {

struct Escena;
struct Vista;

/// @{ The additions, a type each, and the general one.
struct Agregar_Esfera;
struct Agregar_Cilindro;
struct Agregar_Cono;
struct Agregar_Tronco;
struct Agregar_Plano;
struct Agregar_Disco;
struct Agregar_Triangulo;
struct Agregar_Elemento;
/// @}

/// @{ The removals, a type each, and the general one.
struct Eliminar_Esfera;
struct Eliminar_Cilindro;
struct Eliminar_Cono;
struct Eliminar_Tronco;
struct Eliminar_Plano;
struct Eliminar_Disco;
struct Eliminar_Triangulo;
struct Eliminar_Elemento;
/// @}

/// Any operation: the additions and the removals, each in the order of Tipo with the general one last. Where a type
/// has no line here, model/operaciones.hpp does not compile.
using Operation =
    std::variant<Agregar_Esfera, Agregar_Cilindro, Agregar_Cono, Agregar_Tronco, Agregar_Plano, Agregar_Disco,
                 Agregar_Triangulo, Agregar_Elemento, Eliminar_Esfera, Eliminar_Cilindro, Eliminar_Cono,
                 Eliminar_Tronco, Eliminar_Plano, Eliminar_Disco, Eliminar_Triangulo, Eliminar_Elemento>;

/// @{ The changes of an attribute, an attribute each (spec/historia.tex). What each is, stands in model/cambio.hpp.
struct Cambiar_Centro;
struct Cambiar_Radio;
struct Cambiar_Vector;
struct Cambiar_Altura;
struct Cambiar_Proporcion;
struct Cambiar_Vertices;
/// @}
/// Any of them, in the order of the attributes.
using AttributeChange =
    std::variant<Cambiar_Centro, Cambiar_Radio, Cambiar_Vector, Cambiar_Altura, Cambiar_Proporcion, Cambiar_Vertices>;

/// @{ The changes of the looks of an element. What each is, stands in model/vista.hpp.
struct Cambiar_Material;
struct Quitar_Material;
struct Cambiar_Grupo;
struct Quitar_Grupo;
/// @}
/// Any of them.
using LookChange = std::variant<Cambiar_Material, Quitar_Material, Cambiar_Grupo, Quitar_Grupo>;

/// What a total operation answers: r!, and where it is an error, the precondition of the partial operation that
/// does not hold.
struct Answer {
  Respuesta r;                                 ///< r!
  const contract::clause* violated = nullptr;  ///< null where the operation is done
  /// Whether the operation is done.
  bool ok() const noexcept { return violated == nullptr; }
  bool operator==(const Answer&) const = default;
};

}  // namespace durero::model
