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

/// Adds the option; what it holds is then the name of an engine.
void add_engine(CLI::App& command, std::string& name);
/// The option --max-depth of a command that draws.
void add_max_depth(CLI::App& command, std::optional<std::uint32_t>& max_depth);

/// Adds the option --hierarchy; what it holds is then `automatic` or `hand`.
void add_hierarchy(CLI::App& command, std::string& hierarchy);

/// Adds the option --with, a Z text by which the scene is read and its rays are answered; behind those of the two above
/// that the command has, which it excludes.
void add_with(CLI::App& command, std::string& file);

/// What is done with the pictures that a scene names.
enum class Pictures : bool {
  left,  ///< nothing: no ray needs them
  read   ///< they are read, for colours
};

/// A scene, and what answers rays on it: an engine of the table, or a Z text.
class Asked {
 public:
  /// The scene, which the engine is ready for.
  const scene::Scene& scene() const { return written_ ? written_->scene : input_->scene; }
  /// What answers.
  const engine::Engine& engine() const { return written_ ? *written_->engine : *ready_; }
  /// Throws std::invalid_argument where the engine knows no origins; `why` it has to.
  void require_origins(std::string_view why) const;

 private:
  friend Asked asked_of(const std::string&, std::string_view, std::string_view, const std::string&,
                        std::optional<scene::Resolution>, Pictures);
  std::unique_ptr<const scene::GroupedScene> input_{};
  const engine::Row* row_ = nullptr;
  std::unique_ptr<const engine::Engine> ready_{};
  std::optional<written::Written> written_{};
};

/// Reads the scene of that file and makes the engine ready for it, or the Z text `with`, where one is named. The
/// resolution is the scene's where one is given: engines know pixels by it.
Asked asked_of(const std::string& file, std::string_view engine, std::string_view hierarchy, const std::string& with,
               std::optional<scene::Resolution> resolution = {}, Pictures pictures = Pictures::left);

/// What to say where an engine that knows no origins is asked for rays that have one.
std::string without_origins(const engine::Row& engine, std::string_view why);

}  // namespace durero::cli
