#include "json_patch.hpp"

#include <fmt/format.h>
#include <rapidjson/pointer.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <span>

#include "durero/io/json/json_pointer.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/text/nearest.hpp"
#include "durero/text/shown.hpp"

namespace durero::io::json {
namespace {

enum class PatchWord : std::uint8_t { add, remove, replace, move, copy, test };
constexpr std::array<std::string_view, 6> patch_words{"add", "remove", "replace", "move", "copy", "test"};

/// A pointer as it stands in a patch.
struct PatchPointer {
  std::string text;
  std::size_t offset;         // of its opening quote
  rapidjson::Pointer parsed;  // its keys and indices
  std::span<const rapidjson::Pointer::Token> tokens() const { return {parsed.GetTokens(), parsed.GetTokenCount()}; }
};

struct PatchOperation {
  PatchWord word;
  std::optional<PatchPointer> path{}, from{};
  std::optional<JsonValue> value{};
};

bool takes_from(PatchWord word) { return word == PatchWord::move || word == PatchWord::copy; }
bool takes_value(PatchWord word) {
  return word == PatchWord::add || word == PatchWord::replace || word == PatchWord::test;
}

class PatchReader {
 public:
  explicit PatchReader(const Source& patch) : patch_(patch) {}

  std::vector<PatchOperation> read() {
    const Document document(patch_);
    Reader in(document);
    std::vector<PatchOperation> operations;
    in.array("a patch", [&] { operations.push_back(read_operation(in)); });
    return operations;
  }

 private:
  /// Other members are passed over, as the RFC asks.
  PatchOperation read_operation(Reader& in) {
    const std::size_t at = in.offset();
    PatchOperation read{};
    std::optional<PatchWord> word;
    in.members("an operation of a patch", [&](const Key& key) {
      const auto once = [&](const auto& member) {
        if (member) in.fail(key.offset, fmt::format("key \"{}\" stands twice", key.name), "expected it once");
      };
      if (key.name == "op") {
        once(word);
        word = read_word(in);
      } else if (key.name == "path" || key.name == "from") {
        std::optional<PatchPointer>& pointer = key.name == "path" ? read.path : read.from;
        once(pointer);
        pointer.emplace(read_pointer(in, key.name));
      } else if (key.name == "value") {
        once(read.value);
        read.value.emplace(read_value(patch_, in));
      } else {
        in.skip();
      }
    });
    require(in, at, "op", word.has_value());
    read.word = *word;
    require(in, at, "path", read.path.has_value());
    require(in, at, "from", read.from || !takes_from(read.word));
    require(in, at, "value", read.value || !takes_value(read.word));
    return read;
  }

  static void require(const Reader& in, std::size_t at, std::string_view key, bool is_there) {
    if (!is_there) in.fail(at, fmt::format("key \"{}\" is missing in an operation of a patch", key), "expected it");
  }

  static PatchWord read_word(Reader& in) {
    const std::size_t at = in.offset();
    const std::string_view word = in.string("op");
    const auto found = std::ranges::find(patch_words, word);
    if (found == patch_words.end())
      in.fail(at, fmt::format("op is {}", text::shown(word)),
              "expected " + text::expected_of(word, {patch_words.begin(), patch_words.end()}));
    return static_cast<PatchWord>(found - patch_words.begin());
  }

  static PatchPointer read_pointer(Reader& in, std::string_view key) {
    const std::size_t at = in.offset();
    std::string text(in.string(key));
    rapidjson::Pointer parsed(text.data(), text.size());
    if ((!text.empty() && text.front() != '/') || !parsed.IsValid())
      in.fail(at, fmt::format("{} is {}", key, text::shown(text)), "expected a JSON pointer, such as /elementos/0");
    return {std::move(text), at, std::move(parsed)};
  }

  const Source& patch_;
};

/// The most values that the copies of a patch put in. Each may double a document, so that a short patch would fill any
/// memory; a scene of half a million spheres has as many. What else is put in stands in the patch.
constexpr std::size_t most_copied = std::size_t{1} << 22U;

class PatchRun {
 public:
  PatchRun(const Source& patch, JsonValue& root) : patch_(patch), root_(root) {}

