#pragma once
/// JSON with places. RapidJSON parses the text into a flat list of tokens (8 bytes each: kind and offset), and a Reader
/// walks the list by the schema of the caller, so that an error of meaning has the place of its value or key just as an
/// error of syntax has. No recursion anywhere: nesting costs memory only.
///
/// Why not RapidJSON's document: it forgets the places. Why not its events directly: a schema in an event handler is a
/// hand-made state machine; walked from a list it reads like the schema.
///
/// Numbers are read from the text to the nearest binary64 (number_text.hpp), as every reader here does, however many
/// digits they have. RapidJSON has an arithmetic of its own and refuses what that cannot hold; so it never sees them.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/source.hpp"

namespace durero::io::json {

/// What a token is: a value; `key`, of an object; `object` and `array`, an opening bracket, and its closing one; `end`,
/// behind the last.
enum class TokenKind : std::uint8_t { null, boolean, number, string, key, object, end_object, array, end_array, end };

/// One JSON text, checked: its tokens in order, then one of kind `end`.
class Document {
 public:
  /// Parses the bytes [begin, end) of the source as one JSON value; the source must outlive it.
  /// Throws InputError.
  Document(const Source& source, std::size_t begin, std::size_t end);
  /// Parses the whole source, which must outlive it, as one JSON value. Throws InputError.
  explicit Document(const Source& source) : Document(source, 0, source.text().size()) {}

  /// Where a piece of the text begins, and what it is.
  struct Token {
    std::uint64_t offset : 56;  ///< its first byte in the source: of a string or key, the opening quote
    TokenKind kind : 8;         ///< says whether it has a number_text(), a string_value() or neither
  };

  /// What it was parsed from.
  const Source& source() const noexcept { return *source_; }
  /// In the order of the text; at least a value and `end`.
  const std::vector<Token>& tokens() const noexcept { return tokens_; }
  /// The text of a number token.
  std::string_view number_text(Token token) const;
  /// The value of a string or key token; valid as long as the document and its source.
  std::string_view string_value(Token token) const;

 private:
  friend struct Recorder;
  static Token token(std::size_t offset, TokenKind kind) { return {offset & ((std::uint64_t{1} << 56U) - 1), kind}; }

  const Source* source_;
  std::size_t end_;
  std::vector<Token> tokens_;
  std::map<std::size_t, std::string> unescaped_;  // by offset: the strings that are written with escapes
};

/// A key of an object.
struct Key {
  std::string_view name;  ///< without quotes and escapes; valid as long as the document and its source
  std::size_t offset;     ///< of its opening quote in the source
};

/// Walks a document from its first token to its last. Every member throws InputError at the place of the token.
class Reader {
 public:
  /// Stands on the first token. The document must outlive it.
  explicit Reader(const Document& document) : document_(&document) {}

  /// Of the token that stands here; `end` behind the last value.
  TokenKind kind() const { return token().kind; }
  /// Of what an array or an object begins with. Precondition: one stands here.
  TokenKind kind_of_first_item() const { return document_->tokens()[next_ + 1].kind; }
  /// Which byte of the source the token that stands here begins at.
  std::size_t offset() const { return token().offset; }
  /// Where the last key that was read stands.
  std::size_t key_offset() const { return key_offset_; }

  /// A finite number. `what` names the value in messages.
  double number(std::string_view what);
  /// A number, or the string "inf", "-inf" or "nan", which stand for what JSON has no number for.
  double extended_number(std::string_view what);
  /// A string, its escapes read; valid as long as the document and its source.
  std::string_view string(std::string_view what);
  /// One of the words true and false.
  bool boolean(std::string_view what);
  /// An array of three finite numbers.
  glm::dvec3 vec3(std::string_view what) {
    return triple(what, [&] { return number(what); });
  }
  /// An array of three arrays of three finite numbers.
  std::array<glm::dvec3, 3> three_points(std::string_view what) {
    return three<glm::dvec3>(what, "expected three points", [&] { return vec3(what); });
  }

  /// An array of three numbers, each what item() reads.
  template <class Item>
  glm::dvec3 triple(std::string_view what, Item&& item) {
    const auto v = three<double>(what, "expected three numbers", item);
    return {v[0], v[1], v[2]};
  }
  /// An array of three items, each what item() reads; where there are more or fewer, the message ends with `expected`.
  template <class Value, class Item>
  std::array<Value, 3> three(std::string_view what, const char* expected, Item&& item) {
    const std::size_t at = offset();
    std::array<Value, 3> values{};
    std::size_t count = 0;
    array(what, [&] {
      require_less_than_three(what, count, expected);
      values[count++] = item();
    });
    require_three(what, count, at, expected);
    return values;
  }

  /// Calls item() for each item of an array; it must read exactly one value.
  template <class Item>
  void array(std::string_view what, Item&& item) {
    open(TokenKind::array, what);
    while (kind() != TokenKind::end_array) item();
    ++next_;
  }

  /// Calls member(Key) for each member of an object whose keys are free; it must read exactly one value.
  template <class Member>
  void members(std::string_view what, Member&& member) {
    open(TokenKind::object, what);
    while (kind() != TokenKind::end_object) member(take_key());
    ++next_;
  }

  /// Calls member(i) for each member of an object with the given keys (64 at most), i the key's place among them. A key
  /// that is not among them, or stands twice, is an error at the key; a required one (the first `required` are) that is
  /// missing is an error at the object.
  template <class Member>
  void object(std::string_view what, std::span<const std::string_view> keys, std::size_t required, Member&& member) {
    const std::size_t at = offset();
    std::uint64_t seen = 0;
    members(what, [&](const Key& key) { member(known_key(what, keys, key, seen)); });
    require(what, keys, required, seen, at);
  }

  /// Passes a value, whatever it is.
  void skip();

  /// A reader that stands on the value of the first member of that name; nothing where there is none, or where no
  /// object stands here. This one stays where it is.
  std::optional<Reader> member(std::string_view name) const;

  /// Throws InputError at that byte of the source, with the clause that is broken, if one is.
  [[noreturn]] void fail(std::size_t offset, const std::string& wrong, const std::string& expected,
                         const contract::clause* broken = nullptr) const {
    document_->source().fail(offset, wrong, expected, broken);
  }

 private:
  Document::Token token() const { return document_->tokens()[next_]; }
  void open(TokenKind kind, std::string_view what);
  void require_less_than_three(std::string_view what, std::size_t count, const char* expected) const;
  void require_three(std::string_view what, std::size_t count, std::size_t at, const char* expected) const;
  [[noreturn]] void wrong_kind(std::string_view what, std::string_view expected) const;
  Key take_key();
  std::size_t known_key(std::string_view what, std::span<const std::string_view> keys, const Key& key,
                        std::uint64_t& seen) const;
  void require(std::string_view what, std::span<const std::string_view> keys, std::size_t required, std::uint64_t seen,
               std::size_t at) const;

  const Document* document_;
  std::size_t next_ = 0;
  std::size_t key_offset_ = 0;
};

}  // namespace durero::io::json
