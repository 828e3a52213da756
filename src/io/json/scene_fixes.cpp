#include "durero/io/json/scene_fixes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/json.hpp"
#include "durero/io/json/json_pointer.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/model/operaciones_clauses.hpp"
#include "durero/model/tipos.hpp"
#include "durero/scene/groups.hpp"
#include "io/axis.hpp"
#include "json_patch.hpp"

namespace durero::io {
namespace {

using json::JsonItems;
using json::JsonMembers;
using json::JsonValue;

/// An operation of a patch.
struct PatchProposal {
  enum class Kind : std::uint8_t { replace, remove };

  Kind kind;
  std::string path;      // a JSON pointer to the value
  std::string value{};   // of a replacement, as JSON text
  std::string reason{};  // for whoever reads the patch; the standard lets programs pass over it
};
using Kind = PatchProposal::Kind;

constexpr std::string_view elements_pointer = "/elementos/";

/// The text of a patch, an operation a line.
std::string patch_text(const std::vector<PatchProposal>& patch) {
  std::string text = "[";
  for (const PatchProposal& operation : patch) {
    text += &operation == patch.data() ? "\n" : ",\n";
    std::string line;
    json::Writer out(line);
    out.begin_object()
        .member("op", operation.kind == Kind::replace ? "replace" : "remove")
        .member("path", operation.path);
    if (!operation.reason.empty()) out.member("reason", operation.reason);
    if (operation.kind == Kind::remove) {
      out.end_object();
      text += line;
    } else {
      text += line + ",\"value\":" + operation.value + "}";
    }
  }
  return text + "\n]\n";
}

/// The string that a value is, and nothing of any other.
std::optional<std::string> string_of(const JsonValue* value) {
  const auto* const string = value == nullptr ? nullptr : std::get_if<std::string>(&value->of);
  return string == nullptr ? std::nullopt : std::optional(*string);
}

std::string line_of(const JsonValue& value) {
  std::string text;
  json::append_value(text, value);
  return text;
}

/// The text of an element but for its name.
std::string text_but_for_name(JsonValue element) {
  std::erase_if(std::get<JsonMembers>(element.of), [](const json::JsonMember& member) { return member.key == "id"; });
  return line_of(element);
}

/// The elements of a file; none where it has no such array.
const JsonItems& elements_of(const JsonValue& root) {
  static const JsonItems none;
  const JsonValue* const elements = root.member("elementos");
  const auto* const items = elements == nullptr ? nullptr : std::get_if<JsonItems>(&elements->of);
  return items == nullptr ? none : *items;
}

std::string quoted(const std::string& text) {
  std::string written;
  json::Writer(written).value(text);
  return written;
}

/// The elements of a file by their names: where each name stands first.
class FirstPlaces {
 public:
  explicit FirstPlaces(const JsonValue& root) {
    const JsonItems& elements = elements_of(root);
    for (std::size_t i = 0; i < elements.size(); ++i)
      if (const auto id = string_of(elements[i].member("id"))) first_.try_emplace(*id, i);
  }

  std::optional<std::size_t> of(const std::string& id) const {
    const auto found = first_.find(id);
    return found == first_.end() ? std::nullopt : std::optional(found->second);
  }
  /// A name after that one that no element has; it is taken then. Nothing where it would be too long.
  std::optional<std::string> free_name(const std::string& id) {
    for (std::size_t n = 2;; ++n) {
      std::string name = fmt::format("{}:{}", id, n);
      if (!model::Elemento::is_name(name)) return std::nullopt;
      if (first_.try_emplace(name, 0).second) return name;
    }
  }

 private:
  std::map<std::string, std::size_t> first_{};
};

/// Proposes operations for the errors of one reading of a file.
class Proposals {
 public:
  explicit Proposals(JsonValue& root) : root_(root), places_(root) {}

  std::optional<PatchProposal> of(const InputError& error, const std::string& pointer) {
    const contract::clause* const broken = error.broken();
    if (broken == nullptr) return std::nullopt;
    const std::string_view label = broken->label;
    if (label == model::Unitario_inv_1.label) return unit_axis(pointer);
    if (label == model::Agregar_Elemento_pre_1.label) return one_name(pointer);
    if (label == model::Vertices_inv_1.label) return no_line(pointer);
    if (label == scene::group_pre_2.label) return member(pointer, "it is no element");
    if (label == scene::group_pre_3.label) return member(pointer, "it is no group");
    if (label == scene::group_pre_4.label || label == scene::group_pre_5.label)
      return member(pointer, "it is in a group already");
    return std::nullopt;
  }

 private:
  std::optional<PatchProposal> unit_axis(const std::string& pointer) {
    const JsonValue* const node = json::find(root_, pointer);
    if (node == nullptr) return std::nullopt;
    const std::string text = line_of(*node);
    const Source source("an axis", text);
    const json::Document document(source);
    const auto axis = axis_between(glm::dvec3(0), json::Reader(document).vec3("an axis"));
    if (!axis) return std::nullopt;
    std::string value;
    json::Writer(value).value(axis->vector);
    return PatchProposal{Kind::replace, pointer, value, fmt::format("its length is {}", axis->altura)};
  }

