#include "durero/io/json/file_patch.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "durero/io/json/json.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/text/shown.hpp"
#include "json_tree.hpp"

namespace durero::io::json {
namespace {

using Kind = PatchProposal::Kind;

constexpr std::array<std::string_view, 4> patch_keys{"op", "path", "value", "reason"};
constexpr std::size_t required_of_patch = 2;

PatchProposal read_patch_operation(Reader& in, const TreeNode& node) {
  PatchProposal operation{Kind::remove, "", "", "", in.offset()};
  const std::size_t at = in.offset();
  bool has_value = false;
  in.object("an operation", patch_keys, required_of_patch, [&](std::size_t key) {
    const std::size_t place = in.offset();
    switch (key) {
      case 0: {
        const std::string_view op = in.string("op");
        if (op != "replace" && op != "remove")
          in.fail(place, fmt::format("op is {}", text::shown(op)), "expected replace or remove");
        operation.kind = op == "replace" ? Kind::replace : Kind::remove;
        return;
      }
      case 1:
        operation.path = in.string("path");
        return;
      case 2:
        in.skip();
        operation.value = line_of(*node.member("value"));
        has_value = true;
        return;
      default:
        operation.reason = in.string("reason");
    }
  });
  if (has_value != (operation.kind == Kind::replace))
    in.fail(at, has_value ? "remove has a value" : "replace has no value",
            "expected a value to replace by, and it alone");
  return operation;
}

/// Carries out an operation; false where its path names nothing.
bool apply(TreeNode& root, const PatchProposal& operation) {
  return operation.kind == Kind::remove ? remove(root, operation.path) : replace(root, operation.path, operation.value);
}

}  // namespace

bool is_patch(const Source& source) {
  const std::size_t first = source.text().find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && source.text()[first] == '[';
}

std::vector<PatchProposal> read_patch(const Source& source) {
  const TreeNode tree = read_tree(source);
  const Document document(source);
  Reader in(document);
  std::vector<PatchProposal> patch;
  in.array("a patch", [&] { patch.push_back(read_patch_operation(in, tree.items[patch.size()])); });
  return patch;
}

std::string patch_text(std::span<const PatchProposal> patch) {
  std::string text = "[";
  for (const PatchProposal& operation : patch) {
    text += &operation == &patch.front() ? "\n" : ",\n";
    std::string line;
    Writer out(line);
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

std::string patched(const Source& file, const Source& patch_source, std::span<const PatchProposal> patch) {
  TreeNode root = read_tree(file);
  for (const PatchProposal& operation : patch)
    if (!apply(root, operation))
      patch_source.fail(operation.offset, fmt::format("{} names nothing", text::shown(operation.path)),
                        fmt::format("expected a pointer to a value of {}", file.name()));
  return tree_text(root) + "\n";
}

}  // namespace durero::io::json
