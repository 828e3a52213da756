#include "lsp/rpc.hpp"

#include <fmt/format.h>

#include "durero/text/utf8.hpp"

namespace durero::lsp {
namespace {

[[noreturn]] void refuse_member(const char* name, const char* expected) {
  throw RpcError(ErrorCode::invalid_params, fmt::format("{} is missing or wrong; expected {}", name, expected));
}

}  // namespace

const JsonValue* find_member(const JsonValue& of, const char* name) {
  if (!of.IsObject()) return nullptr;
  const auto at = of.FindMember(name);
  return at == of.MemberEnd() ? nullptr : &at->value;
}

const JsonValue& member(const JsonValue& of, const char* name) {
  const JsonValue* found = find_member(of, name);
  if (!found) refuse_member(name, "a member of this name");
  return *found;
}

std::string text_member(const JsonValue& of, const char* name) {
  const JsonValue& found = member(of, name);
  if (!found.IsString()) refuse_member(name, "a string");
  return {found.GetString(), found.GetStringLength()};
}

std::uint32_t count_member(const JsonValue& of, const char* name) {
  const JsonValue& found = member(of, name);
  if (!found.IsUint()) refuse_member(name, "a whole number that is not negative");
  return found.GetUint();
}

const JsonValue& array_member(const JsonValue& of, const char* name) {
  const JsonValue& found = member(of, name);
  if (!found.IsArray()) refuse_member(name, "an array");
  return found;
}

void put(JsonWriter& to, std::string_view text) {
  std::string plain;
  plain.reserve(text.size());
  while (!text.empty()) {
    const auto character = text::decode(text);
    plain += character ? text.substr(0, character->length) : "\uFFFD";
    text.remove_prefix(character ? character->length : 1);
  }
  to.String(plain.data(), static_cast<rapidjson::SizeType>(plain.size()));
}

void put(JsonWriter& to, const char* key, std::string_view text) {
  to.Key(key);
  put(to, text);
}

void put(JsonWriter& to, const char* key, std::int64_t number) {
  to.Key(key);
  to.Int64(number);
}

}  // namespace durero::lsp
