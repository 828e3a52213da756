#pragma once
/// The scene of a call, read, with the engine that answers its rays.

#include <memory>
#include <string>

#include "asked.hpp"
#include "durero/engine/engine.hpp"
#include "durero/io/json/written_elements.hpp"
#include "durero/scene/grouped_scene.hpp"

namespace durero::web {

/// A scene, and the engine that answers rays on it.
class HeldScene {
 public:
  /// Reads the scene; `with` is a Z text that declares types of its elements, or null. Throws io::InputError.
  HeldScene(const io::Source& source, const io::Source* with);
  HeldScene(const HeldScene&) = delete;
  HeldScene& operator=(const HeldScene&) = delete;

  /// The elements, and the stage.
  const scene::Scene& scene() const noexcept { return grouped_.scene; }
  /// The engine that `durero trace` asks where it is told no other.
  const engine::Engine& engine() const;

 private:
  scene::GroupedScene grouped_{};
  mutable std::unique_ptr<const engine::Engine> engine_{};
};

/// The scene of a call: its key `scene`, with `with` where that is there. Throws io::InputError.
std::shared_ptr<const HeldScene> scene_of(const AskedCall& asked);

/// The name of an element of the scene.
std::string name_of(const scene::Scene& scene, scene::ElementRef element);

}  // namespace durero::web
