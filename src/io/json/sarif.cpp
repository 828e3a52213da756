#include "durero/io/json/sarif.hpp"

#include <fmt/format.h>

namespace durero::io {

void begin_sarif(json::Writer& out, std::string_view tool, std::span<const SarifRule> rules) {
  out.begin_object().member("$schema", "https://json.schemastore.org/sarif-2.1.0.json").member("version", "2.1.0");
  out.new_line().key("runs").begin_array().begin_object().key("tool").begin_object().key("driver").begin_object();
  out.member("name", tool).key("rules").begin_array();
  for (const SarifRule& rule : rules) {
    out.new_line().begin_object().member("id", rule.id);
    write_sarif_message(out, "shortDescription", rule.description);
    out.end_object();
  }
  out.end_array().end_object().end_object().new_line();
}

void end_sarif(json::Writer& out) { out.end_array().end_object().end_array().end_object(); }

void write_sarif_message(json::Writer& out, std::string_view key, std::string_view text) {
  out.key(key).begin_object().member("text", text).end_object();
}

std::string sarif_uri(std::string_view file) {
  std::string uri = file.starts_with('/') ? "file://" : "";
  for (const char c : file) {
    const bool is_plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    if (is_plain || std::string_view("-._~/").find(c) != std::string_view::npos) {
      uri += c;
    } else {
      uri += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return uri;
}

}  // namespace durero::io
