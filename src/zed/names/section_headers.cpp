#include "durero/zed/names/section_headers.hpp"

#include "zed/syntax/block_parser.hpp"
#include "zed/syntax/lexer.hpp"

namespace durero::zed {

std::vector<std::pair<std::string, std::vector<std::string>>> section_headers(std::string_view text) {
  std::vector<std::pair<std::string, std::vector<std::string>>> headers;
  std::vector<Defect> defects;  // the reader reports them
  for (const Block& block : cut(text, {}, defects)) {
    if (block.environment != "zsection") continue;
    try {
      const SectionHeader read = parse_header(lex(block, {}, {}));
      headers.emplace_back(read.name, read.parents);
    } catch (const ZError&) {  // as above
    }
  }
  return headers;
}

}  // namespace durero::zed
