#pragma once
/// The attributes of all shapes by their words, as files and scripts name them. They come from the tables of
/// scene/shape/, so a new shape changes nothing here.

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "durero/scene/attributes.hpp"
#include "durero/scene/shapes.hpp"

namespace durero::io {

/// Each word once, in the order in which the shapes first name it.
inline constexpr auto attribute_words = [] {
  constexpr auto distinct = [] {
    std::array<std::string_view, 64> words{};
    std::size_t count = 0;
    scene::for_each_attribute_of_all([&](const auto& attribute) {
      const auto end = words.begin() + count;
      if (std::find(words.begin(), end, attribute.word) == end) words[count++] = attribute.word;
    });
    return std::pair{words, count};
  }();
  std::array<std::string_view, distinct.second> words{};
  std::copy_n(distinct.first.begin(), words.size(), words.begin());
  return words;
}();

/// visit(attribute) for an attribute of that word, of the first shape that has it: a word means the same kind of value
/// in every shape. Precondition: it is one of attribute_words.
template <class Visit>
void with_attribute(std::string_view word, Visit&& visit) {
  bool visited = false;
  scene::for_each_attribute_of_all([&](const auto& attribute) {
    if (visited || attribute.word != word) return;
    visited = true;
    visit(attribute);
  });
}

/// Whether the shape has an attribute of that word.
template <class Shape>
constexpr bool has_attribute(std::string_view word) {
  bool has = false;
  scene::for_each_attribute<Shape>([&](const auto& attribute) { has = has || attribute.word == word; });
  return has;
}

}  // namespace durero::io
