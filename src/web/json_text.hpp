#pragma once
/// JSON made of parts that are JSON already, as the lines of the command line are.

#include <string>
#include <string_view>

#include "durero/io/json/json_writer.hpp"

namespace durero::web {

/// A value as JSON: what io::json::Writer writes of it.
template <class Value>
std::string json_of(const Value& value) {
  std::string text;
  io::json::Writer(text).value(value);
  return text;
}

/// An object, member by member.
class ObjectText {
 public:
  /// Adds a member whose value is JSON.
  ObjectText& raw(std::string_view key, std::string_view json) {
    text_.append(text_.size() > 1 ? "," : "").append(json_of(key)).append(":").append(json);
    return *this;
  }
  /// Adds a member whose value is written as JSON.
  template <class Value>
  ObjectText& member(std::string_view key, const Value& value) {
    return raw(key, json_of(value));
  }
  /// The object.
  std::string text() const { return text_ + "}"; }

 private:
  std::string text_ = "{";
};

/// An array, item by item.
class ArrayText {
 public:
  /// Adds an item that is JSON.
  ArrayText& raw(std::string_view json) {
    text_.append(text_.size() > 1 ? "," : "").append(json);
    return *this;
  }
  /// The array.
  std::string text() const { return text_ + "]"; }

 private:
  std::string text_ = "[";
};

/// An array of what `made` makes of each item.
template <class Items, class Maker>
std::string array_of(const Items& items, Maker made) {
  ArrayText array;
  for (const auto& item : items) array.raw(made(item));
  return array.text();
}

/// An array of texts.
template <class Texts>
std::string array_of_texts(const Texts& texts) {
  return array_of(texts, [](const auto& text) { return json_of(std::string_view(text)); });
}

/// An array of the lines of a text, each of which is JSON or, with `quoted`, a text.
std::string array_of_lines(std::string_view lines, bool quoted);

}  // namespace durero::web
