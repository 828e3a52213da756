#pragma once
/// A body is what an element is that no table holds: its points are made of those of shapes. In the tables it stands as
/// a sphere, which says nothing of where it is; Scene::body() tells.

#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "durero/model/instancias.hpp"
#include "durero/scene/any_shape.hpp"

namespace durero::scene {

/// The copy that an affine map makes of a shape (puntos_de_instancia). Invariant: inv(map).
struct Instance {
  AnyShape shape;    ///< the original, by value: what becomes of it later changes nothing here
  model::Mapa mapa;  ///< where its points are put
};

struct Body;

/// Solids that are joined (spec/solidos.tex). Its parts are bodies that bound a solid, one or more.
struct Compound {
  /// How the parts are joined.
  enum class Operation : std::uint8_t {
    united,       ///< what is in any
    intersected,  ///< what is in all
    subtracted    ///< what is in the first and in none of the others
  };
  Operation operation;      ///< of all parts
  std::vector<Body> parts;  ///< in their order
};

/// The geometry of an element that is none of Shapes. Its set of points is closed.
struct Body {
  std::variant<Instance, Compound> form;  ///< the kind of body, with its parts
};

/// Whether a body bounds a solid: it is one, or a copy of a sphere, a cylinder, a cone, a truncated cone or a plane.
bool bounds_a_solid(const Body& body);

/// The copy that a map makes of a body, which is one of the same kind.
Body copied(const model::Mapa& by, const Body& body);

/// The word of a kind of body in files.
std::string_view word_of(const Body& body);

/// What gives a body its name and its place in the tables.
inline constexpr Sphere stand_in{{}, 1};

}  // namespace durero::scene
