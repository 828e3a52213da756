#include "scene_tracer.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "by_text.hpp"
#include "durero/composed/engine.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/pictures/picture_file.hpp"
#include "durero/io/rays/rays_file.hpp"
#include "durero/io/source.hpp"
#include "durero/scene/stage.hpp"
#include "engines.hpp"

namespace durero::cli {

SceneTracer::SceneTracer(const std::string& file, std::string_view engine, std::string_view hierarchy,
                         const std::string& with, std::optional<scene::Resolution> resolution, Pictures pictures)
    : SceneTracer(io::read_source(file), engine, hierarchy, with, resolution, pictures) {}

SceneTracer::SceneTracer(const io::Source& source, std::string_view engine, std::string_view hierarchy,
                         const std::string& with, std::optional<scene::Resolution> resolution, Pictures pictures)
    : file_(source.name()) {
  if (io::begins_as_rays(source))
    source.fail(0, "rays stand here", "expected a scene (JSON), which is named before the rays");
  const auto read_pictures = [&](scene::Scene& scene) {
    if (pictures == Pictures::read) io::read_pictures(source, scene.stage());
  };
  if (!with.empty()) {
    written_ = read_by_text(source, with);
    read_pictures(written_->scene);
    if (resolution) written_->scene.stage().resolution = resolution;
    return;
  }
  auto input = std::make_unique<scene::GroupedScene>(io::read_grouped_scene(source, io::Bodies::read));
  read_pictures(input->scene);
  if (resolution) input->scene.stage().resolution = resolution;
  row_ = engine::find(engine);
  ready_ = composed::prepared(*row_, hierarchy, *input);
  input_ = std::move(input);
}

std::unique_ptr<const engine::Engine> SceneTracer::prepare(const scene::Scene& then) const {
  if (row_ == nullptr) throw std::domain_error("an element moves beside those of a Z text; expected none with motion");
  return composed::prepared(*row_, then);
}

void SceneTracer::require_origins(std::string_view why) const {
  if (row_ != nullptr && !row_->honours_origins) throw std::invalid_argument(without_origins(*row_, why));
}

void SceneTracer::require_tables(std::string_view who) const {
  if (scene().has_bodies())
    throw std::domain_error(
        fmt::format("{}: an element is made of others, as an instance is; expected none with {}", file_, who));
}

}  // namespace durero::cli
