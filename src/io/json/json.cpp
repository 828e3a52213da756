#include "durero/io/json/json.hpp"

#include <fmt/format.h>
#include <rapidjson/error/en.h>
#include <rapidjson/reader.h>

#include <algorithm>

#include "durero/io/number_text.hpp"
#include "durero/text/nearest.hpp"
#include "durero/text/shown.hpp"
#include "durero/text/spanish.hpp"
#include "durero/text/utf8.hpp"
#include "json_stream.hpp"

namespace durero::io::json {
namespace {

// What is wrong, and what is expected, in the words of this program.
std::pair<std::string, std::string> explain(rapidjson::ParseErrorCode code, std::string_view rest) {
  const std::string here = rest.empty() ? "the text ends" : text::shown(text::first(rest)) + " stands here";
  switch (code) {
    case rapidjson::kParseErrorDocumentEmpty:
      return {"the text is empty", "expected a JSON value"};
    case rapidjson::kParseErrorDocumentRootNotSingular:
      return {here + " after the value", "expected the end of the text"};
    case rapidjson::kParseErrorValueInvalid:
      return {here, "expected a JSON value: object, array, string, finite number, true, false or null"};
    case rapidjson::kParseErrorObjectMissName:
      return {here, "expected a key in quotes or }"};
    case rapidjson::kParseErrorObjectMissColon:
      return {here, "expected : after a key"};
    case rapidjson::kParseErrorObjectMissCommaOrCurlyBracket:
      return {here, "expected , or } after a member"};
    case rapidjson::kParseErrorArrayMissCommaOrSquareBracket:
      return {here, "expected , or ] after an item"};
    case rapidjson::kParseErrorStringMissQuotationMark:
      return {here + " inside a string", "expected its closing quote"};
    case rapidjson::kParseErrorStringEscapeInvalid:
    case rapidjson::kParseErrorStringUnicodeEscapeInvalidHex:
    case rapidjson::kParseErrorStringUnicodeSurrogateInvalid:
      return {here + " inside a string", "expected no control character, and escapes that JSON has"};
    case rapidjson::kParseErrorStringInvalidEncoding:
      return {here + " inside a string", "expected UTF-8 without control characters"};
    case rapidjson::kParseErrorNumberMissFraction:
    case rapidjson::kParseErrorNumberMissExponent:
      return {here + " in a number", "expected a digit"};
    default:
      return {rapidjson::GetParseError_En(code), "expected JSON"};
  }
}

}  // namespace

// Receives RapidJSON's events and notes where each token starts. The stream stands on the bracket at an opening or
// closing one, and behind the token at every other.
struct Recorder {
  Document& document;
  const Stream& stream;

  bool Null() { return add(TokenKind::null, tell() - 4); }
  bool Bool(bool value) { return add(TokenKind::boolean, tell() - (value ? 4U : 5U)); }
  bool RawNumber(const char*, rapidjson::SizeType, bool) {
    std::size_t start = tell();
    const std::string_view text = document.source_->text();
    while (start > base() && is_number_byte(text[start - 1])) --start;
    return add(TokenKind::number, start);
  }
  bool String(const char* value, rapidjson::SizeType length, bool) {
    return text_token(TokenKind::string, {value, length});
  }
  bool Key(const char* value, rapidjson::SizeType length, bool) { return text_token(TokenKind::key, {value, length}); }
  bool StartObject() { return add(TokenKind::object, tell()); }
  bool EndObject(rapidjson::SizeType) { return add(TokenKind::end_object, tell()); }
  bool StartArray() { return add(TokenKind::array, tell()); }
  bool EndArray(rapidjson::SizeType) { return add(TokenKind::end_array, tell()); }
  // Numbers arrive raw only.
  bool Int(int) { return false; }
  bool Uint(unsigned) { return false; }
  bool Int64(std::int64_t) { return false; }
  bool Uint64(std::uint64_t) { return false; }
  bool Double(double) { return false; }

 private:
  std::size_t base() const { return static_cast<std::size_t>(stream.begin - document.source_->text().data()); }
  std::size_t tell() const { return base() + stream.Tell(); }

  bool add(TokenKind kind, std::size_t offset) {
    document.tokens_.push_back(Document::token(offset, kind));
    return true;
  }

  // The opening quote of a string that ends here. An escape is longer than what it stands for, so where the string as
  // read is as long as the string as written there is none; otherwise the opening quote is the nearest one before that
  // no backslash, or an even number of them, precedes.
  bool text_token(TokenKind kind, std::string_view value) {
    const std::string_view text = document.source_->text();
    const std::size_t closing = tell() - 1;
    std::size_t opening = closing - value.size() - 1;
    if (text[opening] == '"' && !escaped(text, opening)) return add(kind, opening);
    for (opening = closing - 1; text[opening] != '"' || escaped(text, opening); --opening) {
    }
    document.unescaped_.emplace(opening, value);
    return add(kind, opening);
  }

