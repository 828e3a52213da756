#include "durero/io/json/scene_fixes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "durero/io/json/file_patch.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/json.hpp"
#include "durero/io/json/json_pointer.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/model/operaciones_clauses.hpp"
#include "durero/model/tipos.hpp"
#include "durero/scene/groups.hpp"
#include "io/axis.hpp"
#include "json_tree.hpp"

namespace durero::io {
namespace {

using json::PatchProposal;
using json::TreeNode;
using Kind = PatchProposal::Kind;

constexpr std::string_view elements_pointer = "/elementos/";

/// The value of a string leaf, and nothing of any other.
std::optional<std::string> string_of(const TreeNode* node) {
  if (node == nullptr || !node->text.starts_with('"')) return std::nullopt;
  const Source source("a string", node->text);
  const json::Document document(source);
  return std::string(json::Reader(document).string("a string"));
}

/// The text of an element but for its name.
std::string text_but_for_name(TreeNode element) {
  json::remove(element, "/id");
  return json::line_of(element);
}

std::string quoted(const std::string& text) {
  std::string written;
  json::Writer(written).value(text);
  return written;
}

/// The elements of a file by their names: where each name stands first.
class FirstPlaces {
 public:
  explicit FirstPlaces(const TreeNode& root) {
    const TreeNode* const elements = root.member("elementos");
    if (elements == nullptr) return;
    for (std::size_t i = 0; i < elements->items.size(); ++i)
      if (const auto id = string_of(elements->items[i].member("id"))) first_.try_emplace(*id, i);
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
  explicit Proposals(TreeNode& root) : root_(root), places_(root) {}

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
    const TreeNode* const node = json::find(root_, pointer);
    if (node == nullptr) return std::nullopt;
    const std::string text = json::line_of(*node);
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
    TreeNode* const node = json::find(root_, element);
    if (node == nullptr || !element.starts_with(elements_pointer)) return std::nullopt;
    const auto id = string_of(node->member("id"));
    const auto first = id ? places_.of(*id) : std::nullopt;
    if (!first) return std::nullopt;
    const std::string other = fmt::format("{}{}", elements_pointer, *first);
    if (json::line_of(*json::find(root_, other)) == json::line_of(*node))
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

  TreeNode& root_;
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
InputError in_file(const Source& file, TreeNode& root, const InputError& error, const std::string& pointer) {
  const std::string message(error.message());
  const std::size_t end = std::min(message.find("; "), message.size());
  const TreeNode* const node = json::find(root, pointer);
  const TextPosition place = node == nullptr ? TextPosition{1, 1} : file.place(node->offset);
  return {file.name(), place, message.substr(0, end), message.substr(std::min(end + 2, message.size())),
          error.broken()};
}

/// Mends the text in memory until it can be read, or nothing more can be proposed.
SceneFixes patch_of(const Source& file) {
  TreeNode root = json::read_tree(file);
  SceneFixes fixes;
  std::vector<PatchProposal> patch;
  while (true) {
    const Source now(file.name(), json::tree_text(root));
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
    for (const PatchProposal& operation : proposed) {
      if (operation.kind == Kind::replace) json::replace(root, operation.path, operation.value);
      if (operation.kind == Kind::remove) json::remove(root, operation.path);
    }
    std::ranges::move(proposed, std::back_inserter(patch));
  }
  if (!patch.empty()) fixes.script = json::patch_text(patch);
  return fixes;
}

/// The operations that drop what is the same as another element, whose name comes before.
std::string operations_of(const scene::GroupedScene& scene) {
  const Source text("a scene", scene_text(scene.scene, scene.groups));
  const TreeNode root = json::read_tree(text);
  std::map<std::string, std::string> first;  // from an element but for its name
  std::string script;
  for (const TreeNode& element : root.member("elementos")->items) {
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
