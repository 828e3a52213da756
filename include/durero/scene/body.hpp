#pragma once
/// A body is what an element is that no table holds: its points are made of those of shapes. In the tables it stands as
/// a sphere, which says nothing of where it is; Scene::body() tells.

#include <string_view>
#include <variant>

#include "durero/model/instancias.hpp"
#include "durero/scene/any_shape.hpp"

namespace durero::scene {

/// The copy that an affine map makes of a shape (puntos_de_instancia). Invariant: inv(map).
struct Instance {
  AnyShape shape;    ///< the original, by value: what becomes of it later changes nothing here
  model::Mapa mapa;  ///< where its points are put
};

/// The geometry of an element that is none of Shapes. Its set of points is closed.
struct Body {
  std::variant<Instance> form;  ///< the kind of body, with its parts
};

/// The copy that a map makes of a body, which is one of the same kind.
Body copied(const model::Mapa& by, const Body& body);

/// The word of a kind of body in files.
std::string_view word_of(const Body& body);

/// What gives a body its name and its place in the tables.
inline constexpr Sphere stand_in{{}, 1};

}  // namespace durero::scene
