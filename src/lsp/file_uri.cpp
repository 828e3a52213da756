#include "lsp/file_uri.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>

namespace durero::lsp {
namespace {

constexpr std::string_view scheme = "file://";

std::string without_escapes(std::string_view text) {
  std::string plain;
  for (std::size_t at = 0; at < text.size(); ++at) {
    unsigned code = 0;
    const char* digits = text.data() + at + 1;
    const bool escaped = text[at] == '%' && at + 2 < text.size();
    if (escaped && std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
      plain += static_cast<char>(static_cast<unsigned char>(code));
      at += 2;
    } else {
      plain += text[at];
    }
  }
  return plain;
}

bool stands_plainly(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("-._~/").find(c) != std::string_view::npos;
}

}  // namespace

std::string path_of_uri(std::string_view uri) {
  if (!uri.starts_with(scheme)) return std::string(uri);
  std::string_view path = uri.substr(scheme.size());
  path.remove_prefix(std::min(path.find('/'), path.size()));  // the host is this machine
  return std::filesystem::path(without_escapes(path)).lexically_normal().string();
}

std::string uri_of_path(std::string_view path) {
  std::string uri(scheme);
  for (const char c : path) {
    if (stands_plainly(c)) {
      uri += c;
    } else {
      uri += fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    }
  }
  return uri;
}

}  // namespace durero::lsp
