#include "json_patch.hpp"

#include <fmt/format.h>
#include <rapidjson/pointer.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>

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

using Tokens = std::span<const rapidjson::Pointer::Token>;

/// The value that the tokens lead to; null where there is none.
JsonValue* find(JsonValue& root, Tokens tokens) {
  JsonValue* value = &root;
  for (const rapidjson::Pointer::Token& token : tokens) {
    if (auto* const items = std::get_if<JsonItems>(&value->of))
      value = token.index < items->size() ? &(*items)[token.index] : nullptr;
    else
      value = value->member({token.name, token.length});
    if (value == nullptr) return nullptr;
  }
  return value;
}

struct PatchOperation {
  std::size_t offset;  // of its opening bracket
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
    PatchOperation read{.offset = at, .word = {}};
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
        existing(path).of = std::move(operation.value->of);
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
  [[noreturn]] void fail(const PatchPointer& at, std::string_view wrong, const std::string& expected) const {
    patch_.fail(at.offset, fmt::format("{} {}", text::shown(at.text), wrong), expected);
  }
  [[noreturn]] void fail_absent(const PatchPointer& at) const {
    fail(at, "is not there", "expected a pointer to what the document has");
  }

  static std::string_view key_of(const rapidjson::Pointer::Token& token) { return {token.name, token.length}; }

  /// The value that the first tokens of the pointer lead to.
  JsonValue& existing(const PatchPointer& at, Tokens tokens) const {
    JsonValue* const value = find(root_, tokens);
    if (value == nullptr) fail_absent(at);
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

}  // namespace

JsonValue* find(JsonValue& root, std::string_view pointer) {
  const rapidjson::Pointer parsed(pointer.data(), pointer.size());
  return parsed.IsValid() ? find(root, Tokens{parsed.GetTokens(), parsed.GetTokenCount()}) : nullptr;
}

std::vector<std::size_t> apply_patch(const Source& patch, JsonValue& value) {
  PatchRun run(patch, value);
  std::vector<std::size_t> offsets;
  for (PatchOperation& operation : PatchReader(patch).read()) {
    offsets.push_back(operation.offset);
    run.apply(operation);
  }
  return offsets;
}

}  // namespace durero::io::json
