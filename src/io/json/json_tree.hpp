#pragma once
/// A JSON text as a tree whose leaves are pieces of the text, so that it can be edited and written again with the
/// digits that it had.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/json/json.hpp"
#include "durero/io/source.hpp"

namespace durero::io::json {

/// The most containers that may stand one within another: whoever edits a tree walks it by recursion.
inline constexpr std::size_t most_levels = 100;

/// A value of a JSON text.
struct TreeNode {
  /// The forms of it.
  enum class Form : unsigned char { leaf, array, object };

  Form form = Form::leaf;
  std::size_t offset = 0;           ///< where it begins in the text that it was read from
  std::string text{};               ///< of a leaf, as it was written
  std::vector<std::string> keys{};  ///< of an object, without escapes, in step with the items
  std::vector<TreeNode> items{};    ///< of a container

  /// The member of an object; null where there is none.
  const TreeNode* member(std::string_view key) const;
};

/// Reads a whole source. Throws InputError where it is no JSON, or is nested too deeply.
TreeNode read_tree(const Source& source);

/// The text of a value: each item of a container of the two outer levels on a line of its own.
std::string tree_text(const TreeNode& node);
/// The same on one line.
std::string line_of(const TreeNode& node);

/// The value that a JSON pointer names; null where there is none.
TreeNode* find(TreeNode& root, std::string_view pointer);

/// Replaces the value that a JSON pointer names by that of a JSON text; false where there is none.
bool replace(TreeNode& root, std::string_view pointer, const std::string& text);

/// Removes the value that a JSON pointer names; false where there is none, or where it is the whole.
bool remove(TreeNode& root, std::string_view pointer);

}  // namespace durero::io::json
