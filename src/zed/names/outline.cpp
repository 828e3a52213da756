#include "durero/zed/names/outline.hpp"

#include <algorithm>
#include <utility>

#include "zed/names/tokenized_block.hpp"
#include "zed/syntax/token_stream.hpp"

namespace durero::zed {
namespace {

using Part = OutlineEntry::Part;

/// Makes the entries of the paragraphs of one block.
class BlockOutline {
 public:
  BlockOutline(const CheckedTexts& of, const TokenizedBlock& block) : of_(of), block_(block) {}

  std::vector<OutlineEntry> entries(const std::vector<const Paragraph*>& paragraphs) {
    std::vector<OutlineEntry> all;
    for (std::size_t i = 0; i < paragraphs.size(); ++i) {
      const bool last = i + 1 == paragraphs.size();
      from_ = first_ = byte_of(paragraphs[i]->place);
      to_ = end_before(last ? block_.tokens.end() : position_of(paragraphs[i + 1]->place));
      if (paragraphs.size() == 1 && !std::holds_alternative<FreeType>(paragraphs[0]->form)) from_ = block_.offset;
      std::visit([&](const auto& form) { add(form, paragraphs[i]->place, all); }, paragraphs[i]->form);
    }
    return all;
  }

 private:
  /// The first token that does not stand before a place. Tokens are in the order of the text.
  std::vector<Token>::const_iterator position_of(Place place) const {
    const auto order = [](Place at) { return std::pair(at.line, at.column); };
    return std::ranges::lower_bound(block_.tokens, order(place), {},
                                    [&](const Token& token) { return order(token.place); });
  }
  const Token* token_at(Place place) const {
    const auto at = position_of(place);
    return at == block_.tokens.end() || at->place != place ? nullptr : &*at;
  }
  std::size_t byte_of(Place place) const {
    const Token* token = token_at(place);
    return token ? block_.begin_of(*token) : block_.offset;
  }
  /// The end of the last token before one that has bytes.
  std::size_t end_before(std::vector<Token>::const_iterator behind) const {
    while (behind != block_.tokens.begin())
      if ((--behind)->to > 0) return block_.end_of(*behind);
    return block_.offset;
  }

  OutlineEntry entry(Part part, const std::string& name, Place place) const {
    OutlineEntry made{part, name, {}, from_, std::max(from_, to_), first_, first_, {}};
    if (const Token* token = token_at(place)) {
      made.name_from = block_.begin_of(*token);
      made.name_to = block_.end_of(*token);
    }
    made.to = std::max(made.to, made.name_to);
    return made;
  }
  OutlineEntry part_of(Part part, const Name& name, Place place, const std::string& detail) const {
    OutlineEntry made = entry(part, name.text(), place);
    made.from = made.name_from;
    made.to = made.name_to;
    made.detail = detail;
    return made;
  }
  std::string type_of(const Name& name) const {
    const Global* global = of_.typing.find(block_.section, name);
    return global ? global->scheme.type.text() : std::string();
  }

  void add(const GivenTypes& given, Place, std::vector<OutlineEntry>& to) const {
    for (std::size_t i = 0; i < given.names.size(); ++i)
      to.push_back(part_of(Part::given, given.names[i], given.places[i], "given set"));
  }
  void add(const FreeType& type, Place place, std::vector<OutlineEntry>& to) const {
    OutlineEntry made = entry(Part::free_type, type.name.text(), place);
    made.detail = "free type";
    for (const Branch& branch : type.branches)
      made.entries.push_back(part_of(Part::branch, branch.name, branch.place, type_of(branch.name)));
    to.push_back(std::move(made));
  }
  void add(const Definition& definition, Place place, std::vector<OutlineEntry>& to) const {
    OutlineEntry made = entry(Part::definition, definition.name.text(), place);
    made.detail = type_of(definition.name);
    to.push_back(std::move(made));
  }
  void add(const Axiomatic& box, Place, std::vector<OutlineEntry>& to) const {
    for (const Declaration& declaration : box.text.declarations)
      for (std::size_t i = 0; i < declaration.names.size(); ++i)
        to.push_back(part_of(Part::axiom, declaration.names[i], declaration.places[i], type_of(declaration.names[i])));
  }
  void add(const Schema& box, Place place, std::vector<OutlineEntry>& to) const {
    OutlineEntry made = entry(Part::schema, box.name.text(), place);
    const Global* global = of_.typing.find(block_.section, box.name);
    const bool typed = global && global->scheme.type.is_schema_set();
    for (const Declaration& declaration : box.text.declarations)
      for (std::size_t i = 0; i < declaration.names.size(); ++i) {
        const Type* type = typed ? global->scheme.type.parts()[0].field(declaration.names[i]) : nullptr;
        made.entries.push_back(
            part_of(Part::component, declaration.names[i], declaration.places[i], type ? type->text() : std::string()));
      }
    to.push_back(std::move(made));
  }
  void add(const Conjecture& conjecture, Place place, std::vector<OutlineEntry>& to) const {
    const std::string& label = conjecture.claim.label;
    to.push_back(entry(Part::conjecture, label.empty() ? "⊢?" : label, place));
  }

  const CheckedTexts& of_;
  const TokenizedBlock& block_;
  std::size_t from_ = 0, to_ = 0, first_ = 0;  // the bytes of the paragraph, and where its first token is
};

/// The paragraphs of a section that stand in a block. Both are in the order of the text.
std::vector<const Paragraph*> paragraphs_in(const TokenizedBlock& block, const Section& section) {
  std::vector<const Paragraph*> found;
  const auto is_before = [](const Paragraph& paragraph, Place place) {
    return std::pair(paragraph.place.line, paragraph.place.column) < std::pair(place.line, place.column);
  };
  auto at = std::lower_bound(section.paragraphs.begin(), section.paragraphs.end(), block.block.place, is_before);
  for (; at != section.paragraphs.end() && block.holds(at->place); ++at) found.push_back(&*at);
  return found;
}

OutlineEntry section_entry(const TokenizedBlock& header) {
  const std::size_t end = header.offset + header.block.body.size();
  OutlineEntry made{Part::section, header.section, {}, header.offset, end, header.offset, header.offset, {}};
  for (const Token& token : header.tokens)
    if (token.text + token.strokes == header.section) {
      made.name_from = header.begin_of(token);
      made.name_to = header.end_of(token);
      break;
    }
  return made;
}

}  // namespace

std::vector<OutlineEntry> outline(const CheckedTexts& of, const std::string& file) {
  std::vector<OutlineEntry> top;
  for (const TokenizedBlock& block : tokenized(of.texts.at(file), of.read)) {
    if (block.is_header()) {
      top.push_back(section_entry(block));
      continue;
    }
    const Section* section = of.read.find(block.section);
    if (!section || section->file != file) continue;
    const bool nested = !top.empty() && top.back().part == Part::section;
    std::vector<OutlineEntry>& to = nested ? top.back().entries : top;
    for (OutlineEntry& each : BlockOutline(of, block).entries(paragraphs_in(block, *section)))
      to.push_back(std::move(each));
    if (nested && !to.empty()) top.back().to = std::max(top.back().to, to.back().to);
  }
  return top;
}

}  // namespace durero::zed
