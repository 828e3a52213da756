#include "durero/zed/names/cross_reference.hpp"

#include <algorithm>
#include <utility>

#include "zed/names/name_walk.hpp"

namespace durero::zed {

const Occurrence* CrossReference::at(const std::string& file, std::size_t byte) const {
  const auto entry = files.find(file);
  if (entry == files.end()) return nullptr;
  const std::vector<Occurrence>& among = entry->second;
  const auto behind = std::ranges::upper_bound(among, byte, {}, &Occurrence::from);
  if (behind == among.begin()) return nullptr;
  const Occurrence& last = *(behind - 1);
  if (byte == last.from && behind - 1 != among.begin() && last.is_operator) {  // x is meant at the end of x+
    const Occurrence& before = *(behind - 2);
    if (!before.is_operator && before.to == byte) return &before;
  }
  return byte <= last.to ? &last : nullptr;
}

CheckedTexts checked(std::map<std::string, std::string> texts) {
  CheckedTexts made;
  made.texts = std::move(texts);
  made.read = read_texts(made.texts);
  made.typing = check(made.read);
  return made;
}

CrossReference cross_reference(const CheckedTexts& of) {
  NameWalk walk(of);
  std::map<std::string, std::vector<TokenizedBlock>> blocks;
  bool complete = true;
  for (const Section& section : of.read.sections) {
    const auto text = of.texts.find(section.file);
    complete = complete && text != of.texts.end();
    if (text == of.texts.end()) continue;
    const auto [at, added] = blocks.try_emplace(section.file);
    if (added) at->second = tokenized(text->second, of.read);
    walk.section(section, at->second);
  }
  CrossReference found = walk.take();
  found.complete = found.complete && complete;
  return found;
}

}  // namespace durero::zed
