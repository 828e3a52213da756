#include "json_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "durero/io/json/json_writer.hpp"

namespace durero::io::json {
namespace {

using Form = TreeNode::Form;

/// Where a leaf that begins there ends: a string at its closing quote, any other before what bounds it.
std::size_t end_of_leaf(std::string_view text, std::size_t begin) {
  if (text[begin] != '"') return std::min(text.find_first_of(",]} \t\r\n", begin), text.size());
  std::size_t at = begin + 1;
  while (text[at] != '"') at += text[at] == '\\' ? 2 : 1;
  return at + 1;
}

class TreeReader {
 public:
  explicit TreeReader(const Document& document) : document_(document) {}

  TreeNode value(std::size_t level) {
    const Document::Token token = take();
    TreeNode node{.offset = token.offset};
    const bool opens = token.kind == TokenKind::object || token.kind == TokenKind::array;
    if (!opens) {
      const std::string_view text = document_.source().text();
      node.text = text.substr(token.offset, end_of_leaf(text, token.offset) - token.offset);
      return node;
    }
    if (level == most_levels)
      document_.source().fail(token.offset, fmt::format("{} brackets stand one within another", most_levels + 1),
                              "expected fewer");
    node.form = token.kind == TokenKind::object ? Form::object : Form::array;
    while (document_.tokens()[next_].kind != TokenKind::end_object &&
           document_.tokens()[next_].kind != TokenKind::end_array) {
      if (node.form == Form::object) node.keys.emplace_back(document_.string_value(take()));
      node.items.push_back(value(level + 1));
    }
    take();
    return node;
  }

 private:
  Document::Token take() { return document_.tokens()[next_++]; }

  const Document& document_;
  std::size_t next_ = 0;
};

constexpr std::size_t levels_of_lines = 2;

void append_key(std::string& text, std::string_view key) {
  Writer(text).value(key);
  text += ':';
}

void append(std::string& text, const TreeNode& node, std::size_t level) {
  if (node.form == Form::leaf) {
    text += node.text;
    return;
  }
  text += node.form == Form::object ? '{' : '[';
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    if (i > 0) text += ',';
    if (level < levels_of_lines) text += '\n';
    if (node.form == Form::object) append_key(text, node.keys[i]);
    append(text, node.items[i], level + 1);
  }
  text += node.form == Form::object ? '}' : ']';
}

/// The place of an item among those of a container: nothing where the token names none.
std::optional<std::size_t> place_of(const TreeNode& node, std::string_view token) {
  if (node.form == Form::leaf) return std::nullopt;
  if (node.form == Form::array) {
    std::size_t place = 0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), place);
    const bool is_number = error == std::errc() && end == token.data() + token.size() && !token.empty();
    if (!is_number || (token.size() > 1 && token.front() == '0') || place >= node.items.size()) return std::nullopt;
    return place;
  }
  std::string key;
  for (std::size_t i = 0; i < token.size(); ++i) {
    const bool is_escape = token[i] == '~' && i + 1 < token.size();
    key += !is_escape ? token[i] : token[++i] == '1' ? '/' : '~';
  }
  const auto found = std::ranges::find(node.keys, key);
  if (found == node.keys.end()) return std::nullopt;
  return static_cast<std::size_t>(found - node.keys.begin());
}

}  // namespace

const TreeNode* TreeNode::member(std::string_view key) const {
  const auto found = std::ranges::find(keys, key);
  return found == keys.end() ? nullptr : &items[static_cast<std::size_t>(found - keys.begin())];
}

TreeNode read_tree(const Source& source) {
  const Document document(source);
  return TreeReader(document).value(0);
}

std::string tree_text(const TreeNode& node) {
  std::string text;
  append(text, node, 0);
  return text;
}

std::string line_of(const TreeNode& node) {
  std::string text;
  append(text, node, levels_of_lines);
  return text;
}

TreeNode* find(TreeNode& root, std::string_view pointer) {
  TreeNode* node = &root;
  while (!pointer.empty()) {
    if (pointer.front() != '/') return nullptr;
    const std::size_t end = std::min(pointer.find('/', 1), pointer.size());
    const auto place = place_of(*node, pointer.substr(1, end - 1));
    if (!place) return nullptr;
    node = &node->items[*place];
    pointer.remove_prefix(end);
  }
  return node;
}

bool replace(TreeNode& root, std::string_view pointer, const std::string& text) {
  TreeNode* const node = find(root, pointer);
  if (node == nullptr) return false;
  const std::size_t offset = node->offset;
  *node = read_tree(Source("value", text));
  node->offset = offset;
  return true;
}

bool remove(TreeNode& root, std::string_view pointer) {
  const std::size_t slash = pointer.rfind('/');
  TreeNode* const container = slash == pointer.npos ? nullptr : find(root, pointer.substr(0, slash));
  const auto place = container == nullptr ? std::nullopt : place_of(*container, pointer.substr(slash + 1));
  if (!place) return false;
  const auto at = static_cast<std::ptrdiff_t>(*place);
  container->items.erase(container->items.begin() + at);
  if (container->form == Form::object) container->keys.erase(container->keys.begin() + at);
  return true;
}

}  // namespace durero::io::json
