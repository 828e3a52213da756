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
    const std::size_t offset = in_.offset();
    switch (in_.kind()) {
      case TokenKind::object: {
        require_depth(depth);
        JsonMembers members;
        in_.members("a value", [&](const Key& key) { members.push_back({std::string(key.name), value(depth + 1)}); });
        return {std::move(members), offset};
      }
      case TokenKind::array: {
        require_depth(depth);
        JsonItems items;
        in_.array("a value", [&] { items.push_back(value(depth + 1)); });
        return {std::move(items), offset};
      }
      case TokenKind::string:
        return {std::string(in_.string("a value")), offset};
      case TokenKind::null:
      case TokenKind::boolean:
      case TokenKind::number:
      case TokenKind::key:
      case TokenKind::end_object:
      case TokenKind::end_array:
      case TokenKind::end:
        break;  // a value stands here, so it is one of the first three
    }
    JsonWord word{std::string(word_at(source_.text(), offset))};
    in_.skip();
    return {std::move(word), offset};
  }

 private:
  void require_depth(std::size_t depth) const {
    if (depth >= deepest_brackets)
      in_.fail(in_.offset(), "brackets stand too deep in each other", "expected no more than a scene has");
  }

  const Source& source_;
  Reader& in_;
};

/// Writes a value: the parts of its outer levels each on a line of its own.
class JsonValueWriter {
 public:
  explicit JsonValueWriter(std::string& out) : out_(out) {}

  void value(const JsonValue& of, std::size_t line_levels) {
    std::visit([&](const auto& kind) { append(kind, line_levels); }, of.of);
  }

 private:
  void append(const JsonWord& word, std::size_t) { out_ += word.text; }
  void append(const std::string& text, std::size_t) { Writer(out_).value(std::string_view(text)); }
  void append(const JsonItems& items, std::size_t line_levels) {
    out_ += '[';
    for (const JsonValue& item : items) {
      separate(&item == items.data(), line_levels);
      part(item, line_levels);
    }
    out_ += ']';
  }
  void append(const JsonMembers& members, std::size_t line_levels) {
    out_ += '{';
    for (const JsonMember& member : members) {
      separate(&member == members.data(), line_levels);
      Writer(out_).key(member.key);
      part(member.value, line_levels);
    }
    out_ += '}';
  }

  void separate(bool is_first, std::size_t line_levels) {
    if (!is_first) out_ += ',';
    if (line_levels > 0) out_ += '\n';
  }
  void part(const JsonValue& of, std::size_t line_levels) { value(of, line_levels - (line_levels > 0 ? 1 : 0)); }

  std::string& out_;
};

constexpr std::size_t line_levels_of_a_file = 2;

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

JsonValue read_whole(const Source& source) {
  const Document document(source);
  Reader in(document);
  return read_value(source, in);
}

void append_value(std::string& out, const JsonValue& value) { JsonValueWriter(out).value(value, 0); }

void append_lines(std::string& out, const JsonValue& value) {
  JsonValueWriter(out).value(value, line_levels_of_a_file);
  out += '\n';
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
