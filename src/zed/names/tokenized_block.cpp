#include "zed/names/tokenized_block.hpp"

#include <utility>

#include "zed/syntax/block_parser.hpp"
#include "zed/syntax/lexer.hpp"

namespace durero::zed {
namespace {

const Markup no_commands;
const Operators no_words;

template <class Table, class Value>
const Value& entry_of(const Table& table, const std::string& section, const Value& otherwise) {
  const auto at = table.find(section);
  return at == table.end() ? otherwise : at->second;
}

/// The name that a header gives its section; empty where it cannot be read.
std::string name_in(const std::vector<Token>& header) {
  try {
    return parse_header(header).name;
  } catch (const ZError&) {  // the reader reports it
    return {};
  }
}

}  // namespace

bool TokenizedBlock::holds(Place place) const {
  const auto order = [](Place p) { return std::pair(p.line, p.column); };
  return order(block.place) <= order(place) && order(place) < order(block.end);
}

std::vector<TokenizedBlock> tokenized(std::string_view text, const Specification& read) {
  std::vector<Defect> defects;  // the reader reports them
  std::vector<TokenizedBlock> blocks;
  std::string section = "Specification";
  for (Block& block : cut(text, {}, defects)) {
    const bool header = block.environment == "zsection";
    const Markup& markup = header ? no_commands : entry_of(read.markup, section, no_commands);
    const Operators& operators = header ? no_words : entry_of(read.operators, section, no_words);
    std::vector<Token> tokens = lex(block, markup, operators);
    if (header) section = name_in(tokens);
    const auto offset = static_cast<std::size_t>(block.body.data() - text.data());
    blocks.push_back({std::move(block), section, offset, std::move(tokens)});
  }
  return blocks;
}

}  // namespace durero::zed
