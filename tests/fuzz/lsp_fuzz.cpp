/// libFuzzer's entry to the language server: `lsp_fuzz tests/fuzz/seeds/lsp`. Each line of the input is a message.

#include <rapidjson/document.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "durero/lsp/language_server.hpp"
#include "fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  durero::lsp::LanguageServer server("0", [](const std::string&) { return std::map<std::string, std::string>(); });
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  while (!rest.empty() && !server.is_over()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    server.take(line);
    while (server.has_work()) server.step();
    for (const std::string& message : server.sent()) {
      rapidjson::Document read;
      read.Parse<rapidjson::kParseIterativeFlag | rapidjson::kParseValidateEncodingFlag>(message.c_str());
      durero::test::must(!read.HasParseError());
    }
  }
  return 0;
}
