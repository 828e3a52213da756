#include "durero/zed/print/block_layout.hpp"

#include <algorithm>

#include "durero/text/utf8.hpp"
#include "durero/zed/print/convert.hpp"
#include "zed/syntax/source.hpp"

namespace durero::zed {
namespace {

std::size_t start_of_body(const Block& block, std::string_view text) {
  return static_cast<std::size_t>(block.body.data() - text.data());
}

std::vector<Block> blocks_of(std::string_view text) {
  std::vector<Defect> defects;
  return cut(text, {}, defects);
}

bool is_wide(std::string_view body) {
  for (std::size_t from = 0; from < body.size();) {
    const std::size_t end = std::min(body.find('\n', from), body.size());
    const std::string_view line = body.substr(from, end - from);
    const auto columns = line.size() - static_cast<std::size_t>(std::ranges::count_if(line, text::continues));
    if (columns > most_columns) return true;
    from = end + 1;
  }
  return false;
}

}  // namespace

std::vector<Replacement> block_layout(std::string_view text, const Specification& read) {
  if (form_of(text) != Form::latex) return {};
  const std::string back = converted(converted(text, Form::unicode, read), Form::latex, read);
  const std::vector<Block> before = blocks_of(text), after = blocks_of(back);
  std::vector<Replacement> replacements;
  for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) {
    const std::string_view body = after[i].body;
    if (body == before[i].body || is_wide(body)) continue;
    const std::size_t from = start_of_body(before[i], text);
    replacements.push_back({from, from + before[i].body.size(), std::string(body)});
  }
  return replacements;
}

}  // namespace durero::zed
