// Scenes and their edits, in the lines of `durero check` and `durero edit`.
#include <array>
#include <memory>
#include <optional>

#include "calls.hpp"
#include "durero/contract/contract.hpp"
#include "durero/io/json/asked_parts.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/operations_file.hpp"
#include "durero/io/json/scene_check.hpp"
#include "durero/io/json/why_not.hpp"
#include "durero/written/edited.hpp"
#include "json_text.hpp"

namespace durero::web {
namespace {

constexpr std::array<std::string_view, 2> check_keys{"scene", "with"};
constexpr std::array<std::string_view, 5> edit_keys{"scene", "operations", "with", "audit", "scenes"};

io::SceneCheck checked_scene(const AskedCall& asked) {
  const io::Source scene = asked.part("scene");
  if (!asked.has("with")) return io::check_scene(scene);
  const written::Text text(asked.part("with"));
  return io::check_scene(scene, text.types(), written::bodies_beside(text), [&] { written::read(scene, text); });
}

std::string check_lines(const io::SceneCheck& check) {
  if (check.errors.empty()) return array_of_lines(io::check_text(check), true);
  return array_of(check.errors, [](const io::InputError& error) { return json_of(error.what()); });
}

std::unique_ptr<io::EditedScene> edited_scene(const AskedCall& asked) {
  const io::Source scene = asked.part("scene");
  if (!asked.has("with")) return std::make_unique<io::EditedScene>(io::read_grouped_scene(scene, io::Bodies::read));
  return std::make_unique<written::Edited>(scene, std::make_shared<const written::Text>(asked.part("with")));
}

/// The operations of a call as a script: a text, or an array of lines and objects.
io::Source script_of(const AskedCall& asked) {
  io::json::Reader in = asked.at("operations");
  const bool is_text = in.kind() == io::json::TokenKind::string;
  return {"operations", is_text ? std::string(in.string("operations")) : io::read_json_script(in, asked.source())};
}

/// The answers to the steps of a script.
struct StepAnswers {
  ArrayText answers{}, refusals{}, scenes{};
  bool all_done = true;
};

void carry_out(io::EditedScene& edited, const io::ScriptStep& step, bool each_scene, StepAnswers& given) {
  const io::EditAnswer answer = edited.apply_total(step);
  given.answers.raw(io::answer_text(step.line, answer));
  given.refusals.raw(answer.ok() ? "null" : io::why_not_text(step.line, io::why_not(edited, step)));
  if (each_scene) given.scenes.raw(json_of(edited.scene_text()));
  given.all_done = given.all_done && answer.ok();
}

}  // namespace

std::string answer_check(const AskedCall& asked) {
  asked.require(check_keys, 1);
  const io::SceneCheck check = checked_scene(asked);
  std::string json = io::check_json(check);
  std::erase(json, '\n');  // no string of JSON has one
  return ObjectText()
      .member("ok", check.errors.empty() && check.findings.empty())
      .raw("check", json)
      .raw("lines", check_lines(check))
      .text();
}

std::string answer_edit(const AskedCall& asked) {
  asked.require(edit_keys, 2);
  std::optional<contract::scoped_semantic> audit;
  if (asked.flag("audit", false)) audit.emplace(contract::cost::audit, contract::evaluation_semantic::enforce);
  const bool each_scene = asked.flag("scenes", true);
  const std::unique_ptr<io::EditedScene> edited = edited_scene(asked);
  StepAnswers given;
  if (each_scene) given.scenes.raw(json_of(edited->scene_text()));
  for (const io::ScriptStep& step : io::read_script(script_of(asked), edited->of().scene.stage(), edited->types()))
    carry_out(*edited, step, each_scene, given);
  if (!each_scene) given.scenes.raw(json_of(edited->scene_text()));
  return ObjectText()
      .member("ok", given.all_done)
      .raw("answers", given.answers.text())
      .raw("refusals", given.refusals.text())
      .raw("scenes", given.scenes.text())
      .text();
}

}  // namespace durero::web
