// durero check SCENE: reads a scene, and evaluates every invariant of Escena on what it stands for.
#include <fmt/format.h>

#include "commands.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/scene_file.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/text/shown.hpp"

namespace durero::cli {
namespace {

std::string count_of_each_shape(const scene::Scene& scene) {
  std::string counts;
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", scene.shapes<Shape>().size(), Shape::word);
  });
  return counts;
}

int check(const std::string& path) {
  const io::Source source = io::read_source(path);
  const scene::Scene scene = io::read_scene(source);
  std::string report =
      fmt::format("{}: {} elementos: {}\n", text::escaped(source.name()), scene.size(), count_of_each_shape(scene));
  const model::Judgements judgements = model::inv(scene::retrieve(scene));
  for (const model::Judgement& judgement : judgements) {
    report +=
        fmt::format("{} {}: {}\n", judgement.what->label, judgement.holds ? "ok" : "fails", judgement.what->predicate);
  }
  io::write_file("-", report);
  return model::all_hold(judgements) ? 0 : 1;
}

}  // namespace

void add_check(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("check", "Read a scene and evaluate every invariant");
  const auto path = std::make_shared<std::string>();
  command->add_option("SCENE", *path, "Scene file (JSON); - is the standard input")->required();
  command->callback([path, &status] { status = check(*path); });
}

}  // namespace durero::cli