  static bool escaped(std::string_view text, std::size_t at) {
    std::size_t first = at;
    while (first > 0 && text[first - 1] == '\\') --first;
    return (at - first) % 2 == 1;
  }
};

Document::Document(const Source& source, std::size_t begin, std::size_t end) : source_(&source), end_(end) {
  const std::string_view text = source.text().substr(begin, end - begin);
  if (text.starts_with("\xEF\xBB\xBF")) source.fail(begin, "a byte order mark", "expected UTF-8 without one");
  constexpr unsigned flags =
      rapidjson::kParseIterativeFlag | rapidjson::kParseValidateEncodingFlag | rapidjson::kParseNumbersAsStringsFlag;
  Stream stream{text.data(), text.data(), text.data() + text.size()};
  Recorder recorder{*this, stream};
  rapidjson::Reader parser;
  const rapidjson::ParseResult result = parser.Parse<flags>(stream, recorder);
  if (result.IsError()) {
    const auto [wrong, expected] = explain(result.Code(), text.substr(std::min(result.Offset(), text.size())));
    source.fail(begin + std::min(result.Offset(), text.size()), wrong, expected);
  }
  if (stream.next != stream.end) source.fail(begin + stream.Tell(), "a NUL byte", "expected the end of the text");
  tokens_.push_back(token(end, TokenKind::end));
}

std::string_view Document::number_text(Token token) const {
  const std::string_view rest = source_->text().substr(token.offset, end_ - token.offset);
  std::size_t length = 0;
  while (length < rest.size() && is_number_byte(rest[length])) ++length;
  return rest.substr(0, length);
}

std::string_view Document::string_value(Token token) const {
  if (!unescaped_.empty()) {
    if (const auto found = unescaped_.find(token.offset); found != unescaped_.end()) return found->second;
  }
  const std::size_t first = token.offset + 1;
  return source_->text().substr(first, source_->text().find('"', first) - first);
}

double Reader::number(std::string_view what) {
  if (kind() != TokenKind::number) wrong_kind(what, "a number");
  const std::string_view text = document_->number_text(token());
  const auto value = read_finite(text);
  if (!value) {
    fail(offset(), fmt::format("{} is {}, beyond binary64", text::with_english(what), text::shown(text)),
         "expected a finite number");
  }
  ++next_;
  return *value;
}

double Reader::extended_number(std::string_view what) {
  if (kind() != TokenKind::string) return number(what);
  const std::size_t at = offset();
  const std::string_view text = string(what);
  for (const std::string_view known : {"inf", "-inf", "nan"}) {
    if (text == known) return *read_number(text);
  }
  fail(at, fmt::format("{} is {}", what, text::shown(text)), "expected a number, \"inf\" or \"-inf\"");
}

std::string_view Reader::string(std::string_view what) {
  if (kind() != TokenKind::string) wrong_kind(what, "a string");
  return document_->string_value(document_->tokens()[next_++]);
}

void Reader::skip() {
  std::size_t depth = 0;
  do {
    const TokenKind passed = kind();
    ++next_;
    depth += passed == TokenKind::array || passed == TokenKind::object;
    depth -= passed == TokenKind::end_array || passed == TokenKind::end_object;
  } while (depth > 0);
}

std::optional<Reader> Reader::member(std::string_view name) const {
  if (kind() != TokenKind::object) return std::nullopt;
  Reader ahead = *this;
  ++ahead.next_;
  while (ahead.kind() != TokenKind::end_object) {
    if (ahead.take_key().name == name) return ahead;
    ahead.skip();
  }
  return std::nullopt;
}

bool Reader::boolean(std::string_view what) {
  if (kind() != TokenKind::boolean) wrong_kind(what, "true or false");
  return document_->source().text()[document_->tokens()[next_++].offset] == 't';
}

void Reader::require_less_than_three(std::string_view what, std::size_t count, const char* expected) const {
  if (count == 3) fail(offset(), fmt::format("{} has a fourth item", text::with_english(what)), expected);
}

void Reader::require_three(std::string_view what, std::size_t count, std::size_t at, const char* expected) const {
  if (count != 3) fail(at, fmt::format("{} has {} items", text::with_english(what), count), expected);
}

void Reader::open(TokenKind wanted, std::string_view what) {
  if (kind() != wanted) wrong_kind(what, wanted == TokenKind::array ? "an array" : "an object");
  ++next_;
}

void Reader::wrong_kind(std::string_view what, std::string_view expected) const {
  constexpr std::string_view names[] = {"null", "true or false", "a number", "a string", "a key", "an object",
                                        "}",    "an array",      "]",        "missing"};
  fail(offset(), fmt::format("{} is {}", text::with_english(what), names[static_cast<int>(kind())]),
       fmt::format("expected {}", expected));
}

Key Reader::take_key() {
  const Document::Token key = document_->tokens()[next_++];
  key_offset_ = key.offset;
  return {document_->string_value(key), key_offset_};
}

std::size_t Reader::known_key(std::string_view what, std::span<const std::string_view> keys, const Key& key,
                              std::uint64_t& seen) const {
  std::size_t i = 0;
  while (i < keys.size() && keys[i] != key.name) ++i;
  if (i == keys.size()) {
    fail(key.offset, fmt::format("unknown key {} in {}", text::shown(key.name), what),
         "expected " + text::expected_of(key.name, {keys.begin(), keys.end()}));
  }
  if ((seen >> i & 1U) != 0)
    fail(key.offset, fmt::format("key {}{} stands twice", text::shown(key.name), text::english_beside(key.name)),
         "expected it once");
  seen |= std::uint64_t{1} << i;
  return i;
}

void Reader::require(std::string_view what, std::span<const std::string_view> keys, std::size_t required,
                     std::uint64_t seen, std::size_t at) const {
  for (std::size_t i = 0; i < required; ++i) {
    if ((seen >> i & 1U) == 0)
      fail(at, fmt::format("key \"{}\"{} is missing in {}", keys[i], text::english_beside(keys[i]), what),
           "expected it");
  }
}

}  // namespace durero::io::json
