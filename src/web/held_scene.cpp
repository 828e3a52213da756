#include "held_scene.hpp"

#include <optional>

#include "durero/composed/engine.hpp"
#include "durero/engine/prepared.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/written/engine.hpp"
#include "held.hpp"

namespace durero::web {
namespace {

constexpr std::size_t most_scenes = 8;

}  // namespace

HeldScene::HeldScene(const io::Source& source, const io::Source* with) {
  if (with == nullptr) {
    grouped_ = io::read_grouped_scene(source, io::Bodies::read);
    return;
  }
  written::Written read = written::read(source, written::Text(*with));
  grouped_.scene = std::move(read.scene);
  engine_ = std::move(read.engine);
}

const engine::Engine& HeldScene::engine() const {
  if (!engine_) engine_ = composed::prepared(*engine::find(engine::default_engine), engine::automatic, grouped_);
  return *engine_;
}

std::shared_ptr<const HeldScene> scene_of(const AskedCall& asked) {
  thread_local Held<HeldScene> held(most_scenes);
  const io::Source source = asked.part("scene");
  std::optional<io::Source> with;
  if (asked.has("with")) with = asked.part("with");
  std::string key = std::string(source.text());
  if (with) key.append(1, '\0').append(with->text());
  return held.of(key, [&] { return std::make_shared<const HeldScene>(source, with ? &*with : nullptr); });
}

std::string name_of(const scene::Scene& scene, scene::ElementRef element) { return scene.name(element).name(); }

}  // namespace durero::web
