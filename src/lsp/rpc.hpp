#pragma once
/// JSON-RPC 2.0: errors, and the members of what a client sends.

#include <rapidjson/document.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace durero::lsp {

using JsonValue = rapidjson::Value;
using JsonWriter = rapidjson::Writer<rapidjson::StringBuffer>;

/// The codes of JSON-RPC and of the Language Server Protocol.
enum class ErrorCode : std::int32_t {
  parse_error = -32700,
  invalid_request = -32600,
  method_not_found = -32601,
  invalid_params = -32602,
  internal_error = -32603,
  server_not_initialized = -32002,
  request_cancelled = -32800,
  request_failed = -32803,
};

/// The error of a message that cannot be answered otherwise.
class RpcError : public std::runtime_error {
 public:
  RpcError(ErrorCode the_code, const std::string& message) : std::runtime_error(message), code(the_code) {}
  ErrorCode code;
};

/// @{ Return a member of an object. Throw RpcError (invalid_params) where it is missing or of another kind.
const JsonValue& member(const JsonValue& of, const char* name);
std::string text_member(const JsonValue& of, const char* name);
std::uint32_t count_member(const JsonValue& of, const char* name);
const JsonValue& array_member(const JsonValue& of, const char* name);
/// @}
/// Returns a member, or null where there is none or no object.
const JsonValue* find_member(const JsonValue& of, const char* name);
/// Follows members from an object on, and returns the last; null where one is missing.
template <class... Names>
const JsonValue* find_member(const JsonValue& of, const char* name, Names... more) {
  const JsonValue* next = find_member(of, name);
  return next ? find_member(*next, more...) : nullptr;
}

/// Writes a string; bytes that are no UTF-8 become U+FFFD, as JSON has no other bytes.
void put(JsonWriter& to, std::string_view text);
/// Writes a key and a string.
void put(JsonWriter& to, const char* key, std::string_view text);
/// Writes a key and a whole number.
void put(JsonWriter& to, const char* key, std::int64_t number);

}  // namespace durero::lsp
