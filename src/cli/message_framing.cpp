#include "message_framing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "durero/io/source.hpp"

namespace durero::cli {
namespace {

constexpr std::string_view line_end = "\r\n", length_name = "content-length";

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

}  // namespace

void MessageFraming::add(std::string_view bytes) {
  lines_ +=
      static_cast<std::size_t>(std::count(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(from_), '\n'));
  bytes_.erase(0, from_);
  from_ = 0;
  bytes_ += bytes;
}

void MessageFraming::refuse(std::size_t at, const std::string& what, const char* expected) const {
  const auto before = std::string_view(bytes_).substr(0, from_ + at);
  const std::size_t line = lines_ + static_cast<std::size_t>(std::ranges::count(before, '\n')) + 1;
  throw io::InputError("<stdin>", {line, 1}, what, expected);
}

/// Returns the number that the headers count, which end in line ends of their own.
std::size_t MessageFraming::length_in(std::string_view headers) const {
  std::optional<std::size_t> length;
  for (std::size_t at = 0; at < headers.size();) {
    const std::size_t end = headers.find(line_end, at);
    const std::string_view line = headers.substr(at, end - at);
    const std::size_t colon = line.find(':');
    if (colon == line.npos) refuse(at, "this is no header", "expected NAME: VALUE");
    if (in_lower_case(line.substr(0, colon)) == length_name) {
      const std::string_view digits = without_blanks(line.substr(colon + 1));
      std::size_t count = 0;
      const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
      if (error != std::errc() || stop != digits.data() + digits.size() || length)
        refuse(at, "Content-Length is wrong", "expected it once, a whole number of bytes");
      if (count > most_message) refuse(at, fmt::format("a message of {} bytes", count), "expected at most 16 MiB");
      length = count;
    }
    at = end + line_end.size();
  }
  if (!length) refuse(0, "there is no Content-Length", "expected it among the headers of a message");
  return *length;
}

std::optional<std::string> MessageFraming::next() {
  const std::string_view rest = std::string_view(bytes_).substr(from_);
  const std::size_t end = rest.substr(0, most_header).find("\r\n\r\n");
  if (end == rest.npos) {
    if (rest.size() >= most_header) refuse(0, "the headers do not end", "expected an empty line behind them");
    return std::nullopt;
  }
  const std::size_t begin = end + 2 * line_end.size();
  const std::size_t length = length_in(rest.substr(0, end + line_end.size()));
  if (rest.size() - begin < length) return std::nullopt;
  from_ += begin + length;
  return std::string(rest.substr(begin, length));
}

std::string framed(std::string_view message) {
  return fmt::format("Content-Length: {}\r\n\r\n{}", message.size(), message);
}

}  // namespace durero::cli
