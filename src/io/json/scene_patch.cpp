#include "durero/io/json/scene_patch.hpp"

#include <fmt/format.h>

#include <array>

#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/json_pointer.hpp"
#include "json_difference.hpp"
#include "json_patch.hpp"

namespace durero::io {
namespace {

json::JsonValue value_of_scene(const scene::GroupedScene& of) {
  return json::read_whole(Source("a scene", scene_text(of.scene, of.groups)));
}

/// Fails at the beginning of the patch with an error of what it has made.
[[noreturn]] void fail_of_result(const Source& patch, const Source& made, const InputError& error) {
  const std::array offsets{error.offset()};
  const std::string pointer = json::pointers(json::Document(made), offsets).front();
  constexpr std::string_view between = "; ";
  const std::string_view message = error.message();
  const std::size_t end = message.rfind("; expected ");
  const std::string wrong =
      fmt::format("the scene is then wrong at {}: {}", pointer.empty() ? "the whole" : pointer, message.substr(0, end));
  patch.fail(0, wrong, std::string(message.substr(end + between.size())), error.broken());
}

}  // namespace

std::string scene_patch(const scene::GroupedScene& from, const scene::GroupedScene& to) {
  return json::patch_between(value_of_scene(from), value_of_scene(to));
}

scene::GroupedScene patched_scene(const scene::GroupedScene& scene, const Source& patch) {
  json::JsonValue value = value_of_scene(scene);
  json::apply_patch(patch, value);
  std::string text;
  json::append_value(text, value);
  const Source made("the patched scene", std::move(text));
  try {
    return read_grouped_scene(made, Bodies::read);
  } catch (const InputError& error) {
    fail_of_result(patch, made, error);
  }
}

}  // namespace durero::io
