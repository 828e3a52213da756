#include "durero/io/json/json_pointer.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace durero::io::json {
namespace {

/// An array or an object that is open, and which of its items or members was begun last.
struct OpenContainer {
  bool is_array;
  std::size_t items = 0;
  std::string_view key{};
};

std::string text_of(const std::vector<OpenContainer>& path) {
  std::string text;
  for (const OpenContainer& level : path)
    text += "/" + (level.is_array ? std::to_string(level.items - 1) : pointer_token(level.key));
  return text;
}

}  // namespace

std::string pointer_token(std::string_view key) {
  std::string text;
  for (const char c : key) text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return text;
}

std::vector<std::string> pointers(const Document& document, std::span<const std::size_t> offsets) {
  std::vector<std::string> all;
  std::vector<OpenContainer> path;
  const auto& tokens = document.tokens();
  for (std::size_t i = 0; i + 1 < tokens.size() && all.size() < offsets.size(); ++i) {
    const TokenKind kind = tokens[i].kind;
    const bool ends = kind == TokenKind::end_object || kind == TokenKind::end_array;
    if (ends) path.pop_back();
    if (kind == TokenKind::key) {
      path.back().key = document.string_value(tokens[i]);
    } else if (!ends && !path.empty()) {
      ++path.back().items;
    }
    while (all.size() < offsets.size() && offsets[all.size()] < tokens[i + 1].offset) all.push_back(text_of(path));
    if (kind == TokenKind::object || kind == TokenKind::array) path.push_back({.is_array = kind == TokenKind::array});
  }
  all.resize(offsets.size());
  return all;
}

std::vector<std::string> pointers_in_order(const Source& text, std::vector<InputError>& errors) {
  std::ranges::stable_sort(errors, {}, &InputError::offset);
  std::vector<std::size_t> offsets;
  offsets.reserve(errors.size());
  for (const InputError& error : errors) offsets.push_back(error.offset());
  return pointers(Document(text), offsets);
}

}  // namespace durero::io::json
