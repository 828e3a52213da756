#pragma once
/// A scene file and what answers rays on it, as the options --engine, --hierarchy and --with say.

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "durero/engine/engine.hpp"
#include "durero/io/source.hpp"
#include "durero/scene/grouped_scene.hpp"
#include "durero/scene/stage.hpp"
#include "durero/written/engine.hpp"

namespace durero::cli {

/// The treatment of the pictures that a scene names.
enum class Pictures : bool {
  left,  ///< nothing: no ray needs them
  read   ///< they are read, for colours
};

/// A scene, and the engine that answers rays on it: one of the table, or a Z text's.
class SceneTracer {
 public:
  /// Reads the scene of that file and makes the engine ready for it, or the Z text `with`, where one is named. The
  /// resolution is the scene's where one is given: engines know pixels by it.
  SceneTracer(const std::string& file, std::string_view engine, std::string_view hierarchy, const std::string& with,
              std::optional<scene::Resolution> resolution = {}, Pictures pictures = Pictures::left);

  /// The same of the text of a scene file.
  SceneTracer(const io::Source& source, std::string_view engine, std::string_view hierarchy, const std::string& with,
              std::optional<scene::Resolution> resolution = {}, Pictures pictures = Pictures::left);

  /// The scene, which the engine is ready for.
  const scene::Scene& scene() const { return written_ ? written_->scene : input_->scene; }
  /// The engine that answers.
  const engine::Engine& engine() const { return written_ ? *written_->engine : *ready_; }
  /// Whether a Z text answers.
  bool is_by_text() const noexcept { return written_.has_value(); }
  /// Prepares the same engine for the scene at another time. Throws std::domain_error of a Z text's elements.
  std::unique_ptr<const engine::Engine> prepare(const scene::Scene& then) const;
  /// Checks that the engine honours origins. Throws std::invalid_argument, where `why` gives the reason that it must.
  void require_origins(std::string_view why) const;
  /// Checks that every element is one of the tables. Throws std::domain_error, where `who` asks for no other.
  void require_tables(std::string_view who) const;

 private:
  std::string file_;
  std::unique_ptr<const scene::GroupedScene> input_{};
  const engine::EngineRow* row_ = nullptr;
  std::unique_ptr<const engine::Engine> ready_{};
  std::optional<written::Written> written_{};
};

}  // namespace durero::cli
