#pragma once
/// The options --engine, --hierarchy and --with of `durero trace`, `agree`, `render` and `stats`.

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "durero/engine/engine.hpp"
#include "durero/scene/grouped_scene.hpp"
#include "durero/written/engine.hpp"

namespace durero::cli {

/// Adds the option --engine; its value is the name of an engine.
void add_engine(CLI::App& command, std::string& name);
/// The option --max-depth of a command that draws.
void add_max_depth(CLI::App& command, std::optional<std::uint32_t>& max_depth);

/// Adds the option --hierarchy; its value is `automatic` or `hand`.
void add_hierarchy(CLI::App& command, std::string& hierarchy);

/// Adds the option --with, a Z text by which the scene is read and its rays are answered. It must be added after the
/// two above, which it excludes.
void add_with(CLI::App& command, std::string& file);

/// The treatment of the pictures that a scene names.
enum class Pictures : bool {
  left,  ///< nothing: no ray needs them
  read   ///< they are read, for colours
};

/// A scene, and the engine that answers rays on it: one of the table, or a Z text's.
class SceneTracer {
 public:
  /// The scene, which the engine is ready for.
  const scene::Scene& scene() const { return written_ ? written_->scene : input_->scene; }
  /// The engine that answers.
  const engine::Engine& engine() const { return written_ ? *written_->engine : *ready_; }
  /// Checks that the engine honours origins. Throws std::invalid_argument, where `why` gives the reason that it must.
  void require_origins(std::string_view why) const;

 private:
  friend SceneTracer asked_of(const std::string&, std::string_view, std::string_view, const std::string&,
                              std::optional<scene::Resolution>, Pictures);
  std::unique_ptr<const scene::GroupedScene> input_{};
  const engine::EngineRow* row_ = nullptr;
  std::unique_ptr<const engine::Engine> ready_{};
  std::optional<written::Written> written_{};
};

/// Reads the scene of that file and makes the engine ready for it, or the Z text `with`, where one is named. The
/// resolution is the scene's where one is given: engines know pixels by it.
SceneTracer asked_of(const std::string& file, std::string_view engine, std::string_view hierarchy,
                     const std::string& with, std::optional<scene::Resolution> resolution = {},
                     Pictures pictures = Pictures::left);

/// The message about an engine that honours no origins and is asked for rays that have one.
std::string without_origins(const engine::EngineRow& engine, std::string_view why);

}  // namespace durero::cli
