#include "edit_completion.hpp"

#include <algorithm>
#include <span>

#include "durero/io/json/operations_file.hpp"
#include "durero/model/tipos.hpp"
#include "durero/scene/mesh.hpp"
#include "durero/scene/stage.hpp"

namespace durero::cli {
namespace {

using CompletionWords = std::vector<std::string>;

CompletionWords names_of_elements(const io::EditedScene& scene) {
  CompletionWords names;
  const scene::Scene& all = scene.of().scene;
  all.for_each([&](scene::ElementRef element, const auto&) { names.push_back(all.name(element).name()); });
  return names;
}

CompletionWords names_of_groups(const io::EditedScene& scene) {
  CompletionWords names;
  for (const auto& [name, group] : scene.of().groups.table()) names.push_back(name);
  return names;
}

CompletionWords names_of_meshes(const io::EditedScene& scene) {
  CompletionWords names;
  const scene::Meshes& meshes = scene.of().scene.meshes();
  for (std::size_t i = 0; i < meshes.size(); ++i) names.push_back(meshes[i].m.name());
  return names;
}

CompletionWords names_of_materials(const io::EditedScene& scene) {
  CompletionWords names;
  for (const scene::Material& material : scene.of().scene.stage().materials) names.push_back(material.name);
  return names;
}

CompletionWords names_of_types() {
  CompletionWords names;
  for (std::size_t i = 0; i < model::tipo_count; ++i) names.emplace_back(model::name(static_cast<model::Tipo>(i)));
  return names;
}

/// The values that an input may take, where they are names of things that there are.
CompletionWords values_of(std::string_view input, const io::EditedScene& scene) {
  if (input == "e" || input == "de" || input == "elementos") return names_of_elements(scene);
  if (input == "g" || input == "groups") return names_of_groups(scene);
  if (input == "m") return names_of_meshes(scene);
  if (input == "material") return names_of_materials(scene);
  if (input == "t") return names_of_types();
  return {};
}

CompletionWords first_words(const io::EditedScene& scene, bool with_commands) {
  CompletionWords words;
  for (const io::OperationWords& operation : io::operation_words(scene.types())) words.push_back(operation.name);
  if (with_commands)
    for (const SessionCommand& command : session_commands()) words.emplace_back(command.name);
  return words;
}

/// An input by its name as it is typed, `e?` or `e`.
std::string_view without_mark(std::string_view name) {
  return name.ends_with('?') ? name.substr(0, name.size() - 1) : name;
}

/// The inputs of the operation that the words before do not give.
CompletionWords inputs_left(std::span<const std::string_view> before, const io::EditedScene& scene) {
  CompletionWords words;
  for (const io::OperationWords& operation : io::operation_words(scene.types())) {
    if (operation.name != before.front()) continue;
    for (const std::string& input : operation.inputs) {
      const auto gives = [&](std::string_view word) { return without_mark(word.substr(0, word.find('='))) == input; };
      if (std::ranges::none_of(before.subspan(1), gives)) words.push_back(input + "?=");
    }
  }
  return words;
}

/// The words of a line before the one that it ends in, and where that begins.
struct TypedWords {
  std::vector<std::string_view> before{};
  std::size_t begin = 0;
};
TypedWords words_of(std::string_view line) {
  TypedWords words;
  for (std::size_t end; (end = line.find(' ', words.begin)) != line.npos; words.begin = end + 1)
    if (end > words.begin) words.before.push_back(line.substr(words.begin, end - words.begin));
  return words;
}

CompletionWords candidates(std::span<const std::string_view> before, std::string_view last, std::size_t& begin,
                           const io::EditedScene& scene) {
  if (before.empty()) return first_words(scene, true);
  if (before.front() == "show") return names_of_elements(scene);
  if (before.front() == "why-not") before = before.subspan(1);
  if (before.empty()) return first_words(scene, false);
  const std::size_t equals = last.find('=');
  if (equals == last.npos) return inputs_left(before, scene);
  const std::size_t comma = last.rfind(',');  // of a list of names
  begin += (comma == last.npos ? equals : comma) + 1;
  return values_of(without_mark(last.substr(0, equals)), scene);
}

}  // namespace

const std::vector<SessionCommand>& session_commands() {
  static const std::vector<SessionCommand> commands{
      {"help", "", "this"},
      {"list", "", "the elements, by name"},
      {"show", "NAME", "an element as a scene file has it"},
      {"view", "", "the scene in the terminal, to be turned and picked from; q ends it"},
      {"why-not", "OPERATION", "every clause that does not hold; nothing is carried out"},
      {"undo", "", "takes the last operation back"},
      {"redo", "", "does it again"},
      {"write", "[FILE]", "writes the scene, to the FILE of -o or else to its own where none is named"},
      {"quit", "", "ends; asks where something is not written"},
  };
  return commands;
}

TypedCompletion completion_of(std::string_view line, const io::EditedScene& scene) {
  const TypedWords words = words_of(line);
  TypedCompletion completion{words.begin, {}};
  completion.words = candidates(words.before, line.substr(words.begin), completion.begin, scene);
  const std::string_view typed = line.substr(completion.begin);
  std::erase_if(completion.words, [&](const std::string& word) { return !word.starts_with(typed); });
  std::ranges::sort(completion.words);
  return completion;
}

}  // namespace durero::cli
