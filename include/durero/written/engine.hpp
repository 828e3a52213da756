#pragma once
/// The engine of a Z text answers rays: each element is the set that its `puntos_…` defines.

#include <memory>
#include <span>

#include "durero/engine/engine.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/source.hpp"
#include "durero/written/text.hpp"

namespace durero::written {

/// A scene whose elements are defined by a Z text, also those with shapes of the program, and the engine that answers
/// rays on it.
struct Written {
  scene::Scene scene;                            ///< read by io::read_scene(source, types, elements)
  io::WrittenByName elements;                    ///< the elements that are of types of the text
  std::unique_ptr<const engine::Engine> engine;  ///< exact, and honours origins; it does not refer to the scene
};

/// The engine for a scene by the text, where the program has shapes for all its elements; it does not refer to the
/// scene. Throws NotInDomain, and io::InputError at an error in the text.
std::unique_ptr<const engine::Engine> prepared(const scene::Scene& scene, const Text& text);
/// The engine for a scene where these elements are of types that the text declares. Throws as the other does.
std::unique_ptr<const engine::Engine> prepared(const scene::Scene& scene, const io::WrittenByName& elements,
                                               const Text& text);

/// The points of an element that the program has a shape for, by the text. Throws as prepared(scene, text) does.
Surface surface_of(const Text& text, const scene::Scene& scene, scene::ElementRef element);
/// The points of an element of a type of the text. Throws as Text::surface does.
Surface surface_of(const Text& text, const io::WrittenElement& element);

/// The answer to bodies in a scene by the text: they are read where the program's formulas have all other elements.
io::Bodies bodies_beside(const Text& text);

/// Reads a scene by the text. Throws io::InputError at the first thing that is wrong, in the scene or in the text.
Written read(const io::Source& source, const Text& text);
/// A scene that is read with that answer to bodies. Precondition: none are read where the text declares shapes.
Written read(const io::Source& source, const Text& text, io::Bodies bodies);

}  // namespace durero::written