  std::optional<PatchProposal> one_name(const std::string& pointer) {
    const std::string element = pointer.substr(0, pointer.rfind('/'));
    const JsonValue* const node = json::find(root_, element);
    if (node == nullptr || !element.starts_with(elements_pointer)) return std::nullopt;
    const auto id = string_of(node->member("id"));
    const auto first = id ? places_.of(*id) : std::nullopt;
    if (!first) return std::nullopt;
    const std::string other = fmt::format("{}{}", elements_pointer, *first);
    if (line_of(*json::find(root_, other)) == line_of(*node))
      return PatchProposal{Kind::remove, element, "", fmt::format("it stands at {} too", other)};
    const auto name = places_.free_name(*id);
    if (!name) return std::nullopt;
    return PatchProposal{Kind::replace, element + "/id", quoted(*name), fmt::format("{} has the name", other)};
  }

  static std::optional<PatchProposal> no_line(const std::string& pointer) {
    const std::string element = pointer.substr(0, pointer.rfind('/'));
    if (!element.starts_with(elements_pointer)) return std::nullopt;
    return PatchProposal{Kind::remove, element, "", "its vertices lie on one line"};
  }

  static std::optional<PatchProposal> member(const std::string& pointer, const char* reason) {
    return PatchProposal{Kind::remove, pointer, "", reason};
  }

  JsonValue& root_;
  FirstPlaces places_;
};

/// The errors of a text, in its order, each with its pointer.
struct PlacedErrors {
  std::vector<InputError> errors{};
  std::vector<std::string> pointers{};
};

PlacedErrors errors_of(const Source& source) {
  PlacedErrors found;
  read_scene(source, found.errors, Bodies::read);
  found.pointers = json::pointers_in_order(source, found.errors);
  return found;
}

/// Replacements first: they move nothing. Then removals from the last to the first, so that none moves another.
void sort_for_carrying_out(std::vector<PatchProposal>& operations) {
  const auto removals = std::ranges::stable_partition(
      operations, [](const PatchProposal& operation) { return operation.kind == Kind::replace; });
  std::ranges::reverse(removals);
}

/// An error of a patched text, at the place that its value has in the file.
InputError in_file(const Source& file, JsonValue& root, const InputError& error, const std::string& pointer) {
  const std::string message(error.message());
  const std::size_t end = std::min(message.find("; "), message.size());
  const JsonValue* const node = json::find(root, pointer);
  const TextPosition place = node == nullptr ? TextPosition{1, 1} : file.place(node->offset);
  return {file.name(), place, message.substr(0, end), message.substr(std::min(end + 2, message.size())),
          error.broken()};
}

/// Mends the text in memory until it can be read, or nothing more can be proposed.
SceneFixes patch_of(const Source& file) {
  JsonValue root = json::read_whole(file);
  SceneFixes fixes;
  std::vector<PatchProposal> patch;
  while (true) {
    std::string text;
    json::append_lines(text, root);
    const Source now(file.name(), std::move(text));
    const PlacedErrors found = errors_of(now);
    std::vector<PatchProposal> proposed;
    fixes.left.reset();
    Proposals proposals(root);
    for (std::size_t i = 0; i < found.errors.size(); ++i) {
      auto proposal = proposals.of(found.errors[i], found.pointers[i]);
      if (proposal) {
        proposed.push_back(*std::move(proposal));
      } else if (!fixes.left) {
        fixes.left = in_file(file, root, found.errors[i], found.pointers[i]);
      }
    }
    if (proposed.empty()) break;
    sort_for_carrying_out(proposed);
    json::apply_patch(Source("the proposals", patch_text(proposed)), root);
    std::ranges::move(proposed, std::back_inserter(patch));
  }
  if (!patch.empty()) fixes.script = patch_text(patch);
  return fixes;
}

/// The operations that drop what is the same as another element, whose name comes before.
std::string operations_of(const scene::GroupedScene& scene) {
  const JsonValue root = json::read_whole(Source("a scene", scene_text(scene.scene, scene.groups)));
  std::map<std::string, std::string> first;  // from an element but for its name
  std::string script;
  for (const JsonValue& element : elements_of(root)) {
    const std::string id = string_of(element.member("id")).value();
    const auto [at, is_first] = first.try_emplace(text_but_for_name(element), id);
    if (is_first) continue;
    script += fmt::format("# {} is the same as {}.", id, at->second);
    if (const std::string_view group = scene.groups.of_element(id); !group.empty())
      script += fmt::format(" It leaves the group {}.", group);
    script += fmt::format("\nEliminar_Elemento e?={}\n", id);
  }
  return script;
}

}  // namespace

SceneFixes scene_fixes(const Source& file) {
  std::vector<InputError> errors;
  read_scene(file, errors, Bodies::read);
  if (errors.empty()) return {operations_of(read_grouped_scene(file, Bodies::read))};
  try {
    return patch_of(file);
  } catch (const InputError&) {  // it is no JSON
    std::ranges::stable_sort(errors, {}, &InputError::offset);
    return {"", errors.front()};
  }
}

}  // namespace durero::io
