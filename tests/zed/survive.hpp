#pragma once
/// What the reader owes to any input whatever: it ends, in one piece, and what it read it can print and read again.

#include <stdexcept>
#include <string>
#include <string_view>

#include "durero/zed/print/print.hpp"
#include "durero/zed/review/review.hpp"
#include "durero/zed/syntax/parser.hpp"

namespace durero::zed::test {

inline void survive_term(std::string_view text) {
  Term term;
  try {
    term = parse_unicode(text);
  } catch (const ZError&) {
    return;
  }
  if (parse_unicode(to_unicode(term)) != term) throw std::logic_error("printed as another term: " + to_unicode(term));
  check_term(Typing(), "", term);
}

inline void survive_paragraph(const Paragraph& paragraph, const Operators& operators) {
  const auto* type = std::get_if<FreeType>(&paragraph.form);
  if (type && type->joined) return;  // is printed as one of its own
  if (parse_unicode_paragraph(to_unicode(paragraph), operators) != paragraph)
    throw std::logic_error("printed as another paragraph: " + to_unicode(paragraph));
}

/// The text as a file of Z in LaTeX mark-up, and as an expression in Unicode. Throws std::logic_error where the reader
/// breaks its word; a text that is refused is none of that.
inline void survive(const std::string& text) {
  survive_term(text);
  const Specification read = read_text(text, "no-such-folder/input.tex");
  for (const Section& section : read.sections)
    for (const Paragraph& paragraph : section.paragraphs) survive_paragraph(paragraph, read.operators.at(section.name));
  for (const Defect& defect : review(read))
    if (defect.text().empty()) throw std::logic_error("a defect without a text");
}

}  // namespace durero::zed::test
