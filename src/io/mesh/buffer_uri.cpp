#include "buffer_uri.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <system_error>

#include "durero/text/file.hpp"
#include "durero/text/shown.hpp"
#include "io/byte_order.hpp"
#include "io/scene_folder.hpp"

namespace durero::io {
namespace {

constexpr std::string_view base64_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Nothing where a character is no digit, or they are one too many for whole bytes.
std::optional<std::string> base64_bytes(std::string_view digits) {
  for (int padding = 0; padding < 2 && digits.ends_with('='); ++padding) digits.remove_suffix(1);
  if (digits.size() % 4 == 1) return std::nullopt;
  std::string bytes;
  bytes.reserve(digits.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int count = 0;  // of the bits that are no byte yet
  for (const char digit : digits) {
    const std::size_t value = base64_digits.find(digit);
    if (value == base64_digits.npos) return std::nullopt;
    bits = bits << 6U | static_cast<std::uint32_t>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xffU);
  }
  return bytes;
}

std::optional<int> hexadecimal(char c) {
  if ('0' <= c && c <= '9') return c - '0';
  const char small = static_cast<char>(c | 0x20);
  return 'a' <= small && small <= 'f' ? std::optional(small - 'a' + 10) : std::nullopt;
}

/// The text with the bytes that `%20` and its like stand for. Nothing where a `%` stands before anything else.
std::optional<std::string> percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    const auto high = i + 2 < text.size() ? hexadecimal(text[i + 1]) : std::nullopt;
    const auto low = i + 2 < text.size() ? hexadecimal(text[i + 2]) : std::nullopt;
    if (!high || !low) return std::nullopt;
    decoded += static_cast<char>(*high * 16 + *low);
    i += 2;
  }
  return decoded;
}

/// Whether a URI begins with a scheme, such as `http:`.
bool has_scheme(std::string_view uri) { return uri.find(':') < uri.find_first_of("/?#"); }

}  // namespace

std::string buffer_bytes(const Source& source, std::string_view uri, std::size_t at, std::size_t most) {
  constexpr std::string_view base64 = ";base64";
  if (uri.starts_with("data:")) {
    const std::string_view type = uri.substr(0, uri.find(','));
    auto bytes =
        type.ends_with(base64) && type.size() < uri.size() ? base64_bytes(uri.substr(type.size() + 1)) : std::nullopt;
    if (!bytes) source.fail(at, fmt::format("uri is {}", text::shown(uri)), "expected bytes in base64 behind data:");
    return std::move(*bytes);
  }
  const auto name = percent_decoded(uri);
  const SceneFolder folder(source);
  const auto path = has_scheme(uri) || !name ? std::nullopt : folder.path(source, *name);
  if (!path) source.fail(at, fmt::format("uri is {}", text::shown(uri)), folder.expected() + ", or data:");
  try {
    return text::read_file(*path, most);
  } catch (const std::system_error& error) {
    source.fail(at, fmt::format("uri is {}: {}", text::shown(uri), error.code().message()), "expected a readable file");
  }
}

std::string base64_text(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t here = std::min<std::size_t>(3, bytes.size() - i);
    const std::uint64_t three = big_endian(bytes.substr(i, here)) << 8 * (3 - here);
    for (std::size_t k = 0; k < 4; ++k) text += k <= here ? base64_digits[three >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

}  // namespace durero::io
