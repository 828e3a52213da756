#include "json_value.hpp"

#include <algorithm>

#include "durero/io/json/json_writer.hpp"
#include "durero/io/number_text.hpp"

namespace durero::io::json {
namespace {

/// Of a number, true, false or null: from that byte on.
std::string_view word_at(std::string_view text, std::size_t begin) {
  return text.substr(begin, text.find_first_of(", \t\r\n]}", begin) - begin);
}

class ValueReader {
 public:
  ValueReader(const Source& source, Reader& in) : source_(source), in_(in) {}

  JsonValue value(std::size_t depth) {
    switch (in_.kind()) {
      case TokenKind::object: {
        require_depth(depth);
        JsonMembers members;
        in_.members("a value", [&](const Key& key) { members.push_back({std::string(key.name), value(depth + 1)}); });
        return {std::move(members)};
      }
      case TokenKind::array: {
        require_depth(depth);
        JsonItems items;
        in_.array("a value", [&] { items.push_back(value(depth + 1)); });
        return {std::move(items)};
      }
      case TokenKind::string:
        return {std::string(in_.string("a value"))};
      case TokenKind::null:
      case TokenKind::boolean:
      case TokenKind::number:
      case TokenKind::key:
      case TokenKind::end_object:
      case TokenKind::end_array:
      case TokenKind::end:
        break;  // a value stands here, so it is one of the first three
    }
    JsonWord word{std::string(word_at(source_.text(), in_.offset()))};
    in_.skip();
    return {std::move(word)};
  }

 private:
  void require_depth(std::size_t depth) const {
    if (depth >= deepest_brackets)
      in_.fail(in_.offset(), "brackets stand too deep in each other", "expected no more than a scene has");
  }

  const Source& source_;
  Reader& in_;
};

void append(std::string& out, const JsonWord& word) { out += word.text; }
void append(std::string& out, const std::string& text) { Writer(out).value(std::string_view(text)); }
void append(std::string& out, const JsonItems& items) {
  out += '[';
  for (const JsonValue& item : items) {
    if (&item != items.data()) out += ',';
    append_value(out, item);
  }
  out += ']';
}
void append(std::string& out, const JsonMembers& members) {
  out += '{';
  for (const JsonMember& member : members) {
    if (&member != members.data()) out += ',';
    Writer(out).key(member.key);
    append_value(out, member.value);
  }
  out += '}';
}

bool equal(const JsonWord& a, const JsonWord& b) {
  if (a == b) return true;
  const auto x = read_decimal(a.text), y = read_decimal(b.text);
  return x && y && *x == *y;
}
bool equal(const std::string& a, const std::string& b) { return a == b; }
bool equal(const JsonItems& a, const JsonItems& b) { return std::ranges::equal(a, b, are_equal); }
bool equal(const JsonMembers& a, const JsonMembers& b) {
  std::vector<const JsonMember*> by_key[2];
  for (const JsonMember& member : a) by_key[0].push_back(&member);
  for (const JsonMember& member : b) by_key[1].push_back(&member);
  for (auto& members : by_key) std::ranges::stable_sort(members, {}, &JsonMember::key);
  return std::ranges::equal(by_key[0], by_key[1], [](const JsonMember* x, const JsonMember* y) {
    return x->key == y->key && are_equal(x->value, y->value);
  });
}

/// Of members that are constant or not; null where there are none.
template <class Members>
auto first_of_key(Members* members, std::string_view key) -> decltype(&members->front().value) {
  if (members == nullptr) return nullptr;
  const auto found = std::ranges::find(*members, key, &JsonMember::key);
  return found == members->end() ? nullptr : &found->value;
}

const JsonValue& value_of(const JsonValue& item) { return item; }
const JsonValue& value_of(const JsonMember& member) { return member.value; }

}  // namespace

JsonValue* JsonValue::member(std::string_view key) { return first_of_key(std::get_if<JsonMembers>(&of), key); }
const JsonValue* JsonValue::member(std::string_view key) const {
  return first_of_key(std::get_if<JsonMembers>(&of), key);
}

ValueExtent extent_of(const JsonValue& value) {
  return std::visit(
      []<class Value>(const Value& of) {
        ValueExtent extent{0, 1};
        if constexpr (std::is_same_v<Value, JsonItems> || std::is_same_v<Value, JsonMembers>) {
          for (const auto& part : of) {
            const ValueExtent below = extent_of(value_of(part));
            extent = {std::max(extent.depth, below.depth), extent.values + below.values};
          }
          ++extent.depth;
        }
        return extent;
      },
      value.of);
}

bool JsonValue::operator==(const JsonValue& other) const { return of == other.of; }

JsonValue read_value(const Source& source, Reader& in) { return ValueReader(source, in).value(0); }

void append_value(std::string& out, const JsonValue& value) {
  std::visit([&](const auto& of) { append(out, of); }, value.of);
}

bool are_equal(const JsonValue& a, const JsonValue& b) {
  return std::visit(
      []<class Left, class Right>(const Left& left, const Right& right) {
        if constexpr (std::is_same_v<Left, Right>)
          return equal(left, right);
        else
          return false;
      },
      a.of, b.of);
}

}  // namespace durero::io::json
