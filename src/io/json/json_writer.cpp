#include "durero/io/json/json_writer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "durero/io/number_text.hpp"

namespace durero::io::json {
namespace {

void append_quoted(std::string& out, std::string_view text) {
  out += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += {'\\', c};
    } else if (static_cast<unsigned char>(c) < 0x20) {
      fmt::format_to(std::back_inserter(out), "\\u{:04x}", static_cast<unsigned>(c));
    } else {
      out += c;
    }
  }
  out += '"';
}

}  // namespace

void Writer::separate() {
  if (comma_) *out_ += ',';
  if (line_) *out_ += '\n';
  comma_ = line_ = false;
}

Writer& Writer::key(std::string_view name) {
  separate();
  append_quoted(*out_, name);
  *out_ += ':';
  return *this;
}

Writer& Writer::new_line() {
  line_ = true;
  return *this;
}

Writer& Writer::begin(char bracket) {
  separate();
  *out_ += bracket;
  return *this;
}

Writer& Writer::end(char bracket) {
  comma_ = false;  // none stands before an end
  return raw({&bracket, 1});
}

Writer& Writer::raw(std::string_view text) {
  separate();
  *out_ += text;
  comma_ = true;
  return *this;
}

Writer& Writer::value(std::string_view text) {
  separate();
  append_quoted(*out_, text);
  comma_ = true;
  return *this;
}

Writer& Writer::value(std::uint64_t number) { return raw(fmt::format_int(number).c_str()); }

Writer& Writer::value(double number) {
  if (std::isnan(number)) return value("nan");
  if (std::isinf(number)) return value(number > 0 ? "inf" : "-inf");
  separate();
  append_number(*out_, number);
  comma_ = true;
  return *this;
}

Writer& Writer::value(const glm::dvec3& triple) {
  return begin_array().value(triple.x).value(triple.y).value(triple.z).end_array();
}

Writer& Writer::value(const std::array<glm::dvec3, 3>& triples) {
  begin_array();
  for (const glm::dvec3& triple : triples) value(triple);
  return end_array();
}

}  // namespace durero::io::json
