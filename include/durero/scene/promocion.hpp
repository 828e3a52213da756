#pragma once
/// spec/promocion.tex: a scene as one function from names to shapes, and its operations lifted from one shape. The free
/// type of the text is AnyShape, and each of its alternatives has the attributes of its type and no others:
/// Esfera.def.1, Cilindro.def.1, Cono.def.1, Tronco.def.1, Plano.def.1, Disco.def.1, Triangulo.def.1.

#include <map>
#include <optional>

#include "durero/model/escena.hpp"
#include "durero/model/operation.hpp"
#include "durero/scene/any_shape.hpp"
#include "durero/scene/scene.hpp"

namespace durero::scene {

/// Formas.def.1. Formas() is Init_Formas.def.1. Each shape is valid, which Scene has checked, or apply_lifted.
struct Formas {
  std::map<model::Elemento, AnyShape> forma;  ///< the component of that name in the text
};

/// The shapes of the elements by themselves, without meshes: Retrato.inv.1. O(n log n).
Formas formas(const Scene& scene);

/// The scene that these shapes say: Recobro.inv.1, Recobro.inv.2, Recobro.inv.3, Recobro.inv.4, Recobro.inv.5,
/// Recobro.inv.6, Recobro.inv.7. O(n log n).
model::Escena retrieve(const Formas& formas);

/// The operation, said of one shape and lifted by a frame, and its answer; nothing, and no change, where it cannot
/// happen. It looks at no t?, since the name of an addition says the type. A general operation is that of the type.
/// Precondition: a general addition has the attributes of its type. O(log n).
std::optional<model::Respuesta> apply_lifted(Formas& formas, const model::Operation& operation);

}  // namespace durero::scene
