// Surfaces that a Z text declares, as a grid of rays meets them, and scenes as shaders.
#include <array>
#include <optional>
#include <stdexcept>

#include "calls.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/stage.hpp"
#include "durero/shader/fragment.hpp"
#include "durero/text/shown.hpp"
#include "durero/written/text.hpp"
#include "held_scene.hpp"
#include "json_text.hpp"

namespace durero::web {
namespace {

constexpr std::array<std::string_view, 4> surface_keys{"with", "scene", "width", "height"};
constexpr std::array<std::string_view, 2> shader_keys{"scene", "writes"};
constexpr std::uint64_t most_side = 512;  // of a grid, whose answer is a text

std::string word_of_written(io::WrittenKind kind) {
  constexpr std::array<std::string_view, 3> words{"number", "triple", "three_points"};
  return std::string(words[static_cast<std::size_t>(kind)]);
}

std::string types_text(const written::Text& text) {
  return array_of(text.types(), [](const io::WrittenType& type) {
    const auto attribute = [](const io::WrittenAttribute& of) {
      return ObjectText().member("name", of.word).member("kind", word_of_written(of.kind)).text();
    };
    return ObjectText().member("tipo", type.word).raw("attributes", array_of(type.attributes, attribute)).text();
  });
}

/// The rays of the scene's camera, in a picture of that size or, without one, of the scene's own.
scene::PrimaryRays camera_rays(const AskedCall& asked, const scene::Scene& scene,
                               std::optional<scene::Resolution> resolution) {
  const scene::Stage& stage = scene.stage();
  if (!stage.camera)
    asked.source().fail(asked.at("scene").offset(), "the scene has no camera", "expected one, which rays start from");
  return {*stage.camera, resolution.value_or(stage.resolution.value_or(scene::default_resolution))};
}

std::string grid_hit(const HeldScene& held, const scene::Hit& hit) {
  if (hit.resultado != model::Resultado::hit) return "null";
  return ObjectText()
      .member("e", name_of(held.scene(), hit.elementos.front()))
      .member("t", hit.t)
      .member("p", hit.punto)
      .member("n", held.engine().normal(held.scene(), hit.elementos.front(), hit.punto))
      .text();
}

std::string grid_text(const AskedCall& asked, const HeldScene& held, scene::Resolution size) {
  const scene::PrimaryRays rays = camera_rays(asked, held.scene(), size);
  std::vector<scene::Query> queries;
  for (std::uint32_t y = 0; y < size.height; ++y)
    for (std::uint32_t x = 0; x < size.width; ++x) queries.push_back({rays.ray(x, y), {}});
  return array_of(engine::first_hits(held.engine(), queries),
                  [&](const scene::Hit& hit) { return grid_hit(held, hit); });
}

shader::ShaderOutput output_of(const AskedCall& asked) {
  const std::string writes = asked.text("writes", shader::shader_outputs[0]);
  for (std::size_t i = 0; i < shader::shader_outputs.size(); ++i)
    if (shader::shader_outputs[i] == writes) return static_cast<shader::ShaderOutput>(i);
  asked.source().fail(asked.at("writes").offset(), "no shader writes " + text::shown(writes),
                      "expected color, answer or doubts");
}

template <std::size_t Size>
std::string floats(const std::array<float, Size>& values) {
  return array_of(values, [](float value) { return json_of(static_cast<double>(value)); });
}

std::string uniforms(const shader::ShaderView& view) {
  return ObjectText()
      .raw("eye", floats(view.eye))
      .raw("forward", floats(view.forward))
      .raw("step_x", floats(view.step_x))
      .raw("step_y", floats(view.step_y))
      .raw("size", floats(view.size))
      .text();
}

}  // namespace

std::string answer_surface(const AskedCall& asked) {
  asked.require(surface_keys, 1);
  ObjectText answer;
  answer.raw("types", types_text(written::Text(asked.part("with"))));
  if (!asked.has("scene")) return answer.text();
  const auto held = scene_of(asked);
  const auto side = [&](std::string_view key) {
    return static_cast<std::uint32_t>(asked.whole(key, 1, most_side, 64));
  };
  const scene::Resolution size{side("width"), side("height")};
  return answer.member("width", std::uint64_t{size.width})
      .member("height", std::uint64_t{size.height})
      .raw("hits", grid_text(asked, *held, size))
      .text();
}

std::string answer_render_shader(const AskedCall& asked) {
  asked.require(shader_keys, 1);
  const auto held = scene_of(asked);
  const shader::ShaderOutput output = output_of(asked);
  std::string fragment;
  try {
    fragment = shader::fragment_shader(held->scene(), output);
  } catch (const std::domain_error& error) {
    throw io::InputError("scene", {1, 1}, error.what(), "expected a scene that a shader can hold");
  }
  ArrayText elements;
  held->scene().for_each([&](scene::ElementRef e, const auto&) { elements.raw(json_of(name_of(held->scene(), e))); });
  return ObjectText()
      .member("fragment", fragment)
      .member("vertex", shader::vertex_shader())
      .raw("elementos", elements.text())
      .raw("uniforms", uniforms(shader::ShaderView(camera_rays(asked, held->scene(), {}))))
      .text();
}

}  // namespace durero::web
