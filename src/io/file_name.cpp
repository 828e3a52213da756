#include "durero/io/file_name.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "durero/io/source.hpp"
#include "durero/text/shown.hpp"

namespace durero::io {

bool ends_in(std::string_view path, std::string_view ending) noexcept {
  const auto small = [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return path.size() >= ending.size() &&
         std::ranges::equal(path.substr(path.size() - ending.size()), ending, {}, small);
}

std::string_view ending_of(std::string_view path) noexcept {
  const std::string_view name = path.substr(path.rfind('/') + 1);
  const std::size_t dot = name.rfind('.');
  return dot == name.npos || dot == 0 || dot + 1 == name.size() ? std::string_view() : name.substr(dot);
}

void require_ending(const std::string& path, std::span<const std::string_view> endings, std::string_view what) {
  const std::string_view ending = ending_of(path);
  if (ending.empty()) return;
  for (const std::string_view known : endings)
    if (ends_in(ending, known)) return;
  throw FileError(path, fmt::format("{} is no ending of {}", text::shown(ending), what),
                  fmt::format("expected a name that ends in {}, or has no ending", fmt::join(endings, " or ")));
}

}  // namespace durero::io
