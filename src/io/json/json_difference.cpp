#include "json_difference.hpp"

#include <fmt/format.h>

#include <compare>
#include <iterator>
#include <numeric>
#include <optional>

#include "durero/io/json/json_pointer.hpp"
#include "durero/io/json/json_writer.hpp"

namespace durero::io::json {
namespace {

using Lines = std::vector<std::string>;

std::string line_of(std::string_view word, const std::string& path, const JsonValue* value) {
  std::string line;
  Writer out(line);
  out.begin_object().member("op", word).member("path", path);
  if (value == nullptr) {
    out.end_object();
    return line;
  }
  out.key("value");
  append_value(line, *value);
  return line + "}";
}

std::size_t length_of(const Lines& lines) {
  return std::accumulate(lines.begin(), lines.end(), std::size_t{0},
                         [](std::size_t sum, const std::string& line) { return sum + line.size(); });
}

void append_lines(Lines& to, Lines from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

/// The lines between values that differ, at that path.
Lines difference(const std::string& path, const JsonValue& a, const JsonValue& b);

Lines of_members(const std::string& path, const JsonMembers& a, const JsonValue& b_whole) {
  Lines lines;
  const auto at = [&](const JsonMember& member) { return path + "/" + pointer_token(member.key); };
  for (const JsonMember& member : a) {
    const JsonValue* const now = b_whole.member(member.key);
    if (now == nullptr)
      lines.push_back(line_of("remove", at(member), nullptr));
    else if (*now != member.value)
      append_lines(lines, difference(at(member), member.value, *now));
  }
  return lines;
}

Lines of_items(const std::string& path, const JsonItems& a, const JsonItems& b) {
  Lines lines;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i]) append_lines(lines, difference(fmt::format("{}/{}", path, i), a[i], b[i]));
  return lines;
}

const std::string& id_of(const JsonValue& item) { return std::get<std::string>(item.member("id")->of); }

/// From the last to the first, so that a line moves nothing that a later one speaks of.
Lines of_named_items(const std::string& path, const JsonItems& a, const JsonItems& b) {
  Lines lines;
  std::size_t i = a.size(), j = b.size();
  while (i > 0 || j > 0) {
    const auto order = i == 0   ? std::strong_ordering::less
                       : j == 0 ? std::strong_ordering::greater
                                : id_of(a[i - 1]) <=> id_of(b[j - 1]);
    const std::string last = fmt::format("{}/{}", path, i == 0 ? 0 : i - 1);
    if (order < 0) {
      lines.push_back(line_of("add", fmt::format("{}/{}", path, i), &b[--j]));
      continue;
    }
    --i;
    if (order == 0) --j;
    if (order == 0 && a[i] == b[j]) continue;
    lines.push_back(line_of("test", last + "/id", a[i].member("id")));
    if (order > 0)
      lines.push_back(line_of("remove", last, nullptr));
    else
      append_lines(lines, difference(last, a[i], b[j]));
  }
  return lines;
}

bool is_named(const std::string& path) { return path == "/elementos" || path == "/mallas"; }

/// Whether a part of one is a part of the other: an element of another type has other attributes.
bool are_of_one_type(const JsonValue& a, const JsonValue& b) {
  const JsonValue *const x = a.member("tipo"), *const y = b.member("tipo");
  return x == nullptr || y == nullptr || *x == *y;
}

/// The lines between the parts of arrays of the same size, or of objects; nothing where there are no such parts.
std::optional<Lines> difference_of_parts(const std::string& path, const JsonValue& a, const JsonValue& b) {
  const auto *const items = std::get_if<JsonItems>(&a.of), *const now = std::get_if<JsonItems>(&b.of);
  if (items != nullptr && now != nullptr && items->size() == now->size()) return of_items(path, *items, *now);
  const auto *const members = std::get_if<JsonMembers>(&a.of), *const others = std::get_if<JsonMembers>(&b.of);
  if (members == nullptr || others == nullptr || !are_of_one_type(a, b)) return std::nullopt;
  Lines lines = of_members(path, *members, b);
  for (const JsonMember& member : *others)
    if (a.member(member.key) == nullptr)
      lines.push_back(line_of("add", path + "/" + pointer_token(member.key), &member.value));
  return lines;
}

Lines difference(const std::string& path, const JsonValue& a, const JsonValue& b) {
  if (is_named(path)) return of_named_items(path, std::get<JsonItems>(a.of), std::get<JsonItems>(b.of));
  std::optional<Lines> parts = difference_of_parts(path, a, b);
  if (parts && path.empty()) return *std::move(parts);
  std::string whole = line_of("replace", path, &b);
  if (parts && length_of(*parts) < whole.size()) return *std::move(parts);
  return {std::move(whole)};
}

}  // namespace

std::string patch_between(const JsonValue& from, const JsonValue& to) {
  std::string text = "[";
  if (from != to) {
    for (const std::string& line : difference("", from, to)) text += (text.size() == 1 ? "\n" : ",\n") + line;
    text += "\n";
  }
  return text + "]\n";
}

}  // namespace durero::io::json
