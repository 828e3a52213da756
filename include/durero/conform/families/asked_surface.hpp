#pragma once
/// A surface is an element of a type that a Z text declares. A user's scene may have some; no family has any, since no
/// system is told what a text says of them.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "durero/conform/families/asked_body.hpp"
#include "durero/written/text.hpp"

namespace durero::conform {

/// A surface by its numbers, and its points.
struct AskedSurface {
  std::shared_ptr<const written::Text> text;  ///< what the points of its type are
  std::string type;                           ///< one that the text declares
  std::vector<io::WrittenValue> values;       ///< its attributes, in the order of the type
  written::Surface points;                    ///< those that the text defines for these values
};

/// A surface of a scene, where it stands in the tables as a sphere that says nothing of it.
struct NamedSurface {
  scene::ElementRef element;  ///< its place in the scene
  AskedSurface surface;       ///< its numbers and points
};

/// The elements of a scene that are none of the model's shapes.
struct OtherElements {
  std::span<const NamedBody> bodies{};       ///< its bodies
  std::span<const NamedSurface> surfaces{};  ///< its surfaces of a text, ascending

  OtherElements() = default;  ///< none
  /// @{ Bodies alone, or both.
  OtherElements(std::span<const NamedBody> of_bodies, std::span<const NamedSurface> of_surfaces = {})
      : bodies(of_bodies), surfaces(of_surfaces) {}
  OtherElements(const std::vector<NamedBody>& of_bodies) : bodies(of_bodies) {}
  /// @}

  /// The body that the element is; null of another.
  const AskedBody* body(scene::ElementRef element) const { return find_body(bodies, element); }
  /// The surface that the element is; null of another.
  const AskedSurface* surface(scene::ElementRef element) const;
};

/// The surfaces of a scene that was read by a text, ascending. Throws written::NotInDomain where the text defines no
/// points for the numbers of one, and io::InputError where they are no algebraic surface.
std::vector<NamedSurface> surfaces_of(const scene::Scene& scene, const io::WrittenByName& elements,
                                      const std::shared_ptr<const written::Text>& text);

}  // namespace durero::conform