  void apply(PatchOperation& operation) {
    const PatchPointer& path = *operation.path;
    switch (operation.word) {
      case PatchWord::add:
        require_depth(path, *operation.value);
        return add(path, std::move(*operation.value));
      case PatchWord::remove:
        take(path);
        return;
      case PatchWord::replace:
        require_depth(path, *operation.value);
        existing(path) = std::move(*operation.value);
        return;
      case PatchWord::move:
        if (path.text.starts_with(operation.from->text + "/"))
          fail(path, "lies in what is moved", "expected a place outside it");
        require_depth(path, existing(*operation.from));
        if (path.text != operation.from->text) add(path, take(*operation.from));
        return;
      case PatchWord::copy:
        return add(path, copy(path, *operation.from));
      case PatchWord::test:
        if (!are_equal(existing(path), *operation.value)) fail(path, "has another value", "expected that of the test");
    }
  }

 private:
  using Tokens = std::span<const rapidjson::Pointer::Token>;

  [[noreturn]] void fail(const PatchPointer& at, std::string_view wrong, const std::string& expected) const {
    patch_.fail(at.offset, fmt::format("{} {}", text::shown(at.text), wrong), expected);
  }
  [[noreturn]] void fail_absent(const PatchPointer& at) const {
    fail(at, "is not there", "expected a pointer to what the document has");
  }

  static std::string_view key_of(const rapidjson::Pointer::Token& token) { return {token.name, token.length}; }

  /// The value that the first tokens of the pointer lead to.
  JsonValue& existing(const PatchPointer& at, Tokens tokens) const {
    JsonValue* value = &root_;
    for (const rapidjson::Pointer::Token& token : tokens) {
      auto* const items = std::get_if<JsonItems>(&value->of);
      if (items == nullptr)
        value = value->member(key_of(token));
      else
        value = token.index < items->size() ? &(*items)[token.index] : nullptr;
      if (value == nullptr) fail_absent(at);
    }
    return *value;
  }
  JsonValue& existing(const PatchPointer& at) const { return existing(at, at.tokens()); }

  /// Brackets do not stand deeper than they may in what is put in at a pointer.
  void require_depth(const PatchPointer& at, const JsonValue& value) const {
    if (at.tokens().size() + extent_of(value).depth > deepest_brackets)
      fail(at, "would stand too deep", "expected no more brackets than a scene has");
  }

  JsonValue copy(const PatchPointer& to, const PatchPointer& from) {
    const JsonValue& value = existing(from);
    require_depth(to, value);
    copied_ += extent_of(value).values;
    if (copied_ > most_copied)
      fail(to, "would be too much", fmt::format("expected {} copied values in all", most_copied));
    return value;
  }

  void add(const PatchPointer& at, JsonValue value) {
    const Tokens tokens = at.tokens();
    if (tokens.empty()) {
      root_ = std::move(value);
      return;
    }
    JsonValue& holder = existing(at, tokens.first(tokens.size() - 1));
    const std::string_view key = key_of(tokens.back());
    if (auto* const items = std::get_if<JsonItems>(&holder.of)) {
      const std::size_t place = key == "-" ? items->size() : tokens.back().index;
      if (place > items->size()) fail_absent(at);
      items->insert(items->begin() + static_cast<std::ptrdiff_t>(place), std::move(value));
    } else if (JsonValue* const member = holder.member(key)) {
      *member = std::move(value);
    } else if (auto* const members = std::get_if<JsonMembers>(&holder.of)) {
      members->push_back({std::string(key), std::move(value)});
    } else {
      fail_absent(at);
    }
  }

  JsonValue take(const PatchPointer& at) {
    const Tokens tokens = at.tokens();
    if (tokens.empty()) fail(at, "is the whole document", "expected a pointer to a part of it");
    JsonValue taken = std::move(existing(at));
    JsonValue& holder = existing(at, tokens.first(tokens.size() - 1));
    if (auto* const items = std::get_if<JsonItems>(&holder.of))
      items->erase(items->begin() + static_cast<std::ptrdiff_t>(tokens.back().index));
    else
      std::erase_if(std::get<JsonMembers>(holder.of),
                    [&](const JsonMember& member) { return member.key == key_of(tokens.back()); });
    return taken;
  }

  const Source& patch_;
  JsonValue& root_;
  std::size_t copied_ = 0;
};

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

void apply_patch(const Source& patch, JsonValue& value) {
  PatchRun run(patch, value);
  for (PatchOperation& operation : PatchReader(patch).read()) run.apply(operation);
}

std::string patch_between(const JsonValue& from, const JsonValue& to) {
  std::string text = "[";
  if (from != to) {
    for (const std::string& line : difference("", from, to)) text += (text.size() == 1 ? "\n" : ",\n") + line;
    text += "\n";
  }
  return text + "]\n";
}

}  // namespace durero::io::json
